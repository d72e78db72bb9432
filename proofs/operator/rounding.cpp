// SPDX-License-Identifier: GPL-3.0-or-later
/// Roundings of numbers of 106 bits (scalar/double_double.hpp): what a person counted, counted again by an arithmetic that keeps its own
/// account. The unit u is 2^-101, twice what one operation may be off by.
#include "proofs/operator/own.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/wave/wave.hpp"

#include <fmt/format.h>

namespace touchstone::proofs {
namespace {

using GiNaC::pow;

/// A number and what all operations before it can have moved it by, to first order, in units of 2^-102: each adds 1 of its result.
struct Counted {
    Ball value, error;
    Counted(const Ball& v, const Ball& e) : value(v), error(e) {}
    Counted(long n) : value(n), error(0) {}
    static Counted rounded(const Ball& v, const Ball& carried) { return {v, carried + abs(v)}; }

    friend Counted operator+(const Counted& a, const Counted& b) { return rounded(a.value + b.value, a.error + b.error); }
    friend Counted operator-(const Counted& a, const Counted& b) { return rounded(a.value - b.value, a.error + b.error); }
    friend Counted operator*(const Counted& a, const Counted& b)
    {
        return rounded(a.value * b.value, abs(a.value) * b.error + abs(b.value) * a.error);
    }
    friend Counted operator/(const Counted& a, const Counted& b)
    {
        return rounded(a.value / b.value, a.error / abs(b.value) + abs(a.value) * b.error / (b.value * b.value));
    }
    friend Counted sqrt(const Counted& a)
    {
        const Ball r = sqrt(a.value);
        return rounded(r, a.error / (2 * r));
    }
    friend Counted inverse_root(const Counted& a)
    {
        const Ball r = 1 / sqrt(a.value);
        return rounded(r, a.error * r / (2 * a.value));
    }
    /// Relative, in units of u.
    Ball relative() const { return error / abs(value) / 2; }
};
Counted exact(const Ball& v) { return {v, Ball(0)}; }
/// G is known to u, 2 units.
Counted known_to_u(const Ball& v) { return {v, 2 * abs(v)}; }

/// Distances from an end: 1, 1/2, ... 2^-90
const std::vector<long> powers{0, 1, 2, 4, 7, 11, 16, 24, 35, 50, 70, 90};

Finding kernel(const Constants& k)
{
    const WorkingPrecision wide(256);
    Worst full, partial;
    for (const Rational& x : {Rational(1), Rational(1001, 1000), Rational(3, 2), Rational(5), Rational(37), Rational(400)})
        for (const Rational& G : {Rational(101, 100), Rational(3, 2), Rational(4), Rational(1000)})
            for (const long p : powers)
                for (const bool upper : {true, false}) {
                    const Ball gap = ScalarTraits<Ball>::power_of_two(-p), y = (Ball(x) + (upper ? 1 - gap : gap - 1)) / Ball(G);
                    if (!certainly(less(Ball(0), y))) continue;
                    const Counted d = wave::kernel_full_squared<Counted>(exact(Ball(x)), exact(Ball(G)), exact(y * y));
                    full.below(d.relative(), k.ball(0) * (1 + Ball(x)) / gap,
                               fmt::format("x = {}, G = {}, 2^-{} from an end", x.get_str(), G.get_str(), p));
                }
    for (const Rational& x :
         {Rational(1, 1'000'000), Rational(1, 100), Rational(1, 3), Rational(3, 4), Rational(999, 1000), Rational(999'999, 1'000'000)})
        for (const long p : powers)
            for (const bool upper : {true, false}) { // z = end (1 - gap), or end gap; the code's cancellation is 4x/(4x - G^2 z)
                const Ball gap = ScalarTraits<Ball>::power_of_two(-p), z = 4 * Ball(x) * (upper ? 1 - gap : gap);
                if (p == 0) continue;
                const Counted d = wave::kernel_partial_squared<Counted>(exact(Ball(x)), exact(Ball(1)), exact(z));
                partial.below(d.relative(), k.ball(0) * (upper ? 1 / gap : 1 / (1 - gap)),
                              fmt::format("x = {}, 2^-{} from an end", x.get_str(), p));
            }
    return Argument("the code's formula in an arithmetic that counts")
        .add("x >= 1: relative roundings < constant (1 + x)/(1 -+ c) u", full.result())
        .add("x < 1: relative roundings < constant 4x/(4x - G^2 z) u", partial.result())
        .conclude("the kernel in a cluster");
}

/// Partial contact: the angle's variables serve where z >= end/6 (AtPoint::direct in layer.cpp), nearer to the edge of contact z itself
/// does.
Finding positions(const Constants& k)
{
    const WorkingPrecision wide(256);
    constexpr long least_share = 6; // of the end that z is where an angle is used
    const Counted G = known_to_u(Ball(3)), G2 = G * G;
    Worst full, sine, cosine;
    const auto bound = k.ball(0);
    for (const Rational& x : {Rational(1), Rational(1001, 1000), Rational(3, 2), Rational(37), Rational(400)})
        for (long i = 0; i <= 16; ++i) {
            const Counted t = exact(sqrt(Ball(Rational(i, 32)))), q = t * t, at = exact(Ball(x));
            const std::string where = fmt::format("x = {}, {}/32", x.get_str(), i);
            const Counted high = wave::square_full_from_above<Counted>(at, q) / G2;
            full.below(high.relative(), bound, where);
            const Counted low = wave::square_full_from_below<Counted>(at, q) / G2;
            if (!low.value.contains_zero()) full.below(low.relative(), bound, where);
        }
    for (const Rational& x : {Rational(1, 1'000'000), Rational(1, 10), Rational(1, 2), Rational(2, 3), Rational(4, 5), Rational(999, 1000)})
        for (long i = 0; i <= 32; ++i) { // q <= 1/2 is sin^2(theta/2), then cos^2
            const Ball end = 4 * Ball(x) / G2.value, least = end / least_share;
            const Counted t = exact(sqrt(Ball(Rational(i, 64)))), q = t * t, at = exact(Ball(x)), gap = Counted(1) - at;
            const std::string where = fmt::format("x = {}, {}/64", x.get_str(), i);
            const Counted from_above = wave::square_partial_from_above<Counted>(at, q) / G2;
            if (certainly(less(least, from_above.value))) sine.below(from_above.relative(), bound, where);
            const Counted from_below = wave::square_partial_from_below<Counted>(gap, q) / G2;
            if (certainly(less(least, from_below.value))) cosine.below(from_below.relative(), bound, where);
        }
    return Argument("the code's formulas in an arithmetic that counts")
        .add("x >= 1: z is known within constant u z", full.result())
        .add("x < 1, z >= end/6, by the sine of theta/2", sine.result())
        .add("and by its cosine", cosine.result())
        .conclude("what rounding moves a place in a panel by");
}

/// c where rounding puts an edge: its distance from the nearer end of the kernel, then the sine or cosine of theta/2 that integration ends
/// at.
Finding edges(const Constants& k)
{
    const WorkingPrecision wide(256);
    Worst all;
    const auto judge = [&](const Counted& distance, const Ball& x, const std::string& where) {
        const Counted t = sqrt(distance / Counted(2)); // 1 -+ c = 2 t^2
        all.below(4 * t.value * t.error / 2, k.ball(0) * (1 + x), where);
    };
    const Counted one(1);
    for (const Rational& ratio : {Rational(1), Rational(1001, 1000), Rational(3, 2), Rational(37), Rational(400)})
        for (const long p : powers)
            for (const bool upper : {true, false}) {
                const Ball gap = ScalarTraits<Ball>::power_of_two(-p), x(ratio), G(Rational(5, 4)),
                           y = (x + (upper ? 1 - gap : gap - 1)) / G;
                if (!certainly(less(Ball(0), y))) continue;
                const Counted X = exact(x), place = known_to_u(G) * sqrt(exact(y * y));
                judge(upper ? one + X - place : place - X + one, x, fmt::format("x = {}, 2^-{} from an end", ratio.get_str(), p));
            }
    for (const Rational& ratio : {Rational(1, 1'000'000), Rational(1, 10), Rational(1, 2), Rational(2, 3), Rational(999, 1000)})
        for (const long p : powers) {
            const Ball gap = 2 * Ball(ratio) * ScalarTraits<Ball>::power_of_two(-p - 1), x(ratio), c = 1 - gap, G(3);
            const Ball z = (1 + c) * (2 * x - 1 + c) / (G * G);
            const Counted X = exact(x), g = known_to_u(G), G2z = g * g * exact(z), rest = one - X, R = wave::radius<Counted>(rest, G2z);
            const std::string where = fmt::format("x = {}, {} 2^-{} from the upper end", ratio.get_str(), ratio.get_str(), p);
            judge(wave::one_minus_c_partial<Counted>(X, R, G2z), x, where);
            judge(wave::one_plus_c_partial<Counted>(rest, R), x, where);
        }
    return Argument("the code's formulas in an arithmetic that counts")
        .add("an edge moves by less than constant u (1 + x) in c, the rounding of G included", all.result())
        .conclude("what rounding moves an edge by");
}

/// T_(k+1) = 2 t T_k - T_(k-1): what a step is off by reaches T_k through U of what is left of the way.
Finding recurrence(const Constants& k)
{
    const WorkingPrecision wide(128);
    constexpr int highest = 60;
    Worst all;
    for (long i = 0; i <= 64; ++i) {
        const Ball t(Rational(i, 64));
        std::vector<Ball> T{Ball(1), t}, U{Ball(1), 2 * t};
        for (int n = 2; n <= highest; ++n) {
            T.push_back(2 * t * T.back() - T[T.size() - 2]);
            U.push_back(2 * t * U.back() - U[U.size() - 2]);
            Ball lost(0); // in halves of u: a product, a difference
            for (std::size_t j = 1; j < static_cast<std::size_t>(n); ++j)
                lost += (abs(2 * t * T[j]) + abs(T[j + 1])) * abs(U[static_cast<std::size_t>(n) - 1 - j]);
            all.below(lost / 2, k.ball(0) * n * n, fmt::format("T_{} at {}/64", n, i));
        }
    }
    return Argument("every step's rounding times what the recurrence makes of it")
        .add("T_k is off by less than constant k^2 u, k <= 60", all.result())
        .conclude("polynomials by their recurrence");
}

Finding sums(const Constants& k)
{
    const Rational n(k.number(0));
    const Rational lost = n * n / 2 + 5 * n + 10; // in 2^-106; 2 n u = 64 n
    return Argument("exact arithmetic")
        .add("n^2/2 + 5 n + 10 <= 64 n at the largest n; the left is convex, and 15.5 <= 64 at n = 1",
             exactly(lost <= 64 * n, lost.get_str() + " against " + Rational(64 * n).get_str()))
        .conclude("sums that keep their low parts in one binary64 (Sum) lose less than 2 n u");
}

Finding quotient_of_discs(const Constants& k)
{
    Ring ring;
    const ex c = sym("c"), u = sym("u"), r = sym("h"), v = ring.root("v", pow(r, 2) - pow(u, 2)),
             d = pow(c, 2) - pow(r, 2); // b = c + u + i v, u^2 + v^2 = r^2
    const ex norm = pow(c + u, 2) + pow(v, 2), re = (c + u) / norm - k.exact(0) * c / d, im = -v / norm;
    return Argument("symbolic identity")
        .add("|1/b - c/(c^2 - r^2)| = r/(c^2 - r^2) for |b - c| = r, c > r",
             identity(pow(re, 2) + pow(im, 2), pow(r / d, 2), Points{"c=2 u=1/3 h=1"}, ring))
        .conclude("1/b of a disc is a disc");
}

Finding two_waves(const Constants& k)
{
    // 4 ceil((4 + 27) log(10)/(2 log 3)/4) nodes at the finest tolerance, 1e-25/64 of 1e-2
    const long nodes = 36, cuts = 200, lanes = nodes / 4 * cuts;
    return Argument("counting, in exact arithmetic")
        .add("terms of a lane, two operations each, and 100 of an integrand, in halves of u",
             exactly(Rational(2 * lanes + 100, 2) <= Rational(k.number(0)),
                     std::to_string(lanes + 50) + " against " + std::to_string(k.number(0))))
        .conclude("all terms are positive, all distances sums of positive terms: relative errors add");
}

} // namespace

std::vector<OwnClaim> rounding_claims()
{
    return {
        {"rounding.kernel",
         "dtheta/dz loses less than {0} u for each unit of cancellation",
         "transfer/layer.cpp, wave_kernel.cpp",
         {{"constant", 48}},
         kernel,
         {{0, 1}}},
        {"rounding.positions",
         "z = y^2 is known within {0} u z, the rounding of G included",
         "transfer/layer.cpp, proven_levels.cpp",
         {{"constant", 40}},
         positions,
         {{0, 3}}},
        {"rounding.edges",
         "an edge between two pieces moves by at most {0} u (1 + x) in c",
         "transfer/layer.cpp",
         {{"constant", 16}},
         edges,
         {{0, 2}}},
        {"rounding.recurrence",
         "T_k by its recurrence is off by at most {0} k^2 u",
         "transfer/layer.cpp",
         {{"constant", 2}},
         recurrence,
         {{0, 0.5}}},
        {"rounding.sums",
         "a sum of up to {0} products is off by at most 2 n u",
         "transfer/wave_kernel.cpp",
         {{"n", 117}},
         sums,
         {{0, 118}}},
        {"rounding.quotient_of_discs",
         "the centre of 1/b is {0} conj(c)/(|c|^2 - r^2)",
         "transfer/disc.hpp",
         {{"factor", 1}},
         quotient_of_discs,
         {{0, 0.99}}},
        {"rounding.two_waves",
         "an integral of two_waves.cpp is off by at most {0} u of itself",
         "transfer/two_waves.cpp",
         {{"constant", 2000}},
         two_waves,
         {{0, 1800}}},
    };
}

} // namespace touchstone::proofs
