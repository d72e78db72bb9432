// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/ellipse_rule.hpp"

#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <cmath>
#include <list>
#include <sstream>

#if __has_include(<flint/arb_hypgeom.h>)
#include <flint/arb_hypgeom.h>
#else
#include <arb_hypgeom.h>
#endif

namespace touchstone::quadrature {

GaussNodes::GaussNodes(long n, slong bits)
    : n_(n)
    , bits_(bits)
{
    const WorkingPrecision precision(bits);
    const Ball quarter = pi<Ball>() / Ball(4);
    entries_.resize(static_cast<std::size_t>((n + 1) / 2));
    for (long k = 0; k < (n + 1) / 2; ++k) { // roots in descending order
        Entry& e = entries_[static_cast<std::size_t>(k)];
        arb_hypgeom_legendre_p_ui_root(e.z.get(), e.weight.get(), static_cast<ulong>(n), static_cast<ulong>(k), bits);
        const Ball angle = quarter + quarter * e.z;
        arb_sin_cos(e.sine.get(), e.cosine.get(), angle.get(), bits);
    }
}

std::shared_ptr<const GaussNodes> GaussNodes::get(long n, slong bits)
{
    thread_local std::list<std::shared_ptr<const GaussNodes>> cache;
    for (auto it = cache.begin(); it != cache.end(); ++it)
        if ((*it)->n_ == n && (*it)->bits_ >= bits && (*it)->bits_ <= bits + bits / 4 + 64) {
            cache.splice(cache.begin(), cache, it);
            return cache.front();
        }
    constexpr std::size_t most = 24;
    cache.push_front(std::shared_ptr<const GaussNodes>(new GaussNodes(n, (bits + 63) / 64 * 64)));
    if (cache.size() > most) cache.pop_back();
    return cache.front();
}

namespace {

/// Ball that holds [a, b].
Ball between(double a, double b)
{
    return hull(Ball::exactly(a), Ball::exactly(b));
}

/// Few values of n, so that tables of nodes are shared.
long rounded_count(double n)
{
    constexpr double coarse = 16;
    long step = 1;
    while (n / static_cast<double>(step) > coarse) step *= 2;
    return std::max(4L, static_cast<long>(std::ceil(n / static_cast<double>(step))) * step);
}

class EllipseProof {
public:
    EllipseProof(const EllipseFunction& f, double bits)
        : f_(f)
        , bits_(bits)
    {
    }
    struct Ellipse {
        double sigma;
        Ball bound; ///< of |F|
    };
    /// The ellipse that asks for the fewest nodes, of those tried.
    std::optional<Ellipse> best(double log2_tolerance);
    long pieces = 0;

private:
    ComplexBall value(double s1, double s2, double phi1, double phi2);
    bool is_covered(double s1, double s2, double phi1, double phi2, double smallest, long budget, Ball& bound);
    std::optional<Ellipse> largest_proved();
    Ball bound_on(double sigma);

    const EllipseFunction& f_;
    double bits_;
};

constexpr double half_turn = 3.1416; // a little more than pi

/// F on cosh(s + i phi), as balls of cosh s cos phi and sinh s sin phi.
ComplexBall EllipseProof::value(double s1, double s2, double phi1, double phi2)
{
    ++pieces;
    const Ball s = between(s1, s2), phi = between(phi1, phi2);
    Ball sine, cosine, sinh_s, cosh_s;
    arb_sin_cos(sine.get(), cosine.get(), phi.get(), strip_bits);
    arb_sinh_cosh(sinh_s.get(), cosh_s.get(), s.get(), strip_bits);
    return f_.in_plane(ComplexBall(cosh_s * cosine, sinh_s * sine));
}

/// Whether F is analytic on the boxes, halved down to the smallest; `bound` becomes one of |F| there too.
bool EllipseProof::is_covered(double s1, double s2, double phi1, double phi2, double smallest, long budget, Ball& bound)
{
    if (pieces >= budget) return false;
    if (const ComplexBall y = value(s1, s2, phi1, phi2); y.is_finite()) {
        const Ball size = upper_ball(y);
        if (arb_gt(size.get(), bound.get())) bound = size;
        return true;
    }
    const double height = s2 - s1, width = phi2 - phi1;
    if (height <= smallest && width <= smallest) return false;
    if (width > height) {
        const double phi = (phi1 + phi2) / 2;
        return is_covered(s1, s2, phi1, phi, smallest, budget, bound) && is_covered(s1, s2, phi, phi2, smallest, budget, bound);
    }
    const double s = (s1 + s2) / 2;
    return is_covered(s, s2, phi1, phi2, smallest, budget, bound) && is_covered(s1, s, phi1, phi2, smallest, budget, bound);
}

/// The upper half of the ellipse is enough: F is real on the real line. A value in the plane costs about two at nodes.
std::optional<EllipseProof::Ellipse> EllipseProof::largest_proved()
{
    constexpr double first = 2.0 / 3, second = 0.3, highest = 3, few_pieces = 30, least_saved = 16, step = 2.25;
    std::optional<Ellipse> proved;
    std::optional<double> failed;
    const auto nodes = [&](double sigma) { return bits_ * M_LN2 / (2 * sigma); };
    const auto try_up_to = [&](double sigma, double below, double allowance) {
        Ball bound = proved ? proved->bound : Ball(0);
        if (is_covered(below, sigma, 0, half_turn, (sigma - below) / 4, pieces + static_cast<long>(allowance), bound))
            proved = Ellipse{sigma, bound};
        else
            failed = sigma;
    };
    for (const double sigma : {first, second})
        if (!proved) try_up_to(sigma, 0, few_pieces + nodes(sigma) / 10);
    while (proved) {
        const double middle = failed ? (proved->sigma + *failed) / 2 : std::min(highest, step * proved->sigma);
        const double saved = nodes(proved->sigma) - nodes(middle);
        if (saved < least_saved) break;
        try_up_to(middle, proved->sigma, saved / 2);
    }
    return proved;
}

/// Of |F| on the boundary: the box with the largest bound is halved as long as that lowers the bound.
Ball EllipseProof::bound_on(double sigma)
{
    struct Arc {
        double phi1, phi2;
        Ball size;
    };
    constexpr int at_first = 4, most_halvings = 12;
    constexpr double worth_while = 1; // in bits
    std::vector<Arc> arcs;
    const auto add = [&](double phi1, double phi2) { arcs.push_back({phi1, phi2, upper_ball(value(sigma, sigma, phi1, phi2))}); };
    for (int k = 0; k < at_first; ++k) add(half_turn * k / at_first, half_turn * (k + 1) / at_first);
    const auto smaller = [](const Arc& a, const Arc& b) {
        return !b.size.is_finite() || (a.size.is_finite() && arb_lt(a.size.get(), b.size.get()));
    };
    for (int k = 0; k < most_halvings; ++k) {
        const auto largest = std::max_element(arcs.begin(), arcs.end(), smaller);
        const Arc halved = *largest;
        arcs.erase(largest);
        const double phi = (halved.phi1 + halved.phi2) / 2;
        add(halved.phi1, phi);
        add(phi, halved.phi2);
        const Ball after = std::max_element(arcs.begin(), arcs.end(), smaller)->size;
        if (after.is_finite() && halved.size.is_finite() && log2_upper(halved.size) - log2_upper(after) < worth_while) break;
    }
    return std::max_element(arcs.begin(), arcs.end(), smaller)->size;
}

std::optional<EllipseProof::Ellipse> EllipseProof::best(double log2_tolerance)
{
    constexpr double high = 1.25, least = 0.05;
    auto best = largest_proved();
    if (!best) return std::nullopt;
    const auto height = [&](const Ball& bound) { return log2_upper(bound) - log2_tolerance; }; // in bits: nodes go by it, over sigma
    if (height(best->bound) < high * bits_) return best;
    best->bound = bound_on(best->sigma);
    double sigma = best->sigma;
    for (;;) {
        if (best->bound.is_finite() && height(best->bound) < high * bits_) break; // a smaller ellipse can't save what its height costs
        // as if the height grew like the square of sigma, as that of a Gaussian does
        const double excess = best->bound.is_finite() ? height(best->bound) / bits_ - 1 : 9;
        sigma *= std::clamp(std::sqrt(1 / excess), 0.2, 0.6);
        if (sigma < least) break;
        Ellipse other{sigma, bound_on(sigma)};
        if (!other.bound.is_finite()) continue;
        if (best->bound.is_finite() && height(other.bound) / sigma > height(best->bound) / best->sigma) break;
        best = std::move(other);
    }
    return best->bound.is_finite() ? best : std::nullopt;
}

struct Sum {
    Ball value{0}, absolute{0};
};

Sum sum_of(const EllipseFunction& f, long n, slong bits)
{
    const auto nodes = GaussNodes::get(n, bits);
    const WorkingPrecision precision(bits);
    Sum sum;
    const auto& entries = nodes->entries();
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const bool is_middle = n % 2 != 0 && k + 1 == entries.size();
        for (const bool mirrored : {false, true}) {
            if (mirrored && is_middle) continue;
            const Ball y = f.at_node(entries[k], mirrored);
            arb_addmul(sum.value.get(), y.get(), entries[k].weight.get(), bits);
            const Ball size = upper_ball(y);
            arb_addmul(sum.absolute.get(), size.get(), entries[k].weight.get(), strip_bits);
        }
    }
    return sum;
}

} // namespace

std::string EllipseIntegral::proof(const Ball& scale) const
{
    const Ball size = touchstone::abs(scale), rounding = radius_of(value) * size;
    std::ostringstream text;
    text.precision(4);
    text << "|f| <= " << bound_text(bound * size) << " on the ellipse with the ends for foci, rho = " << std::exp(sigma) << ", in at most " << pieces
         << " boxes; |discretisation| <= " << bound_text(discretisation * size) << ", with rounding <= " << bound_text(rounding);
    return text.str();
}

std::optional<EllipseIntegral> by_ellipse(const EllipseFunction& f, double bits, bool of_absolute, long most_nodes)
{
    constexpr long rough = 8;          // nodes that show the size
    constexpr double believed = 10;    // bits that may cancel, where the rough values show that some do
    constexpr int most_attempts = 3;
    constexpr slong guard = 12;
    Sum first = sum_of(f, rough, strip_bits);
    if (!first.value.is_finite() || !first.absolute.is_finite()) return std::nullopt;
    const double absolute = log2_upper(first.absolute);
    if (!std::isfinite(absolute)) return std::nullopt;
    const double rough_size = log2_upper(first.value);
    const double size = of_absolute || rough_size > absolute - 1 ? absolute - 1 : absolute - believed;
    double log2_tolerance = size - bits - 2;
    EllipseProof proof(f, bits);
    const WorkingPrecision coarse(strip_bits);
    const auto ellipse = proof.best(log2_tolerance);
    if (!ellipse) return std::nullopt;
    EllipseIntegral out;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        const double wanted = (log2_upper(ellipse->bound) - log2_tolerance + 3 - std::log2(1 - std::exp(-2 * ellipse->sigma))) * M_LN2;
        const long n = rounded_count(std::max(4.0, wanted / (2 * ellipse->sigma)));
        if (n > most_nodes) return std::nullopt;
        const slong precision = std::max<slong>(strip_bits, static_cast<slong>(absolute - log2_tolerance) + guard);
        Sum sum = sum_of(f, n, precision);
        if (!sum.value.is_finite()) return std::nullopt;
        const Ball discretisation = upper_ball(lemma::gauss_legendre(ellipse->bound, Ball::exactly(ellipse->sigma), n));
        widen(sum.value, discretisation);
        out = {sum.value, out.nodes + n, proof.pieces, ellipse->sigma, ellipse->bound, discretisation};
        const double shortfall = bits - static_cast<double>(out.value.relative_bits());
        if (shortfall <= 0 || of_absolute) break;
        log2_tolerance -= std::min(shortfall + 2, bits);
    }
    return out;
}

} // namespace touchstone::quadrature
