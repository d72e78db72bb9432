// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_judge.hpp"

#include "proofs/mutation/typesetter.hpp"
#include "proofs/own/own_forbids.hpp"
#include "proofs/own/own_names.hpp"
#include "proofs/own/own_sides.hpp"
#include "proofs/own/own_symbols.hpp"
#include "proofs/own/own_values.hpp"
#include "proofs/reading/whole.hpp"
#include "proofs/symbols.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>

namespace touchstone::proofs {

namespace {

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

/// Whether the left side is a symbol that stands for nothing.
bool is_of_a_free_symbol(const OwnLedger& ledger, const Print& p)
{
    const auto left = ledger.symbols.find(p.text("lhs"));
    return left != ledger.symbols.end() && left->second.is.empty();
}

/// ... and is what the entry follows from, an equation. What is less than something is not known by that.
bool names_its_right_side(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    return e.follows && is_of_a_free_symbol(ledger, p) && right_form(ledger.at(e.follows->equation)).text("relation") == "=";
}

/// What a chain says beyond its first right side, which alone follows from another equation: equal as formulas, and bounds at the points
/// all over the ranges. Where a bound has no value it says nothing.
Check further_parts(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    const WorkingPrecision closer(bits_of_a_closer_look);
    GiNaC::lst with; // the left side is what it follows from
    GiNaC::exmap left;
    if (names_its_right_side(ledger, e, p)) left[sym(p.text("lhs"))] = derived(ledger, *e.follows);
    for (const auto& [name, is] : left) with.append(name == is);
    bool are_proved = true;
    for (std::size_t i = 1; i < p.parts(); ++i) {
        const std::string part = std::to_string(i) + ".", relation = p.text(part + "relation");
        if (relation == "=" && !p.has(part + "condition")) {
            const Check c = same({ledger, p, part, with}, with_put_in(p(part + "rhs"), left), with_put_in(p(part + "lhs"), left));
            if (c.verdict != Verdict::proved && c.verdict != Verdict::verified) return c;
            are_proved = are_proved && c.verdict == Verdict::proved;
            continue;
        }
        are_proved = false;
        if (relation != "=" && !is_bound(relation)) continue;
        const ex gap = with_put_in(gap_of(ledger, e, p, part), left);
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
        if (surely_has_no_value(t.formula, at))
            return {Verdict::undecided, "at " + where + " the formula has no real value as it is written"};
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

/// What excuses nothing is misspelt, or of a print that has changed.
void must_excuse_a_change(const OwnLedger& ledger)
{
    for (const OwnEntry& e : ledger.entries) {
        if (e.excuses.empty()) continue;
        std::set<std::string> changes;
        for (const Change& change : typesetters_changes(right_form(e))) changes.insert(change.name);
        for (const auto& [change, reason] : e.excuses)
            if (!changes.count(change))
                throw OwnLedgerError(ledger.file + ": entry '" + e.print.id + "': excuses: no change '" + change + "' is made");
    }
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

/// A definition is believed where it gives a symbol its meaning that has none: what follows from something, or is of what stands for
/// something, is judged like any other entry.
bool is_believed(const OwnLedger& ledger, const OwnEntry& e)
{
    if (!e.definition || readable(ledger, e)) return false;
    const auto has_a_value = [&](const std::string& side) {
        const auto symbol = ledger.symbols.find(side);
        return symbol != ledger.symbols.end() && !symbol->second.is.empty();
    };
    const std::string left = e.print.text("lhs");
    const std::set<std::string> names = words(left);
    if (!ledger.symbols.count(left) && std::any_of(names.begin(), names.end(), has_a_value)) return false;
    bool is_any = has_a_value(left);
    for (std::size_t i = 0; e.print.parts() > 1 && i < e.print.parts(); ++i)
        is_any = is_any || has_a_value(e.print.text(std::to_string(i) + ".rhs"));
    return !is_any;
}

/// What the symbols of an entry are worth: the samples; the left side is what it follows from. Where what is put for a positive symbol is
/// positive by the printed condition, what it follows from says nothing outside of that.
Meaning meaning_of(const OwnLedger& ledger, const OwnEntry& e, const Print& p, bool only_inside)
{
    Meaning m;
    m.every_situation_decides = m.may_say_less = true;
    for (int set = 0; set < sample_sets; ++set) {
        if (only_inside && condition_at(ledger, p, "0.", {}, samples(ledger, set)) == Truth::no) continue;
        Situation s = situation(ledger, set);
        if (const std::string& left = e.print.text("lhs"); names_its_right_side(ledger, e, e.print)) {
            s.value.erase(left);
            s[left] = value_of(ledger, derived(ledger, *e.follows), s);
        }
        m.situations.push_back(std::move(s));
    }
    return m;
}

/// Read in balls of the usual width, and in much narrower ones: sides that agree to many bits may yet differ, and what wide balls leave
/// undecided narrow ones may decide.
Check read_closely(const OwnLedger& ledger, const OwnEntry& e, const Print& p, bool only_inside)
{
    const Check usual = read_whole_as(p, meaning_of(ledger, e, p, only_inside));
    const WorkingPrecision closer(bits_of_a_closer_look);
    const Check narrow = read_whole_as(p, meaning_of(ledger, e, p, only_inside));
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
        if (const auto no = value_forbids(ledger, e, p)) return a.add("a value as it is written", *no).conclude();
        if (e.follows) {
            const std::string what = "the right side follows from (" + e.follows->equation + ")";
            if (const auto no = hidden_dependence(whole, e)) return a.add(what, *no).conclude(); // of the rest nothing is known
            a.add(what, same({ledger, p, "0."}, p("rhs"), derived(ledger, *e.follows)));
            for (const Check& no : what_forbids(whole, ledger, e, p)) a.add(what, no);
        }
        if (!e.over.empty()) a.add("the bound", bounds(ledger, e, p));
        const auto signs = sign_forbids(whole, ledger, e, p);
        if (signs) a.add("signs over its ranges", *signs);
        if (a.conclude().verdict == Verdict::refuted) return a.conclude();
        if (e.follows && is_of_a_free_symbol(ledger, p) && !names_its_right_side(ledger, e, p)) {
            if (e.over.empty() && p.parts() > 1)
                a.add("the further parts", {Verdict::undecided, "what '" + p.text("lhs") + "' is worth is not said by a bound"});
        } else if (readable(ledger, e)) {
            const Check read = read_closely(ledger, e, p, e.follows && signs);
            bool is_proved = e.follows || !e.over.empty();
            if (e.follows && e.over.empty() && p.parts() > 1) { // the proof above is the first part's alone
                const Check further = further_parts(ledger, e, p);
                is_proved = further.verdict == Verdict::proved;
                a.add("the further parts", further);
            }
            // where a proof stands for all of it already, the reading only refutes
            if (read.verdict == Verdict::refuted || !is_proved) a.add("the whole print, each field", read);
        } else if (!is_believed(ledger, e)) {
            a.add("what it should be", {Verdict::undecided, "nothing says so: \"follows\", \"over\", or \"is\" of the symbol on the left"});
        }
    } catch (const std::length_error& wrong) {
        throw OwnLedgerError(whole.file + ": entry '" + e.print.id + "': " + wrong.what());
    } catch (const std::exception& wrong) { // a changed print that cannot be read
        a.add("it can be read", {Verdict::refuted, wrong.what()});
    }
    return a.conclude("", is_believed(whole, e) ? Verdict::definition : Verdict::proved);
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

namespace {

/// A change may make a number of a print too long.
Finding judge_changed(const OwnLedger& ledger, const OwnEntry& e, const Print& changed)
{
    try {
        return judge_own(ledger, e, changed);
    } catch (const OwnLedgerError& wrong) {
        return Argument("reading").add("it can be read", {Verdict::refuted, wrong.what()}).conclude();
    }
}

} // namespace

OwnMutation mutate_own(const OwnLedger& ledger, const std::string& id)
{
    OwnMutation m;
    must_have_their_signs(ledger);
    must_excuse_a_change(ledger);
    for (const OwnEntry& e : ledger.entries) {
        if (!id.empty() && e.print.id != id) continue;
        if (is_believed(ledger, e)) {
            m.unjudged.push_back(e.print.id);
            continue;
        }
        for (const Change& change : typesetters_changes(right_form(e))) {
            ++m.changes;
            const Finding f = judge_changed(ledger, e, change.print);
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
