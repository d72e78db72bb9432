// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/fixed_means.hpp"

#include "touchstone/quadrature/fractions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace touchstone::quadrature {
namespace {

constexpr long most_terms = 14; // of the two series below: one more costs about as much as the mean that it saves
/// binomial(2k, k)
constexpr std::array<mp_limb_t, most_terms + 1> central_binomials = [] {
    std::array<mp_limb_t, most_terms + 1> c{1};
    for (std::size_t k = 1; k <= most_terms; ++k) c[k] = c[k - 1] * (4 * k - 2) / k;
    return c;
}();

/// 2^-(1 + step) sum over k >= 0 of c_k c_(k + step) (h/16)^k, c_k = binomial(2k, k), step 0 or 1, h' <= 2^-zeros, zeros >= 1. A term is at
/// most h^k/2, so that from k = n on there is less than h^n.
Fraction sum_of_binomials(Fractions& fractions, const Fraction& h, int zeros, std::size_t step)
{
    const long terms = (fractions.bits() + zeros - 1) / zeros;
    Fraction sum = fractions.zero();
    for (auto k = static_cast<std::size_t>(terms); k-- > 0;) {
        fractions.multiply(sum, sum, h);
        fractions.add_integer(sum, central_binomials[k] * central_binomials[k + step], static_cast<long>(4 * k + 1 + step));
    }
    sum.off = sum.off + Units(1);
    return sum;
}

/// a = 1/2, b = sqrt(v)/2 after so many means that a short series in h = ((a - b)/(a + b))^2 is left.
struct Means {
    Fraction sum, h; // a + b, h
    Fraction part;   // where E is asked for: (1 + v)/2 less the sum of 2^j (a - b)^2 over the means before, j = 0, 1, ...
    int count = 0, zeros = 0;
};

class MeansOf {
public:
    MeansOf(Fractions& fractions, const Fraction& v, bool with_e)
        : on_(fractions), with_e_(with_e), a_(on_.half()), b_(on_.zero()), difference_(on_.zero()), product_(on_.zero()),
          found_{on_.zero(), on_.zero(), on_.zero()}
    {
        on_.root(b_, v);
        on_.halve(b_);
        if (!with_e_) return;
        found_.part = v;
        on_.halve(found_.part);
        on_.add_integer(found_.part, 1, 1);
    }

    /// None if the series would be too long all the same.
    std::optional<Means> found()
    {
        constexpr int most = 32; // each doubles the bits of 1/h at least, once a and b are near each other
        for (;; ++found_.count) {
            on_.add(found_.sum, a_, b_);
            on_.subtract(difference_, a_, b_);
            if (is_close()) return std::move(found_);
            if (found_.count == most) return std::nullopt;
            step();
        }
    }

private:
    bool is_close()
    {
        const double size = 2 * (on_.log2(difference_) - on_.log2(found_.sum));
        if (size * most_terms > -static_cast<double>(on_.bits())) return false;
        on_.divide(product_, difference_, found_.sum);
        on_.multiply(found_.h, product_, product_);
        found_.zeros = on_.zeros(found_.h);
        return found_.zeros * most_terms >= on_.bits();
    }
    void step()
    {
        on_.multiply(product_, a_, b_);
        on_.root(b_, product_);
        std::swap(a_, found_.sum);
        on_.halve(a_);
        if (!with_e_) return;
        on_.multiply(product_, difference_, difference_);
        for (int j = 0; j < found_.count; ++j) on_.add(product_, product_, product_);
        on_.subtract(found_.part, found_.part, product_);
    }

    Fractions& on_;
    bool with_e_;
    Fraction a_, b_, difference_, product_;
    Means found_;
};

/// d/s, d halved until that is a fraction. \pre s is no smaller than a hundredth
Ball quotient(Fractions& fractions, Fraction d, const Fraction& s)
{
    int halvings = 0;
    for (; !Fractions::is_clearly_below(d, s); ++halvings) fractions.halve(d);
    fractions.divide(d, d, s);
    Ball r = fractions.ball(d);
    arb_mul_2exp_si(r.get(), r.get(), halvings);
    return r;
}

void widen_by_part(Ball& x, const mag_t part)
{
    mag_t size;
    mag_init(size);
    arb_get_mag(size, x.get());
    mag_mul(size, size, part);
    arb_add_error_mag(x.get(), size);
    mag_clear(size);
}

/// From the middle m of v to all of m +- r: K and E change by r/(m - r) of themselves at most.
void widen_to(const Ball& v, Elliptic<Ball>& at_middle)
{
    if (v.is_exact()) return;
    mag_t part;
    mag_init(part);
    arb_get_mag_lower(part, v.get());
    mag_div(part, arb_radref(v.get()), part);
    widen_by_part(at_middle.k, part);
    if (at_middle.e.is_finite()) widen_by_part(at_middle.e, part);
    mag_clear(part);
}

/// Of v in [2^-32, 1).
std::optional<Elliptic<Ball>> below_one(const Ball& v, bool with_e)
{
    constexpr long spare = 4; // bits, for what the operations are off by
    const slong bits = WorkingPrecision::bits();
    const long lost = 1 - arf_abs_bound_lt_2exp_si(arb_midref(v.get())); // by the roots
    const long limbs = std::max(2L, (bits + lost + spare + Fractions::limb_bits - 1) / Fractions::limb_bits);
    Fractions fractions(static_cast<std::size_t>(limbs));
    const auto means = MeansOf(fractions, fractions.of(v), with_e).found();
    if (!means) return std::nullopt;
    Elliptic<Ball> r{quotient(fractions, sum_of_binomials(fractions, means->h, means->zeros, 0), means->sum), Ball::indeterminate()};
    if (with_e) {
        const Ball series = fractions.ball(sum_of_binomials(fractions, means->h, means->zeros, 1));
        Ball rest = fractions.ball(means->sum) * fractions.ball(means->h) * series;
        arb_mul_2exp_si(rest.get(), rest.get(), means->count);
        r.e = r.k * fractions.ball(means->part) - rest;
    }
    widen_to(v, r);
    return r;
}

} // namespace

std::optional<Elliptic<Ball>> by_fixed_means(const Ball& v, bool with_e)
{
    constexpr long farthest = 32; // log2 of v or 1/v: the roots lose as many bits
    arf_srcptr middle = arb_midref(v.get());
    if (!v.is_finite() || arb_is_positive(v.get()) == 0 || arf_cmpabs_2exp_si(middle, farthest) > 0 ||
        arf_cmpabs_2exp_si(middle, -farthest) < 0 || arf_is_one(middle) != 0)
        return std::nullopt;
    if (arf_cmpabs_2exp_si(middle, 0) < 0) return below_one(v, with_e);
    Ball at;
    arb_set_arf(at.get(), middle);
    const Ball inverse = Ball(1) / at, root = sqrt(at);
    if (arf_cmpabs_2exp_si(arb_midref(inverse.get()), 0) >= 0) return std::nullopt; // v is next to 1
    auto found = below_one(inverse, with_e);
    if (!found) return std::nullopt;
    found->k /= root; // DLMF 19.7.2
    found->e *= root;
    widen_to(v, *found);
    return found;
}

} // namespace touchstone::quadrature
