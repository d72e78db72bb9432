// SPDX-License-Identifier: GPL-3.0-or-later
#include "finders.hpp"

#include "proofs/ledger.hpp"
#include "proofs/operator/own.hpp"
#include "proofs/recorded.hpp"

#include <fstream>
#include <iterator>

namespace {

using namespace touchstone::proofs;

bool claim_finds(const Claim& c)
{
    const Entry e = run(c, prints().at(c.id));
    const std::string recorded = recorded_form({e}), entry = recorded.substr(recorded.find('\n') + 1);
    return e.finding.verdict != expected_verdict(c.id) || !e.surviving().empty() || recorded_text().find(entry) == std::string_view::npos;
}

bool own_claim_finds(const OwnClaim& c)
{
    static const std::string recorded = [] {
        std::ifstream in(TOUCHSTONE_DATA "/paper/own.txt");
        return std::string{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }();
    const CheckedLemma e = run(c);
    const std::string text = recorded_form(std::vector<CheckedLemma>{e});
    return !e.failures().empty() || recorded.find(text.substr(text.find('\n') + 1)) == std::string::npos;
}

/// Numbers in the words of a correction are put together when the claims are: a look at the record alone finds them.
bool consequence_differs(const Claim& c)
{
    return c.correction && !c.correction->consequence.empty() &&
           recorded_text().find("  consequence: " + c.correction->consequence + "\n") == std::string_view::npos;
}

} // namespace

std::vector<Finder> finders_of_the_ledger()
{
    std::vector<Finder> all;
    for (const Claim& c : claims()) all.push_back({c.id + "'s consequence", [&c] { return consequence_differs(c); }});
    for (const Claim& c : claims()) all.push_back({c.id, [&c] { return claim_finds(c); }});
    for (const OwnClaim& c : own_claims()) all.push_back({c.id, [&c] { return own_claim_finds(c); }});
    return all;
}
