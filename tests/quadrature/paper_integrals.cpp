// SPDX-License-Identifier: MIT
// The paper's own integrals, through the formulas of the library as they stand.
#include "tests/quadrature/closed_form.hpp"
#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/westergaard.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::quadrature;
using namespace touchstone::quadrature::testing;

namespace {

Rational delta_of(long n) { return 1 - power(Rational(2), -(n + 1)); }

/// (6.7) at n = 1 in partial contact: the integral over p = p_0/p*_0 in (0, 2 sqrt(load)) of the density (2.19)
/// times (6.6) at p_0/p*_1 = p/G. The defect 4 load - p^2 is (distance to the edge)(edge + p).
struct AreaAtScaleOne {
    Rational load, G;
    template <class T>
    T operator()(const T& p, const T&, const T& to_edge) const
    {
        const T s(load), edge = 2 * sqrt(s);
        return westergaard::density_partial(p, s, T(sqrt(to_edge * (edge + p)))) * 2 * asin(sqrt(p / G)) / pi<T>();
    }
    Interval support() const
    {
        const Rational s = load;
        return Interval::finite(0, Endpoint([s] { return 2 * sqrt(Ball(s)); }));
    }
};

/// The same number by the recursion: two steps of the transfer operator on the constant function,
/// (2/pi) sqrt(x) integral over psi in (0, pi/2) of B(y) cos(psi)/sqrt(1 - x sin^2 psi), y = (2/G) sqrt(x) cos(psi) sqrt(1 - x sin^2 psi).
struct AreaByRecursion {
    Rational load, G;
    template <class T>
    T operator()(const T& psi, const T&, const T& to_end) const
    {
        const T s(load), sine = sin(psi), cosine = sin(to_end);
        const T root = sqrt(1 - s * sine * sine);
        const T y = 2 / T(G) * sqrt(s) * cosine * root;
        return 2 / pi<T>() * sqrt(s) * cosine / root * 2 * asin(sqrt(y)) / pi<T>();
    }
};

} // namespace

TEST_CASE("(7.13): the integral of (1 - x^2)^(delta_n/2) is its Gamma quotient, n = 0..19")
{
    for (long n = 0; n < 20; ++n) {
        const Rational half = delta_of(n) / 2;
        for (const long digits : {30L, 100L}) {
            check_integral([half](auto, auto l, auto r) { return to_power(l * r, half); }, Interval::finite(-1, 1), digits, [&] {
                const Ball h(half);
                return sqrt(pi<Ball>()) * gamma_function(Ball(1 + h)) / gamma_function(Ball(h + Ball(3) / 2));
            });
        }
    }
    const Rational half = delta_of(0) / 2;
    check_integral([half](auto, auto l, auto r) { return to_power(l * r, half); }, Interval::finite(-1, 1), 1000, [&] {
        const Ball h(half);
        return sqrt(pi<Ball>()) * gamma_function(Ball(1 + h)) / gamma_function(Ball(h + Ball(3) / 2));
    });
}

TEST_CASE("(7.13): K_(n+1)/K_n of the library is 2^delta_n/pi times the integral")
{
    const WorkingPrecision precision(300);
    for (long n = 0; n < 6; ++n) {
        const Rational half = delta_of(n) / 2;
        Options options;
        options.digits = 60;
        const Enclosure e = tanh_sinh([half](auto, auto l, auto r) { return to_power(l * r, half); }, Interval::finite(-1, 1), options);
        const Ball ratio = archard::K_by_recursion<Ball>(n + 1) / archard::K_by_recursion<Ball>(n);
        CHECK(e.status == Status::certified);
        CHECK(ratio.overlaps(pow(Ball(2), Ball(delta_of(n))) / pi<Ball>() * e.value));
    }
}

TEST_CASE("(2.19): the density integrates to the contact area (2.5) and its mean is the load")
{
    for (const auto& [load, digits] : {std::pair(Rational(1, 1000), 30L),
                                       {Rational(1, 10), 100L},
                                       {Rational(1, 2), 30L},
                                       {Rational(99, 100), 30L},
                                       {Rational(1, 5), 1000L}}) {
        const Rational s = load;
        const auto density = [s](auto p, auto to_edge) {
            using T = decltype(p);
            const T load_t(s), edge = 2 * sqrt(load_t);
            return westergaard::density_partial(p, load_t, T(sqrt(to_edge * (edge + p))));
        };
        const Interval support = Interval::finite(0, Endpoint([s] { return 2 * sqrt(Ball(s)); }));
        check_integral([density](auto p, auto, auto r) { return density(p, r); }, support, digits,
                       [s] { return 2 * asin(sqrt(Ball(s))) / pi<Ball>(); });
        check_integral([density](auto p, auto, auto r) { return p * density(p, r); }, support, digits, [s] { return Ball(s); });
    }
}

TEST_CASE("(6.7) at n = 1 agrees with the recursion")
{
    for (const auto& [load, G] :
         {std::pair(Rational(1, 10), Rational(4)), {Rational(1, 1000), Rational(3)}, {Rational(1, 2), Rational(4)}}) {
        for (const long digits : {30L, 100L, 1000L}) {
            if (digits == 1000 && load != Rational(1, 10)) continue; // a second each
            Options options;
            options.digits = digits;
            const AreaAtScaleOne f{load, G};
            const Enclosure direct = tanh_sinh(f, f.support(), options);
            const Enclosure recursive =
                tanh_sinh(AreaByRecursion{load, G}, Interval::finite(0, Endpoint([] { return pi<Ball>() / 2; })), options);
            INFO(direct.reason << " " << recursive.reason << " " << direct.certificate.to_json());
            CHECK(direct.status == Status::certified);
            CHECK(recursive.status == Status::certified);
            CHECK(direct.value.overlaps(recursive.value));
            CHECK(proven_digits(direct.value) >= static_cast<double>(digits) - 3);
            CHECK(proven_digits(recursive.value) >= static_cast<double>(digits) - 3);
        }
    }
}
