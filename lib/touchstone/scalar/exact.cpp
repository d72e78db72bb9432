// SPDX-License-Identifier: MIT
#include "touchstone/scalar/exact.hpp"

#include <limits>
#include <numeric>

namespace touchstone {
namespace {

// Beyond these sizes exactness costs more than it tells; the caller uses balls.
constexpr unsigned long degree_limit = 4096;
constexpr std::size_t bit_limit = 1'000'000;

std::size_t bits(const Rational& r)
{
    return mpz_sizeinbase(r.get_num_mpz_t(), 2) + mpz_sizeinbase(r.get_den_mpz_t(), 2);
}

Rational bounded_power(const Rational& r, long e)
{
    if (r != 1 && static_cast<std::size_t>(std::labs(e)) > bit_limit / bits(r)) throw NotExact();
    return power(r, e);
}

/// x as a long, if it is one.
long small_integer(const Rational& x)
{
    if (x.get_den() != 1 || !x.get_num().fits_slong_p()) throw NotExact();
    const long n = x.get_num().get_si();
    if (n == std::numeric_limits<long>::min()) throw NotExact(); // it has no negative
    return n;
}

} // namespace

void Exact::normalise()
{
    if (factor_ == 0) {
        *this = Exact();
        return;
    }
    for (unsigned long p = 2; p <= degree_; ++p)
        while (degree_ % p == 0) {
            const auto root = exact_root(radicand_, p);
            if (!root) break;
            radicand_ = *root;
            degree_ /= p;
        }
    if (degree_ == 1) {
        factor_ *= radicand_;
        radicand_ = 1;
    }
}

const Rational& Exact::rational() const
{
    if (!is_rational()) throw NotExact();
    return factor_;
}

Ball Exact::ball() const
{
    Ball b(factor_);
    if (degree_ != 1) {
        Ball root;
        arb_root_ui(root.get(), Ball(radicand_).get(), degree_, WorkingPrecision::bits());
        b *= root;
    }
    if (pi_power_ != 0) b *= pow(touchstone::pi<Ball>(), Ball(pi_power_));
    return b;
}

Exact operator*(const Exact& a, const Exact& b)
{
    Exact r;
    r.factor_ = a.factor_ * b.factor_;
    r.pi_power_ = a.pi_power_ + b.pi_power_;
    r.degree_ = std::lcm(a.degree_, b.degree_);
    if (r.degree_ > degree_limit || bits(r.factor_) > bit_limit) throw NotExact();
    r.radicand_ = bounded_power(a.radicand_, static_cast<long>(r.degree_ / a.degree_))
                  * bounded_power(b.radicand_, static_cast<long>(r.degree_ / b.degree_));
    r.normalise();
    return r;
}

Exact operator/(const Exact& a, const Exact& b)
{
    if (b.is_zero()) throw NotExact();
    return a * b.power(Rational(-1));
}

Exact operator+(const Exact& a, const Exact& b)
{
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    return b * Exact(Rational((a / b).rational() + 1));
}

bool operator==(const Exact& a, const Exact& b)
{
    if (a.is_zero() || b.is_zero()) return a.is_zero() && b.is_zero();
    const Exact q = a / b;
    return q.is_rational() && q.factor_ == 1;
}

Exact Exact::power(const Rational& e) const
{
    if (e.get_den() == 1) {
        if (is_zero()) return e > 0 ? Exact(0) : (e == 0 ? Exact(1) : throw NotExact());
        const long n = small_integer(e);
        // s^(n/m) in lowest terms: where p divides what is left of m it does not divide what is left of n, and s^n is a p-th power only if
        // s is
        const auto common = static_cast<long>(std::gcd(static_cast<unsigned long>(std::labs(n)), degree_));
        Exact r;
        r.factor_ = bounded_power(factor_, n);
        r.radicand_ = bounded_power(radicand_, n / common);
        r.degree_ = degree_ / static_cast<unsigned long>(common);
        r.pi_power_ = pi_power_ * e;
        if (r.degree_ == 1 || r.factor_ == 0) r.normalise();
        return r;
    }
    if (sign() < 0) throw NotExact();
    if (is_zero()) return e > 0 ? Exact(0) : throw NotExact();
    // (r s^(1/m))^(p/q) = (r^m s)^(p/(q m))
    if (!e.get_den().fits_ulong_p()) throw NotExact();
    const unsigned long q = e.get_den().get_ui();
    const long p = small_integer(Rational(e.get_num()));
    Exact r;
    r.factor_ = 1;
    r.pi_power_ = pi_power_ * e;
    const Rational base = bounded_power(factor_, static_cast<long>(degree_)) * radicand_;
    if (q > degree_limit / degree_) {
        // Too high a degree to hold as a radical: a perfect power of that degree is rational, anything else is left to balls.
        if (q > bit_limit) {
            if (base != 1) throw NotExact();
            return r;
        }
        const auto root = exact_root(base, q * degree_);
        if (!root) throw NotExact();
        r.factor_ = bounded_power(*root, p);
        return r;
    }
    r.degree_ = degree_ * q;
    r.radicand_ = bounded_power(base, p);
    r.normalise();
    return r;
}

Exact sqrt(const Exact& x) { return x.power(Rational(1, 2)); }

Exact exp(const Exact& x) { return x.is_zero() ? Exact(1) : throw NotExact(); }

Exact log(const Exact& x) { return x == Exact(1) ? Exact(0) : throw NotExact(); }

Exact pow(const Exact& x, const Exact& y) { return x.power(y.rational()); }

Exact asin(const Exact& x) { return ScalarTraits<Exact>::pi() / 2 - acos(x); }

Exact acos(const Exact& x) { return atan2(sqrt(Exact(1) - x * x), x); }

Exact atan2(const Exact& y, const Exact& x)
{
    // Niven: the only rational multiples of pi whose tangent squared is rational are those of 0, pi/6, pi/4, pi/3, pi/2.
    const Exact half_turn = ScalarTraits<Exact>::pi();
    if (x.is_zero() && y.is_zero()) throw NotExact();
    Exact angle; // of the first quadrant
    if (x.is_zero()) angle = half_turn / 2;
    else {
        const Exact q = y / x;
        const Rational t = (q * q).rational();
        if (t == 0) angle = Exact(0);
        else if (t == Rational(1, 3)) angle = half_turn / 6;
        else if (t == 1) angle = half_turn / 4;
        else if (t == 3) angle = half_turn / 3;
        else throw NotExact();
    }
    if (x.sign() < 0) angle = half_turn - angle;
    return y.sign() < 0 ? -angle : angle;
}

Truth less(const Exact& x, const Exact& y)
{
    if (x == y) return Truth::no;
    // Different elements of the set are different numbers (pi is transcendental), so this ends.
    for (slong bits = 64;; bits *= 2) {
        const WorkingPrecision precision(bits);
        const Truth t = less(x.ball(), y.ball());
        if (t != Truth::unknown) return t;
    }
}

Exact ScalarTraits<Exact>::pi() { return Exact::pi_to(Rational(1)); }

Exact ScalarTraits<Exact>::gamma(const Exact& x)
{
    // Gamma(n) and Gamma(n + 1/2) by the recurrence from Gamma(1) = 1, Gamma(1/2) = sqrt(pi).
    const Rational r = x.rational();
    if (r <= 0 || r > 1000 || Rational(2 * r).get_den() != 1) throw NotExact();
    const bool whole = r.get_den() == 1;
    Exact value = whole ? Exact(1) : Exact::pi_to(Rational(1, 2));
    for (Rational k = whole ? Rational(1) : Rational(1, 2); k < r; k += 1) value = value * Exact(k);
    return value;
}

Exact ScalarTraits<Exact>::cos_pi(const Exact& x)
{
    Rational r = x.rational();
    // reduce to [0, 2), then to [0, 1] by symmetry
    Integer turns;
    const Rational half = r / 2;
    mpz_fdiv_q(turns.get_mpz_t(), half.get_num_mpz_t(), half.get_den_mpz_t());
    r -= 2 * Rational(turns);
    if (r > 1) r = 2 - r;
    const bool negative = 2 * r > 1;
    if (negative) r = 1 - r;
    Exact c;
    if (r == 0) c = Exact(1);
    else if (r == Rational(1, 2)) c = Exact(0);
    else if (r == Rational(1, 3)) c = Exact(Rational(1, 2));
    else if (r == Rational(1, 4)) c = sqrt(Exact(Rational(1, 2)));
    else if (r == Rational(1, 6)) c = sqrt(Exact(Rational(3, 4)));
    else throw NotExact();
    return negative ? -c : c;
}

Exact ScalarTraits<Exact>::power_of_two(long e)
{
    if (static_cast<std::size_t>(std::labs(e)) > bit_limit) throw NotExact();
    return Exact(power(Rational(2), e));
}

} // namespace touchstone
