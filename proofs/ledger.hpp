// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The ledger: one verdict for each numbered equation and checkable sentence of the paper.
///
/// A claim is judged by a function that is handed the *print* (print.hpp), the transcribed equation
/// as data, and knows how to derive what should stand there. The same function judges three things:
/// the print itself, its perturbed versions (the negative controls, which must come out refuted), and,
/// where the print is false, the corrected form (which must come out proved). A judge that would
/// accept anything is thereby found out.
#pragma once

#include "proofs/print.hpp"

#include <functional>
#include <iosfwd>
#include <optional>
#include <source_location>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::proofs {

enum class Verdict {
    proved,      ///< as printed, for all parameters in its domain
    verified,    ///< as printed, at every digit printed or every point tried in balls
    refuted,     ///< as printed it is false
    argued,      ///< proved but for a step that words carry and no program checks
    definition,  ///< nothing to prove
    qualitative, ///< judged by a stated number
    undecided,   ///< neither proved nor refuted here; the reason says what is missing
};
std::string_view name(Verdict);

/// What one check of an argument says, and by what it says so.
struct Check {
    Verdict verdict = Verdict::undecided;
    std::string detail;
    std::string lemma = {}; ///< "area_bounds proofs/lemmas/area_bounds.cpp:96", if a lemma said it
};
/// The same check, said by the function that calls this.
Check as_lemma(Check, const std::source_location& = std::source_location::current());

/// What a judge hands back.
struct Finding {
    Verdict verdict = Verdict::undecided;
    std::string method;
    std::vector<std::string> steps; ///< each lemma in order, with what its check said
    std::string reason;             ///< of a refuted claim the counterexample; else what the verdict rests on
    std::string judge = {};               ///< "proofs/section_7.cpp:58"
    std::vector<std::string> lemmas = {}; ///< as Check::lemma, each once
    std::vector<std::string> rows = {};   ///< of data/paper/values.txt that were asked for
};

/// An argument reduced to lemmas, each checked. It proves if all its checks do; one refuted check refutes it; with a step
/// that only words carry it is argued; anything else leaves it undecided.
class Argument {
public:
    explicit Argument(std::string method, const std::source_location& = std::source_location::current());
    /// A lemma and what its check said.
    Argument& add(const std::string& lemma, const Check& check);
    /// A step that the proof needs and no program checks.
    Argument& argue(const std::string& text);
    /// A remark, or a step of a line's arithmetic: it is shown, and never decides.
    Argument& note(const std::string& text);
    /// The finding if every check passed; `passed` is the verdict that then holds.
    Finding conclude(const std::string& reason = {}, Verdict passed = Verdict::proved) const;

private:
    Finding finding_;
    Verdict worst_ = Verdict::proved;
    int checks_ = 0;
};

/// Where a false print goes wrong and what holds instead.
struct Correction {
    std::string fault;             ///< misprint, wording or substance
    std::string wrong;             ///< the first wrong place
    std::string corrected;         ///< the form that holds, for a person
    std::vector<Edit> edits;       ///< what turns the print into it
    std::string consequence;       ///< who inherits the error, and what a code that trusts the print gets wrong
};

/// A perturbed version of the print that must be refuted.
struct Control {
    std::string what;
    std::vector<Edit> edits;
};

struct Claim {
    std::string id;
    std::string statement;   ///< in words
    std::string assumptions;
    std::function<Finding(const Print&)> judge;
    std::vector<Control> controls;
    std::optional<Correction> correction;
    std::vector<std::string> rests_on; ///< ids of the claims it uses; a refuted one in its corrected form
};

/// The verdict on one claim and on its controls.
struct Entry {
    const Claim* claim = nullptr;
    Print print;
    Finding finding;
    std::optional<Finding> corrected;
    struct ControlResult { std::string what; Finding finding; };
    std::vector<ControlResult> controls;
    /// Controls that did not come out refuted, a correction that did not come out proved or argued, or
    /// a proof without any control: reasons not to believe this entry.
    std::vector<std::string> surviving() const;
};

/// The judge's finding, and what the whole print says against it (reading/reading.hpp): a lemma looks at what it is about, the
/// reader at every field. Where one refutes, it is refuted.
enum class Order { judge_first, reading_first };
Finding judge_whole(const Claim&, const Print&, Order = Order::judge_first);

/// Judge a claim against its print, and run its controls and its correction.
Entry run(const Claim&, const Print&);

/// The ids of a cycle in rests_on, the first repeated at the end; empty if there is none: a proof that rests on itself proves nothing.
std::vector<std::string> cycle(const std::vector<Claim>&);

/// All claims, in the order of the paper. \throws std::logic_error if they rest on one another in a cycle.
const std::vector<Claim>& claims();

/// The verdict recorded for a claim in data/paper/verdicts.txt; a changed one is a failure.
/// \throws std::out_of_range if none is recorded.
Verdict expected_verdict(const std::string& id);

/// One file for each section of the paper.
std::vector<Claim> section_2();
std::vector<Claim> section_3();
std::vector<Claim> section_5();
std::vector<Claim> section_6();
std::vector<Claim> section_7();
std::vector<Claim> section_8();
std::vector<Claim> section_9();
std::vector<Claim> table_1();
std::vector<Claim> sentences();
/// What contact codes test besides the paper (data/beyond).
std::vector<Claim> beyond();

} // namespace touchstone::proofs
