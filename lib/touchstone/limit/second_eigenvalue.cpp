// SPDX-License-Identifier: MIT
#include "touchstone/limit/second_eigenvalue.hpp"

#include "touchstone/limit/area_series.hpp"
#include "touchstone/limit/eigenfunction.hpp"
#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

namespace touchstone::limit {
namespace {

using Traits = ScalarTraits<Ball>;
using quadrature::upper_ball;

constexpr slong bits_of_bounds = 64;
constexpr double sigma_of_noise = 0.7; ///< of the ellipses about the panels of tau
constexpr double height = 0.8;         ///< |Im log s| of the ellipse about all s
constexpr long most_nodes = 2000;
constexpr int most_pieces = 768;       ///< of the boundary of an ellipse
constexpr int first_pieces = 48;
const Rational place(7, 10);           ///< of w = 1, in sigma = s - log(G^2/4): about the median of s' that D' meets

/// s = -log x is at least that of the largest ratio, 4/G^2.
Ball least_s(const Ball& G) { return 2 * log(G / 2); }

ComplexBall real_sum(const ComplexBall& z, const Ball& x)
{
    ComplexBall r;
    acb_add_arb(r.get(), z.get(), x.get(), WorkingPrecision::bits());
    return r;
}
Ball real_sum(const Ball& z, const Ball& x) { return z + x; }

bool is_right_of_zero(const ComplexBall& z) { return arb_is_positive(acb_realref(z.get())) != 0; }

/// One wave's s' and ds'/ds = psi, d psi/ds, at s and at a noise of given tanh^2 and log cosh.
template <class T>
struct Step {
    T remains, next, psi, bend;
    Step(const Ball& log_half_G, const T& s, const T& square, const T& log_cosh)
        : remains(T(1) - exp(-s) * square)
    {
        const T z = T(1) / (T(2) * remains);
        next = real_sum(s / T(2) + log_cosh - log(remains) / T(2), log_half_G);
        psi = T(1) - z;
        bend = z * (T(2) * z - T(1));
    }
};

/// cosh(sigma + i phi) for phi between the k-th and the next of `pieces` parts of a full turn.
ComplexBall on_ellipse(const Ball& sigma, int k, int pieces)
{
    const Ball turn = 2 * Traits::pi() / Ball(pieces), phi = hull(turn * Ball(k), turn * Ball(k + 1));
    Ball sine, cosine, sinh, cosh;
    arb_sin_cos(sine.get(), cosine.get(), phi.get(), WorkingPrecision::bits());
    arb_sinh_cosh(sinh.get(), cosh.get(), sigma.get(), WorkingPrecision::bits());
    return {cosh * cosine, sinh * sine};
}

/// At least the sum of |c_k| rho^k.
Ball size_on_ellipse(const std::vector<Ball>& c, const Ball& rho)
{
    Ball sum(0);
    for (std::size_t k = c.size(); k-- > 0;) sum = sum * rho + upper_ball(c[k]);
    return sum;
}

/// At least rho of the ellipse about [-1, 1] through t: rho + 1/rho = |t + 1| + |t - 1|.
Ball rho_of(const ComplexBall& t)
{
    const Ball axis = at_least(upper_ball((abs(t + ComplexBall(1)) + abs(t - ComplexBall(1))) / 2), Ball(1));
    return upper_ball(axis + sqrt(axis * axis - 1));
}

/// At least both.
Ball larger(const Ball& a, const Ball& b)
{
    const Ball x = upper_ball(a), y = upper_ball(b); // exact, so that one of them is
    return !x.is_finite() || arb_gt(x.get(), y.get()) ? x : y;
}

} // namespace

NoiseBeyond beyond_the_noise(const Ball& G, const Ball& last)
{
    // |psi| and |bend| are largest at v = x, or psi is 1/2 at v = 0
    const Ball x = 4 / (G * G), z = 1 / (2 * (1 - x));
    return {32 / (3 * Traits::pi()) * exp(-3 * last), larger(upper_ball(1 - z), Ball(Rational(1, 2))), upper_ball(z * (2 * z - 1))};
}

namespace {

/// (D w)' and D w, proven: what is integrated is analytic in tau and s on ellipses about the panels of tau and about [low, high] of log s.
class Derivative {
public:
    Derivative(const Ball& G, const Eigenfunction& w_, double sigma, double tolerance)
        : w(w_), log_half_G(log(G / 2)), panels(panels_of_noise(sigma)),
          sigma_of_s(Ball::exactly(std::asinh(2 * height / (w.high - w.low))))
    {
        check_cut(G);
        for (std::size_t j = 0; j + 1 < panels.size(); ++j) add_panel(j, tolerance);
        cut_off(G);
    }
    /// (D w)'(s) where s >= log(G^2/4), s <= exp(high). A little below, from exp(low) on, it encloses what the rule is of, which is all
    /// that interpolation asks of it.
    Ball slope(const Ball& s) const { return within(sum(s, true), error_ + slope_beyond_); }
    Ball value(const Ball& s) const { return within(sum(s, false), error_ + value_beyond_); }
    /// At least |(D w)' - lambda w'| on the ellipse about all log s, without what was cut off.
    Ball size_on_the_ellipse(const Ball& lambda) const
    {
        Ball rho, s_least;
        arb_exp(rho.get(), sigma_of_s.get(), WorkingPrecision::bits());
        // Re log s >= centre - half cosh(sigma)
        Ball cosh;
        arb_cosh(cosh.get(), sigma_of_s.get(), WorkingPrecision::bits());
        s_least = exp((Ball::exactly(w.high) + Ball::exactly(w.low)) / 2 - cosh / w.stretch());
        return upper_ball(all_ + abs(lambda) * size_on_ellipse(w.slope, rho) * w.stretch() / s_least);
    }
    const Ball& ellipse() const { return sigma_of_s; }

private:
    struct Bounds {
        Ball rho{1}, share{0}, psi{0}, bend{0}, inverse{0}; ///< of w's ellipse, |(4/pi) sech^3|, |psi|, |bend|, |1/s'|
    };

    static Ball within(Ball value, const Ball& error)
    {
        arb_add_error(value.get(), error.get());
        return value;
    }

    /// s' stays where w is a polynomial: it is convex in s at the last tau, so both ends decide.
    void check_cut(const Ball& G) const
    {
        const Ball s_high = exp(Ball::exactly(w.high)), s_low = exp(Ball::exactly(w.low));
        if (!certainly(less(s_low, least_s(G))) || !certainly(less(Ball(0), s_low)))
            throw BeyondReach("the interval does not hold the smallest s");
        Ball cosh;
        arb_cosh(cosh.get(), Ball::exactly(panels.back()).get(), WorkingPrecision::bits());
        for (const Ball& s : {s_low, s_high})
            if (!certainly(less(s / 2 + log_half_G + log(cosh) - log(1 - exp(-s)) / 2, s_high)))
                throw BeyondReach("the noise is cut off too late");
    }

    /// What is left out beyond the last tau: |w| <= sum |c_k| and |w'| <= sum |c'_k| dt/ds, also where w is constant.
    void cut_off(const Ball& G)
    {
        const auto [mass, psi, bend] = beyond_the_noise(G, Ball::exactly(panels.back()));
        const Ball most = size_on_ellipse(w.value, Ball(1)),
                   steepest = size_on_ellipse(w.slope, Ball(1)) * w.stretch() / exp(Ball::exactly(w.low));
        slope_beyond_ = upper_ball(mass * (bend * most + psi * psi * steepest));
        value_beyond_ = upper_ball(mass * psi * most);
    }

    /// All of it analytic on both ellipses: cosh tau, 1 - v and s' have positive real parts on their boundaries, hence inside.
    std::optional<Bounds> bounds(const Ball& centre, const Ball& half, int pieces) const
    {
        Bounds b;
        const Ball middle_of_s = (Ball::exactly(w.high) + Ball::exactly(w.low)) / 2, sigma = Ball::exactly(sigma_of_noise);
        const int of_s = pieces / 2; // both ellipses upside down give the conjugate
        std::vector<ComplexBall> s;
        for (int k = 0; k < of_s / 2; ++k)
            s.push_back(exp(real_sum(on_ellipse(sigma_of_s, k, of_s) * ComplexBall(1 / w.stretch()), middle_of_s)));
        for (int k = 0; k < pieces; ++k) {
            const ComplexBall tau = real_sum(on_ellipse(sigma, k, pieces) * ComplexBall(half), centre);
            ComplexBall cosh, tanh;
            acb_cosh(cosh.get(), tau.get(), WorkingPrecision::bits());
            acb_tanh(tanh.get(), tau.get(), WorkingPrecision::bits());
            if (!is_right_of_zero(cosh)) return {};
            const ComplexBall square = tanh * tanh, log_cosh = log(cosh);
            const Ball inverse = 1 / abs(cosh);
            b.share = larger(b.share, upper_ball(4 / Traits::pi() * inverse * inverse * inverse));
            for (const ComplexBall& at : s) {
                const Step<ComplexBall> step(log_half_G, at, square, log_cosh);
                if (!is_right_of_zero(step.remains) || !is_right_of_zero(step.next)) return {};
                b.rho = larger(b.rho, rho_of(w.place(step.next)));
                b.psi = larger(b.psi, upper_ball(step.psi));
                b.bend = larger(b.bend, upper_ball(step.bend));
                b.inverse = larger(b.inverse, upper_ball(1 / abs(step.next)));
            }
        }
        if (!(b.rho + b.share + b.psi + b.bend + b.inverse).is_finite()) return {};
        return b;
    }

    void add_panel(std::size_t j, double tolerance)
    {
        const Ball centre = (Ball::exactly(panels[j + 1]) + Ball::exactly(panels[j])) / 2,
                   half = (Ball::exactly(panels[j + 1]) - Ball::exactly(panels[j])) / 2;
        Ball size;
        {
            const WorkingPrecision precision(bits_of_bounds);
            std::optional<Bounds> b;
            for (int pieces = first_pieces; !b && pieces <= most_pieces; pieces *= 2) b = bounds(centre, half, pieces);
            if (!b) throw BeyondReach("the eigenfunction is not analytic on the ellipses");
            const Ball of_w = size_on_ellipse(w.value, b->rho), of_slope = size_on_ellipse(w.slope, b->rho) * w.stretch() * b->inverse;
            size = upper_ball(half * b->share * larger(b->bend * of_w + b->psi * b->psi * of_slope, b->psi * of_w));
        }
        all_ += 2 * size;
        const Ball sigma = Ball::exactly(sigma_of_noise);
        long n = 4;
        const auto off = [&] { return upper_ball(quadrature::lemma::gauss_legendre(size, sigma, n)); };
        while (arf_get_d(arb_midref(off().get()), ARF_RND_UP) > tolerance) {
            if ((n += 4) > most_nodes) throw BeyondReach("the eigenfunction grows too fast on the ellipses");
        }
        error_ += off();
        add_noise(nodes, Ball::exactly(panels[j]), Ball::exactly(panels[j + 1]), n);
    }

    Ball sum(const Ball& s, bool of_slope) const
    {
        Ball total(0);
        for (const Noise& n : nodes) {
            const Step<Ball> step(log_half_G, s, n.square, n.log_cosh);
            const Ball t = w.place(step.next), here = chebyshev_sum(w.value, t);
            if (of_slope)
                total += n.weight * (step.bend * here + step.psi * step.psi * chebyshev_sum(w.slope, t) * w.stretch() / step.next);
            else
                total += n.weight * step.psi * here;
        }
        return total;
    }

    const Eigenfunction& w;
    const Ball log_half_G;
    const std::vector<double> panels;
    const Ball sigma_of_s;
    std::vector<Noise> nodes;
    Ball error_{0}, all_{0}, slope_beyond_, value_beyond_;
};

// ---- the weight W(sigma) = 1 + r + (3/2) r^4 + r^-1/10^4, r = exp(-2 sigma), and its integral V

const Rational growing(1, 10'000);

} // namespace

Ball weight_of_slopes(const Ball& r) { return 1 + r + 3 * r * r * r * r / 2 + Ball(growing) / r; }
Ball integral_of_weight(const Ball& r) { return -log(r) / 2 - r / 2 - 3 * r * r * r * r / 16 + Ball(growing) / (2 * r); }

namespace {

Ball integral_up_to_the_place() { return integral_of_weight(exp(-2 * Ball(place))); }

/// Rows of D by the angle phi of the noise, u = sin phi, boxes of phi: E[f] = (4/pi) int cos^2 f dphi.
class Rows {
public:
    explicit Rows(const Ball& G) : largest_x(4 / (G * G)), V_at_place(integral_up_to_the_place())
    {
        for (int j = 0; j < boxes; ++j) {
            const Ball from = Traits::pi() * Ball(j) / Ball(2 * boxes), to = Traits::pi() * Ball(j + 1) / Ball(2 * boxes);
            Ball sine, cosine;
            arb_sin_cos(sine.get(), cosine.get(), hull(from, to).get(), WorkingPrecision::bits());
            const bool last = j + 1 == boxes;
            squares.push_back({sine * sine, last ? at_least(cosine * cosine, Ball(0)) : cosine * cosine, last});
        }
    }
    struct Row {
        Ball coupling;  ///< at least E[|psi| |V(sigma') - V(place)|]
        Ball remainder; ///< at least E[psi^2 W(sigma')] + E[bend |V(sigma') - V(place)|]
    };
    /// For all ratios x = exp(-sigma) 4/G^2 of the ball `rho` = exp(-sigma) <= 1.
    Row at(const Ball& rho) const
    {
        Ball coupling(0), remainder(0);
        for (const Square& q : squares) {
            const Ball remains = 1 - largest_x * rho * q.sine, z = 1 / (2 * remains), psi = 1 - z, bend = z * (2 * z - 1);
            const Ball r = rho * q.cosine * remains; // exp(-2 sigma')
            // cos^2 times |V - V(place)|, and cos^2 W
            const Ball distance = q.last ? near_the_end(rho, q.cosine, remains) : q.cosine * upper_ball(integral_of_weight(r) - V_at_place);
            const Ball W = q.cosine * (1 + r + 3 * r * r * r * r / 2) + Ball(growing) / (rho * remains);
            coupling += upper_ball(psi) * upper_ball(distance);
            remainder += upper_ball(psi * psi * W) + upper_ball(bend) * upper_ball(distance);
        }
        const Ball share = Ball(2) / Ball(boxes); // (4/pi) dphi
        return {upper_ball(share * coupling), upper_ball(share * remainder)};
    }

private:
    static constexpr int boxes = 800; ///< to 1 % of the norm
    struct Square {
        Ball sine, cosine; ///< sin^2, cos^2
        bool last;
    };
    /// cos^2 |V - V(place)| where r may be 0: log(1/r)/2 <= r^-1/2.
    Ball near_the_end(const Ball& rho, const Ball& cosine, const Ball& remains) const
    {
        return Traits::sqrt_positive_part(cosine / (rho * remains)) + cosine * (1 + upper_ball(V_at_place)) +
               Ball(growing) / (2 * rho * remains);
    }
    Ball largest_x, V_at_place;
    std::vector<Square> squares;
};

} // namespace

Slopes::Slopes(const Ball& G, const Eigenfunction& w_, slong bits_) : w(w_), bits(bits_), lowest(least_s(G))
{
    const WorkingPrecision precision(bits); // to that of w: Clenshaw's recurrence would multiply what 64 bits leave by powers of 2
    bend = chebyshev_derivative(w.slope);
    third = size_on_ellipse(chebyshev_derivative(bend), Ball(1));
}

Ball Slopes::steepest(double from, double to) const
{
    constexpr int parts = 16; // on each by Taylor's formula about its middle
    const WorkingPrecision precision(bits); // Clenshaw's recurrence in balls loses more than a bit a term
    const Ball width = (Ball::exactly(to) - Ball::exactly(from)) / parts;
    Ball most(0);
    for (int k = 0; k < parts; ++k) {
        const Ball s = lowest + Ball::exactly(from) + width * hull(Ball(k), Ball(k + 1)), t = w.place(s);
        const Ball off = Ball::exactly(t.radius_bound());
        Ball middle;
        arb_get_mid_arb(middle.get(), t.get());
        const Ball at_middle = upper_ball(chebyshev_sum(w.slope, middle)), bent = upper_ball(chebyshev_sum(bend, middle));
        const Ball slope = at_middle + off * bent + off * off * third / 2;
        most = larger(most, upper_ball(slope * w.stretch() / s));
    }
    return most;
}

namespace {

/// sup over sigma >= 0 of (E[psi^2 W] + E[bend |V - V(place)|] + |w'| coupling/|w(place)|)/W: intervals of sigma, the worst halved until
/// that is below `goal`.
class Remainder {
public:
    Remainder(const Ball& G, const Eigenfunction& w_, const Rows& rows_, const Ball& per_slope_, slong bits_)
        : w(w_), rows(rows_), lowest(least_s(G)), per_slope(per_slope_), slopes(G, w_, bits_)
    {
    }
    Ball norm(double last, double goal)
    {
        constexpr int most_halvings = 400;
        constexpr double first = 0.05, growth = 1.2;
        std::priority_queue<Interval> all;
        for (double from = 0, width = first; from < last; width *= growth) {
            const double to = std::min(last, from + width);
            all.push(measured(from, to));
            from = to;
        }
        for (int k = 0; k < most_halvings && all.top().bound > goal; ++k) {
            const Interval worst = all.top();
            all.pop();
            const double middle = (worst.from + worst.to) / 2;
            all.push(measured(worst.from, middle));
            all.push(measured(middle, worst.to));
        }
        return larger(Ball::exactly(all.top().bound), beyond(Ball::exactly(last)));
    }

private:
    struct Interval {
        double from, to, bound;
        bool operator<(const Interval& o) const { return bound < o.bound; }
    };
    Interval measured(double from, double to) const
    {
        const Ball sigma = hull(Ball::exactly(from), Ball::exactly(to)), rho = at_most(exp(-sigma), Ball(1));
        const Ball bound = upper_ball((rows.at(rho).remainder + slopes.steepest(from, to) * per_slope) / weight_of_slopes(rho * rho));
        return {from, to, arf_get_d(arb_midref(bound.get()), ARF_RND_UP)};
    }
    /// From there on w' = 0 or at most the largest, x <= 1/2, psi^2 <= 1/4 and bend <= 2 x, W >= 1/(10^4 rho^2):
    /// E[W] <= 7/2 + 2 growing/(rho (1 - x)), E|V - V(place)| <= (4/pi) (rho (1 - x))^-1/2 + 1 + |V(place)| + growing/(rho (1 - x)).
    Ball beyond(const Ball& last) const
    {
        const Ball rho = exp(-last), half = Ball(Rational(1, 2)), x = exp(-lowest) * rho;
        if (!certainly(less(x, half))) throw BeyondReach("the last ratio is not small");
        const Ball g(growing), V = 2 + upper_ball(integral_up_to_the_place()), y = rho / 2;
        const Ball steepest = size_on_ellipse(w.slope, Ball(1)) * w.stretch() / lowest;
        const Ball E = (Ball(Rational(7, 2)) + 2 * g / y) / 4 + 2 * x * (4 / (Traits::pi() * sqrt(y)) + V + g / y) + steepest * per_slope;
        return upper_ball(E * rho * rho / g);
    }
    const Eigenfunction& w;
    const Rows& rows;
    const Ball lowest, per_slope;
    const Slopes slopes;
};

/// At least |(D w)' - lambda w'| for all s with log s in [low, high]: Chebyshev interpolation, whose error on an ellipse is known.
Ball largest_defect(const Derivative& D, const Eigenfunction& w, const Ball& lambda, double tolerance)
{
    const slong bits = WorkingPrecision::bits();
    const Ball size = D.size_on_the_ellipse(lambda), rho = exp(D.ellipse());
    const auto off = [&](long n) { return upper_ball(4 * size / (pow(rho, Ball(n)) * (rho - 1))); };
    long n = 16;
    while (arf_get_d(arb_midref(off(n).get()), ARF_RND_UP) > tolerance) {
        if ((n += 8) > most_nodes) throw BeyondReach("the eigenfunction grows too fast on the ellipses");
    }
    std::vector<Ball> values(static_cast<std::size_t>(n) + 1);
    transfer::in_parallel(values.size(), [&](std::size_t i) {
        const WorkingPrecision precision(bits);
        const Ball t = -Traits::cos_pi(Ball(static_cast<long>(i)) / Ball(n)),
                   s = exp((Ball::exactly(w.high) + Ball::exactly(w.low)) / 2 + t / w.stretch());
        values[i] = D.slope(s) - lambda * chebyshev_sum(w.slope, t) * w.stretch() / s;
    });
    // The values' balls hold what was cut off too, and so does that of their mean, the coefficient of T_0: its upper end pays for it
    // between the nodes.
    Ball sum = off(n);
    for (long k = 0; k <= n; ++k) { // the coefficient of T_k
        Ball c(0);
        for (long i = 0; i <= n; ++i) {
            const Ball term = values[static_cast<std::size_t>(i)] * Traits::cos_pi(Ball(k * (n - i)) / Ball(n));
            c += i == 0 || i == n ? term / 2 : term;
        }
        sum += upper_ball((k == 0 || k == n ? c : 2 * c) / Ball(n));
    }
    return sum;
}

/// At least |(D w)'|/W beyond the last s, where w' = 0: |w| and |w'| at most their largest, psi^2 <= 1/4, bend <= 2 x.
Ball defect_beyond(const Ball& G, const Eigenfunction& w)
{
    const Ball last = exp(Ball::exactly(w.high)), rho = exp(least_s(G) - last), x = exp(-last);
    if (!certainly(less(x, Ball(Rational(1, 2))))) throw BeyondReach("the last ratio is not small");
    const Ball steepest = size_on_ellipse(w.slope, Ball(1)) * w.stretch() / exp(Ball::exactly(w.low));
    return upper_ball((2 * x * size_on_ellipse(w.value, Ball(1)) + steepest / 4) * rho * rho / Ball(growing));
}

} // namespace

EigenvalueProof prove_eigenvalue(const Ball& G, const Eigenfunction& w, Accuracy wanted)
{
    const double sigma = highest_sigma(wanted), tolerance = std::pow(10.0, -static_cast<double>(wanted.digits) - 4);
    const Derivative D(G, w, sigma, tolerance);
    const Ball s = least_s(G) + Ball(place), at_place = chebyshev_sum(w.value, w.place(s));
    EigenvalueProof proof;
    proof.lambda = D.value(s) / at_place;
    proof.defect = larger(largest_defect(D, w, proof.lambda, tolerance), defect_beyond(G, w)) / abs(at_place);
    {
        const slong bits = WorkingPrecision::bits();
        const WorkingPrecision precision(bits_of_bounds);
        const Rows rows(G);
        proof.coupling = rows.at(exp(-Ball(place))).coupling;
        constexpr double goal = 0.85; // of lambda
        Remainder remainder(G, w, rows, upper_ball(proof.coupling / at_place), bits);
        proof.remainder = remainder.norm(sigma, goal * arf_get_d(arb_midref(proof.lambda.get()), ARF_RND_NEAR));
    }
    return proof;
}

namespace {

EigenvalueProof proof_for(const std::function<Ball()>& G, Accuracy wanted)
{
    const Ball at = G();
    if (!certainly(less(Ball(2), at))) throw BeyondReach("the gap is proven where G > 2 only");
    return prove_eigenvalue(at, approximate_eigenfunction(at, wanted), wanted);
}

slong bits_for_proof(Accuracy a) { return 64 + 5 * a.digits; }

} // namespace

std::string second_eigenvalue_certificate(const std::function<Ball()>& G, Accuracy wanted)
{
    const WorkingPrecision precision(bits_for_proof(wanted));
    const EigenvalueProof p = proof_for(G, wanted);
    return fmt::format(
        "second eigenvalue: D w/w = {} at sigma = 0.7; |(D w)' - lambda w'| <= {} W; coupling {}, norm of the remainder {} < lambda (docs/limit.md, theorem 8)\n",
        p.lambda.to_string(wanted.digits + 2), quadrature::bound_text(p.defect), quadrature::bound_text(p.coupling),
        quadrature::bound_text(p.remainder));
}

Ball second_eigenvalue(const std::function<Ball()>& G, Accuracy wanted)
{
    const WorkingPrecision precision(bits_for_proof(wanted));
    const EigenvalueProof p = proof_for(G, wanted);
    const Ball margin = p.lambda - p.remainder, error = upper_ball(3 * p.coupling * p.defect / margin);
    if (!certainly(less(2 * error, margin))) throw BeyondReach("other eigenvalues are too near for the second to be proven simple");
    Ball enclosed = p.lambda;
    arb_add_error(enclosed.get(), error.get());
    return enclosed;
}

Witness second_eigenvalue_to_first_order(const Ball& G)
{
    Ball value = (1 - hertzian_moment(Ball(1)) / (G * G)) / 2, error = 1 / pow(G, Ball(4)) + Ball::exactly(value.radius_bound());
    arb_get_mid_arb(value.get(), value.get());
    arb_get_mid_arb(error.get(), error.get());
    return {value, error};
}

} // namespace touchstone::limit
