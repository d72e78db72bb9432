// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_forbids.hpp"

#include "proofs/own/own_sides.hpp"
#include "proofs/symbols.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace touchstone::proofs {

namespace {

/// What the entry follows from, and what that follows from in turn.
std::set<std::string> all_sources(const OwnLedger& ledger, const OwnEntry& e)
{
    std::set<std::string> all;
    std::vector<std::string> todo = e.rests_on;
    while (!todo.empty()) {
        const std::string id = todo.back();
        todo.pop_back();
        if (!all.insert(id).second) continue;
        const auto& further = ledger.at(id).rests_on;
        todo.insert(todo.end(), further.begin(), further.end());
    }
    return all;
}

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

/// Whether what is put in leaves a quantity what it is: equals are put for equals, or symbols are written in new ones, each in one of its
/// own that it varies with, beside known ones: x = a xi.
bool is_only_rewritten(const OwnLedger& ledger, const OwnEntry& e)
{
    if (!e.follows->derivative_by.empty()) return false;
    std::set<std::string> taken;
    for (const std::string& id : all_sources(ledger, e))
        for (const auto& [field, text] : right_form(ledger.at(id)).fields)
            if (field.ends_with(".lhs") || field.ends_with(".rhs")) taken.merge(symbols_of(written_out(ledger, read(text))));
    for (const auto& [symbol, by] : e.follows->with) {
        const ex put = with_references(ledger, by);
        const bool is_an_entry = by.starts_with("@") && ledger.has(by.substr(1));
        if (is_an_entry && right_form(ledger.at(by.substr(1)))("lhs").is_equal(sym(symbol))) continue;
        if (is_the_same_in_other_words(ledger, sym(symbol), put)) continue;
        const ex full = written_out(ledger, put);
        bool varies = false;
        for (const std::string& name : symbols_of(full))
            if (!taken.count(name)) varies = varies || !GiNaC::normal(full.diff(GiNaC::ex_to<GiNaC::symbol>(sym(name)))).is_zero();
        if (!varies) return false;
        taken.merge(symbols_of(full));
    }
    return true;
}

/// Whether a source has the symbol in it elsewhere than as the left side, or the side, that it names there; or something is put for it.
std::optional<Check> means_something_else(const OwnLedger& ledger, const OwnEntry& e, const ex& name)
{
    const Follows& f = *e.follows;
    for (const std::string& id : all_sources(ledger, e)) {
        const Print other = right_form(ledger.at(id));
        for (const auto& [field, text] : other.fields) {
            const bool is_left = field.ends_with("lhs"), is_first = field == "lhs" || field.starts_with("0.");
            if ((!is_left && !field.ends_with("rhs")) || text.empty()) continue;
            const ex side = read(text);
            const bool named_here = is_first && (is_left || (id == f.equation && f.side == "lhs")) && side.is_equal(name);
            if (!named_here && symbols_of(written_out(ledger, side)).count(str(name)))
                return Check{Verdict::undecided, "(" + id + ") has '" + str(name) + "' in it: the right side wants a symbol of its own"};
        }
    }
    for (const auto& [symbol, by] : f.with)
        if (symbol == str(name) && !is_the_same_in_other_words(ledger, name, with_references(ledger, by)))
            return Check{Verdict::undecided, "something else is put for '" + symbol + "': the right side wants a symbol of its own"};
    return std::nullopt;
}

/// A symbol that names the right side may have been given another by what the entry follows from: y = x^2 and y = 2*x, its derivative.
std::optional<Check> named_before(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    const Follows& f = *e.follows;
    const ex name = p("lhs");
    if (const auto no = means_something_else(ledger, e, name)) return no;
    std::set<std::string> sources = all_sources(ledger, e);
    if (right_form(ledger.at(f.equation))(f.side == "rhs" ? "lhs" : "rhs").is_equal(name)) {
        if (is_only_rewritten(ledger, e)) return std::nullopt;
        sources = {f.equation}; // which was compared with its own sources itself
    }
    for (const std::string& id : sources) {
        const Print other = right_form(ledger.at(id));
        const bool is_direct = id == f.equation && f.side == "lhs";
        if (other.text("relation") != "=" || !other(is_direct ? "rhs" : "lhs").is_equal(name)) continue;
        const Check c = same({ledger, p, "0."}, p("rhs"), other(is_direct ? "lhs" : "rhs"));
        if (c.verdict == Verdict::verified) return c;
        if (c.verdict != Verdict::proved)
            return Check{Verdict::undecided, "(" + id + ") is of '" + str(name) + "' too, and is not the same: what is put in, or a " +
                                                 "derivative, makes another quantity, which wants a symbol of its own"};
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
