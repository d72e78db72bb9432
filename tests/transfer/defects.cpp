// SPDX-License-Identifier: MIT
/// D_m >= |T V_(m-1) - V_m| at random ratios, for V_m that jump at every edge of the mesh: whether the intervals of the proof leave none
/// out, and whether what it takes from finitely many points holds between them; and all that it is made of by itself, on meshes and with
/// levels made by hand. The values of T V are those of layer.hpp, which has a test of its own.
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
                const double difference = std::fabs(double(there.value[m - 1] - V->value(i, m, (x * x - p.centre) / p.half)))
                    - there.error[m - 1];
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
        const double G_ = 1.1 + 4 * unit(random), lowest = std::array{0.3, 1e-4, 1e-2}[static_cast<std::size_t>(round % 3)];
        const Made made(1e-5, Real(G_), drawn_panels(random, lowest, 40, 1.05, round % 2 ? 1.6 : 6), 1);
        const Layer& V = made.V;
        Continuation across;
        CHECK(continue_wave(V, Interval(Real(1 - 3e-6), Real(1 + 1e-6)), 1e-9, across) == Fit::no);
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
                const double most = largest(full ? x - 1 : 1 - x,
                    [&](double r) { return continue_wave(V, about(1e-12), r, f) == Fit::yes; }), r = of_most * most;
                REQUIRE(continue_wave(V, about(1e-12), r, f) == Fit::yes);
                const WaveAt here{x, G_, full};
                double may = full ? (x - 1) / bounds::margin : std::min(0.24 * (1 - x), 0.5 * x);
                for (const bool upper : {false, true}) {
                    const Continuation::End& e = f.ends[upper];
                    if (e.panel < 0) continue;
                    const Panel& q = V.panels[static_cast<std::size_t>(e.panel)];
                    const double inner = double(e.inner), left = std::sqrt(std::max(double(q.left()), lowest)),
                        right = std::sqrt(double(q.right()));
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
                            const Complex w = t * gap(there, inner),
                                local = (there.square(upper ? 1. - w : w - 1.) - double(q.centre)) / double(q.half);
                            CHECK((std::abs(local - 1.) + std::abs(local + 1.)) / 2 - 1 <= e.distance * (1 + 1e-9));
                        }
                    }
                    CHECK(e.factor == doctest::Approx(end_share(1.8 * e.gap)).scale(0).epsilon(1e-12));
                    const double z_moves = full ? square_moves(upper ? (x + 1) / G_ : inner, r / G_)
                        : force_moves(x, r, 2.36 * r) / (G_ * G_);
                    CHECK(e.distance == doctest::Approx(z_moves / double(q.half)).scale(0).epsilon(1e-9));
                    CHECK(e.overlap == doctest::Approx(largest_share(G_, std::max(0., double(q.y0) - left))
                        + largest_share(G_, std::max(0., right - double(q.y1)))).scale(1e-6).epsilon(2e-3));
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
                    const auto beyond = [&](double a, double b) { return upper ? there.share(std::max(a, inner), std::min(b, y))
                        : there.share(std::max(a, y), std::min(b, inner)); };
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
}

namespace {

/// The part of a level that a panel is, and those that are holes.
struct Found {
    std::vector<Part> panels, holes;
    Found(const Defects& D, const Layer& V, int m)
    {
        for (const Part& p : D.parts(m, bounds::infinite)) {
            const bool panel = std::any_of(V.panels.begin(), V.panels.end(), [&](const Panel& q) { return q.y0 == p.y0 && q.y1 == p.y1; });
            (panel ? panels : holes).push_back(p);
        }
        std::sort(panels.begin(), panels.end(), [](const Part& a, const Part& b) { return a.y0 < b.y0; });
    }
};

std::vector<Panel> panels_at(std::initializer_list<double> edges)
{
    std::vector<Panel> panels;
    const double* from = nullptr;
    for (const double& z : edges) {
        if (from) panels.push_back(panel(Real(*from), Real(z), panels.empty()));
        from = &z;
    }
    return panels;
}

doctest::Approx nearly(double v, double off = 1e-6) { return doctest::Approx(v).scale(0).epsilon(off); }

/// From 1 at the middle of a run of waves that all stay on the mesh.
constexpr double G_made = 2.5;
Made made_for(double tolerance_) { return {tolerance_, Real(G_made), panels_at({0.01, 0.03, 0.1, 0.25, 0.5, 1.21, 2, 3, 5, 9}), 2}; }

} // namespace

TEST_CASE("between the points of a check a function is no larger than the check says")
{
    for (const auto& [count, rho] : {std::pair{10, 64.0}, {19, 4.0}, {40, 10.0}}) {
        const Check check(count, rho);
        CHECK(check.spread == nearly((rho * rho + 1) / (2 * rho), 2e-3));
        CHECK(check.spread > (rho * rho + 1) / (2 * rho));
        double lebesgue = 0;
        for (int k = 0; k <= 1000; ++k) {
            const double x = -1 + k * 0.002;
            double sum = 0;
            for (int i = 0; i < count; ++i) {
                double product = 1;
                for (int j = 0; j < count; ++j)
                    if (j != i) product *= (x - double(check.points.at[static_cast<std::size_t>(j)]))
                        / double(check.points.at[static_cast<std::size_t>(i)] - check.points.at[static_cast<std::size_t>(j)]);
                sum += std::fabs(product);
            }
            lebesgue = std::max(lebesgue, sum);
        }
        CHECK(check.lebesgue > 1.01 * lebesgue); // the points are moved
        CHECK(check.lebesgue < 1.05 * lebesgue);
        CHECK(check.tail >= 2 * (1 + check.lebesgue) * std::pow(rho, 1 - count) / (rho - 1));
        CHECK(check.tail == nearly(2 * (1 + check.lebesgue) * std::pow(rho, 1 - count) / (rho - 1), 2e-3));
    }
    for (const double d : {1e-6, 0.3, 7.0}) CHECK(ellipse_of_distance(d) + 1 / ellipse_of_distance(d) == nearly(2 + 2 * d, 1e-12));
    double bound = 1;
    raise(bound, 2), raise(bound, 0);
    CHECK(bound == 2);
    raise(bound, std::nan(""));
    CHECK(bound == bounds::infinite);
}

TEST_CASE("what parts add up to is the least that a level of defects between them gives")
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto weight = [](const Part& p) { return p.width; };
    int by_all = 0, by_some = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<Part> parts;
        for (int k = 0; k < 5; ++k) parts.push_back({std::pow(10, -3 * unit(random)), unit(random) * (round % 2 ? 1 : 0.3), Real(0),
            Real(1), unit(random) < 0.3});
        std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.defect > b.defect; });
        double best = bounds::infinite, rest = 0;
        for (const Part& p : parts)
            if (p.on_average) rest += p.defect * weight(p);
        std::vector<double> levels{0};
        for (const Part& p : parts) levels.push_back(p.defect);
        for (const double d : levels) {
            double sum = d + rest;
            for (const Part& p : parts)
                if (!p.on_average && p.defect > d) sum += p.defect * weight(p);
            best = std::min(best, sum);
        }
        double all = rest;
        for (const Part& p : parts)
            if (!p.on_average) all += p.defect * weight(p);
        (best == nearly(all, 1e-12) ? by_all : by_some)++;
        CHECK(least_sum(parts, weight) == nearly(best, 1e-12));
    }
    CHECK(by_all > 10);
    CHECK(by_some > 10);
}

TEST_CASE("a disc ends before x = 1, and a polynomial's interval not within roundings of an image")
{
    const Made made(1e-5, Real(2), panels_at({1e-4, 1e-2, 4, 40}), 1);
    Continuation f;
    const Interval J(Real(1.4 - 1e-9), Real(1.4 + 1e-9));
    CHECK(continue_wave(made.V, J, 0.4 / 1.0005, f) == Fit::no);
    CHECK(continue_wave(made.V, J, 0.4 / 1.0015, f) == Fit::yes);
    const Made partial(1e-5, Real(2), panels_at({0.01, 0.06, 0.3, 2}), 1);
    const Real left = Real(0.01), right = partial.V.panels[0].right();
    for (const auto& [roundings, fit] : {std::pair{4.0, Fit::no}, {20.0, Fit::yes}}) { // z = x where G = 2
        CHECK(continue_wave(partial.V, Interval(left * Real{1, roundings * bounds::u}, Real(0.04)), 1e-9, f) == fit);
        CHECK(continue_wave(partial.V, Interval(Real(0.03), right * Real{1, -roundings * bounds::u}), 1e-9, f) == fit);
    }
}

TEST_CASE("an interval of ratios is covered by the one that is looked at, however narrow it is")
{
    for (const double relative : {0.5, 1e-9, 2 * narrowest})
        for (const double from : {0.3, 1.0, 7.0}) {
            const Real start = from;
            const Interval J(start, start + Real(from * relative));
            const Real needed = (J.high - J.low) * 0.5;
            CHECK(J.half - needed >= Real(1.9 * bounds::u * from));
            CHECK(J.half - needed <= needed * 3e-6);
            CHECK(J.x - J.low <= J.half);
            CHECK(J.high - J.x <= J.half);
            CHECK(J.h >= double(J.half));
            CHECK(J.h == nearly(double(J.half), 2e-3));
        }
}

TEST_CASE("a check's bound of a function that is near an analytic one")
{
    const Check check(10, 64);
    CHECK(check.anywhere(1, 0, 0) == nearly(check.lebesgue, 2e-3));
    CHECK(check.anywhere(0, 1, 0) == nearly(check.lebesgue + 1, 2e-3));
    CHECK(check.anywhere(0, 0, 1) == nearly(1, 2e-3));
    CHECK(check.anywhere(1, 1, 1) == nearly(2 * check.lebesgue + 2, 2e-3));
    CHECK(check.anywhere(0, 0, 1) > 1);
}

namespace {

/// A made level at a complex z.
Complex value_of(const Layer& V, std::size_t i, int m, Complex z)
{
    const Complex local = (z - double(V.panels[i].centre)) / double(V.panels[i].half);
    Complex before = 1, now = local, sum = 0;
    for (int k = 0; k < V.orders.terms; ++k) {
        sum += V.coefficients.high[V.row(i, k) + static_cast<std::size_t>(m)] * before;
        const Complex next = 2. * local * now - before;
        before = now;
        now = next;
    }
    return sum;
}

} // namespace

TEST_CASE("T V on a disc, V continued at the ends of the wave, and V_1 there, are no larger than they are taken to be")
{
    Made made = made_for(1e-5);
    const Layer& V = made.V;
    made.set(0, [](std::size_t i, int k) { return k == 0 ? Real(1) : k == 2 ? Real(0.2 * static_cast<double>(i)) : Real(0); });
    made.set(1, [](std::size_t, int k) { return k == 3 ? 10 : 0; });
    int seen[2] = {};
    for (const double x : {0.35, 0.5, 0.8, 1.3, 1.4, 1.7, 2.2})
        for (const double of_largest : {1., 0.2}) {
            const Interval J(Real(x - 1e-9), Real(x + 1e-9));
            Continuation f;
            const double r = of_largest * largest(x, [&](double t) { return continue_wave(V, J, t, f) == Fit::yes; });
            if (continue_wave(V, J, r, f) != Fit::yes) continue;
            CAPTURE(x);
            double known = f.middle * V.largest[0];
            for (const Continuation::End& e : f.ends)
                if (e.panel >= 0) {
                    const double rho = ellipse_of_distance(e.distance);
                    known += e.factor * (1 + 0.2 * e.panel * rho * rho);
                }
            CHECK(f.bound(V, 0) >= known);
            CHECK(f.bound(V, 0) == nearly(known, 5e-3));
            const auto i = static_cast<std::size_t>(V.find(Real(x) * Real(x)));
            const Panel& p = V.panels[i];
            const auto own = [&](const Interval& on) { return size_on_disc(V, i, 1, on, r, f) - f.bound(V, 0); };
            double most = 0;
            for (const Complex& v : circle(x, r)) most = std::max(most, std::abs(value_of(V, i, 1, v * v)));
            CHECK(most <= own(J));
            // at the end of the panel's interval it is all but attained: T_3 has half of rho^3
            const double end = std::sqrt(double(p.centre + p.half)), at_end = std::abs(value_of(V, i, 1, (end + r) * (end + r)));
            CHECK(at_end <= own({Real(end - 1e-9), Real(end + 1e-9)}));
            CHECK(at_end > 0.45 * own({Real(end - 1e-9), Real(end + 1e-9)}));
            ++seen[x > 1];
        }
    CHECK(seen[0] > 3);
    CHECK(seen[1] > 3);
    Continuation first; // of the first panel, where V_0 is 1
    first.ends[1].panel = 0;
    first.ends[1].factor = 2;
    CHECK(first.bound(V, 0) == nearly(2, 5e-3));
    Result there;
    V.apply(Real(1.7), there);
    const double rest = there.error[0] + 2 * V.rounding[V.at(5, 1)];
    CHECK(there.error[0] > 0);
    CHECK(off(V, there, 5, 1, there.value[0]) == nearly(rest, 2e-3));
    CHECK(off(V, there, 5, 1, there.value[0]) > rest);
    CHECK(off(V, there, 5, 1, there.value[0] - Real(0.5)) == nearly(0.5 + rest, 3e-3));
    there.error[0] = 0;
    CHECK(off(V, there, 5, 1, there.value[0]) == nearly(2 * V.rounding[V.at(5, 1)], 2e-3));
}

TEST_CASE("what a polynomial changes by is no more than its derivative, nor than twice its size")
{
    Made made = made_for(1e-5);
    made.set(1, [](std::size_t i, int k) { return k == static_cast<int>(i) + 1 || k == 0 ? 2 : 0; });
    for (std::size_t i = 0; i < 6; ++i) {
        const double k = static_cast<double>(i) + 1, half = double(made.V.panels[i].half);
        CHECK(change_of(made.V, i, 1, 1e-6 * half) == nearly(2 * k * k * 1e-6, 3e-3));
        CHECK(change_of(made.V, i, 1, 1e-6 * half) > 2 * k * k * 1e-6); // attained at an end of the interval
        CHECK(change_of(made.V, i, 1, 10 * half) == nearly(8, 3e-3));
        CHECK(change_of(made.V, i, 1, 10 * half) > 8);
    }
}

TEST_CASE("at x = 1, where nothing is analytic, a level that increases is between its ends, and what is known of the one before is added")
{
    constexpr double tolerance_ = 1e-5;
    for (const double size : {1., 1e-3, 0.}) {
        Made made = made_for(tolerance_);
        const Layer& V = made.V;
        made.set(0, [=](std::size_t, int k) { return k == 0 ? 0.1 * size : 0; });
        made.set(1, [=](std::size_t, int k) { return k == 0 ? Real(size) : k == 1 ? Real(-4 * size) : k == 2 ? Real(size) : Real(0); });
        Defects D(made.rules, V, 2, tolerance_, true);
        D.prove_steps();
        const Found found(D, V, 1);
        D.add_up();
        const Found all(D, V, 1);
        const double before = std::sqrt(0.1) * std::sqrt(G_made * 0.1 / 2); // B_0 below the first panel: no more is known of it
        constexpr std::size_t at_one = 4; // 0.5 ... 1.21
        const double width = double(V.panels[at_one].y1 - V.panels[at_one].y0), narrow = std::pow(tolerance_ / 64, 2. / 3) * width;
        int seen = 0, by_values = 0, elsewhere = 0;
        for (std::size_t i = 0; i < found.holes.size(); ++i) {
            const Part& p = found.holes[i];
            const bool next_to_one = std::fabs(double(p.y1 - 1)) < 1e-20 || std::fabs(double(p.y0 - 1)) < 1e-20;
            const auto again = std::find_if(all.holes.begin(), all.holes.end(),
                [&](const Part& q) { return q.y0 == p.y0 && q.y1 == p.y1; });
            REQUIRE(again != all.holes.end());
            CHECK_FALSE(p.on_average);
            CHECK(p.width >= double(p.y1 - p.y0));
            CHECK(p.width == nearly(double(p.y1 - p.y0), 2e-3));
            Continuation f;
            const Interval J(p.y0, p.y1);
            if (next_to_one || continue_wave(V, J, 2.1 * J.h, f) != Fit::yes) CHECK(again->defect - p.defect == nearly(before, 3e-3));
            else if (continue_wave(V, J, 2.15 * J.h, f) == Fit::yes) {
                CHECK(again->defect == p.defect);
                ++by_values;
            }
            const auto own = static_cast<std::size_t>(V.find(J.x * J.x));
            const Panel& q = V.panels[own];
            const Real beside = (q.y1 - q.y0) * 2e-3;
            if (!next_to_one && (continue_wave(V, J, 2.1 * J.h, f) == Fit::yes || p.y0 < q.y0 + beside || q.y1 - beside < p.y1)) continue;
            const double h = double(p.y1 - p.y0) / 2;
            if (next_to_one) {
                ++seen;
                CHECK(h <= 1.01 * std::min(narrow, 1e-6 * width));
                CHECK(h > 0.2 * std::min(narrow, 1e-6 * width));
            }
            else ++elsewhere;
            Result low, high;
            V.apply(p.y0, low);
            V.apply(p.y1, high);
            const auto value = [&](const Real& x) { return V.value(own, 1, (x * x - q.centre) / q.half); };
            const double known = std::fabs(double(low.value[0] - value(p.y0))) + std::fabs(double(high.value[0] - value(p.y0)))
                + change_of(V, own, 1, double(p.y1 * p.y1 - p.y0 * p.y0)) + low.error[0] + high.error[0];
            CHECK(p.defect == nearly(known, 5e-3));
            CHECK(p.defect >= known);
        }
        CHECK(seen == (size > 0 ? 2 : 0));
        CHECK(elsewhere >= (size > 0 ? 3 : 0));
        CHECK(by_values >= (size > 0 ? 3 : 0));
        for (std::size_t i = 1; i < V.panels.size(); ++i) {
            CAPTURE(size);
            CAPTURE(i);
            if (size == 0 && (i == at_one || i == at_one + 1)) CHECK(all.panels[i].defect - found.panels[i].defect == nearly(before, 3e-3));
            else CHECK(all.panels[i].defect == found.panels[i].defect); // to the right of these the lower end of the wave is on a panel
        }
    }
}

TEST_CASE("where V is a neighbour's polynomial that is far off, this counts with its share")
{
    constexpr double tolerance_ = 1e-5;
    Made made = made_for(tolerance_);
    const Layer& V = made.V;
    made.set(0, [](std::size_t i, int k) { return k == 0 ? i % 2 ? 1 : -1 : 0; });
    made.set(1, [](std::size_t, int k) { return k == 0 ? 1 : 0; });
    Defects D(made.rules, V, 2, tolerance_, true);
    D.prove_steps();
    const std::vector<double> apart = overlap_defects(made.rules, V, 2);
    const Check check(made.rules.orders.terms + 7, 4);
    int seen = 0;
    for (const Part& p : Found(D, V, 1).holes) {
        const Interval J(p.y0, p.y1);
        Continuation f;
        // else it was another check
        if (continue_wave(V, J, 5 * J.h, f) == Fit::yes || continue_wave(V, J, J.h * check.spread * (1 + 1e-9), f) != Fit::yes) continue;
        double most = 0, share = 0;
        for (std::size_t n = 0; n < check.points.at.size(); ++n) {
            Result there;
            V.apply(J.x + J.half * check.points.at[n], there);
            most = std::max(most, std::fabs(double(there.value[0] - 1)) + there.error[0]);
        }
        for (const Continuation::End& e : f.ends)
            if (e.panel >= 0) share += e.overlap * apart[V.at(static_cast<std::size_t>(e.panel), 0)];
        seen += share > 0.1;
        CHECK(p.defect >= check.anywhere(most, share, 0) * (1 - 1e-9));
        CHECK(p.defect == nearly(check.anywhere(most, share, 0), 5e-3));
    }
    CHECK(seen > 3);
}

TEST_CASE("at x = 1 a level that need not increase is off by what the two laws of ratios differ by, too")
{
    constexpr double tolerance_ = 1e-5;
    for (const double size : {1., 0.}) { // of V_0; V_1 is 0 at 1, and steep
        Made made = made_for(tolerance_);
        const Layer& V = made.V;
        constexpr std::size_t at_one = 4; // 0.5 ... 1.21
        made.set(0, [=](std::size_t, int k) { return k == 0 ? size : 0; });
        const Real local = (Real(1) - V.panels[at_one].centre) / V.panels[at_one].half;
        Result at_one_exactly;
        V.apply(Real(1), at_one_exactly);
        const Real there_too = at_one_exactly.value[0];
        made.set(1, [=](std::size_t, int k) { return k == 0 ? there_too - 3 * local : k == 1 ? Real(3) : Real(0); });
        Defects D(made.rules, V, 2, tolerance_, false);
        D.prove_steps();
        int seen = 0;
        for (const Part& p : Found(D, V, 1).holes) {
            if (!(std::fabs(double(p.y1 - 1)) < 1e-28 || std::fabs(double(p.y0 - 1)) < 1e-28)) continue;
            ++seen;
            CHECK((p.y1 < Real(1.5) && p.y0 < Real(1) ? p.y1 >= Real(1) + Real(1.5 * bounds::u) || p.y0 <= Real(1) - Real(1.5 * bounds::u)
                : false));
            const double h = double(p.y1 - p.y0) / 2;
            CHECK(h >= 0.9 * narrowest);
            CHECK(h <= 2.1 * narrowest);
            const Real x = (p.y0 + p.y1) * 0.5;
            Result there;
            V.apply(x, there);
            const Real v = V.value(at_one, 1, (x * x - V.panels[at_one].centre) / V.panels[at_one].half);
            const double known = std::fabs(double(there.value[0] - v)) + there.error[0] + std::sqrt(32 * h) * size
                + 3 * double(p.y1 * p.y1 - p.y0 * p.y0) / double(V.panels[at_one].half);
            CAPTURE(size);
            CHECK(p.defect == nearly(known, 5e-3));
            CHECK(p.defect >= known);
        }
        CHECK(seen == 2);
    }
}

namespace {

/// A first level with a point where it is not analytic, or not said to be.
struct Known : First {
    double step = 0, error = 0, singular = 1e9;
    Bounds bounds_{1, bounds::infinite};
    bool share = true;
    std::function<Real(const Real&)> analytic = [](const Real&) { return Real(0.5); };
    bool is_share() const override { return share; }
    std::pair<Real, double> value(const Real& x) const override { return {x < Real(singular) ? analytic(x) : analytic(x) + step, error}; }
    Bounds on_disc(const Real& low, const Real& high, const Real& x, double r) const override
    {
        const Real off = x - Real(singular);
        const bool apart = (Real(singular) < low || high < Real(singular)) && std::fabs(off.high) > r;
        return apart ? bounds_ : Bounds{bounds::infinite, bounds::infinite};
    }
    double weight_on(double x, double width, double largest) const override { return 3 + 5 * x + 7 * largest + (width < 1e-20 ? 0 : 1000); }
};

} // namespace

TEST_CASE("a first level: what its points, its bounds on a disc and its errors make of a panel")
{
    constexpr double tolerance_ = 1e-5;
    Made made = made_for(tolerance_);
    const Layer& V = made.V;
    made.set(0, [](std::size_t, int k) { return k == 0 ? 0.4 : k == 1 ? 0.03 : k == 2 ? 0.01 : 0; });
    const auto proven = [&](const Known& first, bool monotone) {
        Defects D(made.rules, V, 1, tolerance_, monotone);
        D.prove_level_zero(first);
        return Found(D, V, 0);
    };
    for (const bool monotone : {true, false})
        for (const auto& [error, value, complement] : {std::array{1e-3, 1., bounds::infinite}, {1e-3, 1e3, 1e9}, {0., 1e3, 1.},
            {0., 1e9, 1e3}}) {
            Known first;
            first.error = error;
            first.bounds_ = {value, complement};
            first.share = monotone;
            const Found found = proven(first, monotone);
            const Check check(made.rules.orders.terms + (monotone ? 7 : 19), 4);
            for (std::size_t i = 0; i < V.panels.size(); ++i) {
                if (V.panels[i].y0 < Real(1) && Real(1) < V.panels[i].y1) continue;
                const Panel& p = V.panels[i];
                const double slack = double(p.y1 - p.y0) * 1e-3, low = i == 0 ? double(p.y0) : double(p.y0) - slack, high = double(p.y1)
                    + slack, x = (low + high) / 2, r = (high - low) / 2 * check.spread;
                const double d = (2 * x * r + r * r) / double(p.half), rho = 1 + d + std::sqrt(d * (2 + d));
                double most = 0;
                for (std::size_t n = 0; n < check.points.at.size(); ++n) {
                    const Real at = Real(x) + Real((high - low) / 2) * check.points.at[n];
                    most = std::max(most, std::fabs(0.5 - double(V.value(i, 0, (at * at - p.centre) / p.half))));
                }
                const double grown = 0.03 * rho + 0.01 * rho * rho,
                    between = std::min(value + 0.4 + grown, complement + 0.6 + grown) * check.tail;
                CAPTURE(monotone);
                CAPTURE(i);
                CAPTURE(value);
                if (between > 0.9 * tolerance_ / 16) continue; // halved
                CHECK(found.panels[i].defect == nearly(check.lebesgue * (most + error) + between, 5e-3));
                CHECK(found.panels[i].defect >= check.lebesgue * (most + error) + between);
            }
        }
}

TEST_CASE("a first level that V is: what is left are the bound on a disc and roundings")
{
    constexpr double tolerance_ = 1e-5;
    Made made = made_for(tolerance_);
    const Layer& V = made.V;
    made.set(0, [&](std::size_t i, int k) { return k == 0 ? Real(0.4) + V.panels[i].centre * 0.05 : k == 1 ? V.panels[i].half * 0.05
        : Real(0); });
    Known first;
    first.analytic = [](const Real& x) { return Real(0.4) + x * x * 0.05; };
    const Check check(made.rules.orders.terms + 7, 4);
    for (const auto& [value, complement] : {std::pair{100., bounds::infinite}, {1., 100.}, {100., 1.}, {0.1, 0.2}}) {
        first.bounds_ = {value, complement};
        Defects D(made.rules, V, 1, tolerance_, true);
        D.prove_level_zero(first);
        const Found found(D, V, 0);
        for (const std::size_t i : {1u, 2u, 3u, 6u, 7u, 8u}) {
            const Panel& p = V.panels[i];
            const double slack = double(p.y1 - p.y0) * 1e-3, low = double(p.y0) - slack, high = double(p.y1) + slack, x = (low + high) / 2,
                r = (high - low) / 2 * check.spread;
            const double rho = ellipse_of_distance((2 * x * r + r * r) / double(p.half)), mean = 0.4 + 0.05 * double(p.centre),
                grown = 0.05 * double(p.half) * rho;
            const double between = std::min(value + mean + grown, complement + std::fabs(mean - 1) + grown) * check.tail;
            CAPTURE(i);
            CAPTURE(value);
            REQUIRE(between < 0.9 * tolerance_ / 16);
            CHECK(found.panels[i].defect >= between);
            CHECK(found.panels[i].defect == nearly(between, 5e-3));
        }
    }
    made.set(0, [](std::size_t, int k) { return k == 0 ? 1 : 0; });
    first.analytic = [](const Real&) { return Real(1); };
    first.bounds_ = {100, 0};
    Defects D(made.rules, V, 1, tolerance_, true);
    D.prove_level_zero(first);
    for (const Part& p : Found(D, V, 0).panels) CHECK(p.defect
        == nearly(check.lebesgue * 2 * V.rounding[V.at(static_cast<std::size_t>(V.find(p.y0 * p.y0 * Real{1, 1e-20})), 0)], 1e-2));
}

TEST_CASE("a first level that is not analytic at a point is there between its ends, or counts on an average")
{
    constexpr double tolerance_ = 1e-5;
    Made made = made_for(tolerance_);
    const Layer& V = made.V;
    made.set(0, [](std::size_t, int k) { return k == 0 ? 0.4 : k == 1 ? 0.25 : 0; });
    constexpr std::size_t i = 7; // 3 ... 5
    const Panel& p = V.panels[i];
    Known first;
    first.singular = 2.01;
    first.step = 0.125;
    first.error = 0.0078125;
    for (const bool monotone : {true, false}) {
        Defects D(made.rules, V, 1, tolerance_, monotone);
        D.prove_level_zero(first);
        int seen = 0;
        for (const Part& h : Found(D, V, 0).holes) {
            const double low = double(h.y0), high = double(h.y1);
            const Real singular(first.singular);
            if (!(h.y0 <= singular && singular <= h.y1)) continue;
            CHECK(h.on_average == !monotone);
            ++seen;
            CAPTURE(monotone);
            if (monotone) {
                const double width = double(p.y1 - p.y0) * 1.002;
                CHECK((high - low) / 2 <= std::pow(tolerance_ / 64, 2. / 3) * width * 1.01);
                const double v = double(V.value(i, 0, (h.y0 * h.y0 - p.centre) / p.half));
                const double known = std::fabs(0.5 - v) + std::fabs(0.625 - v) + 2 * 0.0078125
                    + 0.25 * (high * high - low * low) / double(p.half);
                CHECK(h.defect == nearly(known, 3e-3));
                CHECK(h.defect >= known);
            }
            else {
                CHECK(double(h.y1 - h.y0) < 8 * narrowest * high);
                CHECK(double(h.y1 - h.y0) > narrowest * high);
                CHECK(h.defect == nearly(3 + 5 * low + 7 * 0.65, 2e-2));
            }
        }
        CHECK(seen > 0);
        CHECK(seen < 3);
    }
    // beyond a panel's end by half a thousandth of its width it is proven with that panel, too
    const double width = double(p.y1 - p.y0), next = double(V.panels[i + 1].y1 - p.y1);
    for (const double singular : {double(p.y1) + 0.0005 * width, double(p.y1) - 0.0005 * next}) {
        first.singular = singular;
        Defects D(made.rules, V, 1, tolerance_, true);
        D.prove_level_zero(first);
        const Found found(D, V, 0);
        CHECK(std::count_if(found.holes.begin(), found.holes.end(),
            [&](const Part& h) { return h.y0 <= Real(singular) && Real(singular) <= h.y1; }) >= 2);
    }
    // at 1, where intervals end, it is on either side of them; V is steep there
    const Real local_one = (Real(1) - V.panels[4].centre) / V.panels[4].half;
    made.set(0, [&](std::size_t, int k) { return k == 0 ? 0.55 - 1e3 * local_one : k == 1 ? Real(1e3) : Real(0); });
    first.singular = 1;
    Defects at_one(made.rules, V, 1, tolerance_, true);
    at_one.prove_level_zero(first);
    int seen = 0;
    for (const Part& h : Found(at_one, V, 0).holes) {
        if (!(h.y0 <= Real(1) && Real(1) <= h.y1)) continue;
        ++seen;
        const Panel& q = V.panels[4];
        const double v = double(V.value(4, 0, (h.y0 * h.y0 - q.centre) / q.half));
        const double known = std::fabs(0.5 - v) + std::fabs(0.625 - v) + 2 * 0.0078125
            + 1e3 * double(h.y1 * h.y1 - h.y0 * h.y0) / double(q.half);
        CHECK(h.defect == nearly(known, 3e-3));
        CHECK(h.defect >= known);
    }
    CHECK(seen == 2);
    Known nowhere; // analytic
    nowhere.bounds_ = {bounds::infinite, bounds::infinite};
    Defects D(made.rules, V, 1, tolerance_, true);
    D.prove_level_zero(nowhere);
    for (const Part& q : Found(D, V, 0).panels) CHECK((q.defect == bounds::infinite || q.defect == 0));
}

TEST_CASE("neighbours' polynomials differ by no more than is taken, on the part of their intervals that is the other's panel")
{
    Made made = made_for(1e-5);
    const Layer& V = made.V;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const int m : {0, 1}) made.set(m, [&](std::size_t i, int k) { return k == 0 || k > 3 ? 0
        : std::pow(0.3, static_cast<double>(i)) * unit(random); });
    const std::vector<double> bound = overlap_defects(made.rules, V, 3);
    REQUIRE(bound.size() == V.panels.size() * static_cast<std::size_t>(V.count));
    double closest = 1e9;
    for (const std::size_t m : {0u, 1u})
        for (std::size_t e = 0; e < V.panels.size(); ++e) {
            double most = 0;
            for (std::size_t n = 0; n < V.panels.size(); ++n) {
                if (n == e) continue;
                const double low = std::max(double(V.panels[e].left()), double(V.panels[n].z0)),
                    high = std::min(double(V.panels[e].right()), double(V.panels[n].z1));
                for (int k = 0; k <= 40 && low < high; ++k) {
                    const double z = low + (high - low) * k / 40;
                    most = std::max(most, std::abs(value_of(V, e, static_cast<int>(m), z) - value_of(V, n, static_cast<int>(m), z)));
                }
            }
            CAPTURE(m);
            CAPTURE(e);
            CHECK(bound[V.at(e, static_cast<int>(m))] >= 2 * most); // Lebesgue's constant of 12 points is 2.6
            CHECK(bound[V.at(e, static_cast<int>(m))] <= 2.8 * most);
            if (e == 0) CHECK(most == 0); // its interval ends with it
            else closest = std::min(closest, most);
        }
    CHECK(closest > 0);
    // panels that lie within another's overlap, and polynomials that only roundings tell apart
    Made narrow(1e-5, Real(G_made), panels_at({0.5, 1, 1.01, 1.02, 2, 4}), 2);
    narrow.set(0, [](std::size_t i, int k) { return k == 0 ? (i == 3 ? 2. : 1.) : 0; });
    const std::vector<double> seen = overlap_defects(narrow.rules, narrow.V, 2);
    const double lebesgue = 1.01 * (1 + 2 / pi_ * std::log(narrow.rules.orders.terms));
    for (std::size_t e = 0; e < 5; ++e) {
        const bool sees = e > 1; // that of panel 1 ends before 1.02
        CAPTURE(e);
        if (sees) CHECK(seen[narrow.V.at(e, 0)] == nearly(lebesgue, 3e-3));
        else if (e == 0) CHECK(seen[narrow.V.at(e, 0)] == 0);
        else CHECK(seen[narrow.V.at(e, 0)] == nearly(lebesgue * (narrow.V.rounding[narrow.V.at(1, 0)]
            + narrow.V.rounding[narrow.V.at(0, 0)]), 1e-2));
    }
}

TEST_CASE("the last panel's neighbours are looked at as far as its interval reaches")
{
    Made made(1e-5, Real(G_made), panels_at({0.5, 1, 1.01, 1.02, 2}), 2);
    made.set(0, [](std::size_t i, int k) { return k == 0 ? (i == 1 ? 2. : 1.) : 0; });
    const std::vector<double> seen = overlap_defects(made.rules, made.V, 2);
    for (std::size_t e = 1; e < 4; ++e) CHECK(seen[made.V.at(e, 0)]
        == nearly(1.01 * (1 + 2 / pi_ * std::log(made.rules.orders.terms)), 3e-3));
}

TEST_CASE("the share of theta on an interval of y, at any ratio between two, is no more than is taken, and nearly that much")
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    int nothing = 0, near = 0;
    double slack[2] = {1e9, 1e9};
    for (int round = 0; round < 4000; ++round) {
        const bool full = round % 2;
        const double G = 1.1 + 3 * unit(random), low = full ? 1 + 3 * unit(random) * unit(random) : unit(random), high = round % 4 < 2
            ? low : full ? low + 0.1 * unit(random) : low + (1 - low) * unit(random);
        const double end = (full ? low + 1 : 2 * std::sqrt(low)) / G, begin = full ? (low - 1) / G : 0, at = round % 8 < 4 ? end
            + 0.1 * (unit(random) - 0.5) : begin + (end - begin) * unit(random);
        const double y0 = std::max(1e-3, at), y1 = y0 + std::pow(10, -4 * unit(random));
        const double bound = share_of(Real(G), Real(low), Real(high), Real(y0), Real(y1));
        double most = 0;
        for (int k = 0; k <= 8; ++k) most = std::max(most, WaveAt{low + (high - low) * k / 8, G, full}.share(y0, y1));
        CAPTURE(G);
        CAPTURE(low);
        CAPTURE(high);
        CAPTURE(y0);
        CAPTURE(y1);
        CHECK(most <= bound + 1e-12);
        CHECK(bound <= 1.003 * largest_share(G, y1 - y0) + 1e-12);
        if (bound == 0) ++nothing;
        // where the interval is far from the ends, and narrow, the kernel hardly changes on it
        const WaveAt wave{low, G, full};
        const double c0 = wave.cosine(y0).real(), c1 = wave.cosine(y1).real();
        if (high == low && c0 > -0.9 && c1 < 0.9 && y1 - y0 < 1e-3) {
            ++near;
            slack[full] = std::min(slack[full], most / bound);
            const double factor = G * (y1 - y0) / (pi_ * std::sqrt(std::min(1., 1 - c1) * std::min(1., 1 + c0)));
            CHECK(bound == nearly(std::min(factor, largest_share(G, y1 - y0)), 3e-3));
        }
    }
    CHECK(nothing > 100);
    CHECK(near > 100);
    CHECK(share_of(Real(2), Real(0.9), Real(1.1), Real(0.5), Real(0.6)) == bounds::infinite);
    CHECK(share_of(Real(2), Real(0.9), Real(1), Real(0.5), Real(0.6)) < 1);
    // beyond the ends of the wave
    CHECK(share_of(Real(2), Real(3), Real(3), Real(2), Real(2.5)) > 0);
    CHECK(share_of(Real(2), Real(3), Real(3), Real(2 + 1e-9), Real(2.5)) == 0);
    CHECK(share_of(Real(2), Real(3), Real(3), Real(0.5), Real(1)) > 0);
    CHECK(share_of(Real(2), Real(3), Real(3), Real(0.5), Real(1 - 1e-9)) == 0);
    CHECK(share_of(Real(2), Real(0.25), Real(0.25), Real(0.5 + 1e-9), Real(1)) == 0);
    CHECK(share_of(Real(2), Real(0.25), Real(0.25), Real(0.5 - 1e-9), Real(1)) > 0);
}

TEST_CASE("an interval that meets the end of a wave by a few roundings has a share")
{
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto exact = [](const Real& v) -> Rational { return Rational(v.high) + Rational(v.low); };
    int inside = 0;
    for (int round = 0; round < 2000; ++round) {
        const Real G = Real(1.1 + unit(random)) + Real(unit(random) * 0x1p-54), x = Real(100 + 300 * unit(random))
            + Real(unit(random) * 0x1p-46), shift = Real{1, (unit(random) - 0.5) * 8 * bounds::u};
        const Real at_end = (x + 1) / G * shift, at_begin = (x - 1) / G * shift;
        const Rational end = exact(x) + 1 - exact(G) * exact(at_end), begin = exact(G) * exact(at_begin) - exact(x) + 1;
        if (end > 0) CHECK(share_of(G, x, x, at_end, at_end + 1) > std::sqrt(2 * end.get_d()) / 4);
        if (begin > 0) CHECK(share_of(G, x, x, at_begin - 1, at_begin) > std::sqrt(2 * begin.get_d()) / 4);
        inside += (end > 0) + (begin > 0);
    }
    CHECK(inside > 1500);
}

TEST_CASE("the mass that is left after some waves: a power of the highest ratio, and never more than before")
{
    for (const double G : {1.2, 3.0})
        for (const double highest : {0.01, 0.5, 40.0}) {
            const std::vector<double> mass = mass_after_steps(G, highest, 3);
            REQUIRE(mass.size() == 4);
            CHECK(mass[0] == 1);
            const double powers[] = {std::sqrt(highest), std::pow(highest, 0.75) / std::sqrt(G),
                std::pow(highest, 0.875) / std::pow(G, 1.25)};
            double least = 1;
            for (std::size_t k = 0; k < 3; ++k) {
                CHECK(mass[k + 1] >= std::min(least, powers[k]));
                CHECK(mass[k + 1] == nearly(std::min(least, powers[k]), 2e-3));
                least = mass[k + 1];
            }
        }
}

TEST_CASE("what a level's defects add up to: its parts within reach, what is below the first panel, and what is known of the levels before")
{
    constexpr double tolerance_ = 1e-5, enlarged = G_made * bounds::margin;
    struct Case {
        bool monotone;
        double first, size, error; ///< the first panel's left end in y, the size of V, the error of B_0
        double top = 9;            ///< of the mesh, in y^2; below 1 waves lose mass, and nothing is proven
        bool steps = size > 1e-3 && top > 1;
    };
    for (const Case& c : {Case{true, 0.1, 0.5, 1e-6}, {false, 0.1, 0.5, 1e-6}, {true, 0.1, 0.4, 1e-3}, {true, 0.01, 1e-9, 0},
        {false, 0.1, 0.4, 1e-3}, {false, 0.01, 0.7, 0}, {false, 0.01, 0.7, 1e-3, 0.25}, {true, 0.01, 1e-9, 0, 0.25}}) {
        std::vector<Panel> panels;
        for (double z = c.first * c.first; z < c.top; z *= 2.5) panels.push_back(panel(Real(z), Real(2.5 * z), panels.empty()));
        Made made{tolerance_, Real(G_made), panels, 3};
        const Layer& V = made.V;
        for (const int m : {0, 1, 2}) made.set(m, [&](std::size_t i, int k) { return k == 0
            ? c.size * (1 + 0.01 * static_cast<double>(i) * m) + (c.size == 0.5 && m == 0 && i == 3 ? 0.3 : 0) : 0; });
        Defects D(made.rules, V, 3, tolerance_, c.monotone);
        Known first;
        first.error = c.error;
        if (c.error > 0) D.prove_level_zero(first);
        if (c.steps) D.prove_steps();
        D.add_up();
        CAPTURE(c.monotone);
        CAPTURE(c.first);
        const double y = c.first;
        std::vector<double> effects, sums; // at least T |B_m - V_m|
        const std::vector<double> mass = mass_after_steps(G_made, double(V.panels.back().y1), 3), low_mass = mass_after_steps(G_made, y, 3);
        for (int m = 0; m < 3; ++m) {
            CAPTURE(m);
            const double best = least_sum(D.parts(m, bounds::infinite), [](const Part& p) { return largest_share(enlarged, p.width); });
            double below = c.monotone ? std::sqrt(y) : 0;
            if (m > 0) {
                const auto before = static_cast<std::size_t>(m - 1);
                const Found found(D, V, m);
                below = c.monotone ? std::min(low_mass[static_cast<std::size_t>(m + 1)], V.size[V.at(0, m)] + found.panels[0].defect
                    + sums[before]) : std::sqrt(y) * V.largest[before] + sums[before];
            }
            const double known = best + below * largest_share(G_made, y);
            CHECK(D.effect(m, bounds::infinite) >= known);
            CHECK(known < bounds::infinite);
            if (known > 0) CHECK(D.effect(m, bounds::infinite) == nearly(known, 6e-3));
            else CHECK(D.effect(m, bounds::infinite) == 0);
            effects.push_back(known);
            double sum = 0;
            for (int k = 0; k <= m; ++k) sum += effects[static_cast<std::size_t>(k)] * mass[static_cast<std::size_t>(m - k)];
            sums.push_back(sum);
            const double twice = least_sum(D.parts(m, 1.2), [](const Part& p) { return largest_second_share(enlarged, p.width); });
            CHECK(D.second_effect(m, 1.2) >= twice);
            if (twice > 0) CHECK(D.second_effect(m, 1.2) == nearly(twice, 2e-3));
            else CHECK(D.second_effect(m, 1.2) == 0);
            for (const double reach : {0.2, 0.5, 0.60001, 1.1, 2.5}) {
                const std::vector<Part> parts = D.parts(m, reach), all = D.parts(m, bounds::infinite);
                CHECK(parts.size() == static_cast<std::size_t>(std::count_if(all.begin(), all.end(),
                    [&](const Part& p) { return double(p.y0) <= reach; })));
                for (std::size_t i = 0; i < parts.size(); ++i) {
                    CHECK(double(parts[i].y0) <= reach);
                    CHECK(parts[i].width >= double(parts[i].y1 - parts[i].y0));
                    CHECK(parts[i].width == nearly(double(parts[i].y1 - parts[i].y0), 2e-3));
                    if (i > 0) CHECK(parts[i].defect <= parts[i - 1].defect);
                }
            }
        }
        for (const auto& [low, high] : {std::pair{0.3, 0.3}, {0.5, 0.6}, {1.2, 1.2}, {2.0, 2.1}}) {
            const double there = least_sum(D.parts(0, bounds::infinite),
                [&](const Part& p) { return share_of(Real(G_made), Real(low), Real(high), p.y0, p.y1); });
            CHECK(D.effect_at(Real(low), Real(high)) >= there);
            CHECK((D.effect_at(Real(low), Real(high)) == there || D.effect_at(Real(low), Real(high)) == nearly(there, 2e-3)));
        }
    }
}

TEST_CASE("what a load's rounding changes: the slope of V where the ratios are, and its jumps where an edge moves")
{
    constexpr double u = bounds::u;
    Made made = made_for(1e-5);
    const Layer& V = made.V;
    // steeper from panel to panel, and jumps
    made.set(0, [](std::size_t i, int k) { return k == static_cast<int>(i) ? 0.1 : 0; });
    made.set(1, [](std::size_t i, int k) { return k == 0 ? i < 4 ? Real(0.5) : Real(1) : Real(0); }); // one jump at y^2 = 0.5
    const Defects D(made.rules, V, 2, 1e-5, false);
    for (const double x : {0.05, 0.3, 0.781251, 0.9, 1.2, 1.768, 3.0}) {
        // z G^2 = (x + c)^2 or (1 + c)(2x - 1 + c), x within 4 u x of itself; as much for the roundings of z itself
        const double dz = 40 * u * x * (1 + x) / (G_made * G_made);
        for (const int m : {0, 1}) {
            double known = 0;
            for (std::size_t i = 0; i < V.panels.size(); ++i) {
                const Panel& p = V.panels[i];
                const double share = share_of(Real(G_made), Real(x), Real(x), p.y0, p.y1);
                if (share == 0) continue;
                const double dy = dz / double(p.y0), n = static_cast<double>(i);
                if (m == 0) known += share * 0.1 * n * n * dz / double(p.half);
                const Real y0 = p.y0 - Real(dy), y1 = p.y0 + Real(dy);
                known += V.jump[V.at(i, m)] * share_of(Real(G_made), Real(x), Real(x), y0, y1);
            }
            CAPTURE(x);
            CAPTURE(m);
            CHECK(D.blur(m, Real(x)) >= 0.999 * known);
            CHECK(D.blur(m, Real(x)) <= 1.02 * known);
        }
    }
}
