// SPDX-License-Identifier: MIT
#include "touchstone/recursion/first_steps/first_wave.hpp"

namespace touchstone::transfer::first_steps {

using C = ComplexBall;

End over_G(const Exact& r, const Ball& G, const std::optional<Exact>& exact_G)
{
    if (r.is_zero()) return End::rational(0);
    return {r.ball() / G, exact_G ? exactly([&] { return r / *exact_G; }) : std::nullopt};
}

FirstWave::FirstWave(const Rational& load, const Ball& G, const std::optional<Exact>& exact_G) : full_(load >= 1)
{
    const WorkingPrecision w = wide();
    load_ = Ball(load);
    out_ = Ball(Rational(1 - load));
    G_ = G;
    if (full_) {
        low_ = over_G(Rational(load - 1), G, exact_G);
        high_ = over_G(Rational(load + 1), G, exact_G);
        return;
    }
    low_ = End::rational(0);
    high_ = over_G(2 * sqrt(Exact(load)), G, exact_G);
}

std::vector<Piece::Beyond> FirstWave::roots(const Piece& piece) const
{
    std::vector<Piece::Beyond> roots{piece.right(high_)};
    if (full_) roots.push_back(piece.left(low_));
    return roots;
}

C FirstWave::density(const C& x, const Piece::Point& at) const
{
    if (full_) return C(1 / pi<Ball>());
    const C Gx = C(narrow(G_)) * x, out = C(narrow(out_)), R = at.root_of(out * out + Gx * Gx);
    return Gx * at.root_of((2 - out + R) / ((out + R) * (C(narrow(high_.at())) + x))) / (C(pi<Ball>()) * R);
}

C FirstWave::share(const C& to_none, const C& to_all, const Piece::Point& at)
{
    if (at.extent() == Extent::left_half) return two_angles(to_none, to_all, at.analytic);
    if (at.extent() == Extent::right_half) return 1 - two_angles(to_all, to_none, at.analytic);
    // the tangent of half the angle: finite where there is nothing left to all
    return 2 * two_angles(to_none, to_all + at.root_of(to_none * to_none + to_all * to_all), at.analytic);
}

C FirstWave::partial_share(const C& x, const C& to_high, const Piece::Point& at) const
{
    const C Gx = C(narrow(G_)) * x, out = C(narrow(out_)), R = at.root_of(out * out + Gx * Gx);
    return two_angles(to_high * at.root_of((C(narrow(high_.at())) + x) / 2) * C(narrow(G_)), at.root_of(out + R + Gx * Gx / 2),
                      at.analytic);
}

C FirstWave::bounded_share(const C& x, const C& to_high, const C& to_low) const
{
    C square;
    if (full_) square = quotient_on_disc(to_high, to_low);
    else {
        const C Gx = C(narrow(G_)) * x, out(narrow(out_)), R = root_on_disc(out * out + Gx * Gx);
        square = quotient_on_disc(to_high * (C(narrow(high_.at())) + x) * C(narrow(G_) * narrow(G_)), 2 * (out + R + Gx * Gx / 2));
    }
    // arctan z = int_0^1 z dt/(1 + z^2 t^2), the denominator at least 1 and |z t|^2: at most |z|, and 2
    if (!right_half(square)) return C::indeterminate();
    return within(2 * at_most(sqrt(abs(square)), Ball(2)) / pi<Ball>());
}

} // namespace touchstone::transfer::first_steps
