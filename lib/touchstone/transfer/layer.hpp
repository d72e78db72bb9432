// SPDX-License-Identifier: MIT
/// \file
/// Piecewise polynomials V on a mesh, and T V at a point with everything that rounding and quadrature can do to it charged:
/// proven_levels.md, 2. V may be anything. Internal to transfer/.
#pragma once

#include "touchstone/transfer/wide_balls.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace touchstone::transfer::levels {

using Real = DoubleDouble<double>; // values and positions; bounds of errors are `double`
using Kernel = WaveKernel<Real>;

/// Half of an interval of x, relative: rounding moves its Chebyshev points by less than 1e-6 of that.
/// A panel of z is at least twice as wide, relative: its edges' rounding is far less than its width.
constexpr double narrowest = 2e6 * bounds::u;
constexpr double overlap = 1.4; ///< a panel's polynomial is a good approximation on so much more than the panel

inline double power(double x, int n)
{
    double r = 1;
    for (; n > 0; n >>= 1, x *= x)
        if (n & 1) r *= x;
    return r;
}
inline double size_of(const Real& x) { return std::fabs(x.high) * bounds::margin; }

/// The polynomial of a panel holds on z0 <= z <= z1, z = x^2, and is a good approximation on centre +- half.
struct Panel {
    Real y0, y1, z0, z1, centre, half;
    bool first;
    // a hundredth less: what jumps between the last node and the end of the interval is not seen
    Real left() const { return first ? z0 : centre - half * 0.99; }
    Real right() const { return centre + half * 0.99; }
    double width() const { return size_of(y1 - y0); }
};

inline Panel panel(const Real& z0, const Real& z1, bool first)
{
    Panel p{sqrt(z0), sqrt(z1), z0, z1, (z0 + z1) * 0.5, (z1 - z0) * (0.5 * overlap), first};
    if (first) p.half = p.centre - z0; // nothing is known to its left
    return p;
}

/// A run of panels seen as one from afar: the kernel of T is interpolated on a <= z <= b.
struct Cluster {
    int first, last;         ///< panels
    int left = -1, right = -1;
    Real a, b, mid, half;
    int panels() const { return last - first + 1; }
};

/// Chebyshev points of the first kind and T_k there.
struct ChebyshevPoints {
    Wide at, T; ///< T[k * count + i]
    explicit ChebyshevPoints(int count);
};

/// At least |dtheta/dz| where z is within the ellipse about c.mid with the half axis axis * c.half and c.a, c.b for its foci: short of the
/// kernel's ends.
double largest_density(const Kernel&, const Cluster&, double axis);
/// How much more than its own rounding 1 - c or 1 + c loses on a cluster.
double cancellation(const Kernel&, const Cluster&);

/// Bounds on a cluster: interpolation of dtheta/dz and every rounding.
struct ClusterError {
    double total;   ///< per unit of |V|
    double measure; ///< per unit of an error of V on average
};
/// Infinite where the cluster will not do.
ClusterError cluster_error(const Kernel&, const Cluster&, int terms, double affordable);

/// A disc about the middle of an interval of the variable of integration where |local| <= 2.916, inside the ellipse of rho = 6, and at
/// least
/// |dtheta/d(variable)| there.
struct RuleDisc {
    double radius, largest;
};
/// The largest that is found, for mid -+ width.
RuleDisc disc_about(const Kernel&, const Panel&, Substitution, const Real& mid, const Real& width);
/// Gauss-Legendre of so many points on the disc's middle -+ half, per unit of sum |c_k| 6^k. Infinite where the disc does not hold that.
double quadrature_error(const RuleDisc&, double half, int points);

/// What rounding moves an edge by at most, in c: 8 operations on numbers up to 1 + x, G's own error included.
inline double edge_moves(const Real& x) { return 16 * bounds::u * (1 + double(x)); }
/// At least the share of theta between an edge and where it may be moved to, by `moved` in c at most: next to an end of the kernel, that of
/// an interval there, md (2).
double share_moved(const Kernel&, const Real& z, double moved);

/// Sizes of everything that follows from the tolerance.
struct Orders {
    int terms, gauss, kernel;
    explicit Orders(double tolerance)
        : terms(4 * static_cast<int>(std::ceil(-std::log10(tolerance) * 1.72 / 4)))
        , gauss(4 * static_cast<int>(std::ceil(terms * 0.7 / 4)))
        , kernel(terms)
    {
    }
};

/// T V at one point as sums over the numbers of V: the same for every V on one mesh.
struct Plan {
    struct Sum {
        bool cluster;
        std::size_t first; ///< of the layer's weights, resp. coefficients
        std::size_t from, count; ///< of the factors
    };
    std::vector<Sum> sums;
    Wide factors;
    void add(bool cluster, std::size_t first, const Wide& by);
    std::size_t memory() const { return sums.capacity() * sizeof(Sum) + 2 * factors.high.capacity() * sizeof(double); }
};

/// What apply() writes to.
struct Result {
    Wide value;
    std::vector<double> error;
    Plan* plan = nullptr;                ///< is written too, where V is one
    Wide kernel, moment, local, weight; ///< scratch
};

/// `count` of the V on one mesh. Arrays: [panel * count + m], [(panel * terms + k) * count + m].
struct Layer {
    const Orders& orders;
    const Gauss& gauss;
    const Real G;
    const double affordable;
    std::vector<Panel> panels;
    const int count;
    std::vector<Cluster> clusters;

    Wide coefficients;
    Wide weights;                  ///< [(cluster * orders.kernel + q) * count + m]: integral of V_m times the q-th Lagrange polynomial
    std::vector<double> growth;    ///< sum |c_k| 6^k
    std::vector<double> rounding;  ///< error of evaluating V_m on the panel, the point's own rounding included
    std::vector<int> accurate;     ///< [panel]: from this T_k on, moments are taken in binary64
    std::vector<double> late;      ///< what V_m's coefficients there make of their roundings, per unit of the share
    std::vector<double> step; ///< [panel * count + m]: at least the jump of V_m at the panel's left edge; one more for the last right edge
    std::vector<double> jump;      ///< at least the jumps of V_m at the panel's edges and at those of its neighbours
    std::vector<double> size;      ///< sum |c_k|
    std::vector<double> top;       ///< [cluster * count + m]: at least |V_m| on the cluster
    std::vector<double> noise;     ///< [cluster * count + m]: mean error of V_m on the cluster, from `rounding`
    std::vector<double> largest;   ///< [m]: at least |V_m|

    /// \throws BeyondReach where a panel is narrower than 2 narrowest of its place
    Layer(const Orders&, const Gauss&, const ChebyshevPoints&, const Gauss& exact, Real G, double tolerance, std::vector<Panel>, int count);

    std::size_t at(std::size_t panel, int m) const { return panel * count + m; }
    std::size_t row(std::size_t panel, int k) const { return (panel * orders.terms + k) * count; }
    int find(const Real& z) const
    {
        const auto it = std::upper_bound(panels.begin(), panels.end(), z, [](const Real& v, const Panel& p) { return v < p.z0; });
        return std::max(0, static_cast<int>(it - panels.begin()) - 1);
    }
    Real value(std::size_t panel, int m, const Real& local) const
    {
        Real b1 = 0, b2 = 0;
        const Real twice = local + local;
        for (int k = orders.terms - 1; k > 0; --k) {
            const Real b = twice * b1 - b2 + coefficients[row(panel, k) + m];
            b2 = b1;
            b1 = b;
        }
        return local * b1 - b2 + coefficients[row(panel, 0) + m];
    }
    /// All V_m there, into out.value. \param local within [-1, 1]
    void values(std::size_t panel, const Real& local, Result& out) const
    {
        out.moment = Wide(orders.terms);
        out.value = Wide(count);
        Real before = 1, now = local;
        const Real twice = local + local;
        for (int k = 0; k < orders.terms; ++k) {
            out.moment.set(k, before);
            const Real next = twice * now - before;
            before = now;
            now = next;
        }
        add_products(coefficients, row(panel, 0), out.moment, count, out.value);
    }
    double magnitude(std::size_t panel, int k, int m) const { return std::fabs(coefficients.high[row(panel, k) + m]); }
    double growth_at(std::size_t panel, int m, double rho, int from = 0) const
    {
        double sum = 0, p = power(rho, from);
        for (int k = from; k < orders.terms; ++k, p *= rho) sum += magnitude(panel, k, m) * p;
        return bounds::margin * sum;
    }
    /// V_m from its coefficients, [panel * terms + k].
    void set(int m, const Wide& series);
    /// T V_m at x for all m, with bounds of the error.
    void apply(const Real& x, Result&) const;
    /// T V at the point of a plan, where V is one. Its error is not bounded.
    Real follow(const Plan&) const;

    const ChebyshevPoints& points; ///< of the clusters
    const Gauss& exact;            ///< for polynomials of degree terms + kernel

private:
    void set_clusters(int m);
};

} // namespace touchstone::transfer::levels
