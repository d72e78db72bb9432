// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/ledger.hpp"

#include "proofs/lemmas/stored_values.hpp"
#include "proofs/reading/reading.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace touchstone::proofs {

std::string_view name(Verdict v)
{
    switch (v) {
    case Verdict::proved: return "proved";
    case Verdict::verified: return "verified";
    case Verdict::refuted: return "refuted";
    case Verdict::argued: return "argued";
    case Verdict::definition: return "definition";
    case Verdict::qualitative: return "qualitative";
    case Verdict::undecided: return "undecided";
    }
    throw std::logic_error("not a verdict");
}

namespace {

/// "proofs/lemmas/area_bounds.cpp:96", wherever the sources were compiled.
std::string place(const std::source_location& at)
{
    const std::string file = at.file_name();
    const std::size_t cut = file.rfind("proofs/");
    return (cut == std::string::npos ? file : file.substr(cut)) + ":" + std::to_string(at.line());
}

/// "area_bounds" of "touchstone::proofs::Check touchstone::proofs::area_bounds()".
std::string function(const std::source_location& at)
{
    std::string name = at.function_name();
    name.resize(std::min(name.find('('), name.size()));
    const std::size_t cut = name.find_last_of(" :");
    return cut == std::string::npos ? name : name.substr(cut + 1);
}

void add_once(std::vector<std::string>& all, const std::string& one)
{
    if (!one.empty() && std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

} // namespace

Check as_lemma(Check c, const std::source_location& at)
{
    c.lemma = function(at) + " " + place(at);
    return c;
}

Argument::Argument(std::string method, const std::source_location& at)
{
    finding_.method = std::move(method);
    finding_.judge = place(at);
}

Argument& Argument::argue(const std::string& text)
{
    finding_.steps.push_back("(argued) " + text);
    if (worst_ == Verdict::proved || worst_ == Verdict::verified) worst_ = Verdict::argued;
    return *this;
}

Argument& Argument::add(const std::string& lemma, const Check& check)
{
    ++checks_;
    add_once(finding_.lemmas, check.lemma);
    finding_.steps.push_back(lemma + " [" + std::string(name(check.verdict)) + ": " + check.detail + "]");
    const auto rank = [](Verdict v) { // the weakest link decides, a refuted one before all
        switch (v) {
        case Verdict::refuted: return 4;
        case Verdict::undecided: return 3;
        case Verdict::argued: return 2;
        case Verdict::verified: return 1;
        default: return 0;
        }
    };
    const std::string why = lemma + ": " + check.detail;
    if (rank(check.verdict) > rank(worst_)) {
        worst_ = check.verdict;
        if (rank(worst_) >= 3) finding_.reason = why;
    } else if (check.verdict == Verdict::refuted) {
        finding_.reason += "; " + why;
    }
    return *this;
}

Argument& Argument::note(const std::string& text)
{
    finding_.steps.push_back("(remark) " + text);
    return *this;
}

Finding Argument::conclude(const std::string& reason, Verdict passed) const
{
    Finding f = finding_;
    if (worst_ == Verdict::refuted || worst_ == Verdict::undecided) {
        f.verdict = worst_;
        return f;
    }
    f.reason = reason;
    const bool weaker = worst_ == Verdict::argued || (worst_ == Verdict::verified && passed == Verdict::proved);
    f.verdict = weaker && (passed == Verdict::proved || passed == Verdict::verified) ? worst_ : passed;
    if (passed == Verdict::proved && checks_ == 0) throw std::logic_error("a proof without a check");
    return f;
}

std::vector<std::string> Entry::surviving() const
{
    std::vector<std::string> bad;
    for (const ControlResult& c : controls)
        if (c.finding.verdict != Verdict::refuted)
            bad.push_back("control survives as " + std::string(name(c.finding.verdict)) + ": " + c.what);
    const bool holds = finding.verdict == Verdict::proved || finding.verdict == Verdict::verified || finding.verdict == Verdict::argued;
    if (holds && controls.empty()) bad.push_back("no control");
    if (finding.verdict == Verdict::refuted) {
        if (!corrected) bad.push_back("refuted without a corrected form");
        else if (corrected->verdict != Verdict::proved && corrected->verdict != Verdict::argued)
            bad.push_back("the corrected form comes out " + std::string(name(corrected->verdict)));
    }
    return bad;
}

namespace {

Finding judged(const Claim& claim, const Print& print, Order order)
{
    const auto refuted = [](const Check& reading) {
        Finding f;
        f.verdict = Verdict::refuted;
        f.method = "the whole print read in balls";
        f.reason = reading.detail;
        return f;
    };
    std::optional<Check> reading;
    if (order == Order::reading_first) {
        reading = read_whole(print);
        if (reading && reading->verdict == Verdict::refuted) return refuted(*reading);
    }
    Finding f;
    try {
        f = claim.judge(print);
    } catch (const std::exception& e) { // a print that its judge cannot take: never silently, and never proved
        f.verdict = Verdict::undecided;
        f.reason = std::string("the judge cannot read it: ") + e.what();
    }
    if (f.verdict == Verdict::refuted) return f;
    if (order == Order::judge_first) reading = read_whole(print);
    if (!reading) return f;
    if (reading->verdict == Verdict::refuted) {
        const Finding r = refuted(*reading);
        f.verdict = r.verdict;
        f.reason = r.reason;
    }
    f.steps.push_back("the whole print, each field [" + std::string(name(reading->verdict)) + ": " + reading->detail + "]");
    return f;
}

} // namespace

Finding judge_whole(const Claim& claim, const Print& print, Order order)
{
    values_used(); // what others asked for
    Finding f = judged(claim, print, order);
    for (const std::string& row : values_used()) add_once(f.rows, row);
    return f;
}

Entry run(const Claim& claim, const Print& print)
{
    Entry e;
    e.claim = &claim;
    e.print = print;
    e.finding = judge_whole(claim, print);
    if (claim.correction) e.corrected = judge_whole(claim, print.edited(claim.correction->edits));
    for (const Control& c : claim.controls) e.controls.push_back({c.what, judge_whole(claim, print.edited(c.edits))});
    return e;
}

std::vector<std::string> cycle(const std::vector<Claim>& all)
{
    std::map<std::string, const Claim*> by_id;
    for (const Claim& c : all) by_id[c.id] = &c;
    std::map<std::string, int> state; // 1: on the way, 2: leads to no cycle
    std::vector<std::string> path;
    const std::function<bool(const std::string&)> leads_to_one = [&](const std::string& id) {
        if (state[id] == 2 || !by_id.count(id)) return false;
        path.push_back(id);
        if (state[id] == 1) return true;
        state[id] = 1;
        for (const std::string& other : by_id[id]->rests_on)
            if (leads_to_one(other)) return true;
        state[id] = 2;
        path.pop_back();
        return false;
    };
    for (const Claim& c : all)
        if (leads_to_one(c.id)) {
            path.erase(path.begin(), std::find(path.begin(), path.end(), path.back()));
            return path;
        }
    return {};
}

const std::vector<Claim>& claims()
{
    static const std::vector<Claim> all = [] {
        std::map<std::string, Claim> by_id;
        for (auto* section :
             {&section_2, &section_3, &section_5, &section_6, &section_7, &section_8, &section_9, &table_1, &sentences, &beyond})
            for (Claim& c : section())
                if (!by_id.emplace(c.id, c).second) throw std::logic_error("two claims for " + c.id);
        std::vector<Claim> ordered;
        for (const std::string& id : print_order()) {
            const auto found = by_id.find(id);
            if (found == by_id.end()) throw std::logic_error("no claim for " + id);
            ordered.push_back(std::move(found->second));
            by_id.erase(found);
        }
        if (!by_id.empty()) throw std::logic_error("no print for " + by_id.begin()->first);
        if (const auto c = cycle(ordered); !c.empty()) {
            std::string path;
            for (const std::string& id : c) path += (path.empty() ? "" : " -> ") + id;
            throw std::logic_error("the ledger rests on itself: " + path);
        }
        return ordered;
    }();
    return all;
}

} // namespace touchstone::proofs
