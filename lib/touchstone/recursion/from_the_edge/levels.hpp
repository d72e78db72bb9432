// SPDX-License-Identifier: MIT
/// \file
/// The levels of one law, (G, load): analyticity box by box, rows, panels, values; forward.hpp says what is computed. Internal to
/// from_the_edge/.
#pragma once

#include "touchstone/recursion/from_the_edge/boxes.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/transfer/fixed.hpp"

#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <vector>

namespace touchstone::transfer::from_the_edge {

/// Polynomial on a panel [a, b] of d, in xi = (coordinate - mid)/half.
struct Panel {
    double a = 0, b = 0;
    bool logarithmic = false;
    Ball mid, half;
    double mid_d = 0, half_d = 0; ///< about
    long points = 0;
    double rho = 0, bound = 0;     ///< |u| <= bound on the ellipse rho
    double interpolation = 0;      ///< error of the interpolant of exact values
    double slope = 0;              ///< and of its derivative, with respect to xi
    std::vector<double> errors;    ///< of the nodal values
    double worst = 0;              ///< largest of errors
    arb_poly_t polynomial;
    std::vector<mp_limb_t> fixed; ///< its coefficients over 2^scale, highest first
    long scale = 0;
    mag_t fixed_error;            ///< of a value by Horner's rule from these
    Panel() { arb_poly_init(polynomial); mag_init(fixed_error); }
    ~Panel() { arb_poly_clear(polynomial); mag_clear(fixed_error); }
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;
};

struct Level {
    long k = 0;
    Ball edge;   ///< e_k
    Ball edge_bound; ///< the same at bound_bits
    Ball C;
    Boxes boxes;
    std::vector<std::unique_ptr<Panel>> panels; ///< none at k = 1
    std::vector<double> log_d, log_v;           ///< about, for tolerances
    double tail = 0;                            ///< T_k
    // for the certificate
    std::size_t nodes = 0, row_nodes = 0;
    double worst_interpolation = 0, worst_row = 0, worst_carried = 0, worst_total = 0;
};

enum class Kind { step, share, slope };

struct RuleNode {
    Ball s, c, weight;
};
/// Proven for each d in [low, high], and in the disc of radius `around` about each.
struct RowRule {
    double low = infinity, high = 0, around = 0;
    std::vector<RuleNode> nodes;
    double error = 0;
    double reach = infinity; ///< delta from here on is left out
    /// Whether a ball is one of these d, and so narrow that the rule's disc, wider by the slack of bounds, holds all of it.
    bool holds(const Ball& d) const { return low <= about(d) && about(d) <= high && d.radius_bound() <= slack / 2 * about(d); }
};
/// What differs between the routes beside the law.
struct Settings {
    std::vector<double> ratios;
    long least_points, most_points, step_points; ///< most at accuracy 80, more in proportion
    bool logarithmic;
    std::vector<double> piece_rhos;
    long most_gauss;
};
const Settings& settings(Law law);

class Levels {
public:
    Law law;
    double accuracy, epsilon;
    long most_points, most_gauss; ///< on a panel, on a piece
    slong precision;      ///< of the rows
    slong wide;           ///< of polynomials: powers of xi cancel up to (1 + 2^(1/2))^points
    FixedFormat format;
    std::vector<mp_limb_t> xi_fixed, sum_fixed, product_fixed, scratch;
    Ball G, load;
    bool full; ///< load = 1 exactly
    double G_d, load_d, beta;
    double delta_max;
    Shells shells;
    std::vector<std::unique_ptr<Level>> levels; ///< index k, from 1
    std::map<long, std::unique_ptr<Level>> whole;  ///< E_k up to the cut, for small p
    std::map<long, std::vector<std::pair<Ball, Ball>>> gauss;
    std::map<long, std::vector<Ball>> to_monomials;      ///< [power][node]
    std::map<long, std::vector<double>> chebyshev_at;    ///< T_m(x_j), [m][j]
    std::mutex mutex;

    static slong precision_for(double accuracy) { return static_cast<slong>(accuracy / std::numbers::ln2) + 34; }
    /// Where the far end begins: what it holds is negligible even for a light load at the last scale. Twice as far as far_end.hpp needs, at
    /// least: rows leave out what is beyond a little less.
    static double far_end(Law law, double accuracy, double G, double load);

    Levels(Law, const Ball& G, const Ball& load, double accuracy);

    long power(long k) const { return law == Law::density ? k - 1 : k + 1; }
    bool is_small(long n, const Ball& d) const;

    // ---- kernels and bounds

    /// int_0^(pi/2) sin^m
    static Ball wallis(long m);
    /// Bound of the step's kernel, or infinity. \param direct a bound of |1/E| known otherwise, E proven off its cut
    double kernel_bound(const Disc& e, const Disc& d, const Disc& s, const Disc& c, double direct = infinity, Kind kind = Kind::step) const;
    double modulus(const Disc& x, const Disc& one_minus, const Disc& w4, const Disc& D, double direct, Kind kind) const;
    /// Bound of |u_1| on a disc of d.
    double first_bound(const Disc& d) const;
    /// Largest bound of boxes that meet the range; infinite if one of them is not proven.
    double lookup(const Boxes& boxes, const PolarRange& p) const;
    /// Bound of |u| at 2 d s, for the d of a box and s0 <= s <= s1.
    double reached(const Boxes&, int shell, int direction, double s0, double s1) const;
    void fill(Boxes& boxes, double disc_radius, const std::function<double(const Disc&, int shell, int direction, double outer)>& f) const;
    std::unique_ptr<Level> first_level() const;
    /// |kernel| E^(1/2) where |x| <= e and |4w| <= eta (1-e)^2: R = (1-x)(1 + eta')^(1/2), |P| <= 2 + 2 eta, M = (1-x)(2 + ...).
    double far_kernel(double e, double eta) const;
    static constexpr int sectors = 32;
    /// Shares of int sin^m over theta in the sectors of [0, pi/2], rounded up (upper sums).
    static std::array<double, sectors> sector_shares(long m);
    void bound_boxes(const Level& from, Level& to) const;

    // ---- estimates, for tolerances only

    double kernel_d(double e, double d, double s) const;
    void estimate_first(Level& level) const;
    double estimate(const Level& level, double d) const;
    double estimate_step(const Level& from, double d) const;
    double estimate_share(const Level& from, double d) const;

    // ---- rules and rows

    struct Row {
        Ball value, slope; ///< v_{k+1}(d), and its derivative where asked
        double error = 0;  ///< of value (or of slope, where asked) beyond its radius: rule and levels
        double rule_error = 0, interpolation = 0, carried = 0;
    };
    const std::vector<std::pair<Ball, Ball>>& legendre(long n);
    /// Largest |integrand| over a disc of t: 2/(1+t^2) sin^m kernel u.
    double integrand_bound(const Level& from, Kind kind, const Disc& d, const Disc& t) const;
    /// Rule for all real d in [low, high], or for the disc of radius `around` about it.
    RowRule make_rule(const Level& from, Kind kind, double low, double high, double around, double tolerance);
    RowRule rule_at(const Level& from, Kind kind, const Ball& d, double around);
    /// u_1 and, if asked, its derivative.
    void first(const Ball& d, Ball& u, Ball* slope) const;
    Row row(const Level& from, Kind kind, const Ball& d, const RowRule& rule);
    /// What the far end, delta >= reach, can hold of v_{k+1}(d).
    double dropped(const Level& from, Kind kind, double d, double reach) const;
    double log_constant(const Level& from) const;
    Ball constant_after(const Level& from) const;

    // ---- building a level

    struct Choice {
        double b = 0, rho = 0, bound = 0;
        long points = std::numeric_limits<long>::max();
    };
    const std::vector<double>& chebyshev_table(long n);
    /// Values at the n Chebyshev points to coefficients of powers.
    const std::vector<Ball>& monomial_matrix(long n);
    /// Bound of |u| on the ellipse rho of [a, b], in d or in log d; whole: of |v|, or in log d of |d^(k/2) v|, b = 1/2.
    double ellipse_bound(const Level& to, double a, double b, bool logarithmic, double rho, bool whole) const;
    Choice choose(const Level& from, const Level& to, double a, double b, bool logarithmic, bool whole) const;
    void extend_to(long k);
    /// \param whole_until 0, or where E_{k+1}, kept in place of u_{k+1}, is to end: for small p
    std::unique_ptr<Level> next(const Level& from, double whole_until = 0);
    /// Fixed-point form of the panel's polynomial: sum |c| < 2^14 units of 2^scale.
    ///
    /// A value is off by at most: each of `points` coefficients one unit, each product one unit (both carried on by |xi| <= 1), and xi's
    /// own unit times sum j |c_j| <= points 2^14. The radius of xi is added where it is used.
    void make_fixed(Panel& panel) const;
    void evaluate(const Panel& panel, const Ball& xi, Ball& u);
    void fill_panel(const Level& from, Level& to, Panel& panel, bool whole);

    // ---- values

    struct Value {
        Ball value;
        Row row;
        std::size_t nodes;
        double cut = 0; ///< where E_n ends, if by the form for small p
    };
    Value density(long n, const Ball& p, const Ball& d);
    Value small_density(long n, const Ball& d);
    Value exceedance(long n, const Ball& d);

    // ---- integrals over the whole support

    /// int d^(twice/2) e^(-c d) u_k over the panels of a level, and where they end.
    ///
    /// |u - polynomial| <= interpolation + Lebesgue constant (2/pi) log N + 1 times the worst node's error.
    std::pair<Ball, double> over_level(const Level& level, long twice, const Ball& c) const;
    /// p_n^max = G^k e_k, k = n + 1
    Ball highest(const Level& level) const;
    Ball force(long n);
    Ball mass(long n);
};

/// b, and what may be off by error.
void widen(Ball& b, double error);
/// x^(twice/2)
Ball half_power(const Ball& x, long twice);
/// Where the variable of integration over a panel, t with delta = t^2 or y with delta = e^y, is x: delta, and the panel's polynomial.
std::pair<C, C> on_panel(const Panel&, const C& x, slong bits);
/// delta^(twice/2) ddelta = 2 t^(twice+1) dt
C root_measure(const C& t, long twice, slong bits);

} // namespace touchstone::transfer::from_the_edge
