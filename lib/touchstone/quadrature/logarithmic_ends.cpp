// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/logarithmic_ends.hpp"

#include "touchstone/quadrature/elliptic.hpp"
#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/special.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <cmath>
#include <map>
#include <vector>

#if __has_include(<flint/acb_hypgeom.h>)
#include <flint/acb_hypgeom.h>
#else
#include <acb_hypgeom.h>
#endif

namespace touchstone::quadrature {
namespace {

template <class V>
using N = EndpointNumber<V>;

/// As many terms of a power series in q that q^n is below the last bit at work, or well below the radius of the argument, and a few.
long terms_for(const Ball& q, const Ball& radius)
{
    constexpr long most = 20000;
    constexpr double spare = 8; // bits
    const double bits = -log2_upper(q),
                 wanted = std::min(static_cast<double>(WorkingPrecision::bits()), spare - std::min(0.0, log2_upper(radius)));
    return bits > 0 ? std::min(most, static_cast<long>(wanted / bits) + 2) : most;
}

/// a_n, 2 a_n s_n and b_n, a_n = ((1/2)_n/n!)^2, b_n = (1/2)_n (3/2)_n/((2)_n n!), s_n = 1/(1 2) + 1/(3 4) + ... (n terms).
struct EllipticCoefficients {
    std::vector<Ball> own, logarithmic, regular;
};

/// The first of them to the precision at work, kept.
const EllipticCoefficients& elliptic_coefficients(long terms)
{
    thread_local std::map<slong, EllipticCoefficients> kept;
    constexpr std::size_t most_precisions = 8;
    if (kept.size() > most_precisions) kept.clear();
    EllipticCoefficients& c = kept[WorkingPrecision::bits()];
    if (c.regular.size() >= static_cast<std::size_t>(terms)) return c;
    c = {};
    Ball a(1), b(1), s(0);
    for (long n = 0; n < 2 * terms; ++n) { // others will soon ask for some more
        c.own.push_back(a);
        c.logarithmic.push_back(Ball(2) * a * s);
        c.regular.push_back(b);
        s += Ball(1) / Ball((2 * n + 1) * (2 * n + 2));
        a = a * Ball((2 * n + 1) * (2 * n + 1)) / Ball((2 * n + 2) * (2 * n + 2));
        b = b * Ball((2 * n + 1) * (2 * n + 3)) / Ball((2 * n + 2) * (2 * n + 4));
    }
    return c;
}

/// 1, u, u^2, ...
std::vector<ComplexBall> powers_of(const ComplexBall& u, long count)
{
    std::vector<ComplexBall> p{ComplexBall(1), u};
    for (auto n = p.size(); n < static_cast<std::size_t>(count); ++n) p.push_back(p[n / 2] * p[n - n / 2]);
    return p;
}

ComplexBall sum_of(const std::vector<Ball>& c, const std::vector<ComplexBall>& powers, long terms)
{
    constexpr slong parts = 2; // which stand side by side
    ComplexBall sum;
    const slong bits = WorkingPrecision::bits();
    acb_srcptr first = powers.front().get();
    arb_dot(acb_realref(sum.get()), nullptr, 0, c.front().get(), 1, acb_realref(first), parts, terms, bits);
    arb_dot(acb_imagref(sum.get()), nullptr, 0, c.front().get(), 1, acb_imagref(first), parts, terms, bits);
    return sum;
}

/// Whether the number is off the negative axis with its principal logarithm for the one that is continued.
bool is_principal(const N<Ball>&) { return true; }
bool is_principal(const N<ComplexBall>& u)
{
    const Ball angle = touchstone::abs(log(u).value().imag());
    return arb_lt(angle.get(), pi<Ball>().get()) != 0;
}

/// Whether abs(v) is below that.
template <class V>
bool is_below(const V& v, double bound)
{
    return upper(v) < bound;
}

/// Whether log u is a symbol here: then what stands beside it must be one function on the whole of the plane.
template <class V>
bool keeps_its_logarithm(const N<V>& u)
{
    return u.frame() && u.frame()->keeps_logarithms() && !u.is_plain();
}

Ball log_of_16()
{
    Ball r;
    arb_const_log2(r.get(), WorkingPrecision::bits());
    arb_mul_2exp_si(r.get(), r.get(), 2);
    return r;
}

/// |u| < 1: K(u) = (pi/2) sum of a_n u^n, S(u) = sum of 2 a_n s_n u^n and (pi/4) sum of b_n u^n.
EllipticAboutOne by_series(const ComplexBall& u, bool of_k)
{
    const Ball q = upper_ball(u), quarter = pi<Ball>() / Ball(4);
    const long terms = std::max(2L, terms_for(q, radius_of(u)));
    const EllipticCoefficients& c = elliptic_coefficients(terms);
    const std::vector<ComplexBall> powers = powers_of(u, terms);
    EllipticAboutOne sums{sum_of(c.own, powers, terms), sum_of(c.logarithmic, powers, terms), ComplexBall::indeterminate()};
    widen(sums.k, lemma::remainder(Ball(1), q, terms)); // a_n <= 1
    sums.k = sums.k * ComplexBall(quarter + quarter);
    widen(sums.rest, lemma::elliptic_remainder(q, terms));
    if (of_k) return sums;
    sums.regular = sum_of(c.regular, powers, terms);
    widen(sums.regular, lemma::remainder(Ball(1), q, terms)); // b_n <= 1
    sums.regular = sums.regular * ComplexBall(quarter);
    return sums;
}

/// A disc about a number.
ComplexBall disc_about(const Ball& middle, const Ball& radius)
{
    ComplexBall z(middle);
    widen(z, upper_ball(radius));
    return z;
}

/// S(u) = -(K(u)/pi) (l - log 16) - other.
EllipticAboutOne from_parts(const ComplexBall& u, bool of_k, const ComplexBall& l, const ComplexBall& other)
{
    if (!l.is_finite() || !other.is_finite()) // then K, which takes longer than both, is of no use
        return {ComplexBall::indeterminate(), ComplexBall::indeterminate(), ComplexBall::indeterminate()};
    const auto own = elliptic_over_pi(ComplexBall(1) - u, !of_k);
    const ComplexBall to_k(pi<Ball>());
    return {own.k * to_k, own.k * (ComplexBall(log_of_16()) - l) - other, of_k ? own.e : (own.k - own.e) * to_k / u};
}

/// Off the cuts, by principal functions.
EllipticAboutOne by_values(const ComplexBall& u, bool of_k)
{
    return from_parts(u, of_k, analytic::log(u), first_kind_of_complement(u));
}

/// For Re u < 0, across the cuts of log u and K(1 - u): S(u) = -(K(u)/pi) (log(-u) - log 16) - (1 - u)^(-1/2) K(1/(1 - u)).
EllipticAboutOne by_reciprocal(const ComplexBall& u, bool of_k)
{
    const ComplexBall v = ComplexBall(1) - u;
    const ComplexBall other = first_kind_of_complement(-u / v) / analytic::sqrt(v);
    return from_parts(u, of_k, analytic::log(-u), other);
}

constexpr double near_one = 0.75; // abs(u) up to which the series about u = 0 are taken

EllipticAboutOne about_one(const ComplexBall& u, bool of_k)
{
    if (is_known_by_size(u)) return about_one_by_size(upper_ball(u), of_k);
    if (is_below(u, near_one)) return by_series(u, of_k); // a ball that may hold 0
    return arb_is_negative(u.real().get()) != 0 ? by_reciprocal(u, of_k) : by_values(u, of_k);
}

/// K(1 - u) or E(1 - u), v the value of u.
N<ComplexBall> with_logarithm_of_complement(bool is_k, const N<ComplexBall>& u, const ComplexBall& v)
{
    const EllipticAboutOne parts = about_one(v, is_k);
    // DLMF 19.12.1
    const N<ComplexBall> K =
        N<ComplexBall>(parts.k / ComplexBall(-pi<Ball>())) * (log(u) - N<ComplexBall>(log_of_16())) - N<ComplexBall>(parts.rest);
    if (is_k) return K;
    // Legendre's relation
    return (N<ComplexBall>(ComplexBall(pi<Ball>() / Ball(2))) + u * N<ComplexBall>(parts.regular) * K) / N<ComplexBall>(parts.k);
}

/// At a real point the value itself is known: what no logarithm stands beside is that less the logarithms' shares, those of -K(u)/pi log u
/// in K(1 - u) and of -(K(u) - E(u))/pi log u in E(1 - u).
N<Ball> with_logarithm_of_complement(bool is_k, const N<Ball>& u, const Ball& v)
{
    const auto own = elliptic_over_pi(Ball(1) - v, !is_k);
    const Ball beside = is_k ? -own.k : own.e - own.k;
    Ball free = is_k ? first_kind_of_complement(v) : elliptic_of_complement(v).e;
    N<Ball>::Terms terms;
    for (const Side s : {Side::left, Side::right}) {
        const Exponent& power = u.order(s).power;
        if (power.is_zero()) continue;
        const bool left = s == Side::left;
        const Ball share = beside * power.ball();
        free -= share * u.frame()->log_of_distance(s);
        terms.push_back({left ? 1 : 0, left ? 0 : 1, share});
    }
    return {u.frame(), {}, {}, std::move(free), std::move(terms)};
}

template <class V>
N<V> elliptic(Op op, const N<V>& u)
{
    const bool is_k = op == Op::elliptic_k_of_complement, keeps = keeps_its_logarithm(u);
    const V v = u.value();
    if (!v.is_finite()) return N<V>(V::indeterminate());
    const bool near = vanishes_at_an_end(u) && is_below(v, near_one);
    if (keeps && !vanishes_at_an_end(u)) return N<V>(V::indeterminate());
    if (!keeps && (std::same_as<V, Ball> || !near)) {
        if (!u.is_plain() && !is_principal(u)) return N<V>(V::indeterminate());
        return N<V>(is_k ? first_kind_of_complement(v) : elliptic_of_complement(v).e);
    }
    return with_logarithm_of_complement(is_k, u, v);
}

/// sum over k of (psi(k + 1) + psi(n + k + 1)) w^k/(k! (n + k)!)
template <class V>
V digamma_series(long n, const V& w)
{
    const Ball q = upper_ball(w);
    Ball euler, c, over(1);
    arb_const_euler(euler.get(), WorkingPrecision::bits());
    c = -euler - euler;
    for (long j = 1; j <= n; ++j) {
        c += Ball(1) / Ball(j);
        over = over / Ball(j);
    }
    V sum(0), power(1);
    Ball size(1);
    // from k = 2 on the coefficients grow by less than a factor 2, so once (k + 1)(n + k + 1) >= 4 |w| the terms halve at least
    for (long k = 0;; ++k) {
        const Ball term = touchstone::abs(c) * over * size;
        const bool halving = k >= 2 && arb_ge(Ball((k + 1) * (n + k + 1)).get(), (Ball(4) * q).get());
        if (halving && log2_upper(term) < -static_cast<double>(WorkingPrecision::bits())) {
            widen(sum, Ball(2) * upper_ball(term));
            return sum;
        }
        sum += power * V(c * over);
        power = power * w;
        size = size * q;
        c += Ball(1) / Ball(k + 1) + Ball(1) / Ball(n + k + 1);
        over = over / Ball((k + 1) * (n + k + 1));
    }
}

/// sum over k < n of (n - k - 1)!/k! (-w)^k
template <class V>
V finite_sum(long n, const V& w)
{
    V sum(0), power(1);
    for (long k = 0; k < n; ++k) {
        Ball c(1);
        for (long j = 2; j < n - k; ++j) c = c * Ball(j);
        for (long j = 2; j <= k; ++j) c = c / Ball(j);
        sum += power * V(c);
        power = power * -w;
    }
    return sum;
}

/// K_n and Y_n (DLMF 10.31.1, 10.8.1).
template <class V>
N<V> with_logarithm(Op op, long n, const N<V>& x)
{
    const bool modified = op == Op::bessel_k;
    const V z = x.value(), square = z * z / V(4), w = modified ? square : -square;
    const N<V> half = x / N<V>(2), power = to_power(half, Exponent(n));
    const N<V> regular(special_function(modified ? Op::bessel_i : Op::bessel_j, Ball(n), z));
    const long sign = n % 2 == 0 ? 1 : -1;
    N<V> sum = N<V>(modified ? -sign : 2) * log(half) * regular;
    if (n > 0) sum = sum + N<V>(finite_sum(n, w)) / power * N<V>(modified ? V(Ball(1) / Ball(2)) : V(-1));
    sum = sum + power * N<V>(digamma_series(n, w)) * N<V>(modified ? V(Ball(sign) / Ball(2)) : V(-1));
    return modified ? sum : sum / N<V>(V(pi<Ball>()));
}

/// J_nu and I_nu: (x/2)^nu times an entire function of x^2.
template <class V>
N<V> with_power(Op op, const Exponent& order, const N<V>& x)
{
    const V z = x.value(), square = z * z / V(4), w = op == Op::bessel_i ? square : -square;
    ComplexBall f;
    const ComplexBall a((order + Exponent(1)).ball()), argument(w);
    acb_hypgeom_0f1(f.get(), a.get(), argument.get(), 1, WorkingPrecision::bits());
    if constexpr (std::same_as<V, Ball>)
        return to_power(N<V>(x / N<V>(2)), order) * N<V>(f.real());
    else
        return to_power(N<V>(x / N<V>(2)), order) * N<V>(f);
}

template <class V>
std::optional<N<V>> bessel(Op op, const Ball& order, const N<V>& x)
{
    constexpr double largest = 8;
    const double nu = arf_get_d(arb_midref(order.get()), ARF_RND_NEAR);
    if (x.has_logarithms()) return N<V>(V::indeterminate());
    if (!vanishes_at_an_end(x) || !order.is_exact() || std::fabs(nu) > largest) return std::nullopt;
    const bool integer = arb_is_int(order.get()) != 0, logarithmic = op == Op::bessel_k || op == Op::bessel_y;
    const bool half_odd = !integer && arb_is_int((order * Ball(2)).get()) != 0;
    if (!(integer && logarithmic && nu >= 0) && !(half_odd && (op == Op::bessel_j || op == Op::bessel_i))) return std::nullopt;
    const Exponent exponent(std::lround(2 * nu), 2);
    // farther away terms cancel: bits at a node, less than what a box loses otherwise on a piece
    constexpr double near = std::same_as<V, Ball> ? 2 : 8;
    constexpr double farthest = 64; // the series takes as many terms as x is large
    if (keeps_its_logarithm(x) && !is_below(x.value(), farthest)) return N<V>(V::indeterminate());
    if (!keeps_its_logarithm(x) && !is_below(x.value(), near)) {
        if (!is_principal(x)) return N<V>(V::indeterminate());
        const V value = special_function(op, order, x.value());
        if constexpr (std::same_as<V, Ball>) return N<V>(value);
        // with the order that it has near 0: of which sheet a root or a logarithm of it is must not depend on the piece
        const N<V> front = to_power(x / N<V>(2), integer ? Exponent(-static_cast<long>(nu)) : exponent);
        return front * N<V>(value / front.value());
    }
    return integer ? with_logarithm(op, static_cast<long>(nu), x) : with_power(op, exponent, x);
}

} // namespace

EllipticAboutOne about_one_by_size(const Ball& q, bool of_k)
{
    const Ball one_less = Ball(1) - q, quarter = pi<Ball>() / Ball(4), half = quarter + quarter;
    const auto own = elliptic_over_pi(one_less, !of_k);
    const Ball rest = own.k * (log_of_16() - touchstone::log(q)) - first_kind_of_complement(q);
    EllipticAboutOne sums{disc_about(half, own.k * pi<Ball>() - half), disc_about(Ball(0), rest), ComplexBall::indeterminate()};
    if (!of_k) sums.regular = disc_about(quarter, (own.k - own.e) * pi<Ball>() / q - quarter);
    return sums;
}

N<Ball> elliptic_of_complement(Op op, const N<Ball>& u) { return elliptic(op, u); }
N<ComplexBall> elliptic_of_complement(Op op, const N<ComplexBall>& u) { return elliptic(op, u); }
std::optional<N<Ball>> bessel_about_zero(Op op, const Ball& order, const N<Ball>& x) { return bessel(op, order, x); }
std::optional<N<ComplexBall>> bessel_about_zero(Op op, const Ball& order, const N<ComplexBall>& x) { return bessel(op, order, x); }

} // namespace touchstone::quadrature
