// SPDX-License-Identifier: MIT
/// \file
/// Fixed-point numbers in two's complement, for the inner loops of the transfer operator. Internal to transfer/.
///
/// A number is `limbs` words; its unit is 2^-fraction with fraction = 64 limbs - 16, so |value| < 2^15.
/// Sums are exact. A product is rounded down by less than one unit. Nothing here rounds in any other way,
/// which is what the error counts in discretisation.hpp rely on.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <gmp.h>

#include <cstddef>
#include <vector>

namespace touchstone::transfer {

class FixedFormat {
public:
    static constexpr int headroom = 16;
    explicit FixedFormat(long fraction_at_least)
        : limbs_(static_cast<int>((fraction_at_least + headroom + 63) / 64)) {}
    int limbs() const { return limbs_; }
    long fraction() const { return 64L * limbs_ - headroom; }
    Ball unit() const { return ScalarTraits<Ball>::power_of_two(-fraction()); }

    /// The midpoint of b rounded down to the format; |result - true value| <= radius of b + unit.
    /// \throws std::logic_error if it does not fit
    void put(mp_limb_t* out, const Ball& b) const;
    void put(mp_limb_t* out, const fmpz_t units) const;
    void get(fmpz_t units, const mp_limb_t* in) const;
    /// 2^shift a b, rounded down by less than a unit. scratch: 2 limbs. out may not overlap a, b.
    void multiply(mp_limb_t* out, const mp_limb_t* a, const mp_limb_t* b, unsigned shift, mp_limb_t* scratch) const
    {
        product(scratch, a, b);
        const mp_limb_t below = scratch[limbs_ - 1];
        const unsigned up = headroom + shift;
        mpn_lshift(out, scratch + limbs_, limbs_, up);
        out[0] |= below >> (64 - up);
    }
    /// sum_j a_j b_j exactly, in units 2^(-2 fraction), as an enclosing (exact) ball.
    Ball dot(const mp_limb_t* a, const mp_limb_t* b, std::size_t length) const;

    /// An exact sum of products.
    class Products {
    public:
        explicit Products(const FixedFormat& format) : format_(format), sum_(2 * static_cast<std::size_t>(format.limbs_)), term_(sum_) {}
        void clear() { sum_.assign(sum_.size(), 0); }
        void add(const mp_limb_t* a, const mp_limb_t* b)
        {
            format_.product(term_.data(), a, b);
            mpn_add_n(sum_.data(), sum_.data(), term_.data(), 2 * format_.limbs_);
        }
        Ball value() const;
        /// Rounded down by less than a unit. \pre |sum| < 2^15
        void put(mp_limb_t* out) const
        {
            mpn_lshift(out, sum_.data() + format_.limbs_, format_.limbs_, headroom);
            out[0] |= sum_[static_cast<std::size_t>(format_.limbs_) - 1] >> (64 - headroom);
        }

    private:
        const FixedFormat& format_;
        std::vector<mp_limb_t> sum_, term_;
    };

private:
    /// The full signed product, 2 limbs words.
    void product(mp_limb_t* out, const mp_limb_t* a, const mp_limb_t* b) const
    {
        mpn_mul_n(out, a, b, limbs_);
        if (a[limbs_ - 1] >> 63) mpn_sub_n(out + limbs_, out + limbs_, b, limbs_);
        if (b[limbs_ - 1] >> 63) mpn_sub_n(out + limbs_, out + limbs_, a, limbs_);
    }
    int limbs_;
};

} // namespace touchstone::transfer
