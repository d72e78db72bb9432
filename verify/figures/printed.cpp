// SPDX-License-Identifier: GPL-3.0-or-later
/// What a code loses that trusts the print: the size of its misprints, and the rounding errors of its formulas beside the edge of the
/// contact.
#include "verify/figures/contact.hpp"

#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/oracle/error.hpp"
#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/gap.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/rounding/decimal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace touchstone::figures {
namespace {

constexpr slong bits = 192;

Ball relative_error(const Ball& printed, const Ball& truth) { return abs(printed / truth - Ball(1)); }

/// (7.17), and with it (7.18), as printed.
Ball K_as_printed(long n)
{
    Ball k = pow(Ball(2), Ball(n) + power_of_two<Ball>(-n)) / pow(pi<Ball>(), Ball(n + 2) / Ball(2));
    for (long i = 0; i < n; ++i) {
        const Ball small = power_of_two<Ball>(-(i + 2));
        k *= ScalarTraits<Ball>::gamma(Ball(Ball(1) - small)) / ScalarTraits<Ball>::gamma(Ball(ratio<3, 2, Ball>() - small));
    }
    return k;
}

/// The step (7.10) with the power of pi as printed, over that of (7.13).
Ball power_of_pi(long n) { return pow(pi<Ball>(), (archard::delta<Ball>(n) - Ball(3)) / Ball(2)) * pi<Ball>(); }

/// The integrand of (6.2) but for q_(n-1): inner square root as printed, or of the square.
Ball integrand_6_2(const Ball& before, const Ball& p, bool as_printed)
{
    const Ball m = Ball(1) - before;
    const Ball inner = sqrt((as_printed ? m : m * m) + p * p);
    return p / sqrt((m * m + p * p) * (2 * before * (m + inner) - p * p));
}

Panel constants()
{
    Panel p{"(a) constants of Archard's law",
            "(a)",
            {"scale {/:Italic n}", 0, last_scale, false, 5},
            {"relative error of the print", 1e-6, 1e4, true, 100},
            {},
            {},
            {},
            "top left"};
    Curve k{"(7.17) and (7.18)", "(7.17), (7.18): {/:Italic K_n}", Style::marked_line, 2, {}};
    Curve step{"(7.10)", "(7.10): one step", Style::marked_line, 1, {}};
    for (long n = 0; n <= last_scale; ++n) {
        if (n > 0)
            k.points.push_back(certified(static_cast<double>(n), relative_error(K_as_printed(n), archard::K_by_recursion<Ball>(n)), 6));
        step.points.push_back(certified(static_cast<double>(n), relative_error(power_of_pi(n), Ball(1)), 6));
    }
    p.curves = {std::move(k), std::move(step)};
    return p;
}

Panel widest_segment()
{
    Panel p{"(b) widest segment (9.4)",
            "(b)",
            {"{/:Italic G} = γ^{{/:Italic D}−1}", 2, 10, false, 2},
            {"relative error of the print", 0, 1, false, 0.25},
            {},
            {},
            {},
            ""};
    Curve c{"(9.4)", "", Style::line, 2, {}};
    for (int k = 0; k <= 160; ++k) {
        const Rational G = Rational(2) + Rational(k, 20);
        const Ball x_P = peaks::fixed_point(Ball(G));
        // at G = 2 exactly both arcsines are of 1
        if (k == 0) c.points.push_back({2, "0", "0", "exact"});
        else c.points.push_back(certified(G.get_d(), relative_error(asin(x_P), asin(sqrt(x_P))), 6));
    }
    p.curves.push_back(std::move(c));
    return p;
}

Panel recursion_kernel()
{
    Panel p{"(c) integrand of (6.2)",
            "(c)",
            {"{/:Italic p_{n−1}} / {/:Italic p*_n}", 0, 1, false, 0.2},
            {"relative error of the print", 1e-3, 1, true, 10},
            {},
            {},
            {},
            "bottom left"};
    int colour = 0;
    for (const auto& [numerator, text] : {std::pair{1L, "0.1"}, {5L, "0.5"}, {10L, "1"}}) {
        const Rational pressure(numerator, 10);
        Curve c{fmt::format("p = {}", text), fmt::format("{{/:Italic p_n}} = {} {{/:Italic p*_n}}", text), Style::line, ++colour, {}};
        const Rational low = pressure * pressure / 4;
        for (int k = 1; k < 100; ++k) {
            const Rational before = low + (1 - low) * k / 100;
            const Ball b(before), at(pressure);
            c.points.push_back(certified(before.get_d(), relative_error(integrand_6_2(b, at, true), integrand_6_2(b, at, false)), 6));
        }
        p.curves.push_back(std::move(c));
    }
    return p;
}

Panel limit_of_area()
{
    const Areas areas;
    Panel p{"(d) area by (7.21)",
            "(d)",
            {"scale {/:Italic n}", 0, last_scale, false, 5},
            {"relative error of the print", 1e-3, 1e4, true, 10},
            {},
            {},
            {},
            "top right"};
    for (std::size_t k = 0; k < loads.size(); ++k) {
        const Load& l = loads[k];
        const Surface& s = surfaces()[3];
        Curve c{fmt::format("load {}", l.text), fmt::format("load {}", l.text), Style::marked_line, static_cast<int>(k) + 1, {}};
        for (long n = 0; n <= last_scale; ++n)
            c.points.push_back(no_better_than(areas.status(l.value, s.G),
                                              certified(static_cast<double>(n),
                                                        relative_error(archard::area_limit(n, Ball::exactly(l.value), Ball::exactly(s.G),
                                                                                           archard::K_by_recursion<Ball>(100)),
                                                                       areas.at(n, l.value, s.G)),
                                                        6)));
        p.curves.push_back(std::move(c));
    }
    return p;
}

// ---- rounding errors beside the edge

struct Judged {
    const char* quantity;
    std::function<double(double, double)> library, printed;
};

double measured_ulps(const oracle::CertifiedValue& truth, double answer) { return oracle::error_of(answer, truth).most; }

/// Error in ulps of both codes, and what rounding the inputs alone can force, at x = a (1 -+ 2^-k).
Panel edge_panel(const Judged& j, const char* letter, const char* what, double side)
{
    constexpr double load = 0.3;
    Panel p{fmt::format("({}) {}", letter, what),
            letter,
            {"distance from the edge |{/:Italic x} − {/:Italic a}| / {/:Italic a}", 1e-16, 1, true, 1e4},
            {"error in ulps", 1e-3, 1e30, true, 1e4},
            {},
            {},
            {},
            above_all};
    Curve forced{"forced by rounded inputs", "forced by rounded inputs", Style::line, grey, {}};
    Curve printed{"formula as printed", "formula as printed, double", Style::points, 2, {}};
    Curve library{"library", "library, double", Style::points, 1, {}};
    const Quantity& q = *find_quantity(j.quantity);
    const double a = westergaard::half_width(load);
    for (int k = 1; k <= 50; ++k) {
        const double x = a * (1 + side * std::ldexp(1, -k));
        if (x > 0.5) continue;
        const Inputs in({{"x", exact_rational(x)}, {"load", exact_rational(load)}});
        const Evaluation e = evaluate(q, in, {.digits = 40});
        const auto value = parse_rational(e.value), error = parse_rational(e.error_bound);
        const oracle::CertifiedValue truth{*value, *error};
        if (truth.is_zero()) continue;
        const double at = std::fabs(x / a - 1);
        const auto point = [at](double ulps, const char* status) {
            return Point{at, fmt::format("{:.4g}", std::max(ulps, 1e-3)), "", status};
        };
        library.points.push_back(point(measured_ulps(truth, j.library(x, load)), "measured"));
        printed.points.push_back(point(measured_ulps(truth, j.printed(x, load)), "measured"));
        forced.points.push_back(point(oracle::forced_by_inputs(q, {x, load}, truth, 1).least, "certified"));
    }
    p.curves = {std::move(forced), std::move(printed), std::move(library)};
    return p;
}

double textbook_gap(double x, double load)
{
    const double v = std::sin(std::numbers::pi * std::fabs(x));
    return v * v <= load ? 0 : 2 * (v * std::sqrt(v * v - load) - load * std::acosh(v / std::sqrt(load)));
}

} // namespace

Figure print_errors()
{
    const WorkingPrecision precision(bits);
    Figure f{"print-errors", "Where printed equations fail",
             "Relative error of what is printed, certified. (a) (7.17) and (7.18): both arguments of Γ are 1/2 too small, and the error "
             "grows like a power; (7.10): its power of π is right only in the limit. (b) (9.4) lacks a square root: right at G = 2 "
             "alone. "
             "(c) The inner square root of (6.2) lacks a square; p_n as in the legend. (d) (7.21) with K_∞, said to be the limit at "
             "large n, at D = 1.5, γ = 10: its error tends to a constant, not to zero, as the Hertzian approximation errs at each scale.",
             "Four panels of relative errors of misprinted equations; the error of (7.17) grows without bound with n.", {}, 2, 320};
    f.panels = {constants(), widest_segment(), recursion_kernel(), limit_of_area()};
    return f;
}

Figure edge_error()
{
    const WorkingPrecision precision(bits);
    Figure f{"edge-error", "Error of two codes beside the edge of the contact",
             "Error in ulps of binary64 at load 0.3, x = a(1 ∓ 2^(−k)), of the library's formulas and of the textbook's as printed, "
             "measured on this machine when the figure is drawn. Line: what the rounding of x and load to binary64 alone can force, so "
             "that no code could do better on rounded inputs (certified lower bound). "
             "The library stays below that line; the formula as printed goes with it for the pressure, and for the gap, a difference of "
             "nearly equal numbers, errs by powers of ten more: beside the edge no digit of it is right. Points on the lower border are "
             "errors of 0.001 ulp or less.",
             "Two panels of error against distance from the edge, both logarithmic: towards the edge the library's error stays below what "
             "rounded inputs force; the formula as printed goes with it for the pressure and is far above it for the gap.", {}, 2, 360};
    f.panels.push_back(edge_panel({"westergaard.pressure", [](double x, double s) { return westergaard::pressure(x, s); },
                                   [](double x, double s) { return as_printed::pressure_partial(x, s); }},
                                  "a", "pressure inside, (2.4)", -1));
    f.panels.push_back(
        edge_panel({"westergaard.gap", [](double x, double s) { return westergaard::gap(x, s); }, textbook_gap}, "b", "gap outside", +1));
    return f;
}

} // namespace touchstone::figures
