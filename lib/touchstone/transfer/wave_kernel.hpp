// SPDX-License-Identifier: MIT
/// \file
/// The sums of proven_levels.cpp that take its time: four at a time in 106 bits. Internal to transfer/.
///
/// The counts of operations behind the error bounds in proven_levels.md hold for the code of wave_kernel.cpp.
#pragma once

#include "touchstone/scalar/double_double.hpp"
#include "touchstone/wave/wave.hpp"

#include <cstddef>
#include <cstring>
#include <vector>

namespace touchstone::transfer {

/// Numbers of 106 bits, heads and tails apart.
struct Wide {
    std::vector<double> high, low;
    Wide() = default;
    explicit Wide(std::size_t count) : high(count), low(count) {}
    std::size_t size() const { return high.size(); }
    void resize(std::size_t count) { high.resize(count), low.resize(count); }
    DoubleDouble<double> operator[](std::size_t i) const { return {high[i], low[i]}; }
    void set(std::size_t i, const DoubleDouble<double>& v) { high[i] = v.high, low[i] = v.low; }
};

/// Four numbers side by side, from and to four places of an array.
using Four = DoubleDouble<Lanes>;
TOUCHSTONE_INLINE Four load(const Wide& w, std::size_t i)
{
    Four r;
    std::memcpy(&r.high, w.high.data() + i, sizeof r.high);
    std::memcpy(&r.low, w.low.data() + i, sizeof r.low);
    return r;
}
TOUCHSTONE_INLINE void store(const Four& r, Wide& w, std::size_t i)
{
    std::memcpy(w.high.data() + i, &r.high, sizeof r.high);
    std::memcpy(w.low.data() + i, &r.low, sizeof r.low);
}
TOUCHSTONE_INLINE DoubleDouble<double> sum(const Four& f)
{
    const DoubleDouble<double> a{f.high[0], f.low[0]}, b{f.high[1], f.low[1]}, c{f.high[2], f.low[2]}, d{f.high[3], f.low[3]};
    return (a + b) + (c + d);
}
constexpr DoubleDouble<double> inverse_pi{0x1.45f306dc9c883p-2, -0x1.6b01ec5417056p-56};

/// One wave at load ratio x: z = y^2 of the next ratio y, where it begins and ends, and 1 -+ c, c = cos theta, as functions of z.
template <class R>
struct WaveKernel {
    R x, G, G2, begin, end;
    bool full;
    WaveKernel(const R& x_, const R& G_, bool full_) : x(x_), G(G_), G2(G_ * G_), full(full_)
    {
        const R low = (full ? x - 1 : 1 - x) / G, high = (x + 1) / G, squared = low * low;
        begin = full ? squared : -squared; // x < 1: where R = x + c vanishes
        end = full ? high * high : 4 * x / G2;
    }
    TOUCHSTONE_INLINE R root(const R& z) const { return wave::radius<R>(1 - x, G2 * z); }
    TOUCHSTONE_INLINE R one_minus_c(const R& z) const
    {
        return positive_part(full ? 1 + x - G * sqrt(z) : wave::one_minus_c_partial<R>(x, root(z), G2 * z));
    }
    TOUCHSTONE_INLINE R one_plus_c(const R& z) const
    {
        return positive_part(full ? G * sqrt(z) - x + 1 : wave::one_plus_c_partial<R>(1 - x, root(z)));
    }
    /// dtheta/dz
    TOUCHSTONE_INLINE R density(const R& z) const
    {
        return full ? wave::kernel_full_squared<R>(x, G, z) : wave::kernel_partial_squared<R>(x, G2, z);
    }
};

enum class Substitution { sine, cosine, square }; ///< sin(theta/2), cos(theta/2), z

/// Counts are multiples of four; everything is owned by the caller.

/// out[q] = dtheta/dz at mid + half * nodes[q], over pi
void wave_densities(const WaveKernel<DoubleDouble<double>>&, DoubleDouble<double> mid, DoubleDouble<double> half, const Wide& nodes,
                    Wide& out);

/// Gauss nodes t = mid + half * nodes[i] of the variable: local[i] = (z(t) - centre)/unit and weight[i], which is
/// half * weights[i] dtheta/dt over pi. \returns the sum of the weights
double wave_nodes(const WaveKernel<DoubleDouble<double>>&, Substitution, DoubleDouble<double> mid, DoubleDouble<double> half,
                  const Wide& nodes, const Wide& weights, DoubleDouble<double> centre, DoubleDouble<double> unit, Wide& local,
                  Wide& weight);

/// out[k] = sum of weight[i] T_k(local[i]), k < terms; in binary64 from k = accurate >= 2 on, where it is off by less than late_moment(k -
/// accurate, ...) times the sum of the weights' moduli
void chebyshev_moments(const Wide& local, const Wide& weight, std::size_t terms, std::size_t accurate, Wide& out);
inline void chebyshev_moments(const Wide& local, const Wide& weight, std::size_t terms, Wide& out)
{
    chebyshev_moments(local, weight, terms, terms, out);
}

/// In the recurrence for w T_k, |local| <= 1, a step is off by 5 2^-53 |w| at most, local's own rounding included, which the j-th step
/// after makes j + 1 times as large; each of the two numbers it starts from is off by 2^-53 |w|. Together that is below 3 (steps + 2)^2
/// 2^-53 |w|; a sum of n numbers adds n 2^-53 of the sum of moduli.
inline double late_moment(std::size_t steps, std::size_t nodes)
{
    const auto s = static_cast<double>(steps + 2);
    return 0x1p-53 * (3 * s * s + static_cast<double>(nodes));
}

/// The sum of a[first + k] b[b_first + k], k < count
DoubleDouble<double> dot(const Wide& a, std::size_t first, const Wide& b, std::size_t b_first, std::size_t count);
inline DoubleDouble<double> dot(const Wide& a, std::size_t first, const Wide& b) { return dot(a, first, b, 0, b.size()); }
/// out[m] += the sum of a[first + k columns + m] b[k], m < columns
void add_products(const Wide& a, std::size_t first, const Wide& b, std::size_t columns, Wide& out);

} // namespace touchstone::transfer
