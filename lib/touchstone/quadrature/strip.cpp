// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/strip.hpp"

#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace touchstone::quadrature {
namespace {

Ball exactly(double x) { return Ball::exactly(x); }

ComplexBall conjugate(ComplexBall z)
{
    acb_conj(z.get(), z.get());
    return z;
}

/// cos y for 0 <= y < pi/2 and sin y, at an exact y.
std::pair<Ball, Ball> cos_sin(double y) { return {cos(exactly(y)), sin(exactly(y))}; }

Ball sinh_of(double x) { Ball r; arb_sinh(r.get(), exactly(x).get(), strip_bits); return r; }
Ball cosh_of(double x) { Ball r; arb_cosh(r.get(), exactly(x).get(), strip_bits); return r; }

struct FarAndNear {
    ComplexBall far, near, log_one_plus_e; // 1/(1 + E), E/(1 + E), log(1 + E)
};

Ball lowest(const Ball& x)
{
    Ball r;
    arb_get_lbound_arf(arb_midref(r.get()), x.get(), strip_bits);
    return r;
}
Ball highest(const Ball& x)
{
    Ball r;
    arb_get_ubound_arf(arb_midref(r.get()), x.get(), strip_bits);
    return r;
}

/// The least interval that has all values of a function on a box, from those at its corners and at the places where it may be largest.
class Range {
public:
    void take(const Ball& value)
    {
        const Ball low = lowest(value), high = highest(value);
        if (empty_ || !arb_ge(low.get(), low_.get())) low_ = low;
        if (empty_ || !arb_le(high.get(), high_.get())) high_ = high;
        empty_ = false;
    }
    const Ball& low() const { return low_; }
    const Ball& high() const { return high_; }
    Ball ball() const { return touchstone::hull(low_, high_); }

private:
    Ball low_, high_;
    bool empty_ = true;
};

/// Whether an angle of [low, high] may be congruent to `at` modulo 2 pi. In double with room to spare: where in doubt, yes.
bool may_meet(double low, double high, double at)
{
    constexpr double spare = 1e-9;
    const double k = std::ceil((low - at) / (2 * M_PI) - spare);
    return !(at + 2 * M_PI * k > high + spare * (1 + std::fabs(high)));
}

/// For E = exp(-w), w = x + iy, 0 <= re1 <= x <= re2, im1 <= y <= im2. With e = exp(-x), c = cos y, s = sin y and D = |1 + E|^2 = 1 + 2ec + e^2:
/// 1/(1 + E) = (1 + ec + i es)/D = (1 + tanh(w/2))/2, E/(1 + E) = (e(c + e) - i es)/D, log(1 + E) = log(D)/2 - i atan2(es, 1 + ec).
/// Their parts are monotone in x and in c (or s) but at the places named below, so corners and those places bound them (tanh_sinh.md, section 2).
FarAndNear far_and_near(const Ball& re1, const Ball& re2, const Ball& im1, const Ball& im2)
{
    const FarAndNear nothing{ComplexBall::indeterminate(), ComplexBall::indeterminate(), ComplexBall::indeterminate()};
    const double y1 = arf_get_d(arb_midref(im1.get()), ARF_RND_DOWN), y2 = arf_get_d(arb_midref(im2.get()), ARF_RND_UP);
    constexpr double farthest = 1e5; // beyond, angles in double are too coarse
    if (!(y2 < farthest)) return nothing;
    const std::array<Ball, 2> e{exp(-re2), exp(-re1)};
    std::array<Ball, 2> sine, cosine;
    arb_sin_cos(sine[0].get(), cosine[0].get(), im1.get(), strip_bits);
    arb_sin_cos(sine[1].get(), cosine[1].get(), im2.get(), strip_bits);
    Range c;
    for (const Ball& v : cosine) c.take(v);
    if (may_meet(y1, y2, 0)) c.take(Ball(1));
    if (may_meet(y1, y2, M_PI)) c.take(Ball(-1));

    const Ball one(1);
    Range d, far_real, near_real, imaginary, angle;
    for (const Ball& r : e)
        for (const Ball& v : {c.low(), c.high()}) {
            const Ball modulus = one + r * (v + v + r);
            d.take(modulus);
            far_real.take((one + r * v) / modulus);
            near_real.take(r * (v + r) / modulus);
        }
    const Ball opposite = -c.low(), square = one - opposite * opposite;
    const auto may_be_between = [&](const Ball& low, const Ball& high) {
        return !arb_lt(opposite.get(), low.get()) && !arb_gt(opposite.get(), high.get());
    };
    if (may_be_between(e[0], e[1])) d.take(square); // D is least at e = -c
    const auto secant = [&](const Ball& r) { return (r + r) / (one + r * r); }; // 1/cosh x
    if (may_be_between(secant(e[0]), secant(e[1]))) { // where c cosh x = -1 the real parts are (1 +- 1/sqrt(1 - c^2))/2, beyond 1 and 0
        const Ball root = sqrt(square), beyond = opposite * opposite / (root * (one + root) * Ball(2));
        far_real.take(one + beyond);
        near_real.take(-beyond);
    }
    if (!arb_is_positive(d.low().get())) return nothing;
    for (const Ball& r : e) {
        for (const std::size_t k : {0, 1}) {
            const Ball across = r * sine[k], along = one + r * cosine[k];
            imaginary.take(across / (along * along + across * across));
            angle.take(atan2(across, along));
        }
        // for fixed e the angle is extreme where cos y = -e, the imaginary part where cos y = -2e/(1 + e^2)
        const double size = std::min(1.0, arf_get_d(arb_midref(r.get()), ARF_RND_NEAR));
        for (const double sign : {1.0, -1.0}) {
            if (may_meet(y1, y2, M_PI - sign * std::acos(size))) angle.take(Ball(static_cast<long>(sign)) * asin(at_most(r, one)));
            if (may_meet(y1, y2, M_PI - sign * std::acos(2 * size / (1 + size * size)))) imaginary.take(Ball(static_cast<long>(sign)) * r / (one - r * r));
        }
    }
    const Ball half_log = touchstone::hull(log(d.low()), log(d.high())) / Ball(2), across = imaginary.ball();
    return {ComplexBall(far_real.ball(), across), ComplexBall(near_real.ball(), -across), ComplexBall(half_log, -angle.ball())};
}

struct Key {
    std::array<double, 4> corner;
    Side side;
    bool operator==(const Key&) const = default;
};
struct KeyHash {
    std::size_t operator()(const Key& k) const
    {
        std::uint64_t h = k.side == Side::left ? 0x9e3779b97f4a7c15u : 0;
        for (const double c : k.corner) h = (h ^ std::bit_cast<std::uint64_t>(c)) * 0xff51afd7ed558ccdu + (h >> 29);
        return static_cast<std::size_t>(h ^ (h >> 32));
    }
};

} // namespace

StripPiece StripPiece::finite(Side side, double x1, double x2, double y1, double y2)
{
    StripPiece piece;
    piece.side_ = side;
    piece.x1_ = x1;
    piece.x2_ = x2;
    const Ball pi = touchstone::pi<Ball>();
    const auto [c1, s1] = cos_sin(y1);
    const auto [c2, s2] = cos_sin(y2);
    const Ball sh1 = sinh_of(x1), sh2 = sinh_of(x2), ch1 = cosh_of(x1), ch2 = cosh_of(x2);
    // every factor is monotone and non-negative on the piece
    const Ball re1 = pi * sh1 * c2, re2 = pi * sh2 * c1, im1 = pi * ch1 * s1, im2 = pi * ch2 * s2;
    const ComplexBall w(hull(re1, re2), hull(im1, im2));
    const FarAndNear map = far_and_near(re1, re2, im1, im2);
    const ComplexBall &far = map.far, &near = map.near;
    const ComplexBall log_far = -map.log_one_plus_e;
    const ComplexBall log_near = log_far - w;
    const bool left = side == Side::left;
    piece.far_ = left ? conjugate(far) : far;
    piece.near_ = left ? conjugate(near) : near;
    piece.log_far_ = left ? conjugate(log_far) : log_far;
    piece.log_near_ = left ? conjugate(log_near) : log_near;
    // |cosh(x + iy)|^2 = sinh^2 x + cos^2 y
    piece.stretch_ = pi * sqrt(sh2 * sh2 + c1 * c1);
    return piece;
}

StripPiece StripPiece::endless(Side side, double x1, double y2)
{
    StripPiece piece;
    piece.side_ = side;
    piece.endless_ = true;
    piece.x1_ = x1;
    piece.x2_ = std::numeric_limits<double>::infinity();
    const auto [c, s] = cos_sin(y2);
    piece.depth_ = touchstone::pi<Ball>() * sinh_of(x1) * c;
    const Ball e = exp(-piece.depth_);            // |E| <= e < 1
    const Ball near = e / (Ball(1) - e);          // |E/(1 + E)|
    const Ball log_far = -log(Ball(1) - e);       // |log(1 + E)|
    piece.near_ = disc(near);
    piece.far_ = ComplexBall(1) + disc(near);
    piece.log_near_ = ComplexBall::indeterminate();
    piece.log_far_ = disc(log_far);
    // |Im w| = pi cosh x sin y <= rho tan d coth x1
    piece.slope_ = s / c * cosh_of(x1) / sinh_of(x1);
    return piece;
}

/// The distance is exp(-w') times 1/(1 + E), with Re w' = rho >= A = depth: |u|^e rho^k is at most
/// (1 - exp(-A))^-e times the sup of exp(-e rho) rho^k, taken at A or at rho = k/e.
ComplexBall StripPiece::vanishing(Side s, const Ball& e, const Exponent& k) const
{
    if (!reaches(s) || !arb_is_nonnegative(e.get())) return ComplexBall::indeterminate();
    const Ball exponent = k.ball();
    const auto size = [&](const Ball& rho) { return exp(exponent * log(rho) - e * rho); };
    if (arb_is_zero(e.get())) { // rho^k alone: real, from 0 to A^k
        if (Exponent(0) < k) return ComplexBall::indeterminate();
        return ComplexBall(hull(Ball(0), size(depth_)));
    }
    Ball top = size(depth_);
    if (Exponent(0) < k) top = size(at_least(exponent / e, depth_)); // decreasing from there on
    return disc(top * exp(-e * log(Ball(1) - exp(-depth_))));
}

/// log u = -w' - log(1 + E): over rho it is -1 + i[-slope, slope] + (log_far)/A.
ComplexBall StripPiece::logarithm_over_rho(Side s) const
{
    if (!reaches(s)) return ComplexBall::indeterminate();
    const Ball log_far = -log(Ball(1) - exp(-depth_));
    return ComplexBall(Ball(-1), hull(-slope_, slope_)) + disc(log_far / depth_);
}

StripPiece StripPiece::at(Side side, double x1, double x2, double y1, double y2)
{
    thread_local std::unordered_map<Key, StripPiece, KeyHash> cache;
    const Key key{{x1, x2, y1, y2}, side};
    if (const auto found = cache.find(key); found != cache.end()) return found->second;
    if (cache.size() > 40000) cache.clear();
    const WorkingPrecision precision(strip_bits);
    return cache.emplace(key, std::isinf(x2) ? endless(side, x1, y2) : finite(side, x1, x2, y1, y2)).first->second;
}

const StripPiece& StripPiece::everywhere()
{
    thread_local const StripPiece piece = [] {
        StripPiece p;
        p.near_ = p.far_ = p.log_near_ = p.log_far_ = ComplexBall::indeterminate();
        p.stretch_ = p.depth_ = Ball::indeterminate();
        return p;
    }();
    return piece;
}

} // namespace touchstone::quadrature
