// SPDX-License-Identifier: MIT
#include "touchstone/transfer/fixed.hpp"

#include <stdexcept>

namespace touchstone::transfer {

namespace {

/// fmpz_t with a lifetime: what does not fit is refused by an exception.
struct Units {
    Units() { fmpz_init(n); }
    ~Units() { fmpz_clear(n); }
    Units(const Units&) = delete;
    Units& operator=(const Units&) = delete;
    fmpz_t n;
};

} // namespace

void FixedFormat::put(mp_limb_t* out, const fmpz_t units) const
{
    mpz_t z;
    mpz_init(z);
    fmpz_get_mpz(z, units);
    const std::size_t used = mpz_size(z);
    const auto n = static_cast<std::size_t>(limbs_);
    if (mpz_sizeinbase(z, 2) >= static_cast<std::size_t>(64 * limbs_)) {
        mpz_clear(z);
        throw std::logic_error("transfer: a number does not fit its fixed-point format");
    }
    for (std::size_t i = 0; i < n; ++i) out[i] = i < used ? mpz_getlimbn(z, static_cast<mp_size_t>(i)) : 0;
    if (mpz_sgn(z) < 0) mpn_neg(out, out, limbs_);
    mpz_clear(z);
}

void FixedFormat::put(mp_limb_t* out, const Ball& b) const
{
    if (!b.is_finite()) throw std::logic_error("transfer: a number is not finite");
    Units units;
    arf_t scaled;
    arf_init(scaled);
    arf_mul_2exp_si(scaled, arb_midref(b.get()), fraction());
    arf_get_fmpz(units.n, scaled, ARF_RND_FLOOR);
    arf_clear(scaled);
    put(out, units.n);
}

void FixedFormat::get(fmpz_t units, const mp_limb_t* in) const
{
    std::vector<mp_limb_t> t(in, in + limbs_);
    const bool negative = t.back() >> 63;
    if (negative) mpn_neg(t.data(), t.data(), limbs_);
    mpz_t z;
    mpz_init(z);
    mpz_import(z, t.size(), -1, sizeof(mp_limb_t), 0, 0, t.data());
    fmpz_set_mpz(units, z);
    mpz_clear(z);
    if (negative) fmpz_neg(units, units);
}

Ball FixedFormat::dot(const mp_limb_t* a, const mp_limb_t* b, std::size_t length) const
{
    Products sum(*this);
    for (std::size_t j = 0; j < length; ++j) sum.add(a + j * static_cast<std::size_t>(limbs_), b + j * static_cast<std::size_t>(limbs_));
    return sum.value();
}

Ball FixedFormat::Products::value() const
{
    std::vector<mp_limb_t> sum = sum_;
    const bool negative = sum.back() >> 63;
    if (negative) mpn_neg(sum.data(), sum.data(), 2 * format_.limbs_);
    mpz_t z;
    mpz_init(z);
    mpz_import(z, sum.size(), -1, sizeof(mp_limb_t), 0, 0, sum.data());
    if (negative) mpz_neg(z, z);
    Ball r;
    arf_set_mpz(arb_midref(r.get()), z);
    mpz_clear(z);
    arb_mul_2exp_si(r.get(), r.get(), -2 * format_.fraction());
    return r;
}

} // namespace touchstone::transfer
