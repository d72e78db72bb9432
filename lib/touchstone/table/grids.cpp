// SPDX-License-Identifier: MIT
/// Which inputs the tables have: every regime, dense where codes go wrong (edges of the contact,
/// loads near 0 and 1), extremes of the exponent range, and fixed pseudo-random binary64 numbers.
#include "touchstone/paper/segments.hpp"
#include "touchstone/table/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace touchstone {
namespace {

using Row = std::vector<double>;
using Rows = std::vector<Row>;

/// Uniform in (0, 1), the same on every platform (mt19937_64's output is; distributions are not).
class Random {
public:
    explicit Random(unsigned long seed) : engine_(seed) {}
    double operator()() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
    double between(double a, double b) { return a + (b - a) * (*this)(); }
    double log_between(double a, double b) { return std::exp2(std::log2(a) + (std::log2(b) - std::log2(a)) * (*this)()); }

private:
    std::mt19937_64 engine_;
};

/// exp2 and friends may differ in the last bit between C libraries: keep 40 bits so that the grid cannot.
double rounded(double x)
{
    int e = 0;
    const double m = std::frexp(x, &e);
    return std::ldexp(std::nearbyint(std::ldexp(m, 40)), e - 40);
}

/// Loads in (0, 1]: extremes, powers of two, dense below 1, the paper's values, the special angles.
std::vector<double> partial_loads()
{
    std::vector<double> v{5e-324, 1e-310, 0x1p-1022, 1e-300, 1e-200, 1e-100, 1e-50, 1e-30, 1e-20, 1e-16, 1e-12, 1e-9, 1e-6,
                          0.001, 0.01, 0.05, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8, 0.9, 0.99, 1.0};
    for (int k = 2; k <= 53; ++k) v.push_back(1 - std::ldexp(1, -k));
    for (int k = 2; k <= 60; k += 2) v.push_back(std::ldexp(1, -k));
    return v;
}

std::vector<double> full_loads()
{
    std::vector<double> v{1.0, 1.1, 1.25, 1.5, 2.0, 3.0, 5.0, 10.0, 100.0, 1e6, 1e15, 1e300};
    for (int k = 4; k <= 52; k += 4) v.push_back(1 + std::ldexp(1, -k));
    return v;
}

Rows as_rows(const std::vector<double>& v)
{
    Rows rows;
    for (const double x : v) rows.push_back({x});
    return rows;
}

Rows distinct(Rows rows)
{
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

Rows half_width_grid()
{
    Rows rows = as_rows(partial_loads());
    Random r(1);
    for (int i = 0; i < 100; ++i) rows.push_back({r()});
    for (int i = 0; i < 100; ++i) rows.push_back({rounded(r.log_between(1e-300, 1))});
    return distinct(rows);
}

Rows hertz_half_width_grid()
{
    Rows rows = half_width_grid();
    for (const double s : full_loads()) rows.push_back({s});
    return distinct(rows);
}

/// Positions inside, next to and outside the contact edge, from the binary64 number nearest below the edge.
template <class Edge>
Rows position_grid(const std::vector<double>& loads, Edge edge, double farthest)
{
    Rows rows;
    Random r(2);
    for (const double s : loads) {
        const double a = std::min(rounded(edge(s)), farthest);
        std::vector<double> x{0, a / 4, a / 2, -a / 2, 0.9 * a, a, std::nextafter(a, 0), std::nextafter(a, 1), 0.5 * farthest, farthest};
        for (const int k : {4, 8, 16, 24, 32, 40, 48}) {
            x.push_back(a * (1 - std::ldexp(1, -k)));
            x.push_back(a * (1 + std::ldexp(1, -k)));
        }
        for (int i = 0; i < 3; ++i) x.push_back(a * r());
        for (const double xi : x)
            if (std::fabs(xi) <= farthest) rows.push_back({xi, s});
    }
    return distinct(rows);
}

std::vector<double> some_loads()
{
    std::vector<double> v{1e-300, 1e-100, 1e-20, 1e-12, 1e-6, 0.001, 0.01, 0.1, 0.2, 0.25, 0.4, 0.5, 0.75, 0.9, 0.99,
                          1 - 0x1p-20, 1 - 0x1p-40, 1 - 0x1p-53, 1.0, 1 + 0x1p-52, 1 + 0x1p-20, 1.25, 1.5, 2.0, 3.0, 10.0, 1000.0};
    Random r(3);
    for (int i = 0; i < 6; ++i) v.push_back(r());
    return v;
}

Rows pressure_grid()
{
    return position_grid(some_loads(), [](double s) { return s < 1 ? westergaard::half_width(s) : 0.5; }, 0.5);
}

Rows hertz_pressure_grid()
{
    std::vector<double> loads = some_loads();
    return position_grid(loads, [](double s) { return hertz::half_width(s); }, 16.0);
}

/// Loads for what happens beside the contact: some_loads, and more towards both ends.
std::vector<double> gap_loads()
{
    std::vector<double> v = some_loads();
    for (int k = 4; k <= 52; k += 4) v.push_back(1 - std::ldexp(1, -k));
    for (int k = 6; k <= 48; k += 6) v.push_back(std::ldexp(1, -k));
    return v;
}

Rows gap_grid()
{
    return position_grid(gap_loads(), [](double s) { return s < 1 ? westergaard::half_width(s) : 0.5; }, 0.5);
}

Rows hertz_gap_grid()
{
    return position_grid(gap_loads(), [](double s) { return hertz::half_width(s); }, 16.0);
}

/// Pressures across the support, dense at its edges; `at_edge` says whether the edges themselves belong.
Rows pressure_level_grid(bool at_edge)
{
    Rows rows;
    Random r(4);
    for (const double s : some_loads()) {
        const double top = westergaard::peak_pressure(s);
        const double low = s > 1 ? s - 1 : 0;
        std::vector<double> p{low, low + (top - low) / 4, low + (top - low) / 2, top - (top - low) / 8, top, 1.5 * top, low / 2};
        for (const int k : {8, 16, 24, 32, 40, 50}) {
            p.push_back(top * (1 - std::ldexp(1, -k)));
            p.push_back(top * (1 + std::ldexp(1, -k)));
            p.push_back(low + (top - low) * std::ldexp(1, -k));
        }
        for (int i = 0; i < 3; ++i) p.push_back(low + (top - low) * r());
        for (const double pi : p) {
            const Rational P = exact_rational(pi), S = exact_rational(s);
            const bool edge = S < 1 ? P * P == 4 * S : (P == S - 1 || P == S + 1);
            if (at_edge || !edge) rows.push_back({pi, s});
        }
    }
    return distinct(rows);
}

const std::vector<double> paper_D{1.05, 1.25, 1.5};
const std::vector<double> paper_gamma{4, 5, 10, 16, 256};

std::vector<Row> surfaces()
{
    std::vector<Row> v;
    for (const double D : paper_D)
        for (const double g : paper_gamma) v.push_back({D, g});
    for (const Row& extra : Rows{{1 + 0x1p-52, 10}, {1.999, 10}, {2 - 0x1p-52, 5}, {1.5, 1.0625}, {1.5, 1e6}, {1.01, 1e300}, {1.75, 2.5}})
        v.push_back(extra);
    return v;
}

Rows bound_grid()
{
    Rows rows = surfaces();
    Random r(5);
    for (int i = 0; i < 200; ++i) rows.push_back({1 + r(), rounded(1 + r.log_between(1e-3, 1e6))});
    return distinct(rows);
}

Rows profile_grid()
{
    Rows rows;
    Random r(6);
    for (const auto& [D, g] : {std::pair{1.05, 5.0}, {1.05, 10.0}, {1.5, 5.0}, {1.5, 10.0}, {1.25, 2.5}, {1.5, 4.0}}) {
        for (const double x : {0.0, 0.5, 0.25, -0.25, 0.125, 0x1p-20, 0.1, 1.0 / 3.0, 12345.678, 1e15}) rows.push_back({x, D, g});
        for (int i = 0; i < 10; ++i) rows.push_back({r() - 0.5, D, g});
    }
    return distinct(rows);
}

/// G on both sides of 2 and near its ends, for quantities that take D and gamma or G.
std::vector<double> ratios()
{
    std::vector<double> v{1 + 0x1p-52, 1 + 0x1p-20, 1.0625, 1.0838, 1.122, 1.5, 1.75, 2 - 0x1p-20, 2 - 0x1p-52, 2.0, 2 + 0x1p-51,
                          2.05, 2.25, 2.5, 3.1622776601683795, 4.0, 4.47, 5.0, 16.0, 1000.0, 1e15, 1e150, 1e155, 1e160};
    return v;
}

Rows fixed_point_grid()
{
    Rows rows = as_rows(ratios());
    Random r(7);
    for (int i = 0; i < 200; ++i) rows.push_back({rounded(1 + r.log_between(1e-6, 1e3))});
    return distinct(rows);
}

Rows f_grid()
{
    Rows rows = hertz_half_width_grid();
    return distinct(rows);
}

const std::vector<double> paper_loads{0.001, 0.01, 0.1, 1, 10};

Rows iterate_grid()
{
    Rows rows;
    for (const double n : {0., 1., 2., 3., 5., 10., 20., 100., 1000.})
        for (const double s : {1e-300, 0.001, 0.01, 0.1, 1., 10., 1e10})
            for (const double G : {1.0838, 1.122, 2., 2.25, 3.1622776601683795, 16.}) rows.push_back({n, s, G});
    return distinct(rows);
}

Rows n_grid()
{
    Rows rows;
    for (int n = 0; n <= 64; ++n) rows.push_back({static_cast<double>(n)});
    for (const double n : {100., 1000., 10000., 100000., 1000000.}) rows.push_back({n});
    return rows;
}

Rows alpha_grid()
{
    Rows rows;
    for (const double n : {0., 1., 2., 3., 4., 5., 10., 20., 50., 60., 1000., 1000000.})
        for (const double D : {1 + 0x1p-52, 1.05, 1.25, 1.5, 1.75, 2 - 0x1p-52}) rows.push_back({n, D});
    return distinct(rows);
}

Rows area_grid()
{
    Rows rows;
    for (int n = 0; n <= 20; ++n)
        for (const double s : {1e-300, 1e-12, 0.001, 0.01, 0.1, 1., 10.})
            for (const double G : {1.0838, 1.122, 2.2360679774997896, 3.1622776601683795}) rows.push_back({static_cast<double>(n), s, G});
    // where an exponent no longer fits 53 bits, and where powers alone would leave the range
    for (const double n : {40., 47., 48., 52., 53., 54., 60., 100., 300.})
        for (const double s : {1e-300, 0.01, 1., 1e300})
            for (const double G : {1.0838, 3.1622776601683795, 11., 1e6}) rows.push_back({n, s, G});
    return distinct(rows);
}

/// Partial contact at every scale: G of (D, gamma) = (1.5, 5), (1.5, 10), (1.5, 16) = (1.25, 256).
Rows contact_area_grid()
{
    Rows rows;
    for (const double G : {2.2360679774997896, 3.1622776601683795, 4.})
        for (const double s : {0.001, 0.01, 0.1, 1.})
            for (int n = 0; n <= 20; ++n) rows.push_back({static_cast<double>(n), s, G});
    return distinct(rows);
}

constexpr double figure_3a_G = 1.0837983867343681; ///< D = 1.05, gamma = 5
constexpr double figure_3b_G = 1.1220184543019633; ///< D = 1.05, gamma = 10
constexpr double figure_5_G = 3.1622776601683795;  ///< D = 1.5, gamma = 10
constexpr double second_G = 2.2360679774997896;    ///< D = 1.5, gamma = 5

/// Tables with full contact are split by what is known of them, so that each has one status: G < 2 here, G > 2 and load > 1 in _heavy.
Rows contact_area_full_grid()
{
    Rows rows;
    for (const double G : {figure_3a_G, figure_3b_G})
        for (const double s : paper_loads)
            for (int n = 0; n <= 20; ++n) rows.push_back({static_cast<double>(n), s, G});
    return distinct(rows);
}

Rows contact_area_heavy_grid()
{
    Rows rows;
    for (const double G : {second_G, figure_5_G})
        for (int n = 0; n <= 20; ++n) rows.push_back({static_cast<double>(n), 10., G});
    return distinct(rows);
}

/// The lowest and the highest pressure of scale n, in p*_0, rounded: (5.2), (5.4), (5.6).
std::pair<double, double> support(long n, double s, double G)
{
    double unit = 1, low = s - 1;
    for (long k = 1; k <= n; ++k) low -= unit *= G;
    return {std::max(0., low), unit * G * peaks::iterate(n, s, G)};
}

/// Scale 1 where full contact occurs: the support up to its ends, and beside the points where the density has logarithms.
Rows contact_scale_1_grid()
{
    Rows rows;
    const auto add = [&rows](double p, double s, double G) {
        const auto [low, high] = support(1, s, G);
        if (p > low && p < high) rows.push_back({1, rounded(p), s, G});
    };
    std::vector<std::pair<double, double>> cases{{1, 1.5}, {1, 2}, {0.5, 2}, {1.5, 2.5}, {100, 1.5}, {10, second_G}, {10, figure_5_G}};
    for (const double s : paper_loads)
        for (const double G : {figure_3a_G, figure_3b_G}) cases.emplace_back(s, G);
    for (const auto& [s, G] : cases) {
        const auto [low, high] = support(1, s, G);
        for (const double share : {0x1p-20, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 1 - 0x1p-20}) add(low + (high - low) * share, s, G);
        if (s <= 1) continue;
        for (const double at : {s + 1 - G, s - 1 + G})
            for (const double off : {-0x1p-10, -0x1p-30, 0x1p-30, 0x1p-10}) add(at * (1 + off), s, G);
    }
    return distinct(rows);
}

/// Scales 2 and 4 where full contact occurs: certified exceedances take a mesh for each row, hence few rows.
Rows contact_distribution_full_grid()
{
    Rows rows;
    for (const auto& [s, G] : {std::pair{1., figure_3a_G}, {10., figure_3a_G}, {0.01, figure_3b_G}, {10., figure_5_G}})
        for (const auto& [n, share] : {std::pair{2L, 0.5}, {4L, 0.7}}) {
            const auto [low, high] = support(n, s, G);
            rows.push_back({static_cast<double>(n), rounded(low + (high - low) * share), s, G});
        }
    return distinct(rows);
}

/// Scale 2, and one of scale 4.
Rows contact_density_full_grid()
{
    Rows rows = contact_distribution_full_grid();
    std::erase_if(rows, [](const std::vector<double>& row) { return row[0] > 2 && row[2] != 1; });
    return rows;
}

/// Shares of the highest pressure (or of the widest segment), the edge from both sides included.
const std::vector<double> shares{0x1p-20, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 1 - 0x1p-12, 1 - 0x1p-20, 1.25};

/// Where the scales up to 20 are tabulated.
const std::vector<double> scale_shares{0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99};

/// p (in p*_0) across the support: scales 0 and 1 dense at the edges, the case of figure 5 up to scale 20, another up to 4.
Rows contact_distribution_grid()
{
    Rows rows;
    const auto add = [&rows](long n, double share, double s, double G) {
        double unit = 1;
        for (long k = 0; k <= n; ++k) unit *= G;
        rows.push_back({static_cast<double>(n), rounded(share * unit * peaks::iterate(n, s, G)), s, G});
    };
    for (const double s : {0.001, 0.01, 0.1, 1.})
        for (const long n : {0L, 1L})
            for (const double share : shares) add(n, share, s, figure_5_G);
    for (const double share : scale_shares)
        for (long n = 0; n <= 20; ++n) add(n, share, 0.001, figure_5_G);
    for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99})
        for (const long n : {1L, 2L, 4L}) add(n, share, 0.1, second_G);
    return distinct(rows);
}

/// a (in lambda_n) up to the widest segment and beyond, the scales whose pressures decide it.
Rows segments_density_grid()
{
    Rows rows;
    const auto add = [&rows](long n, double share, double s, double G) {
        const double a = rounded(share * segments::max_half_width(n, s, G));
        if (a <= 0.5) rows.push_back({static_cast<double>(n), a, s, G});
    };
    for (const double s : {0.001, 0.01, 0.1, 1.})
        for (const long n : {1L, 2L})
            for (const double share : shares) add(n, share, s, figure_5_G);
    // the pressure goes with about the square of the width: the same range of pressures
    for (const double share : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99})
        for (long n = 1; n <= 20; ++n) add(n, share, 0.001, figure_5_G);
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9, 0.99})
        for (const long n : {2L, 3L, 5L}) add(n, share, 0.1, second_G);
    return distinct(rows);
}

Rows segments_count_grid()
{
    Rows rows;
    for (const double g : {5., 10., 16.})
        for (const double s : {0.001, 0.01, 0.1, 1.})
            for (int n = 1; n <= 21; ++n) rows.push_back({static_cast<double>(n), s, 1.5, g});
    return distinct(rows);
}

Rows segments_grid()
{
    Rows rows;
    for (int n = 1; n <= 20; ++n)
        for (const double s : paper_loads)
            for (const double D : {1.05, 1.5})
                for (const double g : {5., 10.}) rows.push_back({static_cast<double>(n), s, D, g});
    for (const double n : {48., 53., 54., 60., 100., 400.})
        for (const double s : {1e-300, 1e-100, 0.01, 1.})
            for (const double D : {1.05, 1.5, 1.95}) rows.push_back({n, s, D, 5.});
    return distinct(rows);
}

Rows max_half_width_grid()
{
    Rows rows;
    for (const double n : {0., 1., 2., 3., 5., 10., 20., 100.})
        for (const double s : {1e-300, 1e-12, 0.001, 0.01, 0.1, 0.9, 1., 10.})
            for (const double G : {1.0838, 1.122, 2., 2.2360679774997896, 3.1622776601683795, 16.}) rows.push_back({n, s, G});
    return distinct(rows);
}

/// G from next to 2, where full contact begins never to end, to where (7.21) is right to all digits; among them those of figures 3 to 5.
Rows limit_grid()
{
    std::vector<double> G{second_G, figure_5_G, 2.01, 2.02, 2.05, 2.1, 2.15, 2.2, 2.25, 2.3, 2.4, 2.5, 2.6, 2.7, 2.75, 2.8, 2.9};
    for (int k = 12; k <= 40; ++k) G.push_back(k / 4.);
    for (const double g :
         {11., 12., 13., 14., 15., 16., 18., 20., 25., 30., 40., 50., 64., 100., 128., 200., 500., 1000., 5000., 1e4, 3e4, 1e5, 1e6})
        G.push_back(g);
    return distinct(as_rows(G));
}

/// Full contact never ends: from where the mesh is largest to G = 2, the first two of figure 3 among them.
Rows limit_full_grid()
{
    return as_rows({1.02, 1.03, 1.05, figure_3a_G, 1.1, figure_3b_G, 1.15, 1.2, 1.25, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 1.95, 2});
}

Rows limit_ratio_grid() { return as_rows({2.05, second_G, figure_5_G, 4, 10, 100, 1000, 1e4, 1e6}); }
Rows limit_gap_grid() { return as_rows({2.2, second_G, 2.5, 3, figure_5_G, 4, 10, 100, 1e4, 1e6}); }

/// Pressures in p*_n; at p = G/5 and G, contacts of the next scale leave the Hertzian range, and are full.
Rows limit_exceedance_grid()
{
    Rows rows;
    for (const double p : {0.01, 0.1, 0.25, 0.5, 0.75, 1., 1.25}) rows.push_back({p, figure_5_G});
    for (const double p : {0.1, 0.4472135954999579, 1.5}) rows.push_back({p, second_G});
    for (const double p : {0.3, 1.5}) rows.push_back({p, 1.5});
    return rows;
}

/// Pressures in p*_n up to next to the highest, 4/G, and with full contact.
Rows limit_density_grid()
{
    Rows rows;
    for (const double p : {0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 1., 1.2}) rows.push_back({p, figure_5_G});
    for (const double p : {0.1, 0.4472135954999579, 1., 1.5}) rows.push_back({p, second_G});
    for (const double p : {0.5, 1.5}) rows.push_back({p, 1.5});
    return rows;
}

/// Scales up to 30 of figure 5's case, and with full contact.
Rows limit_distance_grid()
{
    Rows rows;
    for (const double n : {1., 2., 3., 5., 10., 20., 30.}) rows.push_back({n, 0.5, 0.1, figure_5_G});
    for (const double n : {2., 5.}) rows.push_back({n, 1., 0.1, 1.5});
    return rows;
}

/// Half-widths in wavelengths.
Rows limit_segments_grid()
{
    Rows rows;
    for (const double a : {0.05, 0.1, 0.15, 0.2}) rows.push_back({a, figure_5_G});
    for (const double a : {0.25, 0.5}) rows.push_back({a, 1.5});
    return rows;
}

Rows limit_scale_grid()
{
    Rows rows;
    for (const double G : {second_G, figure_5_G})
        for (const double s : {0.001, 0.1, 1.})
            for (const double tolerance : {0.01, 1e-6}) rows.push_back({s, tolerance, G});
    return rows;
}

} // namespace

static const std::vector<TableSpec>& grids()
{
    constexpr long digits = 40;
    static const std::vector<TableSpec> all{
        {"westergaard_half_width", "westergaard.half_width", digits, half_width_grid},
        {"westergaard_pressure", "westergaard.pressure", digits, pressure_grid},
        {"westergaard_exceedance", "westergaard.exceedance", digits, [] { return pressure_level_grid(true); }},
        {"westergaard_density", "westergaard.density", digits, [] { return pressure_level_grid(false); }},
        {"westergaard_gap", "westergaard.gap", digits, gap_grid},
        {"westergaard_mean_gap", "westergaard.mean_gap", digits, hertz_half_width_grid},
        {"westergaard_energy", "westergaard.energy", digits, hertz_half_width_grid},
        {"hertz_half_width", "hertz.half_width", digits, hertz_half_width_grid},
        {"hertz_pressure", "hertz.pressure", digits, hertz_pressure_grid},
        {"hertz_gap", "hertz.gap", digits, hertz_gap_grid},
        {"weierstrass_profile", "weierstrass.profile", digits, profile_grid},
        {"weierstrass_bound", "weierstrass.bound", digits, bound_grid},
        {"peaks_f", "peaks.f", digits, f_grid},
        {"peaks_iterate", "peaks.iterate", digits, iterate_grid},
        {"peaks_fixed_point", "peaks.fixed_point", digits, fixed_point_grid},
        {"contact_area", "contact.area", digits, contact_area_grid},
        {"contact_area_full", "contact.area", 16, contact_area_full_grid, true},
        {"contact_area_heavy", "contact.area", 17, contact_area_heavy_grid, true},
        {"archard_K", "archard.K", digits, n_grid},
        {"archard_K_inf", "archard.K_inf", 1000, [] { return Rows{{}}; }},
        {"archard_delta", "archard.delta", digits, n_grid},
        {"archard_alpha", "archard.alpha", digits, alpha_grid},
        {"archard_area", "archard.area", digits, area_grid},
        {"archard_segments", "archard.segments", digits, segments_grid},
        {"archard_segments_limit", "archard.segments_limit", digits, segments_grid},
        {"contact_exceedance", "contact.exceedance", 30, contact_distribution_grid, true},
        {"contact_density", "contact.density", 30, contact_distribution_grid, true},
        {"contact_exceedance_scale_1", "contact.exceedance", 30, contact_scale_1_grid},
        {"contact_density_scale_1", "contact.density", 30, contact_scale_1_grid},
        {"contact_exceedance_full", "contact.exceedance", 10, contact_distribution_full_grid, true},
        {"contact_density_full", "contact.density", 10, contact_density_full_grid, true},
        {"segments_count", "segments.count", digits, segments_count_grid},
        {"segments_density", "segments.density", 30, segments_density_grid, true},
        {"limit_constant", "limit.area_constant", 20, limit_grid, true},
        {"limit_constant_full", "limit.area_constant", 10, limit_full_grid, true},
        {"limit_ratio", "limit.area_ratio", 20, limit_ratio_grid, true},
        {"limit_exceedance", "limit.exceedance", 8, limit_exceedance_grid, true},
        {"limit_force", "limit.force", 8, limit_exceedance_grid, true},
        {"limit_density", "limit.density", 6, limit_density_grid, true},
        {"limit_distance", "limit.distance", 3, limit_distance_grid, true},
        {"limit_segments", "limit.segments", 8, limit_segments_grid, true},
        {"limit_scale", "limit.scale", 20, limit_scale_grid, true},
        {"limit_gap", "limit.gap", 15, limit_gap_grid, true},
        {"segments_max_half_width", "segments.max_half_width", digits, max_half_width_grid},
    };
    return all;
}

const std::vector<TableSpec>& table_specs()
{
    static const std::vector<TableSpec> all = [] {
        std::vector<TableSpec> specs = grids();
        for (auto& spec : specs) spec.forced = !spec.quantity.starts_with("limit."); // another G is another solution there
        return specs;
    }();
    return all;
}

} // namespace touchstone
