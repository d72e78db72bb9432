// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the judges of sentences share: a sentence says that a quantity of which an enclosure is known stands in a relation to a number, or
/// names a bound below which something holds.
#pragma once

#include "proofs/enclosure/enclosure.hpp"
#include "proofs/ledger.hpp"

#include "touchstone/scalar/ball.hpp"

#include <optional>
#include <string>
#include <vector>

namespace touchstone::proofs {

inline const std::string the_model = "the model of sections 5 and 6: scales decoupled by (5.1)";
inline const std::string hertz_everywhere = "Hertzian contact at every scale";
inline const char* const at_the_loads = " (loads 0.001, 0.01, 0.1, 1; certified)";

inline ex G() { return sym("G"); }
inline ex n() { return sym("n"); }
inline Ball root(long r) { return sqrt(Ball(r)); }
/// G of figure 3a, gamma = 5 and D = 1.05.
Ball G_of_figure_3a();
/// (5.4) and (5.5) have one fixed point, reached from every start.
Check the_fixed_point();

/// A check that found the opposite of what was claimed.
Check opposite(Check);

/// "A < B" was proved; the print may say that or the weaker "A <= B", and no other.
Check says_less(const Print&, const std::string& what);
/// The same for "A > B" and "A >= B".
Check says_greater(const Print&, const std::string& what);

/// "quantity relation number", for a quantity of which an enclosure is known.
Check number_satisfies(const Ball& quantity, const Print&, const std::string& what);
/// The same for a share, which is neither below zero nor above one.
Check share_satisfies(const Ball& share, const Print&, const std::string& what);

/// "exact relation print": equality by normal form; where the print says < or >, a bound that is weaker than equality is true.
Check stated(const Print&, const ex& exact, const Points&);

/// Certainly inside the range.
Check within(const Ball& quantity, const Ball& range);

/// bound <= largest for all G > 1: a claim for loads below a smaller bound is true with it.
bool at_most_for_all_G(const ex& bound, const ex& largest);
/// The bound is a formula with a positive value at the point given.
std::optional<Ball> positive_bound(const ex& bound, const Point& at);
/// Neither a proof nor a counterexample for the bound printed.
Check between_proof_and_counterexample();

Finding not_computed(const std::string& what);

/// "a to b" of a hull, four digits.
std::string between(const Ball& hull);

/// log(A_n)/n tends to the printed slope: judged for a sentence and for figure 3.
Finding limiting_slope(const Print&);

/// One list for each file.
std::vector<Claim> sentences_of_sections_2_5();
std::vector<Claim> sentences_of_sections_6_7();
std::vector<Claim> sentences_of_sections_8_11();
std::vector<Claim> figures();

} // namespace touchstone::proofs
