// SPDX-License-Identifier: GPL-3.0-or-later
// A judge of a sentence judges what is said: a weaker true bound is not refuted, a false one is.
#include "proofs/ledger.hpp"
#include "proofs/lemmas/area_bounds.hpp"
#include "proofs/sentences/sentences.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace touchstone::proofs;

namespace {

Verdict verdict_of(const char* id, const std::vector<Edit>& edits)
{
    const auto claim = std::find_if(claims().begin(), claims().end(), [id](const Claim& c) { return c.id == id; });
    return judge_whole(*claim, prints().at(id).edited(edits)).verdict;
}

/// Without the reader of the whole print, who sees much of it too.
Finding by_the_judge_alone(const char* id, const std::vector<Edit>& edits)
{
    const auto claim = std::find_if(claims().begin(), claims().end(), [id](const Claim& c) { return c.id == id; });
    return claim->judge(prints().at(id).edited(edits));
}

bool holds(Verdict v) { return v == Verdict::proved || v == Verdict::argued; }

} // namespace

TEST_CASE("a bound that is weaker than the proved one is true")
{
    CHECK(holds(verdict_of("text.light-load-steeper", {{"rhs", "1/(4*G^2)", "1/(5*G^2)"}})));
    CHECK(holds(verdict_of("text.light-load-steeper", {{"rhs", "1/(4*G^2)", "1/(4*G^3)"}})));
    CHECK(holds(verdict_of("text.several-scales", {{"rhs", "-2*m", "-3*m"}})));
    CHECK(holds(verdict_of("text.apparent-lower", {{"rhs", "1/G^2", "1/(2*G^2)"}})));
    CHECK(holds(verdict_of("text.apparent-lower", {{"rhs", "1/G^2", "2/G^2"}})));
    CHECK(holds(verdict_of("text.pstar-increases", {{"relation", ">", ">="}})));
    CHECK(holds(verdict_of("text.constant-decreases", {{"relation", "<", "<="}})));
    CHECK(holds(verdict_of("text.increasingly-hertzian", {{"relation", "=", "<"}, {"rhs", "1", "2"}})));
    CHECK(holds(verdict_of("text.full-contact-vanishes", {{"relation", "=", ">="}})));
    CHECK(holds(verdict_of("text.defines-limit", {{"relation", "=", "<"}, {"rhs", "1", "100"}})));
    CHECK(holds(verdict_of("text.area-decreases", {{"rhs", "A_n", "2*A_n"}})));
    CHECK(holds(verdict_of("text.conditional-contact", {{"relation", "=", "<"}, {"rhs", "1", "2"}})));
    CHECK(holds(verdict_of("text.delta-limit", {{"relation", "=", "<="}})));
    CHECK(holds(verdict_of("text.area-vanishes", {{"relation", "=", "<"}, {"rhs", "0", "1"}})));
    CHECK(holds(verdict_of("text.mean-pressure", {{"relation", "=", "<"}, {"rhs", "pbar", "2*pbar"}})));
    CHECK(holds(verdict_of("text.limiting-slope", {{"relation", "=", "<"}, {"rhs", "-(D-1)", "-1/2*(D-1)"}})));
    CHECK(holds(verdict_of("text.several-scales", {{"rhs", "gamma^(-2*m)", "gamma^(-2*m)/Pi"}})));
    CHECK(verdict_of("text.limit-0.39139", {{"rhs", "0.39139", "0.391388"}}) == Verdict::verified);
}

TEST_CASE("a bound that is false is refuted")
{
    CHECK(verdict_of("text.light-load-steeper", {{"rhs", "1/(4*G^2)", "2*(1+G)"}}) == Verdict::refuted);
    CHECK(verdict_of("text.light-load-steeper", {{"rhs", "1/(4*G^2)", "-1/(4*G^2)"}}) == Verdict::refuted);
    CHECK(verdict_of("text.several-scales", {{"rhs", "gamma^(-2*m)", "1"}}) == Verdict::refuted);
    CHECK(verdict_of("text.several-scales", {{"rhs", "-2*m", "-m"}}) == Verdict::refuted); // the counterexample is at gamma = 5 alone
    CHECK(verdict_of("text.apparent-lower", {{"rhs", "1/G^2", "10/G^2"}}) == Verdict::refuted);
    CHECK(verdict_of("text.increasingly-hertzian", {{"relation", "=", "<"}, {"rhs", "1", "0"}}) == Verdict::refuted);
    CHECK(verdict_of("text.increasingly-hertzian", {{"relation", "=", ">"}, {"rhs", "1", "2"}}) == Verdict::refuted);
    CHECK(verdict_of("text.full-contact-vanishes", {{"relation", "=", "<"}}) == Verdict::refuted);
    CHECK(verdict_of("text.full-contact-vanishes", {{"relation", "=", ">"}, {"rhs", "0", "2"}}) == Verdict::refuted);
    CHECK(verdict_of("text.defines-limit", {{"relation", "=", ">"}, {"rhs", "1", "100"}}) == Verdict::refuted);
    CHECK(verdict_of("text.defines-limit", {{"relation", "=", ">"}, {"rhs", "1", "2"}}) == Verdict::refuted);
    CHECK(verdict_of("text.light-load-steeper", {{"rhs", "1/(4*G^2)", "1/(4*G)"}}) == Verdict::refuted);
    CHECK(verdict_of("text.several-scales", {{"rhs", "gamma^(-2*m)", "2*gamma^(-2*m)"}}) == Verdict::refuted);
    CHECK(verdict_of("text.peak-at-centre", {{"lhs", "cos(2*", "cos(3*"}, {"condition", "integer", "odd"}}) == Verdict::refuted);
    CHECK(verdict_of("text.area-decreases", {{"relation", "<=", "<"}}) == Verdict::refuted); // not while contact is full
    CHECK(verdict_of("text.area-decreases", {{"relation", "<=", ">"}}) == Verdict::refuted);
    CHECK(verdict_of("text.area-decreases", {{"relation", "<=", "="}}) == Verdict::refuted);
    CHECK(verdict_of("text.area-decreases", {{"relation", "<=", "="}, {"rhs", "A_n", "A_n/2"}}) == Verdict::refuted);
    CHECK(verdict_of("text.area-decreases", {{"rhs", "A_n", "A_n/2"}}) == Verdict::refuted);
    CHECK(verdict_of("text.area-decreases", {{"rhs", "A_n", "A_n+1"}}) == Verdict::refuted);
    CHECK(verdict_of("text.limiting-slope", {{"relation", "=", "<"}, {"rhs", "-(D-1)", "-2*(D-1)"}}) == Verdict::refuted);
    CHECK(verdict_of("text.limiting-slope", {{"relation", "=", "<"}}) == Verdict::refuted);
    CHECK(verdict_of("text.delta-limit", {{"relation", "=", "<"}}) == Verdict::refuted);
    CHECK(verdict_of("text.several-scales", {{"rhs", "gamma^(-2*m)", "Pi*gamma^(-2*m)"}}) == Verdict::refuted);
    CHECK(verdict_of("text.full-contact-persists", {{"rhs", "1", "1/2"}}) == Verdict::refuted); // at n = 0 it is the load, whatever that is
    CHECK(verdict_of("text.limit-0.39139", {{"rhs", "0.39139", "0.391387"}}) == Verdict::refuted); // cut off, not rounded
    CHECK(verdict_of("text.limit-0.39139", {{"rhs", "0.39139", "0.3914"}}) == Verdict::refuted);   // to four places
}

TEST_CASE("a judge sees by itself that a bound is false")
{
    const auto refuted = [](const char* id, const std::vector<Edit>& edits) {
        return by_the_judge_alone(id, edits).verdict == Verdict::refuted;
    };
    CHECK(refuted("text.conditional-contact", {{"relation", "=", "<"}, {"rhs", "1", "1/2"}}));
    CHECK(refuted("text.conditional-contact", {{"relation", "=", ">"}, {"rhs", "1", "2"}}));
    CHECK(refuted("text.limiting-slope", {{"relation", "=", "<"}, {"rhs", "-(D-1)", "-2*(D-1)"}}));
    CHECK(refuted("text.limiting-slope", {{"relation", "=", ">"}, {"rhs", "-(D-1)", "-1/2*(D-1)"}}));
    CHECK_FALSE(
        holds(by_the_judge_alone("text.limiting-slope", {{"relation", "=", "<"}, {"rhs", "-(D-1)", "-1/2"}}).verdict)); // near D = 1
    CHECK(refuted("text.full-contact-persists", {{"rhs", "1", "3/2"}, {"condition", "n >= 0", "n >= n_0"}}));
    const Finding wide = by_the_judge_alone("text.fractal-domain", {{"1.rhs", "infinity", "5/2"}});
    CHECK(wide.verdict == Verdict::refuted);
    CHECK(wide.reason.find("diverges") != std::string::npos);
}

TEST_CASE("a bound is compared for all G > 1, and a lower end that only a radius makes negative is 0")
{
    const ex G = sym("G");
    CHECK_FALSE(at_most_for_all_G(1 / (16 * GiNaC::pow(G - 1, 2)), 1 / (4 * G * G))); // it is for G >= 2
    CHECK(at_most_for_all_G(1 / (5 * G * G), 1 / (4 * G * G)));
    CHECK(between(touchstone::hull(touchstone::Ball(0), touchstone::Ball(100))) == "0 to 100.00");
}

TEST_CASE("digits with dots are the first ones, and without them rounded")
{
    CHECK(holds(verdict_of("7.20", {{"1.digits", "0.39139...", "0.39138..."}, {"1.rhs", "0.39139", "0.39138"}})));
    CHECK(verdict_of("7.20", {{"1.digits", "0.39139...", "0.39137..."}, {"1.rhs", "0.39139", "0.39137"}}) == Verdict::refuted);
    CHECK(holds(verdict_of("7.20", {{"1.digits", "0.39139...", "0.391"}, {"1.rhs", "0.39139", "0.391"}}))); // off by 0.39 of a unit
    CHECK(verdict_of("7.20", {{"1.digits", "0.39139...", "0.39138"}, {"1.rhs", "0.39139", "0.39138"}}) == Verdict::refuted);
}

TEST_CASE("a share of full contacts is held by the rarer of the two: to climb above load 1, and to stay there")
{
    using touchstone::Ball, touchstone::Rational;
    const Ball G(Rational(11, 10)), far(Rational(4, 5)); // where staying is the rarer
    const Ball stay = acos(G - 1) / touchstone::pi<Ball>();
    CHECK(least_full_share(G, far).overlaps((1 - G * far) * stay * (G - 1) / (G * G)));
    CHECK(
        touchstone::certainly(less(least_full_share(G, Ball(Rational(3, 5))), (1 - G * 3 / 5) * stay * (G - 1) / (G * G)))); // climbing is
}

TEST_CASE("between what is proved and what is refuted nothing is claimed")
{
    CHECK(verdict_of("text.light-load-steeper", {{"rhs", "1/(4*G^2)", "1/(3*G^2)"}}) == Verdict::undecided);
    CHECK(verdict_of("text.light-load-steeper", {{"rhs", "1/(4*G^2)", "G/80"}}) ==
          Verdict::undecided); // at G = 100 above load 1, where A_1 may be below the Hertzian area
    CHECK(verdict_of("text.several-scales", {{"rhs", "gamma^(-2*m)", "3/2*gamma^(-2*m)"}}) == Verdict::undecided);
    // What bounds for every n would leave open, certified limits decide: 1.20 of (7.21) at gamma = 5, 1.09 at gamma = 10.
    CHECK(verdict_of("text.defines-limit", {{"relation", "=", ">"}, {"rhs", "1", "3/2"}}) == Verdict::refuted);
    CHECK(holds(verdict_of("text.defines-limit", {{"relation", "=", ">"}})));
}
