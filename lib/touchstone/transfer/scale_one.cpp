// SPDX-License-Identifier: MIT
#include "touchstone/transfer/scale_one.hpp"

#include "touchstone/catalogue/quantity.hpp"

#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#else
#include <acb_calc.h>
#endif

#include <memory>
#include <vector>

namespace touchstone::transfer {
namespace {

using C = ComplexBall;
/// `analytic` asks for an indeterminate result unless the integrand is analytic on the whole ball.
using Integrand = std::function<C(const C& t, bool analytic)>;

slong bits() { return WorkingPrecision::bits(); }
/// Ends, and differences of ends.
WorkingPrecision wide() { return WorkingPrecision(bits() + 4096); }

C root(const C& z, bool analytic)
{
    C r;
    acb_sqrt_analytic(r.get(), z.get(), analytic, bits());
    return r;
}

/// (2/pi) arctan(top/bottom) of two roots: of numbers with a positive real part.
C two_angles(const C& top, const C& bottom, bool analytic)
{
    const C z = top / bottom;
    Ball re;
    arb_set(re.get(), acb_realref(z.get()));
    if (analytic && !certainly(less(Ball(0), re)) && !certainly(less(abs(z), Ball(1)))) return C::indeterminate();
    C r;
    acb_atan(r.get(), z.get(), bits());
    return 2 * r / C(pi<Ball>());
}

int call(acb_ptr result, const acb_t t, void* f, slong order, slong precision)
{
    const WorkingPrecision scope(precision);
    C z;
    acb_set(z.get(), t);
    const C r = (*static_cast<const Integrand*>(f))(z, order != 0);
    acb_set(result, r.get());
    return 0;
}

/// int_0^(pi/4) f
Ball eighth_turn(const Integrand& f)
{
    C sum;
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    options->depth_limit = 10'000;
    options->eval_limit = 400'000;
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -6000);
    acb_calc_integrate(sum.get(), call, const_cast<Integrand*>(&f), C(0).get(), C(pi<Ball>() / 4).get(), bits(), tolerance, options, bits());
    mag_clear(tolerance);
    Ball re;
    arb_set(re.get(), acb_realref(sum.get()));
    return re;
}

/// An end: a ball at wide() precision, and the number itself if it is rational. Copies are known to be the same number.
struct End {
    End() = default;
    End(const Ball& b, std::optional<Rational> e) : ball(std::make_shared<const Ball>(b)), exact(std::move(e)) {}
    const Ball& at() const { return *ball; }
    std::shared_ptr<const Ball> ball;
    std::optional<Rational> exact;
};
End rational(const Rational& r)
{
    const WorkingPrecision w = wide();
    return {Ball(r), r};
}
bool same(const End& a, const End& b) { return a.ball == b.ball; }
/// -1, 0, 1
int order(const End& a, const End& b)
{
    if (same(a, b)) return 0;
    if (a.exact && b.exact) return *a.exact < *b.exact ? -1 : *a.exact > *b.exact ? 1 : 0;
    if (certainly(less(a.at(), b.at()))) return -1;
    if (certainly(less(b.at(), a.at()))) return 1;
    throw BeyondReach("two ends of waves are too close to be told from one another");
}
bool below(const End& a, const End& b) { return order(a, b) < 0; }
const End& larger(const End& a, const End& b) { return below(a, b) ? b : a; }
const End& lesser(const End& a, const End& b) { return below(b, a) ? b : a; }
Ball narrow(const Ball& b)
{
    Ball r;
    arb_set_round(r.get(), b.get(), bits());
    return r;
}
/// b - a >= 0; exactly 0 if they are one
Ball difference(const End& a, const End& b)
{
    if (same(a, b)) return Ball(0);
    if (a.exact && b.exact) return Ball(Rational(*b.exact - *a.exact));
    const slong precision = bits() + 4096;
    Ball d;
    arb_sub(d.get(), b.at().get(), a.at().get(), precision);
    return narrow(d);
}

/// A piece [a, b], seen from one of its ends: the distances of a point from what is not inside.
class Piece {
public:
    Piece(const End& a, const End& b, bool from_left) : a_(a), b_(b), from_left_(from_left), width_(difference(a, b)) {}
    /// A point s <= a or s >= b of the line, and the distance of x from it.
    struct Beyond {
        Ball gap;   ///< from the piece; 0: it is the piece's end
        bool left;
        bool zero() const { return arb_is_zero(gap.get()); }
    };
    Beyond left(const End& s) const { return {difference(s, a_), true}; }
    Beyond right(const End& s) const { return {difference(b_, s), false}; }

    struct Point {
        const Piece* piece = nullptr;
        C sine, cosine; ///< of the angle from the left end
        bool analytic = false;
        C distance(const Beyond& b) const
        {
            const C& s = b.left ? sine : cosine;
            return C(b.gap) + C(piece->width_) * s * s;
        }
        C root_of(const Beyond& b) const
        {
            if (b.zero()) return C(sqrt(piece->width_)) * (b.left ? sine : cosine);
            return root(distance(b), analytic);
        }
        C root_of(const C& z) const { return root(z, analytic); }
        bool near_left() const { return piece->from_left_; }
    };
    using Function = std::function<C(const Point&)>;
    /// Its half of int f dx/(product of the roots of these).
    Ball integral(const Function& f, const std::vector<Beyond>& roots) const
    {
        int at_left = 0, at_right = 0;
        for (const Beyond& b : roots)
            if (b.zero()) ++(b.left ? at_left : at_right);
        if (at_left > 1 || at_right > 1) throw BeyondReach("the density is infinite at this pressure");
        Ball scale = 2 * width_;
        for (int k = 0; k < at_left + at_right; ++k) scale = scale / sqrt(width_);
        return scale * eighth_turn([&](const C& t, bool analytic) {
                   const C s = sin(t), c = cos(t);
                   const Point x{this, from_left_ ? s : c, from_left_ ? c : s, analytic};
                   C value = f(x);
                   if (!at_left) value = value * x.sine;
                   if (!at_right) value = value * x.cosine;
                   for (const Beyond& b : roots)
                       if (!b.zero()) value = value / x.root_of(b);
                   return value;
               });
    }

private:
    End a_, b_;
    bool from_left_;
    Ball width_;
};

/// Both halves of a piece, if there is one.
Ball over(const End& a, const End& b, const std::function<Ball(const Piece&)>& half)
{
    if (!below(a, b)) return Ball(0);
    return half(Piece(a, b, true)) + half(Piece(a, b, false));
}

using Beyond = Piece::Beyond;
using Point = Piece::Point;

/// The two waves: where -E' and F are not smooth, and what they are there.
class Waves {
public:
    explicit Waves(const ScaleOne& q) : full_(q.load >= 1)
    {
        const WorkingPrecision w = wide();
        const auto over_G = [&](const Rational& r) { return End{Ball(r) / G_, q.exact_G ? std::optional(Rational(r / *q.exact_G)) : std::nullopt}; };
        load_ = Ball(q.load);
        G_ = q.G();
        P_ = q.exact_p ? over_G(*q.exact_p) : End{q.p() / G_, std::nullopt};
        needed_ = {P_.at() * P_.at() / 4, P_.exact ? std::optional(Rational(*P_.exact * *P_.exact / 4)) : std::nullopt};
        if (full_) {
            low_ = over_G(q.load - 1);
            high_ = over_G(q.load + 1);
            return;
        }
        low_ = rational(0);
        high_ = {2 * sqrt(load_) / G_, std::nullopt};
        if (mpz_perfect_square_p(q.load.get_num_mpz_t()) && mpz_perfect_square_p(q.load.get_den_mpz_t()))
            high_ = over_G(2 * Rational(mpz_class(sqrt(q.load.get_num())), mpz_class(sqrt(q.load.get_den()))));
    }

    /// Neither 0 nor its limit from inside is the density there.
    void require_no_jump() const
    {
        const End P_below = shifted(P_, -1), P_above = shifted(P_, 1);
        if ((full_ && order(P_above, low_) == 0) || order(below(high_, one_) ? needed_ : P_below, high_) == 0)
            throw BeyondReach("the density jumps at this pressure, an end of its support");
    }

    Ball by_ratio(bool density) const
    {
        const C P(narrow(P_.at()));
        const End P_below = shifted(P_, -1), P_above = shifted(P_, 1), zero = rational(0);
        // the second wave in partial contact
        Ball sum = over(larger(low_, needed_), lesser(high_, one_), [&](const Piece& piece) {
            const Beyond lo = piece.left(needed_), one = piece.right(one_), origin = piece.left(zero);
            std::vector<Beyond> roots = first_roots(piece);
            if (density) roots.push_back(lo);
            return piece.integral(
                [&](const Point& x) {
                    const C to_one = x.distance(one), R = x.root_of(to_one * to_one + P * P), up = to_one + R;
                    const C second = density ? P * x.root_of((2 - to_one + R) / up) / (2 * C(pi<Ball>()) * R)
                                             : two_angles(x.root_of(lo) * C(sqrt(Ball(2))), x.root_of(up + P * P / 2), x.analytic);
                    return first(x.distance(origin), x) * second;
                },
                roots);
        });
        // and in full contact
        sum = sum + over(larger(larger(low_, one_), P_below), lesser(high_, P_above), [&](const Piece& piece) {
            const Beyond lo = piece.left(P_below), hi = piece.right(P_above), one = piece.left(one_);
            std::vector<Beyond> roots = first_roots(piece);
            if (density) roots.insert(roots.end(), {lo, hi});
            return piece.integral([&](const Point& x) { return first(1 + x.distance(one), x) * (density ? C(1 / pi<Ball>()) : share(x.root_of(lo), x.root_of(hi), x)); }, roots);
        });
        if (density) return sum / G_;
        if (!below(P_above, high_)) return sum;
        // x >= P + 1: all of it above P
        if (!full_) return sum + partial_share(narrow(P_above.at()), sqrt(narrow(difference(P_above, high_))), Point{}).real();
        if (!below(low_, P_above)) return sum + 1;
        return sum + two_angles(sqrt(narrow(difference(P_above, high_))), sqrt(narrow(difference(low_, P_above))), false).real();
    }

    Ball by_angle(bool density) const
    {
        const C P(narrow(P_.at()));
        const End zero = rational(0), two = rational(2);
        const auto from_P = [&](const End& s) { return shifted_difference(P_, s); }; // u where x = s >= 1
        Ball sum(0);
        if (below(one_, high_)) {
            const End first_u = from_P(high_), last_u = from_P(low_);
            sum = over(larger(zero, first_u), lesser(lesser(two, P_), last_u), [&](const Piece& piece) {
                const Beyond hi = piece.left(first_u), lo = piece.right(last_u), seam = piece.right(P_);
                std::vector<Beyond> roots{piece.left(zero), piece.right(two)};
                if (density) roots.push_back(hi);
                if (density && full_) roots.push_back(lo);
                return piece.integral(
                    [&](const Point& u) {
                        const C x = 1 + u.distance(seam);
                        if (density) return first(x, u);
                        return full_ ? share(u.root_of(hi), u.root_of(lo), u) : partial_share(x, u.root_of(hi), u);
                    },
                    roots);
            });
        }
        if (below(P_, two) && below(low_, one_) && below(needed_, high_)) {
            const End first_u = below(high_, one_) ? partial_u(high_) : P_;
            const bool within = below(needed_, low_); // x = low_ is met before u = 2
            const End last_u = order(needed_, low_) == 0 ? two : partial_u(low_);
            const bool seam_first = !below(high_, one_);
            const Ball above_one = narrow(difference(seam_first ? one_ : high_, seam_first ? high_ : one_));
            sum = sum + over(first_u, within ? last_u : two, [&](const Piece& piece) {
                const Beyond start = piece.left(first_u), end = piece.right(last_u), seam = piece.left(P_), origin = piece.left(zero), least = piece.right(two);
                const C needed(narrow(needed_.at()));
                const C first_at(narrow(first_u.at())), last_at(narrow(last_u.at()));
                const bool at_seam = order(high_, one_) == 0;
                std::vector<Beyond> roots{origin, piece.right(two)};
                if (density && (!seam_first || at_seam)) roots.push_back(start);
                if (density && full_) roots.push_back(end);
                return piece.integral(
                    [&](const Point& point) {
                        const C u = point.distance(origin), x = needed + point.distance(least) * (1 + P * P / (2 * u)) / 2;
                        // hi - x and x - lo are a distance along u times these
                        const auto slope = [&](const C& at) { return (1 + P * P / (u * at)) / 2; };
                        C to_hi = point.root_of(seam_first && !at_seam ? C(above_one) + point.distance(seam) * (u + P) / (2 * u) : slope(first_at));
                        const C to_lo = full_ ? point.root_of(slope(last_at)) : C(1);
                        if (density) return P / u * first(x, point) / (to_hi * to_lo);
                        if (!seam_first || at_seam) to_hi = to_hi * point.root_of(start);
                        return full_ ? share(to_hi, to_lo * point.root_of(end), point) : partial_share(x, to_hi, point);
                    },
                    roots);
            });
        }
        sum = sum / pi<Ball>();
        if (density) return sum / G_;
        // x < low_: all of lambda_0 has more
        const End last_u = below(low_, one_) ? (below(needed_, low_) ? partial_u(low_) : two) : from_P(low_);
        if (!below(last_u, two)) return sum;
        if (!below(zero, last_u)) return sum + 1;
        return sum + 2 * asin(sqrt(narrow(difference(last_u, two)) / 2)) / pi<Ball>();
    }

private:
    static End shifted(const End& e, long by)
    {
        const WorkingPrecision w = wide();
        return {e.at() + by, e.exact ? std::optional(Rational(*e.exact + by)) : std::nullopt};
    }
    /// a + 1 - b
    static End shifted_difference(const End& a, const End& b)
    {
        const WorkingPrecision w = wide();
        return {a.at() - b.at() + 1, a.exact && b.exact ? std::optional(Rational(*a.exact + 1 - *b.exact)) : std::nullopt};
    }
    /// u where x = s <= 1
    End partial_u(const End& s) const
    {
        const WorkingPrecision w = wide();
        const Ball to_one = 1 - s.at();
        return {to_one + sqrt(to_one * to_one + P_.at() * P_.at()), std::nullopt};
    }

    /// -E' is `first` over the roots of the distances of x from these.
    std::vector<Beyond> first_roots(const Piece& piece) const
    {
        std::vector<Beyond> roots{piece.right(high_)};
        if (full_) roots.push_back(piece.left(low_));
        return roots;
    }
    C first(const C& x, const Point& at) const
    {
        if (full_) return C(1 / pi<Ball>());
        const C Gx = C(narrow(G_)) * x, out = C(1 - narrow(load_)), R = at.root_of(out * out + Gx * Gx);
        return Gx * at.root_of((2 - out + R) / ((out + R) * (C(narrow(high_.at())) + x))) / (C(pi<Ball>()) * R);
    }
    /// The share above, in full contact, from the roots of the distances to where none is above, on the left, and all, on the right.
    static C share(const C& to_none, const C& to_all, const Point& at)
    {
        return at.near_left() ? two_angles(to_none, to_all, at.analytic) : 1 - two_angles(to_all, to_none, at.analytic);
    }
    /// E(x) for load < 1, from the root of high_ - x
    C partial_share(const C& x, const C& to_high, const Point& at) const
    {
        const C Gx = C(narrow(G_)) * x, out = C(1 - narrow(load_)), R = at.root_of(out * out + Gx * Gx);
        return two_angles(to_high * at.root_of((C(narrow(high_.at())) + x) / 2) * C(narrow(G_)), at.root_of(out + R + Gx * Gx / 2), at.analytic);
    }

    bool full_; ///< the first wave
    Ball load_, G_;
    End P_, needed_, low_, high_, one_ = rational(1);
};

} // namespace

Ball scale_one_exceedance(Variable v, const ScaleOne& q)
{
    const Waves waves(q);
    return v == Variable::ratio ? waves.by_ratio(false) : waves.by_angle(false);
}

Ball scale_one_density(Variable v, const ScaleOne& q)
{
    const Waves waves(q);
    waves.require_no_jump();
    return v == Variable::ratio ? waves.by_ratio(true) : waves.by_angle(true);
}

} // namespace touchstone::transfer
