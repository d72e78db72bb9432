// SPDX-License-Identifier: MIT
/// T V at a point beside the same integral in balls: V with jumps of 1 at edges, on panels as narrow as can be, at ratios next to 1, to 0
/// and to where an end of the kernel meets an edge. No rounding may exceed what is claimed for it.
#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/transfer/layer.hpp"
#include "touchstone/transfer/proven_levels.hpp"

#include <doctest/doctest.h>

#include <complex>
#include <cstdlib>
#include <random>

using namespace touchstone;
using namespace touchstone::transfer;
using namespace touchstone::transfer::levels;

namespace {

/// T V_m(x) = (1/pi) int V_m dtheta, panel by panel: T_k of the local coordinate is a polynomial in c = cos theta, and int c^j dtheta is
/// known.
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
        const double x_ = arf_get_d(arb_midref(x.get()), ARF_RND_NEAR),
                     size = 4 * (std::pow((1 + std::max(1.0, x_)) / double(layer_.G), 2) + double(p.centre)) / double(p.half);
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

/// All rounds, or every other one, which has each kind of x and each place of an edge, though not each with each.
double attack(Draw& draw, int rounds, int step, double tolerance, double narrow, Series series)
{
    const Orders orders(tolerance);
    const Gauss gauss(orders.gauss), exact(orders.terms);
    const ChebyshevPoints kernel_points(orders.kernel);
    const auto terms = static_cast<std::size_t>(orders.terms);
    Worst worst;
    for (int round = step - 1; round < rounds; round += step) {
        const Real G = draw.real(1.1, 6);
        const Real x = round % 3 == 0   ? draw.real(1.0001, 6)
                       : round % 3 == 1 ? draw.real(0.01, 0.9999)
                                        : Real(1) + Real(draw.between(-1, 1) * 1e-13);
        const Kernel k(x, G, x >= 1);
        // an edge of the mesh at an end of the kernel, next to it, at c = 0, or anywhere
        const Real middle = k.full ? (x * x) / (G * G) : k.end * 0.25;
        const Real hard[] = {k.end, k.full && k.begin > Real(1e-8) ? k.begin : middle,
                             k.end * Real{1, std::ldexp(draw.between(-1, 1), -100)}, middle, k.end * draw.real(0.2, 0.95)};
        Layer layer(orders, gauss, kernel_points, exact, G, tolerance, mesh_towards(hard[(round / 3) % 5], narrow, 1e-9, 3 * double(k.end)),
                    4);
        for (int m = 0; m < 4; ++m) {
            Wide all(layer.panels.size() * terms);
            for (std::size_t j = 0; j < layer.panels.size(); ++j) {
                const bool inside = std::abs(static_cast<int>(j) - layer.find(k.end)) > 4 &&
                                    (!k.full || std::abs(static_cast<int>(j) - layer.find(k.begin)) > 4);
                for (std::size_t i = 0; i < terms; ++i) all.set(j * terms + i, series(draw, static_cast<int>(i), m, orders.terms, inside));
            }
            layer.set(m, all);
        }
        const WorkingPrecision precision(300);
        const Ball true_G = to_ball(G) * (1 + Ball::exactly((round / 2 % 2 ? 0.99 : -0.99) * bounds::u));
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
    CHECK(attack(draw, 15, 2, 1e-25, 2 * narrowest, constants) > 1e-3);
}

TEST_CASE("T V beside the same in balls: polynomials of the highest degree")
{
    Draw draw{std::mt19937_64(seed())};
    CHECK(attack(draw, 15, 1, 1e-25, 1e-6, polynomials) > 1e-6);
}

TEST_CASE("T V beside the same in balls: coefficients that fall, and with them what is asked of their moments")
{
    Draw draw{std::mt19937_64(seed())};
    CHECK(attack(draw, 15, 2, 1e-14, 1e-6, falling) > 1e-5);
}

TEST_CASE("slow: T V beside the same in balls, each kind of x with each place of an edge" * doctest::skip())
{
    Draw draw{std::mt19937_64(seed())};
    CHECK(attack(draw, 15, 1, 1e-25, 2 * narrowest, constants) > 1e-3);
    CHECK(attack(draw, 15, 1, 1e-14, 1e-6, falling) > 1e-5);
}

namespace {

void check_whole_run(double tolerance)
{
    Draw draw{std::mt19937_64(seed())};
    const Real G(1.5);
    const ProvenLevels run(Ball::exactly(1.5), 2, tolerance);
    Worst worst;
    const Layer& layer = run.layer();
    for (int i = 0; i < 6; ++i) {
        // anywhere, and where an end of the kernel meets an edge of the mesh
        const Real edge =
            sqrt(layer.panels[static_cast<std::size_t>(draw.between(0.5, 0.95) * static_cast<double>(layer.panels.size()))].z0);
        worst.compare(layer, Ball::exactly(1.5),
                      i % 2                ? draw.real(0.001, 2)
                      : edge * G > Real(2) ? edge * G - 1
                                           : edge * edge * G * G * 0.25);
    }
    MESSAGE(worst.compared << " compared, largest error: " << worst.ratio << " of what is claimed");
}

} // namespace

TEST_CASE("T V of a whole run beside the same in balls") { check_whole_run(1e-6); }
TEST_CASE("slow: T V of a whole run of more digits beside the same in balls" * doctest::skip()) { check_whole_run(1e-11); }

TEST_CASE("panels too narrow for their points to be told apart are refused")
{
    const Orders orders(1e-9);
    const Gauss gauss(orders.gauss), exact(orders.terms);
    const ChebyshevPoints kernel_points(orders.kernel);
    CHECK_THROWS_AS(Layer(orders, gauss, kernel_points, exact, Real(2), 1e-9, {panel(Real(1), Real(1) + Real(narrowest), true)}, 4),
                    BeyondReach);
}

// ---- what is charged, piece by piece

namespace {

using Complex = std::complex<long double>;

/// |dtheta/dz| at a complex z.
double density_at(const Kernel& k, const Complex& z)
{
    const long double x = double(k.x), G = double(k.G);
    const Complex R = std::sqrt((1 - x) * (1 - x) + G * G * z), root = std::sqrt(z);
    const Complex c = k.full ? G * root - x : R - x, slope = k.full ? G / (2.0L * root) : G * G / (2.0L * R);
    return static_cast<double>(std::abs(slope / std::sqrt((1.0L - c) * (1.0L + c))));
}

Cluster cluster_on(const Real& a, const Real& b, int panels = 1) { return {0, panels - 1, -1, -1, a, b, (a + b) * 0.5, (b - a) * 0.5}; }

/// The largest on an ellipse about [-1, 1] whose half axis that is, or on the circle of that radius.
template <class F>
double largest_on(double axis, bool ellipse, const F& f)
{
    double most = 0;
    for (int i = 0; i < 720; ++i) {
        const long double t = 3.14159265358979323846L * i / 360, a = axis;
        most = std::max(most, f(Complex(a * std::cos(t), (ellipse ? std::sqrt(a * a - 1) : a) * std::sin(t))));
    }
    return most;
}

const std::vector<Kernel>& some_kernels()
{
    static const std::vector<Kernel> all{{Real(1), Real(1.3), true},  {Real(1.0001), Real(2), true}, {Real(1.7), Real(1.2), true},
                                         {Real(6), Real(3), true},    {Real(0.01), Real(2), false},  {Real(0.5), Real(1.5), false},
                                         {Real(0.98), Real(3), false}};
    return all;
}

/// Of so many degrees, on so many Gauss nodes; the mesh has these edges.
struct Small {
    Orders orders;
    Gauss gauss, exact;
    ChebyshevPoints points;
    Layer layer;
    Small(double digits_of, double tolerance, const Real& G, const std::vector<Real>& edges, int count)
        : orders(digits_of)
        , gauss(orders.gauss)
        , exact(orders.terms)
        , points(orders.kernel)
        , layer(orders, gauss, points, exact, G, tolerance, panels_on(edges), count)
    {
    }
    static std::vector<Panel> panels_on(const std::vector<Real>& edges)
    {
        std::vector<Panel> all;
        for (std::size_t i = 1; i < edges.size(); ++i) all.push_back(panel(edges[i - 1], edges[i], i == 1));
        return all;
    }
    /// Coefficients of V_m from (panel, k).
    template <class F>
    void set(int m, const F& coefficient)
    {
        const auto terms = static_cast<std::size_t>(orders.terms);
        Wide all(layer.panels.size() * terms);
        for (std::size_t i = 0; i < all.size(); ++i) all.set(i, coefficient(i / terms, static_cast<int>(i % terms)));
        layer.set(m, all);
    }
};

std::vector<Real> even_edges(double from, double to, int panels)
{
    std::vector<Real> edges;
    for (int i = 0; i <= panels; ++i) edges.emplace_back(from + (to - from) * i / panels);
    return edges;
}

/// The sum of all that proven_levels.md, 2, has charged to T V_m at x.
class Charged {
public:
    Charged(const Layer& V, const Real& x, int m)
        : V_(V)
        , k_(x, V.G, x >= 1)
        , m_(static_cast<std::size_t>(m))
        , begin_(std::max(k_.full ? k_.begin : Real(0), V.panels[0].z0))
    {
        walk(0);
        const double strip = std::sqrt(edge_moves(x));
        sum_ += bounds::u * 2 * V.orders.terms * visits_ * V.largest[m_];
        for (const Real& end : {k_.end, begin_}) sum_ += strip * V.jump[at(V.find(end))];
    }
    double sum() const { return sum_; }
    int clusters() const { return clusters_; }
    int pieces() const { return pieces_; }

private:
    std::size_t at(int panel) const { return static_cast<std::size_t>(panel * V_.count) + m_; }
    double moved(const Real& z) const { return share_moved(k_, z, edge_moves(k_.x)); }
    void walk(int index)
    {
        const Cluster& c = V_.clusters[static_cast<std::size_t>(index)];
        if (c.b <= begin_ || c.a >= k_.end) return;
        const bool whole = c.a >= begin_ && c.b <= k_.end;
        const ClusterError lost =
            whole ? cluster_error(k_, c, V_.orders.kernel, V_.affordable) : ClusterError{bounds::infinite, bounds::infinite};
        if (lost.total < bounds::infinite) {
            if (last_ == 'p') sum_ += moved(c.a) * V_.largest[m_];
            last_ = 'c';
            visits_ += 1;
            ++clusters_;
            sum_ += lost.total * V_.top[at(index)] + lost.measure * V_.noise[at(index)];
        }
        else if (c.left >= 0) {
            walk(c.left);
            walk(c.right);
        }
        else {
            if (last_ == 'c') sum_ += moved(c.a) * V_.largest[m_];
            if (last_ == 'p') sum_ += moved(c.a) * (V_.step[at(c.first)] + (k_.one_minus_c(c.a) == 1 ? V_.largest[m_] : 0));
            last_ = 'p';
            visits_ += 3;
            panel(c.first, std::max(c.a, begin_), std::min(c.b, k_.end));
        }
    }
    void panel(int j, Real low, const Real& high)
    {
        if (!k_.full && low < k_.end / 6) {
            const Real cut = std::min(high, k_.end * 0.25);
            piece(j, Substitution::square, low, cut, theta(low) - theta(cut));
            sum_ += moved(cut) * V_.largest[m_];
            low = cut;
        }
        const double c_low = cosine(low), c_high = cosine(high);
        const auto sine = [&](const Real& z) { return z >= k_.end ? Real(0) : sqrt(k_.one_minus_c(z) * 0.5); };
        const auto from_below = [&](const Real& z) { return z <= k_.begin ? Real(0) : sqrt(k_.one_plus_c(z) * 0.5); };
        const double middle = std::acos(std::clamp(0.0, c_low, c_high));
        if (c_high > 0) piece(j, Substitution::sine, sine(high), c_low < 0 ? sqrt(Real(0.5)) : sine(low), middle - theta(high));
        if (c_low < 0)
            piece(j, Substitution::cosine, from_below(low), c_high > 0 ? sqrt(Real(0.5)) : from_below(high), theta(low) - middle);
    }
    void piece(int j, Substitution variable, const Real& low, const Real& high, double angle)
    {
        if (!(high > low)) return;
        ++pieces_;
        const Real mid = (low + high) * 0.5, width = (high - low) * 0.5;
        const RuleDisc disc = disc_about(k_, V_.panels[static_cast<std::size_t>(j)], variable, mid, width);
        if (V_.growth[at(j)] > 0) sum_ += quadrature_error(disc, size_of(width), V_.orders.gauss) * V_.growth[at(j)];
        sum_ += angle / bounds::pi_below * (V_.rounding[at(j)] + V_.late[at(j)]);
    }
    double cosine(const Real& z) const { return z >= k_.end ? 1 : z <= k_.begin ? -1 : double(k_.one_plus_c(z) - 1); }
    double theta(const Real& z) const { return std::acos(cosine(z)); }

    const Layer& V_;
    const Kernel k_;
    const std::size_t m_;
    const Real begin_;
    double sum_ = 0;
    char last_ = ' ';
    int visits_ = 0, clusters_ = 0, pieces_ = 0;
};

} // namespace

TEST_CASE("the density on the ellipse about a cluster is at most what is claimed, and next to an end of the kernel hardly less")
{
    for (const Kernel& k : some_kernels()) {
        CAPTURE(double(k.x));
        const Real low = k.full ? k.begin : Real(0), length = k.end - low;
        for (const double e : {1.31, 2.0, 5.0}) // the distance of the cluster's middle from one end of the kernel, in halves of the cluster
            for (const double half : {1e-6, 1e-3, 0.02, 0.2})
                for (const bool high : {false, true}) {
                    const Real h = length * half, mid = high ? k.end - h * e : low + h * e;
                    const double other = double(high ? mid - k.begin : k.end - mid) / double(h);
                    if (other < e || (!k.full && mid <= h)) continue;
                    const Cluster c = cluster_on(mid - h, mid + h);
                    const double axis = 1 + 0.8 * (e - 1);
                    const double known = largest_on(axis, true, [&](const Complex& t) {
                        return density_at(k, static_cast<long double>(double(mid)) + static_cast<long double>(double(h)) * t);
                    });
                    CAPTURE(e);
                    CAPTURE(half);
                    CAPTURE(high);
                    CHECK(largest_density(k, c, axis) > known);
                    // factors that hardly change on the ellipse are those of its worst point; where x is next to 1 none is such a one
                    const bool narrow = half <= 1e-3 && (high || double(k.x) >= 1.7 || !k.full);
                    CHECK(largest_density(k, c, axis) < known * (!narrow ? 6 : k.full ? 1.03 : 1.45));
                }
    }
}

TEST_CASE("on a cluster 1 - c and 1 + c lose as much as their distances from the kernel's ends say")
{
    for (const Kernel& k : some_kernels()) {
        const Real low = k.full ? k.begin : Real(0), length = k.end - low;
        for (const auto& [a, b] : {std::pair{0.001, 0.5}, {0.4, 0.9999}, {0.2, 0.7}}) {
            const Cluster c = cluster_on(low + length * a, low + length * b);
            const double known = k.full ? (1 + double(k.x)) / std::min(double(k.one_minus_c(c.b)), double(k.one_plus_c(c.a)))
                                        : double(k.end) / double(k.end - c.b);
            CHECK(cancellation(k, c) == doctest::Approx(known).epsilon(1e-9).scale(0));
        }
    }
}

TEST_CASE("a cluster is charged with its interpolation and with every rounding, and not used where it is too near an end or costs too much")
{
    const Kernel full(Real(2), Real(1.5), true), partial(Real(0.6), Real(1.5), false);
    for (const Kernel& k : {full, partial})
        for (const int terms : {4, 12, 60})
            for (const int panels : {1, 3000})
                for (const double half : {1e-9, 1e-3, 0.04})
                    for (const double e : {1.31, 3.0, 12.0}) {
                        const Real h = (k.end - k.begin) * half, mid = k.end - h * e;
                        const Cluster c = cluster_on(mid - h, mid + h, panels);
                        // with half a thousandth longer, as bounds are
                        const double axis = 1 + 0.8 * (e / bounds::margin - 1), rho = axis + std::sqrt(axis * axis - 1);
                        const double mass = 2 * size_of(h) * largest_density(k, c, axis) / bounds::pi_below,
                                     interpolation = 4 * std::pow(rho, 1 - terms) / (rho - 1);
                        const double damped = panels * rho / (rho - 1),
                                     roundings = bounds::u * (4.0 * terms * terms + 500 + 2 * terms * damped + 48 * cancellation(k, c));
                        const ClusterError claimed = cluster_error(k, c, terms, 1e300);
                        CHECK(claimed.total == doctest::Approx(mass * (interpolation + roundings)).epsilon(1e-9).scale(0));
                        CHECK(claimed.measure == doctest::Approx(4 * mass).epsilon(1e-9).scale(0));
                        const double least =
                            std::max(1.01 * mass * interpolation, mass * roundings > 3990 * bounds::u ? 1.01 * mass * roundings : 0);
                        CHECK(cluster_error(k, c, terms, least).total < bounds::infinite);
                        CHECK_FALSE(cluster_error(k, c, terms, 0.98 * mass * interpolation).total < bounds::infinite);
                        if (mass * roundings > 4010 * bounds::u)
                            CHECK_FALSE(cluster_error(k, c, terms, 0.98 * mass * roundings).total < bounds::infinite);
                    }
    const auto near = [](const Real& from, const Real& unit, double e) { return cluster_on(from + unit * (e - 1), from + unit * (e + 1)); };
    CHECK_FALSE(cluster_error(full, near(full.begin, Real(1e-3), 1.29), 12, 1e300).total < bounds::infinite);
    CHECK_FALSE(cluster_error(full, near(full.end, Real(1e-3), -1.29), 12, 1e300).total < bounds::infinite);
    CHECK(cluster_error(full, near(full.begin, Real(1e-3), 1.31), 12, 1e300).total < bounds::infinite);
}

TEST_CASE(
    "in the disc about the nodes of a piece no polynomial of the panel grows further than is claimed, nor does the density of the angle")
{
    for (const Kernel& k : some_kernels()) {
        const Real low = k.full ? k.begin : Real(0), length = k.end - low;
        const long double x = double(k.x), G = double(k.G);
        for (const double width : {1e-9, 1e-4, 0.03, 0.2, 0.6})
            for (const double place : {0.0, 0.05, 0.4, 0.7, 1.0})
                for (const bool first : {false, true}) {
                    const Real z0 = low + length * (place * (1 - width)) + 1e-12, z1 = z0 + length * width;
                    const Panel p = panel(z0, z1, first);
                    const Real cuts[] = {std::max(z0, low), std::min(z1, k.end)};
                    for (const Substitution variable : {Substitution::sine, Substitution::cosine, Substitution::square}) {
                        const bool square = variable == Substitution::square, sine = variable == Substitution::sine;
                        if (square && (k.full || cuts[1] > k.end * 0.9)) continue;
                        const Real from = square ? cuts[0] : sine ? sqrt(k.one_minus_c(cuts[1]) * 0.5) : sqrt(k.one_plus_c(cuts[0]) * 0.5);
                        const Real to = square ? cuts[1] : sine ? sqrt(k.one_minus_c(cuts[0]) * 0.5) : sqrt(k.one_plus_c(cuts[1]) * 0.5);
                        if (!(to > from) || (!square && double(to) > 0.8)) continue;
                        const Real mid = (from + to) * 0.5, half = (to - from) * 0.5;
                        const RuleDisc disc = disc_about(k, p, variable, mid, half);
                        const long double middle = double(mid), tail = mid.low;
                        CAPTURE(double(k.x));
                        CAPTURE(static_cast<int>(variable));
                        CAPTURE(width);
                        CAPTURE(place);
                        CAPTURE(first);
                        REQUIRE(disc.radius >= 0);
                        // the disc is of centre +- radius, where theta is
                        const double limit = square ? std::min(0.9 * double(mid), 0.9 * double(k.end - mid)) : 0.95 - double(mid);
                        CHECK(disc.radius <= std::min(limit, 20.03 * double(half)) * (1 + 1e-12));
                        const double reached = largest_on(disc.radius, false, [&](const Complex& t) {
                            const Complex v = middle + t + tail, c = sine ? 1.0L - 2.0L * v * v : 2.0L * v * v - 1.0L;
                            const Complex z = square ? v : (k.full ? (x + c) * (x + c) : (1.0L + c) * (2 * x - 1 + c)) / (G * G);
                            return static_cast<double>(
                                std::abs((z - static_cast<long double>(double(p.centre))) / static_cast<long double>(double(p.half))));
                        });
                        const double known = largest_on(disc.radius, false, [&](const Complex& t) {
                            const Complex v = middle + t;
                            return square ? density_at(k, v) : static_cast<double>(std::abs(2.0L / std::sqrt(1.0L - v * v)));
                        });
                        if (width > 1e-8) CHECK(reached <= 2.916);
                        CHECK(disc.largest >= known);
                        if (square) { // nor less than its factors are where each is largest
                            const double one_minus_x = 1 - double(k.x), z = double(mid), d = disc.radius, G2 = double(k.G2);
                            const double least = std::sqrt(one_minus_x * one_minus_x + G2 * (z - d)),
                                         most = std::sqrt(one_minus_x * one_minus_x + G2 * (z + d));
                            const double far = (1 + double(k.x) + most) / ((4 * double(k.x) - G2 * (z + d)) * (one_minus_x + least));
                            CHECK(disc.largest >= G2 / 2 / least * std::sqrt(far));
                        }
                        CHECK(disc.largest <= known * (!square ? 1.0011 : width < 1e-3 ? 1.25 : 5));
                        // as far as one of these limits, but for terms of different signs
                        const bool limited = disc.radius > 0.999 * std::min(limit, 20 * double(half));
                        CHECK((limited || reached >= (square ? 2.9 : place == 0.4 && width < 0.1 ? 2.85 : 1.2)));
                    }
                }
    }
}

TEST_CASE("Gauss's rule is charged with its bound on the disc, which is none where it does not hold the nodes")
{
    for (const double ratio : {1.03, 1.5, 4.0})
        for (const int points : {4, 12}) {
            const double rho = ratio + std::sqrt(ratio * ratio - 1),
                         known = 64.0 / 15 * 0.3 / bounds::pi_below * 7 * std::pow(rho, 2 - 2 * points) / (1 - std::pow(rho, -2));
            CHECK(quadrature_error({0.3 * ratio, 7}, 0.3, points) == doctest::Approx(known).epsilon(1e-12).scale(0));
        }
    CHECK(quadrature_error({0.3 * 1.01, 7}, 0.3, 4) == bounds::infinite);
}

TEST_CASE("an edge that rounding moves takes no larger share of the angle than is charged, nor much less")
{
    for (const double x : {0.01, 0.8, 1.0, 5.0})
        CHECK(edge_moves(Real(x)) == doctest::Approx(16 * bounds::u * (1 + x)).epsilon(1e-12).scale(0));
    const double moved = 1e-4;
    for (const Kernel& k : some_kernels())
        for (const double from_end : {0.0, 0.5, 1.9, 2.01, 2.5, 5.0, 100.0, 5000.0, 1e4})
            for (const int side : {-1, 1}) {
                const double c = side * (1 - from_end * moved), R = double(k.x) + c;
                if (!k.full && R < 1 - double(k.x)) continue; // no contact
                const double G = double(k.G), z = k.full ? R * R / (G * G) : (1 + c) * (2 * double(k.x) - 1 + c) / (G * G);
                const auto theta = [](double v) { return std::acos(std::clamp(v, -1.0, 1.0)); };
                const double known = std::max(theta(c - moved) - theta(c), theta(c) - theta(c + moved)) / 3.14159265358979,
                             claimed = share_moved(k, Real(z), moved);
                CAPTURE(double(k.x));
                CAPTURE(from_end);
                CHECK(claimed >= known * (1 - 1e-9));
                CHECK(claimed <= known * (from_end < 2 ? 5.5 : 2.01));
            }
}

TEST_CASE("sizes that follow from the tolerance; panels; powers")
{
    CHECK(Orders(1e-25).terms == 44);
    CHECK(Orders(1e-25).gauss == 32);
    CHECK(Orders(1e-25).kernel == 44);
    CHECK(Orders(1e-9).terms == 16);
    CHECK(Orders(1e-9).gauss == 12);
    CHECK(power(3, 0) == 1);
    CHECK(power(3, 1) == 3);
    CHECK(power(3, 10) == 59049);
    CHECK(size_of(Real(-2)) == doctest::Approx(2.002).epsilon(1e-12));
    const Panel p = panel(Real(4), Real(9), false), first = panel(Real(4), Real(9), true);
    CHECK(double(p.y0) == 2);
    CHECK(double(p.y1) == 3);
    CHECK(p.width() >= 1);
    CHECK(p.width() < 1.002);
    CHECK(double(p.centre) == 6.5);
    CHECK(double(p.half) == doctest::Approx(3.5).epsilon(1e-12));
    CHECK(double(p.left()) == doctest::Approx(6.5 - 0.99 * 3.5).epsilon(1e-12));
    CHECK(double(p.right()) == doctest::Approx(6.5 + 0.99 * 3.5).epsilon(1e-12));
    CHECK(double(first.half) == 2.5);
    CHECK(double(first.left()) == 4);
    CHECK(double(first.right()) == doctest::Approx(6.5 + 0.99 * 2.5).epsilon(1e-12));
}

TEST_CASE("clusters halve a mesh in y until each is one panel, and lie between its edges")
{
    std::vector<Real> edges;
    for (const double y : {0.1, 0.2, 0.25, 0.3, 0.49, 0.51, 0.52, 0.6, 0.9, 1.0, 1.7, 2.0}) edges.emplace_back(y * y);
    Small small(1e-9, 1e-9, Real(2), edges, 1);
    const auto& panels = small.layer.panels;
    const auto& all = small.layer.clusters;
    CHECK(all.size() == 2 * panels.size() - 1);
    CHECK(all[0].first == 0);
    CHECK(all[0].last == static_cast<int>(panels.size()) - 1);
    for (const Cluster& c : all) {
        const auto first = static_cast<std::size_t>(c.first), last = static_cast<std::size_t>(c.last);
        CHECK(c.panels() == c.last - c.first + 1);
        CHECK(c.a == panels[first].z0);
        CHECK(c.b == panels[last].z1);
        CHECK(double(c.mid) == doctest::Approx((double(c.a) + double(c.b)) / 2).epsilon(1e-14).scale(0));
        CHECK(double(c.half) == doctest::Approx((double(c.b) - double(c.a)) / 2).epsilon(1e-14).scale(0));
        if (c.left < 0) {
            CHECK(c.first == c.last);
            continue;
        }
        const Cluster &left = all[static_cast<std::size_t>(c.left)], &right = all[static_cast<std::size_t>(c.right)];
        CHECK(left.first == c.first);
        CHECK(left.last + 1 == right.first);
        CHECK(right.last == c.last);
        const double middle = (double(panels[first].y0) + double(panels[last].y1)) / 2;
        if (left.first < left.last) CHECK(double(panels[static_cast<std::size_t>(left.last)].y0) < middle);
        if (right.first < right.last) CHECK(double(panels[static_cast<std::size_t>(right.first)].y0) >= middle);
    }
    const auto find = [&](double y) { return small.layer.find(Real(y * y)); };
    CHECK(find(0.05) == 0);
    CHECK(find(0.1) == 0);
    CHECK(find(0.22) == 1);
    CHECK(find(0.25) == 2);
    CHECK(find(1.9) == 10);
    CHECK(find(2.5) == 10);
}

TEST_CASE("V on a mesh: its values, and the bounds on it, on its roundings and on its jumps")
{
    Small small(1e-9, 1e-9, Real(2), {Real(0.5), Real(1), Real(1.5), Real(3), Real(3.1), Real(5)}, 4);
    Layer& V = small.layer;
    const int terms = small.orders.terms;
    const std::size_t count = V.panels.size();
    const auto coefficient = [](int m, std::size_t panel, int k) {
        if (m == 0) return k == 0 ? Real(panel == 2 ? -3.0 : 1.0) : Real(0);          // jumps at both edges of the third panel
        if (m == 1) return k == 5 ? Real(0.5 + static_cast<double>(panel)) : Real(0); // one degree alone
        if (m == 2) return Real(std::pow(0.4, k) * (k % 3 == 1 ? -1 : 1) * 1e-3);     // small
        return Real(std::pow(0.55, k) * std::cos(1.7 * k + static_cast<double>(panel)));
    };
    for (int m = 0; m < 4; ++m) small.set(m, [&](std::size_t panel, int k) { return coefficient(m, panel, k); });
    const auto value = [&](std::size_t j, int m, double t) {
        double sum = 0;
        for (int k = 0; k < terms; ++k) sum += double(coefficient(m, j, k)) * std::cos(k * std::acos(t));
        return sum;
    };
    const auto close = [](double known) { return doctest::Approx(known).epsilon(0.002).scale(0); };
    for (int m = 0; m < 4; ++m) {
        CAPTURE(m);
        double largest = 0;
        for (std::size_t j = 0; j < count; ++j) {
            CAPTURE(j);
            Result out;
            V.values(j, Real(0.3), out);
            CHECK(double(V.value(j, m, Real(0.3))) == doctest::Approx(value(j, m, 0.3)).epsilon(1e-13));
            CHECK(double(out.value[static_cast<std::size_t>(m)]) == doctest::Approx(value(j, m, 0.3)).epsilon(1e-13));
            double sum = 0, squares = 0, six = 0, from_three = 0;
            for (int k = 0; k < terms; ++k) {
                const double c = std::fabs(double(coefficient(m, j, k)));
                CHECK(V.magnitude(j, k, m) == c);
                sum += c;
                squares += k * k * c;
                six += std::pow(6, k) * c;
                if (k >= 3) from_three += std::pow(2.5, k) * c;
            }
            const std::size_t at = V.at(j, m);
            largest = std::max(largest, sum);
            CHECK(V.size[at] == close(sum));
            CHECK(V.size[at] >= sum);
            CHECK(V.growth[at] == close(six));
            CHECK(V.growth[at] >= six);
            CHECK(V.growth_at(j, m, 6) == close(six));
            if (from_three > 0) CHECK(V.growth_at(j, m, 2.5, 3) == close(from_three));
            CHECK(V.growth_at(j, m, 2.5, 3) >= from_three);
            const Panel& p = V.panels[j];
            const double position = 40 * double(p.right()) / double(p.half),
                         known = bounds::u * ((position + 2) * squares + (40 + 4 * terms) * sum);
            CHECK(V.rounding[at] == close(known));
            CHECK(V.rounding[at] >= known);
        }
        CHECK(V.largest[static_cast<std::size_t>(m)] == close(largest));
        CHECK(V.largest[static_cast<std::size_t>(m)] >= largest);
        // jumps, with the roundings of both values
        std::vector<double> step;
        for (std::size_t j = 0; j <= count; ++j) {
            const auto side = [&](std::size_t panel, const Real& z) {
                return value(panel, m, double(z - V.panels[panel].centre) / double(V.panels[panel].half));
            };
            const double known = j == 0       ? V.size[V.at(0, m)]
                                 : j == count ? V.size[V.at(count - 1, m)]
                                              : std::fabs(side(j - 1, V.panels[j].z0) - side(j, V.panels[j].z0));
            step.push_back(V.step[V.at(j, m)]);
            CHECK(step[j] == doctest::Approx(known).epsilon(0.0021));
            if (j > 0 && j < count) CHECK(step[j] >= known * (1 - 1e-12) + V.rounding[V.at(j - 1, m)] + V.rounding[V.at(j, m)]);
        }
        for (std::size_t j = 0; j < count; ++j) {
            double known = 0;
            for (std::size_t edge = j == 0 ? 0 : j - 1; edge <= std::min(j + 2, count); ++edge) known += step[edge];
            CHECK(V.jump[V.at(j, m)] == doctest::Approx(known).epsilon(1e-12).scale(0));
        }
        for (std::size_t i = 0; i < V.clusters.size(); ++i) {
            const Cluster& c = V.clusters[i];
            double size = 0, rounding = 0;
            for (int j = c.first; j <= c.last; ++j) {
                const Panel& p = V.panels[static_cast<std::size_t>(j)];
                size = std::max(size, V.size[V.at(static_cast<std::size_t>(j), m)]);
                rounding += V.rounding[V.at(static_cast<std::size_t>(j), m)] * double(p.z1 - p.z0) / double(c.b - c.a);
            }
            CHECK(V.top[V.at(i, m)] == size);
            CHECK(V.noise[V.at(i, m)] == close(rounding));
            CHECK(V.noise[V.at(i, m)] >= rounding);
        }
    }
    // an edge between equal values: only roundings may jump
    CHECK(V.step[V.at(1, 0)] == close(V.rounding[V.at(0, 0)] + V.rounding[V.at(1, 0)]));
    CHECK(V.step[V.at(1, 0)] >= V.rounding[V.at(0, 0)] + V.rounding[V.at(1, 0)]);
}

TEST_CASE("moments are taken in binary64 from the first degree on from which no V's coefficients make a share of the tolerance of their "
          "roundings")
{
    for (const double scale : {1.0, 1e-5, 100.0}) {
        Small small(1e-14, 1e-14, Real(2), {Real(0.5), Real(1), Real(1.5)}, 4);
        Layer& V = small.layer;
        const int terms = small.orders.terms;
        const auto lost = [&](std::size_t j, int m, int from) {
            double sum = 0;
            for (int k = from; k < terms; ++k)
                sum += late_moment(static_cast<std::size_t>(k - from), small.gauss.nodes.size()) * V.magnitude(j, k, m);
            return sum;
        };
        for (const int m : {0, 1}) {
            small.set(m, [&](std::size_t panel, int k) { return Real(scale * std::pow((panel == 0 ? 0.4 : 0.2) + 0.05 * m, k)); });
            for (const std::size_t j : {0, 1}) {
                const double share = 1e-14 / 256 / 8 * std::min(1.0, V.largest[static_cast<std::size_t>(m)]);
                const int from = V.accurate[j];
                CHECK(from % 2 == 0);
                CHECK(from > 2);
                CHECK(V.late[V.at(j, m)] <= share);
                CHECK(V.late[V.at(j, m)] >= lost(j, m, from));
                CHECK(V.late[V.at(j, m)] <= 1.002 * lost(j, m, from));
                CHECK(1.002 * lost(j, m, from - 2) > share); // of this m, the worse of the two, which comes last
            }
        }
    }
}

TEST_CASE("a moment in binary64 is off by less than is claimed, which is what its steps and its sum make of roundings")
{
    for (const std::size_t steps : {0, 1, 2, 5, 40})
        for (const std::size_t nodes : {4, 400}) {
            // a step's 5 units grow with the steps after it, the two first numbers' units too
            double units = static_cast<double>(nodes);
            for (std::size_t j = 0; j <= steps; ++j) units += 5.0 * static_cast<double>(j + 1);
            units += static_cast<double>(2 * steps + 3);
            CHECK(late_moment(steps, nodes) >= 0x1p-53 * units);
            CHECK(late_moment(steps, nodes) <= 0x1p-53 * 1.45 * units);
        }
    Draw draw{std::mt19937_64(7)};
    for (const std::size_t count : {4, 12, 64, 68, 132}) { // 64 at a time
        Wide local(count), weight(count);
        for (std::size_t i = 0; i < count; ++i) local.set(i, draw.real(-1, 1)), weight.set(i, draw.real(-1, 1));
        double moduli = 0;
        for (std::size_t i = 0; i < count; ++i) moduli += std::fabs(weight.high[i]);
        const WorkingPrecision precision(300);
        const std::size_t terms = 24;
        std::vector<Ball> known(terms, Ball(0));
        for (std::size_t i = 0; i < count; ++i) {
            Ball before = to_ball(weight[i]), now = before * to_ball(local[i]);
            for (std::size_t k = 0; k < terms; ++k) {
                known[k] += before;
                const Ball next = 2 * to_ball(local[i]) * now - before;
                before = now;
                now = next;
            }
        }
        for (const std::size_t accurate : {2, 3, 10, 24, 30}) {
            Wide out(terms);
            chebyshev_moments(local, weight, terms, accurate, out);
            for (std::size_t k = 0; k < terms; ++k) {
                const double off = std::fabs(double(to_real(to_ball(out[k]) - known[k])));
                CAPTURE(k);
                CAPTURE(accurate);
                CAPTURE(count);
                CHECK(off <=
                      moduli * (k < accurate ? bounds::u * static_cast<double>(4 * k * k + 2 * count) : late_moment(k - accurate, count)));
            }
        }
        for (const std::size_t terms_there : {1, 2}) {
            Wide out(2);
            chebyshev_moments(local, weight, terms_there, out);
            CHECK(std::fabs(double(out[1] - (terms_there == 1 ? Real(0) : to_real(known[1])))) < 1e-25);
        }
    }
}

TEST_CASE("sums of products in 106 bits, of many columns too")
{
    Draw draw{std::mt19937_64(11)};
    const std::size_t rows = 44, columns = 8;
    Wide a(4 + rows * columns), b(rows + 4), out(columns);
    for (std::size_t i = 0; i < a.size(); ++i) a.set(i, draw.real(-1, 1));
    for (std::size_t i = 0; i < b.size(); ++i) b.set(i, draw.real(-1, 1));
    for (std::size_t m = 0; m < columns; ++m) out.set(m, draw.real(-1, 1));
    const WorkingPrecision precision(300);
    Ball one(0);
    for (std::size_t k = 0; k < rows; ++k) one += to_ball(a[4 + k]) * to_ball(b[4 + k]);
    const double claimed = 2 * static_cast<double>(rows + 4) * bounds::u * static_cast<double>(rows);
    CHECK(std::fabs(double(to_real(to_ball(dot(a, 4, b, 4, rows)) - one))) < claimed);
    std::vector<Ball> known;
    for (std::size_t m = 0; m < columns; ++m) {
        known.push_back(to_ball(out[m]));
        for (std::size_t k = 0; k < b.size() - 4; ++k) known[m] += to_ball(a[4 + k * columns + m]) * to_ball(b[k]);
    }
    b.resize(rows);
    add_products(a, 4, b, columns, out);
    for (std::size_t m = 0; m < columns; ++m) CHECK(std::fabs(double(to_real(to_ball(out[m]) - known[m]))) < claimed);
}

TEST_CASE("a wave's kernel: its ends, 1 - c and 1 + c, its density and its nodes are those of the wave, to all digits")
{
    const WorkingPrecision precision(400);
    const auto off = [](const Real& v, const Ball& known) { return std::fabs(double(to_real((to_ball(v) - known) / known))); };
    Draw draw{std::mt19937_64(13)};
    const Gauss rule(8);
    for (const double number : {0.02, 0.6, 0.999, 1.0, 1.3, 7.0}) {
        const Real x = Real(number) + Real(number == 1 ? 0 : 1e-20), G = draw.real(1.1, 4);
        const bool is_full = x >= 1;
        const Kernel k(x, G, is_full);
        const Ball bx = to_ball(x), bG = to_ball(G), least = (bx - 1) * (bx - 1) / (bG * bG);
        CAPTURE(number);
        CHECK(off(k.end, is_full ? (bx + 1) * (bx + 1) / (bG * bG) : 4 * bx / (bG * bG)) < 20 * bounds::u);
        if (number != 1) CHECK(off(k.begin, is_full ? least : -least) < 20 * bounds::u);
        CHECK(double(k.one_minus_c(k.end * Real{1, 0x1p-60})) == 0); // beyond the end
        const auto cosine = [&](const Ball& z) { return is_full ? bG * sqrt(z) - bx : sqrt((1 - bx) * (1 - bx) + bG * bG * z) - bx; };
        const auto density = [&](const Ball& z) {
            const Ball c = cosine(z), slope = is_full ? bG / (2 * sqrt(z)) : bG * bG / (2 * (bx + c));
            return slope / sqrt((1 - c) * (1 + c));
        };
        const Real low = is_full ? k.begin : Real(0), mid = low + (k.end - low) * 0.45, half = (k.end - low) * 0.3;
        Wide out(8), local(8), weight(8);
        wave_densities(k, mid, half, rule.nodes, out);
        for (std::size_t i = 0; i < 8; ++i) {
            const Ball z = to_ball(mid) + to_ball(half) * to_ball(rule.nodes[i]);
            CHECK(off(out[i], density(z) / pi<Ball>()) < 1e-28);
            CHECK(off(k.density(mid + half * rule.nodes[i]), density(z)) < 1e-28);
            CHECK(off(k.one_minus_c(mid + half * rule.nodes[i]), 1 - cosine(z)) < 1e-28);
            CHECK(off(k.one_plus_c(mid + half * rule.nodes[i]), 1 + cosine(z)) < 1e-28);
        }
        const Real centre(0.3), unit(0.7);
        for (const Substitution variable : {Substitution::sine, Substitution::cosine, Substitution::square}) {
            const bool square = variable == Substitution::square;
            const Real t_mid = square ? mid : variable == Substitution::sine ? Real(0.05) : Real(0.65), t_half = square ? half : Real(0.04);
            const double measure = wave_nodes(k, variable, t_mid, t_half, rule.nodes, rule.weights, centre, unit, local, weight);
            double sum = 0;
            for (std::size_t i = 0; i < 8; ++i) {
                const Ball t = to_ball(t_mid) + to_ball(t_half) * to_ball(rule.nodes[i]),
                           c = variable == Substitution::sine ? 1 - 2 * t * t : 2 * t * t - 1;
                const Ball z = square ? t : (is_full ? (bx + c) * (bx + c) : (1 + c) * (2 * bx - 1 + c)) / (bG * bG);
                const Ball slope = square ? density(z) : Ball(2) / sqrt(1 - t * t);
                CHECK(off(local[i], (z - to_ball(centre)) / to_ball(unit)) < 1e-28);
                CHECK(off(weight[i], to_ball(t_half) * to_ball(rule.weights[i]) * slope / pi<Ball>()) < 1e-28);
                sum += weight.high[i];
            }
            CHECK(measure == doctest::Approx(sum).epsilon(1e-13).scale(0));
        }
    }
}

TEST_CASE("the weights of a cluster integrate V times any polynomial")
{
    Small small(1e-9, 1e-9, Real(2), {Real(0.5), Real(1), Real(1.5), Real(3), Real(3.1), Real(5)}, 4);
    Layer& V = small.layer;
    for (int m = 0; m < 4; ++m)
        small.set(m, [&](std::size_t panel, int k) { return Real(std::pow(0.5, k) * std::cos(2.0 * k + static_cast<double>(panel) + m)); });
    const auto kernel = static_cast<std::size_t>(small.orders.kernel);
    for (std::size_t i = 0; i < V.clusters.size(); ++i)
        for (const int degree : {0, 1, 5, small.orders.kernel - 1})
            for (int m = 0; m < 4; ++m) {
                const Cluster& c = V.clusters[i];
                Real sum = 0, known = 0;
                for (std::size_t q = 0; q < kernel; ++q) {
                    Real p = 1;
                    for (int d = 0; d < degree; ++d) p *= small.points.at[q];
                    sum += V.weights[(i * kernel + q) * 4 + static_cast<std::size_t>(m)] * p;
                }
                for (int j = c.first; j <= c.last; ++j)
                    for (std::size_t g = 0; g < small.exact.nodes.size(); ++g) {
                        const Panel& panel = V.panels[static_cast<std::size_t>(j)];
                        const Real h = (panel.z1 - panel.z0) * 0.5, z = (panel.z1 + panel.z0) * 0.5 + h * small.exact.nodes[g];
                        Real p = 1;
                        for (int d = 0; d < degree; ++d) p *= (z - c.mid) / c.half;
                        known += h * small.exact.weights[g] * V.value(static_cast<std::size_t>(j), m, (z - panel.centre) / panel.half) * p;
                    }
                CHECK(std::fabs(double(sum - known)) < 1e-27);
            }
}

TEST_CASE(
    "T V is charged with what each piece, each cluster, each edge and each sum may be off by, and no more; and a plan is the same sum")
{
    struct Case {
        double digits, tolerance, x, G;
        std::vector<Real> edges;
        int first, last; // panels where V is
        bool clusters;
    };
    const auto even = [](double digits, double tolerance, double x, double G, double to, int panels) {
        return Case{digits, tolerance, x, G, even_edges(0.01, to, panels), 2, panels - 3, tolerance > 1e-100};
    };
    // V on one narrow panel alone, where few charges are made; edges at c = 0, or where z takes over from the sine next to the edge of
    // contact
    const std::vector<Real> full{0.01, 0.2, 0.4, 0.6, 1, 1.01, 1.4, 1.8, 2.2, 3}, partial{1e-6, 0.1, 0.4, 0.8, 0.81, 1, 1.2, 2};
    for (const Case& t : {even(1e-25, 1e-300, 2.25, 2, 4, 65), even(1e-25, 1e-300, 0.75, 1.5, 2, 64), even(1e-9, 1e-300, 2.25, 2, 4, 9),
                          even(1e-9, 1e-300, 0.75, 1.5, 2, 9), even(1e-25, 1e-25, 2.25, 2, 4, 40), even(1e-25, 1e-25, 0.75, 1.5, 2, 40),
                          even(1e-14, 1e-14, 3, 2, 4.5, 32), even(1e-25, 1e-300, 1, 2, 2, 24), Case{1e-25, 1e-300, 2, 2, full, 4, 4, false},
                          Case{1e-25, 1e-25, 2, 2, full, 4, 4, true}, Case{1e-25, 1e-300, 0.75, 1.5, partial, 3, 3, false},
                          Case{1e-25, 1e-25, 0.75, 1.5, partial, 3, 3, true}, Case{1e-25, 1e-300, 0.9, 1.5, partial, 3, 3, false}}) {
        CAPTURE(t.x);
        CAPTURE(t.digits);
        Small small(t.digits, t.tolerance, Real(t.G), t.edges, 4), single(t.digits, t.tolerance, Real(t.G), t.edges, 1);
        const auto coefficient = [&](int m, std::size_t panel, int k) {
            const int j = static_cast<int>(panel);
            if (j < t.first || j > t.last) return Real(0);
            if (m == 0) return Real(k == 0 ? 1 : 0);
            if (m == 1) return Real(k == 0 ? (j % 2 ? 1 : -1) : 0);
            if (m == 2) return Real(k == 6 ? 1 : 0);
            return Real(std::pow(0.3, k) * 0.1);
        };
        for (int m = 0; m < 4; ++m) small.set(m, [&](std::size_t panel, int k) { return coefficient(m, panel, k); });
        single.set(0, [&](std::size_t panel, int k) { return coefficient(3, panel, k); });
        Result out, alone;
        small.layer.apply(Real(t.x), out);
        levels::Plan plan;
        alone.plan = &plan;
        single.layer.apply(Real(t.x), alone);
        CHECK(std::fabs(double(alone.value[0] - out.value[3])) < 1e-13);
        CHECK(std::fabs(double(single.layer.follow(plan) - alone.value[0])) < 1e-28);
        CHECK(plan.memory() >= plan.factors.size() * 2 * sizeof(double) + plan.sums.size() * sizeof(levels::Plan::Sum));
        for (int m = 0; m < 4; ++m) {
            const Charged charged(small.layer, Real(t.x), m);
            CAPTURE(m);
            CHECK(charged.pieces() > 0);
            CHECK((charged.clusters() > 0) == t.clusters);
            CHECK(out.error[static_cast<std::size_t>(m)] == doctest::Approx(charged.sum()).epsilon(0.003).scale(0));
        }
    }
}

TEST_CASE("T 1 is the share in contact to all digits, with an edge of the mesh at an end of the kernel, or at its middle, too")
{
    Draw draw{std::mt19937_64(17)};
    for (const double number : {0.003, 0.9, 1.05, 1.2, 1.5, 1.9, 2.6, 4.0}) {
        const Real x = draw.real(0.999 * number, number), G = draw.real(1.2, 2); // edges are as far from the ends as rounding makes them
        const bool is_full = x >= 1;
        const Kernel k(x, G, is_full);
        const Real low = is_full ? k.begin : Real(1e-40);
        std::vector<Real> edges{low * 0.1, low * 0.2, low * 0.5, low};
        if (!is_full)
            for (Real z = 1e-39; z < k.end * 0.03; z *= 16) edges.push_back(z);
        for (int i = 1; i < 32; ++i) edges.push_back(low + (k.end - low) * (static_cast<double>(i) / 32));
        for (const Real& z : {k.end, k.end * 1.1, k.end * 1.3, k.end * 1.5}) edges.push_back(z);
        Small small(1e-25, 1e-25, G, edges, 1);
        small.set(0, [&](std::size_t, int c) { return Real(c == 0 ? 1 : 0); });
        Result out;
        small.layer.apply(k.x, out);
        const WorkingPrecision precision(300);
        const Ball known = is_full ? Ball(1) : 2 * asin(sqrt(to_ball(k.x))) / pi<Ball>();
        CAPTURE(number);
        CHECK(std::fabs(double(to_real(to_ball(out.value[0]) - known))) < 1e-24);
    }
    // an edge at c = 0, too
    Small small(1e-25, 1e-25, Real(2), even_edges(1.0 / 16, 3, 47), 1);
    small.set(0, [&](std::size_t, int c) { return Real(c == 0 ? 1 : 0); });
    Result out;
    small.layer.apply(Real(2), out);
    CHECK(small.layer.panels[15].z0 == 1);
    CHECK(std::fabs(double(out.value[0] - 1)) < 1e-24);
}

TEST_CASE("beyond the mesh nothing is known of T V, below it V is nothing")
{
    Small small(1e-9, 1e-9, Real(2), {Real(0.5), Real(1), Real(1.5)}, 4);
    for (int m = 0; m < 4; ++m) small.set(m, [&](std::size_t, int k) { return Real(k == 0 ? 1 + m : 0); });
    Result out;
    small.layer.apply(Real(2), out);
    for (const double e : out.error) CHECK(e == bounds::infinite);
    small.layer.apply(Real(0.3), out);
    for (std::size_t m = 0; m < 4; ++m) {
        const double known = std::sqrt(edge_moves(Real(0.3))) * (1 + static_cast<double>(m));
        CHECK(out.error[m] >= known);
        CHECK(out.error[m] <= 1.01 * known);
        CHECK(double(out.value[m]) == 0);
    }
    small.layer.apply(Real(0.5), out); // as far as the first edge, and no further
    CHECK(double(out.value[0]) == 0);
    // up to the very end of the mesh
    const Real x(std::sqrt(1.5) * 2 - 1);
    small.layer.apply(x * Real(1 - 1e-9), out);
    CHECK(out.error[0] < bounds::infinite);
    CHECK(double(out.value[0]) > 0.1);
}

TEST_CASE("T V beside the same in balls, on few panels")
{
    Draw draw{std::mt19937_64(seed())};
    CHECK(attack(draw, 6, 1, 1e-9, 1e-2, constants) > 1e-6);
    CHECK(attack(draw, 6, 1, 1e-9, 1e-1, polynomials) > 1e-9);
    CHECK(attack(draw, 6, 1, 1e-9, 1e-1, falling) > 1e-9);
}
