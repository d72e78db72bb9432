// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/transfer/distribution.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

Rational exactly(const char* text) { return *parse_rational(text); }

Evaluation eval(const char* name, std::map<std::string, Rational> in, long digits)
{
    return evaluate(*find_quantity(name), Inputs(std::move(in)), {.digits = digits});
}

} // namespace

TEST_CASE("two forward routes overlap, tightly, from p = 0 up to the edge")
{
    const WorkingPrecision precision(bits_for_digits(30) + 48);
    for (const char* g : {"2.05", "3.1622776601683795", "16"})
        for (const char* l : {"1e-12", "0.1", "0.9", "1"}) {
            const Ball G(exactly(g)), load(exactly(l)), highest = 2 * sqrt(2 * sqrt(load) * G);
            for (const char* part : {"0.001", "0.3", "0.9", "0.999999999"}) {
                CAPTURE(g); CAPTURE(l); CAPTURE(part);
                Ball p = highest * Ball(exactly(part));
                arb_get_mid_arb(p.get(), p.get());
                const Ball q = density_1(Law::pressures, p, load, G), Q = exceedance_1(Law::pressures, p, load, G);
                CHECK(q.overlaps(density_1(Law::force_chain, p, load, G)));
                CHECK(Q.overlaps(exceedance_1(Law::force_chain, p, load, G)));
                CHECK(q.relative_bits() > 100);
                CHECK(Q.relative_bits() > 90);
            }
        }
}

TEST_CASE("the density is the slope of the exceedance; the exceedance falls from A_1 to 0")
{
    const WorkingPrecision precision(300);
    const Ball G(3), load(exactly("0.4"));
    const Ball area_1 = area(Scheme::force_weighted, 1, {[&] { return load; }, [&] { return G; }});
    Ball last = area_1;
    for (const char* text : {"1e-6", "0.1", "1", "2", "3", "3.8"}) { // p_1^max = 3.8959...
        const Ball p(exactly(text)), h(exactly("1e-20"));
        const Ball slope = (exceedance_1(Law::pressures, p - h, load, G) - exceedance_1(Law::pressures, p + h, load, G)) / (2 * h);
        const Ball q = density_1(Law::force_chain, p, load, G);
        CHECK(certainly(less(abs(slope / q - 1), Ball(exactly("1e-25")))));
        const Ball Q = exceedance_1(Law::pressures, p, load, G);
        CHECK(certainly(less(Q, last)));
        last = Q;
    }
    // all of q_1 is A_1, and its force is the load: by parts, int p q dp = int Q dp
    CHECK(certainly(less(area_1 - exceedance_1(Law::pressures, Ball(exactly("1e-9")), load, G), Ball(exactly("1e-15")))));
}

TEST_CASE("force is conserved: the integral of p q_1(p) encloses the load")
{
    // Simpson's rule in p = p_max sin^2(t), where p q_1 dp/dt is smooth, to the accuracy of such a rule
    const WorkingPrecision precision(128);
    const Ball G(3), load(exactly("0.4")), highest = 2 * sqrt(2 * sqrt(load) * G);
    const long steps = 64;
    Ball sum(0), mass(0);
    for (long i = 1; i < steps; ++i) {
        const Ball t = pi<Ball>() * i / (2 * steps);
        Ball p = highest * sin(t) * sin(t);
        arb_get_mid_arb(p.get(), p.get());
        const Ball term = density_1(Law::pressures, p, load, G) * highest * sin(2 * t) * (i % 2 ? 4 : 2);
        mass += term;
        sum += term * p;
    }
    const Ball rule = pi<Ball>() / (2 * steps) / 3;
    CHECK(certainly(less(abs(sum * rule - load), Ball(exactly("1e-5")))));
    const Ball area_1 = area(Scheme::force_weighted, 1, {[&] { return load; }, [&] { return G; }});
    CHECK(certainly(less(abs(mass * rule - area_1), Ball(exactly("1e-5")))));
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
    CHECK(eval("contact.density", {{"n", 2}, {"p", 1}, {"load", load}, {"G", G}}, 30).status == Status::undecided);
    // (9.3) is the derivative of (9.2): at n = 1, pi G sin(2 pi a) q_0(G sin^2(pi a)) with q_0 of section 2
    const auto s = eval("segments.density", {{"n", 1}, {"a", exactly("1/6")}, {"load", load}, {"G", G}}, 30);
    const auto q = eval("westergaard.density", {{"p", exactly("0.75")}, {"load", load}}, 40);
    const WorkingPrecision precision(128);
    const Ball expected = pi<Ball>() * Ball(3) * sqrt(Ball(3)) / 2 * Ball(*parse_rational(q.value));
    CHECK(certainly(less(abs(Ball(*parse_rational(s.value)) - expected), Ball(exactly("1e-28")))));
}
