// SPDX-License-Identifier: MIT
/// \file
/// Fractions in fixed point that count what they are off by (internal to quadrature/).
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/flint_headers.hpp"

#include <boost/container/small_vector.hpp>
#include <gmp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace touchstone::quadrature {

/// What a fraction is off by, in units of its last place: below 2^31, or unknown.
class Units {
public:
    Units() = default;
    explicit Units(std::uint64_t count) : count_(count <= most ? count : unknown) {}
    bool is_known() const { return count_ != unknown; }
    std::uint64_t count() const { return count_; }

    friend Units operator+(Units a, Units b) { return a.is_known() && b.is_known() ? Units(a.count_ + b.count_) : Units(unknown); }
    /// At least times w/2^32, w <= 2^32 + 1; for w = 2^31 half a unit more.
    Units times(std::uint64_t w) const { return is_known() ? Units(((count_ * w) >> 32) + 1) : *this; }
    /// At least over w/2^32.
    Units over(std::uint64_t w) const { return is_known() && w > 0 ? Units((count_ << 32) / w + 1) : Units(unknown); }

private:
    static constexpr std::uint64_t most = (1ULL << 31) - 1, unknown = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t count_ = 0;
};

template <std::size_t few>
using Limbs = boost::container::small_vector<mp_limb_t, few>; // in place for numbers of some hundred bits

/// n 2^(-64 limbs), within so many units of a number in [0, 1).
struct Fraction {
    Limbs<8> n;
    Units off;
};

/// The operations on fractions of so many limbs. Each rounds down, by less than a unit, and counts what its result is off by: x stands for
/// the fraction, x' for the number it is known for.
class Fractions {
public:
    static constexpr int limb_bits = 64;
    /// Two at least.
    explicit Fractions(std::size_t limbs)
        : limbs_(static_cast<mp_size_t>(limbs)), scratch_(2 * limbs), quotient_(limbs + 1), remainder_(limbs)
    {
    }

    long bits() const { return limb_bits * limbs_; }
    Fraction zero() const { return {Limbs<8>(remainder_.size()), {}}; }
    Fraction half() const
    {
        Fraction x = zero();
        x.n.back() = mp_limb_t{1} << (limb_bits - 1);
        return x;
    }
    /// The middle of a ball, at most a unit below it. \pre it is in [0, 1)
    Fraction of(const Ball& ball) const
    {
        Fraction x = zero();
        x.off = Units(1);
        fmpz_t whole;
        fmpz_init(whole);
        arf_get_fmpz_fixed_si(whole, arb_midref(ball.get()), -bits());
        fmpz_get_ui_array(x.n.data(), limbs_, whole);
        fmpz_clear(whole);
        return x;
    }
    Ball ball(const Fraction& x) const
    {
        if (!x.off.is_known()) return Ball::indeterminate();
        Ball r;
        const mp_size_t used = used_of(x);
        if (used > 0) arf_set_mpn(arb_midref(r.get()), x.n.data(), used, 0);
        mag_set_ui(arb_radref(r.get()), x.off.count());
        arb_mul_2exp_si(r.get(), r.get(), -bits());
        return r;
    }
    /// About, and -oo of 0.
    double log2(const Fraction& x) const
    {
        const mp_size_t used = used_of(x);
        if (used == 0) return -std::numeric_limits<double>::infinity();
        const mp_limb_t highest = x.n[static_cast<std::size_t>(used - 1)];
        return std::log2(static_cast<double>(highest)) - static_cast<double>(limb_bits * (limbs_ - used + 1));
    }
    /// x' is below 2^-that.
    int zeros(const Fraction& x)
    {
        if (!x.off.is_known() || mpn_add_1(quotient_.data(), x.n.data(), limbs_, x.off.count()) != 0) return 0;
        int count = 0;
        for (auto k = x.n.size(); k-- > 0; count += limb_bits)
            if (quotient_[k] != 0) return count + std::countl_zero(quotient_[k]);
        return count;
    }

    /// \pre a + b < 1
    void add(Fraction& r, const Fraction& a, const Fraction& b) const
    {
        mpn_add_n(r.n.data(), a.n.data(), b.n.data(), limbs_);
        r.off = a.off + b.off;
    }
    /// \pre a' >= b'; 0 where only what they are off by says otherwise
    void subtract(Fraction& r, const Fraction& a, const Fraction& b) const
    {
        r.off = a.off + b.off;
        if (mpn_cmp(a.n.data(), b.n.data(), limbs_) < 0) std::fill(r.n.begin(), r.n.end(), 0);
        else mpn_sub_n(r.n.data(), a.n.data(), b.n.data(), limbs_);
    }
    /// Half of what x is off by, and half of a unit, which rounding up half of a whole number and one more has room for.
    void halve(Fraction& x) const
    {
        mpn_rshift(x.n.data(), x.n.data(), limbs_, 1);
        x.off = x.off.times(1ULL << 31);
    }
    /// |a b - a' b'| <= a |b - b'| + b' |a - a'|, and b' is above b by 2^-32 at most, as there are two limbs.
    void multiply(Fraction& r, const Fraction& a, const Fraction& b)
    {
        const Units off = b.off.times(top(a) + 1) + a.off.times(top(b) + 2) + Units(1); // before r, which may be one of them, changes
        mpn_mul_n(scratch_.data(), a.n.data(), b.n.data(), limbs_);
        std::copy(scratch_.begin() + limbs_, scratch_.end(), r.n.begin());
        r.off = off;
    }
    /// |sqrt x - sqrt x'| = |x - x'|/(sqrt x + sqrt x') <= |x - x'|/((2 - 2^-8) sqrt x), for x' >= (1 - 2^-8) x as x is off by less than
    /// 2^31 2^-128. \pre x >= 2^-64
    void root(Fraction& r, const Fraction& x)
    {
        std::copy(x.n.begin(), x.n.end(), std::fill_n(scratch_.begin(), limbs_, 0));
        mpn_sqrtrem(r.n.data(), nullptr, scratch_.data(), 2 * limbs_);
        const std::uint64_t least = top(r);
        r.off = x.off.over(2 * least - (least >> 8) - 1) + Units(1);
    }
    /// |d/s - d'/s'| <= (|d - d'| + (d'/s') |s - s'|)/s. \pre d < s, d' < s', s >= 2^-32
    void divide(Fraction& r, const Fraction& d, const Fraction& s)
    {
        std::copy(d.n.begin(), d.n.end(), std::fill_n(scratch_.begin(), limbs_, 0));
        const Units off = (d.off + s.off).over(top(s)) + Units(1);
        mpn_tdiv_qr(quotient_.data(), remainder_.data(), 0, scratch_.data(), 2 * limbs_, s.n.data(), limbs_);
        std::copy_n(quotient_.begin(), limbs_, r.n.begin());
        r.off = off;
    }
    /// d < s and d' < s', of numbers that are off by less than 2^31 2^-128.
    static bool is_clearly_below(const Fraction& d, const Fraction& s) { return top(d) + 2 < top(s); }
    /// c 2^-power more. \pre that is below 1, and so is the sum; power <= bits()
    void add_integer(Fraction& x, mp_limb_t c, long power) const
    {
        const long place = bits() - power, limb = place / limb_bits, up = place % limb_bits;
        const std::array<mp_limb_t, 2> shifted{c << up, up == 0 ? 0 : c >> (limb_bits - up)};
        mpn_add(x.n.data() + limb, x.n.data() + limb, limbs_ - limb, shifted.data(), std::min(limbs_ - limb, 2L));
    }

private:
    /// Limbs up to the highest that is not 0.
    static mp_size_t used_of(const Fraction& x)
    {
        return x.n.rend() - std::find_if(x.n.rbegin(), x.n.rend(), [](mp_limb_t limb) { return limb != 0; });
    }
    /// x is at least that over 2^32, and below one more.
    static std::uint64_t top(const Fraction& x) { return x.n.back() >> 32; }

    mp_size_t limbs_;
    Limbs<16> scratch_;
    Limbs<9> quotient_;
    Limbs<8> remainder_;
};

} // namespace touchstone::quadrature
