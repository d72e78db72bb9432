// SPDX-License-Identifier: MIT
/// \file
/// Exact expansions of a formula at an end of the interval: which power it begins with there, and its first coefficients.
///
/// A series is s^v (c_0 + c_1 s + c_2 s^2 + ...), s >= 0 the distance to the end, v rational, c_k exact (ExactSum), c_0 not zero, known
/// up to a relative order. A formula whose expansion is not of this form (a logarithm, a constant such as exp(2)) has none: that loses a
/// factorisation, never the truth of one.
#pragma once

#include "touchstone/quadrature/exact_sum.hpp"
#include "touchstone/quadrature/expression.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace touchstone::quadrature {

struct ExactSeries {
    Rational valuation;           ///< v
    std::vector<ExactSum> c;      ///< c_0, ...; empty: zero to the order `valuation`
    bool is_exactly_zero = false; ///< the zero function, no matter what order
};

/// Expansions of many formulas about one point, those of their parts kept.
class Expansions {
public:
    /// In s with x = centre + direction s, direction 1 or -1.
    Expansions(const ExactSum& centre, int direction);
    ~Expansions();
    Expansions(Expansions&&) noexcept;
    std::optional<ExactSeries> of(const ExpressionPtr&);

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

/// The expansion in s of e with x = centre + direction s.
std::optional<ExactSeries> expand(const Expression& e, const ExactSum& centre, int direction);

/// The value of a formula without x, if it is of the form.
std::optional<ExactSum> exact_value(const Expression&);

} // namespace touchstone::quadrature
