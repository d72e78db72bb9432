// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/recorded.hpp"

#include "proofs/severity.hpp"

#include <map>
#include <sstream>
#include <stdexcept>

namespace touchstone::data {
std::string_view verdicts_text();
}

namespace touchstone::proofs {

std::string_view recorded_text() { return data::verdicts_text(); }

namespace {

/// "x in [0, 1]" of a step that subdivision proved (enclosure.cpp), else empty: a range made smaller says less, and no control can see it.
std::string range_of(const std::string& step)
{
    const std::string before = "enclosed for ";
    const std::size_t from = step.find(before);
    if (from == std::string::npos) return {};
    const std::size_t start = from + before.size();
    return step.substr(start, step.rfind(" in ", step.find(" pieces", start)) - start);
}

std::string ranges_of(const Finding& f)
{
    std::string all;
    for (const std::string& step : f.steps)
        if (const std::string range = range_of(step); !range.empty()) all += "  range: " + range + "\n";
    return all;
}

} // namespace

std::string recorded_form(const std::vector<CheckedLemma>& lemmas)
{
    std::ostringstream out;
    out << "# What our own lemmas rest on, held by tests/proofs/operator.cpp: a smaller range says less, and no control can see it.\n";
    for (const CheckedLemma& e : lemmas) out << e.claim->id << " " << name(e.finding.verdict) << "\n" << ranges_of(e.finding);
    return out.str();
}

std::string recorded_form(const std::vector<Entry>& entries)
{
    std::ostringstream out;
    out << "# The verdicts of the ledger, written by touchstone paper --verdicts. A change of this file is a change of what we say of the paper.\n";
    for (const Entry& e : entries) {
        const auto& c = e.claim->correction;
        out << e.claim->id << " " << name(e.finding.verdict);
        if (c) out << " " << severity(*c);
        out << "\n";
        if (!same_as(e.claim->id).empty()) out << "  same as: " << same_as(e.claim->id) << "\n";
        if (c) out << "  wrong: " << c->wrong << "\n  holds, " << name(e.corrected->verdict) << ": " << c->corrected << "\n";
        if (c && !c->consequence.empty()) out << "  consequence: " << c->consequence << "\n";
        if (!caveat(e.claim->id).empty()) out << "  caveat: " << caveat(e.claim->id) << "\n";
        if (!e.finding.method.empty()) out << "  by: " << e.finding.method << "\n";
        for (const std::string& lemma : e.finding.lemmas) out << "  lemma: " << lemma.substr(0, lemma.find(':')) << "\n";
        out << ranges_of(e.finding);
        if (!e.finding.rows.empty()) out << "  stored values: " << e.finding.rows.size() << "\n";
    }
    return out.str();
}

Verdict expected_verdict(const std::string& id)
{
    static const std::map<std::string, std::string> recorded = [] {
        std::map<std::string, std::string> all;
        std::istringstream lines(std::string{recorded_text()});
        for (std::string line; std::getline(lines, line);) { // "ID verdict ...", what is indented says more
            if (line.empty() || line[0] == '#' || line[0] == ' ') continue;
            std::istringstream words(line);
            std::string entry, verdict;
            words >> entry >> verdict;
            all[entry] = verdict;
        }
        return all;
    }();
    const std::string& wanted = recorded.at(id);
    for (const Verdict v : {Verdict::proved, Verdict::verified, Verdict::argued, Verdict::refuted, Verdict::definition, Verdict::qualitative, Verdict::undecided})
        if (name(v) == wanted) return v;
    throw std::out_of_range("not a verdict: " + wanted);
}

} // namespace touchstone::proofs
