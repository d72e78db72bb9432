// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/transfer/forward.hpp"

#include <doctest/doctest.h>

#include <thread>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

Rational exactly(const char* text) { return *parse_rational(text); }

Arguments at(const char* load, const char* G)
{
    return {[load] { return Ball(exactly(load)); }, [G] { return Ball(exactly(G)); }};
}

/// The binary64 number nearest to share p_n^max.
Rational pressure(long n, const char* share, const char* load, const char* G)
{
    const WorkingPrecision precision(256);
    Ball unit;
    arb_pow_ui(unit.get(), Ball(exactly(G)).get(), static_cast<ulong>(n + 1), precision.bits());
    const Ball p = unit * peaks::iterate(n, Ball(exactly(load)), Ball(exactly(G))) * Ball(exactly(share));
    return exact_rational(arf_get_d(arb_midref(p.get()), ARF_RND_NEAR));
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

} // namespace

TEST_CASE("the two laws overlap, tightly, from small p up to the edge")
{
    const WorkingPrecision precision(bits_for_digits(16) + 48);
    for (const auto& [G, load] : {std::pair{"2.05", "1"}, {"3.1622776601683795", "0.1"}, {"100", "1e-12"}})
        for (const long n : {1L, 2L, 4L})
            for (const char* share : {"0.001", "0.3", "0.9", "0.99999999999999999999"}) {
                CAPTURE(G); CAPTURE(load); CAPTURE(n); CAPTURE(share);
                const Rational p = n == 4 && share[4] ? pressure(n, "0.999999", load, G) : pressure(n, share, load, G);
                Ball P;
                {
                    const WorkingPrecision many(400); // 1 - 1e-20 is no binary64 number: p itself as a short ball
                    Ball unit;
                    arb_pow_ui(unit.get(), Ball(exactly(G)).get(), static_cast<ulong>(n + 1), many.bits());
                    P = unit * peaks::iterate(n, Ball(exactly(load)), Ball(exactly(G))) * Ball(exactly(share));
                    arb_get_mid_arb(P.get(), P.get());
                }
                const auto p_at = [&] { return P; };
                const Ball q = density(Law::density, n, p_at, at(load, G)), Q = exceedance(Law::exceedance, n, p_at, at(load, G));
                CHECK(q.overlaps(density(Law::exceedance, n, p_at, at(load, G))));
                CHECK(Q.overlaps(exceedance(Law::density, n, p_at, at(load, G))));
                CHECK(q.relative_bits() > 60);
                CHECK(Q.relative_bits() > 60);
            }
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
        CHECK(near(density(law, 1, p_1, a), "0.01754937144660158405091275", "1e-21"));
        CHECK(near(exceedance(law, 1, p_1, a), "0.04010037050850863148585203", "1e-21"));
        CHECK(near(density(law, 2, p_2, b), "0.0014695860132234507792429895970742645311", "1e-21"));
        CHECK(near(exceedance(law, 2, p_2, b), "0.011215306086010659841210644188124502203", "1e-21"));
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
    CHECK(eval("contact.density", {{"n", 21}, {"p", 1}, {"load", load}, {"G", G}}, 15).status == Status::undecided);
    // (9.3) is the derivative of (9.2): at n = 1, pi G sin(2 pi a) q_0(G sin^2(pi a)) with q_0 of section 2
    const auto s = eval("segments.density", {{"n", 1}, {"a", exactly("1/6")}, {"load", load}, {"G", G}}, 30);
    const auto q = eval("westergaard.density", {{"p", exactly("0.75")}, {"load", load}}, 40);
    const WorkingPrecision precision(128);
    const Ball expected = pi<Ball>() * Ball(3) * sqrt(Ball(3)) / 2 * Ball(*parse_rational(q.value));
    CHECK(certainly(less(abs(Ball(*parse_rational(s.value)) - expected), Ball(exactly("1e-28")))));
}
