// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/evaluate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <malloc.h>
#include <thread>

using namespace touchstone;

namespace {

Inputs inputs(std::initializer_list<std::pair<const char*, const char*>> list)
{
    std::map<std::string, Rational> values;
    for (const auto& [key, text] : list) values[key] = *parse_rational(text);
    return Inputs(values);
}

Evaluation eval(const char* name, const Inputs& in, EvaluationOptions options = {})
{
    const Quantity* q = find_quantity(name);
    REQUIRE(q != nullptr);
    return evaluate(*q, in, options);
}

/// One ordinary argument list for every quantity; a quantity without one fails the tests below.
Inputs typical(const Quantity& q)
{
    static const std::map<std::string, Inputs> all{
        {"westergaard.half_width", inputs({{"load", "0.3"}})},
        {"westergaard.pressure", inputs({{"x", "0.1"}, {"load", "0.3"}})},
        {"westergaard.exceedance", inputs({{"p", "0.7"}, {"load", "0.3"}})},
        {"westergaard.density", inputs({{"p", "0.7"}, {"load", "0.3"}})},
        {"westergaard.gap", inputs({{"x", "0.37"}, {"load", "0.3"}})},
        {"westergaard.mean_gap", inputs({{"load", "0.3"}})},
        {"westergaard.energy", inputs({{"load", "0.3"}})},
        {"hertz.gap", inputs({{"x", "0.37"}, {"load", "0.3"}})},
        {"hertz.half_width", inputs({{"load", "0.3"}})},
        {"hertz.pressure", inputs({{"x", "0.1"}, {"load", "0.3"}})},
        {"weierstrass.profile", inputs({{"x", "0.13"}, {"D", "1.5"}, {"gamma", "5"}})},
        {"weierstrass.bound", inputs({{"D", "1.3"}, {"gamma", "5"}})},
        {"peaks.f", inputs({{"x", "0.3"}})},
        {"peaks.iterate", inputs({{"n", "7"}, {"load", "0.3"}, {"G", "2.7"}})},
        {"peaks.fixed_point", inputs({{"D", "1.3"}, {"gamma", "5"}})},
        {"archard.K", inputs({{"n", "7"}})},
        {"archard.K_inf", inputs({})},
        {"archard.delta", inputs({{"n", "7"}})},
        {"archard.alpha", inputs({{"n", "7"}, {"D", "1.3"}})},
        {"archard.area", inputs({{"n", "7"}, {"load", "0.3"}, {"G", "2.7"}})},
        {"archard.segments", inputs({{"n", "7"}, {"load", "0.3"}, {"D", "1.3"}, {"gamma", "5"}})},
        {"archard.segments_limit", inputs({{"n", "7"}, {"load", "0.3"}, {"D", "1.3"}, {"gamma", "5"}})},
        {"contact.area", inputs({{"n", "3"}, {"load", "0.3"}, {"G", "10"}})},
        {"contact.exceedance", inputs({{"n", "1"}, {"p", "0.7"}, {"load", "0.3"}, {"G", "10"}})},
        {"contact.density", inputs({{"n", "1"}, {"p", "0.7"}, {"load", "0.3"}, {"G", "10"}})},
        {"segments.density", inputs({{"n", "2"}, {"a", "0.01"}, {"load", "0.3"}, {"G", "10"}})},
        {"segments.count", inputs({{"n", "3"}, {"load", "0.3"}, {"D", "1.5"}, {"gamma", "100"}})},
        {"segments.max_half_width", inputs({{"n", "7"}, {"load", "0.3"}, {"G", "2.7"}})},
    };
    const auto it = all.find(q.name);
    REQUIRE_MESSAGE(it != all.end(), "no typical arguments for " << q.name);
    return it->second;
}

/// Quantities whose cost grows with the cube of the digits: asked for 70 digits here, not 1000.
bool costly(const Quantity& q) { return q.name.starts_with("contact.") || q.name == "segments.count" || q.name == "segments.density"; }

/// Seconds a value: tests/limit.
bool of_the_limit(const Quantity& q) { return q.name.starts_with("limit."); }

} // namespace

TEST_CASE("every quantity answers at 1, 50 and 1000 digits, by two routes")
{
    for (const auto& q : catalogue()) {
        CAPTURE(q.name);
        if (of_the_limit(q)) continue;
        CHECK(plan_of(q, typical(q), {20}).proofs.size() >= 2);
        CHECK_FALSE(q.description.empty());
        std::string longest;
        const long most = costly(q) ? 70 : 1000;
        for (const long digits : {most, 50L, 1L}) {
            const Evaluation e = evaluate(q, typical(q), {.digits = digits});
            CHECK((e.status == Status::certified || e.status == Status::exact));
            REQUIRE(e.binary64.has_value());
            // fewer digits are the rounding of more: the double nearest to 50 digits is the one reported
            if (digits == most) longest = e.value;
            else {
                const Rational difference = abs(*parse_rational(e.value) - *parse_rational(longest));
                CHECK(difference <= *parse_rational(e.error_bound) + power(Rational(10), -most * 9 / 10));
            }
            CHECK(nearest_double(*parse_rational(longest)) == *e.binary64);
        }
    }
}

TEST_CASE("digits do not depend on the precision a search starts from, nor on the thread")
{
    for (const auto& q : catalogue()) {
        CAPTURE(q.name);
        if (of_the_limit(q)) continue;
        const Evaluation reference = evaluate(q, typical(q), {.digits = 60});
        for (const slong start : {2L, 33L, 64L, 300L, 1111L}) {
            if (costly(q) && start > 300) continue;
            Evaluation e;
            std::jthread([&] { e = evaluate(q, typical(q), {.digits = 60, .start_bits = start, .limit_bits = 10000}); }).join();
            CHECK(e.value == reference.value);
            CHECK(e.status == reference.status);
            CHECK(e.binary64 == reference.binary64);
        }
    }
}

TEST_CASE("a caller's thread that ends leaves nothing of FLINT's behind")
{
    // under AddressSanitizer the counters are 0, and its search for leaks is the judge
    const auto in_use_after = [](int threads) {
        for (int k = 0; k < threads; ++k)
            std::jthread([] { eval("archard.K_inf", inputs({}), {.digits = 200}); }).join();
        const auto m = mallinfo2();
        return static_cast<double>(m.uordblks + m.hblkhd);
    };
    const double before = in_use_after(2);
    CHECK((in_use_after(10) - before) / 10 < 1000);
}

TEST_CASE("exact values are recognised as exact")
{
    CHECK(eval("peaks.fixed_point", inputs({{"gamma", "4"}, {"D", "1.5"}})).status == Status::exact);
    CHECK(eval("peaks.fixed_point", inputs({{"gamma", "4"}, {"D", "1.5"}})).value == "1");
    CHECK(eval("peaks.f", inputs({{"x", "0.25"}})).value == "1");
    CHECK(eval("weierstrass.profile", inputs({{"x", "1/3"}, {"gamma", "4"}, {"D", "1.5"}})).value == "-1");
    CHECK(eval("weierstrass.profile", inputs({{"x", "0.25"}, {"gamma", "5"}, {"D", "1.05"}})).status == Status::exact);
    CHECK(eval("weierstrass.profile", inputs({{"x", "0.25"}, {"gamma", "5"}, {"D", "1.05"}})).value == "0");
    // zero without any term being zero: cos 36 degrees = sum of 5^(-n/2), n >= 1
    CHECK(eval("weierstrass.profile", inputs({{"x", "0.1"}, {"gamma", "5"}, {"D", "1.5"}})).status == Status::exact);
    CHECK(eval("weierstrass.profile", inputs({{"x", "0.1"}, {"gamma", "5"}, {"D", "1.5"}})).value == "0");
    CHECK(eval("weierstrass.profile", inputs({{"x", "0.1"}, {"gamma", "5"}, {"D", "1.500000001"}})).status == Status::certified);
    CHECK(eval("westergaard.half_width", inputs({{"load", "0.5"}})).value == "0.25");
    CHECK(eval("westergaard.pressure", inputs({{"x", "1/6"}, {"load", "1/4"}})).value == "0"); // the contact edge
    CHECK(eval("archard.delta", inputs({{"n", "2"}})).value == "0.875");
    CHECK(eval("archard.alpha", inputs({{"n", "2"}, {"D", "1.5"}})).value == "-0.625");
    CHECK(eval("segments.max_half_width", inputs({{"n", "3"}, {"load", "10"}, {"G", "1.1"}})).value.starts_with("0.5"));
    // 1/6 has no finite expansion: certified, not exact
    CHECK(eval("westergaard.half_width", inputs({{"load", "0.25"}})).status == Status::certified);
}

TEST_CASE("exact ties round to even, and are not mistaken for undecidable")
{
    // f(x) = 1 + x for x > 1: 2.125 at 3 digits is a tie
    const Evaluation tie = eval("peaks.f", inputs({{"x", "1.125"}}), {.digits = 3});
    CHECK(tie.value == "2.12");
    CHECK(tie.status == Status::certified);
    // a tie of the double rounding: 2 + 2^-52 lies between two binary64 numbers
    CHECK(*eval("peaks.f", inputs({{"x", "0x1.0000000000001p0"}})).binary64 == 2.0);
}

TEST_CASE("what cannot be decided within the limit is undecided, with what is known")
{
    // 1 - 10^-60 from 2: x_n approaches 1/4 from one side only, so one digit of 0.25 is decided late
    const Inputs in = inputs({{"n", "900"}, {"load", "1"}, {"G", "4"}});
    const Evaluation e = eval("peaks.iterate", in, {.digits = 1, .start_bits = 64, .limit_bits = 256});
    CHECK(e.status == Status::undecided);
    CHECK_FALSE(e.note.empty());
    CHECK(e.proven); // and every route has been asked for the digits there are
    const Evaluation decided = eval("peaks.iterate", in, {.digits = 1, .limit_bits = 4000});
    CHECK(decided.status == Status::certified);
    CHECK(decided.value == "0.3"); // from above
}

TEST_CASE("extremes: tiny loads, loads next to 1, many digits, huge n")
{
    CHECK(eval("westergaard.half_width", inputs({{"load", "1e-300"}}), {.digits = 5}).value == "3.1831e-151");
    CHECK(eval("westergaard.half_width", inputs({{"load", "0x1.fffffffffffffp-1"}}), {.digits = 12}).value == "0.499999996646");
    CHECK(eval("archard.K", inputs({{"n", "1000000"}}), {.digits = 30}).value == eval("archard.K_inf", inputs({}), {.digits = 30}).value);
    CHECK(eval("archard.area", inputs({{"n", "1000000"}, {"load", "0.1"}, {"G", "2"}}), {.digits = 5}).status == Status::certified);
    CHECK(eval("weierstrass.profile", inputs({{"x", "0.1"}, {"D", "1.95"}, {"gamma", "1.5"}}), {.digits = 30}).status == Status::certified);
    CHECK(eval("weierstrass.profile", inputs({{"x", "0.1"}, {"D", "1.999999999"}, {"gamma", "1.5"}}), {.digits = 30}).status ==
          Status::undecided);
}

TEST_CASE("exactness far from the ordinary: high degrees, long iterations, saturation")
{
    // G = (2^4097)^(1/4097) = 2: no radical of that degree is held, but a perfect power needs none
    CHECK(eval("peaks.fixed_point", inputs({{"gamma", "0x1p4097"}, {"D", "4098/4097"}})).status == Status::exact);
    CHECK(inputs({{"gamma", "0x1p5000"}, {"D", "5001/5000"}}).compare_G(2) == 0);
    CHECK(eval("peaks.iterate", inputs({{"n", "1000000"}, {"load", "21/20"}, {"G", "41/21"}}), {.digits = 2}).value ==
          "1.0"); // the fixed point, a tie
    CHECK(eval("segments.max_half_width", inputs({{"n", "65"}, {"load", "1/2"}, {"gamma", "8"}, {"D", "1.5"}}), {.digits = 1}).value ==
          "0.2");
    CHECK(eval("segments.max_half_width", inputs({{"n", "200"}, {"load", "10"}, {"G", "1.1"}})).value == "0.5");
    CHECK(eval("segments.max_half_width", inputs({{"n", "7"}, {"load", "1e300"}, {"D", "1.5"}, {"gamma", "10"}})).status == Status::exact);
    CHECK(eval("weierstrass.profile", inputs({{"x", "0"}, {"D", "3/2"}, {"gamma", "25/9"}}), {.digits = 1}).value == "2"); // 5/2, a tie
}

TEST_CASE("a first precision above the limit, and a limit below the first precision, are still tried")
{
    CHECK(eval("archard.K", inputs({{"n", "3"}}), {.start_bits = 20000}).value == eval("archard.K", inputs({{"n", "3"}})).value);
    CHECK(eval("archard.K", inputs({{"n", "3"}}), {.limit_bits = 100}).status == Status::certified);
}

TEST_CASE("work without end is refused in time")
{
    CHECK(eval("weierstrass.profile", inputs({{"x", "1/7"}, {"D", "1.9999"}, {"gamma", "3"}}), {.digits = 5}).status == Status::undecided);
    CHECK(eval("weierstrass.profile", inputs({{"x", "1/7"}, {"D", "1.99"}, {"gamma", "1.01"}}), {.digits = 5}).status == Status::undecided);
}

TEST_CASE("out of domain is one line that says what would be right")
{
    const auto fails = [](const char* name, const Inputs& in, const char* expected) {
        CHECK_THROWS_WITH_AS(eval(name, in), doctest::Contains(expected), DomainError);
    };
    fails("archard.K", inputs({{"n", "-1"}}), "n = -1: must be an integer from 0");
    fails("archard.K", inputs({{"n", "1.5"}}), "must be an integer");
    fails("westergaard.half_width", inputs({{"load", "0"}}), "load = 0: must be > 0");
    fails("westergaard.half_width", inputs({{"load", "1.5"}}), "<= 1");
    fails("westergaard.pressure", inputs({{"x", "0.6"}, {"load", "0.5"}}), "x = 3/5");
    fails("westergaard.density", inputs({{"p", "1"}, {"load", "0.25"}}), "edges of the support");
    fails("weierstrass.bound", inputs({{"D", "2"}, {"gamma", "5"}}), "D = 2: must be > 1 and < 2");
    fails("weierstrass.bound", inputs({{"D", "1.5"}, {"gamma", "1"}}), "gamma = 1: must be > 1");
    fails("peaks.fixed_point", inputs({{"G", "1"}}), "G = 1: must be > 1");
    CHECK_THROWS_AS(eval("archard.K_inf", inputs({}), {.digits = 0}), DomainError);
    CHECK_THROWS_AS(eval("archard.K_inf", inputs({}), {.digits = 10001}), DomainError);
}

TEST_CASE("routes that disagree are a hard failure")
{
    Quantity broken = *find_quantity("hertz.half_width");
    broken.exact = {};
    broken.routes[1].ball = [](const Inputs& in) { return sqrt(Ball(in.real("load"))) / 3; }; // 3 for pi
    CHECK_THROWS_AS(evaluate(broken, inputs({{"load", "0.3"}})), RoutesDisagree);
    // an exact zero is no exception: outside the contact the first route gives 0 with radius 0
    Quantity outside = *find_quantity("hertz.pressure");
    outside.exact = {};
    outside.routes[1].ball = [](const Inputs&) { return Ball(1); };
    CHECK_THROWS_AS(evaluate(outside, inputs({{"x", "0.4"}, {"load", "0.3"}})), RoutesDisagree);
    // and one that is right but too loose to decide the digits does not count as a second route
    broken.routes[1].ball = [](const Inputs& in) {
        Ball b = sqrt(Ball(in.real("load"))) / pi<Ball>();
        arb_add_error(b.get(), power_of_two<Ball>(-20).get());
        return b;
    };
    CHECK(evaluate(broken, inputs({{"load", "0.3"}})).status == Status::undecided);
}

namespace {

/// A value with what the test says of it; other routes than the test's are gone.
Quantity known_by(Plan plan)
{
    Quantity q = *find_quantity("archard.K_inf");
    q.routes.clear();
    q.plan = [plan](const Inputs&, Accuracy) { return plan; };
    return q;
}
Proof proves(const Rational& value, const Rational& radius = 0, std::vector<long>* asked = nullptr)
{
    return {"a proof", [=](Accuracy a) {
                if (asked) asked->push_back(a.digits);
                const WorkingPrecision precision(working_bits(a) + 200);
                Ball b(value);
                arb_add_error(b.get(), Ball(radius + power(Rational(10), -a.digits - 3)).get());
                return b;
            }};
}
Look sees(const Rational& value, const Rational& error)
{
    return {"an estimate", [=](Accuracy) { return Witness{Ball(value), Ball(error)}; }};
}
const Rational third(1, 3), tiny = power(Rational(10), -18);

} // namespace

TEST_CASE("a witness that agrees is a second look; one that does not is said loudly and leaves the proof alone")
{
    const Evaluation agreed = evaluate(known_by({.proofs = {proves(third)}, .witnesses = {sees(third + tiny, tiny)}, .shares = "nothing"}),
                                       inputs({}), {.digits = 12});
    CHECK(agreed.status == Status::certified);
    REQUIRE(agreed.second_look);
    CHECK_FALSE(agreed.second_look->is_proof);
    CHECK(agreed.second_look->agrees);
    CHECK(agreed.second_look->digits == 17);
    CHECK(agreed.second_look->shares == "nothing");
    CHECK(agreed.note.empty());
    CHECK(agreed.routes == std::vector<std::string>{"a proof", "an estimate (witness)"});

    const Evaluation apart = evaluate(known_by({.proofs = {proves(third)}, .witnesses = {sees(third + power(Rational(10), -9), tiny)}}),
                                      inputs({}), {.digits = 12});
    CHECK(apart.status == Status::certified);
    CHECK(apart.value == "0.333333333333");
    CHECK(apart.proven);
    REQUIRE(apart.second_look);
    CHECK_FALSE(apart.second_look->agrees);
    CHECK(apart.note.find("DISAGREES") != std::string::npos);
    CHECK(apart.note.find("an estimate") != std::string::npos);

    // one that misjudges itself is named, where another one agrees; where none does, or cannot look, the first is what disagrees
    Look other = sees(third, tiny), off = sees(third + power(Rational(10), -8), tiny),
         cannot{"blind", [](Accuracy) -> Witness { throw BeyondReach("no grid"); }};
    other.name = "another";
    off.name = "a third";
    const Look wrong = sees(third + power(Rational(10), -9), tiny);
    const Evaluation mended =
        evaluate(known_by({.proofs = {proves(third)}, .witnesses = {wrong, cannot, other}}), inputs({}), {.digits = 12});
    REQUIRE(mended.second_look);
    CHECK(mended.second_look->agrees);
    CHECK(mended.second_look->name == "another");
    CHECK(mended.note == "the witness 'an estimate' is off here, 8 digits agree");
    CHECK(mended.routes == std::vector<std::string>{"a proof", "another (witness)"});
    const Evaluation none = evaluate(known_by({.proofs = {proves(third)}, .witnesses = {wrong, cannot, off}}), inputs({}), {.digits = 12});
    CHECK_FALSE(none.second_look->agrees);
    CHECK(none.second_look->name == "an estimate");
    CHECK(none.note.find("'an estimate' DISAGREES") != std::string::npos);
    Look vague = sees(third + power(Rational(10), -9), power(Rational(10), -8)); // would agree with what is off by 10^-7 too
    vague.name = "a vague one";
    CHECK_FALSE(
        evaluate(known_by({.proofs = {proves(third)}, .witnesses = {wrong, vague}}), inputs({}), {.digits = 12}).second_look->agrees);

    // an error that the witness knows of is no disagreement, and one that cannot look is missed
    CHECK(evaluate(known_by({.proofs = {proves(third)}, .witnesses = {sees(third + power(Rational(10), -9), power(Rational(10), -10))}}),
                   inputs({}), {.digits = 12})
              .second_look->agrees);
    const Look blind{"blind", [](Accuracy) -> Witness { throw BeyondReach("no grid"); }};
    const Evaluation alone = evaluate(known_by({.proofs = {proves(third)}, .witnesses = {blind}}), inputs({}), {.digits = 12});
    CHECK(alone.status == Status::certified);
    CHECK(alone.note == "no second look: no grid");
}

TEST_CASE("a witness is asked for what a second proof would be, and two digits more, as far as witnesses go")
{
    for (const auto& [digits, asked] : {std::pair{5L, 7L}, {12L, 12L}, {22L, 13L}, {40L, 15L}}) {
        long seen = 0;
        const Look look{"an estimate", [&seen](Accuracy a) {
                            seen = a.digits;
                            return Witness{Ball(third), Ball(tiny)};
                        }};
        evaluate(known_by({.proofs = {proves(third)}, .witnesses = {look}}), inputs({}), {.digits = digits});
        CHECK(seen == asked);
    }
}

TEST_CASE("what a proof certifies does not depend on the precision it begins with, however many bits that is")
{
    for (const bool dear : {false, true})
        for (const slong bits : {2, 40, 300, 3000}) {
            CAPTURE(dear);
            CAPTURE(bits);
            std::vector<long> asked;
            const Proof unlimited = proves(third, 0, &asked);
            const Proof to_thirty{"a proof", [=](Accuracy a) {
                                      if (a.digits > 30) throw BeyondReach("no more than thirty");
                                      return unlimited.ball(a);
                                  }};
            const Evaluation e = evaluate(known_by({.proofs = {to_thirty}, .dear = dear}), inputs({}), {.digits = 20, .start_bits = bits});
            CHECK(e.status == Status::certified);
            CHECK(e.value == "0.33333333333333333333");
            if (!dear) continue;
            CHECK(asked.front() >= 1); // however few bits that is
            asked.clear();
            evaluate(known_by({.proofs = {unlimited}, .dear = dear}), inputs({}), {.digits = 20, .limit_bits = bits});
            CHECK(*std::min_element(asked.begin(), asked.end()) >= 1);
        }
    // a limit of the caller's is not said to be the method's
    const Plan few{.proofs = {proves(third)}, .most_digits = 40, .dear = true};
    CHECK(evaluate(known_by(few), inputs({}), {.digits = 20, .limit_bits = 80}).note.find("--max-precision") != std::string::npos);
}

TEST_CASE("a second proof that refuses leaves no digit certified, and a witness that sees nothing does not agree")
{
    const Proof refuses{"another proof", [](Accuracy) -> Ball { throw BeyondReach("no second proof here"); }};
    for (const bool dear : {false, true}) {
        const Evaluation alone = evaluate(known_by({.proofs = {proves(third), refuses}, .dear = dear}), inputs({}), {.digits = 12});
        CHECK(alone.status == Status::undecided);
        CHECK(alone.value == "0.333333333333");
        CHECK(alone.note.find("no second proof here") != std::string::npos);
        CHECK_FALSE(alone.second_look);
    }
    const auto nothing = [](const Ball& value, const Ball& error) {
        return Look{"blind", [=](Accuracy) { return Witness{value, error}; }};
    };
    for (const Look& blind : {nothing(Ball::indeterminate(), Ball(tiny)), nothing(Ball(third), Ball::indeterminate())}) {
        const Evaluation e = evaluate(known_by({.proofs = {proves(third)}, .witnesses = {blind}}), inputs({}), {.digits = 12});
        CHECK(e.status == Status::certified);
        CHECK_FALSE(e.second_look);
        CHECK(e.note == "no second look: 'blind' has no value here");
    }
}

TEST_CASE("two proofs have to agree, and two estimates never make one")
{
    CHECK_THROWS_AS(evaluate(known_by({.proofs = {proves(third), proves(third + Rational(1, 1000))}}), inputs({})), RoutesDisagree);
    const Evaluation both = evaluate(known_by({.proofs = {proves(third), proves(third)}}), inputs({}));
    REQUIRE(both.second_look);
    CHECK(both.second_look->is_proof);
    const Evaluation guessed =
        evaluate(known_by({.witnesses = {sees(third, tiny), sees(third, tiny)}, .refusal = "nobody tried"}), inputs({}), {.digits = 10});
    CHECK(guessed.status == Status::estimated);
    CHECK_FALSE(guessed.proven);
    CHECK_FALSE(guessed.second_look);
    const Evaluation nothing = evaluate(known_by({.refusal = "nobody tried"}), inputs({}), {.digits = 10});
    CHECK(nothing.status == Status::undecided);
    CHECK(nothing.note == "nobody tried");
    CHECK_FALSE(nothing.proven);
}

TEST_CASE("more digits than are certified: those that are, and the reason; never unproven ones")
{
    const std::vector<Look> witnesses{sees(third, tiny), sees(third, tiny)};
    const Evaluation e =
        evaluate(known_by({.proofs = {proves(third)}, .witnesses = witnesses, .most_digits = 12, .refusal = "the mesh ends there"}),
                 inputs({}), {.digits = 25});
    CHECK(e.status == Status::undecided);
    CHECK(e.value == "0.333333333333");
    CHECK(e.digits == 12);
    CHECK(e.proven);
    CHECK(e.note == "12 digits are certified here, 25 were asked for: the mesh ends there");
    // a proof that refuses so many only when it is asked
    const Proof refuses{"a proof", [](Accuracy a) {
                            if (a.digits > 20) throw BeyondReach("too dear");
                            return proves(third).ball(a);
                        }};
    const Evaluation fewer = evaluate(known_by({.proofs = {refuses}, .witnesses = witnesses}), inputs({}), {.digits = 25});
    CHECK(fewer.digits == 15);
    CHECK(fewer.proven);
    CHECK(fewer.note == "15 digits are certified here, 25 were asked for: too dear");
    // few digits are had although binary64 wants more than there are
    const Proof short_of_binary64{"a proof", [](Accuracy a) {
                                      if (a.digits > 16) throw BeyondReach("16 digits are proven");
                                      return proves(third).ball(a);
                                  }};
    const Evaluation few = evaluate(known_by({.proofs = {short_of_binary64}, .witnesses = witnesses}), inputs({}), {.digits = 6});
    CHECK(few.status == Status::certified);
    CHECK(few.value == "0.333333");
    CHECK(few.note.empty());
}

TEST_CASE("fewer digits never cost more: nothing dear is computed for the sake of binary64")
{
    const Rational tie = 1 + power(Rational(2), -53) + power(Rational(10), -40); // next to the middle of two binary64 numbers
    for (const bool dear : {false, true})
        for (const Rational& value : {third, tie}) {
            CAPTURE(dear);
            CAPTURE(value.get_str());
            long most = 0;
            for (const long digits : {30L, 20L, 12L, 5L, 1L}) {
                std::vector<long> asked;
                const Evaluation e =
                    evaluate(known_by({.proofs = {proves(value, 0, &asked)}, .dear = dear}), inputs({}), {.digits = digits});
                CHECK(e.status == Status::certified);
                REQUIRE_FALSE(asked.empty());
                if (dear) CHECK(asked == std::vector<long>{digits});
                else if (value == third) CHECK(asked.size() == 1);
                if (dear || value == third) {
                    if (digits < 30) CHECK(asked.back() <= most);
                    most = asked.back();
                }
                if (!dear) CHECK(e.binary64 == nearest_double(value));
            }
        }
}

TEST_CASE("a ball that more accuracy does not narrow is not asked for again and again: what a method never proves is not searched for")
{
    std::vector<long> asked;
    const Plan rate_leaves_nine{.proofs = {proves(third, power(Rational(10), -10), &asked)}, .most_digits = 9};
    const Evaluation e = evaluate(known_by(rate_leaves_nine), inputs({}), {.digits = 4});
    CHECK(e.value == "0.3333");
    CHECK(asked == std::vector<long>{4}); // and binary64 is beyond it
    asked.clear();
    const Rational tie = Rational(1, 2) + power(Rational(10), -5) / 2; // within its ball
    const Plan next_to_a_tie{.proofs = {proves(tie, power(Rational(10), -10), &asked)}, .most_digits = 9};
    CHECK(evaluate(known_by(next_to_a_tie), inputs({}), {.digits = 5}).status == Status::undecided);
    CHECK(asked.back() <= 17);
}

TEST_CASE("at G = 2 the largest half-width tends to 1/2, and its proofs do not stop where no ball tells it from that")
{
    for (const auto& [n, load, value] : {std::tuple{"3", "0.5", "0.406980"},
                                         {"20000", "0.5", "0.500000"},
                                         {"20000", "0.9999999999999999999", "0.500000"},
                                         {"20000", "1e-300", "0.500000"}}) {
        CAPTURE(n);
        const Evaluation e = eval("segments.max_half_width", inputs({{"n", n}, {"load", load}, {"G", "2"}}), {.digits = 6});
        CHECK(e.status == Status::certified);
        CHECK(e.value == value);
        CHECK(e.bits <= 256);
    }
}

TEST_CASE("areas from the limit answer few digits at once, whatever more of them would take")
{
    for (const auto& [n, load, G, value] : {std::tuple{"100", "1.2", "2.6", "4.4e-42"},
                                            {"70", "2", "10", "7.9e-70"},
                                            {"5", "1000", "100000", "2.3e-18"}}) { // the last by panels, at the end of their reach
        CAPTURE(G);
        const Evaluation e = eval("contact.area", inputs({{"n", n}, {"load", load}, {"G", G}}), {.digits = 2});
        CHECK(e.status == Status::certified);
        CHECK(e.value == value);
        CHECK(e.bits < 128);
    }
}

TEST_CASE("a second proof that is asked for fewer digits confirms those, and has to")
{
    const auto looks_again = [](const Rational& value, const Rational& radius) {
        Proof p = proves(value, radius);
        p.digits = 10;
        return p;
    };
    const EvaluationOptions thirty{.digits = 30, .limit_bits = 800};
    const Evaluation e = evaluate(known_by({.proofs = {proves(third), looks_again(third, power(Rational(10), -13))}}), inputs({}), thirty);
    CHECK(e.status == Status::certified);
    CHECK(e.digits == 30);
    REQUIRE(e.second_look);
    CHECK(e.second_look->digits == 10);
    const Evaluation wide =
        evaluate(known_by({.proofs = {proves(third), looks_again(third, power(Rational(10), -8))}}), inputs({}), thirty);
    CHECK(wide.status == Status::undecided); // not even ten digits
    const Rational off = third + power(Rational(10), -12);
    CHECK_THROWS_AS(evaluate(known_by({.proofs = {proves(third), looks_again(off, power(Rational(10), -13))}}), inputs({}), thirty),
                    RoutesDisagree);
    std::vector<long> asked;
    Proof counts = proves(third, 0, &asked);
    counts.digits = 10;
    evaluate(known_by({.proofs = {proves(third), counts}}), inputs({}), thirty);
    CHECK(asked == std::vector<long>{10});
    // one that stays a little wide is asked for more when the first is, and not for the same again and again
    Proof wider = proves(third, power(Rational(10), -9), &asked);
    wider.digits = 10;
    const EvaluationOptions to_eighty{.digits = 30, .limit_bits = 300};
    asked.clear();
    CHECK(evaluate(known_by({.proofs = {proves(third), wider}}), inputs({}), to_eighty).status == Status::undecided);
    REQUIRE(asked.size() > 1);
    CHECK(asked[1] > asked[0]);
    CHECK(std::is_sorted(asked.begin(), asked.end()));
    // a dear first proof that has decided is not asked again while the second is
    std::vector<long> first_asked;
    asked.clear();
    CHECK(evaluate(known_by({.proofs = {proves(third, 0, &first_asked), wider}, .dear = true}), inputs({}), to_eighty).status ==
          Status::undecided);
    CHECK(asked.size() > 1);
    CHECK(first_asked == std::vector<long>{30});
    // asked for fewer itself, it is a proof like the first, binary64 and all
    const Evaluation one = evaluate(known_by({.proofs = {proves(third), counts}}), inputs({}), {.digits = 1});
    CHECK(asked.back() == 18);
    CHECK(one.binary64 == 1. / 3);
}

TEST_CASE("what is shown undecided, and binary64, rest on every proof")
{
    // the second proof knows 4 digits at any accuracy: no more are shown, and no double
    const Evaluation e = evaluate(known_by({.proofs = {proves(third), proves(third, power(Rational(10), -6))}}), inputs({}),
                                  {.digits = 10, .limit_bits = 400});
    CHECK(e.status == Status::undecided);
    CHECK(e.digits <= 5);
    CHECK(e.value.starts_with("0.333"));
    CHECK_FALSE(e.binary64);
}

TEST_CASE("G is compared exactly")
{
    CHECK(inputs({{"gamma", "4"}, {"D", "1.5"}}).compare_G(2) == 0);
    CHECK(inputs({{"gamma", "4"}, {"D", "1.49999999999999999999999999999999"}}).compare_G(2) == -1);
    CHECK(inputs({{"gamma", "256"}, {"D", "1.25"}}).compare_G(4) == 0);
    CHECK(inputs({{"gamma", "10"}, {"D", "0x1.0cccccccccccdp+0"}}).compare_G(2) == -1);
}

TEST_CASE("inputs are brought to lowest terms, and a denominator 0 is no number")
{
    const Inputs in({{"n", Rational(6, 2)}, {"G", Rational(102, 100)}, {"p", Rational(Integer(1), Integer(-3))}});
    CHECK(in.integer("n") == 3);
    CHECK(in.real("G").get_den() == 50);
    CHECK(in.real("p") < 0);
    CHECK(in.compare_G(Rational(204, 200)) == 0);
    CHECK(inputs({{"gamma", "4"}, {"D", "1.5"}}).compare_G(Rational(6, 3)) == 0);
    CHECK(inputs({{"G", "1.02"}}).compare_G(Rational(102, 100)) == 0);
    CHECK(eval("archard.K", Inputs({{"n", Rational(6, 2)}}), {.digits = 10}).value ==
          eval("archard.K", inputs({{"n", "3"}}), {.digits = 10}).value);
    Rational nothing;
    mpz_set_ui(mpq_denref(nothing.get_mpq_t()), 0);
    CHECK_THROWS_AS(Inputs({{"G", nothing}}), std::invalid_argument);
}
