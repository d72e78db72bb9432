// SPDX-License-Identifier: MIT
/// The distribution at scale 1 for any G and load: two variables of integration, the certified chains of partial contact, the
/// estimates, and the local forms at singular points.
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/transfer/full_contact.hpp"
#include "touchstone/recursion/first_steps/scale_one.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::transfer;

/// What the precision of these balls is meant for.
static Accuracy wanted() { return {accuracy_of(WorkingPrecision::bits()).digits + 1}; }

namespace {

Rational exactly(const char* text) { return *parse_rational(text); }

ScaleOne scale_one(const Rational& p, const Rational& load, const Rational& G)
{
    return {[p] { return Ball(p); }, load, [G] { return Ball(G); }, p, G};
}
ScaleOne scale_one(const char* p, const char* load, const char* G) { return scale_one(exactly(p), exactly(load), exactly(G)); }

/// 10^-digits
Rational small(unsigned long digits)
{
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, digits);
    return Rational(1, power);
}

/// Radius over midpoint below 10^-digits.
bool sharp(const Ball& b, long digits) { return arb_rel_accuracy_bits(b.get()) > bits_for_digits(digits); }

double apart(const Ball& a, const Ball& b)
{
    const Ball r = abs(a / b - 1);
    return arf_get_d(arb_midref(r.get()), ARF_RND_UP);
}

/// At every so many of the pressures of each regime, from the first or another one on.
void compare_variables(std::size_t first, std::size_t step)
{
    const WorkingPrecision precision(160);
    struct Case {
        const char *load, *G;
        std::vector<const char*> p;
    };
    for (const auto& [load, G, ps] : {
             Case{"3", "1.5", {"0.5000001", "1", "2.5000001", "4.1", "5.4999999"}},
             {"1", "2", {"1e-300", "1e-9", "0.9", "3.999999999"}},
             {"0.3", "1.5", {"1e-300", "0.2", "0.9", "2.1", "2.25"}},
             {"0.999999", "1.5", {"1e-9", "0.5", "3.4"}},
             {"1.000001", "1.9999999", {"0.000001", "0.9", "2.000001", "4"}},
             {"1.5", "2.5", {"0.01", "2.5", "4.9"}}, // (load + 1)/G = 1
             {"0.36", "1.2", {"0.1", "1.2", "2.3"}}, // 2 sqrt(load)/G = 1
             {"100", "1.05", {"98", "99.7", "101.9"}},
             {"0.001", "1.05", {"1e-6", "0.3"}}})
        for (std::size_t k = first; k < ps.size(); k += step) {
            const char* p = ps[k];
            CAPTURE(load); CAPTURE(G); CAPTURE(p);
            const ScaleOne q = scale_one(p, load, G);
            const Ball Q[2] = {scale_one_exceedance(Variable::ratio, q), scale_one_exceedance(Variable::angle, q)};
            const Ball d[2] = {scale_one_density(Variable::ratio, q), scale_one_density(Variable::angle, q)};
            CHECK(Q[0].overlaps(Q[1]));
            CHECK(d[0].overlaps(d[1]));
            for (const int i : {0, 1}) {
                CHECK(sharp(Q[i], 30));
                CHECK(sharp(d[i], 30));
            }
        }
}

} // namespace

TEST_CASE("both variables give the same, to 30 digits, in every regime") { compare_variables(1, 2); }
TEST_CASE("slow: both variables give the same, to 30 digits, next to singular points and far from them" * doctest::skip())
{
    compare_variables(0, 1);
}

TEST_CASE("the certified chains of partial contact hold the same numbers, and the estimates come near")
{
    const WorkingPrecision precision(128);
    for (const auto& [load, G, p] : {std::tuple{"0.3", "3.16", "1.8"}, {"1", "2.5", "0.4"}, {"0.001", "4", "0.1"}}) {
        CAPTURE(load); CAPTURE(G); CAPTURE(p);
        const Ball P(exactly(p)), x(exactly(load)), g(exactly(G));
        const Arguments in{[&] { return x; }, [&] { return g; }};
        for (const Variable v : {Variable::ratio, Variable::angle}) {
            CHECK(scale_one_exceedance(v, scale_one(p, load, G)).overlaps(exceedance(Law::exceedance, 1, [&] { return P; }, in, wanted())));
            CHECK(scale_one_density(v, scale_one(p, load, G)).overlaps(density(Law::density, 1, [&] { return P; }, in, wanted())));
        }
    }
    for (const auto& [load, G, p] :
         {std::tuple{"1.5", "2.5", "2.1"}, {"1", "2", "0.9"}, {"3", "1.5", "2.4999999"}, {"0.3", "1.5", "0.9"}}) {
        CAPTURE(load); CAPTURE(G); CAPTURE(p);
        const ScaleOne q = scale_one(p, load, G);
        for (const Grid grid : {Grid::blind, Grid::tracked}) {
            CHECK(apart(estimated_exceedance(grid, 1, Ball(exactly(p)), Ball(exactly(load)), Ball(exactly(G))).value,
                        scale_one_exceedance(Variable::ratio, q)) < 3e-18);
            CHECK(apart(estimated_density(grid, 1, Ball(exactly(p)), Ball(exactly(load)), Ball(exactly(G))).value,
                        scale_one_density(Variable::ratio, q)) < 1e-16);
        }
    }
}

TEST_CASE("all of a wave above the pressure, or none of it")
{
    const WorkingPrecision precision(128);
    for (const Variable v : {Variable::ratio, Variable::angle}) {
        CHECK(apart(scale_one_exceedance(v, scale_one("0.4", "3", "1.5")), Ball(1)) < 1e-30); // p_1^min = 0.5
        CHECK(certainly(less(abs(scale_one_exceedance(v, scale_one("5.6", "3", "1.5"))), Ball(small(30))))); // p_1^max = 5.5
    }
}

namespace {

/// By both variables everywhere, or by one of them at each side of each point, and by each at each side and each point.
void check_singular_points(bool both)
{
    const WorkingPrecision precision(200);
    const Ball G(exactly("1.5")), slope = 1 / (2 * pi<Ball>() * pi<Ball>() * sqrt(G));
    Ball thirty_decades;
    arb_const_log10(thirty_decades.get(), 200);
    thirty_decades = 30 * thirty_decades;
    for (const char* at : {"2.5", "3.5"}) // load +- (G - 1)
        for (const int side : {-1, 1})
            for (const Variable v : {Variable::ratio, Variable::angle}) {
                if (!both && (v == Variable::ratio) == (side == (at[0] == '2' ? 1 : -1))) continue;
                CAPTURE(at); CAPTURE(side);
                const auto q = [&](unsigned long digits) {
                    return scale_one_density(v, scale_one(exactly(at) + side * small(digits), 3, exactly("1.5")));
                };
                const Ball rise = q(60) - q(30);
                CHECK(sharp(rise, 30));
                CHECK(apart(rise, slope * thirty_decades) < 1e-27); // the rest is distance times log(distance)
            }
}

} // namespace

TEST_CASE("at a singular point the density is -log(distance)/(2 pi^2 sqrt G), from both sides, as near as one likes")
{
    check_singular_points(false);
}
TEST_CASE("slow: so it is by both variables at each side of each point" * doctest::skip()) { check_singular_points(true); }

TEST_CASE("the density is minus the slope of the exceedance")
{
    const WorkingPrecision precision(256);
    const Rational h = small(20);
    for (const auto& [p, load, G] : {std::tuple{"2.1", "3", "1.5"}, {"0.4", "0.7", "1.3"}, {"0.2", "1", "1.2"}}) {
        CAPTURE(p); CAPTURE(load); CAPTURE(G);
        const auto Q = [&](const Rational& at) { return scale_one_exceedance(Variable::angle, scale_one(at, exactly(load), exactly(G))); };
        const Ball slope = (Q(exactly(p) - h) - Q(exactly(p) + h)) / (2 * Ball(h));
        CHECK(apart(slope, scale_one_density(Variable::ratio, scale_one(p, load, G))) < 1e-36);
    }
}

TEST_CASE("scale 1 through the catalogue: certified, or one line that says why not")
{
    const auto eval = [](const char* name, std::map<std::string, Rational> in) {
        return evaluate(*find_quantity(name), Inputs(std::move(in)), {.digits = 25});
    };
    const std::map<std::string, Rational> figure_3{{"n", 1}, {"load", 1}, {"D", exactly("1.05")}, {"gamma", 5}, {"p", exactly("0.7")}};
    for (const char* name : {"contact.exceedance", "contact.density"}) CHECK(eval(name, figure_3).status == Status::certified);
    CHECK(eval("segments.density", {{"n", 2}, {"load", 1}, {"D", exactly("1.05")}, {"gamma", 5}, {"a", exactly("0.2")}}).status ==
          Status::certified);
    // where it is infinite or jumps no grid is asked instead
    for (const auto& [p, why] : {std::pair{"2.5", "infinite"}, {"3.5", "infinite"}, {"0.5", "jumps"}, {"5.5", "jumps"}}) {
        CAPTURE(p);
        const auto e = eval("contact.density", {{"n", 1}, {"load", 3}, {"G", exactly("1.5")}, {"p", exactly(p)}});
        CHECK(e.status == Status::undecided);
        CHECK(e.digits == 0);
        CHECK(e.note.find(why) != std::string::npos);
    }
    const auto near = eval("contact.density", {{"n", 1}, {"load", 3}, {"G", exactly("1.5")}, {"p", exactly("2.5") + small(30)}});
    CHECK(near.status == Status::certified);
}

namespace {

Ball area(Variable v, const char* load, const char* G) { return scale_one_exceedance(v, scale_one("0", load, G)); }

} // namespace

namespace {

/// To so many digits, wherever singular points meet or nearly do.
void check_areas(slong bits, long digits)
{
    const WorkingPrecision precision(bits);
    for (const auto& [load, G] : {std::pair{"0.35", "1.0838"},
                                  {"1", "2"},
                                  {"1", "1.5"},
                                  {"1", "2.5"},
                                  {"0.5625", "1.5"},
                                  {"0.5625000000000000000000000000001", "1.5"},
                                  {"0.999999999999999999999999999999", "1.5"},
                                  {"1.000000000000000000000000000001", "2"},
                                  {"0.5", "1.5"},
                                  {"0.5000000000000000000001", "1.5"},
                                  {"2.4999999999999999999999999", "1.5"},
                                  {"3", "3.5"},
                                  {"1e-300", "2"},
                                  {"0.3", "1.000000000000000000000001"},
                                  {"1000.5", "1000"}}) {
        CAPTURE(load); CAPTURE(G);
        const Ball A[2] = {area(Variable::ratio, load, G), area(Variable::angle, load, G)};
        CHECK(A[0].overlaps(A[1]));
        for (const Ball& a : A) CHECK(sharp(a, digits));
    }
}

} // namespace

TEST_CASE("slow: the area at scale 1: both variables, to 40 digits" * doctest::skip()) { check_areas(200, 40); }
TEST_CASE("the area at scale 1: both variables, to 15 digits, also where singular points meet or nearly do")
{
    check_areas(110, 15);
    const WorkingPrecision precision(200);
    for (const char* load : {"1", "4"}) { // irrational G: what is exact without it is still told
        const auto root_5 = [] { return sqrt(Ball(5)); };
        const ScaleOne q{[] { return Ball(0); }, exactly(load), root_5, Rational(0), std::nullopt};
        CHECK(scale_one_exceedance(Variable::ratio, q).overlaps(scale_one_exceedance(Variable::angle, q)));
    }
    for (const auto& [load, G] : {std::pair{"0.35", "1.0838"}, {"3", "2.5"}}) // Q_1 goes to A_1, with p log p at worst
        CHECK(apart(scale_one_exceedance(Variable::ratio, scale_one("1e-40", load, G)), area(Variable::angle, load, G)) < 1e-28);
}

TEST_CASE("the area at scale 1 is what the operator discretised gives, and for small loads what Archard's recursion gives")
{
    const WorkingPrecision precision(128);
    for (const auto& [load, G] : {std::pair{"0.3", "3.16"}, {"1", "2.5"}, {"0.001", "4"}}) {
        CAPTURE(load); CAPTURE(G);
        const Ball x(exactly(load)), g(exactly(G));
        CHECK(area(Variable::angle, load, G)
                  .overlaps(transfer::area(Scheme::force_weighted, 1, {[&] { return x; }, [&] { return g; }}, wanted())));
    }
    const auto archard =
        evaluate(*find_quantity("archard.area"), Inputs({{"n", 1}, {"load", exactly("1e-100")}, {"G", exactly("1.5")}}), {.digits = 30});
    CHECK(apart(area(Variable::ratio, "1e-100", "1.5"), archard.ball) < 1e-28);
}
