// SPDX-License-Identifier: MIT
/// T V at a point beside the same integral in balls: V with jumps of 1 at edges, on panels as narrow as can be, at ratios next to 1, to 0 and to
/// where an end of the kernel meets an edge. No rounding may exceed what is claimed for it.
#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/transfer/layer.hpp"
#include "touchstone/transfer/proven_levels.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>

using namespace touchstone;
using namespace touchstone::transfer;
using namespace touchstone::transfer::levels;

namespace {

/// T V_m(x) = (1/pi) int V_m dtheta, panel by panel: T_k of the local coordinate is a polynomial in c = cos theta, and int c^j dtheta is known.
class InBalls {
public:
    InBalls(const Layer& layer, const Ball& G) : layer_(layer), G_(G)
    {
        mag_zero(arb_radref(G_.get())); // of the numbers within reach of rounding, one
    }
    std::vector<Ball> at(const Real& number) const
    {
        const Ball x = to_exact(number);
        std::vector<Ball> sum(static_cast<std::size_t>(layer_.count), Ball(0));
        for (std::size_t j = 0; j < layer_.panels.size(); ++j) add_panel(j, x, sum);
        const WorkingPrecision precision(300);
        for (Ball& s : sum) s = s / pi<Ball>();
        return sum;
    }

private:
    /// c where the next ratio is y = z^(1/2), kept in [-1, 1].
    Ball cosine(const Ball& x, const Ball& z, bool full) const
    {
        const Ball c = full ? G_ * sqrt(z) - x : sqrt((1 - x) * (1 - x) + G_ * G_ * z) - x;
        return at_least(at_most(c, Ball(1)), Ball(-1));
    }
    void add_panel(std::size_t j, const Ball& x, std::vector<Ball>& sum) const
    {
        const Panel& p = layer_.panels[j];
        const int terms = used(j);
        // powers of c cancel to numbers below 1: (4 z/half)^terms
        const double x_ = arf_get_d(arb_midref(x.get()), ARF_RND_NEAR), size = 4 * (std::pow((1 + std::max(1.0, x_)) / double(layer_.G), 2) + double(p.centre)) / double(p.half);
        const WorkingPrecision precision(400 + static_cast<slong>(terms * std::log2(4 + size)));
        const bool full = !certainly(less(x, Ball(1)));
        const Ball low = cosine(x, to_exact(p.z0), full), high = cosine(x, to_exact(p.z1), full);
        if (!certainly(less(low, high))) return; // both beyond the same end
        const auto n = static_cast<std::size_t>(2 * terms);
        std::vector<Ball> integral(n); // of c^j
        const Ball a = acos(low), b = acos(high), sine_a = sqrt_of(1 - low * low), sine_b = sqrt_of(1 - high * high);
        Ball power_a(1), power_b(1);
        for (std::size_t i = 0; i < n; ++i) {
            const long k = static_cast<long>(i);
            if (i == 0) integral[0] = a - b;
            else {
                integral[i] = (power_a * sine_a - power_b * sine_b) / k;
                if (i > 1) integral[i] = integral[i] + integral[i - 2] * (k - 1) / k;
                power_a = power_a * low;
                power_b = power_b * high;
            }
        }
        // z G^2 = (x + c)^2 or (1 + c)(2x - 1 + c)
        const Ball G2 = G_ * G_ * to_exact(p.half), shift = to_exact(p.centre) / to_exact(p.half);
        const Ball l0 = (full ? x * x : 2 * x - 1) / G2 - shift, l1 = 2 * x / G2, l2 = 1 / G2;
        std::vector<Ball> before{Ball(1)}, now{l0, l1, l2};
        for (int k = 0; k < terms; ++k) {
            Ball moment(0);
            for (std::size_t i = 0; i < before.size(); ++i) moment += before[i] * integral[i];
            for (int m = 0; m < layer_.count; ++m) {
                const Real c = layer_.coefficients[layer_.row(j, k) + static_cast<std::size_t>(m)];
                sum[static_cast<std::size_t>(m)] += to_exact(c) * moment;
            }
            std::vector<Ball> next(now.size() + 2, Ball(0));
            for (std::size_t i = 0; i < now.size(); ++i) {
                next[i] += 2 * l0 * now[i];
                next[i + 1] += 2 * l1 * now[i];
                next[i + 2] += 2 * l2 * now[i];
                if (i < before.size()) next[i] -= before[i];
            }
            before = std::move(now);
            now = std::move(next);
        }
    }
    /// One more than the highest degree of any V_m there.
    int used(std::size_t j) const
    {
        for (int k = layer_.orders.terms; k > 1; --k)
            for (int m = 0; m < layer_.count; ++m)
                if (layer_.magnitude(j, k - 1, m) > 0) return k;
        return 1;
    }
    static Ball sqrt_of(const Ball& x)
    {
        Ball r;
        arb_sqrtpos(r.get(), x.get(), WorkingPrecision::bits());
        return r;
    }
    static Ball to_exact(const Real& v)
    {
        const WorkingPrecision precision(2000);
        return Ball::exactly(v.high) + Ball::exactly(v.low);
    }

    const Layer& layer_;
    Ball G_;
};

/// The largest |difference|/claimed; not above 1 if nothing is wrong.
struct Worst {
    double ratio = 0;
    long compared = 0;
    void compare(const Layer& layer, const Ball& G, const Real& x)
    {
        Result out;
        layer.apply(x, out);
        const WorkingPrecision precision(300);
        const std::vector<Ball> known = InBalls(layer, G).at(x);
        for (int m = 0; m < layer.count; ++m) {
            const auto i = static_cast<std::size_t>(m);
            if (!(out.error[i] < bounds::infinite)) continue;
            const Ball off = abs(to_ball(out.value[i]) - known[i]);
            INFO("x = ", double(x), ", m = ", m, ", off by ", off.to_string(), ", claimed ", out.error[i]);
            REQUIRE(off.radius_bound() < 1e-40);
            CHECK_FALSE(certainly(less(Ball::exactly(out.error[i]), off)));
            if (out.error[i] > 0) ratio = std::max(ratio, arf_get_d(arb_midref(off.get()), ARF_RND_NEAR) / out.error[i]);
            ++compared;
        }
    }
};

struct Draw {
    std::mt19937_64 engine;
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); }
    Real real(double a, double b) { const double v = between(a, b); return Real(v) + Real(between(-1, 1) * std::ldexp(v, -54)); }
};

/// From lowest to highest, halved towards a point until a panel is as narrow as that.
std::vector<Panel> mesh_towards(const Real& at, double narrow, double lowest, double highest)
{
    std::vector<Real> edges{at};
    for (double z = lowest; z < highest; z *= 1.6) edges.emplace_back(z);
    edges.emplace_back(highest);
    for (double w = 0.25; w > 1.1 * narrow; w /= 2)
        for (const int side : {-1, 1}) edges.push_back(at * (Real(1) + Real(side * w)));
    std::sort(edges.begin(), edges.end());
    std::vector<Panel> panels;
    Real from = edges.front();
    for (const Real& to : edges) {
        if (to > Real(highest) || !(to - from >= Real(1.05 * narrow) * to)) continue;
        panels.push_back(panel(from, to, panels.empty()));
        from = to;
    }
    return panels;
}

/// Coefficient k of V_m on a panel, drawn. \param inside not one of the panels next to an end of the kernel
using Series = Real (*)(Draw&, int k, int m, int terms, bool inside);
/// V = 1, V that jump between 1 and -1 at every edge, and V that do so except at the very ends of the kernel.
Real constants(Draw& draw, int k, int m, int, bool inside)
{
    if (k > 0) return 0;
    return m == 0 || (m == 2 && !inside) || draw.between(0, 1) < 0.5 ? Real(1) : Real(-1);
}
/// Of the highest degree alone, and of all degrees.
Real polynomials(Draw& draw, int k, int m, int terms, bool)
{
    if (m < 2) return k + 1 == terms ? Real(m == 0 || draw.between(0, 1) < 0.5 ? 1 : -1) : Real(0);
    return draw.real(-1, 1);
}

/// As fast as those of a function that is resolved: from some of them on, moments are taken in binary64.
Real falling(Draw& draw, int k, int m, int, bool) { return draw.between(-1, 1) * std::pow(m < 2 ? 0.3 : 0.45, k); }

double attack(Draw& draw, int rounds, double tolerance, double narrow, Series series)
{
    const Orders orders(tolerance);
    const Gauss gauss(orders.gauss), exact(orders.terms);
    const ChebyshevPoints kernel_points(orders.kernel);
    const auto terms = static_cast<std::size_t>(orders.terms);
    Worst worst;
    for (int round = 0; round < rounds; ++round) {
        const Real G = draw.real(1.1, 6);
        const Real x = round % 3 == 0 ? draw.real(1.0001, 6) : round % 3 == 1 ? draw.real(0.01, 0.9999) : Real(1) + Real(draw.between(-1, 1) * 1e-13);
        const Kernel k(x, G, x >= 1);
        // an edge of the mesh at an end of the kernel, next to it, at c = 0, or anywhere
        const Real middle = k.full ? (x * x) / (G * G) : k.end * 0.25;
        const Real hard[] = {k.end, k.full && k.begin > Real(1e-8) ? k.begin : middle, k.end * Real{1, std::ldexp(draw.between(-1, 1), -100)}, middle, k.end * draw.real(0.2, 0.95)};
        Layer layer(orders, gauss, kernel_points, exact, G, tolerance, mesh_towards(hard[(round / 3) % 5], narrow, 1e-9, 3 * double(k.end)), 4);
        for (int m = 0; m < 4; ++m) {
            Wide all(layer.panels.size() * terms);
            for (std::size_t j = 0; j < layer.panels.size(); ++j) {
                const bool inside = std::abs(static_cast<int>(j) - layer.find(k.end)) > 4 && (!k.full || std::abs(static_cast<int>(j) - layer.find(k.begin)) > 4);
                for (std::size_t i = 0; i < terms; ++i) all.set(j * terms + i, series(draw, static_cast<int>(i), m, orders.terms, inside));
            }
            layer.set(m, all);
        }
        const WorkingPrecision precision(300);
        const Ball true_G = to_ball(G) * (1 + Ball::exactly((round % 2 ? 0.99 : -0.99) * bounds::u));
        CAPTURE(round);
        CAPTURE(double(G));
        worst.compare(layer, true_G, x);
    }
    MESSAGE(worst.compared << " compared, largest error: " << worst.ratio << " of what is claimed");
    return worst.ratio;
}

unsigned long seed()
{
    const char* given = std::getenv("TOUCHSTONE_SEED");
    const unsigned long n = given ? std::strtoul(given, nullptr, 10) : 1974;
    MESSAGE("seed " << n);
    return n;
}

} // namespace

// Claims much wider than any error would hide a constant that is too small: hence the lower bounds.

TEST_CASE("T V beside the same in balls: V jumps at every edge, and edges crowd at the ends of the kernel")
{
    Draw draw{std::mt19937_64(seed())};
    CHECK(attack(draw, 15, 1e-25, 2 * narrowest, constants) > 1e-3);
}

TEST_CASE("T V beside the same in balls: polynomials of the highest degree")
{
    Draw draw{std::mt19937_64(seed())};
    CHECK(attack(draw, 15, 1e-25, 1e-6, polynomials) > 1e-6);
}

TEST_CASE("T V beside the same in balls: coefficients that fall, and with them what is asked of their moments")
{
    Draw draw{std::mt19937_64(seed())};
    CHECK(attack(draw, 15, 1e-14, 1e-6, falling) > 1e-5);
}

TEST_CASE("T V of a whole run beside the same in balls")
{
    Draw draw{std::mt19937_64(seed())};
    const Real G(1.5);
    const ProvenLevels run(Ball::exactly(1.5), 2, 1e-11);
    Worst worst;
    const Layer& layer = run.layer();
    for (int i = 0; i < 6; ++i) {
        // anywhere, and where an end of the kernel meets an edge of the mesh
        const Real edge = sqrt(layer.panels[static_cast<std::size_t>(draw.between(0.5, 0.95) * static_cast<double>(layer.panels.size()))].z0);
        worst.compare(layer, Ball::exactly(1.5), i % 2 ? draw.real(0.001, 2) : edge * G > Real(2) ? edge * G - 1 : edge * edge * G * G * 0.25);
    }
    MESSAGE(worst.compared << " compared, largest error: " << worst.ratio << " of what is claimed");
}

TEST_CASE("panels too narrow for their points to be told apart are refused")
{
    const Orders orders(1e-9);
    const Gauss gauss(orders.gauss), exact(orders.terms);
    const ChebyshevPoints kernel_points(orders.kernel);
    CHECK_THROWS_AS(Layer(orders, gauss, kernel_points, exact, Real(2), 1e-9, {panel(Real(1), Real(1) + Real(narrowest), true)}, 4), BeyondReach);
}
