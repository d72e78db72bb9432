// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_names.hpp"

#include "proofs/own/own_sides.hpp"
#include "proofs/symbols.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace touchstone::proofs {

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

namespace {

bool is_side(const std::string& field) { return field.ends_with(".lhs") || field.ends_with(".rhs"); }

/// The side if it is a symbol that stands for nothing; else nothing.
std::string free_name(const OwnLedger& ledger, const std::string& side)
{
    const std::set<std::string> all = words(side);
    if (all.size() != 1) return {};
    const auto symbol = ledger.symbols.find(*all.begin());
    return symbol != ledger.symbols.end() && symbol->second.is.empty() && read(side).is_equal(sym(*all.begin())) ? *all.begin() : "";
}

std::set<std::string> symbols_in(const OwnLedger& ledger, const std::string& text)
{
    std::set<std::string> all;
    for (const std::string& word : words(text))
        if (ledger.symbols.count(word)) all.insert(word);
    return all;
}

/// Each symbol with those that what it stands for, or another entry says it to be, or to be below, is of.
std::map<std::string, std::set<std::string>> what_symbols_are_of(const OwnLedger& ledger, const OwnEntry& except)
{
    std::map<std::string, std::set<std::string>> all;
    for (const auto& [name, symbol] : ledger.symbols) all[name] = symbols_in(ledger, symbol.is);
    for (const OwnEntry& e : ledger.entries) {
        if (e.print.id == except.print.id) continue;
        const Print p = right_form(e);
        for (std::size_t i = 0; i < p.parts(); ++i) {
            const std::string part = std::to_string(i) + ".", left = p.text(part + "lhs"), right = p.text(part + "rhs");
            if (const std::string name = free_name(ledger, left); !name.empty()) all[name].merge(symbols_in(ledger, right));
            if (const std::string name = free_name(ledger, right); !name.empty()) all[name].merge(symbols_in(ledger, left));
        }
    }
    return all;
}

/// What is put for a symbol that is equal to it.
bool is_an_equal(const OwnLedger& ledger, const std::string& symbol, const std::string& by)
{
    if (by.starts_with("@") && ledger.has(by.substr(1)) && right_form(ledger.at(by.substr(1)))("lhs").is_equal(sym(symbol))) return true;
    return is_the_same_in_other_words(ledger, sym(symbol), with_references(ledger, by));
}

/// The symbols that another value is put for, or by which a derivative is taken.
std::set<std::string> moved_symbols(const OwnLedger& ledger, const Follows& f)
{
    std::set<std::string> all;
    for (const auto& [symbol, by] : f.with)
        if (!is_an_equal(ledger, symbol, by)) all.insert(symbol);
    if (!f.derivative_by.empty()) all.insert(f.derivative_by);
    return all;
}

} // namespace

std::optional<Check> hidden_dependence(const OwnLedger& ledger, const OwnEntry& e)
{
    const Follows& f = *e.follows;
    const std::set<std::string> moved = moved_symbols(ledger, f);
    if (moved.empty()) return std::nullopt;
    const auto are_of = what_symbols_are_of(ledger, e);
    const auto reaches = [&](const std::string& from, const std::string& to) {
        std::set<std::string> seen, todo = are_of.at(from);
        while (!todo.empty()) {
            const std::string name = *todo.begin();
            todo.erase(todo.begin());
            if (!seen.insert(name).second) continue;
            for (const std::string& other : are_of.at(name)) todo.insert(other);
        }
        return seen.count(to) > 0;
    };
    const Print source = right_form(ledger.at(f.equation));
    std::set<std::string> in_it;
    for (const std::string side : {"lhs", "rhs"}) {
        if (source.text("relation") == "=" && side != f.side) continue; // of a bound both sides follow
        ex formula = source(side);
        for (const std::string& name : moved) formula = without_hidden(ledger, formula, sym(name));
        in_it.merge(symbols_of(formula));
    }
    for (const std::string& name : moved)
        for (const std::string& other : in_it)
            if (other != name && (reaches(other, name) || (in_it.count(name) && reaches(name, other))))
                return Check{Verdict::undecided, "'" + other + "' and '" + name + "' depend on one another by another entry, which " +
                                                     "what is put in, or a derivative, does not reach: \"is\" says it for all"};
    return std::nullopt;
}

namespace {

/// Whether an entry is written by this replacement, as what it follows from may be.
bool carries(const OwnLedger& ledger, const OwnEntry& e, const std::pair<std::string, std::string>& replacement)
{
    const auto has_it = [&](const OwnEntry& of) {
        return of.follows && std::count(of.follows->with.begin(), of.follows->with.end(), replacement) > 0;
    };
    const std::set<std::string> sources = all_sources(ledger, e);
    return has_it(e) || std::any_of(sources.begin(), sources.end(), [&](const std::string& id) { return has_it(ledger.at(id)); });
}

/// Whether a symbol is met nowhere but in what is written by this replacement, so that it has its meaning by that: x = a xi.
bool is_new(const OwnLedger& ledger, const std::string& name, const std::pair<std::string, std::string>& replacement)
{
    for (const auto& [other, symbol] : ledger.symbols)
        if (words(symbol.is).count(name)) return false;
    for (const OwnEntry& e : ledger.entries) {
        std::string texts;
        for (const auto& [field, text] : right_form(e).fields)
            if (is_side(field) || field.ends_with("condition")) texts += text + " ";
        if (e.follows)
            for (const auto& [symbol, by] : e.follows->with) texts += symbol + " " + by + " ";
        if (words(texts).count(name) && !carries(ledger, e, replacement)) return false;
    }
    return true;
}

/// A number, a symbol, or a product of powers of these: nothing that may be 0 in other words.
bool is_one_product(const ex& e)
{
    if (GiNaC::is_a<GiNaC::mul>(e)) return std::all_of(e.begin(), e.end(), is_one_product);
    if (GiNaC::is_a<GiNaC::power>(e)) return GiNaC::is_a<GiNaC::numeric>(e.op(1)) && is_one_product(e.op(0));
    return (GiNaC::is_a<GiNaC::numeric>(e) && !e.is_zero()) || GiNaC::is_a<GiNaC::constant>(e) || GiNaC::is_a<GiNaC::symbol>(e);
}

/// Whether a formula surely changes with a symbol somewhere.
bool varies(const OwnLedger& ledger, const ex& slope)
{
    const Ball by = evaluate(slope, samples(ledger, 0));
    return by.is_finite() && !by.contains_zero();
}

/// Whether what is put in leaves a quantity what it is: proved, where equals are put for equals, or each symbol is scaled or shifted to a
/// new one; verified, where it is a function of a new one, which may not have all its values.
Verdict is_only_rewritten(const OwnLedger& ledger, const OwnEntry& e)
{
    Verdict worst = e.follows->derivative_by.empty() ? Verdict::proved : Verdict::undecided;
    std::set<std::string> taken;
    for (const auto& replacement : e.follows->with) {
        if (is_an_equal(ledger, replacement.first, replacement.second)) continue;
        const ex full = written_out(ledger, with_references(ledger, replacement.second));
        Verdict here = Verdict::undecided;
        for (const std::string& name : symbols_of(full)) {
            const ex slope = full.diff(GiNaC::ex_to<GiNaC::symbol>(sym(name)));
            if (!taken.insert(name).second || !is_new(ledger, name, replacement)) continue;
            if (!slope.has(sym(name)) && is_one_product(slope)) here = Verdict::proved;
            else if (here == Verdict::undecided && varies(ledger, slope)) here = Verdict::verified;
        }
        if (here == Verdict::undecided) return here;
        if (here == Verdict::verified) worst = worst == Verdict::proved ? here : worst;
    }
    return worst;
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

/// What an entry says a symbol to be: the other side of its equation; nothing, if the symbol is in it otherwise.
std::optional<ex> meaning_in(const Print& p, const ex& name)
{
    if (p.parts() == 1)
        for (const auto& [side, other] : {std::pair("lhs", "rhs"), std::pair("rhs", "lhs")})
            if (p(side).is_equal(name) && !p(other).has(name)) return p(other);
    return p("lhs").is_equal(name) ? std::optional(p("rhs")) : std::nullopt;
}

/// Whether an equation that follows from nothing says something of a symbol: not, if it says what another one is by it.
bool says_something_of(const OwnLedger& ledger, const Print& p, const std::string& name)
{
    const std::string left = free_name(ledger, p.text("lhs"));
    const auto symbol = ledger.symbols.find(p.text("lhs"));
    const bool has_a_value = symbol != ledger.symbols.end() && !symbol->second.is.empty(); // which it is compared with
    if (p.parts() == 1 && left != name && (!left.empty() || has_a_value) && free_name(ledger, p.text("rhs")) != name) return false;
    return std::any_of(p.fields.begin(), p.fields.end(), [&](const auto& f) { return is_side(f.first) && words(f.second).count(name); });
}

/// The entries that give a symbol its meaning: those that follow from nothing, wherever they are; or else the first one that follows from
/// something, and not from e; and what e follows from.
std::vector<const OwnEntry*> meanings(const OwnLedger& ledger, const OwnEntry& e, const std::string& name)
{
    std::vector<const OwnEntry*> all, following;
    const std::set<std::string> sources = all_sources(ledger, e);
    bool is_first = true;
    for (const OwnEntry& other : ledger.entries) {
        is_first = is_first && other.print.id != e.print.id;
        const Print p = right_form(other);
        if (other.print.id == e.print.id || p.parts() == 0 || p.text("relation") != "=") continue;
        if (!other.follows && says_something_of(ledger, p, name)) all.push_back(&other);
        if (!other.follows || free_name(ledger, p.text("lhs")) != name) continue;
        if (sources.count(other.print.id)) all.push_back(&other);
        else if (is_first && !all_sources(ledger, other).count(e.print.id)) following.push_back(&other);
    }
    if (all.empty() && !following.empty()) all.push_back(following.front());
    return all;
}

} // namespace

std::optional<Check> named_before(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    const Follows& f = *e.follows;
    const ex name = p("lhs");
    if (const auto no = means_something_else(ledger, e, name)) return no;
    const bool goes_on = right_form(ledger.at(f.equation))(f.side == "rhs" ? "lhs" : "rhs").is_equal(name);
    const Verdict rewritten = goes_on ? is_only_rewritten(ledger, e) : Verdict::undecided; // the equation was compared itself
    if (rewritten == Verdict::proved) return std::nullopt;
    if (rewritten == Verdict::verified)
        return Check{rewritten, "'" + str(name) + "' in terms of another symbol, which may not reach all of it"};
    for (const OwnEntry* other : meanings(ledger, e, str(name))) {
        const std::string& id = other->print.id;
        const auto meaning = meaning_in(right_form(*other), name);
        const Check c = meaning ? same({ledger, p, "0."}, p("rhs"), *meaning) : Check{Verdict::undecided, ""};
        if (c.verdict == Verdict::verified) return c;
        if (c.verdict != Verdict::proved)
            return Check{Verdict::undecided, "(" + id + ") is of '" + str(name) + "' too, and is not the same: what is put in, or a " +
                                                 "derivative, makes another quantity, which wants a symbol of its own"};
    }
    return std::nullopt;
}

} // namespace touchstone::proofs
