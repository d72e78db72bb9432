// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/ellipse_rule.hpp"

#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>

namespace touchstone::quadrature {

namespace {

/// Ball that holds [a, b].
Ball between(double a, double b) { return hull(Ball::exactly(a), Ball::exactly(b)); }

Ball middle_of(const Ball& x)
{
    Ball m;
    arb_set_arf(m.get(), arb_midref(x.get()));
    return m;
}

/// Few values of n, so that tables of nodes are shared.
long rounded_count(double n)
{
    constexpr double coarse = 16;
    long step = 1;
    while (n / static_cast<double>(step) > coarse) step *= 2;
    return std::max(4L, static_cast<long>(std::ceil(n / static_cast<double>(step))) * step);
}

constexpr double half_turn = 3.1416; // a little more than pi

/// z = cosh(s + i phi) on a box, as balls of cosh s cos phi and sinh s sin phi.
EllipseBox box_of(double s1, double s2, double phi1, double phi2)
{
    const WorkingPrecision precision(strip_bits);
    const Ball s = between(s1, s2), phi = between(phi1, phi2);
    Ball sine, cosine, sinh_s, cosh_s;
    arb_sin_cos(sine.get(), cosine.get(), phi.get(), strip_bits);
    arb_sinh_cosh(sinh_s.get(), cosh_s.get(), s.get(), strip_bits);
    EllipseBox box{ComplexBall(cosh_s * cosine, sinh_s * sine), {}, {}, {}};
    if (phi1 >= half_turn / 2) box.side = Side::left;
    if (phi2 <= half_turn / 2) box.side = Side::right;
    const ComplexBall angle = (ComplexBall(1) + box.z) * ComplexBall(pi<Ball>() / Ball(4));
    acb_sin_cos(box.sine.get(), box.cosine.get(), angle.get(), strip_bits);
    return box;
}

/// The same boxes come back for each integrand.
const EllipseBox& kept_box(double s1, double s2, double phi1, double phi2)
{
    constexpr std::size_t most = 4000;
    thread_local std::map<std::array<double, 4>, EllipseBox> boxes;
    const std::array<double, 4> key{s1, s2, phi1, phi2};
    if (const auto found = boxes.find(key); found != boxes.end()) return found->second;
    if (boxes.size() > most) boxes.clear();
    return boxes.emplace(key, box_of(s1, s2, phi1, phi2)).first->second;
}

/// Bounds M_k, in the order of the weights.
using Bounds = std::vector<Ball>;

class EllipseProof {
public:
    /// `guess`: about the sigma of the largest ellipse; `closer_guess` says it again from more nodes; ellipses that ask for more than
    /// `most_nodes` are of no use.
    EllipseProof(const EllipseFunction& f, double bits, double guess, std::function<double()> closer_guess, long most_nodes)
        : f_(f)
        , bits_(bits)
        , guess_(guess)
        , closer_guess_(std::move(closer_guess))
        , most_nodes_(static_cast<double>(most_nodes))
    {
    }
    struct Ellipse {
        double sigma;
        Bounds bounds;
    };
    /// The ellipse that asks for the fewest nodes, of those tried.
    std::optional<Ellipse> best(double log2_tolerance);
    /// About as many nodes bring the error down to 2^log2_tolerance.
    double nodes_for(const Ellipse&, double log2_tolerance) const;
    long pieces = 0;

private:
    std::optional<Bounds> value(double s1, double s2, double phi1, double phi2);
    bool is_covered(double s1, double s2, double phi1, double phi2, double smallest, long budget, Bounds& bounds);
    void try_up_to(double sigma, double below, double most_boxes);
    void search_from(double sigma, int attempts, double log2_tolerance, double most_boxes);
    double nodes_at(double sigma, double log2_tolerance) const;
    double turn() const { return f_.is_even ? half_turn / 2 : half_turn; } ///< phi up to here is enough
    std::optional<Ellipse> largest_proved(double log2_tolerance);
    std::optional<Bounds> bounds_on(double sigma);

    const EllipseFunction& f_;
    double bits_, guess_;
    std::function<double()> closer_guess_;
    double most_nodes_;
    std::optional<Ellipse> proved_;          // the largest so far
    std::optional<double> failed_;           // the smallest sigma above it that was not proved
    double failed_from_ = 0, failed_to_ = 0; // phi, where that was
    std::vector<ComplexBall> values_;
    std::vector<Ball> middles_; // m_k: of the first box looked at
};

constexpr long closer_nodes = 48; // that show how far F is analytic where the first, fewer ones don't
constexpr int boxes_of_a_bound = 4; // that the boundary takes, of an even F half of them
constexpr int parts_after_a_failure = 4; // of the turn, to begin with: wider boxes have failed
constexpr double shrunk = 0.7;    // times the sigma of an ellipse that failed: the next to be tried

void take_larger(Ball& a, const Ball& b)
{
    if (arb_gt(b.get(), a.get())) a = b;
}

void take_larger(Bounds& all, const Bounds& some)
{
    if (all.empty()) all.resize(some.size());
    for (std::size_t k = 0; k < some.size(); ++k) take_larger(all[k], some[k]);
}

/// Bounds of |c_k - m_k| on the box; of an even F for the mirror images as well, that is on the box and its own mirror image.
std::optional<Bounds> EllipseProof::value(double s1, double s2, double phi1, double phi2)
{
    ++pieces;
    f_.in_plane(kept_box(s1, s2, phi1, phi2), values_);
    if (!std::all_of(values_.begin(), values_.end(), [](const ComplexBall& c) { return c.is_finite(); })) return std::nullopt;
    const bool first = middles_.empty();
    Bounds sizes;
    for (std::size_t k = 0; k < values_.size(); ++k) {
        const std::size_t partner = f_.partner(k);
        if (first) middles_.push_back(partner < k ? middles_[partner] : middle_of(values_[k].real()));
        sizes.push_back(upper_ball(values_[k] - ComplexBall(middles_[k])));
        if (partner >= k) continue;
        take_larger(sizes[k], sizes[partner]);
        sizes[partner] = sizes[k];
    }
    return sizes;
}

/// Whether F is analytic on the boxes, halved down to the smallest; `bounds` become such that hold there too.
bool EllipseProof::is_covered(double s1, double s2, double phi1, double phi2, double smallest, long budget, Bounds& bounds)
{
    if (pieces >= budget) return false;
    if (const auto sizes = value(s1, s2, phi1, phi2)) {
        take_larger(bounds, *sizes);
        return true;
    }
    const double height = s2 - s1, width = phi2 - phi1;
    if (height <= smallest && width <= smallest) {
        failed_from_ = phi1;
        failed_to_ = phi2;
        return false;
    }
    if (width > height) {
        const double phi = (phi1 + phi2) / 2;
        return is_covered(s1, s2, phi1, phi, smallest, budget, bounds) && is_covered(s1, s2, phi, phi2, smallest, budget, bounds);
    }
    const double s = (s1 + s2) / 2;
    return is_covered(s, s2, phi1, phi2, smallest, budget, bounds) && is_covered(s1, s, phi1, phi2, smallest, budget, bounds);
}

/// By the rates exp(-2 sigma) a node beside the weight 1 and exp(-sigma) beside the others.
double EllipseProof::nodes_for(const Ellipse& e, double log2_tolerance) const
{
    double most = 0;
    for (std::size_t k = 0; k < e.bounds.size(); ++k) {
        const bool one = f_.weights[k].is_one();
        const double bits = log2_upper(e.bounds[k]) - log2_tolerance - std::log2(1 - std::exp(-(one ? 2 : 1) * e.sigma));
        most = std::max(most, bits * M_LN2 / ((one ? 2 : 1) * e.sigma));
    }
    return most;
}

/// The upper half of the ellipse is enough: F is real on the real line; the right half of that, where F is even. What lies up to `below` is
/// proved already.
void EllipseProof::try_up_to(double sigma, double below, double most_boxes)
{
    Bounds bounds = proved_ ? proved_->bounds : Bounds();
    const double smallest = (sigma - below) / 4;
    const long budget = pieces + static_cast<long>(most_boxes);
    // where the one before failed this one will fail first
    const bool likely = failed_to_ <= failed_from_ || is_covered(below, sigma, failed_from_, failed_to_, smallest, budget, bounds);
    const int parts = failed_ ? parts_after_a_failure : 1;
    bool covered = likely;
    for (int k = 0; k < parts && covered; ++k)
        covered = is_covered(below, sigma, turn() * k / parts, turn() * (k + 1) / parts, smallest, budget, bounds);
    if (covered)
        proved_ = Ellipse{sigma, bounds};
    else
        failed_ = sigma;
}

/// About as many nodes the ellipse asks for, its bounds taken to be as large as on the one that is proved.
double EllipseProof::nodes_at(double sigma, double log2_tolerance) const
{
    if (proved_) return nodes_for(*proved_, log2_tolerance) * proved_->sigma / sigma;
    const bool plain = std::all_of(f_.weights.begin(), f_.weights.end(), [](const SingularWeight& w) { return w.is_one(); });
    return bits_ * M_LN2 / ((plain ? 2 : 1) * sigma);
}

/// That ellipse or a smaller one, in so many boxes each.
void EllipseProof::search_from(double sigma, int attempts, double log2_tolerance, double most_boxes)
{
    for (; attempts > 0 && !proved_ && nodes_at(sigma, log2_tolerance) <= most_nodes_; --attempts, sigma *= shrunk)
        try_up_to(sigma, 0, most_boxes);
}

std::optional<EllipseProof::Ellipse> EllipseProof::largest_proved(double log2_tolerance)
{
    constexpr double highest = 3, trusted = 0.8, beyond = 1.25, unguided = 2.0 / 3, step = 2.25;
    constexpr double likely = 0.65; // of a guess so high that nothing was made of it
    constexpr double few_boxes = 70, very_few_boxes = 24, a_glance = 16, least_saved = 16; // boxes, and nodes
    constexpr int attempts = 3;
    constexpr long easily = 4; // boxes: then the guess was far too cautious, as for waves that few nodes do not resolve
    bool is_guided = guess_ < highest;
    const auto look_closer = [&] {
        guess_ = closer_guess_();
        is_guided = guess_ < highest;
        if (is_guided && failed_) failed_ = std::min(*failed_, beyond * guess_); // none failed where none was worth a try
    };
    if (!is_guided) {
        search_from(unguided, 1, log2_tolerance, very_few_boxes);
        if (!proved_) look_closer();
    }
    // an ellipse that is of no use is not tried where one as large as the guess is of some
    const double useful = nodes_at(1, log2_tolerance) / most_nodes_, trusting = std::max(trusted * guess_, std::min(guess_, useful));
    const double first = failed_ ? std::min(trusting, unguided * shrunk) : trusting;
    if (!proved_) search_from(first, failed_ ? attempts - 1 : attempts, log2_tolerance, few_boxes);
    // where bounds are as large as exp(10^9) nodes are saved for nobody
    const auto worth = [&](double sigma) { return std::min(nodes_at(sigma, log2_tolerance), 2 * most_nodes_); };
    while (proved_ && (!is_guided || failed_ || pieces <= easily)) {
        const bool is_blind = !is_guided && !failed_;
        const double farthest = failed_ ? (proved_->sigma + *failed_) / 2 : std::min(highest, step * proved_->sigma);
        const double next = likely * guess_ > proved_->sigma ? std::min(farthest, likely * guess_) : farthest;
        const double saved = worth(proved_->sigma) - worth(farthest);
        if (saved < least_saved) break;
        try_up_to(next, proved_->sigma, is_blind ? std::min(a_glance, saved / f_.nodes_a_box) : saved / f_.nodes_a_box);
        if (is_blind && failed_ && worth(proved_->sigma) - worth(*failed_) > closer_nodes) look_closer();
    }
    return proved_;
}

/// On the boundary: the box with the largest bound is halved as long as that lowers the bound.
std::optional<Bounds> EllipseProof::bounds_on(double sigma)
{
    struct Arc {
        double phi1, phi2;
        std::optional<Bounds> sizes;
        double bits; // log2 of the largest
    };
    const int at_first = f_.is_even ? boxes_of_a_bound / 2 : boxes_of_a_bound;
    constexpr int most_halvings = 12;
    constexpr double worth_while = 1; // in bits
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    std::vector<Arc> arcs;
    const auto add = [&](double phi1, double phi2) {
        Arc arc{phi1, phi2, value(sigma, sigma, phi1, phi2), unbounded};
        if (arc.sizes) {
            arc.bits = -unbounded;
            for (const Ball& b : *arc.sizes) arc.bits = std::max(arc.bits, log2_upper(b));
        }
        arcs.push_back(std::move(arc));
    };
    for (int k = 0; k < at_first; ++k) add(turn() * k / at_first, turn() * (k + 1) / at_first);
    const auto smaller = [](const Arc& a, const Arc& b) { return a.bits < b.bits; };
    for (int k = 0; k < most_halvings; ++k) {
        const auto largest = std::max_element(arcs.begin(), arcs.end(), smaller);
        const Arc halved = *largest;
        arcs.erase(largest);
        const double phi = (halved.phi1 + halved.phi2) / 2;
        add(halved.phi1, phi);
        add(phi, halved.phi2);
        const double after = std::max_element(arcs.begin(), arcs.end(), smaller)->bits;
        if (std::isfinite(after) && std::isfinite(halved.bits) && halved.bits - after < worth_while) break;
    }
    Bounds all;
    for (const Arc& a : arcs) {
        if (!a.sizes) return std::nullopt;
        take_larger(all, *a.sizes);
    }
    return all;
}

std::optional<EllipseProof::Ellipse> EllipseProof::best(double log2_tolerance)
{
    constexpr double high = 1.25, least = 0.05;
    const auto proved = largest_proved(log2_tolerance);
    if (!proved) return std::nullopt;
    const auto nodes_of_one = [&](const Ellipse& e) { return nodes_for({e.sigma, Bounds(e.bounds.size(), Ball(1))}, -bits_); };
    // nodes as many times as a bound of 1 would take
    const auto excess = [&](const Ellipse& e) { return nodes_for(e, log2_tolerance) / nodes_of_one(e); };
    const double saved = nodes_for(*proved, log2_tolerance) - nodes_of_one(*proved); // at the most
    if (excess(*proved) < high || saved < f_.nodes_a_box * boxes_of_a_bound) return proved;
    std::optional<Ellipse> best;
    double sigma = proved->sigma;
    if (auto bounds = bounds_on(sigma)) best = Ellipse{sigma, std::move(*bounds)};
    for (;;) {
        if (best && excess(*best) < high) break; // a smaller ellipse can't save what its height costs
        // as if the height grew like the square of sigma, as that of a Gaussian does
        sigma *= std::clamp(std::sqrt(1 / (best ? excess(*best) - 1 : 9)), 0.2, 0.6);
        if (sigma < least) break;
        auto bounds = bounds_on(sigma);
        if (!bounds) continue;
        Ellipse other{sigma, std::move(*bounds)};
        if (best && nodes_for(other, log2_tolerance) > nodes_for(*best, log2_tolerance)) break;
        best = std::move(other);
    }
    return best;
}

struct Sum {
    Ball value{0}, absolute{0};
    std::vector<std::vector<Ball>> at_nodes; ///< c_k at the nodes, from 1 to -1; only of few
};

double to_double(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

/// c_k(z) of an even F become c_k(-z).
void mirror(const EllipseFunction& f, std::vector<Ball>& c)
{
    for (std::size_t k = 0; k < c.size(); ++k)
        if (const std::size_t partner = f.partner(k); k < partner) std::swap(c[k], c[partner]);
}

Sum sum_of(const EllipseFunction& f, long n, slong bits, bool keeps_values = false)
{
    const auto nodes = GaussNodes::get(n, bits, f.rule);
    std::vector<std::shared_ptr<const WeightedNodes>> weights;
    for (const SingularWeight& w : f.weights) weights.push_back(w.is_one() ? nullptr : WeightedNodes::get(w, n, bits));
    const WorkingPrecision precision(bits);
    Sum sum;
    if (keeps_values) sum.at_nodes.resize(static_cast<std::size_t>(n));
    std::vector<Ball> c;
    const auto& entries = nodes->entries();
    const bool is_single = f.weights.size() == 1 && weights.front();
    const auto evaluate = [&](std::size_t k, bool mirrored) {
        if (is_single && f.with_weight)
            if (auto y = f.with_weight(entries[k], mirrored)) {
                c.assign(1, *y * weights.front()->reciprocal(k, mirrored));
                return;
            }
        f.at_node(entries[k], mirrored, c);
    };
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const bool is_middle = n % 2 != 0 && k + 1 == entries.size();
        for (const bool mirrored : {false, true}) {
            if (mirrored && is_middle) continue;
            if (!mirrored || !f.is_even) evaluate(k, mirrored);
            else mirror(f, c);
            for (std::size_t i = 0; i < c.size(); ++i) {
                const Ball& weight = weights[i] ? weights[i]->at(k, mirrored) : entries[k].weight;
                arb_addmul(sum.value.get(), c[i].get(), weight.get(), bits);
                const Ball size = upper_ball(c[i]), share = upper_ball(weight);
                arb_addmul(sum.absolute.get(), size.get(), share.get(), strip_bits);
            }
            if (keeps_values) sum.at_nodes[mirrored ? static_cast<std::size_t>(n) - 1 - k : k] = c;
        }
    }
    return sum;
}

struct Guess {
    double sigma;
    bool is_resolved; ///< whether the nodes show how F varies at all
};

/// |coefficients| of Legendre's polynomials, or of Chebyshev's, about, that the values at n nodes show for the i-th function.
std::vector<double> coefficients(const Sum& rough, std::size_t i, GaussRule rule)
{
    const std::size_t count = rough.at_nodes.size();
    const auto nodes = GaussNodes::get(static_cast<long>(count), strip_bits, rule);
    const bool is_legendre = rule == GaussRule::legendre;
    const auto& entries = nodes->entries();
    std::vector<double> a(count, 0);
    for (std::size_t j = 0; j < count; ++j) {
        const auto& e = entries[std::min(j, count - 1 - j)];
        const double z = j < count - 1 - j ? to_double(e.z) : -to_double(e.z),
                     value = to_double(rough.at_nodes[j][i]) * to_double(e.weight);
        double before = 0, now = 1;
        for (std::size_t k = 0; k < count; ++k) {
            const auto degree = static_cast<double>(k);
            a[k] += value * now * (is_legendre ? degree + 0.5 : 2 / M_PI);
            const double next = is_legendre ? ((2 * degree + 1) * z * now - degree * before) / (degree + 1)
                                : k == 0    ? z
                                            : 2 * z * now - before;
            before = now;
            now = next;
        }
    }
    for (double& x : a) x = std::fabs(x);
    return a;
}

/// About the sigma of the largest ellipse, by how fast the coefficients of the rule's polynomials fall that the values at a few nodes show;
/// some large number where they show none. Nothing is claimed of it: it says where the proof is to begin.
Guess guessed_ellipse(const Sum& rough, GaussRule rule)
{
    constexpr double unknown = 9, noise = 1e-13;
    constexpr double entire = 1.5; // falling ever faster
    double least = unknown;
    for (std::size_t i = 0; i < rough.at_nodes.front().size(); ++i) {
        const std::vector<double> a = coefficients(rough, i, rule);
        const std::size_t width = a.size() / 3;
        const auto largest = [&](std::size_t from) {
            return *std::max_element(a.begin() + static_cast<long>(from), a.begin() + static_cast<long>(from + width));
        };
        const double early = largest(1), middle = largest(1 + width), late = largest(std::min(1 + 2 * width, a.size() - width));
        const double seen = noise * *std::max_element(a.begin(), a.end());
        if (!(middle > seen)) continue;
        const double first_fall = std::log(early / middle), second_fall = std::log(middle / std::max(late, seen));
        constexpr std::size_t many = 24; // of few nodes this is how entire functions look
        if (late <= seen) {
            if (a.size() >= many) least = std::min(least, first_fall / static_cast<double>(width));
            continue;
        }
        const bool has_begun = first_fall > 0 || a.size() >= many; // to fall: what still grows is not resolved
        if (has_begun && second_fall > entire * first_fall) continue;
        // of many nodes the later ones are the better ones
        const double fall = a.size() >= many ? second_fall : (first_fall + second_fall) / 2;
        least = std::min(least, std::max(0.0, fall) / static_cast<double>(width));
    }
    const double unresolved = 2.4 / static_cast<double>(rough.at_nodes.size()); // beyond it the coefficients looked at are no tail
    return least < unresolved ? Guess{unknown, false} : Guess{least, true};
}

/// Of the rule with n nodes.
Ball discretisation_of(const EllipseFunction& f, const EllipseProof::Ellipse& e, long n, slong bits)
{
    const Ball sigma = Ball::exactly(e.sigma);
    Ball total(0);
    for (std::size_t k = 0; k < f.weights.size(); ++k) {
        if (f.rule == GaussRule::chebyshev)
            total += lemma::gauss_chebyshev(e.bounds[k], sigma, n);
        else if (f.weights[k].is_one())
            total += lemma::gauss_legendre(e.bounds[k], sigma, n);
        else
            total += lemma::interpolation(e.bounds[k], sigma, WeightedNodes::get(f.weights[k], n, bits)->size(), n);
    }
    return upper_ball(total);
}

} // namespace

std::size_t EllipseFunction::partner(std::size_t k) const
{
    if (!is_even) return k;
    return static_cast<std::size_t>(std::find(weights.begin(), weights.end(), weights[k].mirrored()) - weights.begin());
}

std::string EllipseIntegral::proof(const Ball& scale) const
{
    const Ball size = touchstone::abs(scale), rounding = radius_of(value) * size;
    std::ostringstream text;
    text.precision(4);
    text << "|f| <= " << bound_text(bound * size) << " up to a constant on the ellipse with the ends for foci, rho = " << std::exp(sigma)
         << ", in at most " << pieces << " boxes; |discretisation| <= " << bound_text(discretisation * size)
         << ", with rounding <= " << bound_text(rounding);
    return text.str();
}

std::optional<EllipseIntegral> by_ellipse(const EllipseFunction& f, double bits, bool of_absolute, long most_nodes)
{
    const long rough = f.weights.size() > 1 ? 10 : 16; // nodes that show the size, and how far F is analytic; fewer of the dear ones
    constexpr double believed = 10; // bits that may cancel, where the rough values show that some do
    constexpr int most_attempts = 3;
    constexpr slong guard = 12;
    const Sum first = sum_of(f, rough, strip_bits, true);
    if (!first.value.is_finite() || !first.absolute.is_finite()) return std::nullopt;
    const double absolute = log2_upper(first.absolute);
    if (!std::isfinite(absolute)) return std::nullopt;
    const double rough_size = log2_upper(first.value);
    const Guess guess = guessed_ellipse(first, f.rule);
    const double size = of_absolute || (guess.is_resolved && rough_size > absolute - 1) ? absolute - 1 : absolute - believed;
    double log2_tolerance = size - bits - 2;
    const auto closer_guess = [&] { return guessed_ellipse(sum_of(f, closer_nodes, strip_bits, true), f.rule).sigma; };
    EllipseProof proof(f, bits, guess.sigma, closer_guess, most_nodes);
    const WorkingPrecision coarse(strip_bits);
    const auto ellipse = proof.best(log2_tolerance);
    if (!ellipse) return std::nullopt;
    EllipseIntegral out;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        constexpr double constants = 3; // log2 of what stands before the bounds
        const long n = rounded_count(std::max(4.0, proof.nodes_for(*ellipse, log2_tolerance - constants)));
        if (n > most_nodes) return std::nullopt;
        const slong precision = std::max<slong>(strip_bits, static_cast<slong>(absolute - log2_tolerance) + guard);
        Sum sum = sum_of(f, n, precision);
        if (!sum.value.is_finite()) return std::nullopt;
        const Ball discretisation = discretisation_of(f, *ellipse, n, precision);
        widen(sum.value, discretisation);
        const Ball largest = *std::max_element(ellipse->bounds.begin(), ellipse->bounds.end(),
                                               [](const Ball& a, const Ball& b) { return arb_lt(a.get(), b.get()) != 0; });
        out = {sum.value, out.nodes + (f.is_even ? (n + 1) / 2 : n), proof.pieces, ellipse->sigma, largest, discretisation};
        const double shortfall = bits - static_cast<double>(out.value.relative_bits());
        if (shortfall <= 0 || of_absolute) break;
        log2_tolerance -= std::min(shortfall + 2, bits);
    }
    return out;
}

} // namespace touchstone::quadrature
