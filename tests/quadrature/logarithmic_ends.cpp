// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/elliptic.hpp"
#include "touchstone/quadrature/logarithmic_ends.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"
#include "touchstone/scalar/flint_headers.hpp"

#include "arb_elliptic.hpp"
#include "place.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <tuple>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

constexpr slong true_bits = 320;

ComplexBall elliptic_k(const ComplexBall& m) { return ::elliptic_k(m, true_bits); }
ComplexBall elliptic_e(const ComplexBall& m) { return ::elliptic_e(m, true_bits); }

ComplexBall bessel(Op op, const Rational& order, const ComplexBall& z)
{
    ComplexBall w;
    const ComplexBall nu(order);
    (op == Op::bessel_k   ? acb_hypgeom_bessel_k
     : op == Op::bessel_y ? acb_hypgeom_bessel_y
     : op == Op::bessel_i ? acb_hypgeom_bessel_i
                          : acb_hypgeom_bessel_j)(w.get(), nu.get(), z.get(), true_bits);
    return w;
}

ComplexBall number(const Rational& re, const Rational& im) { return {Ball(re), Ball(im)}; }
/// The two parts of free + c log u, which is all there is.
template <class V>
void check_parts(const EndpointNumber<V>& found, const ComplexBall& free, const ComplexBall& c, slong least)
{
    REQUIRE(found.logarithms().size() == 1);
    const auto& term = found.logarithms().front();
    CHECK(term.left == 1);
    CHECK(term.right == 0);
    const auto power = EndpointNumber<V>(found.frame(), found.left(), found.right(), V(1)).value();
    CHECK(holds(power * found.factor_without_logarithm(), free));
    CHECK(holds(power * term.c, c));
    CHECK(accuracy(found.factor_without_logarithm()) >= least);
    CHECK(accuracy(term.c) >= least);
}

const std::pair<Rational, Rational> places_about_zero[] = {{Rational(1, 1000), Rational(1, 3000)},
                                                           {Rational(-1, 7), Rational(1, 9)},
                                                           {Rational(3, 10), Rational(-1, 5)},
                                                           {Rational(-9, 20), Rational(1, 50)},
                                                           {Rational(9, 20), 0},
                                                           {Rational(1, 100), Rational(49, 100)}};

} // namespace

TEST_CASE("K(1 - u) and E(1 - u) about u = 0 are continued with the logarithm, sheet by sheet")
{
    for (const auto& [re, im] : places_about_zero)
        for (const long sheet : {0L, 1L, -2L}) {
            CAPTURE(re.get_str());
            CAPTURE(im.get_str());
            CAPTURE(sheet);
            const WorkingPrecision precise(true_bits);
            const ComplexBall u = number(re, im), own = elliptic_k(u), circled = turns(sheet);
            // DLMF 19.12.1: K(1 - u) + K(u) log(u)/pi is analytic about 0; and Legendre's relation
            const ComplexBall k = elliptic_k(ComplexBall(1) - u) - own * circled / ComplexBall(pi<Ball>());
            const ComplexBall e = (ComplexBall(pi<Ball>() / Ball(2)) + (own - elliptic_e(u)) * k) / own;
            if (sheet == 0) CHECK(e.overlaps(elliptic_e(ComplexBall(1) - u)));
            const Place<ComplexBall> place(u, log(u) + circled);
            const WorkingPrecision working(128);
            const ComplexBall found_k = elliptic_of_complement(Op::elliptic_k_of_complement, place.left()).value();
            const ComplexBall found_e = elliptic_of_complement(Op::elliptic_e_of_complement, place.left()).value();
            CHECK(holds(found_k, k));
            CHECK(holds(found_e, e));
            CHECK(accuracy(found_k) > 110);
            CHECK(accuracy(found_e) > 110);
        }
}

TEST_CASE("K(1 - u) and E(1 - u) away from u = 0 are the principal ones, and nothing on another sheet")
{
    for (const auto& [re, im] : {std::pair(Rational(1, 10), Rational(4, 5)),
                                 {Rational(-2), Rational(1, 3)},
                                 {Rational(7, 3), Rational(-1)},
                                 {Rational(3, 4), Rational(0)}}) {
        CAPTURE(re.get_str());
        for (const long sheet : {0L, 1L}) {
            const WorkingPrecision precise(true_bits);
            const ComplexBall u = number(re, im), k = elliptic_k(ComplexBall(1) - u), e = elliptic_e(ComplexBall(1) - u);
            const Place<ComplexBall> place(u, log(u) + turns(sheet));
            const WorkingPrecision working(128);
            const ComplexBall found_k = elliptic_of_complement(Op::elliptic_k_of_complement, place.left()).value();
            const ComplexBall found_e = elliptic_of_complement(Op::elliptic_e_of_complement, place.left()).value();
            CHECK(found_k.is_finite() == (sheet == 0));
            CHECK(found_e.is_finite() == (sheet == 0));
            if (sheet != 0) continue;
            CHECK(holds(found_k, k));
            CHECK(holds(found_e, e));
            CHECK(accuracy(found_k) > 110);
            CHECK(accuracy(found_e) > 110);
            // a number without powers of distances
            CHECK(holds(elliptic_of_complement(Op::elliptic_k_of_complement, EndpointNumber<ComplexBall>(u)).value(), k));
        }
    }
    // small at a place, but not vanishing at the end: known as a principal value, not as one continued
    const WorkingPrecision precise(true_bits);
    const ComplexBall u = number(10, 3);
    for (const long sheet : {0L, -1L}) {
        const Place<ComplexBall> place(u, log(u) + turns(sheet));
        const auto inverse = place.left(-1);
        const ComplexBall found = elliptic_of_complement(Op::elliptic_k_of_complement, inverse).value();
        CHECK(found.is_finite() == (sheet == 0));
        if (sheet == 0) CHECK(holds(found, elliptic_k(ComplexBall(1) - ComplexBall(1) / u)));
        const Place<ComplexBall> kept(u);
        CHECK_FALSE(elliptic_of_complement(Op::elliptic_k_of_complement, kept.left(-1)).factor_without_logarithm().is_finite());
    }
}

TEST_CASE("K(1 - u) and E(1 - u) where logarithms are kept are a function and another times log u")
{
    const auto check = [](const auto& u, const ComplexBall& z) {
        using V = std::remove_cvref_t<decltype(u)>;
        const WorkingPrecision precise(true_bits);
        const ComplexBall own = elliptic_k(z), over = own / ComplexBall(-pi<Ball>());
        const ComplexBall free = elliptic_k(ComplexBall(1) - z) - over * log(z), beside = own - elliptic_e(z);
        const Place<V> place(u);
        const WorkingPrecision working(128);
        check_parts(elliptic_of_complement(Op::elliptic_k_of_complement, place.left()), free, over, 100);
        check_parts(elliptic_of_complement(Op::elliptic_e_of_complement, place.left()),
                    (ComplexBall(pi<Ball>() / Ball(2)) + beside * free) / own, beside * over / own, 100);
    };
    const WorkingPrecision precise(true_bits);
    for (const auto& [re, im] : places_about_zero) check(number(re, im), number(re, im));
    for (const auto& [re, im] :
         {std::pair(Rational(1, 10), Rational(1, 2)), {Rational(-2), Rational(1, 3)}, {Rational(7, 3), Rational(-1)}})
        check(number(re, im), number(re, im));
    for (const Rational& re : {Rational(1, 1000), Rational(2, 5), Rational(3, 4)}) check(Ball(re), number(re, 0));
}

TEST_CASE("K(1 - u) on a box about 0 holds what it is at the points of the box")
{
    for (const Rational& half : {Rational(1, 1000), Rational(1, 20), Rational(1, 5), Rational(1, 3)}) {
        CAPTURE(half.get_str());
        const WorkingPrecision precise(true_bits);
        ComplexBall box(0);
        arb_add_error(acb_realref(box.get()), Ball(half).get());
        arb_add_error(acb_imagref(box.get()), Ball(half).get());
        const Place<ComplexBall> place(box);
        const auto found = elliptic_of_complement(Op::elliptic_k_of_complement, place.left());
        REQUIRE(found.logarithms().size() == 1);
        CHECK(found.factor_without_logarithm().is_finite());
        for (const auto& [re, im] :
             {std::pair(half, half), {-half, half}, {half, Rational(0)}, {-half, -half}, {Rational(half / 3), -half}}) {
            const ComplexBall u = number(re, im), over = elliptic_k(u) / ComplexBall(-pi<Ball>());
            CHECK(holds(found.logarithms().front().c, over));
            CHECK(holds(found.factor_without_logarithm(), elliptic_k(ComplexBall(1) - u) - over * log(u)));
        }
    }
}

TEST_CASE("K(1 - u) and E(1 - u) where logarithms are kept are one function across the negative axis")
{
    for (const auto& [middle, half] : {std::pair(Rational(-3, 2), Rational(1, 4)),
                                       {Rational(-1, 5), Rational(1, 20)},
                                       {Rational(-4, 5), Rational(1, 10)},
                                       {Rational(-30), Rational(2)}}) {
        CAPTURE(middle.get_str());
        const WorkingPrecision precise(true_bits);
        ComplexBall box = number(middle, 0);
        arb_add_error(acb_realref(box.get()), Ball(half).get());
        arb_add_error(acb_imagref(box.get()), Ball(half).get());
        const Place<ComplexBall> place(box);
        const auto k = elliptic_of_complement(Op::elliptic_k_of_complement, place.left());
        const auto e = elliptic_of_complement(Op::elliptic_e_of_complement, place.left());
        REQUIRE(k.logarithms().size() == 1);
        REQUIRE(e.logarithms().size() == 1);
        CHECK(k.factor_without_logarithm().is_finite());
        CHECK(e.factor_without_logarithm().is_finite());
        for (const auto& [re, im] : {std::pair(half, half), {-half, half}, {half, -half}, {Rational(half / 3), Rational(-half / 9)}}) {
            // next to the axis, on either side of it, where Arb's principal functions are known
            const ComplexBall u = number(middle + re, im), own = elliptic_k(u), over = own / ComplexBall(-pi<Ball>());
            const ComplexBall free = elliptic_k(ComplexBall(1) - u) - over * log(u), beside = own - elliptic_e(u);
            CHECK(holds(k.factor_without_logarithm(), free));
            CHECK(holds(k.logarithms().front().c, over));
            CHECK(holds(e.factor_without_logarithm(), (ComplexBall(pi<Ball>() / Ball(2)) + beside * free) / own));
            CHECK(holds(e.logarithms().front().c, beside * over / own));
        }
    }
}

TEST_CASE("K and E of a box by means hold what they are in it")
{
    for (const auto& [re, im] : {std::pair(Rational(1), Rational(0)), {Rational(1, 2), Rational(3, 4)}, {Rational(3), Rational(-2)}})
        for (const Rational& half : {Rational(1, 10), Rational(1, 100), Rational(1, 100000)}) {
            CAPTURE(re.get_str());
            CAPTURE(half.get_str());
            const WorkingPrecision precise(true_bits);
            ComplexBall box = number(re, im);
            arb_add_error(acb_realref(box.get()), Ball(half).get());
            arb_add_error(acb_imagref(box.get()), Ball(half).get());
            const WorkingPrecision few(53);
            const auto found = elliptic_of_complement(box);
            const ComplexBall k_alone = first_kind_of_complement(box);
            const WorkingPrecision again(true_bits);
            for (const auto& [x, y] : {std::pair(half, half), {-half, half}, {half, -half}, {-half, -half}, {Rational(half / 3), half}}) {
                const ComplexBall m = ComplexBall(1) - number(re + x, im + y), k = elliptic_k(m);
                CHECK(holds(found.k, k));
                CHECK(holds(k_alone, k));
                CHECK(holds(found.e, elliptic_e(m)));
            }
        }
}

TEST_CASE("K and E of a wide ball, and both parts of K(1 - u) and E(1 - u) there, hold what they are in it")
{
    for (const auto& [re, im, half] : {std::tuple(Rational(0), Rational(0), Rational(1, 3)),
                                       {Rational(2, 5), Rational(1, 5), Rational(1, 4)},
                                       {Rational(-1, 2), Rational(1, 4), Rational(1, 5)},
                                       {Rational(7, 10), Rational(0), Rational(1, 16)}}) {
        CAPTURE(re.get_str());
        const WorkingPrecision few(53);
        ComplexBall box = number(re, im);
        widen(box, Ball(half));
        const Place<ComplexBall> place(box);
        const auto k = elliptic_of_complement(Op::elliptic_k_of_complement, place.left());
        const auto e = elliptic_of_complement(Op::elliptic_e_of_complement, place.left());
        const auto plain = elliptic_of_complement(ComplexBall(1) - box);
        const ComplexBall k_alone = first_kind_of_complement(ComplexBall(1) - box);
        CHECK(upper(upper_ball(k.factor_without_logarithm())) < 6); // log 16 + pi/2 at most where abs(u) < 31/32
        const WorkingPrecision precise(true_bits);
        const std::pair<Rational, Rational> places[] = {{half, half}, {-half, half}, {half, -half}, {-half, -half}, {half / 3, half / 7}};
        for (const auto& [x, y] : places) {
            const ComplexBall u = number(re + x, im + y), own = elliptic_k(u), over = own / ComplexBall(-pi<Ball>());
            const ComplexBall free = elliptic_k(ComplexBall(1) - u) - over * log(u), beside = own - elliptic_e(u);
            CHECK(holds(plain.k, own));
            CHECK(holds(k_alone, own));
            CHECK(holds(plain.e, elliptic_e(u)));
            CHECK(holds(k.logarithms().front().c, over));
            CHECK(holds(k.factor_without_logarithm(), free));
            CHECK(holds(e.logarithms().front().c, beside * over / own));
            CHECK(holds(e.factor_without_logarithm(), (ComplexBall(pi<Ball>() / Ball(2)) + beside * free) / own));
        }
    }
}

TEST_CASE("what a wide ball's size says of K(u), S(u) and (K(u) - E(u))/u is reached at u = q, and no more")
{
    for (const Rational& q : {Rational(1, 16), Rational(1, 3), Rational(3, 4), Rational(31, 32)}) {
        CAPTURE(q.get_str());
        const WorkingPrecision precise(true_bits);
        const auto said = about_one_by_size(Ball(q), false);
        const ComplexBall u(q), own = elliptic_k(u), over = own / ComplexBall(-pi<Ball>());
        const ComplexBall rest = over * (log(u) - log(ComplexBall(16))) - elliptic_k(ComplexBall(1) - u);
        const ComplexBall regular = (own - elliptic_e(u)) / u;
        for (const auto& [disc, at_0, at_q] : {std::tuple(said.k, pi<Ball>() / Ball(2), own),
                                               {said.rest, Ball(0), rest},
                                               {said.regular, pi<Ball>() / Ball(4), regular}}) {
            const Ball reached = abs(at_q - ComplexBall(at_0)), radius = radius_of(disc.real());
            CHECK(arb_gt((radius * Ball(Rational(1'000'001, 1'000'000))).get(), reached.get()) != 0);
            CHECK(arb_lt(radius.get(), (reached * Ball(Rational(1001, 1000))).get()) != 0);
            CHECK(disc.real().contains(at_0));
        }
        CHECK_FALSE(about_one_by_size(Ball(q), true).regular.is_finite());
    }
    // a disc of K and E themselves is no wider than at its edge, where the means of a real number know them
    const WorkingPrecision few(53);
    ComplexBall v(1);
    widen(v, Ball(Rational(1, 2)));
    const auto on = elliptic_of_complement(v);
    const Ball q = upper_ball(ComplexBall(1) - v);
    const auto at_q = elliptic_of_complement(Ball(1) - q);
    CHECK(arb_lt(radius_of(on.k.real()).get(), ((at_q.k - pi<Ball>() / Ball(2)) * Ball(Rational(1001, 1000))).get()) != 0);
    CHECK(arb_lt(radius_of(on.e.real()).get(), ((pi<Ball>() / Ball(2) - at_q.e) * Ball(Rational(1001, 1000))).get()) != 0);
}

TEST_CASE("K(1 - u) and E(1 - u) of a power of the distance have as many logarithms")
{
    const WorkingPrecision precise(true_bits);
    const Rational distance(1, 5);
    const Place<Ball> place{Ball(distance)};
    const ComplexBall d(distance), u = d * d, own = elliptic_k(u), over = own / ComplexBall(-pi<Ball>());
    const WorkingPrecision working(128);
    const auto k = elliptic_of_complement(Op::elliptic_k_of_complement, place.left(2));
    const auto e = elliptic_of_complement(Op::elliptic_e_of_complement, place.left(2));
    const WorkingPrecision again(true_bits);
    REQUIRE(k.logarithms().size() == 1);
    CHECK(holds(k.logarithms().front().c, ComplexBall(2) * over));
    CHECK(holds(k.factor_without_logarithm(), elliptic_k(ComplexBall(1) - u) - ComplexBall(2) * over * log(d)));
    const ComplexBall beside = (own - elliptic_e(u)) / ComplexBall(-pi<Ball>());
    CHECK(holds(e.logarithms().front().c, ComplexBall(2) * beside));
    CHECK(holds(e.factor_without_logarithm(), elliptic_e(ComplexBall(1) - u) - ComplexBall(2) * beside * log(d)));
}

TEST_CASE("K at real points is Arb's, to all bits but a few; of wide balls, of huge and tiny numbers and of none")
{
    std::mt19937_64 random(20261128);
    std::uniform_real_distribution<double> exponent(-60, 60), place(1, 2);
    for (int round = 0; round < 300; ++round) {
        const double v = std::exp2(exponent(random)) * place(random);
        for (const slong bits : {30L, 53L, 128L, 400L}) {
            CAPTURE(v);
            CAPTURE(bits);
            const auto true_k = [&](double at) {
                const WorkingPrecision precise(bits + 100);
                return ::elliptic_k(ComplexBall(Ball(1) - Ball::exactly(at)), bits + 100).real();
            };
            const WorkingPrecision working(bits);
            const Ball k = first_kind_of_complement(Ball::exactly(v));
            CHECK(arb_contains(k.get(), true_k(v).get()) != 0);
            CHECK(k.relative_bits() > bits - 5);
            const double radius = v * place(random) / 4;
            Ball wide = Ball::exactly(v);
            arb_add_error(wide.get(), Ball::exactly(radius).get());
            const Ball of_wide = first_kind_of_complement(wide);
            for (const double at : {v, v + radius, v - radius, v + radius / 3}) CHECK(arb_contains(of_wide.get(), true_k(at).get()) != 0);
        }
    }
    const WorkingPrecision working(128);
    for (const slong e : {-(1L << 31), 1L << 31, -(1L << 33)}) { // beyond what fixed point serves
        const Ball v = ScalarTraits<Ball>::power_of_two(e);
        const Ball k = first_kind_of_complement(v);
        Ball mean;
        arb_agm(mean.get(), Ball(1).get(), sqrt(v).get(), 200);
        CHECK(k.overlaps(pi<Ball>() / (mean + mean)));
        CHECK(k.relative_bits() > 110);
    }
    CHECK_FALSE(first_kind_of_complement(Ball(0)).is_finite());
    CHECK_FALSE(first_kind_of_complement(Ball(-1)).is_finite());
    CHECK_FALSE(first_kind_of_complement(Ball::indeterminate()).is_finite());
}

TEST_CASE("K(1 - u) and E(1 - u) at a node are those of the real number")
{
    for (const Rational& u : {Rational(1, 1000000), Rational(1, 3), Rational(1, 2), Rational(9, 10), Rational(40)}) {
        const WorkingPrecision precise(true_bits);
        const Place<Ball> place(Ball(u), log(Ball(u)));
        const WorkingPrecision working(128);
        for (const bool is_k : {true, false}) {
            const Ball found =
                elliptic_of_complement(is_k ? Op::elliptic_k_of_complement : Op::elliptic_e_of_complement, place.left()).value();
            const WorkingPrecision again(true_bits);
            CHECK(holds(found, is_k ? elliptic_k(ComplexBall(1) - ComplexBall(u)) : elliptic_e(ComplexBall(1) - ComplexBall(u))));
            CHECK(found.relative_bits() > 110);
        }
    }
}

TEST_CASE("K_n and Y_n about 0 are continued with the logarithm, sheet by sheet")
{
    for (const Op op : {Op::bessel_k, Op::bessel_y})
        for (long n = 0; n <= 8; ++n)
            for (const auto& [re, im] : {std::pair(Rational(1, 1000), Rational(1, 3000)),
                                         {Rational(-3, 4), Rational(1, 5)},
                                         {Rational(11, 10), Rational(-1, 2)},
                                         {Rational(3), Rational(5)},
                                         {Rational(-4), Rational(-27, 4)}})
                for (const long sheet : {0L, 1L}) {
                    CAPTURE(n);
                    CAPTURE(re.get_str());
                    CAPTURE(sheet);
                    const WorkingPrecision precise(true_bits);
                    const ComplexBall x = number(re, im);
                    const bool modified = op == Op::bessel_k;
                    // DLMF 10.31.1, 10.8.1: what stands beside the logarithm
                    const ComplexBall beside = modified ? bessel(Op::bessel_i, n, x) * ComplexBall(n % 2 == 0 ? -1 : 1)
                                                        : bessel(Op::bessel_j, n, x) * ComplexBall(Ball(2) / pi<Ball>());
                    const ComplexBall truth = bessel(op, n, x) + beside * turns(sheet);
                    const Place<ComplexBall> place(x, log(x) + turns(sheet));
                    const WorkingPrecision working(128);
                    const auto found = bessel_about_zero(op, Ball(n), place.left());
                    REQUIRE(found);
                    CHECK(holds(found->value(), truth));
                    CHECK(accuracy(found->value()) > 80);
                    const Place<ComplexBall> kept(x);
                    const auto parts = bessel_about_zero(op, Ball(n), kept.left());
                    REQUIRE(parts);
                    const WorkingPrecision again(true_bits);
                    check_parts(*parts, bessel(op, n, x) - beside * log(x), beside, 80);
                }
}

TEST_CASE("K_n and Y_n where logarithms are kept, at few bits and however large, hold what they are")
{
    for (const Op op : {Op::bessel_k, Op::bessel_y})
        for (const long n : {0L, 1L, 3L, 8L})
            for (const slong bits : {8, 12, 16, 40})
                for (const Rational& re :
                     {Rational(1, 3), Rational(5, 4), Rational(3), Rational(6), Rational(9), Rational(25, 2), Rational(16), Rational(63)})
                    for (const Rational& im : {Rational(0), Rational(re / 2)}) {
                        if (im != 0 && re > 50) continue;
                        CAPTURE(n);
                        CAPTURE(bits);
                        CAPTURE(re.get_str());
                        const WorkingPrecision precise(true_bits);
                        const ComplexBall x = number(re, im);
                        const ComplexBall beside = op == Op::bessel_k ? bessel(Op::bessel_i, n, x) * ComplexBall(n % 2 == 0 ? -1 : 1)
                                                                      : bessel(Op::bessel_j, n, x) * ComplexBall(Ball(2) / pi<Ball>());
                        const Place<ComplexBall> kept(x);
                        const auto parts = [&] {
                            const WorkingPrecision working(bits);
                            return bessel_about_zero(op, Ball(n), kept.left());
                        }();
                        REQUIRE(parts);
                        check_parts(*parts, bessel(op, n, x) - beside * log(x), beside, -1000);
                    }
}

TEST_CASE("K_n and Y_n at a node are those of the real number")
{
    for (const Op op : {Op::bessel_k, Op::bessel_y})
        for (const long n : {0L, 1L, 2L, 5L, 8L})
            for (const Rational& u : {Rational(1, 100000), Rational(3, 4), Rational(19, 10), Rational(21, 10), Rational(30)}) {
                const WorkingPrecision precise(true_bits);
                CAPTURE(n);
                CAPTURE(u.get_str());
                const ComplexBall truth = bessel(op, n, ComplexBall(u));
                const Place<Ball> place(Ball(u), log(Ball(u)));
                const WorkingPrecision working(128);
                const auto found = bessel_about_zero(op, Ball(n), place.left());
                REQUIRE(found);
                CHECK(holds(found->value(), truth));
                CHECK(found->value().relative_bits() > 70);
            }
}

TEST_CASE("J and I of half odd order about 0 are continued with the square root")
{
    for (const Op op : {Op::bessel_j, Op::bessel_i})
        for (const Rational& nu : {Rational(1, 2), Rational(-1, 2), Rational(3, 2), Rational(-5, 2), Rational(15, 2)})
            for (const auto& [re, im] : {std::pair(Rational(1, 1000), Rational(1, 3000)),
                                         {Rational(-3, 4), Rational(1, 5)},
                                         {Rational(2), Rational(-1)},
                                         {Rational(-4), Rational(-6)}})
                for (const long sheet : {0L, 1L}) {
                    CAPTURE(nu.get_str());
                    CAPTURE(re.get_str());
                    const WorkingPrecision precise(true_bits);
                    const ComplexBall x = number(re, im);
                    const ComplexBall truth = bessel(op, nu, x) * ComplexBall(sheet == 0 ? 1 : -1);
                    const Place<ComplexBall> place(x, log(x) + turns(sheet));
                    const WorkingPrecision working(128);
                    const auto found = bessel_about_zero(op, Ball(nu), place.left());
                    REQUIRE(found);
                    CHECK(found->left().power == Exponent(nu));
                    CHECK(holds(found->value(), truth));
                    CHECK(accuracy(found->value()) > 90);
                }
    for (const Op op : {Op::bessel_j, Op::bessel_i}) {
        const WorkingPrecision precise(true_bits);
        const Place<Ball> place(Ball(Rational(3, 2)), log(Ball(Rational(3, 2))));
        const auto found = bessel_about_zero(op, Ball(Rational(7, 2)), place.left());
        REQUIRE(found);
        CHECK(holds(found->value(), bessel(op, Rational(7, 2), ComplexBall(Rational(3, 2)))));
        CHECK(found->value().relative_bits() > 300);
    }
}

TEST_CASE("Bessel functions have an expansion about 0 for the orders and arguments there is one for, and no other")
{
    const ComplexBall x = number(Rational(1, 2), Rational(1, 3));
    const Place<ComplexBall> place(x, log(x)), kept(x);
    const auto has = [&](Op op, const Rational& order) { return bessel_about_zero(op, Ball(order), place.left()).has_value(); };
    for (const Op op : {Op::bessel_k, Op::bessel_y}) {
        CHECK(has(op, 0));
        CHECK(has(op, 8));
        CHECK_FALSE(has(op, 9));
        CHECK_FALSE(has(op, -1));
        CHECK_FALSE(has(op, Rational(1, 2)));
        CHECK_FALSE(has(op, Rational(1, 4)));
    }
    for (const Op op : {Op::bessel_j, Op::bessel_i}) {
        CHECK(has(op, Rational(1, 2)));
        CHECK(has(op, Rational(-7, 2)));
        CHECK_FALSE(has(op, Rational(19, 2)));
        CHECK_FALSE(has(op, Rational(-19, 2)));
        CHECK_FALSE(has(op, 1));
        CHECK_FALSE(has(op, 0));
        CHECK_FALSE(has(op, Rational(1, 4)));
    }
    const Ball about_half = pi<Ball>() * (Ball(1) / (Ball(2) * pi<Ball>()));
    CHECK_FALSE(bessel_about_zero(Op::bessel_j, about_half, place.left()).has_value()); // the order is not known to be 1/2
    // an argument that does not vanish at the end is left to the function itself
    CHECK_FALSE(bessel_about_zero(Op::bessel_k, Ball(0), EndpointNumber<ComplexBall>(x)).has_value());
    CHECK_FALSE(bessel_about_zero(Op::bessel_k, Ball(0), place.left(-1)).has_value());
    // and one with a logarithm has no value
    const auto of_logarithm = bessel_about_zero(Op::bessel_k, Ball(0), log(kept.left()));
    REQUIRE(of_logarithm);
    CHECK_FALSE(of_logarithm->has_logarithms());
    CHECK_FALSE(of_logarithm->value().is_finite());
    // far away: the principal value, no value on another sheet, and none where log u is to be kept
    for (const long sheet : {0L, 1L}) {
        const WorkingPrecision precise(true_bits);
        const ComplexBall y = number(9, 1);
        const Place<ComplexBall> far(y, log(y) + turns(sheet));
        const auto found = bessel_about_zero(Op::bessel_k, Ball(2), far.left());
        REQUIRE(found);
        CHECK(found->value().is_finite() == (sheet == 0));
        if (sheet == 0) CHECK(holds(found->value(), bessel(Op::bessel_k, 2, y)));
    }
    const ComplexBall hundred(100);
    const Place<ComplexBall> too_far(hundred);
    const auto found = bessel_about_zero(Op::bessel_k, Ball(2), too_far.left());
    REQUIRE(found);
    CHECK_FALSE(found->has_logarithms());
    CHECK_FALSE(found->value().is_finite());
}
