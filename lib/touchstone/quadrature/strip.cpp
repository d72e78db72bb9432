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

ComplexBall hull(const ComplexBall& a, const ComplexBall& b)
{
    ComplexBall z;
    acb_union(z.get(), a.get(), b.get(), strip_bits);
    return z;
}

struct FarAndNear {
    ComplexBall far, near, log_one_plus_e; // 1/(1 + E), E/(1 + E), log(1 + E)
};

/// For E = exp(-w), Re w in [re1, re2] (>= 0), Im w in [im1, im2]. With e = |E|, c = cos Im w, s = sin Im w:
/// 1 + E = 1 + e c - i e s, D = |1 + E|^2; real and imaginary parts apart, on parts of w small enough for balls.
FarAndNear far_and_near(const Ball& re1, const Ball& re2, const Ball& im1, const Ball& im2)
{
    const auto parts = [](const Ball& a, const Ball& b) {
        const double width = arf_get_d(arb_midref((b - a).get()), ARF_RND_UP);
        return std::clamp(static_cast<long>(std::ceil(width / 0.5)), 1L, 4L);
    };
    const auto part = [](const Ball& a, const Ball& b, long i, long n) {
        return touchstone::hull(a + (b - a) * Ball(i) / Ball(n), a + (b - a) * Ball(i + 1) / Ball(n));
    };
    const long n = parts(re1, re2), m = parts(im1, im2);
    std::optional<FarAndNear> all;
    for (long i = 0; i < n; ++i) {
        // exp is monotone: from the ends of the part
        const Ball e = touchstone::hull(exp(-(re1 + (re2 - re1) * Ball(i) / Ball(n))), exp(-(re1 + (re2 - re1) * Ball(i + 1) / Ball(n))));
        for (long j = 0; j < m; ++j) {
            const Ball angle = part(im1, im2, j, m);
            const Ball ec = e * cos(angle), es = e * sin(angle), a = Ball(1) + ec;
            const Ball d = a * a + es * es;
            if (!arb_is_positive(d.get())) return {ComplexBall::indeterminate(), ComplexBall::indeterminate(), ComplexBall::indeterminate()};
            const FarAndNear here{ComplexBall(a / d, es / d), ComplexBall((ec + e * e) / d, -es / d), analytic::log(ComplexBall(a, -es))};
            if (!all) all = here;
            else all = FarAndNear{hull(all->far, here.far), hull(all->near, here.near), hull(all->log_one_plus_e, here.log_one_plus_e)};
        }
    }
    return *all;
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
