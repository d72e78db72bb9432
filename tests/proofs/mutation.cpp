// SPDX-License-Identifier: GPL-3.0-or-later
// Of the changes a typesetter makes in an equation, a table entry, a sentence, a figure's claim or a formula beyond the paper none comes
// out as anything but refuted, except those that data/paper/excuses.json excuses one by one.
#include "proofs/mutation/survivors.hpp"
#include "proofs/mutation/typesetter.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

using namespace touchstone::proofs;

namespace {

std::vector<const Claim*> everything()
{
    std::vector<const Claim*> all;
    for (const Claim& c : claims()) all.push_back(&c);
    return all;
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

TEST_CASE("every change of every entry")
{
    const Mutation m = mutate(everything());
    CHECK(m.changes > 4700);
    no_survivor(m);
    for (const std::string& idle : m.idle_excuses) {
        CAPTURE(idle);
        CHECK(false); // an excuse that no survivor needs
    }
}

TEST_CASE("every sentence with a machine form is changed")
{
    for (const Claim* c : everything()) {
        const Print& p = prints().at(c->id);
        CAPTURE(c->id);
        if (p.parts() > 0) CHECK(typesetters_changes(p).size() > 0);
    }
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
    for (const Claim* c : everything())
        for (const Change& change : typesetters_changes(prints().at(c->id))) ++kinds[change.kind];
    for (const char* kind : {"digit", "sign", "function", "index", "symbol", "bound", "relation", "condition", "factor", "lost root",
                             "lost square", "fraction"}) {
        CAPTURE(kind);
        CHECK(kinds[kind] > 0);
    }
    for (const Change& change : typesetters_changes(prints().at("7.18"))) CHECK(change.print.fields != prints().at("7.18").fields);
}
