// SPDX-License-Identifier: MIT
/// \file
/// A quantity by name: what `touchstone eval`, the tables and the oracle work with.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/exact.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone {

/// The exact arguments of a quantity. Where D and gamma are asked, G may stand for both.
class Inputs {
public:
    Inputs() = default;
    /// By name, exact; brought to lowest terms, which comparisons of rational numbers rest on. \throws std::invalid_argument of a
    /// denominator 0
    explicit Inputs(std::map<std::string, Rational> values);
    bool has(const std::string& key) const { return values_.contains(key); } ///< whether it is given
    const Rational& real(const std::string& key) const { return values_.at(key); } ///< \throws std::out_of_range
    /// An input that the domain check has found to be an integer within a long.
    long integer(const std::string& key) const { return values_.at(key).get_num().get_si(); }
    const std::map<std::string, Rational>& values() const { return values_; } ///< all, by name
    /// `real(key)` as a ball, with its half-width if the inputs are a box.
    Ball ball(const std::string& key) const;
    /// The box of all inputs within these distances of this one. Only a Route that `takes_boxes` can use it.
    Inputs box(std::map<std::string, Rational> half_widths) const;

    /// G = gamma^(D-1) as an exact number. \throws NotExact where it has no such form.
    Exact G_exact() const;
    /// G = gamma^(D-1), enclosed at the working precision.
    Ball G_ball() const;
    /// How G compares with a rational number: always decided, exactly.
    int compare_G(const Rational& with) const;

private:
    Ball widened(Ball, const std::string& key) const;

    std::map<std::string, Rational> values_;
    std::map<std::string, Rational> half_widths_;
};

/// So many digits are proven by both routes, whichever they are.
inline constexpr long proven_twice = 100;

/// One way to compute a quantity: an enclosure at about the working precision.
struct Route {
    std::string name; ///< as `routes` of a table and of `eval --json` give it
    std::function<Ball(const Inputs&)> ball; ///< encloses the value
    /// Whether it also encloses all values over a box of inputs (it never looks at an input but as a ball).
    bool takes_boxes = false;
    long leads_up_to = any_digits; ///< beyond so many digits the next route is the first proof, since it takes less time there
    /// As second proof it looks at the first half of more than `proven_twice` digits, see looked_at_again(): the whole would take longer
    /// than all else.
    bool halved_as_second = false;
};

/// A proof of a value at certain inputs.
struct Proof {
    std::string name; ///< as `routes` of a table and of `eval --json` give it
    std::function<Ball(Accuracy)> ball; ///< encloses the value. \throws BeyondReach
    long digits = any_digits; ///< a second look at the value is asked for no more than these
};

/// A look at the value without proof.
struct Look {
    std::string name; ///< as `list QUANTITY` gives it
    std::function<Witness(Accuracy)> witness; ///< \throws BeyondReach
};

/// Dearer digits than this are not computed for the sake of binary64 alone.
constexpr double dear_seconds = 0.5;

/// What serves certain inputs: the proofs, and what looks at the value beside them.
struct Plan {
    /// The first decides the digits. A second one has to decide as many of them as it is asked for, alone; disjoint balls are a hard
    /// failure.
    std::vector<Proof> proofs = {};
    /// Of one proof, the first of them is the second look; without a proof, two or more of them make an estimate.
    std::vector<Look> witnesses = {};
    std::optional<Look> own_witness = {}; ///< a second look made for the one proof, before any of `witnesses`
    std::string shares = {};    ///< what a second look shares with the first proof, in words
    long most_digits = any_digits; ///< more are not certified
    std::string refusal = {};   ///< why there is no proof, or why not of more digits
    /// More digits take seconds: none is computed that was not asked for, not even for the sake of binary64.
    bool dear = false;
};

/// What is certified where, for a reader: a line of `touchstone list QUANTITY`.
struct Certified {
    std::string where;       ///< in words
    std::string digits;      ///< "any", or how many
    std::string proof;       ///< name; empty: only estimated there
    std::string second_look; ///< "proof NAME" or "witness NAME"
    std::string shares;      ///< what the two have in common; empty where that was not written down
};
/// A quantity of the paper: its name, what its inputs may be, and what computes it.
struct Quantity {
    std::string name;        ///< as typed: "westergaard.half_width"
    std::string equation;    ///< number in the paper
    std::string unit; ///< as `list` prints it
    std::string domain;      ///< in words, as `list` prints it
    std::vector<std::string> inputs; ///< their names, in order
    std::string description; ///< one line
    /// \throws DomainError with one line saying what is wrong and what would be right
    std::function<void(const Inputs&)> check;
    /// The value in exact arithmetic; throws NotExact where there is none. May be empty.
    std::function<Exact(const Inputs&)> exact;
    /// At least two, independent of one another; their balls must overlap. Empty where there is a plan.
    std::vector<Route> routes;
    /// Prints how the error of a value is made up, for `eval --explain`. May be empty.
    std::function<std::string(const Inputs&, long digits)> explain = {};
    /// The routes are worth a thread each at any number of digits.
    bool costly = false;
    /// What serves these inputs, where that is not the same everywhere. Empty: the routes. See plan_of().
    std::function<Plan(const Inputs&, Accuracy)> plan = {};
    /// The plan in words. Empty: all routes, everywhere in the domain. See certified_where().
    std::vector<Certified> certified = {};
    /// For many points: the binary64 number nearest to the value at binary64 inputs (in the order of `inputs`), proven once, or nothing
    /// where that takes evaluate(); zero is exact, any other value certified. May be empty.
    std::function<std::optional<double>(const double*)> nearest = {};
};

/// All quantities, in the order of the paper's sections.
const std::vector<Quantity>& catalogue();

/// What serves these inputs: the quantity's own plan, or all of its routes as proofs. Refers to both arguments.
Plan plan_of(const Quantity&, const Inputs&, Accuracy);
/// What is proven where, and what is independent of what.
std::vector<Certified> certified_where(const Quantity&);
/// By the first proof alone, to what the thread's precision is meant for. \throws BeyondReach
Ball first_ball(const Quantity&, const Inputs&);

/// \returns the quantity of that name, or nullptr
const Quantity* find_quantity(std::string_view name);

/// The name nearest to what was typed (edit distance), for an error message.
std::string nearest_name(std::string_view typed, const std::vector<std::string>& names);
std::vector<std::string> quantity_names(); ///< in the catalogue's order

/// The sections register their quantities here, one function for each file.
void add_westergaard(std::vector<Quantity>&); // section 2
void add_gap(std::vector<Quantity>&); ///< westergaard.gap, mean_gap, energy
void add_weierstrass(std::vector<Quantity>&); ///< section 3
void add_peaks(std::vector<Quantity>&); ///< section 5
void add_contact(std::vector<Quantity>&); ///< section 6, (8.1) and (9.3)
void add_archard(std::vector<Quantity>&); ///< section 7, (8.2) and (8.3)
void add_segments(std::vector<Quantity>&); ///< (9.4)
void add_limit(std::vector<Quantity>&); ///< the limits of large n

// ---- what domain checks are made of; each throws DomainError in the form "load = -1: must be > 0"
/// The general form: unless `holds`, the input `key` is refused. \throws DomainError
void require(bool holds, const Inputs&, const std::string& key, std::string_view what_would_be_right);
void require_integer(const Inputs&, const std::string& key, long least, long most); ///< from least to most
/// load > 0
void require_load(const Inputs&);
/// D in (1, 2) and gamma > 1, or G > 1
void require_surface(const Inputs&);

} // namespace touchstone
