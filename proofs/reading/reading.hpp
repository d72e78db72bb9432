// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The whole of a printed claim, read: relation, condition and its direction, limits of sums, products and integrals,
/// each member of a chain, the left side.
///
/// A proof derives what should stand there and compares it with the part of the print it is about; what no lemma happens to look
/// at could be printed in any way. Here every field of the print is evaluated in balls in *situations*: exact
/// parameters, and for each symbol of the equation what it stands for, computed from the library's formulas and not from the print. In
/// each of them the relation must hold where the printed condition does, and must fail where it does not: a
/// condition is read as "exactly there", so that a case that is printed too narrow is found like one too wide.
/// Nothing is proved by this: it refutes, or lets the proof have the last word.
#pragma once

#include "proofs/ledger.hpp"

#include "touchstone/scalar/ball.hpp"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::proofs {

/// What every symbol of an equation is worth at some exact parameters.
struct Situation {
    std::map<std::string, Ball> value;
    /// Functions named in the print ("f", "Q_nm1"), at any argument.
    std::map<std::string, std::function<Ball(const Ball&)>> function;
    /// Symbols under a sum over n, by n.
    std::map<std::string, std::function<Ball(long)>> of_index;
    /// (of, by) -> value of a derivative.
    std::map<std::pair<std::string, std::string>, Ball> derivative;
    /// Limits of a symbol as n grows.
    std::map<std::string, Ball> limit;
    /// An integral over this variable is read pointwise, as its integrand where the variable lies between the limits: two integrals
    /// of an arbitrary density over it are equal if and only if these are.
    std::string pointwise;
    /// Infinite sums are read as their first terms, up to this index (3.7 and 3.10 do not converge).
    long last_term = 3;
    /// The relations ~ and -> (for large n) are looked at here only.
    bool large_n = true;
    /// Sides that agree to 60 bits are equal although one is surely a little less, as what a limit is approached by at large n. If not,
    /// nothing is approached: only sides whose enclosures overlap and are narrow for the working precision are taken for equal, and what
    /// has no enclosure is without a value only where an argument is surely outside a function's domain.
    bool agreeing_is_equal = true;
    /// Situations of one group differ in the pointwise variable alone: outside its condition the print must fail in one of them.
    std::optional<std::size_t> group;
    /// A point of equality of the condition. A print may leave it to another case; one that takes it in must hold there.
    bool at_equality = false;
    /// Where an inequality is itself the statement ("partial contact if and only if ..."): is it true here?
    std::optional<bool> wanted;

    Ball& operator[](const std::string& name) { return value[name]; }
};

struct Meaning {
    std::vector<Situation> situations;
    /// The parts whose conjunction `wanted` speaks of; the others must hold everywhere.
    std::set<std::size_t> stated;
    /// The statement is "if", not "if and only if": where the stated parts hold, `wanted` must be true, and they must hold somewhere.
    bool one_way = false;
    /// Each bound of an inequality is reached in some situation: it cannot be printed wider.
    bool bounds_are_reached = false;
    /// A situation in which balls do not decide leaves the print undecided. Else it says nothing, and a print of which nothing is ever
    /// decided is refuted: the paper's own are decided.
    bool every_situation_decides = false;
    /// A print may say less than it could: hold outside of its condition too, or whatever its symbols are, as x <= x. Else it is taken to
    /// say something in each part, and its condition to say "exactly there".
    bool may_say_less = false;
};

/// What the symbols of an equation mean, or nothing for entries that are not equations.
const Meaning* meaning(const std::string& id);

/// Refuted with the situation where the print fails, `verified` with the number of situations otherwise. Nothing for entries without a
/// meaning.
std::optional<Check> read_whole(const Print&);

/// One file for each group of sections.
void add_meanings_of_sections_2_3(std::map<std::string, Meaning>&);
void add_meanings_of_sections_5_6(std::map<std::string, Meaning>&);
void add_meanings_of_section_7(std::map<std::string, Meaning>&);
void add_meanings_of_sections_8_9(std::map<std::string, Meaning>&);
void add_meanings_of_sentences(std::map<std::string, Meaning>&);
void add_meanings_beyond(std::map<std::string, Meaning>&);

} // namespace touchstone::proofs
