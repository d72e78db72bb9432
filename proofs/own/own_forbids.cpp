// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_forbids.hpp"

#include "proofs/own/own_names.hpp"
#include "proofs/own/own_sides.hpp"
#include "proofs/symbols.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace touchstone::proofs {

namespace {

/// Whether a formula stays between two numbers wherever its symbols stay in their ranges; no means: not seen to.
bool stays_within(const OwnLedger& ledger, const ex& e, const Range& r)
{
    const ex full = written_out(ledger, e);
    return not_negative(ledger, full - GiNaC::numeric(r.low.get_str().c_str())).verdict == Verdict::proved &&
           not_negative(ledger, GiNaC::numeric(r.high.get_str().c_str()) - full).verdict == Verdict::proved;
}

/// Where a source was looked at: over its printed range, or, if it rests on what has one, where its symbols are sampled.
std::vector<Range> box_of(const OwnLedger& ledger, const OwnEntry& source)
{
    if (!source.over.empty()) return source.over;
    const std::set<std::string> sources = all_sources(ledger, source);
    if (std::none_of(sources.begin(), sources.end(), [&](const std::string& id) { return !ledger.at(id).over.empty(); })) return {};
    const Print p = right_form(source);
    std::set<std::string> names;
    for (const char* side : {"lhs", "rhs"}) names.merge(symbols_of(written_out(ledger, p(side))));
    std::vector<Range> box;
    for (const std::string& name : names) box.push_back({name, ledger.symbols.at(name).low, ledger.symbols.at(name).high});
    return box;
}

/// From a bound the same bound follows, both sides of it; from what is printed with ~ that alone.
std::optional<Check> bound_forbids(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    const Follows& f = *e.follows;
    if (const ex side = right_form(ledger.at(f.equation))(f.side); f.side == "lhs" && !f.derivative_by.empty() &&
        GiNaC::is_a<GiNaC::symbol>(side) && ledger.symbols.at(str(side)).is.empty() && str(side) != f.derivative_by)
        return Check{Verdict::undecided, "how '" + str(side) + "' varies is not said by a left side alone"};
    for (std::size_t i = 1; i < e.rests_on.size(); ++i) // what "@ID" puts in
        if (const std::string r = right_form(ledger.at(e.rests_on[i])).text("relation"); r != "=")
            return Check{Verdict::undecided, "(" + e.rests_on[i] + ") is printed with " + r + ": nothing is equal to its right side"};
    const Print source = right_form(ledger.at(f.equation));
    const std::string relation = source.text("relation"), from = "(" + f.equation + ") is printed with " + relation;
    if (relation == "=") return std::nullopt;
    if (p.text("relation") != relation || !f.derivative_by.empty() || f.side != "rhs" || (!is_bound(relation) && !f.with.empty()))
        return Check{Verdict::undecided, from + ", from which only the same follows"};
    const Check left = same({ledger, p, "0."}, p("lhs"), replaced(ledger, source("lhs"), replacements(ledger, f)));
    if (left.verdict == Verdict::proved || left.verdict == Verdict::verified) return left;
    return Check{Verdict::undecided, from + ", and what stands on its left side is not the same: " + left.detail};
}

/// What was looked at over a range follows within it.
std::optional<Check> range_forbids(const OwnLedger& whole, const OwnLedger& ledger, const OwnEntry& e)
{
    const GiNaC::lst with = replacements(ledger, *e.follows);
    for (std::size_t i = 0; i < e.rests_on.size(); ++i) {
        const std::string& id = e.rests_on[i];
        const std::vector<Range> box = box_of(whole, whole.at(id));
        for (const Range& r : box)
            if (!stays_within(ledger, i == 0 ? replaced(ledger, sym(r.symbol), with) : sym(r.symbol), r))
                return Check{Verdict::undecided, "(" + id + ") is looked at for " + r.symbol + " in [" + r.low.get_str() + ", " +
                                                     r.high.get_str() + "], and this is not seen to stay in there"};
        for (const ex& one : i == 0 && !box.empty() ? with : GiNaC::lst{})
            if (std::none_of(box.begin(), box.end(), [&](const Range& r) { return one.lhs().is_equal(sym(r.symbol)); }) &&
                !is_the_same_in_other_words(ledger, one.lhs(), one.rhs()))
                return Check{Verdict::undecided, "(" + id + ") is looked at over a range, and " + str(one.lhs()) + " has none there"};
    }
    return std::nullopt;
}

/// What has a condition holds where that does.
std::optional<Check> condition_forbids(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    const GiNaC::lst with = replacements(ledger, *e.follows);
    for (std::size_t i = 0; i < e.rests_on.size(); ++i) {
        const std::string& id = e.rests_on[i];
        const Print other = right_form(ledger.at(id));
        for (const Point& point : points_all_over(ledger)) // what "@ID" puts in stays as it is
            if (condition_at(ledger, other, "0.", i == 0 ? with : GiNaC::lst{}, point) == Truth::no &&
                certainly(condition_at(ledger, p, "0.", {}, point)))
                return Check{Verdict::undecided, "at " + as_text(point) + " the condition of (" + id + "), " +
                                                     other.text("condition") + ", does not hold"};
    }
    return std::nullopt;
}

/// The left side of what follows from an equation. A symbol that stands for nothing names the right side; all else has a value already.
std::optional<Check> left_side(const OwnLedger& whole, const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    const auto symbol = whole.symbols.find(p.text("lhs"));
    const bool has_a_range = std::any_of(e.over.begin(), e.over.end(), [&](const Range& r) { return r.symbol == p.text("lhs"); });
    if (symbol != whole.symbols.end() && symbol->second.is.empty() && !has_a_range) return named_before(ledger, e, p);
    if (right_form(ledger.at(e.follows->equation)).text("relation") != "=") return std::nullopt; // bound_forbids compares both sides
    if (p.text("relation") != "=") return Check{Verdict::verified, "a bound that follows from an equation, at the samples"};
    const Check c = same({ledger, p, "0."}, p("lhs"), derived(ledger, *e.follows));
    return c.verdict == Verdict::proved ? std::nullopt : std::optional(c);
}

/// The symbols of the print, and those that they stand for.
std::set<std::string> all_names(const OwnLedger& ledger, const Print& p)
{
    std::set<std::string> all, todo;
    for (const auto& [field, text] : p.fields)
        if (field.ends_with("lhs") || field.ends_with("rhs") || field.ends_with("condition")) todo.merge(words(text));
    while (!todo.empty()) {
        const std::string name = *todo.begin();
        todo.erase(todo.begin());
        const auto symbol = ledger.symbols.find(name);
        if (symbol != ledger.symbols.end() && all.insert(name).second) todo.merge(words(symbol->second.is));
    }
    return all;
}

/// What must be positive, by its text, and the symbol that it is put for.
using Positive = std::map<std::string, std::pair<std::string, ex>>;

/// By whose sign roots and moduli of a print were simplified, in what it follows from too: there with all that was put in on the way.
Positive must_be_positive(const OwnLedger& whole, const OwnLedger& ledger, const OwnEntry& e, const Print& p,
                          std::map<std::string, Positive>& known)
{
    Positive all;
    const auto add = [&](const std::string& name, const ex& put) { all.try_emplace(str(put), name, put); };
    for (const std::string& name : all_names(ledger, p))
        if (!alphabet().symbols.at(name).real) add(name, sym(name));
    const GiNaC::lst with = e.follows ? replacements(ledger, *e.follows) : GiNaC::lst{};
    for (std::size_t i = 0; i < e.rests_on.size(); ++i) {
        const OwnEntry& source = whole.at(e.rests_on[i]);
        if (!known.count(source.print.id)) {
            Positive of_source = must_be_positive(whole, whole, source, right_form(source), known);
            known[source.print.id] = std::move(of_source);
        }
        for (const auto& [text, one] : known.at(source.print.id)) // what "@ID" puts in stays as it is
            add(one.first, i == 0 ? replaced(ledger, one.second, with) : one.second);
    }
    return all;
}

} // namespace

std::optional<Check> sign_forbids(const OwnLedger& whole, const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    std::optional<Check> worst;
    std::map<std::string, Positive> known;
    for (const auto& [text, one] : must_be_positive(whole, ledger, e, p, known)) {
        const ex put = e.over.empty() ? one.second : written_out(ledger, one.second); // symbols have their signs in their own ranges
        if (is_positive(put)) continue;
        const Check c = not_negative(ledger, put);
        if (c.verdict == Verdict::proved) continue;
        const bool is_wrong = c.verdict == Verdict::refuted && !p.has("condition");
        if (!worst || is_wrong)
            worst = Check{is_wrong ? Verdict::undecided : Verdict::verified, "'" + one.first + "' is positive, and " + text + " is not " +
                                                                                 (is_wrong ? "" : "shown to be ") + "so: " + c.detail};
    }
    return worst;
}

std::vector<Check> what_forbids(const OwnLedger& whole, const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    std::vector<Check> all;
    for (const auto& no : {bound_forbids(ledger, e, p), range_forbids(whole, ledger, e), condition_forbids(ledger, e, p),
                           left_side(whole, ledger, e, p)})
        if (no) all.push_back(*no);
    return all;
}

} // namespace touchstone::proofs
