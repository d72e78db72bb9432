// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proof steps in balls: evaluation of an expression at exact points, and sign over a whole
/// parameter domain by subdivision.
#pragma once

#include "proofs/ledger.hpp"

#include "touchstone/scalar/ball.hpp"

#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::proofs {

/// Exact parameter values, written "pbar=3/2 pstar=1".
using Point = std::map<std::string, Rational>;
Point point(const std::string& text);

/// The points at which a failed identity is looked at for a counterexample.
class Points {
public:
    Points() = default;
    Points(std::initializer_list<const char*> texts) { for (const char* t : texts) all_.push_back(point(t)); }
    explicit Points(std::vector<Point> all) : all_(std::move(all)) {}
    auto begin() const { return all_.begin(); }
    auto end() const { return all_.end(); }
    bool empty() const { return all_.empty(); }

private:
    std::vector<Point> all_;
};
std::string str(const Point&);

/// Encloses e where each symbol has the given enclosure. \throws std::invalid_argument if a
/// symbol has none or a function is unknown.
Ball evaluate(const ex& e, const std::map<std::string, Ball>& values);
Ball evaluate(const ex& e, const Point&);

/// left and right compared at the points: disjoint enclosures refute, else nothing is decided. A point where
/// one side has no value is named.
Check compare_at(const ex& left, const ex& right, const Points&);
/// Both sides have a finite enclosure at every point.
bool evaluates_at(const ex& left, const ex& right, const Points&);

struct Range {
    std::string symbol;
    Rational low, high;
};
/// Whether 0 itself is let in. A bound that is reached inside the box is then not refuted; nor, as a rule, proved: no piece about the place
/// decides it.
enum class Bound { strict, may_be_reached };
inline constexpr int usual_pieces = 20'000; ///< beyond as many a sign is left undecided
/// e > 0 (or e >= 0) on the whole box, by subdivision until every piece is decided.
Check positive_on(const ex& e, const std::vector<Range>& box, int most_pieces = usual_pieces, Bound = Bound::strict);
/// The same of a function of as many balls as there are ranges.
using BallFunction = std::function<Ball(const std::vector<Ball>&)>;
Check positive_over(const BallFunction& f, const std::vector<Range>& box, int most_pieces = usual_pieces, Bound = Bound::strict);

/// a < b, decided in balls.
Check less_than(const Ball& a, const Ball& b, const std::string& what);

} // namespace touchstone::proofs
