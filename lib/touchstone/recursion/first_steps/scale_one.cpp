// SPDX-License-Identifier: MIT
#include "touchstone/recursion/first_steps/scale_one.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/recursion/first_steps/first_wave.hpp"

namespace touchstone::transfer {
namespace {

using namespace first_steps;
using C = ComplexBall;
using Beyond = Piece::Beyond;
using Point = Piece::Point;

/// The two waves: where -E' and F are not smooth, and what they are there.
class Waves {
public:
    explicit Waves(const ScaleOne& q) : Waves(q, q.exact_p && q.exact_p->is_zero()) {}

    /// Neither 0 nor its limit from inside is the density there.
    void require_no_jump() const
    {
        const End P_below = shifted(P_, -1), P_above = shifted(P_, 1);
        if ((first_.full() && order(P_above, first_.low()) == 0) ||
            order(below(first_.high(), one_) ? needed_ : P_below, first_.high()) == 0)
            throw BeyondReach("the density jumps at this pressure, an end of its support");
    }

    Ball by_ratio(bool density) const
    {
        const C P(narrow(P_.at()));
        const End P_below = shifted(P_, -1), P_above = shifted(P_, 1), zero = End::rational(0);
        // the second wave in partial contact
        Ball sum = over_halves(larger(first_.low(), needed_), lesser(first_.high(), one_), [&](const Piece& piece) {
            const Beyond lo = piece.left(needed_), one = piece.right(one_), origin = piece.left(zero);
            std::vector<Beyond> roots = first_.roots(piece);
            if (density) roots.push_back(lo);
            return piece.integral(
                [&](const Point& x) {
                    if (area_) return first_.density(x.distance(origin), x) * of_one_wave(x, origin, one);
                    const C to_one = x.distance(one), R = x.root_of(to_one * to_one + P * P), up = to_one + R;
                    const C second = density ? P * x.root_of((2 - to_one + R) / up) / (2 * C(pi<Ball>()) * R)
                                             : two_angles(x.root_of(lo) * C(sqrt(Ball(2))), x.root_of(up + P * P / 2), x.analytic);
                    return first_.density(x.distance(origin), x) * second;
                },
                roots);
        });
        // and in full contact
        sum = sum + over_halves(larger(larger(first_.low(), one_), P_below), lesser(first_.high(), P_above), [&](const Piece& piece) {
            const Beyond lo = piece.left(P_below), hi = piece.right(P_above), one = piece.left(one_);
            std::vector<Beyond> roots = first_.roots(piece);
            if (density) roots.insert(roots.end(), {lo, hi});
            return piece.integral(
                [&](const Point& x) {
                    return first_.density(1 + x.distance(one), x) *
                           (density ? C(1 / pi<Ball>()) : FirstWave::share(x.root_of(lo), x.root_of(hi), x));
                },
                roots);
        });
        if (density) return sum / G_;
        if (!below(P_above, first_.high())) return sum;
        // x >= P + 1: all of it above P
        if (!first_.full())
            return sum + first_.partial_share(narrow(P_above.at()), sqrt(narrow(difference(P_above, first_.high()))), Point{}).real();
        if (!below(first_.low(), P_above)) return sum + 1;
        return sum +
               two_angles(sqrt(narrow(difference(P_above, first_.high()))), sqrt(narrow(difference(first_.low(), P_above))), false).real();
    }

    Ball by_angle(bool density) const
    {
        const C P(narrow(P_.at()));
        const End zero = End::rational(0), two = End::rational(2);
        const auto from_P = [&](const End& s) { return shifted_difference(P_, s); }; // u where x = s >= 1
        Ball sum(0);
        if (!area_ && below(one_, first_.high())) {
            const End first_u = from_P(first_.high()), last_u = from_P(first_.low());
            sum = over_whole(larger(zero, first_u), lesser(lesser(two, P_), last_u), [&](const Piece& piece) {
                const Beyond hi = piece.left(first_u), lo = piece.right(last_u), seam = piece.right(P_);
                std::vector<Beyond> roots{piece.left(zero), piece.right(two)};
                if (density) roots.push_back(hi);
                if (density && first_.full()) roots.push_back(lo);
                return piece.integral(
                    [&](const Point& u) {
                        const C x = 1 + u.distance(seam);
                        if (density) return first_.density(x, u);
                        return first_.full() ? FirstWave::share(u.root_of(hi), u.root_of(lo), u)
                                             : first_.partial_share(x, u.root_of(hi), u);
                    },
                    roots);
            });
        }
        if (below(P_, two) && below(first_.low(), one_) && below(needed_, first_.high())) {
            const End first_u = below(first_.high(), one_) ? partial_u(first_.high()) : P_;
            const bool within = below(needed_, first_.low()); // x = first_.low() is met before u = 2
            const End last_u = order(needed_, first_.low()) == 0 ? two : partial_u(first_.low());
            const bool seam_first = !below(first_.high(), one_);
            const Ball above_one = narrow(difference(seam_first ? one_ : first_.high(), seam_first ? first_.high() : one_));
            sum = sum + over_whole(first_u, within ? last_u : two, [&](const Piece& piece) {
                      const Beyond start = piece.left(first_u), end = piece.right(last_u), seam = piece.left(P_), origin = piece.left(zero),
                                   least = piece.right(two);
                      const C needed(narrow(needed_.at()));
                      const C first_at(narrow(first_u.at())), last_at(narrow(last_u.at()));
                      const bool at_seam = order(first_.high(), one_) == 0;
                      std::vector<Beyond> roots{origin, piece.right(two)};
                      if (density && (!seam_first || at_seam)) roots.push_back(start);
                      if (density && first_.full()) roots.push_back(end);
                      return piece.integral(
                          [&](const Point& point) {
                              const C u = point.distance(origin), half = C(1) / 2;
                              const C x = needed + point.distance(least) * (area_ ? half : (1 + P * P / (2 * u)) / 2);
                              // hi - x and x - lo are a distance along u times these
                              const auto slope = [&](const C& at) { return area_ ? half : (1 + P * P / (u * at)) / 2; };
                              C to_hi = point.root_of(seam_first && !at_seam
                                                          ? C(above_one) + point.distance(seam) * (area_ ? half : (u + P) / (2 * u))
                                                          : slope(first_at));
                              const C to_lo = first_.full() ? point.root_of(slope(last_at)) : C(1);
                              if (density) return P / u * first_.density(x, point) / (to_hi * to_lo);
                              if (!seam_first || at_seam) to_hi = to_hi * point.root_of(start);
                              return first_.full() ? FirstWave::share(to_hi, to_lo * point.root_of(end), point)
                                                   : first_.partial_share(x, to_hi, point);
                          },
                          roots);
                  });
        }
        sum = sum / pi<Ball>();
        if (density) return sum / G_;
        // x < first_.low(): all of lambda_0 has more
        const End last_u =
            below(first_.low(), one_) ? (below(needed_, first_.low()) ? partial_u(first_.low()) : two) : from_P(first_.low());
        if (!below(last_u, two)) return sum;
        if (!below(zero, last_u)) return sum + 1;
        return sum + 2 * asin(sqrt(narrow(difference(last_u, two)) / 2)) / pi<Ball>();
    }

private:
    static End shifted(const End& e, long by)
    {
        const WorkingPrecision w = wide();
        return {e.at() + by, e.exact ? exactly([&] { return *e.exact + Exact(by); }) : std::nullopt};
    }
    /// a + 1 - b
    static End shifted_difference(const End& a, const End& b)
    {
        const WorkingPrecision w = wide();
        return {a.at() - b.at() + 1, a.exact && b.exact ? exactly([&] { return *a.exact - *b.exact + Exact(1); }) : std::nullopt};
    }
    /// u where x = s <= 1
    End partial_u(const End& s) const
    {
        const WorkingPrecision w = wide();
        const Ball to_one = 1 - s.at();
        return {to_one + sqrt(to_one * to_one + P_.at() * P_.at()), std::nullopt};
    }

    Waves(const ScaleOne& q, bool area) : area_(area), first_(q.load, wide_ball(q.G), q.exact_G)
    {
        const WorkingPrecision w = wide();
        G_ = q.G();
        const End zero = End::rational(0);
        P_ = area_ ? zero : q.exact_p ? over_G(*q.exact_p, G_, q.exact_G) : End{q.p() / G_, std::nullopt};
        needed_ =
            area_ ? zero : End{P_.at() * P_.at() / 4, P_.exact ? exactly([&] { return *P_.exact * *P_.exact / Exact(4); }) : std::nullopt};
    }
    /// (6.6): (2/pi) arcsin x^(1/2), without cancellation where x << 1 and next to x = 1
    static C of_one_wave(const Point& x, const Beyond& origin, const Beyond& one)
    {
        if (certainly(less(2 * one.gap, Ball(1)))) return FirstWave::share(x.root_of(origin), x.root_of(one), x);
        return two_angles(x.root_of(origin), x.root_of(one), x.analytic);
    }
    static Ball wide_ball(const std::function<Ball()>& f)
    {
        const WorkingPrecision w = wide();
        return f();
    }

    bool area_;       ///< p = 0
    FirstWave first_;
    Ball G_;
    End P_, needed_;  ///< and the least ratio that gets to P in partial contact
    const End one_ = End::rational(1);
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
