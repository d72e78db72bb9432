// SPDX-License-Identifier: MIT
/// \file
/// A formula at real points, straight in balls (internal to quadrature/).
///
/// Numbers that keep the powers of the distances to the ends (endpoint_number.hpp) cost several times what balls cost, and are needed only
/// where differences cancel. At the nodes of a rule that stays away from the ends few bits do: there the formula is taken as it stands,
/// with some bits more, and the ball itself says how many are left.
#pragma once

#include "touchstone/quadrature/integrand.hpp"

#include <optional>
#include <vector>

namespace touchstone::quadrature {

class RealFormula {
public:
    /// Nothing if it has other operations than arithmetic, powers with rational exponents or constant bases and elementary functions, or
    /// constants that are not real.
    static std::optional<RealFormula> of(const ExpressionPtr&);

    /// Encloses the values on the ball at the working precision; non-finite unless all intermediate values are real numbers. The reference
    /// holds until the next call; a formula belongs to one thread at a time. Constants are kept, with the most bits that were asked for.
    const Ball& at(const Ball& x) const;

private:
    struct Step {
        Op op = Op::number;
        std::size_t first = 0, second = 0; ///< of earlier values, 0 being x
        long numerator = 1, denominator = 1; ///< of Op::power
        ExpressionPtr constant{};            ///< of Op::number
    };
    class Builder;
    void prepare() const;

    std::vector<Step> steps_; ///< the k-th makes value k + 1
    mutable std::vector<Ball> values_;
    mutable slong bits_ = 0; ///< of the constants among them
};

/// A formula on a finite range, in balls of some bits more than the working precision. Nothing where a difference cancels more than that:
/// these are the few nodes next to an end that ask for other numbers.
class StraightValues {
public:
    /// Both outlive this.
    StraightValues(const RealFormula&, const Range&);
    /// f dx/da at x = from + width sin^2 a.
    std::optional<Ball> in_angle(const Ball& sine, const Ball& cosine);
    /// f at the middle plus (mirrored: minus) half the width times z.
    std::optional<Ball> on_the_line(const Ball& z, bool mirrored);
    /// The same times the width.
    std::optional<Ball> in_fraction(const Ball& z, bool mirrored);
    /// The same on the part between two fractions of the range.
    std::optional<Ball> in_part(const Rational& from, const Rational& to, const Ball& z, bool mirrored);
    /// f at a fraction of the range from one of its ends, times the width.
    std::optional<Ball> beside(Side end, const Ball& fraction);

private:
    std::optional<Ball> value(slong bits) const;
    void prepare();
    void prepare_part(const Rational& from, const Rational& to);

    /// The part that was asked for last: its share of the range, and its middle on [-1, 1].
    struct Part {
        Rational from, to;
        Ball share, place;
        slong bits = 0;
    };
    const RealFormula& formula_;
    const Range& range_;
    Part part_;
    Ball from_, to_, width_, twice_width_, middle_, half_, x_;
    slong bits_ = 0;
};

} // namespace touchstone::quadrature
