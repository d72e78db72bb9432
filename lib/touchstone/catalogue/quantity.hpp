// SPDX-License-Identifier: MIT
/// \file
/// A quantity by name: what `touchstone eval`, the tables and the oracle work with.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/exact.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone {

/// A value that cannot be had at any precision in reach (series too long, regime not proven).
/// Leads to the status `undecided`, never to a guess.
class BeyondReach : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The exact arguments of a quantity. Where D and gamma are asked, G may stand for both.
class Inputs {
public:
    Inputs() = default;
    explicit Inputs(std::map<std::string, Rational> values) : values_(std::move(values)) {}
    bool has(const std::string& key) const { return values_.contains(key); }
    const Rational& real(const std::string& key) const { return values_.at(key); }
    /// An input that the domain check has found to be an integer within a long.
    long integer(const std::string& key) const { return values_.at(key).get_num().get_si(); }
    const std::map<std::string, Rational>& values() const { return values_; }
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

/// One way to compute a quantity: an enclosure at about the working precision.
struct Route {
    std::string name;
    std::function<Ball(const Inputs&)> ball;
    /// Whether it also encloses all values over a box of inputs (it never looks at an input but as a ball).
    bool takes_boxes = false;
};

/// A value found without proof, and how far off its own method thinks it is.
struct Estimate {
    Ball value; ///< radius zero
    Ball error; ///< >= 0; no bound
};

/// One way to compute a quantity where no certified route reaches.
struct EstimateRoute {
    std::string name;
    std::function<Estimate(const Inputs&)> estimate;
};

struct Quantity {
    std::string name;        ///< as typed: "westergaard.half_width"
    std::string equation;    ///< number in the paper
    std::string unit;
    std::string domain;      ///< in words, as `list` prints it
    std::vector<std::string> inputs;
    std::string description;
    /// \throws DomainError with one line saying what is wrong and what would be right
    std::function<void(const Inputs&)> check;
    /// The value in exact arithmetic; throws NotExact where there is none. May be empty.
    std::function<Exact(const Inputs&)> exact;
    /// At least two, independent of one another; their balls must overlap.
    std::vector<Route> routes;
    /// Prints how the error of a value is made up, for `eval --explain`. May be empty.
    std::function<std::string(const Inputs&, long digits)> explain = {};
    /// The routes are worth a thread each at any number of digits.
    bool costly = false;
    /// Two or more, independent of one another, for what the certified routes refuse with BeyondReach. May be empty.
    std::vector<EstimateRoute> estimates = {};
    /// What the routes are at these inputs, where they are not the same everywhere. May be empty.
    std::function<std::vector<std::string>(const Inputs&)> route_names = {};
    /// What limits the certified routes at these inputs. May be empty: nothing does.
    struct Limits {
        long digits = 10'000;       ///< more are refused before anything is computed
        bool first_decides = false; ///< the digits are the first route's alone; the others, of a wider ball, only have to overlap it
    };
    std::function<Limits(const Inputs&)> limits = {};
};

/// All quantities, in the order of the paper's sections.
const std::vector<Quantity>& catalogue();

/// \returns the quantity of that name, or nullptr
const Quantity* find_quantity(std::string_view name);

/// The name nearest to what was typed (edit distance), for an error message.
std::string nearest_name(std::string_view typed, const std::vector<std::string>& names);
std::vector<std::string> quantity_names();

/// The sections register their quantities here, one function for each file.
void add_westergaard(std::vector<Quantity>&);
void add_gap(std::vector<Quantity>&);
void add_weierstrass(std::vector<Quantity>&);
void add_peaks(std::vector<Quantity>&);
void add_contact(std::vector<Quantity>&);
void add_archard(std::vector<Quantity>&);
void add_segments(std::vector<Quantity>&);

// ---- what domain checks are made of; each throws DomainError in the form "load = -1: must be > 0"

void require(bool holds, const Inputs&, const std::string& key, std::string_view what_would_be_right);
void require_integer(const Inputs&, const std::string& key, long least, long most);
/// load > 0
void require_load(const Inputs&);
/// D in (1, 2) and gamma > 1, or G > 1
void require_surface(const Inputs&);

} // namespace touchstone
