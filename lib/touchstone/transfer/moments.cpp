// SPDX-License-Identifier: MIT
#include "touchstone/transfer/moments.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::transfer {

std::vector<std::size_t> words_to_spare(double rho, long points)
{
    std::vector<std::size_t> spare;
    const double bits = std::log2(rho) * (1 - 1e-12); // below log2 rho, as computed and multiplied
    for (long k = 0; k < points; ++k) spare.push_back(static_cast<std::size_t>(static_cast<double>(k) * bits / 64));
    return spare;
}

Moments::Moments(const FixedFormat& format)
    : format_(format), limbs_(static_cast<std::size_t>(format.limbs())), tau_(limbs_), a_(limbs_), b_(limbs_), c_(limbs_),
      scratch_(2 * limbs_)
{
    for (int m = 0; m <= format.limbs(); ++m) formats_.emplace_back(64L * m - FixedFormat::headroom);
}

void Moments::add(const Ball& weight, const Ball& tau, const std::vector<std::size_t>& spare, mp_limb_t* sum)
{
    format_.put(tau_.data(), tau);
    format_.put(a_.data(), weight);
    std::size_t words = significant(a_.data(), limbs_), gone = 0; // of V, above `gone`
    mp_limb_t *before = a_.data(), *now = b_.data(), *next = c_.data();
    multiply(now, before, words, 0);
    add_at(sum, limbs_, before, words, 0);
    if (spare.size() > 1) add_at(sum + limbs_, limbs_, now, words, 0);
    for (std::size_t k = 2; k < spare.size(); ++k) {
        if (const std::size_t drop = spare[k] - gone; drop > 0) {
            if (drop >= words) return; // the rest is less than a unit
            words -= drop;
            gone = spare[k];
            for (mp_limb_t* u : {before, now}) std::copy(u + drop, u + drop + words, u);
        }
        multiply(next, now, words, 1);
        mpn_sub_n(next, next, before, static_cast<mp_size_t>(words));
        add_at(sum + k * limbs_, limbs_, next, words, gone);
        mp_limb_t* const free = before;
        before = now, now = next, next = free;
    }
}

std::size_t Moments::significant(const mp_limb_t* number, std::size_t limbs)
{
    std::size_t top = limbs;
    while (top > 1 && number[top - 1] == 0) --top;
    return std::min(limbs, top + (number[top - 1] >> (64 - 18) ? 1 : 0));
}

void Moments::multiply(mp_limb_t* out, const mp_limb_t* u, std::size_t words, unsigned shift)
{
    formats_[words].multiply(out, u, tau_.data() + (limbs_ - words), shift, scratch_.data());
}

void Moments::add_at(mp_limb_t* sum, std::size_t limbs, const mp_limb_t* u, std::size_t words, std::size_t gone)
{
    const bool negative = u[words - 1] >> 63;
    const mp_limb_t carry = mpn_add_n(sum + gone, sum + gone, u, static_cast<mp_size_t>(words));
    const std::size_t above = gone + words;
    if (above == limbs || negative == (carry != 0)) return;
    if (negative) mpn_sub_1(sum + above, sum + above, static_cast<mp_size_t>(limbs - above), 1);
    else mpn_add_1(sum + above, sum + above, static_cast<mp_size_t>(limbs - above), 1);
}

} // namespace touchstone::transfer
