// SPDX-License-Identifier: MIT
// Compiled with -O3 -fno-math-errno -ffp-contract=off: lanes become vector instructions, and nothing else changes.
#include "touchstone/transfer/wave_kernel.hpp"

#include <algorithm>

namespace touchstone::transfer {
namespace {

using Real = DoubleDouble<double>;
/// A sum of n products or numbers with the low parts in one binary64: off by at most (n^2/2 + 5 n + 10) 2^-106 of the sum of moduli.
struct Sum {
    Lanes high{}, low{};
    TOUCHSTONE_INLINE void add(const Four& a)
    {
        const Four s = Four::two_sum(high, a.high);
        high = s.high;
        low += s.low + a.low;
    }
    TOUCHSTONE_INLINE void add_product(const Four& a, const Four& b)
    {
        using double_double::fused;
        const Four p = Four::two_product(a.high, b.high), s = Four::two_sum(high, p.high);
        high = s.high;
        low += s.low + fused(a.low, b.high, fused(a.high, b.low, p.low));
    }
    TOUCHSTONE_INLINE Four total() const { return Four::two_sum(high, low); }
};

TOUCHSTONE_INLINE Four wide_kernel_density(const Four& x, const Four& G, const Four& G2, bool full, const Four& z)
{
    return full ? wave::kernel_full_squared<Four>(x, G, z) : wave::kernel_partial_squared<Four>(x, G2, z);
}

} // namespace

TOUCHSTONE_CLONES
void wave_densities(const WaveKernel<Real>& k, Real mid, Real half, const Wide& nodes, Wide& out)
{
    const Four x(k.x), G(k.G), G2(k.G2), middle(mid), unit(half), scale(inverse_pi);
    for (std::size_t q = 0; q < nodes.size(); q += 4)
        store(scale * wide_kernel_density(x, G, G2, k.full, middle + unit * load(nodes, q)), out, q);
}

TOUCHSTONE_CLONES
double wave_nodes(const WaveKernel<Real>& k, Substitution variable, Real mid, Real half, const Wide& nodes, const Wide& weights,
                  Real centre, Real unit, Wide& local, Wide& weight)
{
    const Four x(k.x), G(k.G), G2(k.G2), middle(mid), width(half), c(centre), one_unit(Real(1) / unit), scale(half * inverse_pi);
    double measure = 0;
    for (std::size_t i = 0; i < nodes.size(); i += 4) {
        const Four t = middle + width * load(nodes, i), q = t * t;
        Four z, w;
        if (variable == Substitution::square) {
            z = t;
            w = wide_kernel_density(x, G, G2, k.full, z);
        }
        else { // c = 1 - 2 q or 2 q - 1
            if (k.full)
                z = (variable == Substitution::sine ? wave::square_full_from_above<Four>(x, q) : wave::square_full_from_below<Four>(x, q)) /
                    G2;
            else
                z = (variable == Substitution::sine ? wave::square_partial_from_above<Four>(x, q)
                                                    : wave::square_partial_from_below<Four>(1 - x, q)) /
                    G2;
            w = 2 / sqrt(1 - q);
        }
        w = w * scale * load(weights, i);
        store((z - c) * one_unit, local, i);
        store(w, weight, i);
        measure += w.high[0] + w.high[1] + w.high[2] + w.high[3];
    }
    return measure;
}

TOUCHSTONE_CLONES
void chebyshev_moments(const Wide& local, const Wide& weight, std::size_t terms, std::size_t accurate, Wide& out)
{
    constexpr std::size_t most = 16; // lanes of four
    Four before[most], now[most], twice[most];
    Lanes late_before[most], late_now[most];
    const std::size_t count = local.size() / 4;
    for (std::size_t first = 0; first < count; first += most) {
        const std::size_t here = count - first < most ? count - first : most;
        Sum zeroth, one;
        for (std::size_t i = 0; i < here; ++i) { // T_k w instead of T_k: the recurrence is linear
            const Four x = load(local, 4 * (first + i));
            before[i] = load(weight, 4 * (first + i));
            now[i] = x * before[i];
            twice[i] = x + x;
            zeroth.add(before[i]);
            one.add(now[i]);
        }
        const auto add = [&](std::size_t k, const Real& s) { out.set(k, first == 0 ? s : out[k] + s); };
        add(0, sum(zeroth.total()));
        if (terms > 1) add(1, sum(one.total()));
        for (std::size_t k = 2; k < std::min(accurate, terms); ++k) {
            Sum total;
            for (std::size_t i = 0; i < here; ++i) {
                const Four next = twice[i] * now[i] - before[i];
                before[i] = now[i];
                now[i] = next;
                total.add(next);
            }
            add(k, sum(total.total()));
        }
        for (std::size_t i = 0; i < here; ++i) late_before[i] = before[i].high, late_now[i] = now[i].high;
        for (std::size_t k = accurate; k < terms; ++k) {
            Lanes total{};
            for (std::size_t i = 0; i < here; ++i) {
                const Lanes next = twice[i].high * late_now[i] - late_before[i];
                late_before[i] = late_now[i];
                late_now[i] = next;
                total += next;
            }
            add(k, (total[0] + total[1]) + (total[2] + total[3]));
        }
    }
}

TOUCHSTONE_CLONES
Real dot(const Wide& a, std::size_t first, const Wide& b, std::size_t b_first, std::size_t count)
{
    Sum s;
    for (std::size_t k = 0; k < count; k += 4) s.add_product(load(a, first + k), load(b, b_first + k));
    return sum(s.total());
}

TOUCHSTONE_CLONES
void add_products(const Wide& a, std::size_t first, const Wide& b, std::size_t columns, Wide& out)
{
    for (std::size_t m = 0; m < columns; m += 4) {
        Sum s;
        for (std::size_t k = 0; k < b.size(); ++k) s.add_product(load(a, first + k * columns + m), Four(b[k]));
        store(load(out, m) + s.total(), out, m);
    }
}

} // namespace touchstone::transfer
