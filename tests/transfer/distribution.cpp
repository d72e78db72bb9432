// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/recursion/from_the_edge/far_end.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/recursion/first_steps/scale_one.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

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

/// share p_n^max, as an exact number with many bits: 1 - 1e-20 is no binary64 number.
std::function<Ball()> share_of_highest(long n, const char* share, const char* load, const char* G)
{
    const WorkingPrecision precision(400);
    Ball unit;
    arb_pow_ui(unit.get(), Ball(exactly(G)).get(), static_cast<ulong>(n + 1), precision.bits());
    Ball p = unit * peaks::iterate(n, Ball(exactly(load)), Ball(exactly(G))) * Ball(exactly(share));
    arb_get_mid_arb(p.get(), p.get());
    return [p] { return p; };
}

Evaluation eval(const char* name, std::map<std::string, Rational> in, long digits)
{
    return evaluate(*find_quantity(name), Inputs(std::move(in)), {.digits = digits});
}

bool near(const Ball& a, const char* peer, const char* relative)
{
    const Ball b(exactly(peer));
    return certainly(less(abs(a / b - 1), Ball(exactly(relative))));
}

/// At these scales and shares of the highest pressure: each law gives what the other does.
void compare_laws(std::initializer_list<long> scales, std::initializer_list<const char*> shares)
{
    const WorkingPrecision precision(bits_for_digits(16) + 48);
    for (const auto& [G, load] : {std::pair{"2.05", "1"}, {"3.1622776601683795", "0.1"}, {"100", "1e-12"}})
        for (const long n : scales)
            for (const char* share : shares) {
                CAPTURE(G); CAPTURE(load); CAPTURE(n); CAPTURE(share);
                const auto p_at = share_of_highest(n, share, load, G);
                const Ball q = density(Law::density, n, p_at, at(load, G), wanted()),
                           Q = exceedance(Law::exceedance, n, p_at, at(load, G), wanted());
                CHECK(q.overlaps(density(Law::exceedance, n, p_at, at(load, G), wanted())));
                CHECK(Q.overlaps(exceedance(Law::density, n, p_at, at(load, G), wanted())));
                CHECK(q.relative_bits() > 60);
                CHECK(Q.relative_bits() > 60);
            }
}

} // namespace

TEST_CASE("the two laws overlap, tightly, from small p up to the edge") { compare_laws({1, 3}, {"0.01", "0.99999999999999999999"}); }
TEST_CASE("slow: the two laws overlap, tightly, at every scale and share" * doctest::skip())
{
    compare_laws({1, 2, 3}, {"0.01", "0.9", "0.99999999999999999999"});
}

TEST_CASE("force and length are conserved at every scale, in balls: int p q_n dp = load, int q_n dp = A_n")
{
    const WorkingPrecision precision(bits_for_digits(16) + 48); // the levels of the test above
    for (const auto& [G, load] : {std::pair{"2.05", "1"}, {"3.1622776601683795", "0.1"}, {"100", "1e-12"}})
        for (const long n : {1L, 2L}) {
            CAPTURE(G); CAPTURE(load); CAPTURE(n);
            const Ball A = area(Scheme::force_weighted, n, at(load, G), wanted()), length = mass(n, at(load, G), wanted());
            CHECK(length.overlaps(A));
            CHECK(length.relative_bits() > 50);
            for (const Law law : {Law::density, Law::exceedance}) {
                const Ball p = force(law, n, at(load, G), wanted());
                CHECK(p.contains(exactly(load)));
                CHECK(p.relative_bits() > 50);
            }
        }
}

TEST_CASE("a ball at few digits holds the value known from more")
{
    const auto p_at = share_of_highest(2, "0.4", "0.3", "3");
    for (const Law law : {Law::density, Law::exceedance}) {
        const auto with = [&](slong bits) {
            const WorkingPrecision precision(bits);
            return std::pair{density(law, 2, p_at, at("0.3", "3"), wanted()), exceedance(law, 2, p_at, at("0.3", "3"), wanted())};
        };
        const auto rough = with(100), fine = with(150);
        CHECK(rough.first.contains(fine.first));
        CHECK(rough.second.contains(fine.second));
    }
}

TEST_CASE("all regions in contact have p > 0: Q_n tends to A_n, which another operator gives")
{
    const WorkingPrecision precision(bits_for_digits(20) + 48);
    for (const long n : {1L, 3L}) {
        const auto p_at = share_of_highest(n, "1e-60", "0.3", "2.5"); // A_n - Q_n ~ p^2; far enough that both laws leave a far end out
        const Ball A = area(Scheme::force_weighted, n, at("0.3", "2.5"), wanted());
        for (const Law law : {Law::density, Law::exceedance}) {
            const Ball Q = exceedance(law, n, p_at, at("0.3", "2.5"), wanted());
            CHECK(certainly(less(abs(Q / A - 1), Ball(exactly("1e-24")))));
        }
    }
}

TEST_CASE("q_n goes with p, also where the far end is left out")
{
    const WorkingPrecision precision(bits_for_digits(30) + 48);
    const auto slope = [](const char* share) {
        const auto p_at = share_of_highest(2, share, "0.9", "3");
        return density(Law::density, 2, p_at, at("0.9", "3"), wanted()) / p_at();
    };
    const Ball reference = slope("1e-20");
    for (const char* share : {"1e-27", "1e-29", "1e-40", "1e-300"})
        CHECK(certainly(less(abs(slope(share) / reference - 1), Ball(exactly("1e-33")))));
}

TEST_CASE("small p by the exceedance law: its own limit of q_n/p, which the density law and another program give")
{
    const WorkingPrecision precision(bits_for_digits(30) + 48);
    const auto slope = [](Law law, const char* share) {
        const auto p_at = share_of_highest(2, share, "0.1", "3");
        return density(law, 2, p_at, at("0.1", "3"), wanted()) / p_at();
    };
    const Ball small = slope(Law::exceedance, "1e-300");
    CHECK(small.relative_bits() > 104);
    CHECK(small.overlaps(slope(Law::density, "1e-300")));
    CHECK(certainly(less(abs(slope(Law::exceedance, "1e-200") / small - 1), Ball(exactly("1e-31")))));
    // gp: (1/(2 pi G^4)) <<y^(-1/2) (1-y)^(-3/2)>>, y the load ratio two waves on, each an intnum over its angle; 60 digits
    CHECK(near(small, "0.000346796744484476749706120767893088557403448", "1e-31"));
    const auto refused = [] { return density(Law::exceedance, 1, [] { return Ball(exactly("1e-300")); }, at("0.1", "3"), wanted()); };
    CHECK_THROWS_AS(refused(), BeyondReach); // scale 1: the catalogue knows a better route
}

TEST_CASE("small p by the exceedance law: both sides of where its two forms meet")
{
    const WorkingPrecision precision(bits_for_digits(16) + 48);
    const Arguments a = at("0.1", "3.1622776601683795"); // the density's levels are those of the first test
    std::string form[2];
    for (const int side : {0, 1}) {
        const auto p_at = share_of_highest(2, side == 0 ? "1e-8" : "1e-9", "0.1", "3.1622776601683795");
        const Ball q = density(Law::exceedance, 2, p_at, a, wanted());
        CHECK(q.relative_bits() > 57);
        CHECK(q.overlaps(density(Law::density, 2, p_at, a, wanted())));
        form[side] = distribution_certificate(Law::exceedance, 2, p_at, a, wanted());
    }
    CHECK(form[0].find("by parts") == std::string::npos);
    CHECK(form[1].find("by parts over E_2") != std::string::npos);
}

TEST_CASE("n = 1 against nested quadrature, n = 2 against another program's")
{
    const WorkingPrecision precision(bits_for_digits(20) + 48);
    // acb_calc_integrate of (6.1) over p_0, both ends of (2.19) by their distance: 25 digits
    const auto p_1 = [] { return Ball(exactly("1.4142135623730949234")); };
    // gp -q tests/bench/nested_density.gp: load 1/10, G = sqrt 10, p = 5
    const auto p_2 = [] { return Ball(5); };
    const Arguments b{[] { return Ball(exactly("0.1")); }, [] { return sqrt(Ball(10)); }};
    for (const Law law : {Law::density, Law::exceedance}) {
        const Arguments a = at("0.1", "3.1622776601683795");
        CHECK(near(density(law, 1, p_1, a, wanted()), "0.01754937144660158405091275", "1e-21"));
        CHECK(near(exceedance(law, 1, p_1, a, wanted()), "0.04010037050850863148585203", "1e-21"));
        CHECK(near(density(law, 2, p_2, b, wanted()), "0.0014695860132234507792429895970742645311", "1e-21"));
        CHECK(near(exceedance(law, 2, p_2, b, wanted()), "0.011215306086010659841210644188124502203", "1e-21"));
    }
}

TEST_CASE("through the catalogue: ends of the support, and what is out of reach")
{
    const Rational G(3), load = exactly("0.4");
    CHECK(eval("contact.exceedance", {{"n", 1}, {"p", 0}, {"load", load}, {"G", G}}, 30).value
          == eval("contact.area", {{"n", 1}, {"load", load}, {"G", G}}, 30).value);
    CHECK(eval("contact.exceedance", {{"n", 1}, {"p", 4}, {"load", load}, {"G", G}}, 30).value == "0");
    CHECK(eval("contact.exceedance", {{"n", 7}, {"p", 0}, {"load", load}, {"G", G}}, 30).status == Status::certified);
    CHECK(eval("contact.density", {{"n", 1}, {"p", 0}, {"load", load}, {"G", G}}, 30).status == Status::exact);
    CHECK(eval("contact.density", {{"n", 1}, {"p", exactly("3.5")}, {"load", load}, {"G", G}}, 30).status == Status::certified);
    CHECK(eval("contact.density", {{"n", 2}, {"p", 1}, {"load", load}, {"G", G}}, 15).status == Status::certified);
    const auto tiny =
        eval("contact.density", {{"n", 1}, {"p", exactly("1e-300")}, {"load", exactly("0.1")}, {"G", G}}, 30); // gp, as above: one wave
    CHECK(tiny.value == "1.23308843096240858505896966105e-302");
    CHECK(tiny.status == Status::certified);
    CHECK(tiny.routes == std::vector<std::string>{"scale-one-by-ratio", "scale-one-by-angle"});
    CHECK(eval("contact.density", {{"n", 1}, {"p", exactly("1e-150")}, {"load", 1}, {"G", G}}, 10).status ==
          Status::certified); // q_1 ~ p log p
    CHECK(eval("contact.density", {{"n", 21}, {"p", 1}, {"load", load}, {"G", G}}, 15).status == Status::undecided);
    // exactly at the edge: load = 1, G = 8, p_1^max = 8^2/8 and p_2^max = 8^3 (2/8) sqrt(1/8), irrational
    CHECK(eval("contact.exceedance", {{"n", 1}, {"p", 8}, {"load", 1}, {"G", 8}}, 15).status == Status::exact);
    CHECK(eval("contact.density", {{"n", 1}, {"p", 8}, {"load", 1}, {"G", 8}}, 15).status == Status::undecided); // it jumps there
    // (9.3) is the derivative of (9.2): at n = 1, pi G sin(2 pi a) q_0(G sin^2(pi a)) with q_0 of section 2
    const auto s = eval("segments.density", {{"n", 1}, {"a", exactly("1/6")}, {"load", load}, {"G", G}}, 30);
    const auto q = eval("westergaard.density", {{"p", exactly("0.75")}, {"load", load}}, 40);
    const WorkingPrecision precision(128);
    const Ball expected = pi<Ball>() * Ball(3) * sqrt(Ball(3)) / 2 * Ball(*parse_rational(q.value));
    CHECK(certainly(less(abs(Ball(*parse_rational(s.value)) - expected), Ball(exactly("1e-28")))));
}

TEST_CASE(
    "many digits far below the edge, where arcsin z branches at the zeros of E(D) inside ellipses: all laws hold the integral of scale 1")
{
    const ScaleOne one{share_of_highest(1, "1e-19", "1", "2.5"), exactly("1"), [] { return Ball(exactly("2.5")); }, std::nullopt,
                       exactly("2.5")};
    const WorkingPrecision precision(bits_for_digits(150) + 48);
    const Ball known = [&] {
        const WorkingPrecision twice(2 * WorkingPrecision::bits());
        return scale_one_exceedance(Variable::angle, one);
    }();
    for (const Law law : {Law::density, Law::exceedance}) {
        const Ball Q = exceedance(law, 1, one.p, at("1", "2.5"), {150});
        CAPTURE(static_cast<int>(law));
        CHECK(Q.overlaps(known));
        CHECK(Q.relative_bits() > bits_for_digits(150));
    }
    // 270 digits are within reach, and what is not says so
    CHECK(eval("contact.exceedance", {{"n", 1}, {"G", exactly("5/2")}, {"load", 1}, {"p", exactly("1e-17")}}, 150).status ==
          Status::certified);
}

TEST_CASE("neighbouring pressures share levels: kept ones serve whatever needs no more accuracy")
{
    const WorkingPrecision precision(bits_for_digits(16) + 48);
    const auto value = [](const char* share, long n, Accuracy a) {
        return density(Law::exceedance, n, share_of_highest(n, share, "0.7", "3.5"), at("0.7", "3.5"), a);
    };
    const long before = levels_made();
    const Ball first = value("1e-11", 1, {16}); // d = 25: the slope of an exceedance loses 2 d nats
    CHECK(levels_made() == before + 1);
    for (const char* share : {"1e-9", "1e-7", "1e-4", "0.1", "0.9"}) {
        CAPTURE(share);
        CHECK(value(share, 1, {16}).overlaps(density(Law::density, 1, share_of_highest(1, share, "0.7", "3.5"), at("0.7", "3.5"), {16})));
        CHECK(value(share, 1, {12}).relative_bits() > 44);
    }
    CHECK(levels_made() == before + 2); // and one of the other law
    CHECK(value("0.9", 1, {40}).relative_bits() > 130); // more digits need more
    CHECK(levels_made() == before + 3);
    CHECK(value("1e-11", 1, {16}).overlaps(first));
    // p small enough for its own form at scale 2 with the accuracy it asks for, but not with more
    const Ball small = value("1e-12", 2, {16});
    CHECK(value("0.5", 2, {30}).relative_bits() > 96);
    CHECK(value("1e-12", 2, {16}).overlaps(small));
    CHECK(value("1e-12", 2, {16}).relative_bits() > 50);
}

TEST_CASE("levels a little more accurate than a small p asks for do not serve it where it is not small for them, but serve other p")
{
    const WorkingPrecision precision(bits_for_digits(16) + 48);
    const Arguments a = at("0.2", "8");
    const auto accuracy_of_levels = [](long digits) {
        return 4 * std::ceil(std::max(30.0, static_cast<double>(bits_for_digits(digits) - 4) * std::numbers::ln2) / 4);
    };
    const auto asked = [&](double d) { return from_the_edge::accuracy_for_small(accuracy_of_levels(16), 2, d, a.G(), a.load()); };
    double d = 1;
    while (asked(d) == 0) d *= 1.0001;
    const double more = asked(d) + 4; // too much for the form for small p: it is cut off farther out
    REQUIRE_FALSE(from_the_edge::small_for(more, 2, d, a.G(), a.load()));
    long digits = 3;
    while (accuracy_of_levels(digits) + 16 < more) ++digits;
    REQUIRE(accuracy_of_levels(digits) + 16 == more);
    REQUIRE(accuracy_of_levels(3) < accuracy_of_levels(digits));
    const std::string share = fmt::format("{:.17g}", std::exp(-d));
    const auto ordinary = share_of_highest(2, "0.5", "0.2", "8"), small = share_of_highest(2, share.c_str(), "0.2", "8");
    const long before = levels_made();
    CHECK(exceedance(Law::exceedance, 2, ordinary, a, {digits}).relative_bits() > 33);
    CHECK(levels_made() == before + 1);
    CHECK(exceedance(Law::exceedance, 2, ordinary, a, {3}).relative_bits() > 33);
    CHECK(levels_made() == before + 1);
    const Ball q = density(Law::exceedance, 2, small, a, {16});
    CHECK(levels_made() == before + 2);
    CHECK(q.relative_bits() > 33);
}

TEST_CASE("more digits of a distribution than the most that are offered are refused at once")
{
    const WorkingPrecision precision(128);
    for (const bool of_density : {false, true})
        for (const char* share : {"0.5", "1e-3", "1e-6", "1e-9", "1e-12", "1e-15", "1e-18", "1e-22", "1e-26", "1e-30", "1e-34", "1e-40"}) {
            const auto p_at = share_of_highest(2, share, "0.6", "3.3");
            const long most = most_digits_of_distribution(2, p_at, at("0.6", "3.3"), of_density);
            CAPTURE(share);
            CHECK(most > 100);
            CHECK(most < 400);
            const auto more = [&] { return (of_density ? density : exceedance)(Law::exceedance, 2, p_at, at("0.6", "3.3"), {most + 1}); };
            CHECK_THROWS_AS(more(), BeyondReach);
        }
}
