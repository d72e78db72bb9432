// SPDX-License-Identifier: GPL-3.0-or-later
// Of the changes a typesetter makes in an equation, a table entry or a formula beyond the paper none comes out as anything but refuted, except
// those that data/paper/excuses.json excuses one by one.
#include "proofs/mutation/survivors.hpp"
#include "proofs/mutation/typesetter.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

using namespace touchstone::proofs;

namespace {

std::vector<const Claim*> formulas()
{
    std::vector<const Claim*> some;
    for (const Claim& c : claims())
        if (prints().at(c.id).quote.empty()) some.push_back(&c);
    return some;
}

void no_survivor(const Mutation& m)
{
    for (const Survivor& s : m.survivors) {
        CAPTURE(s.id);
        CAPTURE(s.change);
        CAPTURE(s.verdict);
        CAPTURE(s.reason);
        CHECK_FALSE(s.excuse.empty());
        CHECK(s.verdict != "exception");
    }
}

} // namespace

// The whole: test_mutation --no-skip, ctest -R mutation_campaign.
TEST_CASE("every change" * doctest::skip())
{
    const Mutation m = mutate(formulas());
    CHECK(m.changes > 3500);
    no_survivor(m);
    for (const std::string& idle : m.idle_excuses) {
        CAPTURE(idle);
        CHECK(false); // an excuse that no survivor needs
    }
}

TEST_CASE("one change in twenty")
{
    const Mutation m = mutate(formulas(), 20, 7);
    CHECK(m.changes > 150);
    no_survivor(m);
}

TEST_CASE("an excuse that matches no survivor is found, and so is a survivor without one")
{
    const auto is = [](const char* id) { return [id](const Claim& c) { return c.id == id; }; };
    const Claim& with_excuse = *std::find_if(claims().begin(), claims().end(), is("3.3"));
    CHECK(mutate({&with_excuse}).idle_excuses.empty());
    CHECK(mutate({&with_excuse}).unexcused() == 0);
    Claim strict = with_excuse; // a judge that refutes all leaves the excuses idle
    strict.judge = [](const Print&) { Finding f; f.verdict = Verdict::refuted; return f; };
    CHECK(mutate({&strict}).idle_excuses.size() == 2);
    Claim gullible = *std::find_if(claims().begin(), claims().end(), is("table1.n07")); // no reader stands behind this one
    gullible.judge = [](const Print&) { Finding f; f.verdict = Verdict::verified; return f; };
    CHECK(mutate({&gullible}).unexcused() == mutate({&gullible}).changes);
}

TEST_CASE("the typesetter's kinds of change all occur, and each change reads differently")
{
    std::map<std::string, int> kinds;
    for (const Claim* c : formulas())
        for (const Change& change : typesetters_changes(prints().at(c->id))) ++kinds[change.kind];
    for (const char* kind : {"digit", "sign", "function", "index", "symbol", "bound", "relation", "condition", "factor", "lost root", "lost square", "fraction"}) {
        CAPTURE(kind);
        CHECK(kinds[kind] > 0);
    }
    for (const Change& change : typesetters_changes(prints().at("7.18"))) CHECK(change.print.fields != prints().at("7.18").fields);
}
