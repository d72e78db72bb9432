// SPDX-License-Identifier: MIT
#include "touchstone/transfer/layer.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/parallel.hpp"

namespace touchstone::transfer::levels {

using std::max, std::min;
using namespace bounds;

namespace {

int add_clusters(std::vector<Cluster>& all, const std::vector<Panel>& panels, int first, int last)
{
    const int mine = static_cast<int>(all.size());
    const Real a = panels[first].z0, b = panels[last].z1;
    all.push_back({.first = first, .last = last, .a = a, .b = b, .mid = (a + b) * 0.5, .half = (b - a) * 0.5});
    if (first < last) {
        const Real middle = (panels[first].y0 + panels[last].y1) * 0.5;
        int cut = first;
        while (cut + 1 < last && panels[cut + 1].y0 < middle) ++cut;
        const int left = add_clusters(all, panels, first, cut), right = add_clusters(all, panels, cut + 1, last);
        all[mine].left = left;
        all[mine].right = right;
    }
    return mine;
}

} // namespace

double largest_density(const Kernel& k, const Cluster& c, double axis)
{
    const double half = size_of(c.half), from_begin = double(c.mid - k.begin) - half * axis, from_end = double(k.end - c.mid) - half * axis;
    const double begin = double(k.begin), end = double(k.end), far = end - from_end, G2 = double(k.G2), x = double(k.x);
    if (k.full)
        return margin * std::sqrt((std::sqrt(end) + std::sqrt(far)) * (std::sqrt(far) + std::sqrt(begin)) / (from_begin * from_end)) /
               (2 * std::sqrt(begin + from_begin));
    const double one_minus_x = double(1 - k.x), least = double(k.G) * std::sqrt(from_begin),
                 most = std::sqrt(one_minus_x * one_minus_x + G2 * far);
    return margin * G2 / (2 * least) * std::sqrt((1 + x + most) / (G2 * from_end * least));
}

double cancellation(const Kernel& k, const Cluster& c)
{
    if (!k.full) return double(k.end) / double(k.end - c.b);
    // 1 - c = G (end - z)/(end^(1/2) + z^(1/2)) at the one end of the cluster, 1 + c by the distance from the wave's begin at the other
    const double one_minus_c = double(k.end - c.b) / (std::sqrt(double(k.end)) + std::sqrt(double(c.b)));
    const double one_plus_c = double(c.a - k.begin) / (std::sqrt(double(c.a)) + std::sqrt(double(k.begin)));
    return (1 + double(k.x)) / (double(k.G) * min(one_minus_c, one_plus_c));
}

ClusterError cluster_error(const Kernel& k, const Cluster& c, int terms, double affordable)
{
    const double half = size_of(c.half), e = min(double(c.mid - k.begin), double(k.end - c.mid)) / half;
    if (!(e > 1.3)) return {infinite, infinite};
    const double axis = 1 + 0.8 * (e - 1), rho = axis + std::sqrt(axis * axis - 1);
    const double interpolation = 4 / (power(rho, terms - 1) * (rho - 1));
    // the moments of V meet the kernel's Chebyshev coefficients, which fall like rho^-k; they are sums over the panels
    const double roundings = u * (4 * terms * terms + 500 + 2 * terms * c.panels() * rho / (rho - 1) + 48 * cancellation(k, c));
    const double scale = largest_density(k, c, axis) * 2 * half / pi_below;
    if (scale * interpolation > affordable || scale * roundings > max(affordable, 4000 * u)) return {infinite, infinite};
    return {scale * (interpolation + roundings), 4 * scale}; // Lebesgue constant of up to 60 points below 4
}

RuleDisc disc_about(const Kernel& k, const Panel& p, Substitution variable, const Real& mid, const Real& width)
{
    constexpr double largest_local = 2.916;
    const Real& x = k.x;
    Real A = 0, B = 0;
    if (variable == Substitution::sine) A = k.full ? (x + 1) * (x + 1) : 4 * x, B = -4 * (x + 1);
    if (variable == Substitution::cosine) A = k.full ? (x - 1) * (x - 1) : Real(0), B = k.full ? 4 * (x - 1) : -4 * (1 - x);
    const Real q = mid * mid; // z G^2 = A + B t^2 + 4 t^4 about t = mid
    const bool square = variable == Substitution::square;
    const double half = size_of(width), middle = double(mid), G2 = double(k.G2), unit = double(p.half);
    const double off = size_of(square ? mid - p.centre : (A + B * q + 4 * q * q) / k.G2 - p.centre);
    const double a1 = size_of((2 * B + 16 * q) * mid) / G2, a2 = size_of(B + 24 * q) / G2, a3 = 16 * middle / G2, a4 = 4 / G2;
    const auto reach = [&](double d) { return margin * (off + (square ? d : d * (a1 + d * (a2 + d * (a3 + d * a4))))) / unit; };
    double d = 0, cannot = min(20 * half, square ? 0.9 * middle : 0.95 - middle);
    if (square) cannot = min(cannot, 0.9 * double(k.end - mid));
    if (reach(cannot) <= largest_local) d = cannot;
    else
        for (int step = 0; step < 12; ++step) {
            const double between = (d + cannot) / 2;
            (reach(between) <= largest_local ? d : cannot) = between;
        }
    if (!square) return {d, margin * 2 / std::sqrt(1 - (middle + d) * (middle + d))};
    const double least = double(k.root(mid - d)), most = double(k.root(mid + d));
    return {d, margin * G2 / (2 * least) *
                   std::sqrt((1 + double(x) + most) / (G2 * double(k.end - (mid + d)) * (0.7 * least + double(1 - x))))};
}

double quadrature_error(const RuleDisc& disc, double half, int points)
{
    if (!(disc.radius > 1.02 * half)) return infinite;
    const double axis = disc.radius / half, rho = axis + std::sqrt(axis * axis - 1);
    return 64.0 / 15 * half * disc.largest / pi_below / (power(rho, 2 * points - 2) * (1 - 1 / (rho * rho)));
}

double share_moved(const Kernel& k, const Real& z, double moved)
{
    const double to_end = double(k.one_minus_c(z)), to_begin = double(k.one_plus_c(z));
    if (min(to_end, to_begin) < 2 * moved) return std::sqrt(moved);
    return margin * 2 * moved / (pi_below * std::sqrt(min(to_end, 2.0) * min(to_begin, 2.0))); // 1 -+ c at least halve
}

ChebyshevPoints::ChebyshevPoints(int count) : at(count), T(static_cast<std::size_t>(count) * count)
{
    const WorkingPrecision precision(200);
    const auto cosine = [&](int p) { return to_real(ScalarTraits<Ball>::cos_pi(Ball(p) / Ball(2 * count))); };
    for (int i = 0; i < count; ++i) at.set(i, cosine(2 * i + 1));
    for (int k = 0; k < count; ++k)
        for (int i = 0; i < count; ++i) T.set(k * count + i, cosine(k * (2 * i + 1) % (4 * count)));
}

Layer::Layer(const Orders& orders_, const Gauss& gauss_, const ChebyshevPoints& points_, const Gauss& exact_, Real G_, double tolerance,
             std::vector<Panel> panels_, int count_)
    : orders(orders_)
    , gauss(gauss_)
    , G(G_)
    , affordable(tolerance / 256)
    , panels(std::move(panels_))
    , count(count_)
    , coefficients(panels.size() * orders.terms * count)
    , growth(panels.size() * count)
    , rounding(growth)
    , accurate(panels.size(), 2)
    , late(growth)
    , step((panels.size() + 1) * count)
    , jump(growth)
    , size(growth)
    , largest(count)
    , points(points_)
    , exact(exact_)
{
    for (const Panel& p : panels)
        if (!(p.z1 - p.z0 >= 2 * narrowest * p.z1))
            throw BeyondReach("a panel of the mesh is too narrow for numbers of 106 bits to tell its points apart");
    add_clusters(clusters, panels, 0, static_cast<int>(panels.size()) - 1);
    weights = Wide(clusters.size() * orders.kernel * count);
    noise.resize(clusters.size() * count);
    top = noise;
}

// ---- T V_m at a point

namespace {

/// T V_m at one x, for all m.
class AtPoint {
public:
    AtPoint(const Layer& layer_, const Real& x_, Result& out_)
        : layer(layer_), x(x_), out(out_), k(x_, layer_.G, x_ >= 1), moved(edge_moves(x_)), strip(std::sqrt(moved)),
          begin(max(k.full ? k.begin : Real(0), layer_.panels.front().z0))
    {
    }
    void run();

private:
    void charge(double share, const double* per_unit)
    {
        for (double& e : out.error) e += share * *per_unit++;
    }
    /// The same edge, rounded differently on its two sides: a share is missing, or there twice.
    void seam(const Real& z) { charge(share_moved(k, z, moved), layer.largest.data()); }
    /// The same edge, rounded alike on its two sides: on that share V is the neighbour's polynomial.
    void edge(std::size_t panel)
    {
        const Real& z = layer.panels[panel].z0;
        if (k.one_minus_c(z) == 1) seam(z); // one side may be seen from either end of the kernel
        charge(share_moved(k, z, moved), &layer.step[layer.at(panel, 0)]);
    }
    void cluster(int index, const ClusterError&);
    void direct(int panel, Real low, const Real& high);
    void piece(int panel, Substitution, const Real& low, const Real& high);

    const Layer& layer;
    const Real& x;
    Result& out;
    const Kernel k;
    const double moved;
    const double strip;
    const Real begin;
};

/// Part of a panel; limits are sin(theta/2), cos(theta/2) or z.
void AtPoint::piece(int j, Substitution variable, const Real& low, const Real& high)
{
    if (!(high > low)) return;
    const Panel& p = layer.panels[j];
    const Real mid = (low + high) * 0.5, width = (high - low) * 0.5;
    out.local.resize(layer.gauss.nodes.size());
    out.weight.resize(layer.gauss.nodes.size());
    const double measure =
        wave_nodes(k, variable, mid, width, layer.gauss.nodes, layer.gauss.weights, p.centre, p.half, out.local, out.weight);
    chebyshev_moments(out.local, out.weight, layer.orders.terms, static_cast<std::size_t>(layer.accurate[j]), out.moment);
    const double quadrature = quadrature_error(disc_about(k, p, variable, mid, width), size_of(width), layer.orders.gauss);
    for (int m = 0; m < layer.count; ++m) {
        const std::size_t at = layer.at(j, m);
        out.error[m] +=
            (layer.growth[at] == 0 ? 0 : quadrature * layer.growth[at]) + margin * measure * (layer.rounding[at] + layer.late[at]);
    }
    if (out.plan) out.plan->add(false, layer.row(j, 0), out.moment);
    if (layer.count == 1) out.value.set(0, out.value[0] + dot(layer.coefficients, layer.row(j, 0), out.moment));
    else add_products(layer.coefficients, layer.row(j, 0), out.moment, layer.count, out.value);
}

void AtPoint::direct(int j, Real low, const Real& high)
{
    if (!k.full && low < k.end / 6) { // near the edge of contact, distances are kept in z itself
        const Real cut = min(high, k.end * 0.25);
        piece(j, Substitution::square, low, cut);
        seam(cut);
        low = cut;
    }
    const double root_half = std::sqrt(0.5);
    const Real near = high >= k.end ? Real(0) : k.one_minus_c(high), far = k.one_minus_c(low);
    const Real from_below = low <= k.begin ? Real(0) : k.one_plus_c(low), to_above = k.one_plus_c(high);
    if (far <= 1) piece(j, Substitution::sine, sqrt(near * 0.5), sqrt(far * 0.5));
    else if (near >= 1) piece(j, Substitution::cosine, sqrt(from_below * 0.5), sqrt(to_above * 0.5));
    else { // the two meet at c = 0, where one unit of a limit's rounding is one of theta
        piece(j, Substitution::sine, sqrt(near * 0.5), root_half);
        piece(j, Substitution::cosine, sqrt(from_below * 0.5), sqrt(Real(1) - Real(root_half) * root_half));
    }
}

void AtPoint::cluster(int index, const ClusterError& lost)
{
    const Cluster& c = layer.clusters[index];
    wave_densities(k, c.mid, c.half, layer.points.at, out.kernel);
    const std::size_t first = static_cast<std::size_t>(index) * layer.orders.kernel * layer.count;
    if (out.plan) out.plan->add(true, first, out.kernel);
    if (layer.count == 1) out.value.set(0, out.value[0] + dot(layer.weights, first, out.kernel));
    else add_products(layer.weights, first, out.kernel, layer.count, out.value);
    const std::size_t here = static_cast<std::size_t>(index) * layer.count;
    charge(lost.total, &layer.top[here]);
    charge(lost.measure, &layer.noise[here]);
}

void AtPoint::run()
{
    const int count = layer.count;
    out.error.assign(count, 0);
    out.value = Wide(count);
    if (!(k.end > begin)) return charge(strip, layer.largest.data());
    if (k.end > layer.panels.back().z1) { // outside the mesh: nothing is known
        out.error.assign(count, infinite);
        return;
    }
    out.moment = Wide(layer.orders.terms);
    out.kernel = Wide(layer.orders.kernel);
    enum { nothing, by_cluster, by_piece } before = nothing;
    std::vector<int> waiting{0};
    int visits = 0; // each adds `terms` numbers to a sum of at most 2 largest[m]
    while (!waiting.empty()) {
        const int index = waiting.back();
        waiting.pop_back();
        const Cluster& c = layer.clusters[index];
        if (c.b <= begin || c.a >= k.end) continue;
        if (const ClusterError lost = cluster_error(k, c, layer.orders.kernel, layer.affordable);
            lost.total < infinite) { // none that an end is in
            if (before == by_piece) seam(c.a);
            before = by_cluster;
            ++visits;
            cluster(index, lost);
            continue;
        }
        if (c.left >= 0) {
            waiting.push_back(c.right);
            waiting.push_back(c.left);
            continue;
        }
        if (before == by_cluster) seam(c.a);
        if (before == by_piece) edge(static_cast<std::size_t>(c.first));
        before = by_piece;
        visits += 3;
        direct(c.first, max(c.a, begin), min(c.b, k.end));
    }
    // which panel an end of the kernel is in is decided by rounded numbers: V may be the neighbour's on an interval there
    const std::size_t at_end = static_cast<std::size_t>(layer.find(k.end)), at_begin = static_cast<std::size_t>(layer.find(begin));
    for (const std::size_t panel : {at_end, at_begin}) charge(margin * strip, &layer.jump[layer.at(panel, 0)]);
    charge(margin * u * 2 * layer.orders.terms * visits, layer.largest.data());
}

} // namespace

void Layer::apply(const Real& x, Result& out) const { AtPoint(*this, x, out).run(); }

void Plan::add(bool cluster, std::size_t first, const Wide& by)
{
    sums.push_back({cluster, first, factors.size(), by.size()});
    factors.high.insert(factors.high.end(), by.high.begin(), by.high.end());
    factors.low.insert(factors.low.end(), by.low.begin(), by.low.end());
}

Real Layer::follow(const Plan& plan) const
{
    Real total = 0;
    for (const Plan::Sum& s : plan.sums) total += dot(s.cluster ? weights : coefficients, s.first, plan.factors, s.from, s.count);
    return total;
}

void Layer::set(int m, const Wide& series)
{
    const int terms = orders.terms;
    double most = 0;
    for (std::size_t j = 0; j < panels.size(); ++j) {
        double total = 0, squares = 0, six = 0, p = 1;
        for (int k = 0; k < terms; ++k, p *= 6) {
            const Real c = series[j * terms + k];
            coefficients.set(row(j, k) + m, c);
            total += std::fabs(c.high);
            squares += static_cast<double>(k) * k * std::fabs(c.high);
            six += std::fabs(c.high) * p;
        }
        size[at(j, m)] = margin * total;
        growth[at(j, m)] = margin * six;
        // z is known within 40 u z (T and the rounding of G), |T_k'| <= k^2; recurrences for T_k lose at most 2 k^2 u
        rounding[at(j, m)] =
            margin * u * ((40 * double(panels[j].right()) / double(panels[j].half) + 2) * squares + (40 + 4 * terms) * total);
        most = max(most, size[at(j, m)]);
    }
    largest[m] = most;
    const double share = affordable / 8 * min(1.0, most); // of what a piece may take
    for (std::size_t j = 0; j < panels.size(); ++j) {
        const auto lost_from = [&](int k0) {
            double lost = 0;
            for (int k = k0; k < terms; ++k) lost += late_moment(static_cast<std::size_t>(k - k0), gauss.nodes.size()) * magnitude(j, k, m);
            return margin * lost;
        };
        while (accurate[j] < terms && !(lost_from(accurate[j]) <= share)) accurate[j] += 2;
        late[at(j, m)] = lost_from(accurate[j]);
    }
    const auto edge = [&](std::size_t j) -> double& { return step[at(j, m)]; };
    edge(0) = size[at(0, m)]; // V is 0 below the first panel
    for (std::size_t j = 1; j < panels.size(); ++j) {
        const Panel &a = panels[j - 1], &b = panels[j];
        edge(j) = margin * (size_of(value(j - 1, m, (a.z1 - a.centre) / a.half) - value(j, m, (b.z0 - b.centre) / b.half)) +
                            rounding[at(j - 1, m)] + rounding[at(j, m)]);
    }
    edge(panels.size()) = size[at(panels.size() - 1, m)];
    for (std::size_t j = 0; j < panels.size(); ++j) {
        jump[at(j, m)] = edge(j) + edge(j + 1);
        if (j > 0) jump[at(j, m)] += edge(j - 1);
        if (j + 2 <= panels.size()) jump[at(j, m)] += edge(j + 2);
    }
    set_clusters(m);
}

/// Integrals of V_m against the Lagrange polynomials of every cluster: a polynomial of degree terms + kernel - 2, exact by Gauss.
void Layer::set_clusters(int m)
{
    const std::size_t nodes = exact.nodes.size();
    Wide position(panels.size() * nodes), inside(panels.size() * nodes);
    in_parallel(panels.size(), [&](std::size_t j) {
        const Panel& p = panels[j];
        for (std::size_t g = 0; g < nodes; ++g) {
            const Real half = (p.z1 - p.z0) * 0.5, z = (p.z0 + p.z1) * 0.5 + half * exact.nodes[g];
            position.set(j * nodes + g, z);
            inside.set(j * nodes + g, half * exact.weights[g] * value(j, m, (z - p.centre) / p.half));
        }
    });
    in_parallel(clusters.size(), [&](std::size_t index) {
        const Cluster& c = clusters[index];
        const std::size_t from = static_cast<std::size_t>(c.first) * nodes, size_here = static_cast<std::size_t>(c.panels()) * nodes;
        Wide local(size_here), weight(size_here), moment(orders.kernel);
        const Real per_half = Real(1) / c.half;
        for (std::size_t i = 0; i < size_here; ++i) {
            local.set(i, (position[from + i] - c.mid) * per_half);
            weight.set(i, inside[from + i]);
        }
        chebyshev_moments(local, weight, orders.kernel, moment);
        for (int k = 1; k < orders.kernel; ++k) moment.set(k, 2 * moment[k]);
        Wide lagrange(orders.kernel);
        add_products(points.T, 0, moment, orders.kernel, lagrange);
        double lost = 0, most_here = 0;
        for (int j = c.first; j <= c.last; ++j) {
            lost += rounding[at(j, m)] * double(panels[j].z1 - panels[j].z0);
            most_here = max(most_here, size[at(j, m)]);
        }
        noise[index * count + m] = margin * lost / (2 * double(c.half));
        top[index * count + m] = most_here;
        for (int q = 0; q < orders.kernel; ++q) weights.set((index * orders.kernel + q) * count + m, lagrange[q] / orders.kernel);
    });
}

} // namespace touchstone::transfer::levels
