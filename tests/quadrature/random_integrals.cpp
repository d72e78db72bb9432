// SPDX-License-Identifier: MIT
// 2000 random integrals whose values are known in closed form: every ball contains the value, and is tight.
#include "tests/quadrature/closed_form.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>

using namespace touchstone;
using namespace touchstone::quadrature;
using namespace touchstone::quadrature::testing;

namespace {

Ball beta(const Ball& a, const Ball& b)
{
    return gamma_function(a) * gamma_function(b) / gamma_function(Ball(a + b));
}

/// 2F1(c, a; a + b; z) for real z < 1.
Ball hypergeometric_2f1(const Ball& c, const Ball& a, const Ball& sum, const Ball& z)
{
    Ball y;
    arb_hypgeom_2f1(y.get(), c.get(), a.get(), sum.get(), z.get(), 0, WorkingPrecision::bits());
    return y;
}

Ball kummer(const Ball& a, const Ball& sum, const Ball& z)
{
    Ball y;
    arb_hypgeom_m(y.get(), a.get(), sum.get(), z.get(), 0, WorkingPrecision::bits());
    return y;
}

Ball digamma(const Ball& a)
{
    Ball y;
    arb_digamma(y.get(), a.get(), WorkingPrecision::bits());
    return y;
}

class Draw {
public:
    explicit Draw(unsigned long seed) : random_(seed) {}
    long between(long low, long high) { return low + static_cast<long>(random_() % static_cast<unsigned long>(high - low + 1)); }
    /// In (0.05, 5], more often small; with a denominator that is now a power of two, now not.
    Rational exponent()
    {
        const long d = between(0, 1) ? 64 : between(2, 1000);
        const long top = between(0, 2) ? 5 * d : d;
        Rational r(between(d / 20 + 1, top), d);
        r.canonicalize();
        return r;
    }
    /// At a distance of 2^-7 to 2^3.
    Rational distance() { Rational r(between(33, 64), 64); return r * (between(0, 1) ? power(Rational(2), between(-6, 3)) : Rational(1)); }
    Rational number() { Rational r(between(-1000, 1000), between(1, 300)); r.canonicalize(); return r; }

private:
    std::mt19937_64 random_;
};

} // namespace

// TOUCHSTONE_SEED=n tries others.
TEST_CASE("2000 random integrals of eight families contain their closed forms and are tight")
{
    const char* given = std::getenv("TOUCHSTONE_SEED");
    const unsigned long seed = given ? std::strtoul(given, nullptr, 10) : 20130401;
    MESSAGE("seed " << seed);
    Draw draw(seed);
    long poorest = 1000;
    for (int i = 0; i < 2000; ++i) {
        CAPTURE(seed);
        CAPTURE(i);
        const Rational a = draw.exponent();
        Rational b = draw.exponent();
        while (i % 8 == 2 && b.get_den() == 1) b = draw.exponent(); // where the oracle's connection formulas degenerate
        // few digits put the proven terms to the test, many the rounding
        const long digits = i % 40 == 0 ? draw.between(100, 250) : draw.between(1, 50);
        CAPTURE(a.get_str());
        CAPTURE(b.get_str());
        const Rational p = a - 1, q = b - 1;
        Enclosure e;
        switch (i % 8) {
        case 0: { // Beta on a random interval
            const Rational low = draw.number(), width = draw.distance();
            e = check_integral([p, q](auto, auto l, auto r) { return to_power(l, p) * to_power(r, q); },
                               Interval::finite(low, Rational(low + width)), digits,
                               [&] { return beta(Ball(a), Ball(b)) * pow(Ball(width), Ball(Rational(p + b))); });
            break;
        }
        case 1: { // a branch point or pole outside, on the left
            const Rational d = draw.distance();
            Rational c = draw.exponent();
            // here too
            while (Rational(c - a).get_den() == 1 || Rational(c - b).get_den() == 1) c = draw.exponent();
            e = check_integral(
                [p, q, c, d](auto, auto l, auto r) { return to_power(l, p) * to_power(r, q) * to_power(1 + l / d, Rational(-c)); },
                Interval::finite(0, 1), digits,
                [&] {
                    return beta(Ball(a), Ball(b)) * hypergeometric_2f1(Ball(c), Ball(a), Ball(Rational(a + b)), Ball(Rational(-1 / d)));
                });
            break;
        }
        case 2: { // a pole outside, on the right
            const Rational d = draw.distance();
            const Rational z = 1 / (1 + d);
            e = check_integral(
                [p, q, d](auto, auto l, auto r) { return to_power(l, p) * to_power(r, q) * (1 + d) / (r + d); }, Interval::finite(0, 1),
                digits, [&] { return beta(Ball(a), Ball(b)) * hypergeometric_2f1(Ball(1), Ball(a), Ball(Rational(a + b)), Ball(z)); });
            break;
        }
        case 3: { // entire factor, growing or decaying
            const Rational z = Rational(draw.between(-200, 200), 16);
            e = check_integral([p, q, z](auto x, auto l, auto r) { return to_power(l, p) * to_power(r, q) * exp(z * x); },
                               Interval::finite(0, 1), digits,
                               [&] { return beta(Ball(a), Ball(b)) * kummer(Ball(a), Ball(Rational(a + b)), Ball(z)); });
            break;
        }
        case 4: { // poles beside the interval, at m +- i d
            const Rational m(draw.between(1, 63), 64), d = draw.distance() / 8;
            e = check_integral([m, d](auto x, auto, auto) { return 1 / ((x - m) * (x - m) + d * d); }, Interval::finite(0, 1), digits, [&] {
                Ball left, right;
                arb_atan(left.get(), Ball(Rational(m / d)).get(), WorkingPrecision::bits());
                arb_atan(right.get(), Ball(Rational((1 - m) / d)).get(), WorkingPrecision::bits());
                return (left + right) / Ball(d);
            });
            break;
        }
        case 5: { // logarithms
            const long k = draw.between(1, 4);
            if (draw.between(0, 1)) {
                e = check_integral([p, k](auto, auto l, auto) { return to_power(l, p) * to_power(-log(l), Rational(k)); },
                                   Interval::finite(0, 1), digits, [&] { return gamma_function(Ball(k + 1)) / pow(Ball(a), Ball(k + 1)); });
            }
            else {
                e = check_integral([p, q](auto, auto l, auto r) { return to_power(l, p) * to_power(r, q) * log(l); },
                                   Interval::finite(0, 1), digits,
                                   [&] { return beta(Ball(a), Ball(b)) * (digamma(Ball(a)) - digamma(Ball(Rational(a + b)))); });
            }
            break;
        }
        case 6: // half-infinite, algebraic decay
            e = check_integral([p, a, b](auto, auto l, auto) { return to_power(l, p) * to_power(1 + l, Rational(-a - b)); },
                               Interval::right_half_line(0, Decay::algebraic), digits, [&] { return beta(Ball(a), Ball(b)); });
            break;
        default: // half-infinite, exponential decay
            e = check_integral([p, b](auto, auto l, auto r) { return to_power(l, p) * to_power(r, b); },
                               Interval::right_half_line(0, Decay::exponential), digits,
                               [&] { return gamma_function(Ball(a)) / pow(Ball(b), Ball(a)); });
        }
        poorest = std::min(poorest, static_cast<long>(proven_digits(e.value)) - digits);
    }
    MESSAGE("digits proved minus digits asked, at the least: " << poorest);
}
