// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_sides.hpp"

#include "proofs/symbols.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <regex>
#include <set>

namespace touchstone::proofs {

namespace {

/// The number of a symbol in a set of samples, inside its range and exact.
Rational sample(const OwnSymbol& s, std::size_t index, int set)
{
    const long steps = 23; // prime, so that no two symbols keep step
    const long k =
        static_cast<long>((index * 7 + static_cast<std::size_t>(set) * 5 + index * static_cast<std::size_t>(set)) % (steps - 1)) + 1;
    return s.low + (s.high - s.low) * Rational(k, steps);
}

} // namespace

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

namespace {

void take_value(const OwnLedger& ledger, const std::string& name, Situation& s);

} // namespace

Ball value_of(const OwnLedger& ledger, const ex& e, Situation& s)
{
    const std::function<void(const ex&)> need = [&](const ex& part) {
        if (GiNaC::is_a<GiNaC::symbol>(part)) take_value(ledger, GiNaC::ex_to<GiNaC::symbol>(part).get_name(), s);
        for (std::size_t i = 0; i < part.nops(); ++i) need(part.op(i));
    };
    need(e);
    return evaluate(e, s.value);
}

namespace {

void take_value(const OwnLedger& ledger, const std::string& name, Situation& s)
{
    if (s.value.count(name)) return;
    const std::string& is = ledger.symbols.at(name).is;
    if (!is.empty()) s[name] = value_of(ledger, read(is), s);
}

} // namespace

Situation situation(const OwnLedger& ledger, int set)
{
    Situation s;
    s.agreeing_is_equal = false;
    for (const auto& [name, value] : samples(ledger, set))
        if (ledger.symbols.at(name).is.empty()) s[name] = Ball(value);
    for (const auto& [name, symbol] : ledger.symbols) take_value(ledger, name, s);
    return s;
}

Print right_form(const OwnEntry& e) { return e.correction ? e.print.edited(e.correction->edits) : e.print; }

ex written_out(const OwnLedger& ledger, const OwnEntry& entry, const ex& e)
{
    return written_out(ledger, e, [&](const std::string& name) {
        return std::none_of(entry.over.begin(), entry.over.end(), [&](const Range& r) { return r.symbol == name; });
    });
}

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

ex with_references(const OwnLedger& ledger, const std::string& t)
{
    std::string out, rest = t;
    for (std::smatch m; std::regex_search(rest, m, reference()); rest = m.suffix())
        out += m.prefix().str() + "(" + right_form(ledger.at(m[1])).text("rhs") + ")";
    return read(out + rest);
}

GiNaC::lst replacements(const OwnLedger& ledger, const Follows& f)
{
    GiNaC::lst with;
    for (const auto& [symbol, by] : f.with) with.append(sym(symbol) == with_references(ledger, by));
    return with;
}

ex replaced(const OwnLedger& ledger, ex e, const GiNaC::lst& with)
{
    for (const ex& one : with)
        if (!is_the_same_in_other_words(ledger, one.lhs(), one.rhs())) e = without_hidden(ledger, e, one.lhs());
    GiNaC::exmap all;
    for (const ex& one : with) all[one.lhs()] = one.rhs();
    return with_put_in(e, all);
}

ex derived(const OwnLedger& ledger, const Follows& f)
{
    ex e = right_form(ledger.at(f.equation))(f.side);
    if (!f.derivative_by.empty()) {
        const ex by = sym(f.derivative_by);
        e = without_hidden(ledger, e, by).diff(GiNaC::ex_to<GiNaC::symbol>(by));
    }
    return replaced(ledger, e, replacements(ledger, f));
}

namespace {

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

} // namespace

bool is_bound(const std::string& relation) { return relation == "<" || relation == ">" || relation == "<=" || relation == ">="; }

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

namespace {

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

} // namespace

Check same(const Where& where, const ex& print, const ex& wanted)
{
    const Check as_written = same_as_written(where, print, wanted);
    const ex print_in_full = written_out(where.ledger, print), wanted_in_full = written_out(where.ledger, wanted);
    if (as_written.verdict == Verdict::proved || (print_in_full.is_equal(print) && wanted_in_full.is_equal(wanted))) return as_written;
    return same_as_written(where, print_in_full, wanted_in_full);
}

} // namespace touchstone::proofs
