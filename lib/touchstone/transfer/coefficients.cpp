// SPDX-License-Identifier: MIT
#include "touchstone/transfer/coefficients.hpp"

#include "touchstone/transfer/wide_balls.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::transfer {

using Real = DoubleDouble<double>;

Coefficients::Coefficients(const FixedFormat& format, long p)
    : format_(format), terms_(static_cast<std::size_t>(p)), columns_((terms_ + 3) / 4 * 4)
{
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    cosines_.resize(4 * terms_ * limbs);
    near_ = Wide(terms_ * columns_);
    Wide near(4 * terms_);
    for (std::size_t m = 0; m < 4 * terms_; ++m) {
        const Ball c = 2 * ScalarTraits<Ball>::cos_pi(Ball(static_cast<long>(m)) / Ball(2 * p)) / Ball(p);
        format_.put(&cosines_[m * limbs], c);
        near.set(m, to_real(c));
    }
    for (std::size_t k = 0; k < terms_; ++k)
        for (std::size_t j = 0; j < terms_; ++j) {
            const Real c = near[k * (2 * j + 1) % (4 * terms_)] * (k == 0 ? 0.5 : 1);
            near_.high.at(k * columns_ + j) = c.high;
            near_.low.at(k * columns_ + j) = c.low;
        }
}

void Coefficients::of(const mp_limb_t* values, mp_limb_t* coefficients) const
{
    const auto limbs = static_cast<std::size_t>(format_.limbs()), half = (terms_ + 1) / 2;
    const auto size = static_cast<mp_size_t>(limbs);
    std::vector<mp_limb_t> part[2]{std::vector<mp_limb_t>(half * limbs), std::vector<mp_limb_t>(half * limbs)};
    for (std::size_t j = 0; j < half; ++j) { // tau_{p-1-j} = -tau_j: sums for even k, differences for odd
        const mp_limb_t *const here = values + j * limbs, *const there = values + (terms_ - 1 - j) * limbs;
        if (2 * j + 1 == terms_) { // the middle one, once
            std::copy_n(here, limbs, &part[0][j * limbs]);
            break;
        }
        mpn_add_n(&part[0][j * limbs], here, there, size);
        mpn_sub_n(&part[1][j * limbs], here, there, size);
    }
    FixedFormat::Products sum(format_);
    for (std::size_t k = 0; k < terms_; ++k) {
        sum.clear();
        for (std::size_t j = 0; j < half; ++j) sum.add(&cosines_[k * (2 * j + 1) % (4 * terms_) * limbs], &part[k % 2][j * limbs]);
        mp_limb_t* const c = coefficients + k * limbs;
        sum.put(c);
        if (k > 0) continue;
        const mp_limb_t sign = c[limbs - 1] & (mp_limb_t{1} << 63); // halved
        mpn_rshift(c, c, size, 1);
        c[limbs - 1] |= sign;
    }
}

namespace {

constexpr std::size_t words_taken = 3; ///< two, and what the highest of them lacks
constexpr long least_exponent = -736; ///< far above where binary64 numbers lose bits or vanish

bool negative(const mp_limb_t* number, std::size_t limbs) { return number[limbs - 1] >> 63; }

/// One more than the highest word that any of the numbers has beyond its sign, three at least: |numbers| < 2^(64 top) units, and if
/// top > 3 one of them is, or misses by less than a unit, at least 2^(64 (top - 1)).
std::size_t words_of(const mp_limb_t* numbers, std::size_t count, std::size_t limbs)
{
    std::size_t top = std::min(limbs, words_taken);
    for (std::size_t k = 0; k < count; ++k) {
        const mp_limb_t* const number = numbers + k * limbs;
        const mp_limb_t sign = negative(number, limbs) ? ~mp_limb_t{0} : 0;
        for (std::size_t word = limbs; word > top; --word)
            if (number[word - 1] != sign) top = word;
    }
    return top;
}

/// A fixed-point number by the three words below `top`: off by less than 2^(64 (top - 3)) units, at least a unit, 2^-100 of itself and
/// what binary64 loses below 2^-1022.
Real leading_words(const mp_limb_t* number, std::size_t limbs, std::size_t top)
{
    const bool below_zero = negative(number, limbs);
    Real sum;
    std::size_t word = top;
    for (std::size_t taken = std::min(top, words_taken); taken > 0; --taken, --word) {
        const mp_limb_t digits = below_zero ? ~number[word - 1] : number[word - 1]; // the last unit does not count
        const int unit = FixedFormat::headroom - 64 * static_cast<int>(limbs - (word - 1));
        sum += std::ldexp(static_cast<double>(digits >> 32), unit + 32);
        sum += std::ldexp(static_cast<double>(digits & 0xffffffff), unit);
    }
    return below_zero ? -sum : sum;
}

} // namespace

double Coefficients::row(const mp_limb_t* moments, double* near) const
{
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    const std::size_t top = words_of(moments, terms_, limbs);
    Wide leading(terms_), sums(columns_);
    double most = 0;
    for (std::size_t k = 0; k < terms_; ++k) {
        const Real moment = leading_words(moments + k * limbs, limbs, top);
        leading.set(k, moment);
        most = std::max(most, std::fabs(moment.high));
    }
    add_products(near_, 0, leading, columns_, sums);
    std::copy_n(sums.high.data(), terms_, near);
    return row_error(most);
}

double Coefficients::row_error(double most) const
{
    return std::ldexp(most, -80) + std::ldexp(1.0, static_cast<int>(2 + std::max(-format_.fraction(), least_exponent)));
}

} // namespace touchstone::transfer
