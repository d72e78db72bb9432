// SPDX-License-Identifier: GPL-3.0-or-later
// What the program itself rests on: every lemma is proved or verified, every perturbed constant is refuted, and a judge that accepts
// anything is found out.
#include "proofs/operator/own.hpp"
#include "proofs/recorded.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

using namespace touchstone::proofs;

TEST_CASE("every lemma and every constant holds, and each perturbed one is refuted")
{
    std::set<std::string> ids;
    std::size_t controls = 0;
    std::vector<CheckedLemma> all;
    for (const OwnClaim& c : own_claims()) {
        CAPTURE(c.id);
        CHECK(ids.insert(c.id).second);
        CHECK_FALSE(c.constants.empty());
        const auto start = std::chrono::steady_clock::now();
        const CheckedLemma e = run(c);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (seconds > 1) MESSAGE(c.id << " took " << seconds << " s");
        for (const std::string& failure : e.failures()) FAIL_CHECK(c.id << ": " << failure);
        controls += e.controls.size();
        all.push_back(e);
    }
    std::ifstream in(std::string(TOUCHSTONE_DATA) + "/paper/own.txt");
    const std::string recorded{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}, now = recorded_form(all);
    CHECK(recorded == now); // after a change that is meant: write what is printed here to data/paper/own.txt
    CHECK(ids.size() >= 60);
    CHECK(controls >= ids.size());
}

TEST_CASE("each constant of each statement has a control")
{
    for (const OwnClaim& c : own_claims()) {
        CAPTURE(c.id);
        std::set<std::size_t> perturbed;
        for (const auto& k : c.controls) {
            perturbed.insert(k.which);
            CHECK(k.value != c.constants.at(k.which).value);
        }
        CHECK(perturbed.size() == c.constants.size());
    }
}

TEST_CASE("a lemma with a wrong constant, and a judge that accepts anything, fail")
{
    const OwnClaim gullible{"gullible", "{0}", "", {{"constant", 1}}, [](const Constants&) { return Finding{Verdict::proved, "", {}, ""}; },
                            {{0, 2}}};
    CHECK(run(gullible).failures().size() == 1);
    for (const OwnClaim& c : own_claims())
        if (c.id == "wave::disc_partial") {
            OwnClaim wrong = c;
            wrong.constants[1].value = 0.77; // radius_kept
            CHECK_FALSE(run(wrong).failures().empty());
        }
    OwnClaim without{"without", "{0}", "", {{"constant", 1}}, gullible.judge, {}};
    CHECK(run(without).failures().size() == 1);
}
