// SPDX-License-Identifier: MIT
/// \file
/// Which proof serves which inputs: one table, and one function that chooses from it.
///
/// Everything that is said elsewhere about what is certified where (`touchstone list`, docs/certified.md, `--explain`) is printed from it.
#pragma once

#include "touchstone/recursion/problem.hpp"
#include "touchstone/scalar/second_look.hpp"

namespace touchstone::recursion {

/// A way to the value without proof.
struct Observer {
    std::string name;
    /// \throws BeyondReach where observers_refusal() says so, or where a grid gets too large
    std::function<Witness(const Problem&, Accuracy)> look;
};

/// A proof and its second look.
struct Method {
    std::string name;
    std::vector<Asked> asked;                                          ///< what it answers
    std::string reach;                                                 ///< `refusal` in words
    std::function<std::string(const Problem&)> refusal;                ///< why it does not serve this problem; empty: it does
    long digits = any_digits;                                          ///< more are not proven anywhere
    std::function<long(const Problem&)> fewer_digits = {};             ///< at these inputs; may be empty
    /// About so many seconds of one core, nothing being known yet: to compare methods with, not to promise.
    std::function<double(const Problem&, Accuracy)> cost;
    /// \throws BeyondReach where what depends on the numbers themselves (a mesh too large) cannot be had
    std::function<Ball(const Problem&, Accuracy)> enclose;
    std::function<Budget(const Problem&, Accuracy)> budget;
    std::string second = {};                                           ///< name of the second proof; empty: a witness looks
    std::function<Ball(const Problem&, Accuracy)> enclose_again = {};  ///< the second proof
    std::optional<Observer> witness = {}; ///< without a second proof, who looks; none: the first of observers()
    std::string shares = {};                                           ///< what the second look has in common with the proof

    long most_digits(const Problem&) const;
};
const std::vector<Method>& methods();

/// Two that serve all three laws, of different grids and rules. They look again at values that one method proves, and make an estimate
/// where none does.
const std::vector<Observer>& observers();
constexpr long observed_digits = 15;
std::string observers_reach(Asked);
/// Why there is no estimate of this; empty: there is one.
std::string observers_refusal(const Problem&);

/// What serves a problem.
struct Choice {
    const Method* method = nullptr; ///< the cheapest that proves so many digits, or else the one that proves most; none: see refusal
    long digits = 0;                ///< that it proves
    std::string refusal;            ///< why there is no method, or none for more digits
};
Choice choose(const Problem&, Accuracy);

/// What is certified where, and what only estimated, in one sentence.
std::string reach_in_words(Asked);

/// A row of the table, for readers.
struct Reach {
    std::string where, digits, proof, second_look, shares; ///< no proof: only estimated
};
std::vector<Reach> reach(Asked);
/// All rows, in Markdown: docs/certified.md.
std::string reach_as_table();

} // namespace touchstone::recursion
