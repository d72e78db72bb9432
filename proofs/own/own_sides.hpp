// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The sides of a print: where they are looked at, what they stand for, and when two of them are the same.
#pragma once

#include "proofs/own/own_symbols.hpp"
#include "proofs/reading/whole.hpp"

#include <string>
#include <vector>

namespace touchstone::proofs {

inline constexpr int sample_sets = 4;
inline constexpr slong bits_of_a_closer_look = 4096; ///< sides that differ by less than 10^-1200 are taken for equal

Point samples(const OwnLedger& ledger, int set);
std::string as_text(const Point& p);
/// Further points all over the ranges, and next to their ends: for formulas that no normal form compares and that may differ on a part
/// only. Where ranges do not fit together, as x below a, a formula has no value at some of them; those say nothing.
std::vector<Point> points_all_over(const OwnLedger& ledger);
/// e in the situation, whose symbols are computed as needed.
Ball value_of(const OwnLedger& ledger, const ex& e, Situation& s);
Situation situation(const OwnLedger& ledger, int set);
/// The print that others may rest on: corrected, where it has a correction.
Print right_form(const OwnEntry& e);
/// e with what its symbols stand for, down to those that have a range in the entry.
ex written_out(const OwnLedger& ledger, const OwnEntry& entry, const ex& e);
/// e with those symbols written out that stand for something in which `symbol` is.
ex without_hidden(const OwnLedger& ledger, const ex& e, const ex& symbol);
bool is_the_same_in_other_words(const OwnLedger& ledger, const ex& a, const ex& b);
/// "@H1 + x", with the right side of H1.
ex with_references(const OwnLedger& ledger, const std::string& t);
/// What is put for which symbols.
GiNaC::lst replacements(const OwnLedger& ledger, const Follows& f);
/// e with the replacements. What is put for a symbol reaches what stands for something with it in it too, unless it is that symbol in
/// other words, for which it may be put here and there.
ex replaced(const OwnLedger& ledger, ex e, const GiNaC::lst& with);
/// What the entry's right side must be.
ex derived(const OwnLedger& ledger, const Follows& f);
bool is_bound(const std::string& relation);
/// Whether the printed condition of a part, "0 < x <= a", surely holds at a point, with the symbols that `with` says otherwise; surely does
/// not; or neither is known.
Truth condition_at(const OwnLedger& ledger, const Print& p, const std::string& part, const GiNaC::lst& with, const Point& point);
/// Where two formulas have to be the same.
struct Where {
    const OwnLedger& ledger;
    const Print& print;
    std::string part; ///< of the print, whose condition says it
    GiNaC::lst with{};

    bool holds_at(const Point& point) const { return certainly(condition_at(ledger, print, part, with, point)); }
};
/// Whether the two are equal as they stand, or with what the symbols stand for.
Check same(const Where& where, const ex& print, const ex& wanted);

} // namespace touchstone::proofs
