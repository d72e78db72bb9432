// SPDX-License-Identifier: MIT
// Every constant of the proofs in lib/touchstone/quadrature/lemmas.hpp and endpoint_functions.cpp, held against the function that attains
// it: the bound holds, and a bound smaller by the share named here would not. So each constant that is weakened turns a test red.
#include "touchstone/quadrature/endpoint_functions.hpp"
#include "touchstone/quadrature/integrand.hpp"
#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/oscillation.hpp"
#include "touchstone/quadrature/quadrant.hpp"
#include "touchstone/quadrature/singular_weights.hpp"
#include "touchstone/quadrature/special.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <doctest/doctest.h>

#include <tuple>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

/// The truth is within the bound, and above that share of it.
void attains(const Ball& truth, const Ball& bound, const Rational& share)
{
    CHECK_MESSAGE(arb_le(truth.get(), bound.get()), truth.to_string(10), " is over ", bound.to_string(10));
    const Ball less = bound * Ball(share);
    CHECK_MESSAGE(arb_ge(truth.get(), less.get()), truth.to_string(10), " is far below ", bound.to_string(10));
}

Ball decimal(const char* text) { return Ball(*parse_rational(text)); }

using Complex = EndpointNumber<ComplexBall>;

/// rho c, rho = |Re w|, on the piece {Re t >= x1, 0 <= Im t <= d}.
Complex grown(const StripPiece& piece, const ComplexBall& c, const Exponent& logs = 1) { return {&piece, {}, {0, logs}, c}; }

/// sup |f| as enclosed, as a multiple of |r|^power where that is the power it shows.
Ball size_of(const Complex& f)
{
    Ball top;
    const Ball size = abs(f.factor());
    arb_get_ubound_arf(arb_midref(top.get()), size.get(), 53);
    return top;
}

} // namespace

TEST_CASE("gauss_legendre: the Chebyshev polynomial T_4 and two nodes")
{
    const WorkingPrecision precision(128);
    const Ball sigma(3), four = Ball(4) * sigma;
    Ball largest; // of |T_4| on the ellipse
    arb_cosh(largest.get(), four.get(), 128);
    const Ball exact = -Ball(2) / Ball(15), by_rule = -Ball(14) / Ball(9); // T_4(1/sqrt(3)) = -7/9
    attains(exact - by_rule, lemma::gauss_legendre(largest, sigma, 2), Rational(13, 20));
    // next to the segment the sum of the geometric series counts: at rho^2 = 2, 64 2^-2 (1 + 1/2 + 1/4 + ...)
    const Ball near = lemma::gauss_legendre(Ball(15), log(Ball(2)) / 2, 2);
    CHECK(near.contains(Rational(32)));
    CHECK(near.relative_bits() > 40);
}

TEST_CASE("gauss_chebyshev: the Chebyshev polynomial T_2n and n nodes, which all have the value -1")
{
    const WorkingPrecision precision(128);
    const Ball sigma(3);
    for (const long n : {1L, 2L, 7L}) {
        Ball largest; // of |T_2n| on the ellipse
        const Ball exponent = Ball(2 * n) * sigma;
        arb_cosh(largest.get(), exponent.get(), 128);
        attains(pi<Ball>(), lemma::gauss_chebyshev(largest, sigma, n), Rational(99, 100));
    }
    // next to the segment the whole series counts: at rho^2 = 2, 2 pi (1/2 + 1/4 + ...)
    const Ball near = lemma::gauss_chebyshev(Ball(1), log(Ball(2)) / 2, 1);
    CHECK(near.overlaps(Ball(2) * pi<Ball>()));
    CHECK(near.relative_bits() > 100);
}

TEST_CASE("interpolation: the Chebyshev polynomial T_1, the weight log u and one node")
{
    const WorkingPrecision precision(128);
    const SingularWeight w{0, 0, 1, 0};
    const Ball sigma(20);
    Ball largest; // of |T_1| on the ellipse
    arb_cosh(largest.get(), sigma.get(), 128);
    const auto rule = WeightedNodes::get(w, 1, 128);
    const Ball exact = moments(w, 2)[1] * Ball(2); // over z: T_1 is P_1, and its value at the node is 0
    attains(exact, lemma::interpolation(largest, sigma, rule->size(), 1), Rational(24, 100));
    const Ball near = lemma::interpolation(Ball(3), log(Ball(2)), Ball(5), 2); // next to the segment: 2 M size 2^-2 (1 + 1/2 + 1/4 + ...)
    CHECK(near.contains(Rational(15)));
    CHECK(near.relative_bits() > 40);
}

TEST_CASE("discretisation: exp(-t^2) attains N_d/(exp(2 pi d/h) - 1) at d = pi/h")
{
    const WorkingPrecision precision(200);
    const Ball h = decimal("0.7"), d = pi<Ball>() / h;
    const Ball N = Ball(2) * sqrt(pi<Ball>()) * exp(d * d);
    Ball sum(0);
    for (long k = -60; k <= 60; ++k) sum += h * exp(-(h * Ball(k)) * (h * Ball(k)));
    attains(sum - sqrt(pi<Ball>()), lemma::discretisation(N, d, h), Rational(999, 1000));
}

TEST_CASE("log(1 - y)/y: its slope, and how far it is from -1, at a y where both are largest")
{
    const WorkingPrecision precision(128);
    for (const char* text : {"0.1", "0.25", "0.4"}) {
        const Ball y = decimal(text), l = log(1 - y), slope = -(l + y / (1 - y)) / (y * y); // of log(1 - y)/y
        attains(-slope, lemma::slope_of_logarithm(y), Rational(4, 5));
        attains(-l / y - 1, lemma::logarithm_over_argument(y), Rational(4, 5));
    }
}

TEST_CASE("sinc: its slope, attained at 0; most of it where the slope is largest on the real axis, a part on the imaginary one")
{
    const WorkingPrecision precision(128);
    const auto attained = [](const Ball& slope, const Ball& size, const Ball& height, const Rational& share) {
        attains(abs(slope), lemma::slope_of_sinc(size, height), share);
    };
    const auto on_the_line = [](const Ball& x) { return (x * cos(x) - sin(x)) / (x * x); };
    attained(on_the_line(decimal("0.001")), decimal("0.001"), Ball(0), Rational(999, 1000));
    attained(on_the_line(decimal("1")), Ball(1), Ball(0), Rational(9, 10));
    attained(on_the_line(decimal("2.0816")), decimal("2.0816"), Ball(0), Rational(4, 5));
    for (const char* text : {"0.01", "1", "1.4", "5"}) { // sinc(i y) = sinh(y)/y
        const Ball y = decimal(text);
        Ball sinh, cosh;
        arb_sinh_cosh(sinh.get(), cosh.get(), y.get(), 128);
        attained((y * cosh - sinh) / (y * y), y, y, Rational(1, 4));
    }
}

TEST_CASE("sinc of a box holds what it is in it, and is hardly wider")
{
    const std::pair<Rational, Rational> middles[] = {{0, 0}, {Rational(3, 10), Rational(2, 5)}, {3, -1}, {Rational(-1, 9), 6}};
    for (const auto& [re, im] : middles)
        for (const Rational& half : {Rational(1, 2), Rational(1, 100), Rational(0)}) {
            const WorkingPrecision precise(200);
            ComplexBall box{Ball(re), Ball(im)};
            arb_add_error(acb_realref(box.get()), Ball(half).get());
            arb_add_error(acb_imagref(box.get()), Ball(half).get());
            const ComplexBall found = analytic::sinc(box);
            Ball spread(0);
            const auto at = [](const Rational& x, const Rational& y) {
                ComplexBall w;
                acb_sinc(w.get(), ComplexBall(Ball(x), Ball(y)).get(), 200);
                return w;
            };
            for (const long x : {-1L, 0L, 1L})
                for (const long y : {-1L, 0L, 1L}) {
                    const ComplexBall w = at(re + x * half, im + y * half);
                    CHECK(found.overlaps(w));
                    const Ball far = abs(w - at(re, im));
                    if (arb_gt(far.get(), spread.get())) spread = far;
                }
            CHECK(arb_le(radius_of(found).get(), (Ball(5) * spread + Ball(power(Rational(1, 2), 150))).get())); // of two parts together
        }
}

TEST_CASE("truncation: what the lemma sums, by a fine step")
{
    const WorkingPrecision precision(100);
    const Ball alpha = decimal("0.3"), h = decimal("0.0005"), pi_ = pi<Ball>();
    const auto at = [&](long k) {
        Ball s, c;
        arb_sinh_cosh(s.get(), c.get(), (h * Ball(k)).get(), 100);
        return std::pair(s, c);
    };
    const long n = 2000; // alpha pi sinh 1 > 1
    Ball sum(0);
    for (long k = n + 1; k < n + 8000; ++k) {
        const auto [s, c] = at(k);
        sum += h * pi_ * c * exp(-alpha * pi_ * s);
    }
    attains(sum, lemma::truncation(Ball(1), alpha, Ball(0), Ball(3), pi_ * at(n).first), Rational(99, 100));
}

TEST_CASE("strip's tail: the integral of the lemma, by a fine step")
{
    const WorkingPrecision precision(100);
    const Ball alpha = decimal("0.3"), d = decimal("0.8"), h = decimal("0.0005"), pi_ = pi<Ball>();
    Ball sum(0), A;
    for (long k = 2000; k < 10000; ++k) {
        Ball s, c;
        arb_sinh_cosh(s.get(), c.get(), (h * (Ball(k) + Ball(1) / Ball(2))).get(), 100);
        sum += h * pi_ * c * exp(-alpha * pi_ * s * cos(d));
    }
    arb_sinh(A.get(), Ball(1).get(), 100);
    A = A * pi_ * cos(d);
    const Ball factor = lemma::far_factor(alpha, A);
    attains(sum * factor, lemma::strip_tail(Ball(1), alpha, Ball(0), A, d), Rational(99, 100));
}

TEST_CASE("truncation bounds grow by the factor of the far end, whatever its exponent")
{
    const WorkingPrecision precision(100);
    const Ball K(3), alpha = decimal("0.3"), A = decimal("0.7"), far = decimal("7");
    for (const Rational& beta : {Rational(2), Rational(-3, 2)}) {
        const Ball factor = lemma::far_factor(Ball(beta), A);
        CHECK(factor.overlaps(exp(-abs(Ball(beta)) * log(1 - exp(-A)))));
        CHECK(lemma::truncation(K, alpha, Ball(beta), A, far).overlaps(lemma::truncation(K, alpha, Ball(0), A, far) * factor));
        CHECK(lemma::logistic_truncation(K, alpha, Ball(beta), A, far)
                  .overlaps(lemma::logistic_truncation(K, alpha, Ball(0), A, far) * factor));
    }
}

TEST_CASE("a strip's tail has the factor of both ends")
{
    const WorkingPrecision precision(100);
    const Ball K(3), alpha = decimal("0.3"), beta = decimal("-0.8"), A = decimal("0.7"), d = decimal("0.5");
    const Ball both = lemma::far_factor(decimal("1.1"), A), one = lemma::far_factor(alpha, A);
    CHECK((lemma::strip_tail(K, alpha, beta, A, d) * one).overlaps(lemma::strip_tail(K, alpha, Ball(0), A, d) * both));
    CHECK((lemma::logistic_strip_tail(K, alpha, beta, A) * one).overlaps(lemma::logistic_strip_tail(K, alpha, Ball(0), A) * both));
}

TEST_CASE("far factor: E = -exp(-A) attains it")
{
    const WorkingPrecision precision(100);
    for (const char* k : {"0.7", "-0.7"}) {
        const Ball A = decimal("0.9"), E = k[0] == '-' ? exp(-A) : -exp(-A);
        attains(exp(-decimal(k) * log(Ball(1) + E)), lemma::far_factor(decimal(k), A) * (Ball(1) + decimal("1e-20")),
                k[0] == '-' ? Rational(6, 10) : Rational(999, 1000));
    }
}

TEST_CASE("remainder: (s/R)^n attains Cauchy's bound; slope: a Moebius map attains that of Schwarz and Pick")
{
    const WorkingPrecision precision(100);
    const Ball q = decimal("0.001");
    attains(decimal("5") * q * q * q, lemma::remainder(Ball(5), q, 3), Rational(99, 100));
    // T(s) = 5 (s/R - a)/(1 - a s/R), a = 1/4: T'(R/4) = 5/(R (1 - 1/16))
    const Ball R = decimal("2"), a = decimal("0.25"), step = decimal("1e-12");
    const auto T = [&](const Ball& s) { return Ball(5) * (s / R - a) / (Ball(1) - a * s / R); };
    const Ball at = R / Ball(4);
    attains(T(at) - T(at - step), lemma::slope(Ball(5), R, step), Rational(999, 1000));
}

TEST_CASE("logarithm: e^4 attains (4/e) rho^(1/4), and the enclosure on a piece has it")
{
    const WorkingPrecision precision(100);
    const Ball rho = exp(Ball(4));
    attains(log(rho) / exp(Ball(1)), lemma::logarithm_over_fourth_root() * (Ball(1) + decimal("1e-20")), Rational(999999, 1000000));
    const StripPiece piece = StripPiece::at(Side::right, 1, std::numeric_limits<double>::infinity(), 0, 0.5);
    const Complex l = function_of(Op::log, grown(piece, ComplexBall(1)));
    CHECK(l.right().logs == Exponent(1, 4));
    attains(Ball(4) * exp(Ball(-1)), size_of(l), Rational(99, 100));
}

TEST_CASE("exponentials on a piece: the power of the distance is the one they have, the factor no smaller than it is")
{
    const WorkingPrecision precision(100);
    const double x1 = 0.25, d = 0.5;
    const StripPiece piece = StripPiece::at(Side::right, x1, std::numeric_limits<double>::infinity(), 0, d);
    const Ball A = piece.depth();
    // exp(-rho) = |r| |1 + E|, exp(rho) = |r|^-1 |1 + E|^-1
    const Complex falls = function_of(Op::exp, grown(piece, ComplexBall(-1))), rises = function_of(Op::exp, grown(piece, ComplexBall(1)));
    CHECK(falls.right().power == Exponent(1));
    CHECK(rises.right().power == Exponent(-1));
    attains(Ball(1) + exp(-A), size_of(falls), Rational(1, 3));
    attains(Ball(1) / (Ball(1) - exp(-A)), size_of(rises), Rational(1, 2));
    // the exponent is rounded up: exp(rho/3) is never smaller than what is claimed of it, however far out
    const Complex third = function_of(Op::exp, grown(piece, ComplexBall(Rational(1, 3))));
    CHECK(!(Exponent(-1, 3) < third.right().power));
    CHECK(Exponent(-1, 3) - Exponent(1, 2000) < third.right().power);
    // exp(-rho^2) at the least rho is exp(-A^2) = |r|^A |1 + E|^A
    const Complex gaussian = function_of(Op::exp, grown(piece, ComplexBall(-1), 2));
    const Ball power = gaussian.right().power.ball();
    CHECK(arb_le(power.get(), A.get()));
    CHECK(arb_ge((power + decimal("0.001")).get(), A.get()));
    // |cos| <= 1 on the real axis, exp(|Im|) off it
    const Complex wave = function_of(Op::cos, grown(piece, ComplexBall(1)));
    CHECK(wave.right().power == Exponent(0));
    CHECK(arb_ge(size_of(wave).get(), Ball(1).get()));
    CHECK(function_of(Op::sin, grown(piece, ComplexBall(Ball(1), Ball(Rational(1, 4))))).right().power == Exponent(-1, 4));
}

TEST_CASE("erfc, Ai and K on a piece: at the least rho they are as large as is claimed")
{
    const WorkingPrecision precision(100);
    const auto piece_from = [](double x1) { return StripPiece::at(Side::right, x1, std::numeric_limits<double>::infinity(), 0, 0.0625); };
    // two discs were multiplied, each as the square about it: 2^(3/2) of what the lemma says
    const auto claimed = [](const Complex& f, const Ball& A) {
        return size_of(f) * exp(-f.right().power.ball() * A) / (Ball(2) * sqrt(Ball(2))) * (Ball(1) + decimal("1e-10"));
    };
    {
        const StripPiece piece = piece_from(0.03125);
        const Ball A = piece.depth();
        const Ball truth = special_function(Op::erfc, A);
        const Complex f = function_of(Op::erfc, grown(piece, ComplexBall(1)));
        attains(truth, claimed(f, A), Rational(7, 10));
    }
    {
        const StripPiece piece = piece_from(1.5);
        const Ball A = piece.depth();
        const Complex squared = grown(piece, ComplexBall(1), 2); // what holds of rho holds of no power of it
        for (const Op op : {Op::bessel_k_scaled, Op::bessel_i_scaled, Op::bessel_k})
            CHECK_FALSE(function_of(op, Ball(0), squared).factor().is_finite());
        // what is known of J and I of integer order is known of nothing else
        CHECK(function_of(Op::bessel_j, Ball(0), grown(piece, ComplexBall(1))).factor().is_finite());
        CHECK_FALSE(function_of(Op::bessel_j, Ball(1) / 2, grown(piece, ComplexBall(1))).factor().is_finite());
        CHECK_FALSE(function_of(Op::bessel_y, Ball(0), grown(piece, ComplexBall(1))).factor().is_finite());
        // atan x = pi/2 - atan(1/x), 1/x in [0, 1/A]
        const ComplexBall angle = function_of(Op::atan, grown(piece, ComplexBall(-1))).value();
        CHECK(angle.real().overlaps(touchstone::detail::ball_of(arb_atan, -A)));
        CHECK(arb_le((radius_of(angle) * A).get(), Ball(Rational(3, 5)).get()));
        // log rho in [0, (4/e) rho^(1/4)]
        const Complex logarithm = function_of(Op::log, grown(piece, ComplexBall(1), 3));
        CHECK(logarithm.right().logs == Exponent(1, 4));
        for (const double times : {1.0, 10.0, 54.598}) // e^4 where it is largest
            CHECK((logarithm.factor() * exp(log(A * Ball::exactly(times)) / 4)).overlaps(ComplexBall(log(A * Ball::exactly(times)) * 3)));
        CHECK_FALSE(logarithm.factor().overlaps(ComplexBall(Rational(-1, 100))));
        // erf, and either where x falls, about as near to its limit as it is
        const Ball rest = special_function(Op::erfc, A), room = rest * 100;
        for (const auto& [op, direction, truth] : {std::tuple(Op::erf, 1, Ball(1) - rest), std::tuple(Op::erf, -1, rest - Ball(1)),
                                                   std::tuple(Op::erfc, -1, Ball(2) - rest)}) {
            const ComplexBall value = function_of(op, grown(piece, ComplexBall(direction))).value();
            CHECK(value.overlaps(ComplexBall(truth)));
            CHECK(arb_le(radius_of(value).get(), room.get()));
        }
        attains(special_function(Op::airy_ai, A), claimed(function_of(Op::airy_ai, grown(piece, ComplexBall(1))), A), Rational(9, 10));
        for (const long order : {0L, 2L})
            attains(special_function(Op::bessel_k, Ball(order), A),
                    claimed(function_of(Op::bessel_k, Ball(order), grown(piece, ComplexBall(1))), A), Rational(9, 10));
    }
}

TEST_CASE("K_n far from 0, where it is made of numbers exp(2 x) larger, keeps the bits of its argument")
{
    for (const char* order : {"0", "1", "3/2"})
        for (const char* at : {"0.01", "1", "7", "30", "60", "100", "1000"}) {
            CAPTURE(order);
            CAPTURE(at);
            const WorkingPrecision precision(200);
            const Ball nu(*parse_rational(order)), x(*parse_rational(at));
            ComplexBall z(x, x / Ball(3));
            arb_add_error_2exp_si(acb_realref(z.get()), -190);
            const ComplexBall k = special_function(Op::bessel_k, nu, z);
            CHECK(acb_rel_accuracy_bits(k.get()) > 165);
            for (const long side : {-1, 0, 1}) {
                ComplexBall truth, w(x + Ball(side) * ScalarTraits<Ball>::power_of_two(-190), x / Ball(3));
                acb_hypgeom_bessel_k(truth.get(), ComplexBall(nu).get(), w.get(), 8000);
                CHECK(acb_overlaps(k.get(), truth.get()));
            }
        }
}

TEST_CASE("K_n by its size has the function, and most of it is its leading term")
{
    const WorkingPrecision precision(100);
    for (const char* order : {"0", "1", "3/2"}) {
        const Ball nu(*parse_rational(order));
        const ComplexBall z(Ball(300), Ball(100)), by_size = bessel_k_by_its_size(nu, z);
        CHECK(acb_overlaps(by_size.get(), special_function(Op::bessel_k, nu, z).get()));
        CHECK(acb_rel_accuracy_bits(by_size.get()) >= 5);
    }
}

TEST_CASE("Bessel remainder: K_n less its leading term, near and far")
{
    const WorkingPrecision precision(100);
    const auto remainder = [](const Ball& order, const ComplexBall& z) {
        ComplexBall k, root;
        acb_hypgeom_bessel_k(k.get(), ComplexBall(order).get(), z.get(), 200);
        const ComplexBall front = analytic::sqrt(ComplexBall(pi<Ball>() / Ball(2)) / z) * analytic::exp(-z);
        return abs(k / front - ComplexBall(1));
    };
    for (const char* order : {"0", "1", "2.5", "7"})
        for (const char* size : {"1", "10", "1000"})
            for (const long eighths : {0L, 1L, 2L, 3L}) {
                const Ball r = decimal(size), angle = pi<Ball>() * Ball(eighths) / Ball(8) * Ball(Rational(999, 1000));
                const Ball truth = remainder(decimal(order), ComplexBall(r * cos(angle), r * sin(angle)));
                CHECK(arb_le(truth.get(), lemma::bessel_remainder(decimal(order), r, Ball(1)).get()));
            }
    // |R| -> |a_1|/|z|: half of what is claimed, the other half is 2 |a_1|
    attains(Ball(2) * remainder(Ball(7), ComplexBall(decimal("1e8"))), lemma::bessel_remainder(Ball(7), decimal("1e8"), Ball(1)),
            Rational(99, 100));
    attains(Ball(2) * remainder(Ball(0), ComplexBall(decimal("1e8"))), lemma::bessel_remainder(Ball(0), decimal("1e8"), Ball(1)),
            Rational(99, 100));
    // a longer way around 0 counts as if z were as much nearer
    const Ball longer = pi<Ball>() / 2;
    const Ball around = lemma::bessel_remainder(Ball(7), longer * 100, longer) - lemma::bessel_remainder(Ball(7), Ball(100), Ball(1));
    CHECK(around.contains(Rational(0)));
    CHECK(around.radius_bound() < 1e-25);
}

TEST_CASE("elliptic remainder: K(1 - u) less its logarithm, for u so small that one term is all")
{
    const WorkingPrecision precision(400);
    for (const char* text : {"1e-30", "1e-3", "0.4"}) {
        const Ball u = decimal(text);
        const Ball rest =
            special_function(Op::elliptic_k, u) / pi<Ball>() * (log(Ball(16)) - log(u)) - special_function(Op::elliptic_k, Ball(1) - u);
        CHECK(arb_le(rest.get(), lemma::elliptic_remainder(u, 1).get()));
        if (text[0] == '1') attains(rest, lemma::elliptic_remainder(u, 1), Rational(72, 100));
    }
}

TEST_CASE("means of K and E: the first mean against the limit, at every size")
{
    const WorkingPrecision precision(128);
    CHECK(lemma::limit_of_means(Ball(3), Ball(Rational(1, 2))).contains(Rational(3)));
    CHECK(lemma::rest_of_means(Ball(2), Ball(Rational(1, 2)), 4).contains(Rational(32)));
    for (const char* scale : {"1/16", "1", "50"}) {
        const Ball a(*parse_rational(scale)), b = a / 2, mean = (a + b) / 2, delta = sqrt(a * b);
        Ball limit;
        arb_agm(limit.get(), a.get(), b.get(), 128);
        const Ball c = (a - b) / 2;
        attains(mean - limit, lemma::limit_of_means(c * c, delta), Rational(48, 100));
        // 2^(k-1) c_k^2 from the second term on, the largest part of which is the first
        Ball rest(0), x = mean, y = delta;
        for (long k = 2; k < 8; ++k) {
            const Ball next = (x - y) / 2, together = x * y;
            rest += next * next * Ball(1L << (k - 1));
            x = (x + y) / 2;
            y = sqrt(together);
        }
        attains(rest, lemma::rest_of_means(c * c, delta, 1), Rational(20, 100));
    }
}

TEST_CASE("functions with a logarithm at an end are themselves on both sides of where their form changes, and along the strip")
{
    const WorkingPrecision precision(200);
    struct Distance : Frame<Ball> {
        explicit Distance(const Ball& s)
            : s_(s)
        {
        }
        Ball distance(Side) const override { return s_; }
        Ball logarithm(Side) const override { return log(s_); }
        Ball s_;
    };
    for (const char* text : {"1e-40", "0.001", "0.49", "0.51", "0.9", "1.9", "2.1", "7"}) {
        const Ball s = decimal(text);
        const Distance frame(s);
        const EndpointNumber<Ball> u(&frame, {Exponent(1), {}}, {}, Ball(1));
        CAPTURE(text);
        if (arb_lt(s.get(), Ball(1).get()))
            for (const Op op : {Op::elliptic_k, Op::elliptic_e}) {
                const Op complement = op == Op::elliptic_k ? Op::elliptic_k_of_complement : Op::elliptic_e_of_complement;
                const Ball value = function_of(complement, u).value();
                CHECK(value.overlaps(special_function(op, Ball(1) - s)));
                CHECK(value.relative_bits() > 150);
            }
        for (const long order : {0L, 1L, 2L, 5L})
            for (const Op op : {Op::bessel_k, Op::bessel_y}) {
                const Ball value = function_of(op, Ball(order), u).value();
                CHECK(value.overlaps(special_function(op, Ball(order), s)));
                CHECK(value.relative_bits() > 140);
            }
        for (const long order : {0L, 1L, 2L, 5L}) {
            const Ball value = function_of(Op::bessel_k_scaled, Ball(order), u).value();
            CHECK(value.overlaps(special_function(Op::bessel_k_scaled, Ball(order), s)));
            CHECK(value.relative_bits() > 140);
        }
        for (const long twice : {1L, -1L, 3L, -5L})
            for (const Op op : {Op::bessel_j, Op::bessel_i, Op::bessel_i_scaled}) {
                const Ball order = Ball(twice) / Ball(2), value = function_of(op, order, u).value();
                CHECK(value.overlaps(special_function(op, order, s)));
                CHECK(value.relative_bits() > 140);
            }
    }
    // a point at which the image has wound more than half around the end: the continued function, by its derivative's equation along the
    // way
    const StripPiece piece = StripPiece::at(Side::right, 1.5, 1.5, 1.2, 1.2);
    const Complex r(&piece, {}, {Exponent(1), {}}, ComplexBall(1));
    const ComplexBall l = piece.logarithm(Side::right), v = piece.distance(Side::right);
    REQUIRE(arb_gt(abs(l.imag()).get(), pi<Ball>().get()));
    const ComplexBall turn = l - analytic::log(v); // a multiple of 2 pi i
    const ComplexBall expected = special_function(Op::bessel_k, Ball(0), v) - turn * special_function(Op::bessel_i, Ball(0), v);
    CHECK(acb_overlaps(function_of(Op::bessel_k, Ball(0), r).value().get(), expected.get()));
    CHECK_FALSE(acb_overlaps(function_of(Op::bessel_k, Ball(0), r).value().get(), special_function(Op::bessel_k, Ball(0), v).get()));
    CHECK(acb_overlaps(function_of(Op::bessel_k_scaled, Ball(0), r).value().get(), (analytic::exp(v) * expected).get()));
    const ComplexBall k =
        special_function(Op::elliptic_k, ComplexBall(1) - v) - turn * special_function(Op::elliptic_k, v) / ComplexBall(pi<Ball>());
    CHECK(acb_overlaps(function_of(Op::elliptic_k_of_complement, r).value().get(), k.get()));
    const ComplexBall e = special_function(Op::elliptic_e, ComplexBall(1) - v) -
                          turn * (special_function(Op::elliptic_k, v) - special_function(Op::elliptic_e, v)) / ComplexBall(pi<Ball>());
    const ComplexBall continued_e = function_of(Op::elliptic_e_of_complement, r).value();
    CHECK(acb_overlaps(continued_e.get(), e.get()));
    CHECK(acb_rel_accuracy_bits(continued_e.get()) > 40);
    for (const Op op : {Op::bessel_j, Op::bessel_i}) { // an odd half of a turn
        const ComplexBall half = exp(turn / ComplexBall(2)) * special_function(op, Ball(1) / Ball(2), v);
        const ComplexBall continued = function_of(op, Ball(1) / Ball(2), r).value();
        CHECK(acb_overlaps(continued.get(), half.get()));
        CHECK(acb_rel_accuracy_bits(continued.get()) > 40);
    }
    // wound as far, but too large for the series: nothing rather than the principal value
    const StripPiece beside = StripPiece::at(Side::right, 0.2, 0.2, 1.4, 1.4);
    const Complex large(&beside, {}, {Exponent(1), {}}, ComplexBall(1));
    REQUIRE(arb_gt(abs(beside.logarithm(Side::right).imag()).get(), pi<Ball>().get()));
    CHECK_FALSE(function_of(Op::elliptic_k_of_complement, large).value().is_finite());
    CHECK_FALSE(function_of(Op::bessel_k, Ball(0), large).value().is_finite());
}

TEST_CASE("log(1 + v)/v about v = 0 and as far as it is taken: v < 0 attains most of what it is off 1")
{
    const WorkingPrecision precision(100);
    // x = -log r, so that v = exp(-x) is r, as wide as that and no wider; where this piece begins, r is negative: E = -exp(-A)
    Interval half_line = Interval::right_half_line(0, Decay::exponential);
    half_line.prepare();
    const StripPiece piece = StripPiece::at(Side::right, 0.69, std::numeric_limits<double>::infinity(), 0, 0.9293);
    const auto at =
        half_line.at(Complex(&piece, {Exponent(1), {}}, {}, ComplexBall(1)), Complex(&piece, {}, {Exponent(1), {}}, ComplexBall(1)));
    const Integrand f(parse_expression("log(1+exp(-x))"), Range{parse_limit("0"), parse_limit("inf"), Map::right_exponential});
    const Complex logarithm = f.at(at.x, at.left, at.right);
    REQUIRE(logarithm.right().power == Exponent(1));
    const Ball q = size_of(Complex(nullptr, {}, {}, piece.distance(Side::right)));
    attains(-log(Ball(1) - q) / q - Ball(1), size_of(logarithm) - Ball(1), Rational(13, 20));
}

TEST_CASE("odd difference: the identity attains it")
{
    const WorkingPrecision precision(100);
    const Ball R = decimal("0.3"), s = decimal("0.07");
    attains((s - -s) / s, lemma::odd_difference(R, R) * (Ball(1) + decimal("1e-20")), Rational(999999, 1000000));
}

TEST_CASE("turned path: a constant amplitude attains what lies beyond; the quadrant has all of 1/(1 + z)")
{
    const WorkingPrecision precision(100);
    const Ball w = decimal("1.7"), S = decimal("3");
    attains(exp(-w * S) / w, lemma::beyond(Ball(1), w, S) * (Ball(1) + decimal("1e-20")), Rational(999999, 1000000));
    const auto supremum = [](const char* formula, long base, long distance) {
        const auto all = waves(parse_expression(formula));
        REQUIRE(all);
        const auto s = supremum_in_quadrant(all->at(0), base, distance);
        REQUIRE(s);
        return *s;
    };
    // at z = X the amplitude is largest
    attains(decimal("0.1"), supremum("sin(x)/x", 0, 10), Rational(6, 10));
    attains(exp(log(decimal("13")) * decimal("-0.5")), supremum("cos(x)/sqrt(x)", 3, 10), Rational(1, 10));
    attains(log(decimal("21")) / decimal("21"), supremum("cos(x)*log(1+x)/(1+x)", 0, 20), Rational(1, 4));
    // J and Y are parts of (2/(pi w z))^(1/2) exp(i w z) times a factor that tends to 1, in all (2/pi) |K(-i w z)|: largest about z = X
    for (const auto& [formula, order, frequency, share] :
         {std::tuple{"besselj(0,3*x)/x", 0, 3, Rational(6, 10)}, std::tuple{"bessely(2,x/2)/x", 2, 0, Rational(1, 4)}}) {
        CAPTURE(formula);
        const Ball own = frequency != 0 ? Ball(frequency) : Ball(Rational(1, 2)), most = supremum(formula, 0, 10);
        for (const char* y : {"0", "0.1", "1", "10", "100"}) {
            const ComplexBall z(Ball(10), decimal(y)), rotated(own * z.imag(), -own * z.real());
            const Ball k = abs(special_function(Op::bessel_k, Ball(order), rotated));
            const Ball there = k * exp(own * z.imag()) * Ball(2) / pi<Ball>() / abs(z);
            CHECK(arb_le(there.get(), most.get()));
            if (y[0] == '0' && y[1] == '\0') attains(there, most, share);
        }
    }
    // the argument of log z grows to pi/2: |log z| there, not on the axis
    CHECK(arb_ge(supremum("cos(x)/log(1+x)", 0, 20).get(), (Ball(1) / log(Ball(21))).get()));
}

TEST_CASE("quadrant: r = 1/(1 + z), its logarithm and its powers are enclosed, and reach the edges of what encloses them")
{
    const WorkingPrecision precision(100);
    const long distance = 6;
    const Quadrant quadrant(distance);
    const ComplexBall r = quadrant.distance(Side::right), slope = quadrant.logarithm_over_rho(Side::right);
    const ComplexBall rest = quadrant.distance(Side::left), its_logarithm = quadrant.logarithm(Side::left); // of 1 - r, which is nearly all
    CHECK(arb_lt(abs(rest - ComplexBall(1)).get(), Ball(Rational(1, 5)).get()));
    CHECK(arb_lt(abs(its_logarithm).get(), Ball(Rational(1, 4)).get()));
    Ball least_imaginary(0), least_angle(0);
    for (const char* x : {"0", "0.5", "3", "1000"})
        for (const char* y : {"0", "1", "7", "100", "1e9", "1e40"}) {
            const ComplexBall z(Ball(distance) + decimal(x), decimal(y)), at = ComplexBall(1) / (ComplexBall(1) + z);
            CHECK(acb_overlaps(r.get(), at.get()));
            CHECK(acb_overlaps(rest.get(), (ComplexBall(1) - at).get()));
            CHECK(acb_overlaps(its_logarithm.get(), analytic::log(ComplexBall(1) - at).get()));
            const ComplexBall l = analytic::log(at);
            const Ball rho = -log(abs(at));
            CHECK(acb_overlaps(slope.get(), (l / ComplexBall(rho)).get()));
            for (const Exponent& e : {Exponent(1, 3), Exponent(2)})
                for (const Exponent& k : {Exponent(-1), Exponent(0), Exponent(5)}) {
                    const Ball size = exp(-e.ball() * rho + k.ball() * log(rho));
                    Ball most = quadrant.vanishing(Side::right, e.ball(), k).real();
                    arb_get_ubound_arf(arb_midref(most.get()), most.get(), 53);
                    mag_zero(arb_radref(most.get()));
                    CHECK(arb_le(size.get(), (most * (Ball(1) + decimal("1e-12"))).get()));
                }
            if (arb_lt(at.imag().get(), least_imaginary.get())) least_imaginary = at.imag();
            const Ball angle = l.imag() / Ball(1);
            if (arb_lt(angle.get(), least_angle.get())) least_angle = angle;
        }
    attains(-least_imaginary, Ball(1) / Ball(2 * (1 + distance)) * (Ball(1) + decimal("1e-12")), Rational(99, 100)); // z = D + i(1 + D)
    attains(-least_angle, pi<Ball>() / Ball(2) * (Ball(1) + decimal("1e-12")), Rational(99, 100));
    const Ball lower = slope.imag();
    Ball most;
    arb_get_lbound_arf(arb_midref(most.get()), lower.get(), 53);
    attains(pi<Ball>() / Ball(2) / log(Ball(1 + distance)), -most, Rational(999, 1000));
    // exp(-rho/3) rho^5 is largest at rho = 15
    Ball top = quadrant.vanishing(Side::right, Ball(1) / Ball(3), Exponent(5)).real();
    arb_get_ubound_arf(arb_midref(top.get()), top.get(), 53);
    mag_zero(arb_radref(top.get()));
    attains(exp(Ball(-5) + Ball(5) * log(Ball(15))), top, Rational(999, 1000));
}

TEST_CASE("Bessel functions and polylogarithms have no value on a ball that meets their cut, and those without a cut have one")
{
    const WorkingPrecision precision(100);
    ComplexBall z(Ball(-2));
    widen(z, Ball(1) / Ball(4));
    for (const long order : {0L, 1L}) {
        for (const Op op : {Op::bessel_y, Op::bessel_k, Op::bessel_k_scaled}) CHECK_FALSE(special_function(op, Ball(order), z).is_finite());
        for (const Op op : {Op::bessel_j, Op::bessel_i}) CHECK(special_function(op, Ball(order), z).is_finite());
    }
    for (const Op op : {Op::bessel_j, Op::bessel_i}) CHECK_FALSE(special_function(op, Ball(1) / Ball(2), z).is_finite());
    ComplexBall beyond_one(Ball(3) / Ball(2)); // the cut of polylogarithms
    widen(beyond_one, Ball(1) / Ball(4));
    CHECK_FALSE(special_function(Op::polylog, Ball(2), beyond_one).is_finite());
    CHECK(special_function(Op::polylog, Ball(2), z).is_finite());
    // order 0 is z/(1 - z), on wide balls too, and has a pole at 1 and no cut
    ComplexBall half(Ball(1) / Ball(2));
    widen(half, Ball(1) / Ball(4));
    const ComplexBall w = special_function(Op::polylog, Ball(0), half);
    CHECK(w.is_finite());
    CHECK(w.real().contains(Rational(3)));
    CHECK(w.real().contains(Rational(1, 3)));
    CHECK(special_function(Op::polylog, Ball(0), beyond_one).real().contains(Rational(-3)));
    ComplexBall one(Ball(1));
    widen(one, Ball(1) / Ball(4));
    CHECK_FALSE(special_function(Op::polylog, Ball(0), one).is_finite());
}

TEST_CASE("functions of one argument have a value up to the end of their cut, and none on it: next to the end, on both sides")
{
    const WorkingPrecision precision(100);
    const Ball near(Rational(1, 1000)), end_of_lambert = -exp(Ball(-1));
    struct Cut {
        Op op;
        Ball end;
        int right; ///< where it lies: 1 or -1
    };
    for (const auto& [op, end, right] : {Cut{Op::lambert_w, end_of_lambert, -1}, {Op::acosh, Ball(1), -1}, {Op::log1p, Ball(-1), -1},
                                         {Op::lgamma, Ball(0), -1}, {Op::acos, Ball(1), 1}, {Op::acos, Ball(-1), -1},
                                         {Op::atanh, Ball(1), 1}, {Op::atanh, Ball(-1), -1}}) {
        CAPTURE(static_cast<int>(op));
        CHECK_FALSE(special_function(op, ComplexBall(end + right * near)).is_finite());
        CHECK(special_function(op, ComplexBall(end - right * near)).is_finite());
        CHECK(special_function(op, ComplexBall(end + right * near, near)).is_finite()); // beside it
    }
}
