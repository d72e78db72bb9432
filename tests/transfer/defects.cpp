// SPDX-License-Identifier: MIT
/// D_m >= |T V_(m-1) - V_m| at random ratios, for V_m that jump at every edge of the mesh: whether the intervals of the proof leave none out, and whether
/// what it takes from finitely many points holds between them. The values of T V are those of layer.hpp, which has a test of its own.
#include "touchstone/transfer/defects.hpp"
#include "touchstone/transfer/step_defect.hpp"

#include <doctest/doctest.h>

#include <array>
#include <complex>
#include <numbers>
#include <random>

using namespace touchstone;
using namespace touchstone::transfer;
using namespace touchstone::transfer::levels;

namespace {

constexpr double tolerance = 1e-6;
constexpr int levels_made = 4;

/// The largest defect known about x.
double defect_at(const std::vector<Part>& parts, const Real& x)
{
    double found = 0;
    for (const Part& p : parts)
        if (p.y0 <= x && x <= p.y1) found = std::max(found, p.defect);
    return found;
}

struct Seen {
    long points = 0;
    double closest = 0; ///< largest of difference/defect
};

Seen look(double G_, double jumps, double highest)
{
    const Real G = G_;
    const Rules rules(tolerance);
    const auto first = in_contact();
    std::mt19937_64 random(20261122);
    std::uniform_real_distribution<double> unit(0, 1);
    const Spoiled spoiled = [&](int m, double, double) { return m == 1 ? jumps * unit(random) : 0; };
    const auto V = collocate(rules, *first, G, highest, tolerance, levels_made, spoiled);
    Defects D(rules, *V, levels_made, tolerance, true);
    D.prove_level_zero(*first);
    D.prove_steps();
    D.add_up();
    Seen seen;
    Result there;
    for (int m = 1; m < levels_made; ++m) {
        const auto parts = D.parts(m, bounds::infinite);
        for (std::size_t i = 1; i + 1 < V->panels.size(); ++i)
            for (int k = 0; k < 12; ++k) {
                const Panel& p = V->panels[i];
                const Real x = p.y0 + (p.y1 - p.y0) * unit(random);
                if ((x + 1) / G * ((x + 1) / G) > V->panels.back().z1) continue; // sees beyond the mesh
                V->apply(x, there);
                const double difference = std::fabs(double(there.value[m - 1] - V->value(i, m, (x * x - p.centre) / p.half))) - there.error[m - 1];
                INFO("G = ", G_, ", level ", m, ", x = ", double(x), ": ", difference, " <= ", defect_at(parts, x));
                REQUIRE(difference <= defect_at(parts, x));
                seen.closest = std::max(seen.closest, difference / defect_at(parts, x));
                ++seen.points;
            }
    }
    return seen;
}

} // namespace

TEST_CASE("defects hold between the points they were found from")
{
    for (const double jumps : {0.0, 1e-5, 1e-2})
        for (const double G : {1.25, 2.5}) {
            const Seen seen = look(G, jumps, 6);
            INFO("jumps ", jumps, ", G = ", G, ": ", seen.points, " points, at most ", seen.closest, " of the defect");
            CHECK(seen.points > 1000);
            CHECK(seen.closest > 0.05); // the test would see a defect that is too small
        }
}

namespace {

using Complex = std::complex<double>;
constexpr double pi_ = std::numbers::pi;

/// Points of the circle about a real x.
std::vector<Complex> circle(double x, double r)
{
    std::vector<Complex> points;
    for (int k = 0; k < 24; ++k) points.push_back(x + std::polar(r, k * pi_ / 12));
    return points;
}

/// What is made by hand instead of by collocation.
struct Made {
    Rules rules;
    Layer V;
    Made(double tolerance_, const Real& G, std::vector<Panel> panels, int levels)
        : rules(tolerance_), V(layer_on(rules, G, tolerance_, std::move(panels), columns_for(levels)))
    {
    }
    void set(int m, const std::function<Real(std::size_t panel, int k)>& coefficient)
    {
        const auto terms = static_cast<std::size_t>(rules.orders.terms);
        Wide all(V.panels.size() * terms);
        for (std::size_t i = 0; i < V.panels.size(); ++i)
            for (std::size_t k = 0; k < terms; ++k) all.set(i * terms + k, coefficient(i, static_cast<int>(k)));
        V.set(m, all);
    }
};

/// Panels of random widths, each by the factor that is drawn.
std::vector<Panel> drawn_panels(std::mt19937_64& random, double lowest, double highest, double least, double most)
{
    std::uniform_real_distribution<double> factor(least, most);
    std::vector<Panel> panels;
    for (double z = lowest; z < highest;) {
        const double to = z * factor(random);
        panels.push_back(panel(Real(z), Real(to), panels.empty()));
        z = to;
    }
    return panels;
}

/// One wave, at a complex ratio.
struct WaveAt {
    Complex x;
    double G;
    bool full;
    Complex cosine(double y) const { return full ? G * y - x : std::sqrt((1. - x) * (1. - x) + G * G * y * y) - x; }
    Complex square(Complex c) const { return (full ? (x + c) * (x + c) : (1. + c) * (2. * x - 1. + c)) / (G * G); }
    /// (1/pi) int |dtheta| between real y.
    double mass(double from, double to) const
    {
        double sum = 0;
        constexpr int parts = 100;
        for (int k = 0; k < parts; ++k) {
            const double y = from + (to - from) * (k + 0.5) / parts;
            const Complex c = cosine(y), dc = full ? G : G * G * y / (x + c);
            sum += std::abs(dc / std::sqrt((1. - c) * (1. + c))) * (to - from) / parts;
        }
        return sum / pi_;
    }
    /// The share of theta at a real x.
    double share(double from, double to) const
    {
        const auto angle = [&](double y) { return std::acos(std::clamp(cosine(y).real(), -1., 1.)); };
        return to > from ? (angle(from) - angle(to)) / pi_ : 0;
    }
};
/// (1/pi) int |dtheta| over an end, 1 -+ c = s^2 w.
double end_mass(Complex w)
{
    double sum = 0;
    for (int k = 0; k < 200; ++k) sum += 1 / std::sqrt(std::abs(2. - (k + 0.5) * (k + 0.5) / 4e4 * w)) / 200;
    return sum * 2 / pi_ * std::sqrt(std::abs(w));
}

/// The largest t up to `most` with which it is so, where it is for small t.
double largest(double most, const std::function<bool(double)>& so)
{
    double low = 0, high = most;
    for (int k = 0; k < 40; ++k) {
        const double t = (low + high) / 2;
        (so(t) ? low : high) = t;
    }
    return low;
}

} // namespace

TEST_CASE("what squares and forces move by on a disc, and the share of an end of the wave: bounds that are attained")
{
    for (const double r : {1e-3, 0.1, 0.2})
        for (const double x : {0.3, 0.7}) {
            double square = 0, force = 0, share = 0;
            for (const Complex& v : circle(x, r)) {
                square = std::max(square, std::abs(v * v - x * x));
                share = std::max(share, end_mass(v - x));
                for (const Complex& c : circle(1, 2 * r)) force = std::max(force, std::abs((1. + c) * (2. * v - 1. + c) - 4 * x));
            }
            CHECK(square_moves(x, r) == doctest::Approx(square).scale(0).epsilon(1e-9));
            CHECK(force_moves(x, r, 2 * r) == doctest::Approx(force).scale(0).epsilon(1e-9));
            CHECK(end_share(r) >= share);
            CHECK(end_share(r) < share * (1 + r / 4));
        }
    CHECK(end_share(1.44) >= end_mass(1.44));
    CHECK(end_share(1.44) < 1.6 * end_mass(1.44));
}

TEST_CASE("V continued at the ends of the wave: on the disc that is admitted, and no larger one is, everything is as the proof has it")
{
    std::mt19937_64 random(20261127);
    std::uniform_real_distribution<double> unit(0, 1);
    int seen[2] = {}, by_end = 0, at_left[2] = {}, first_panel = 0;
    double overlap_used[2] = {};
    for (int round = 0; round < 6; ++round) {
        const double G_ = 1.1 + 4 * unit(random), lowest = round % 3 ? 1e-2 : 0.3;
        const Made made(1e-5, Real(G_), drawn_panels(random, lowest, 40, 1.05, round % 2 ? 1.6 : 6), 1);
        const Layer& V = made.V;
        for (int k = 0; k < 60; ++k) {
            const bool full = k % 2;
            const double x = full ? 1 + 5 * unit(random) * unit(random) : unit(random);
            const auto about = [&](double h) { return Interval(Real(x - h), Real(x + h)); };
            Continuation f;
            if (continue_wave(V, about(1e-12), 1e-12, f) != Fit::yes) continue;
            ++seen[full];
            CAPTURE(G_);
            CAPTURE(x);
            CHECK(f.ends[0].panel >= (full ? 0 : -1));
            if (!full) CHECK(f.ends[0].panel == -1);
            for (const double of_most : {1., 0.3}) {
                const double most = largest(full ? x - 1 : 1 - x, [&](double r) { return continue_wave(V, about(1e-12), r, f) == Fit::yes; }), r = of_most * most;
                REQUIRE(continue_wave(V, about(1e-12), r, f) == Fit::yes);
                const WaveAt here{x, G_, full};
                double may = full ? (x - 1) / bounds::margin : std::min(0.24 * (1 - x), 0.5 * x);
                for (const bool upper : {false, true}) {
                    const Continuation::End& e = f.ends[upper];
                    if (e.panel < 0) continue;
                    const Panel& q = V.panels[static_cast<std::size_t>(e.panel)];
                    const double inner = double(e.inner), left = std::sqrt(std::max(double(q.left()), lowest)), right = std::sqrt(double(q.right()));
                    first_panel += e.panel == 0;
                    CHECK(inner >= left * (1 - 1e-12));
                    CHECK(inner <= right * (1 + 1e-12));
                    const auto gap = [&](const WaveAt& wave, double y) { return upper ? 1. - wave.cosine(y) : 1. + wave.cosine(y); };
                    CHECK(e.gap == doctest::Approx(gap(here, inner).real()).scale(0).epsilon(1e-9));
                    CHECK(e.gap <= 0.8 * (1 + 1e-12));
                    if (!(e.gap > 0.8 * (1 - 1e-12))) {
                        CHECK((upper ? inner - left : inner - right) == doctest::Approx(0).scale(1).epsilon(1e-12));
                        ++at_left[upper];
                    }
                    may = std::min(may, 0.79 * e.gap / (full ? 1 : 2.36));
                    for (const Complex& v : circle(x, r)) {
                        const WaveAt there{v, G_, full};
                        CHECK(end_mass(gap(there, inner)) <= e.factor);
                        for (const double t : {0., 0.3, 0.6, 1.}) {
                            const Complex w = t * gap(there, inner), local = (there.square(upper ? 1. - w : w - 1.) - double(q.centre)) / double(q.half);
                            CHECK((std::abs(local - 1.) + std::abs(local + 1.)) / 2 - 1 <= e.distance * (1 + 1e-9));
                        }
                    }
                    CHECK(e.factor == doctest::Approx(end_share(1.8 * e.gap)).scale(0).epsilon(1e-12));
                    const double z_moves = full ? square_moves(upper ? (x + 1) / G_ : inner, r / G_) : force_moves(x, r, 2.36 * r) / (G_ * G_);
                    CHECK(e.distance == doctest::Approx(z_moves / double(q.half)).scale(0).epsilon(1e-9));
                    CHECK(e.overlap == doctest::Approx(largest_share(G_, std::max(0., double(q.y0) - left)) + largest_share(G_, std::max(0., right - double(q.y1)))).scale(1e-6).epsilon(2e-3));
                }
                if (of_most == 1) {
                    CHECK(r <= may * (1 + 1e-9));
                    CHECK(r > may * (1 - 1e-9));
                }
                const double from = full ? double(f.ends[0].inner) : 0, to = double(f.ends[1].inner);
                for (const Complex& v : circle(x, r)) CHECK(WaveAt{v, G_, full}.mass(from, to) <= f.middle);
            }
            // the widest J: an image of an end of it is at the end of a panel's interval, or it ends at 1
            const double widest = largest(2 * x, [&](double h) { return continue_wave(V, about(h), 1e-12, f) == Fit::yes; });
            REQUIRE(continue_wave(V, about(widest), 1e-12, f) == Fit::yes);
            bool at_end = std::fabs(x - 1) < widest + 1e-9;
            for (const bool upper : {false, true}) {
                const Continuation::End& e = f.ends[upper];
                if (e.panel < 0) continue;
                const Panel& q = V.panels[static_cast<std::size_t>(e.panel)];
                const double left = std::max(double(q.left()), lowest), right = double(q.right());
                for (const double v : {x - widest, x + widest}) {
                    const WaveAt there{v, G_, full};
                    const double z = there.square(upper ? 1. : -1.).real();
                    CHECK(z >= left * (1 - 1e-12));
                    CHECK(z <= right * (1 + 1e-12));
                    at_end = at_end || std::fabs(z - left) < 1e-6 || std::fabs(z - right) < 1e-6;
                    const double y = std::sqrt(z), inner = double(e.inner), y0 = double(q.y0), y1 = double(q.y1);
                    const auto beyond = [&](double a, double b) { return upper ? there.share(std::max(a, inner), std::min(b, y)) : there.share(std::max(a, y), std::min(b, inner)); };
                    const double share = beyond(0, y0) + beyond(y1, 1e9);
                    CHECK(share <= e.overlap);
                    overlap_used[upper] = std::max(overlap_used[upper], share / e.overlap);
                }
            }
            CHECK(at_end);
            by_end += !(std::fabs(x - 1) < widest + 1e-9);
        }
    }
    CHECK(seen[0] > 100);
    CHECK(seen[1] > 100);
    CHECK(by_end > 50);
    CHECK(at_left[0] > 10);
    CHECK(at_left[1] > 10);
    CHECK(first_panel > 5);
    CHECK(overlap_used[0] > 0.3);
    CHECK(overlap_used[1] > 0.3);
    MESSAGE(seen[0] << " " << seen[1] << " " << by_end << " " << at_left[0] << " " << at_left[1] << " " << first_panel << " " << overlap_used[0] << " " << overlap_used[1]);
}
