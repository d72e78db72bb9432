// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/paper_ledger.hpp"

#include "proofs/own/own_judge.hpp"
#include "verify/exit_codes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <map>

namespace touchstone::program {
namespace {

using namespace touchstone::proofs;

std::string says(const Print& p)
{
    if (p.parts() == 0) return "a table";
    std::string all = p.text("0.lhs");
    for (std::size_t i = 0; i < p.parts(); ++i)
        all += " " + p.text(std::to_string(i) + ".relation") + " " + p.text(std::to_string(i) + ".rhs");
    return all;
}

std::string right(const OwnEntry& e) { return says(e.print.edited(e.correction->edits)); }

/// A refuted print whose correction, if it has one, is not good either; an entry nothing is known of; a correction that is not needed.
std::string failure(const OwnResult& r)
{
    if (r.corrected && r.corrected->verdict == Verdict::refuted) return "the corrected form is refuted too: " + r.corrected->reason;
    if (r.corrected && r.finding.verdict != Verdict::refuted) return "a correction of what is not refuted";
    return "";
}

void print_result(const OwnResult& r)
{
    const OwnEntry& e = *r.entry;
    fmt::print("{:<11} {}  {}\n", name(r.finding.verdict), e.print.id, says(e.print));
    if (!r.finding.reason.empty() && r.finding.verdict != Verdict::proved && r.finding.verdict != Verdict::definition)
        fmt::print("            {}\n", r.finding.reason);
    if (r.corrected)
        fmt::print("            {}{}holds, {}: {}\n", e.correction->wrong, e.correction->wrong.empty() ? "" : "; ",
                   name(r.corrected->verdict), right(e));
    if (const std::string f = failure(r); !f.empty()) fmt::print("FAILED {}: {}\n", e.print.id, f);
}

nlohmann::ordered_json json_of(const OwnResult& r)
{
    const OwnEntry& e = *r.entry;
    nlohmann::ordered_json j = {{"id", e.print.id},           {"verdict", name(r.finding.verdict)},
                                {"method", r.finding.method}, {"statement", says(e.print)},
                                {"reason", r.finding.reason}, {"correction", r.corrected ? right(e) : ""},
                                {"print", e.print.tex},       {"rests_on", e.rests_on},
                                {"steps", r.finding.steps},   {"failures", nlohmann::json::array()}};
    if (r.corrected) j["correction_verdict"] = name(r.corrected->verdict);
    if (const std::string f = failure(r); !f.empty()) j["failures"].push_back(f);
    return j;
}

int print_mutation(const OwnLedger& ledger, const std::string& id)
{
    const OwnMutation m = mutate_own(ledger, id);
    int excused = 0;
    for (const OwnSurvivor& s : m.survivors) {
        if (s.excuse.empty()) fmt::print("SURVIVES as {:<11} {:<20} {}: {}\n", s.verdict, s.id, s.kind, s.change);
        excused += s.excuse.empty() ? 0 : 1;
    }
    for (const std::string& unjudged : m.unjudged)
        fmt::print("not judged  {}: a definition, and nothing says what it should be\n", unjudged);
    fmt::print("{} changes: {} refuted, {} excused, {} survive\n", m.changes, m.refuted, excused, m.unexcused());
    return m.unexcused() == 0 ? holds : fails;
}

int run(const std::string& dir, const std::string& id, bool json, bool mutate)
{
    const OwnLedger ledger = load_ledger(dir);
    if (!id.empty() && !ledger.has(id)) throw Failure(bad_input, fmt::format("no entry '{}' in {}", id, ledger.file));
    if (mutate) return print_mutation(ledger, id);
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    std::map<Verdict, int> count;
    bool failed = false;
    for (const OwnResult& r : judge_all(ledger)) {
        if (!id.empty() && r.entry->print.id != id) continue;
        if (json) all.push_back(json_of(r));
        else print_result(r);
        if (!json && !id.empty())
            for (const std::string& step : r.finding.steps) fmt::print("            {}\n", step);
        ++count[r.finding.verdict];
        failed = failed || !failure(r).empty();
    }
    if (json) {
        fmt::print("{}\n", !id.empty() ? all[0].dump() : all.dump());
    } else {
        fmt::print("\n{}{}{} entries:", ledger.title, ledger.title.empty() ? "" : ": ", ledger.entries.size());
        const char* comma = " ";
        for (const auto& [v, n] : count) {
            fmt::print("{}{} {}", comma, n, name(v));
            comma = ", ";
        }
        fmt::print("\n");
    }
    if (failed || count[Verdict::refuted] > 0) return fails;
    return count[Verdict::undecided] > 0 ? undecided : holds;
}

} // namespace

int run_own_ledger(const std::string& dir, const std::string& id, bool json, bool mutate)
{
    try {
        return run(dir, id, json, mutate);
    } catch (const OwnLedgerError& e) {
        throw Failure(e.no_file() ? no_input_file : bad_input, e.what());
    }
}

} // namespace touchstone::program
