// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_judge.hpp"

#include "proofs/mutation/typesetter.hpp"
#include "proofs/own/own_symbols.hpp"
#include "proofs/reading/whole.hpp"
#include "proofs/symbols.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <regex>
#include <set>

namespace touchstone::proofs {

namespace {

constexpr int sample_sets = 4;
constexpr slong bits_of_a_closer_look = 4096; ///< sides that differ by less than 10^-1200 are taken for equal

/// The number of a symbol in a set of samples, inside its range and exact.
Rational sample(const OwnSymbol& s, std::size_t index, int set)
{
    const long steps = 23; // prime, so that no two symbols keep step
    const long k =
        static_cast<long>((index * 7 + static_cast<std::size_t>(set) * 5 + index * static_cast<std::size_t>(set)) % (steps - 1)) + 1;
    return s.low + (s.high - s.low) * Rational(k, steps);
}

Point samples(const OwnLedger& ledger, int set)
{
    Point p;
    std::size_t index = 0;
    for (const auto& [name, symbol] : ledger.symbols) p[name] = sample(symbol, index++, set);
    return p;
}

std::string as_text(const Point& p)
{
    std::string all;
    for (const auto& [name, value] : p) all += (all.empty() ? "" : " ") + name + "=" + value.get_str();
    return all;
}

/// Further points all over the ranges, and next to their ends: for formulas that no normal form compares and that may differ on a part
/// only. Where ranges do not fit together, as x below a, a formula has no value at some of them; those say nothing.
std::vector<Point> points_all_over(const OwnLedger& ledger)
{
    constexpr long parts = 31; // prime: each symbol visits every part, no two in the same order
    std::vector<Point> all;
    const auto add = [&](const auto& share_of) {
        Point p;
        long index = 0;
        for (const auto& [name, s] : ledger.symbols) p[name] = s.low + (s.high - s.low) * share_of(++index);
        all.push_back(std::move(p));
    };
    for (long k = 1; k < parts; ++k)
        add([&](long index) { return Rational((2 * (k * (index % (parts - 1) + 1) % parts) + 1), 2 * parts); });
    for (const long power : {7L, 20L})
        for (long pattern = 0; pattern < 4; ++pattern) // all low, all high, and by turns
            add([&](long index) {
                const Rational near(1, 1L << power);
                return (pattern == 1 || (pattern == 2 && index % 2) || (pattern == 3 && index % 2 == 0)) ? Rational(1 - near) : near;
            });
    return all;
}

void take_value(const OwnLedger& ledger, const std::string& name, Situation& s);

/// e in the situation, whose symbols are computed as needed.
Ball value_of(const OwnLedger& ledger, const ex& e, Situation& s)
{
    const std::function<void(const ex&)> need = [&](const ex& part) {
        if (GiNaC::is_a<GiNaC::symbol>(part)) take_value(ledger, GiNaC::ex_to<GiNaC::symbol>(part).get_name(), s);
        for (std::size_t i = 0; i < part.nops(); ++i) need(part.op(i));
    };
    need(e);
    return evaluate(e, s.value);
}

void take_value(const OwnLedger& ledger, const std::string& name, Situation& s)
{
    if (s.value.count(name)) return;
    const std::string& is = ledger.symbols.at(name).is;
    if (!is.empty()) s[name] = value_of(ledger, read(is), s);
}

Situation situation(const OwnLedger& ledger, int set)
{
    Situation s;
    s.agreeing_is_equal = false;
    for (const auto& [name, value] : samples(ledger, set))
        if (ledger.symbols.at(name).is.empty()) s[name] = Ball(value);
    for (const auto& [name, symbol] : ledger.symbols) take_value(ledger, name, s);
    return s;
}

/// The print that others may rest on: corrected, where it has a correction.
Print right_form(const OwnEntry& e) { return e.correction ? e.print.edited(e.correction->edits) : e.print; }

/// The same, down to the symbols that have a range in the entry.
ex written_out(const OwnLedger& ledger, const OwnEntry& entry, const ex& e)
{
    return written_out(ledger, e, [&](const std::string& name) {
        return std::none_of(entry.over.begin(), entry.over.end(), [&](const Range& r) { return r.symbol == name; });
    });
}

/// e with those symbols written out that stand for something in which `symbol` is.
ex without_hidden(const OwnLedger& ledger, const ex& e, const ex& symbol)
{
    return written_out(ledger, e, [&](const std::string& name) {
        return !sym(name).is_equal(symbol) && written_out(ledger, sym(name)).has(symbol);
    });
}

bool is_the_same_in_other_words(const OwnLedger& ledger, const ex& a, const ex& b)
{
    const ex off = written_out(ledger, a - b);
    return off.is_zero() || (terms_of(off) <= most_terms && GiNaC::normal(GiNaC::expand(off)).is_zero());
}

/// "@H1 + x", with the right side of H1.
ex with_references(const OwnLedger& ledger, const std::string& t)
{
    static const std::regex name("@([\\w.-]+)");
    std::string out, rest = t;
    for (std::smatch m; std::regex_search(rest, m, name); rest = m.suffix())
        out += m.prefix().str() + "(" + right_form(ledger.at(m[1])).text("rhs") + ")";
    return read(out + rest);
}

/// What is put for which symbols.
GiNaC::lst replacements(const OwnLedger& ledger, const Follows& f)
{
    GiNaC::lst with;
    for (const auto& [symbol, by] : f.with) with.append(sym(symbol) == with_references(ledger, by));
    return with;
}

/// e with the replacements. What is put for a symbol reaches what stands for something with it in it too, unless it is that symbol in
/// other words, for which it may be put here and there.
ex replaced(const OwnLedger& ledger, ex e, const GiNaC::lst& with)
{
    for (const ex& one : with)
        if (!is_the_same_in_other_words(ledger, one.lhs(), one.rhs())) e = without_hidden(ledger, e, one.lhs());
    return e.subs(with);
}

/// What the entry's right side must be.
ex derived(const OwnLedger& ledger, const Follows& f)
{
    ex e = right_form(ledger.at(f.equation))(f.side);
    if (!f.derivative_by.empty()) {
        const ex by = sym(f.derivative_by);
        e = without_hidden(ledger, e, by).diff(GiNaC::ex_to<GiNaC::symbol>(by));
    }
    return replaced(ledger, e, replacements(ledger, f));
}

/// How they differ, if that is by a number, however small; else nothing.
std::string differ_by_a_number(const ex& print, const ex& wanted)
{
    const auto number = [](const ex& e) {
        const ex n = GiNaC::normal(GiNaC::expand(e));
        return GiNaC::is_a<GiNaC::numeric>(n) ? std::optional(n) : std::nullopt;
    };
    if (const auto off = number(print - wanted)) return off->is_zero() ? "" : "the two differ by " + str(*off);
    const auto ratio = wanted.is_zero() ? std::nullopt : number(print / wanted);
    return ratio && !ratio->is_equal(1) ? "it is " + str(*ratio) + " times what it should be" : "";
}

bool is_bound(const std::string& relation) { return relation == "<" || relation == ">" || relation == "<=" || relation == ">="; }

/// Whether the printed condition of a part, "0 < x <= a", surely holds at a point, with the symbols that `with` says otherwise; surely does
/// not; or neither is known.
Truth condition_at(const OwnLedger& ledger, const Print& p, const std::string& part, const GiNaC::lst& with, const Point& point)
{
    if (!p.has(part + "condition")) return Truth::yes;
    std::vector<Ball> sides;
    for (const ex& side : p.sides(part + "condition")) sides.push_back(evaluate(written_out(ledger, replaced(ledger, side, with)), point));
    static const std::regex relation("[<>]=?");
    const std::string& text = p.text(part + "condition");
    const std::vector<std::string> relations(std::sregex_token_iterator(text.begin(), text.end(), relation), {});
    if (relations.size() + 1 != sides.size()) return Truth::unknown; // an equation, which no point of these is on
    Truth all = Truth::yes;
    for (std::size_t k = 0; k < relations.size(); ++k) {
        const auto [smaller, larger] = relations[k][0] == '<' ? std::pair(sides[k], sides[k + 1]) : std::pair(sides[k + 1], sides[k]);
        const bool may_be_equal = relations[k].size() == 2;
        const Truth strictly = less(smaller, larger), reversed = less(larger, smaller);
        if (may_be_equal ? certainly(reversed) : !possibly(strictly)) return Truth::no;
        if (may_be_equal ? possibly(reversed) : !certainly(strictly)) all = Truth::unknown;
    }
    return all;
}

/// Where two formulas have to be the same.
struct Where {
    const OwnLedger& ledger;
    const Print& print;
    std::string part; ///< of the print, whose condition says it
    GiNaC::lst with{};

    bool holds_at(const Point& point) const { return certainly(condition_at(ledger, print, part, with, point)); }
};

/// Two samples as independent numbers, or where the condition leaves them out two points all over the ranges that it does not.
Points free_points(const Where& where)
{
    constexpr std::size_t wanted = 2;
    std::vector<Point> all = points_all_over(where.ledger), inside;
    all.insert(all.begin(), {samples(where.ledger, 0), samples(where.ledger, 1)});
    for (const Point& point : all)
        if (inside.size() < wanted && where.holds_at(point)) inside.push_back(point);
    return Points(std::move(inside));
}

/// A point, of those all over the ranges at which the condition holds, at which the two differ.
std::optional<Check> apart_somewhere(const Where& where, const ex& print, const ex& wanted)
{
    for (const Point& point : points_all_over(where.ledger))
        if (Check there = compare_at(print, wanted, {as_text(point).c_str()}); there.verdict == Verdict::refuted && where.holds_at(point))
            return there;
    return std::nullopt;
}

/// The terms of what log_form takes logarithms of.
double terms_of_factors(const ex& e)
{
    if (GiNaC::is_a<GiNaC::power>(e)) return terms_of_factors(e.op(0));
    if (!GiNaC::is_a<GiNaC::mul>(e)) return terms_of(e);
    double most = 1;
    for (const ex& factor : e) most = std::max(most, terms_of_factors(factor));
    return most;
}

/// As products of powers, or as squares that agree in value at the points.
std::optional<Check> same_as_powers(const ex& print, const ex& wanted, const Points& at, bool is_long)
{
    try {
        if (std::max(terms_of_factors(print), terms_of_factors(wanted)) <= most_terms)
            if (const Check powers = power_identity(print, wanted, at); powers.verdict == Verdict::proved) return powers;
        if (!is_long && identity(pow(print, 2), pow(wanted, 2), at).verdict == Verdict::proved)
            return Check{Verdict::verified, "the squares have the same normal form, and the sign is the same at the points"};
    } catch (const std::exception&) {
    }
    return std::nullopt;
}

/// Equal as they stand: by normal form, as products of powers, or as squares that agree in value where they are looked at. What would be
/// too long multiplied out has no normal form, unless it is the same to the letter.
Check same_as_written(const Where& where, const ex& print, const ex& wanted)
{
    const bool is_long = terms_of(print) + terms_of(wanted) > most_terms && !(print - wanted).is_zero();
    if (!is_long)
        if (const std::string how = differ_by_a_number(print, wanted); !how.empty()) return {Verdict::refuted, how};
    const Points at = free_points(where);
    const Check direct = is_long ? compare_at(print, wanted, at) : identity(print, wanted, at);
    if (direct.verdict != Verdict::undecided) return direct;
    if (at.empty()) return {Verdict::undecided, "the condition holds at none of the points"};
    if (const auto apart = apart_somewhere(where, print, wanted)) return *apart;
    {
        const WorkingPrecision closer(bits_of_a_closer_look);
        if (const auto apart = apart_somewhere(where, print, wanted)) return *apart;
    }
    if (const auto powers = same_as_powers(print, wanted, at, is_long)) return *powers;
    if (!evaluates_at(print, wanted, at)) return direct;
    const WorkingPrecision closer(bits_of_a_closer_look);
    if (const Check there = compare_at(print, wanted, at); there.verdict == Verdict::refuted) return there;
    return {Verdict::verified, "the same in balls at the points, not by normal form"};
}

/// Equal as they stand, or with what the symbols stand for.
Check same(const Where& where, const ex& print, const ex& wanted)
{
    const Check as_written = same_as_written(where, print, wanted);
    const ex print_in_full = written_out(where.ledger, print), wanted_in_full = written_out(where.ledger, wanted);
    if (as_written.verdict == Verdict::proved || (print_in_full.is_equal(print) && wanted_in_full.is_equal(wanted))) return as_written;
    return same_as_written(where, print_in_full, wanted_in_full);
}

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
    for (const std::string& id : e.rests_on) {
        const Print other = right_form(ledger.at(id));
        for (const Point& point : points_all_over(ledger))
            if (condition_at(ledger, other, "0.", id == e.follows->equation ? with : GiNaC::lst{}, point) == Truth::no &&
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

/// The symbols of the print and of all that it follows from, and those that they stand for.
std::set<std::string> all_names(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    std::set<std::string> all, todo;
    const auto take = [&](const Print& print) {
        for (const auto& [field, text] : print.fields)
            if (field.ends_with("lhs") || field.ends_with("rhs")) todo.merge(words(text));
    };
    take(p);
    for (const std::string& id : all_sources(ledger, e)) take(right_form(ledger.at(id)));
    while (!todo.empty()) {
        const std::string name = *todo.begin();
        todo.erase(todo.begin());
        const auto symbol = ledger.symbols.find(name);
        if (symbol != ledger.symbols.end() && all.insert(name).second) todo.merge(words(symbol->second.is));
    }
    return all;
}

/// Roots and moduli are simplified by the sign of a positive symbol: has what is put for it, or what it stands for over the entry's own
/// ranges, this sign?
std::optional<Check> sign_forbids(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    std::optional<Check> worst;
    const auto look = [&](const std::string& name, const ex& put) {
        if (is_positive(put)) return;
        const Check c = not_negative(ledger, put);
        if (c.verdict == Verdict::proved) return;
        const bool is_wrong = c.verdict == Verdict::refuted && !p.has("condition");
        if (!worst || is_wrong)
            worst = Check{is_wrong ? Verdict::undecided : Verdict::verified, "'" + name + "' is positive, and " + str(put) + " is not " +
                                                                                 (is_wrong ? "" : "shown to be ") + "so: " + c.detail};
    };
    const GiNaC::lst with = e.follows ? replacements(ledger, *e.follows) : GiNaC::lst{};
    for (const std::string& name : all_names(ledger, e, p)) {
        const OwnSymbol& symbol = ledger.symbols.at(name);
        if (alphabet().symbols.at(name).real) continue;
        const ex put = replaced(ledger, sym(name), with);
        const bool is_moved = !put.is_equal(sym(name));
        if (is_moved || (!symbol.is.empty() && !e.over.empty())) look(name, is_moved ? put : read(symbol.is));
    }
    return worst;
}

/// By how much a part of the print holds, if it is a bound: positive where it does.
ex gap_of(const OwnLedger& ledger, const OwnEntry& e, const Print& p, const std::string& part)
{
    const ex larger_right = p(part + "rhs") - p(part + "lhs");
    return written_out(ledger, e, p.text(part + "relation")[0] == '<' ? larger_right : -larger_right);
}

/// Each bound over its whole range, and what is equal in between; a first right side may follow from another equation.
Check bounds(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    bool is_any = false;
    for (std::size_t i = 0; i < p.parts(); ++i) is_any = is_any || is_bound(p.text(std::to_string(i) + ".relation"));
    for (std::size_t i = 0; i < p.parts(); ++i) {
        const std::string part = std::to_string(i) + ".", relation = p.text(part + "relation");
        if (!is_any || (relation != "=" && !is_bound(relation))) return {Verdict::refuted, "no bound: printed " + relation};
        if (relation == "=") {
            if (i == 0 && e.follows) continue;
            const Check c = same({ledger, p, part}, p(part + "lhs"), p(part + "rhs"));
            if (c.verdict != Verdict::proved) return c;
            continue;
        }
        const Check c = positive_on(gap_of(ledger, e, p, part), e.over, usual_pieces,
                                    relation.size() == 2 ? Bound::may_be_reached : Bound::strict);
        if (c.verdict != Verdict::proved) return c;
    }
    return {Verdict::proved, "over the whole range, by subdivision in balls"};
}

/// What a chain says beyond its first right side, which alone follows from another equation: equal as formulas, and bounds at the points
/// all over the ranges. Where a bound has no value it says nothing.
Check further_parts(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    const WorkingPrecision closer(bits_of_a_closer_look);
    GiNaC::lst with; // the left side is what it follows from
    if (const auto left = ledger.symbols.find(p.text("lhs")); left != ledger.symbols.end() && left->second.is.empty())
        with.append(sym(left->first) == derived(ledger, *e.follows));
    bool are_proved = true;
    for (std::size_t i = 1; i < p.parts(); ++i) {
        const std::string part = std::to_string(i) + ".", relation = p.text(part + "relation");
        if (relation == "=" && !p.has(part + "condition")) {
            const Check c = same({ledger, p, part, with}, p(part + "rhs").subs(with), p(part + "lhs").subs(with));
            if (c.verdict != Verdict::proved && c.verdict != Verdict::verified) return c;
            are_proved = are_proved && c.verdict == Verdict::proved;
            continue;
        }
        are_proved = false;
        if (relation != "=" && !is_bound(relation)) continue;
        const ex gap = gap_of(ledger, e, p, part).subs(with);
        for (const Point& point : points_all_over(ledger)) {
            const Ball by = evaluate(gap, point);
            if (!by.is_finite() || !(relation == "=" ? !by.contains_zero() : certainly(less(by, Ball(0))))) continue;
            if (certainly(condition_at(ledger, p, part, with, point)))
                return {Verdict::refuted, "at " + as_text(point) + " " + p.text(part + "lhs") + " " + relation + " " +
                                              p.text(part + "rhs") + " is off by " + by.to_string(6)};
        }
    }
    return are_proved ? Check{Verdict::proved, "the further right sides, as formulas"}
                      : Check{Verdict::verified, "what stands beyond the first right side, at the points"};
}

/// One printed number, at the working precision. A number that is cut off may be the value itself: so it is taken where balls do not tell
/// the two apart, if `may_be_exact`.
Check printed(const OwnTable& t, std::size_t row, const std::string& digits, bool may_be_exact)
{
    Point at;
    std::string where;
    for (std::size_t c = 0; c < t.columns.size(); ++c) {
        at[t.columns[c]] = *parse_rational(t.inputs[row][c]);
        where += (c > 0 ? ", " : "") + t.columns[c] + " = " + t.inputs[row][c];
    }
    const auto number = parse_rational(digits);
    if (!number) return {Verdict::refuted, "not a number: " + digits};
    Ball value;
    try {
        value = evaluate(read(t.formula), at);
    } catch (const std::exception& wrong) {
        return {Verdict::undecided, "at " + where + " the formula cannot be read: " + wrong.what()};
    }
    if (!value.is_finite()) return {Verdict::undecided, "at " + where + " the formula has no value"};
    const std::size_t mark = digits.find_first_of("eE"), point = digits.find('.');
    const long exponent = mark == std::string::npos ? 0 : std::stol(digits.substr(mark + 1));
    const long decimals = point == std::string::npos ? 0 : static_cast<long>(std::min(mark, digits.size()) - point - 1);
    const Ball unit = pow(Ball(10), Ball(exponent - decimals)), off = value - Ball(*number);
    const std::string says = "at " + where + " the value is " + value.to_string(12) + ", printed " + digits;
    // cut off, towards 0: what is printed is no larger in modulus, of 0 either sign may have been cut off
    const bool is_cut = t.rounding == "down";
    const Ball least = is_cut ? (*number > 0 ? Ball(0) : -unit) : Ball(-unit / 2),
               most = is_cut ? (*number < 0 ? Ball(0) : unit) : Ball(unit / 2);
    if (certainly(less(off, least)) || certainly(less(most, off))) return {Verdict::refuted, says};
    const auto is_exact = [&](const Ball& end) { return may_be_exact && is_cut && end.contains_zero() && off.contains_zero(); };
    const bool inside = (certainly(less(least, off)) || is_exact(least)) && (certainly(less(off, most)) || is_exact(most));
    return inside ? Check{Verdict::verified, says} : Check{Verdict::undecided, says};
}

/// What balls of the usual width leave open is looked at in much narrower ones.
Check printed(const OwnTable& t, std::size_t row, const std::string& digits)
{
    const Check usual = printed(t, row, digits, false);
    if (usual.verdict != Verdict::undecided) return usual;
    const WorkingPrecision closer(bits_of_a_closer_look);
    return printed(t, row, digits, true);
}

Finding judge_table(const OwnTable& t, const Print& p)
{
    Argument a("each printed number in balls");
    for (std::size_t k = 0; k < t.inputs.size(); ++k)
        a.add("row " + std::to_string(k + 1), printed(t, k, p.text("row" + std::to_string(k + 1) + ".digits")));
    return a.conclude(std::to_string(t.inputs.size()) + " numbers right as printed, rounding " + t.rounding, Verdict::verified);
}

/// The ledger with the ranges of the entry.
OwnLedger within(OwnLedger ledger, const OwnEntry& e)
{
    for (const Range& r : e.over) {
        OwnSymbol& s = ledger.symbols.at(r.symbol);
        s.low = r.low;
        s.high = r.high;
        s.is.clear(); // what has a range stands for all of it
    }
    return ledger;
}

/// Roots and moduli are simplified by the sign of what is in them: what stands for a positive symbol, or is put for it, must be so. What
/// cannot be read, as 1/(x-x) written out, is left to the judge of the entry.
void must_have_their_signs(const OwnLedger& ledger)
{
    const auto is_negative = [&](const std::string& text, const Point& point, Ball& value) {
        try {
            value = evaluate(written_out(ledger, with_references(ledger, text)), point);
        } catch (const std::exception&) {
            return false;
        }
        return value.is_finite() && certainly(less(value, Ball(0)));
    };
    const auto surely_holds_at = [&](const OwnEntry& e, const Point& point) {
        try {
            return certainly(condition_at(ledger, e.print, "0.", {}, point));
        } catch (const std::exception&) {
            return false;
        }
    };
    const auto look = [&](const std::string& where, const std::string& name, const std::string& text,
                          const std::function<bool(const Point&)>& counts) {
        for (const Point& point : points_all_over(ledger)) {
            Ball value;
            if (is_negative(text, point, value) && counts(point))
                throw OwnLedgerError(ledger.file + ": " + where + ": '" + name + "' is positive, and stands for " + value.to_string(6) +
                                     " at " + as_text(point) + "; \"sign\": \"real\" says that it need not be, \"range\" where one looks");
        }
    };
    for (const auto& [name, symbol] : ledger.symbols)
        if (!symbol.is.empty() && symbol.positive) look("symbol '" + name + "'", name, symbol.is, [](const Point&) { return true; });
    for (const OwnEntry& e : ledger.entries)
        if (e.follows)
            for (const auto& [name, by] : e.follows->with)
                if (ledger.symbols.at(name).positive) look("entry '" + e.print.id + "'", name, by,
                     [&](const Point& point) { return surely_holds_at(e, point); });
}

/// Does anything say what the left side should be?
bool readable(const OwnLedger& ledger, const OwnEntry& e)
{
    if (e.follows || !e.over.empty()) return true;
    for (std::size_t i = 0; i < e.print.parts(); ++i) {
        const auto symbol = ledger.symbols.find(e.print.text(std::to_string(i) + ".lhs"));
        if (symbol == ledger.symbols.end() || symbol->second.is.empty()) return false;
    }
    return true;
}

/// What the symbols of an entry are worth: the samples; the left side is what it follows from. Where what is put for a positive symbol is
/// positive by the printed condition, what it follows from says nothing outside of that.
Meaning meaning_of(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    Meaning m;
    m.every_situation_decides = true;
    const bool only_inside = e.follows && sign_forbids(ledger, e, p);
    for (int set = 0; set < sample_sets; ++set) {
        if (only_inside && condition_at(ledger, p, "0.", {}, samples(ledger, set)) == Truth::no) continue;
        Situation s = situation(ledger, set);
        const auto left = ledger.symbols.find(e.print.text("lhs"));
        if (e.follows && left != ledger.symbols.end() && left->second.is.empty()) {
            s.value.erase(left->first);
            s[left->first] = value_of(ledger, derived(ledger, *e.follows), s);
        }
        m.situations.push_back(std::move(s));
    }
    return m;
}

} // namespace

namespace {

/// Read in balls of the usual width, and in much narrower ones: sides that agree to many bits may yet differ, and what wide balls leave
/// undecided narrow ones may decide.
Check read_closely(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    const Check usual = read_whole_as(p, meaning_of(ledger, e, p));
    const WorkingPrecision closer(bits_of_a_closer_look);
    const Check narrow = read_whole_as(p, meaning_of(ledger, e, p));
    return usual.verdict == Verdict::verified && narrow.verdict == Verdict::verified ? usual : narrow;
}

} // namespace

Finding judge_own(const OwnLedger& whole, const OwnEntry& e, const Print& p)
{
    if (e.table) return judge_table(*e.table, p);
    const OwnLedger ledger = within(whole, e);
    Argument a(e.follows ? "normal form" : !e.over.empty() ? "balls over the range" : "balls at the samples");
    try {
        a.add("dimensions", units(p));
        if (e.follows) {
            const std::string what = "the right side follows from (" + e.follows->equation + ")";
            a.add(what, same({ledger, p, "0."}, p("rhs"), derived(ledger, *e.follows)));
            for (const auto& no : {bound_forbids(ledger, e, p), range_forbids(whole, ledger, e), condition_forbids(ledger, e, p),
                                   left_side(whole, ledger, e, p), sign_forbids(ledger, e, p)})
                if (no) a.add(what, *no);
        }
        if (!e.over.empty()) a.add("the bound", bounds(ledger, e, p));
        if (const auto no = e.follows ? std::nullopt : sign_forbids(ledger, e, p)) a.add("signs over its range", *no);
        if (a.conclude().verdict == Verdict::refuted) return a.conclude();
        if (readable(ledger, e)) {
            const Check read = read_closely(ledger, e, p);
            bool is_proved = e.follows || !e.over.empty();
            if (e.follows && e.over.empty() && p.parts() > 1) { // the proof above is the first part's alone
                const Check further = further_parts(ledger, e, p);
                is_proved = further.verdict == Verdict::proved;
                a.add("the further parts", further);
            }
            // where a proof stands for all of it already, the reading only refutes
            if (read.verdict == Verdict::refuted || !is_proved) a.add("the whole print, each field", read);
        } else if (!e.definition) {
            a.add("what it should be", {Verdict::undecided, "nothing says so: \"follows\", \"over\", or \"is\" of the symbol on the left"});
        }
    } catch (const std::exception& wrong) { // a changed print that cannot be read
        a.add("it can be read", {Verdict::refuted, wrong.what()});
    }
    return a.conclude("", e.definition ? Verdict::definition : Verdict::proved);
}

namespace {

bool stands(const Finding& f)
{
    return f.verdict == Verdict::proved || f.verdict == Verdict::verified || f.verdict == Verdict::definition;
}

/// What follows from a print that is refuted and has no correction that holds, or from one of which nothing is known, is not proved by
/// that; nor what follows from it in turn.
void withdraw_what_rests_on_nothing(std::vector<OwnResult>& all)
{
    std::set<std::string> nothing;
    for (const OwnResult& r : all)
        if (!stands(r.corrected ? *r.corrected : r.finding)) nothing.insert(r.entry->print.id);
    const auto rests_on_nothing = [&](const std::string& id) { return nothing.count(id) > 0; };
    for (bool is_new = true; is_new;) {
        is_new = false;
        for (OwnResult& r : all) {
            const auto& sources = r.entry->rests_on;
            const auto source = std::find_if(sources.begin(), sources.end(), rests_on_nothing);
            if (source == sources.end()) continue;
            is_new = nothing.insert(r.entry->print.id).second || is_new;
            for (Finding* f : {&r.finding, r.corrected ? &*r.corrected : nullptr})
                if (f && stands(*f)) {
                    f->verdict = Verdict::undecided;
                    f->reason = "(" + *source + "), from which it follows, is not known to hold as it stands";
                }
        }
    }
}

/// What follows from a bound, or from what follows itself, that is looked at at some points alone is known no better; nor is that into
/// which an equation known no better is put. (An equation that stands at the beginning is what the others are said to follow from.)
void withdraw_proofs_from_samples(std::vector<OwnResult>& all)
{
    std::set<std::string> verified, handed_on;
    for (const OwnResult& r : all) {
        if ((r.corrected ? *r.corrected : r.finding).verdict != Verdict::verified || r.entry->table) continue;
        verified.insert(r.entry->print.id);
        if (r.entry->follows || is_bound(right_form(*r.entry).text("relation"))) handed_on.insert(r.entry->print.id);
    }
    for (bool is_new = true; is_new;) {
        is_new = false;
        for (OwnResult& r : all) {
            const auto& sources = r.entry->rests_on;
            const auto source = std::find_if(sources.begin(), sources.end(), [&](const std::string& id) {
                return handed_on.count(id) > 0 || (id != sources.front() && verified.count(id) > 0);
            });
            if (source == sources.end()) continue;
            is_new = handed_on.insert(r.entry->print.id).second || is_new;
            for (Finding* f : {&r.finding, r.corrected ? &*r.corrected : nullptr})
                if (f && f->verdict == Verdict::proved) {
                    f->verdict = Verdict::verified;
                    f->reason += "; (" + *source + "), from which it follows, is verified";
                }
        }
    }
}

} // namespace

std::vector<OwnResult> judge_all(const OwnLedger& ledger)
{
    must_have_their_signs(ledger);
    std::vector<OwnResult> all;
    for (const OwnEntry& e : ledger.entries) {
        OwnResult r{&e, judge_own(ledger, e, e.print), {}};
        if (e.correction) r.corrected = judge_own(ledger, e, right_form(e));
        all.push_back(std::move(r));
    }
    withdraw_what_rests_on_nothing(all);
    withdraw_proofs_from_samples(all);
    return all;
}

int OwnMutation::unexcused() const
{
    return static_cast<int>(std::count_if(survivors.begin(), survivors.end(), [](const OwnSurvivor& s) { return s.excuse.empty(); }));
}

OwnMutation mutate_own(const OwnLedger& ledger, const std::string& id)
{
    OwnMutation m;
    must_have_their_signs(ledger);
    for (const OwnEntry& e : ledger.entries) {
        if (!id.empty() && e.print.id != id) continue;
        if (e.definition && !readable(ledger, e)) {
            m.unjudged.push_back(e.print.id);
            continue;
        }
        for (const Change& change : typesetters_changes(right_form(e))) {
            ++m.changes;
            const Finding f = judge_own(ledger, e, change.print);
            if (f.verdict == Verdict::refuted) {
                ++m.refuted;
                continue;
            }
            const auto excuse = e.excuses.find(change.name);
            m.survivors.push_back(
                {e.print.id, change.name, change.kind, std::string(name(f.verdict)), excuse == e.excuses.end() ? "" : excuse->second});
        }
    }
    return m;
}

} // namespace touchstone::proofs
