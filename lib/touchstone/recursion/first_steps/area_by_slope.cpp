// SPDX-License-Identifier: MIT
#include "touchstone/recursion/first_steps/area_by_slope.hpp"

#include "touchstone/recursion/first_steps/area_slope.hpp"
#include "touchstone/recursion/first_steps/first_wave.hpp"

#include <algorithm>

namespace touchstone::transfer {
namespace {

using namespace first_steps;
using C = ComplexBall;
using Beyond = Piece::Beyond;
using Point = Piece::Point;

/// What the slope is weighted with: E of the first wave, or 1 up to the load.
class Weight {
public:
    Weight(long n, const FirstSteps& q)
    {
        const WorkingPrecision w = wide();
        if (n == 1) {
            ends_ = {End::rational(q.load)};
            largest_ = Ball(1);
            return;
        }
        wave_.emplace(q.load, q.G(), q.exact_G);
        if (wave_->full()) ends_ = {wave_->low(), wave_->high()};
        else ends_ = {wave_->high()};
        largest_ = wave_->full() ? Ball(1) : narrow(2 * asin(sqrt(Ball(q.load))) / pi<Ball>());
    }

    /// Where it is not smooth; 0 beyond the last of them.
    const std::vector<End>& ends() const { return ends_; }
    /// at least the weight
    const Ball& largest() const { return largest_; }

    /// On a piece between such points and others.
    std::function<C(const Point&)> on(const Piece& piece, const End& begin) const
    {
        if (!wave_ || (wave_->full() && below(begin, wave_->low()))) return [](const Point&) { return C(1); };
        const Beyond high = piece.right(wave_->high());
        const Beyond low = piece.left(wave_->low()); // 0 in partial contact
        return [this, high, low](const Point& y) {
            if (y.analytic) return wave_->bounded_share(y.distance(low), y.distance(high), y.distance(low));
            if (!wave_->full()) return wave_->partial_share(y.distance(low), y.root_of(high), y);
            return two_angles(y.root_of(high), y.root_of(low), false);
        };
    }

private:
    std::optional<FirstWave> wave_;
    std::vector<End> ends_;
    Ball largest_;
};

/// A piece on which neither the weight nor the slope has a singular point but at the ends.
class Part {
public:
    Part(const Piece& piece, const End& begin, const AreaSlope& slope, const Weight& weight, const End& crossing, const End& turn,
         const End& last, bool full)
        : piece_(piece)
        , slope_(slope)
        , weight_(weight.on(piece, begin))
        , largest_(weight.largest())
        , full_(full)
        , first_side_(below(begin, full ? turn : crossing))
        , origin_(piece.left(End::rational(0)))
        , one_(full ? piece.left(End::rational(1)) : piece.right(End::rational(1)))
        , special_(first_side_ ? piece.right(full ? turn : crossing) : piece.left(full ? turn : crossing))
        , last_(piece.right(last))
    {
    }

    Ball integral(slong goal) const
    {
        // the argument of a product of two distances that vanish together is twice that of u
        const bool together = one_.left == special_.left && vanishes(one_) && vanishes(special_);
        return piece_.between_logarithms([this](const Point& y) { return value(y); },
                                         [this](bool left, const Ball& t) { return rest(left, t); }, together ? 0.64 : 1.25, goal);
    }

private:
    C value(const Point& y) const
    {
        const C one = y.distance(one_), special = y.distance(special_);
        return weight_(y) * (full_ ? slope_.at(AreaSlope::Full{one, special, y.distance(last_), first_side_}, y.analytic)
                                   : slope_.at(AreaSlope::Partial{y.distance(origin_), one, special, first_side_}, y.analytic));
    }

    bool vanishes(const Beyond& b) const { return certainly(less(b.gap, piece_.width() / 1000)); }

    /// A distance to the same side is at least that of the end, and at least that of the point, in modulus where Im u <= pi/2; one to the
    /// other side is at least half of the piece. E is at most (4/pi)/(1/2) times its largest value: |arctan z| <= 2 where Re z^2 >= 0, and
    /// <= |z|. What is not near to 0 is within 1e-5 of its value at the end.
    Ball rest(bool left, const Ball& t) const
    {
        Ball bound = 3 * largest_ * (full_ ? slope_.full_bound() : slope_.partial_bound()), exponent(1);
        const auto factor = [&](const Beyond& b, const Rational& power) {
            if (b.left != left) bound = bound / pow(b.gap + piece_.width() / 2, Ball(power));
            else if (vanishes(b)) exponent -= Ball(power);
            else bound = bound / pow(b.gap, Ball(power));
        };
        factor(one_, Rational(1, 4));
        factor(special_, Rational(1, 4));
        if (!full_) factor(origin_, Rational(3, 8));
        return bound * pow(piece_.width() * t, exponent) / exponent;
    }

    const Piece& piece_;
    const AreaSlope& slope_;
    std::function<C(const Point&)> weight_;
    Ball largest_;
    bool full_, first_side_; ///< y >= 1; y < G^2/4, resp. G - 1
    Beyond origin_, one_, special_, last_;
};

} // namespace

Ball area_by_slope(long n, const FirstSteps& q, slong goal)
{
    const Weight weight(n, q);
    const End one = End::rational(1);
    std::vector<End> points{End::rational(0), one};
    End crossing, turn, last;
    Ball wide_G;
    {
        const WorkingPrecision w = wide();
        wide_G = q.G();
        const auto of_G = [&](auto f) { return q.exact_G ? exactly([&] { return f(*q.exact_G); }) : std::nullopt; };
        crossing = {wide_G * wide_G / 4, of_G([](const Exact& g) { return g * g / Exact(4); })};
        turn = {wide_G - 1, of_G([](const Exact& g) { return g - Exact(1); })};
        last = {wide_G + 1, of_G([](const Exact& g) { return g + Exact(1); })};
    }
    if (below(crossing, one)) points.push_back(crossing);
    if (below(one, turn)) points.push_back(turn);
    points.push_back(last);
    points.insert(points.end(), weight.ends().begin(), weight.ends().end());
    std::sort(points.begin(), points.end(), below);

    const AreaSlope slope(wide_G);
    const End end = lesser(weight.ends().back(), last);
    Ball sum(0);
    for (std::size_t k = 0; k + 1 < points.size() && below(points[k], end); ++k) {
        if (!below(points[k], points[k + 1])) continue;
        const Piece piece(points[k], points[k + 1], Extent::whole);
        sum += Part(piece, points[k], slope, weight, crossing, turn, last, !below(points[k], one)).integral(goal);
    }
    return sum;
}

} // namespace touchstone::transfer
