// SPDX-License-Identifier: MIT
/// \file
/// Integrals of typed formulas, with a proof.
///
///     const Integral I = integrate(parse_expression("x^(-1/2)*log(1/x)/(1+x^2)"), parse_limit("0"), parse_limit("1"), {.digits = 50});
///
/// The range is cut where it is told to be (`at`), at the branches of abs, sign, floor, ceil, max, min that can be named exactly, and where
/// the proof stops at a point at which the formula has an exact expansion that is integrable from both sides. Each part is integrated by
/// one of
///
///   Gauss-Legendre   where the formula is analytic about both ends: on one ellipse (ellipse_rule.hpp) if that serves, else by Arb's
///                    acb_calc_integrate (Petras's algorithm), each panel with its ellipse;
///   Gauss-Chebyshev  where it is analytic but for odd powers of the roots of both distances: product_rule.hpp;
///   in the angle     where it behaves like other half-integer powers at both ends: Gauss-Legendre with u = sin^2 a (half_powers.hpp);
///   product rule     where it is powers and logarithms of the distances to the ends times what is analytic about both: product_rule.hpp;
///   tanh-sinh        else: tanh_sinh.hpp;
///   turned path      sums of waves with a decaying amplitude on half-lines: oscillation.hpp;
///
/// at an end with an essential singularity the variable 1/(distance to the end) takes over (substitution.hpp),
/// a complex formula has both parts from one rule (the strip proved once), an integral inside it is proved with a ball of x
/// (inner_integral.hpp), paths in the plane are in path.hpp,
/// and the balls are added at the precision of the digits asked for. Parts that cancel are repeated with more digits.
///
/// Errors: `certified` means that the digits asked for are proven (or |error| <= tolerance, if one is given); `undecided` is a proven
/// enclosure with fewer digits, or none, and `reason` says why, in one line, naming the place. `divergent` is proven: an exact expansion
/// shows the exponent.
#pragma once

#include "touchstone/quadrature/integrand.hpp"
#include "touchstone/quadrature/tanh_sinh.hpp"

#include <functional>

namespace touchstone::quadrature {

struct IntegralOptions {
    long digits = 30;
    std::vector<Limit> at;             ///< points where the range is to be cut
    std::vector<Limit> principal_value; ///< poles about which Cauchy's principal value is meant
    std::optional<Rational> tolerance; ///< an absolute error that is enough
    bool gauss_legendre = true;        ///< whether that rule may be chosen
    bool of_absolute = false;          ///< digits of the integral of |f| are enough
    bool patient = false;              ///< many bits where the formula is huge next to its integral; used where nothing else helps
    bool quick = false;                ///< so are they, one attempt for each part and few evaluations: for integrals inside others
};

/// One part of the range, and how it was done.
struct Part {
    std::string from, to, rule;
    Ball value;
    Certificate certificate; ///< of tanh-sinh
    long evaluations = 0;    ///< of the formula, at nodes
    Ball imaginary;          ///< exactly 0 of a real formula
    std::string proof = {};  ///< of a rule on one ellipse: the ellipse, the bound on it, the error
};

struct Integral {
    Ball value;             ///< its real part, if it is complex
    Ball imaginary;         ///< exactly 0 of a real formula on a real range
    bool is_complex = false;
    Status status = Status::indeterminate;
    long digits = 0; ///< proven; of a complex value, relative to its modulus
    bool divergent = false;
    std::string reason; ///< unless certified
    std::vector<Part> parts;
};

/// Errors: DomainError for a break point or pole that is not inside.
Integral integrate(const ExpressionPtr&, const Limit& from, const Limit& to, const IntegralOptions& = {});

/// Of several formulas over one range. Where tanh-sinh is the rule the strip is proved once for all of them, and they share their nodes.
std::vector<Integral> integrate_several(const std::vector<ExpressionPtr>&, const Limit& from, const Limit& to, const IntegralOptions& = {});

/// Used by integrate where `principal_value` names poles; from is below to, `reversed`: with the other sign.
Integral principal_value(const ExpressionPtr&, const Limit& from, const Limit& to, const IntegralOptions&, bool reversed);

/// Over the range the other way round, and so is each of its parts.
Integral negated(Integral);

/// The attempt repeated with more digits until the value has those asked for, at most a few times, and what the result then is; `reversed`:
/// with the other sign, in what is said of it too.
Integral with_enough_digits(const IntegralOptions&, const std::function<bool(long digits, Integral&)>& attempt, bool reversed = false);

} // namespace touchstone::quadrature
