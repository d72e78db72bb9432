// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone paper --own`: what the program itself rests on, each lemma and each constant proved, each perturbed constant refuted.
#include "proofs/operator/own.hpp"
#include "verify/exit_codes.hpp"
#include "verify/paper.hpp"
#include "verify/progress.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::program {
namespace {

using namespace touchstone::proofs;

std::vector<CheckedLemma> judge_own(const std::string& id)
{
    std::vector<const OwnClaim*> some;
    for (const OwnClaim& c : own_claims())
        if (id.empty() || c.id == id) some.push_back(&c);
    if (some.empty()) throw Failure(bad_input, fmt::format("no lemma '{}'; `touchstone paper --own` lists them", id));
    Progress progress("judging lemmas", some.size());
    std::vector<CheckedLemma> entries;
    for (const OwnClaim* c : some) {
        entries.push_back(run(*c));
        progress.done(entries.size());
    }
    return entries;
}

nlohmann::ordered_json json_of(const CheckedLemma& e)
{
    nlohmann::ordered_json j = {{"id", e.claim->id},        {"verdict", name(e.finding.verdict)}, {"method", e.finding.method},
                                {"statement", e.statement}, {"reason", e.finding.reason},         {"used_in", e.claim->used_in},
                                {"steps", e.finding.steps}};
    j["constants"] = nlohmann::ordered_json::object();
    for (const Constant& c : e.claim->constants) j["constants"][c.name] = c.value;
    j["controls"] = nlohmann::ordered_json::array();
    for (const auto& k : e.controls)
        j["controls"].push_back({{"what", k.what}, {"verdict", name(k.finding.verdict)}, {"reason", k.finding.reason}});
    j["failures"] = e.failures();
    return j;
}

void explain(const CheckedLemma& e)
{
    fmt::print("{:<12} {}\n{:<12} {}\n{:<12} {}\n{:<12} {}\n{:<12} {}\n", "lemma", e.claim->id, "statement", e.statement, "used in",
               e.claim->used_in, "verdict", name(e.finding.verdict), "method", e.finding.method);
    if (!e.finding.reason.empty()) fmt::print("{:<12} {}\n", "reason", e.finding.reason);
    for (std::size_t i = 0; i < e.finding.steps.size(); ++i)
        fmt::print("{:<12} {}. {}\n", i == 0 ? "steps" : "", i + 1, e.finding.steps[i]);
    for (std::size_t i = 0; i < e.controls.size(); ++i)
        fmt::print("{:<12} {}: {} ({})\n", i == 0 ? "controls" : "", e.controls[i].what, name(e.controls[i].finding.verdict),
                   e.controls[i].finding.reason);
}

} // namespace

int print_own(const std::string& id, bool json)
{
    const std::vector<CheckedLemma> entries = judge_own(id);
    std::size_t controls = 0, refuted = 0, failed = 0, proved = 0;
    for (const CheckedLemma& e : entries) {
        controls += e.controls.size();
        refuted += static_cast<std::size_t>(
            std::count_if(e.controls.begin(), e.controls.end(), [](const auto& k) { return k.finding.verdict == Verdict::refuted; }));
        failed += e.failures().size();
        proved += e.finding.verdict == Verdict::proved ? 1 : 0;
    }
    if (json) {
        nlohmann::ordered_json all = nlohmann::ordered_json::array();
        for (const CheckedLemma& e : entries) all.push_back(json_of(e));
        fmt::print("{}\n", all.dump());
        return failed == 0 ? holds : fails;
    }
    if (!id.empty()) explain(entries.front());
    else {
        fmt::print("what the program itself rests on\n");
        for (const CheckedLemma& e : entries) {
            fmt::print("  {:<9} {:<32} {}\n", name(e.finding.verdict), e.claim->id, e.statement);
            if (!e.controls.empty()) {
                fmt::print("  {:<9} {:<32}", "", "");
                const char* separator = " refuted: ";
                for (const auto& k : e.controls) {
                    fmt::print("{}{}", separator, k.what);
                    separator = "; ";
                }
                fmt::print("\n");
            }
        }
    }
    for (const CheckedLemma& e : entries)
        for (const std::string& f : e.failures()) fmt::print("FAILED {}: {}\n", e.claim->id, f);
    fmt::print("{} lemmas and constants: {} proved, {} verified at points; {} perturbed constants, {} refuted\n", entries.size(), proved,
               entries.size() - proved, controls, refuted);
    if (failed == 0 && id.empty())
        fmt::print("`touchstone paper --own wave::size` explains one; docs/method.md says how they make a proof\n");
    return failed == 0 ? holds : fails;
}

} // namespace touchstone::program
