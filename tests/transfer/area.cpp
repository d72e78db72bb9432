// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/archard_constants.hpp"
#include "touchstone/recursion/first_steps/area_by_slope.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/transfer/series.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <thread>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

/// What the precision of these balls is meant for.
Accuracy wanted() { return {accuracy_of(WorkingPrecision::bits()).digits + 1}; }

Rational exactly(const char* text) { return *parse_rational(text); }

Arguments at(const char* load, const char* G)
{
    return {[load] { return Ball(exactly(load)); }, [G] { return Ball(exactly(G)); }};
}

Evaluation eval(const char* name, std::map<std::string, Rational> in, long digits)
{
    return evaluate(*find_quantity(name), Inputs(std::move(in)), {.digits = digits});
}

} // namespace

TEST_CASE("the two discretisations overlap, tightly")
{
    for (const char* G : {"2.05", "3.1622776601683795", "16", "1000"})
        for (const char* load : {"1", "0.999", "0.5", "0.01", "1e-12"})
            for (const long n : {0L, 1L, 2L, 3L, 10L, 100L}) {
                CAPTURE(G); CAPTURE(load); CAPTURE(n);
                const WorkingPrecision precision(128);
                const Ball a = area(Scheme::force_weighted, n, at(load, G), wanted()), b = area(Scheme::area, n, at(load, G), wanted());
                CHECK(a.overlaps(b));
                CHECK(a.relative_bits() > 44);
                CHECK(b.relative_bits() > 44);
            }
}

namespace {

void check_near_2(const char* G)
{
    const WorkingPrecision precision(128);
    for (const char* load : {"1", "0.3"}) {
        const Ball a = area(Scheme::force_weighted, 20, at(load, G), wanted()), b = area(Scheme::area, 20, at(load, G), wanted());
        CHECK(a.overlaps(b));
        CHECK(a.relative_bits() > 44);
        CHECK(b.relative_bits() > 44);
    }
}

/// Loads of 1 - 10^-digits by both discretisations, and at scale 2 by the integral over the slope, which has neither.
void check_next_to_1(std::initializer_list<unsigned long> all_digits)
{
    const WorkingPrecision precision(128);
    for (const unsigned long digits : all_digits) {
        const Rational load = 1 - power(Rational(10), -static_cast<long>(digits));
        for (const char* G : {"2.1", "3", "1000"})
            for (const long n : {2L, 3L, 30L}) {
                CAPTURE(digits); CAPTURE(G); CAPTURE(n);
                const Arguments arguments{[load] { return Ball(load); }, [G] { return Ball(exactly(G)); }};
                const Ball a = area(Scheme::force_weighted, n, arguments, wanted()), b = area(Scheme::area, n, arguments, wanted());
                CHECK(a.overlaps(b));
                CHECK(a.relative_bits() > 44);
                CHECK(b.relative_bits() > 44);
                if (n == 2 && digits <= 30) CHECK(a.overlaps(area_by_slope(2, {load, [G] { return Ball(exactly(G)); }, exactly(G)}, 60)));
            }
    }
}

} // namespace

TEST_CASE("very near G = 2: 2.001") { check_near_2("2.001"); }
TEST_CASE("slow: very near G = 2: 2.0001" * doctest::skip()) { check_near_2("2.0001"); }
TEST_CASE("as near to load = 1 as one likes: 17 and 300 digits") { check_next_to_1({17, 300}); }
TEST_CASE("slow: as near to load = 1 as one likes: 20, 30 and 100 digits" * doctest::skip()) { check_next_to_1({20, 30, 100}); }

TEST_CASE("next to load = 1 what the last 1e-20 of the load is worth is seen")
{
    // the slope next to 1 is finite from scale 1 on, but for a logarithm
    const WorkingPrecision more(bits_for_digits(40) + 48);
    const Ball at_one = area(Scheme::area, 3, at("1", "3"), wanted()),
               below =
                   area(Scheme::area, 3, {[] { return Ball(Rational(1 - power(Rational(10), -20))); }, [] { return Ball(3); }}, wanted());
    CHECK(certainly(less(below, at_one)));
    CHECK(certainly(less(at_one - below, Ball(exactly("1e-18")))));
}

namespace {

void check_light_loads(std::initializer_list<const char*> loads)
{
    const WorkingPrecision precision(bits_for_digits(15) + 48);
    for (const char* load : loads)
        for (const long n : {1L, 4L, 9L}) {
            CAPTURE(load); CAPTURE(n);
            const Ball own = area(Scheme::force_weighted, n, at(load, "3"), wanted()),
                       series = area_series(n, Ball(exactly(load)), Ball(3));
            CHECK(own.overlaps(series));
            CHECK(own.relative_bits() > 44);
            CHECK(series.relative_bits() > 44); // what is cut off is relative to the area, however light the load
            if (n != 4) continue;
            const Ball again = area(Scheme::area, n, at(load, "3"), wanted());
            CHECK(again.overlaps(series));
            CHECK(again.relative_bits() > 44);
        }
}

} // namespace

TEST_CASE("slow: light loads of 1e-150: the power series" * doctest::skip()) { check_light_loads({"1e-150"}); }
TEST_CASE("light loads down to 1e-300: the power series")
{
    const WorkingPrecision precision(bits_for_digits(15) + 48);
    check_light_loads({"1e-88"});
    // at scale 2 the integral over the slope, which has no series
    const Ball series = area_series(2, Ball(exactly("1e-300")), Ball(3));
    CHECK(series.overlaps(area_by_slope(2, {exactly("1e-300"), [] { return Ball(3); }, exactly("3")}, 60)));
    for (const long n : {2L, 5L, 12L}) CHECK(area_series(n, Ball(exactly("1e-300")), Ball(3)).relative_bits() > 60);
}

TEST_CASE("a ball at low precision holds the value known from a high one, and is not idly wide")
{
    for (const char* G : {"2.05", "10"})
        for (const Scheme scheme : {Scheme::force_weighted, Scheme::area})
            for (const long n : {1L, 20L, 60L}) {
                CAPTURE(G); CAPTURE(n);
                const auto at_bits = [&](slong bits) {
                    const WorkingPrecision precision(bits);
                    return area(scheme, n, at("0.3", G), wanted());
                };
                const Ball rough = at_bits(100), fine = at_bits(160);
                CHECK(rough.contains(fine));
                Ball off;
                arb_get_mid_arb(off.get(), rough.get());
                CHECK(certainly(less(Ball(exactly("1e-9")) * Ball::exactly(rough.radius_bound()), abs(off - fine))));
            }
}

TEST_CASE("a grid too coarse for its rule: the interpolation error shows, and its bound alone covers it")
{
    const auto G = [] { return Ball(exactly("2.25")); };
    for (const Scheme scheme : {Scheme::force_weighted, Scheme::area}) {
        Discretisation coarse(scheme, G, 70, 12), fine(scheme, G, 70);
        CHECK(2 * coarse.size() < fine.size());
        const WorkingPrecision precision(fine.bits());
        for (const long n : {2L, 3L, 8L})
            for (const char* x : {"0.8", "0.1", "1e-3"}) {
                CAPTURE(n); CAPTURE(x);
                const Ball rough = coarse.force_share(n, Ball(exactly(x))), sharp = fine.force_share(n, Ball(exactly(x)));
                Ball off;
                arb_get_mid_arb(off.get(), rough.get());
                off = abs(off - sharp);
                CHECK(rough.overlaps(sharp));
                CHECK(certainly(less(Ball(exactly("1e-18")), off))); // more than all other errors together
                CHECK(certainly(less(Ball::exactly(rough.radius_bound()), off * 100'000'000)));
            }
    }
}

TEST_CASE("each part of a row's budget is what is counted for it")
{
    for (const char* g : {"2.25", "30"})
        for (const Scheme scheme : {Scheme::force_weighted, Scheme::area}) {
            const auto G_at = [g] { return Ball(exactly(g)); };
            const double accuracy = 40;
            Discretisation D(scheme, G_at, accuracy, 30);
            CAPTURE(G_at().to_string(5)); CAPTURE(static_cast<int>(scheme));
            const WorkingPrecision precision(D.bits());
            const Ball G = G_at();
            const Ratios all{2 / G, false};
            const bool force = scheme == Scheme::force_weighted;
            const double V = cut_off(all, accuracy) * (force ? 1 : 1.04);
            const Rule rule = force ? double_exponential_rule(G, all, accuracy, V) : gauss_panel_rule(G, all, accuracy, V);
            // the row next to x = 2/G has the largest sum of weights: the integral of (4/pi) sech^3(v) (x/y)^(1/2)
            Ball R(0);
            const Ball x = 2 / G;
            for (const auto& q : rule.nodes) {
                const Ball y = 2 / G * sqrt(x * (1 + (1 - x) * q.sinh_squared)) * q.sech_squared;
                R += q.area_weight * q.sech_squared * sqrt(x / y);
            }
            const auto number = [](const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); };
            const double total = number(R), rho = D.rho(), p = static_cast<double>(D.points_of_block());
            const double terms = static_cast<double>(rule.nodes.size());
            const double fourth_root = std::sqrt(std::sqrt(number(x))), u = std::ldexp(1.0, -static_cast<int>(D.bits() - 24));
            double scale = 1;
            while (scale <= number(magnitudes(G, 128).back())) scale *= 2;
            const Budget& b = D.worst();
            const auto is = [](const Ball& part, double counted, double within = 3e-3) {
                CAPTURE(counted);
                CAPTURE(part.to_string(5));
                CHECK(certainly(less(Ball::exactly(counted * (1 - within)), part))); // the first node's ratio is a little below 2/G
                CHECK(certainly(less(part, Ball::exactly(counted * (1 + within)))));
            };
            is(b.rule, number(rule.discretisation) * fourth_root);
            is(b.truncation, number(rule.truncation) * fourth_root);
            is(b.interpolation, total * 4 * std::pow(rho, 1 - p) / (rho - 1));
            is(b.abscissae, total * u / ((rho + 1 / rho) / 2 - 1));
            is(b.weights, terms * u);
            const double moment = 4 * terms * u * p * p, N = static_cast<double>(D.size());
            const double moments = p * total + N * moment * std::pow(rho, p);
            is(b.entries, p * moment * (2 + 4 / (rho * rho - 1)) + moments * (4 * p + 1 + scale) * u, 1e-5);
            // a level begins with what c, at its limit, makes of a row's budget
            const std::string text = D.certificate(1);
            const double error = std::stod(text.substr(text.find_first_of("0123456789", text.find("error <= "))));
            CHECK(error == doctest::Approx(number(magnitudes(G, 128).back() * b.total())).epsilon(0.01).scale(0));
            // scale 1 has the error of a row, c_0 = 1, and what level 0 carries into it: weights by nodes have nearly the sum of the rule's
            const double off = D.force_share(1, x * Ball(exactly("0.999"))).radius_bound(), carried = off - number(b.total());
            CHECK(carried > 0.8 * total * error);
            CHECK(carried < 1.1 * total * error);
            const Ball parts = b.rule + b.truncation + b.interpolation + b.abscissae + b.weights + b.entries;
            CHECK(certainly(less(abs(b.total() / parts - 1), Ball(exactly("1e-6")))));
        }
}

TEST_CASE("a row above x = 2/G has the budget of a rule made for it, and one of a weight known to few digits what these are worth")
{
    const double accuracy = 30;
    const Ball G(3);
    const auto number = [](const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); };
    for (const Scheme scheme : {Scheme::force_weighted, Scheme::area}) {
        CAPTURE(static_cast<int>(scheme));
        Discretisation D(scheme, [] { return Ball(3); }, accuracy, 50);
        const WorkingPrecision precision(D.bits());
        const Ball high(exactly("0.99")), low(exactly("0.2"));
        const bool force = scheme == Scheme::force_weighted;
        const auto rule_for = [&](const Ratios& x, double V) {
            return force ? double_exponential_rule(G, x, accuracy, V) : gauss_panel_rule(G, x, accuracy, V);
        };
        const Ratios one{high, true}, all{2 / G, false};
        const Rule rule = rule_for(one, cut_off(one, accuracy));
        const double counted = number((rule.discretisation + rule.truncation) * sqrt(sqrt(high)));
        const double budget = number(D.functional({{high, Ball(1)}}).budget);
        CHECK(budget > 0.999 * counted);
        CHECK(budget < 1.01 * counted);

        Ball weight(exactly("0.7"));
        arb_add_error(weight.get(), Ball(exactly("1e-9")).get());
        double R = 0;
        for (const auto& q : rule_for(all, cut_off(all, accuracy) * (force ? 1 : 1.04)).nodes) {
            const Ball y = 2 / G * sqrt(low * (1 + (1 - low) * q.sinh_squared)) * q.sech_squared;
            R += number(q.area_weight * q.sech_squared * sqrt(low / y));
        }
        const double rho = D.rho(), worth = static_cast<double>(D.size()) * 1e-9 * R * (2 + 4 / (rho * rho - 1));
        CHECK(number(D.functional({{low, weight}}).budget) == doctest::Approx(worth).epsilon(1e-3).scale(0));
    }
}

TEST_CASE("an ellipse of interpolation is proven inside Re s > 0, up to where it touches")
{
    const WorkingPrecision precision(96);
    const auto inside = &Discretisation::ellipse_is_inside;
    // log s: the semi-minor axis, half (rho - 1/rho)/2, is below pi/2
    CHECK(inside(Scheme::force_weighted, -1, std::numbers::pi * 0.999 / 1.5, 2));
    CHECK_FALSE(inside(Scheme::force_weighted, -1, std::numbers::pi * 1.001 / 1.5, 2));
    CHECK(inside(Scheme::force_weighted, 3, std::numbers::pi * 0.999 / 4.8, 5));
    CHECK_FALSE(inside(Scheme::force_weighted, 3, std::numbers::pi * 1.001 / 4.8, 5));
    // s: the semi-major axis, half (rho + 1/rho)/2, is below the centre
    CHECK(inside(Scheme::area, 1.251, 1, 2));
    CHECK_FALSE(inside(Scheme::area, 1.249, 1, 2));
    CHECK(inside(Scheme::area, 7.81, 3, 5));
    CHECK_FALSE(inside(Scheme::area, 7.79, 3, 5));
}

TEST_CASE("loads are refused from where the grid ends, and enclosed before: scale 1 by its power series")
{
    for (const Scheme scheme : {Scheme::force_weighted, Scheme::area}) {
        const auto G_at = [] { return Ball(3); };
        Discretisation D(scheme, G_at, 20);
        CAPTURE(static_cast<int>(scheme));
        bool refused = false;
        int served = 0;
        for (long k = 0; k < 120; ++k) {
            const WorkingPrecision precision(D.bits());
            const Ball load = ScalarTraits<Ball>::power_of_two(-1 - 3 * k);
            try {
                const Ball F = D.force_share(1, load);
                CAPTURE(k);
                CHECK_FALSE(refused);
                CHECK(F.overlaps(area_series(1, load, Ball(3)) * Ball(3) / sqrt(load)));
                CHECK(F.is_finite());
                ++served;
            }
            catch (const BeyondReach&) {
                refused = true;
            }
        }
        CHECK(refused);
        CHECK(served > 10);
    }
}

TEST_CASE("a row of a load known to few digits holds all loads it may be, and one of many points their sum")
{
    for (const Scheme scheme : {Scheme::force_weighted, Scheme::area}) {
        Discretisation D(scheme, [] { return Ball(3); }, 40);
        CAPTURE(static_cast<int>(scheme));
        const WorkingPrecision precision(D.bits());
        for (const long n : {1L, 4L}) {
            Ball wide(exactly("0.3"));
            arb_add_error(wide.get(), Ball(exactly("1e-12")).get());
            const Ball F = D.force_share(n, wide);
            for (const char* load : {"0.2999999999990001", "0.3", "0.3000000000009999"})
                CHECK(F.overlaps(D.force_share(n, Ball(exactly(load)))));
            CHECK(F.relative_bits() > 25);
            Ball weight(exactly("-0.7"));
            arb_add_error(weight.get(), Ball(exactly("1e-13")).get());
            const Ball eighth(exactly("0.125"));
            const std::vector<Discretisation::Point> points{
                {Ball(exactly("0.9")), Ball(2)}, {Ball(exactly("0.2")), weight}, {Ball(exactly("0.05")), eighth}};
            const Ball sum = D.apply(D.functional(points), n);
            const auto one = [&](const char* load) { return D.force_share(n, Ball(exactly(load))); };
            for (const char* w : {"-0.70000000000009", "-0.7", "-0.69999999999991"})
                CHECK(sum.overlaps(2 * one("0.9") + Ball(exactly(w)) * one("0.2") + one("0.05") / 8));
            CHECK(sum.relative_bits() > 25);
        }
    }
}

TEST_CASE("the hypergeometric function in a term of the power series is enclosed, and what is left out next to x = 1 is")
{
    for (const char* x : {"0.25", "0.99", "0.999"})
        for (const char* s : {"1/2", "7/3", "12.25", "40"}) {
            CAPTURE(x); CAPTURE(s);
            const auto at_bits = [&](slong bits, auto function) {
                const WorkingPrecision precision(bits);
                return function(Ball(exactly(s)), Ball(exactly(x)));
            };
            const Ball own = at_bits(64, [](const Ball& a, const Ball& z) { return hypergeometric(a, z); });
            const Ball known = at_bits(300, [](const Ball& a, const Ball& z) {
                Ball r;
                arb_hypgeom_2f1(r.get(), ((1 - a) / 2).get(), Ball(exactly("1/2")).get(), ((3 + a) / 2).get(), z.get(), 0, 300);
                return r;
            });
            CHECK(own.contains(known));
            CHECK(own.relative_bits() > 40);
        }
}

TEST_CASE("a geometric sum is that of its terms")
{
    const WorkingPrecision precision(80);
    for (const char* ratio : {"0", "1/16", "1/2", "3/4"}) {
        CAPTURE(ratio);
        Ball sum(0), term(exactly("7/3"));
        for (int k = 0; k < 300; ++k) { // the rest is below 2^-120
            sum += term;
            term = term * Ball(exactly(ratio));
        }
        const Ball closed = geometric_sum(Ball(exactly("7/3")), Ball(exactly(ratio)));
        CHECK(certainly(less(abs(closed - sum), ScalarTraits<Ball>::power_of_two(-60))));
    }
}

TEST_CASE("what the power series leaves out is T1 c G^-(n-1) Y^(s_I)/(1 - Y^(2^-(n-1)))")
{
    for (const slong bits : {80L, 112L})
        for (const long n : {1L, 2L, 3L})
            for (const char* g : {"2.5", "16"})
                for (const char* x : {"0.25", "0.015625"}) { // exact, as G is
                    CAPTURE(bits); CAPTURE(n);
                    const WorkingPrecision precision(bits);
                    const Ball load(exactly(x)), G(exactly(g));
                    const auto number = [](const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); };
                    const double root = std::ldexp(1.0, static_cast<int>(1 - n)), Y = 2 / number(G) * std::sqrt(number(load));
                    const double terms = terms_of_area_series(n, load, G, bits);
                    const double s = 1 - std::ldexp(1.0, static_cast<int>(-n)) + terms * root;
                    const double T1 = 2 * std::asin(std::sqrt(number(load))) / std::numbers::pi, c = number(magnitudes(G, n - 1).back());
                    const double tail = T1 * c * std::pow(number(G), static_cast<double>(1 - n)) * std::pow(Y, s) / (1 - std::pow(Y, root));
                    const Ball area = area_series(n, load, G);
                    CHECK(area.radius_bound() == doctest::Approx(tail).epsilon(1e-6).scale(0));
                    if (n == 3) continue;
                    const WorkingPrecision more(2 * bits);
                    CHECK(area.overlaps(area_series(n, Ball(exactly(x)), Ball(exactly(g)))));
                }
}

TEST_CASE("the power series is refused for load <= 0 or >= 1, G <= 2 and scales above 20")
{
    const WorkingPrecision precision(64);
    const auto refused = [](long n, const Ball& load, const Ball& G, const char* why) {
        CHECK_THROWS_WITH_AS(area_series(n, load, G), why, BeyondReach);
    };
    for (const long n : {0L, 1L}) {
        refused(n, Ball(0), Ball(3), "the series needs load > 0 and G > 2");
        refused(n, Ball(exactly("0.5")), Ball(2), "the series needs load > 0 and G > 2");
    }
    CHECK(area_series(1, Ball(exactly("0.5")), Ball(exactly("2.001"))).is_finite());
    refused(1, Ball(1), Ball(10), "the power series needs load < 1 and small n");
    refused(1, Ball(exactly("1.5")), Ball(10), "the power series needs load < 1 and small n");
    const Ball tiny = ScalarTraits<Ball>::power_of_two(-4'000'000);
    CHECK(area_series(20, tiny, Ball(3)).relative_bits() > 40);
    refused(21, tiny, Ball(3), "the power series needs load < 1 and small n");
}

TEST_CASE("A_2 against a nested integral taken elsewhere")
{
    // A_2 at load 1/10, G = sqrt 10, by PARI's intnum of an intnum at 57 digits (tests/bench/nested_area.gp)
    const WorkingPrecision precision(bits_for_digits(50) + 48);
    const Ball a = area(Scheme::force_weighted, 2, {[] { return Ball(exactly("0.1")); }, [] { return sqrt(Ball(10)); }}, wanted());
    Ball peer(exactly("0.0147826773391939139551944598126151115015416602963043804"));
    arb_add_error(peer.get(), Ball(exactly("1e-54")).get());
    CHECK(a.overlaps(peer));
}

TEST_CASE("the exact power series, a route without quadrature or interpolation")
{
    const WorkingPrecision precision(bits_for_digits(30) + 48);
    for (const char* G : {"2.05", "3.1622776601683795", "16"})
        for (const char* load : {"0.5", "0.1", "1e-3", "1e-12"})
            for (long n = 0; n <= 2; ++n) {
                CAPTURE(G); CAPTURE(load); CAPTURE(n);
                const Ball series = area_series(n, Ball(exactly(load)), Ball(exactly(G)));
                CHECK(series.overlaps(area(Scheme::force_weighted, n, at(load, G), wanted())));
                CHECK(series.relative_bits() > 80);
            }
    const Ball third = area_series(3, Ball(exactly("1e-3")), Ball(16));
    CHECK(third.overlaps(area(Scheme::force_weighted, 3, at("1e-3", "16"), wanted())));
    CHECK(third.relative_bits() > 80);
}

TEST_CASE("the same G, the same areas, digit for digit: (D, gamma) = (1.5, 16) and (1.25, 256)")
{
    for (const long n : {1L, 4L, 20L}) {
        const Rational N(n), load = exactly("0.1");
        const auto a = eval("contact.area", {{"n", N}, {"load", load}, {"D", exactly("1.5")}, {"gamma", 16}}, 30);
        const auto b = eval("contact.area", {{"n", N}, {"load", load}, {"D", exactly("1.25")}, {"gamma", 256}}, 30);
        CHECK(a.status == Status::certified);
        CHECK(a.value == b.value);
    }
}

TEST_CASE("areas increase with the load, decrease with the scale, and force is conserved in their slope")
{
    const WorkingPrecision precision(128);
    Ball below_all(0);
    for (const char* load : {"1e-12", "1e-6", "0.001", "0.01", "0.1", "0.3", "0.7", "0.9", "1"}) {
        Ball last(2);
        for (const long n : {0L, 1L, 2L, 5L, 20L}) {
            const Ball a = area(Scheme::force_weighted, n, at(load, "2.25"), wanted());
            CHECK(certainly(less(a, last)));
            last = a;
        }
        const Ball a5 = area(Scheme::force_weighted, 5, at(load, "2.25"), wanted());
        CHECK(certainly(less(below_all, a5)));
        below_all = a5;
    }
    // A_n G^n/load tends to one constant for all loads
    const Ball heavy = area(Scheme::force_weighted, 100, at("1", "2.25"), wanted()),
               light = area(Scheme::force_weighted, 100, at("0.001", "2.25"), wanted());
    const Ball ratio = heavy / light / 1000;
    CHECK(certainly(less(abs(ratio - 1), Ball(exactly("1e-20")))));
}

TEST_CASE("light loads: Archard's law (7.18), with the ratio enclosed")
{
    const WorkingPrecision precision(128);
    for (const long n : {1L, 2L, 5L}) {
        Ball last_gap(1);
        for (const char* G : {"1e2", "1e4", "1e6"}) { // the whole chain is Hertzian only as G grows as well
            const Ball load = Ball(exactly("1e-12")), g(exactly(G));
            const Ball ratio =
                area(Scheme::force_weighted, n, at("1e-12", G), wanted()) / archard::area(n, load, g, archard::K_gamma_product(n));
            const Ball gap = abs(ratio - 1);
            CHECK(certainly(less(gap, last_gap)));
            last_gap = gap;
        }
        CHECK(certainly(less(last_gap, Ball(exactly("1e-10")))));
    }
}

TEST_CASE("the first scale is (6.6), exact where it is rational")
{
    CHECK(eval("contact.area", {{"n", 0}, {"load", exactly("0.25")}, {"G", 3}}, 20).value == "0.33333333333333333333");
    CHECK(eval("contact.area", {{"n", 0}, {"load", 1}, {"G", 3}}, 20).status == Status::exact);
}

TEST_CASE("out of reach is said, not guessed")
{
    const std::pair<const char*, const char*> reasons[] = {
        {"2", "the limit is not reached at that scale, as far as its rate is proven; no estimate"},
        {"1.0000001", "the constant of the limit is certified for G = gamma^(D-1) >= 1.02 only; no estimate"}};
    for (const auto& [G, reason] : reasons) {
        const auto e = eval("contact.area", {{"n", 150}, {"load", exactly("0.5")}, {"G", exactly(G)}}, 10);
        CHECK(e.status == Status::undecided);
        CHECK(e.value == "nan");
        CHECK(e.note.find(reason) != std::string::npos);
    }
    CHECK_THROWS_AS(eval("contact.area", {{"n", -1}, {"load", 1}, {"G", 3}}, 10), DomainError);
    for (const char* load : {"0", "-1", "2"})
        CHECK_THROWS_WITH_AS(area(Scheme::area, 1, at(load, "3"), {10}), "load must be above 0 and at most 1", BeyondReach);
    CHECK_THROWS_WITH_AS(area(Scheme::area, 1, at("1.5", "3"), {10}), "load must be at most 1", BeyondReach);
}

TEST_CASE("the most digits of an area are those that both schemes serve, and no fewer")
{
    const WorkingPrecision precision(128);
    for (const char* load : {"1/2", "1e-12"}) // no lighter than e^-30: ten nats to spare, and no rows far down
        for (const char* G : {"2.0001", "2.001", "2.01", "2.03", "2.1"}) {
            CAPTURE(load);
            CAPTURE(G);
            const long most = most_digits_of_area(Ball(exactly(load)), Ball(exactly(G)));
            const auto nodes = [&](long digits) {
                const double nats = static_cast<double>(bits_for_digits(digits)) * std::numbers::ln2 + 10;
                return std::max(Discretisation::size_for(Scheme::force_weighted, Ball(exactly(G)), nats, 0),
                                Discretisation::size_for(Scheme::area, Ball(exactly(G)), nats, 0));
            };
            CHECK(most > 10);
            CHECK(nodes(most) <= Discretisation::most_nodes);
            CHECK(nodes(most + 1) > Discretisation::most_nodes);
        }
}

TEST_CASE("where few digits do not last over all scales, more are taken")
{
    const WorkingPrecision precision(128);
    const auto scaled = [](long n) { // A_n G^n tends to a constant
        const Arguments a = at("1/2", "100000");
        return area(Scheme::force_weighted, n, a, {10}) * pow(Ball(100000), n);
    };
    const Ball many = scaled(100);
    CHECK(many.relative_bits() > 20);
    CHECK(many.overlaps(scaled(60)));
    CHECK(area_certificate(Scheme::force_weighted, 100, at("1/2", "100000"), {10}).size() > 100);
}

TEST_CASE("threads share an operator and get the same digits")
{
    std::string value[4];
    {
        std::vector<std::jthread> threads;
        for (std::string& v : value)
            threads.emplace_back([&v] { v = eval("contact.area", {{"n", 7}, {"load", exactly("0.3")}, {"G", 5}}, 25).value; });
    }
    for (const std::string& v : value) CHECK(v == value[0]);
}
