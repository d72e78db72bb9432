// SPDX-License-Identifier: MIT
/// The recursion where full contact occurs: two discretisations against each other, against what is exact, against the
/// certified routes where both apply, and against nested integrals done directly.
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/transfer/full_contact.hpp"
#include "touchstone/transfer/graded.hpp"
#include "touchstone/transfer/piecewise.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <doctest/doctest.h>

#include <algorithm>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

/// What the precision of these balls is meant for.
Accuracy wanted() { return {accuracy_of(WorkingPrecision::bits()).digits + 1}; }

using Real = Extended;

Rational exactly(const char* text) { return *parse_rational(text); }
Ball ball(const char* text) { return Ball(exactly(text)); }

Evaluation eval(const char* name, std::map<std::string, Rational> in, long digits)
{
    return evaluate(*find_quantity(name), Inputs(std::move(in)), {.digits = digits});
}

/// |a/b - 1|
double apart(const Ball& a, const Ball& b)
{
    const WorkingPrecision precision(256);
    const Ball r = abs(a / b - 1);
    return arf_get_d(arb_midref(r.get()), ARF_RND_UP);
}

/// B_1 by one integral and B_2 by two nested ones, each split where (6.6) is not smooth: y = 1.
class Nested {
public:
    explicit Nested(Real G) : G_(G) {}
    Real area(int n, Real x)
    {
        if (n == 0) return x >= 1 ? Real(1) : 2 / pi_ * std::asin(std::sqrt(x));
        // y = (x + cos t)/G, or sqrt(R^2 - (1-x)^2)/G with R = x + cos t, 0 <= t <= acos(1 - 2x); where y = 1 the integral is cut
        const Real last = x >= 1 ? pi_ : std::acos(1 - 2 * x);
        std::vector<Real> cuts{0, last};
        std::vector<Real> singular{Real(1)};
        if (n == 2) { // B_1: the images of 1
            singular.push_back(G_ + 1);
            singular.push_back(G_ >= 2 ? G_ - 1 : G_ * G_ / 4);
        }
        for (const Real s : singular) {
            const Real c = x >= 1 ? G_ * s - x : std::sqrt((1 - x) * (1 - x) + G_ * G_ * s * s) - x;
            if (c > -1 && c < 1 && std::acos(c) < last) cuts.push_back(std::acos(c));
        }
        std::sort(cuts.begin(), cuts.end());
        Real sum = 0;
        for (std::size_t i = 1; i < cuts.size(); ++i) {
            const Real a = cuts[i - 1], b = cuts[i], half = (b - a) / 2;
            if (half < 1e-9L) continue;
            sum += half * rule_.integrate([&](Real, Real to_end) { // on (-1, 1), < 0: from the left
                const Real t = to_end < 0 ? a - half * to_end : b - half * to_end;
                if (x >= 1) return area(n - 1, std::max<Real>(x + std::cos(t), 0) / G_);
                // R^2 - (1-x)^2 = (cos t - cos last)(R + 1 - x)
                const Real above = 2 * std::sin((last - t) / 2) * std::sin((last + t) / 2);
                return area(n - 1, std::sqrt(std::max<Real>(above * (1 + std::cos(t)), 0)) / G_);
            }, Real(-1), Real(1), Real(1e-16L));
        }
        return sum / pi_;
    }

private:
    Real G_;
    const Real pi_ = 4 * std::atan(Real(1));
    boost::math::quadrature::tanh_sinh<Real> rule_{15, Real(1e-17L)};
};

} // namespace

TEST_CASE("one wave keeps force and length: T[id] = id/G, T[1] = 1 in full contact, on both grids")
{
    const WorkingPrecision precision(256);
    for (const char* text : {"1.0838", "2", "3.5"}) {
        const Ball G = ball(text), reach(13);
        const auto g = extended_pair(G);
        const auto identity = [](const Pair<Real>& x) { return x.high; };
        const auto one = [](const Pair<Real>&) { return Real(1); };
        const Piecewise<Real> blind({}, Real(13), identity), blind_one({}, Real(13), one);
        const GradedGrid<Real> grid({}, area_points(G, {reach, GradedGrid<Real>::generations({}), 1e-18}), reach);
        const auto tracked = grid.sample(identity), tracked_one = grid.sample(one);
        const GradedGrid<Real> backwards({}, exceedance_points(ball("0.3"), G, {reach, 4, 1e-18}), reach);
        const auto backwards_one = backwards.sample(one);
        // at ratios of all sizes, and where an end of the wave is a singular point or an end of an interval to all digits
        std::vector<Real> ratios{
            1e-12L, 1e-3L, 0.3L, 0.999L, 1, 1 + 1e-15L, 1 + 1e-9L, 2.5L, g.high + 1, g.high - 1, g.high * (g.high + 1) + 1};
        for (const Real x : ratios) {
            CAPTURE(text); CAPTURE(static_cast<double>(x));
            const auto w = wave_from(Pair<Real>{x, 0}, g);
            // (the blind grid has one interval for id, with an error that is small against 1 only)
            CHECK(std::fabs(static_cast<double>(blind.after(w) * g.high - x)) < 2e-18 * static_cast<double>(std::max(x, Real(1))));
            CHECK(std::fabs(static_cast<double>(grid.after(tracked, w) * g.high / x - 1)) < 2e-18);
            if (x < 1) continue;
            CHECK(std::fabs(static_cast<double>(blind_one.after(w) - 1)) < 2e-18);
            CHECK(std::fabs(static_cast<double>(grid.after(tracked_one, w) - 1)) < 2e-18);
        }
        // backwards, the ratio that is needed has probability 1 at any pressure
        for (const Real P : {1e-9L, 0.01L, 0.5L, 1.0L, 1.9999999L, 2.0L, 2.0001L, 7.0L}) {
            CAPTURE(static_cast<double>(P));
            const auto w = wave_to(Pair<Real>{P, 0}, false);
            CHECK(std::fabs(static_cast<double>(blind_one.after(w) - 1)) < 1e-17);
            CHECK(std::fabs(static_cast<double>(backwards.after(backwards_one, w) - 1)) < 1e-17);
        }
    }
}

void check_grids(const char* G, const char* load, long n)
{
    CAPTURE(G); CAPTURE(load); CAPTURE(n);
    CHECK(apart(estimated_area(Grid::blind, n, ball(load), ball(G)).value, estimated_area(Grid::tracked, n, ball(load), ball(G)).value) <
          3e-18);
}

struct HardPlace {
    const char *G, *load;
};
constexpr HardPlace hard_places[] = {{"2", "1"},
                                     {"2", "0.1"},
                                     {"2", "5"},
                                     {"1.999999999999", "0.7"},
                                     {"2.000000000001", "3"},
                                     {"1.5", "0.999999999"},
                                     {"1.5", "1.000000001"},
                                     {"1.5", "0.5"}, // (load + 1)/G = 1
                                     {"1.5", "2.5"}, // (load - 1)/G = 1
                                     {"4", "10"},
                                     {"16", "100"}};

void check_continuous_at_2(long n)
{
    CHECK(apart(estimated_area(Grid::blind, n, ball("0.7"), ball("1.999999999999")).value,
                estimated_area(Grid::blind, n, ball("0.7"), ball("2.000000000001")).value) < 1e-11);
}

TEST_CASE("slow: both grids at hard places, two scales each" * doctest::skip())
{
    for (const auto& [G, load] : hard_places)
        for (const long n : {1L, 2L}) check_grids(G, load, n);
    check_continuous_at_2(2);
}

TEST_CASE("both grids, at hard places: G near and at 2, loads near 1, singular points at the end of the support")
{
    for (const auto& [G, load] : hard_places) check_grids(G, load, 1); // both scales of each are slow
    check_grids(hard_places[6].G, hard_places[6].load, 2);
    check_continuous_at_2(1);
}

namespace {

void check_against_operator(const char* load, std::initializer_list<long> scales)
{
    const WorkingPrecision precision(128);
    const char* G = "3.1622776601683795";
    for (const long n : scales) {
        CAPTURE(load); CAPTURE(n);
        const Ball certified = area(Scheme::force_weighted, n, {[load] { return ball(load); }, [G] { return ball(G); }}, wanted());
        for (const Grid grid : {Grid::blind, Grid::tracked})
            CHECK(apart(estimated_area(grid, n, ball(load), ball(G)).value, certified) < 3e-18);
    }
}

} // namespace

TEST_CASE("areas against the certified operator of partial contact, where both apply")
{
    for (const char* load : {"1", "0.001"}) check_against_operator(load, {1});
    check_against_operator("0.3", {3});
}
TEST_CASE("slow: areas of four scales against the certified operator of partial contact" * doctest::skip())
{
    for (const char* load : {"1", "0.3", "0.001"}) check_against_operator(load, {1, 4});
}

TEST_CASE("areas against nested integrals, split by hand")
{
    for (const char* G : {"1.5", "2.5"})
        for (const char* load : {"0.3", "1.2", "3.1"}) {
            CAPTURE(G); CAPTURE(load);
            const Real x = extended_pair(ball(load)).high;
            Nested nested(extended_pair(ball(G)).high);
            CHECK(apart(exact_ball(nested.area(1, x)), estimated_area(Grid::blind, 1, ball(load), ball(G)).value) < 1e-15);
            CHECK(apart(exact_ball(nested.area(2, x)), estimated_area(Grid::blind, 2, ball(load), ball(G)).value) < 1e-14);
        }
}

TEST_CASE("A_n = 1 exactly as long as min p_n > 0, and the first scale that loses contact")
{
    // load >= 1 + G + ... + G^n: at G = 3, 1, 4, 13, 40
    for (const long n : {0L, 1L, 2L}) {
        const auto e = eval("contact.area", {{"n", Rational(n)}, {"load", 15}, {"G", 3}}, 15);
        CAPTURE(n);
        CHECK(e.status == Status::exact);
        CHECK(e.value == "1");
    }
    CHECK_THROWS_AS(find_quantity("contact.area")->exact(Inputs({{"n", 3}, {"load", 15}, {"G", 3}})), NotExact);
    // a tie is full contact still: the points without pressure have no length
    CHECK(eval("contact.area", {{"n", 1}, {"load", exactly("2.5")}, {"G", exactly("1.5")}}, 15).value == "1");
    CHECK(eval("contact.area", {{"n", 1}, {"load", exactly("2.4999")}, {"G", exactly("1.5")}}, 4).status == Status::certified);
    CHECK(eval("contact.area", {{"n", 6}, {"load", 10}, {"D", exactly("1.05")}, {"gamma", 5}}, 15).status == Status::exact);
    CHECK(eval("segments.count", {{"n", 3}, {"load", 10}, {"D", exactly("1.05")}, {"gamma", 5}}, 15).value == "125");
    CHECK(eval("contact.exceedance", {{"n", 1}, {"p", exactly("0.4")}, {"load", 3}, {"G", exactly("1.5")}}, 15).value == "1");
    CHECK(eval("contact.density", {{"n", 1}, {"p", exactly("0.4")}, {"load", 3}, {"G", exactly("1.5")}}, 15).value == "0");
    // the ends of the support, p_n^max = G^(n+1) x_n by (5.6), through both regimes, and p_n^min
    for (const auto& [n, p, load, G] : {std::tuple{2L, "7.75", "3", "1.5"}, {2L, "5.76", "0.64", "1.6"}, {3L, "6.868", "1.5", "1.2"}}) {
        CAPTURE(p);
        for (const char* name : {"contact.exceedance", "contact.density"}) {
            const auto e = eval(name, {{"n", n}, {"p", exactly(p)}, {"load", exactly(load)}, {"G", exactly(G)}}, 15);
            CHECK(e.status == Status::exact);
            CHECK(e.value == "0");
        }
    }
    CHECK(eval("contact.density", {{"n", 2}, {"p", exactly("0.25")}, {"load", 5}, {"G", exactly("1.5")}}, 15).value == "0");
    CHECK(eval("contact.exceedance", {{"n", 2}, {"p", exactly("0.25")}, {"load", 5}, {"G", exactly("1.5")}}, 15).value == "1");
    for (const auto& [p, load] :
         {std::pair{"4", "3"}, {"2", "3"}, {"2", "1"}, {"0", "1"}, {"1", "0.25"}}) { // infinite at the ends of one wave
        CAPTURE(p);
        const auto e = eval("contact.density", {{"n", 0}, {"p", exactly(p)}, {"load", exactly(load)}, {"G", exactly("1.5")}}, 15);
        CHECK(e.status == Status::undecided);
        CHECK(e.note.find("infinite") != std::string::npos);
    }
    // the engine knows nothing of that
    for (const Grid grid : {Grid::blind, Grid::tracked}) CHECK(apart(estimated_area(grid, 2, Ball(15), Ball(3)).value, Ball(1)) < 2e-18);
}

TEST_CASE("what is estimated says so, and no digit is given that the two do not share")
{
    const Inputs in({{"n", 2}, {"p", exactly("0.0025")}, {"load", 1}, {"G", 2}}); // below p*_2/1024
    Quantity q = *find_quantity("contact.density");
    const auto e = evaluate(q, in, {.digits = 15});
    CHECK(e.status == Status::estimated);
    CHECK(e.note.find("no proof") != std::string::npos);
    const auto more = evaluate(q, in, {.digits = 30});
    CHECK(more.status == Status::undecided);
    CHECK(more.digits == 15);
    CHECK(more.value == e.value);

    const Ball third = exact_ball(Real(1) / 3);
    const auto seen = [&](const Witness& one, const Witness& other) {
        q.plan = [=](const Inputs&, Accuracy) {
            return Plan{.witnesses = {{"one", [=](Accuracy) { return one; }}, {"other", [=](Accuracy) { return other; }}},
                        .refusal = "no proof"};
        };
        return evaluate(q, in, {.digits = 15});
    };
    const auto apart_by = seen({third, Ball(0)}, {third + Ball::exactly(1e-9), Ball(0)});
    CHECK(apart_by.status == Status::undecided);
    CHECK(apart_by.value == "0.3333333");
    CHECK_FALSE(apart_by.proven);
    CHECK(apart_by.note == "no proof: two discretisations agree to 7 digits only");
    CHECK(seen({third, Ball(0)}, {third, Ball::exactly(1e-9)}).value == "0.3333333"); // as is an error of its own
    const auto at_odds = seen({third, Ball(0)}, {Ball(1), Ball(0)});
    CHECK(at_odds.status == Status::undecided);
    CHECK(at_odds.value == "nan");
    CHECK(at_odds.note == "no proof: two discretisations do not agree");
}

TEST_CASE("scale 2 through the catalogue: as nested integrals over theta and psi, cut at the singular points, in 38 digits elsewhere")
{
    const auto share = eval("contact.exceedance", {{"n", 2}, {"p", exactly("0.9")}, {"load", 1}, {"G", exactly("1.2")}}, 4);
    CHECK(share.status == Status::certified);
    CHECK(share.value == "0.4158"); // 0.415780719727410675080929
    const auto count = eval("segments.count", {{"n", 3}, {"load", 3}, {"D", exactly("1.5")}, {"gamma", exactly("2.25")}}, 4);
    CHECK(count.status == Status::certified);
    CHECK(count.value == "10.09"); // gamma^3 times 0.886121094698361969962823
    const auto density = eval("contact.density", {{"n", 2}, {"p", exactly("0.9")}, {"load", 1}, {"G", 2}}, 6);
    CHECK(density.status == Status::certified);
    CHECK(density.value == "0.0243928"); // 0.02439282952663530310
}

TEST_CASE("slow: the same G, the same certified areas, to 15 digits" * doctest::skip())
{
    const auto a = eval("contact.area", {{"n", 3}, {"load", 10}, {"D", exactly("1.5")}, {"gamma", 16}}, 15);
    CHECK(a.status == Status::certified);
    CHECK(a.value == eval("contact.area", {{"n", 3}, {"load", 10}, {"D", exactly("1.25")}, {"gamma", 256}}, 15).value);
}
TEST_CASE("the same G, the same certified areas; the digits are proven once and seen once more")
{
    const auto b = eval("contact.area", {{"n", 2}, {"load", 1}, {"G", exactly("1.5")}}, 6);
    CHECK(b.status == Status::certified);
    CHECK(b.value == eval("contact.area", {{"n", 2}, {"load", 1}, {"D", exactly("1.25")}, {"gamma", exactly("81/16")}}, 6).value);
    REQUIRE(b.second_look);
    CHECK_FALSE(b.second_look->is_proof);
    CHECK(b.second_look->agrees);
    CHECK(b.second_look->digits >= 6);
}

namespace {

struct Seam {
    const char *G, *load, *p, *least; ///< exceedances and densities agree to this, relative
    long n;
};

void check_seam(const Seam& seam)
{
    const auto& [G, load, p, least, n] = seam;
    CAPTURE(G); CAPTURE(load); CAPTURE(p); CAPTURE(n);
    const auto at = [&](Grid grid, auto f) { return f(grid, n, ball(p), ball(load), ball(G), finest_estimate).value; };
    CHECK(apart(at(Grid::blind, estimated_exceedance), at(Grid::tracked, estimated_exceedance)) < 1e-16);
    CHECK(apart(at(Grid::blind, estimated_density), at(Grid::tracked, estimated_density)) < std::stod(least));
}

} // namespace

TEST_CASE("distributions at the seams: G = 2, load = 1, an end of the support that is a singular point and an end of the grid, p -> 0")
{
    for (const Seam& seam : {
             Seam{"2", "1", "0.9", "1e-16", 2}, // the upper end of E_1 at x = 1, where the grid ends
             {"2", "1", "7.999999992", "1e-14", 2},
             {"2", "1", "1e-9", "1e-7", 2}})
        check_seam(seam);
    // by one integral more over scale 1 (full_contact_slow), to its 15 digits
    CHECK(apart(estimated_exceedance(Grid::tracked, 2, ball("0.9"), Ball(1), Ball(2)).value, ball("0.2356090717562473")) < 1e-15);
    // p -> 0 through 1/sqrt(1 - x): no nan, the area
    for (const Grid grid : {Grid::blind, Grid::tracked})
        CHECK(apart(estimated_exceedance(grid, 2, ball("1e-300"), Ball(1), Ball(2)).value,
                    estimated_area(grid, 2, Ball(1), Ball(2)).value) < 1e-17);
}

TEST_CASE("slow: a seam that no point of the blind grid sees: E_1 ends at 1 + 6e-7" * doctest::skip())
{
    check_seam({"1.9999999", "1.000001", "0.9", "1e-14", 2});
}

TEST_CASE("slow: seams at another scale, and beside a load of 1" * doctest::skip())
{
    for (const Seam& seam : {
             Seam{"2", "1", "0.9", "1e-16", 3},
             {"2", "1", "1e-9", "1e-7", 3},
             {"1.2", "1", "0.9", "1e-16", 2}, // p^2/4 an end of the blind grid's intervals
             {"2.5", "1.5", "6.25", "1e-15", 2}}) // (load + 1)/G = 1
        check_seam(seam);
    check_seam({"2", "0.999999", "3", "1e-14", 2});
}

TEST_CASE("a blind grid that is asked for fewer digits is coarser, and as good as it says")
{
    const WorkingPrecision precision(160);
    const Ball G = ball("1.5"), load = ball("1.3"), p = ball("0.9");
    const auto holds = [](const Witness& coarse, const Witness& fine, long digits) {
        INFO(digits, ": ", coarse.value.to_string(), " +- ", coarse.error.to_string(3), " against ", fine.value.to_string());
        CHECK(!certainly(less(coarse.error, abs(coarse.value - fine.value))));
        CHECK(certainly(less(coarse.error, abs(fine.value) * pow(Ball(10), Ball(-digits)))));
        CHECK(!certainly(less(coarse.error, 4 * fine.error))); // it is another grid, and knows
    };
    for (const long digits : {4, 9}) {
        holds(estimated_area(Grid::blind, 3, load, G, {digits}), estimated_area(Grid::blind, 3, load, G), digits);
        holds(estimated_exceedance(Grid::blind, 2, p, load, G, {digits}), estimated_exceedance(Grid::blind, 2, p, load, G), digits);
    }
}

TEST_CASE("exceedance and density: certified at n = 1 in partial contact, both grids elsewhere, next to singular points too")
{
    const WorkingPrecision precision(160);
    for (const char* p : {"0.01", "0.5", "1.8", "3.2"}) {
        const Ball G = ball("3.16"), load = ball("0.3"), P = ball(p);
        CAPTURE(p);
        for (const Grid grid : {Grid::blind, Grid::tracked}) {
            CHECK(apart(estimated_exceedance(grid, 1, P, load, G).value,
                        exceedance(
                            Law::density, 1, [&] { return P; }, {[&] { return load; }, [&] { return G; }}, wanted())) < 1e-17);
            CHECK(apart(estimated_density(grid, 1, P, load, G).value,
                        density(
                            Law::density, 1, [&] { return P; }, {[&] { return load; }, [&] { return G; }}, wanted())) < 3e-16);
        }
    }
    // G = 1.5, load = 3: q_1 has logarithms at p = 3 +- 1 +- 1.5 and square roots at its ends 0.5, 5.5
    for (const char* p : {"0.50001", "1", "2.4999999", "2.500000001", "3.5000001", "4.1", "5.4999"}) {
        CAPTURE(p);
        const auto at = [p](Grid grid, auto f) { return f(grid, 1, ball(p), Ball(3), ball("1.5"), finest_estimate).value; };
        CHECK(apart(at(Grid::blind, estimated_exceedance), at(Grid::tracked, estimated_exceedance)) < 1e-15);
        CHECK(apart(at(Grid::blind, estimated_density), at(Grid::tracked, estimated_density)) < 1e-11);
    }
}
TEST_CASE("slow: exceedance and density at scale 2, both grids, at small and large pressures" * doctest::skip())
{
    for (const char* p : {"0.3", "2", "10"}) check_seam({"3", "3", p, "1e-14", 2});
}

namespace {

void check_forwards_and_backwards(long scales)
{
    const Ball G = ball("1.5"), load = ball("1.7");
    const auto g = extended_pair(G), x = extended_pair(load);
    // E_1 = F(load; G y), from the distance to its upper end: rounding noise there would be halved without end
    const auto highest = quotient(sum(x, Real(1)), g);
    const auto first = [&](const Pair<Real>& y) {
        const Real below = g.high * ((highest.high - y.high) + (highest.low - y.low));
        return below <= 0 ? Real(0) : below >= 2 ? Real(1) : std::asin(std::sqrt(below / 2)) / (2 * std::atan(Real(1)));
    };
    Piecewise<Real> E({}, Real(4), first);
    Real unit = g.high;
    for (long n = 1; n <= scales; ++n) {
        CAPTURE(n);
        E = Piecewise<Real>({}, Real(4), [&](const Pair<Real>& y) { return E.after(wave_to(product(g, y), false)); });
        unit *= g.high;
        CHECK(std::fabs(static_cast<double>(E.integral() * unit / x.high - 1)) < 1e-16); // int Q_n dp = load
        CHECK(apart(exact_ball(E.at(Real(1e-25L))), estimated_area(Grid::tracked, n, load, G).value) < 1e-16);
    }
}

} // namespace

TEST_CASE("forwards and backwards: p -> 0 is the area, and the mean load is kept") { check_forwards_and_backwards(1); }
TEST_CASE("slow: forwards and backwards: p -> 0 is the area, and the mean load is kept at every scale" * doctest::skip())
{
    check_forwards_and_backwards(2);
}

TEST_CASE("singular points: exact images, merged where they are the same")
{
    const WorkingPrecision precision(256);
    const auto positions = [](const std::vector<SingularPoint>& points) {
        std::vector<double> all;
        for (const auto& p : points) all.push_back(arf_get_d(arb_midref(p.position.get()), ARF_RND_NEAR));
        return all;
    };
    // G = 2: 1 -> 3 and 1 (twice the same) -> 7, 5 -> 15, 13, 11, 9; beyond the reach, kept as neighbours, 13 and 15
    CHECK(positions(area_points(Ball(2), {Ball(12), 4, 1e-18})) == std::vector<double>{1, 3, 5, 7, 9, 11, 13, 15});
    // G = 1.5: 1 -> 2.5, 0.5625 -> 4.75, 2.75, 1.84375, 0.177978515625
    CHECK(positions(area_points(ball("1.5"), {Ball(12), 3, 1e-18})) ==
          std::vector<double>{0.177978515625, 0.5625, 1, 1.84375, 2.5, 2.75, 4.75});
    // load = 3, G = 1.5: 8/3 and 4/3 = 2/G, then (8/3 +- 1)/G, (4/3 +- 1)/G; 1 is marked
    const auto exceedances = positions(exceedance_points(Ball(3), ball("1.5"), {Ball(12), 2, 1e-18}));
    REQUIRE(exceedances.size() == 7);
    const double expected[] = {2. / 9, 1, 10. / 9, 4. / 3, 14. / 9, 22. / 9, 8. / 3};
    for (std::size_t i = 0; i < 7; ++i) CHECK(std::fabs(exceedances[i] - expected[i]) < 1e-15);
}
