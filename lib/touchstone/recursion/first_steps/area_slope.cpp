// SPDX-License-Identifier: MIT
#include "touchstone/recursion/first_steps/area_slope.hpp"

#include "touchstone/recursion/first_steps/pieces.hpp"

namespace touchstone::transfer::first_steps {
namespace {

using C = ComplexBall;

/// Six branch points on a line, a < a' < b < b' < c < c', by their distances; c' may be infinity.
struct BranchPoints {
    Ball a_a, a_b, b_b, b_c, c_c; ///< a' - a, b - a', b' - b, c - b', c' - c
    bool to_infinity;

    // from b and from b' to the others
    Ball b_to_a() const { return a_b + a_a; }
    Ball b_to_c() const { return b_b + b_c; }
    Ball end_to_aa() const { return b_b + a_b; } ///< b' - a'
    Ball end_to_a() const { return end_to_aa() + a_a; }
    Ball end_to_cc() const { return b_c + c_c; } ///< c' - b'
};

/// One step: the new branch points, and 4 |Delta/(u v w)|, the leading coefficients of U, V, W being u, v, w.
std::pair<BranchPoints, Ball> richelot(const BranchPoints& p)
{
    const Ball ba = p.b_to_a(), bc = p.b_to_c(), eaa = p.end_to_aa(), ea = p.end_to_a();
    // where the root of each pair's involution lies: (x - left)/(right - x)
    const bool inf = p.to_infinity;
    const Ball bcc = inf ? Ball(1) : bc + p.c_c, ecc = inf ? Ball(1) : p.end_to_cc();
    const Ball aac = eaa + p.b_c, ac = aac + p.a_a; // c - a', c - a
    const Ball aacc = inf ? Ball(1) : aac + p.c_c, acc = inf ? Ball(1) : ac + p.c_c;
    const Ball in_a_by_b = sqrt(ba * ea / (p.a_b * eaa)), in_a_by_c = sqrt(ac * acc / (aac * aacc));
    const Ball in_b_by_a = sqrt(ba * p.a_b / (ea * eaa)), in_b_by_c = sqrt(bc * bcc / (p.b_c * ecc));
    const auto inner = [](const Ball& width, const Ball& first, const Ball& last) {
        return width * (last - first) / ((1 + first) * (1 + last));
    };
    BranchPoints q;
    q.to_infinity = false;
    q.a_a = inner(p.a_a, in_a_by_c, in_a_by_b);
    q.a_b = p.a_a / (1 + in_a_by_b) + p.a_b + p.b_b * in_b_by_a / (1 + in_b_by_a);
    q.b_b = inner(p.b_b, in_b_by_a, in_b_by_c);
    const Ball to_c = p.b_b / (1 + in_b_by_c) + p.b_c; // from b1' to c
    const Ball around = p.b_b + ba + p.a_b;            // (b' - a) + (b - a') = w
    if (inf) {
        const Ball by_b = sqrt(bc * p.b_c), by_a = sqrt(ac * aac);
        q.b_c = to_c + by_b;
        q.c_c = by_a - by_b;
        return {q, 4 * (bc * around + ba * p.a_b) / around};
    }
    const Ball in_c_by_a = sqrt(ac * aac / (acc * aacc)), in_c_by_b = sqrt(bc * p.b_c / (bcc * ecc));
    q.b_c = to_c + p.c_c * in_c_by_b / (1 + in_c_by_b);
    q.c_c = inner(p.c_c, in_c_by_b, in_c_by_a);
    const Ball u = bc + ecc, v = ac + aacc;
    return {q, 4 * (bc * bcc * around + ba * p.a_b * u) / (u * v * around)};
}

/// int_b^b' dx/|(x-a)(x-a')(x-b)(x-b')(x-c)(x-c')|^(1/2)
Ball period(BranchPoints p)
{
    constexpr int most_steps = 64; // each doubles the digits, once the points of a pair are nearer to each other than to the rest
    Ball scale(1), best = Ball::indeterminate();
    slong known = -1;
    Ball unit = Ball(1) / 2;
    arb_add_error(unit.get(), Ball(unit).get()); // [0, 1]
    for (int step = 0; step < most_steps && known < WorkingPrecision::bits() - 10; ++step) {
        auto [next, factor] = richelot(p);
        p = std::move(next);
        scale = scale * factor;
        const Ball x = unit * p.b_b, rest = p.b_b - x;
        Ball value = sqrt(scale / ((p.b_to_a() + x) * (p.a_b + x) * (p.b_c + rest) * (p.end_to_cc() + rest)));
        const slong now = value.is_finite() ? value.relative_bits() : known;
        if (now > known) {
            best = std::move(value);
            known = now;
        }
        else if (known > 8) break; // the pairs are together: no more digits in the input
    }
    return pi<Ball>() * best;
}

Ball square_root(const Ball& x) { return sqrt(x); }
C square_root(const C& z) { return root_on_disc(z); }

/// r+, -r-, y^(1/2), and the distances of neighbouring branch points that vanish at singular points.
template <class N>
struct Points {
    N root, plus, minus, low_gap, gap; ///< y^(1/2), r+, |r-|, |r-| - y^(1/2), |r+ - y^(1/2)|

    Points(const N& G, const N& y, const N& to_one, const N& to_crossing)
    {
        root = square_root(y);
        const N up = to_one + square_root(to_one * to_one + G * G), sum = G + 2 * root;
        plus = G / up;
        minus = up / G;
        low_gap = to_one * sum / (G * (plus + root)); // where the quadratic with the roots r+, r- is at -y^(1/2)
        gap = 4 * to_one * to_crossing / (G * sum * (root + minus)); // and at y^(1/2)
    }
};

/// Enclosing a point of the line rather than bounding a neighbourhood.
bool is_point(const C& z) { return arb_is_zero(acb_imagref(z.get())) && z.real().relative_bits() > WorkingPrecision::bits() / 2; }

} // namespace

C AreaSlope::at(const Partial& q, bool analytic) const
{
    const Ball G = narrow(G_), front = sqrt(2 / G) / (pi<Ball>() * pi<Ball>());
    if (!analytic && is_point(q.y) && is_point(q.to_one) && is_point(q.to_crossing)) {
        const Points<Ball> p(G, q.y.real(), q.to_one.real(), q.to_crossing.real());
        return front * period({p.low_gap, p.root, q.below_crossing ? p.root : p.plus, p.gap, Ball(0), true});
    }
    // With r = r1 v, w = (r2 - r1)/r1: |w + 1 - v| >= (2 |w| (1 - v))^(1/2) where Re w >= 0, and r + y^(1/2), r - r- are no nearer to 0
    // than at v = 0; all roots are principal, hence analytic. What is left is B(1/2, 1/4) < 5.2442.
    const Points<C> p(C(G), q.y, q.to_one, q.to_crossing);
    const C &first = q.below_crossing ? p.root : p.plus, w = quotient_on_disc(p.gap, first);
    if (!right_half(w) || (!q.below_crossing && !right_half(quotient_on_disc(first, p.root))) ||
        !right_half(quotient_on_disc(first, p.minus)))
        return C::indeterminate();
    return within(front * Ball(Rational(52442, 10000)) / sqrt(abs(first) * abs(p.root) * abs(p.minus) * sqrt(2 * abs(w))));
}

C AreaSlope::at(const Full& q, bool analytic) const
{
    const Ball G = narrow(G_);
    if (!analytic && is_point(q.from_one) && is_point(q.to_turn) && is_point(q.to_end)) {
        const Ball A = q.below_turn ? sqrt(q.to_end.real() * (2 + q.from_one.real())) : sqrt(2 * G),
                   B = sqrt(q.to_turn.real() * q.from_one.real());
        return 1 / (pi<Ball>() * detail::ball_of(arb_agm, A, B));
    }
    // 1/agm(A, B) = (2/pi) int_0^(pi/2) dt/(A^2 cos^2 t + B^2 sin^2 t)^(1/2); with Re (B/A)^2 >= 0 the root's argument is at least 2^(1/2)
    // |A B| cos t sin t, and int (cos t sin t)^(-1/2) dt = B(1/4, 1/4)/2 < 3.7082
    const C A2 = q.below_turn ? q.to_end * (2 + q.from_one) : C(2 * G), B2 = q.to_turn * q.from_one;
    if (!right_half(A2) || !right_half(quotient_on_disc(B2, A2))) return C::indeterminate();
    return within(2 * Ball(Rational(37082, 10000)) / (pi<Ball>() * pi<Ball>() * sqrt(sqrt(2 * abs(A2) * abs(B2)))));
}

Ball AreaSlope::partial_bound() const
{
    // r2 - r = (r2 - r1) + (r1 - r) >= 2 ((r2 - r1)(r1 - r))^(1/2) leaves int_0^r1 r^(-1/2) (r1 - r)^(-3/4) dr = r1^(-1/4) B(1/2, 1/4), B <
    // 5.2442; r + y^(1/2) >= y^(1/2), r - r- >= 1, r1 >= 0.414 y^(1/2) since r+ >= 2^(1/2) - 1: at most 0.663 G^(-1/2) y^(-3/8) (r2 -
    // r1)^(-1/4), and 2^(1/4) times that in complex balls, as above.
    // 1/(r2 - r1) = G (G + 2 y^(1/2))(y^(1/2) - r-)/(4 (1-y) |y - G^2/4|), and -r- <= 1 + 2^(1/2)
    const Ball G = narrow(G_), gap = Ball(Rational(86, 100)) * G * (G + 2);
    return Ball(Rational(8, 10)) * sqrt(sqrt(gap)) / sqrt(G);
}

Ball AreaSlope::full_bound() const
{
    // As above: at most 0.632 (A B)^(-1/2); (G + 1 - y)(1 + y) >= 2 G for 1 <= y <= G - 1
    return Ball(Rational(64, 100)) / sqrt(sqrt(2 * narrow(G_)));
}

} // namespace touchstone::transfer::first_steps
