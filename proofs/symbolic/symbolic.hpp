// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proof steps on expressions. "Proved" here means: the difference of both sides was reduced to
/// zero by GiNaC's normal() after rewriting that is justified beside it. What does not reduce is
/// evaluated in balls at exact points: disjoint enclosures refute it; otherwise it stays undecided.
#pragma once

#include "proofs/enclosure/enclosure.hpp"
#include "proofs/ledger.hpp"

#include <string>
#include <utility>
#include <vector>

namespace touchstone::proofs {

std::string str(const ex&);

/// Is e positive wherever its real symbols are real and its positive symbols positive? No means: not seen to be.
bool is_positive(const ex&);

/// Square roots and sines as algebraic elements: t with t^2 = a polynomial or rational
/// expression in what was adjoined before. An expression in them is zero if the numerator of its
/// normal form leaves remainder zero on division by every relation.
class Ring {
public:
    /// t = sqrt(square), t >= 0. Later sqrt(c^2 square), c a positive monomial, is rewritten as c t.
    ex root(const std::string& name, const ex& square);
    /// s = sin(w), c = cos(w), c^2 = 1 - s^2; sin(2w) and cos(2w) are rewritten in them.
    std::pair<ex, ex> angle(const std::string& name, const ex& w);
    ex rewrite(const ex&) const;
    bool zero(const ex&) const;
    /// e with the adjoined elements written out again.
    ex concrete(const ex& e) const;

private:
    struct Relation { ex t, square; };
    struct Angle { ex w, s, c; };
    std::vector<Relation> relations_;
    std::vector<Angle> angles_;
    bool is_angle_relation(const Relation& r) const;
};

/// left = right, by normal form in the ring.
Check identity(const ex& left, const ex& right, const Points&, const Ring& = {});
/// left = right for two products of powers of positive quantities, exponents symbolic: their
/// logarithms are equal by normal form (and their signs at a point: at least one is needed).
Check power_identity(const ex& left, const ex& right, const Points&);
/// The logarithm of the absolute value of a product of powers, with a symbol for each prime, pi, symbol, sum and function in it.
ex log_form(const ex&);

/// e > 0 for all positive values of its symbols: the numerator and the denominator of its normal
/// form have no negative coefficient. Otherwise a point where e <= 0 in balls refutes it.
Check positive(const ex& e, const Points&);

/// e -> value as x -> 0+, by series expansion with the leading term in normal form.
Check limit_at_zero(const ex& e, const ex& x, const ex& value, const Points&);

/// The condition printed in `field` says "left relation right" and nothing else: the direction by its sign, the bound by normal form.
Check condition_says(const Print&, const std::string& field, const ex& left, const std::string& relation, const ex& right, const Points&);

/// A statement decided by exact arithmetic outside GiNaC.
Check exactly(bool holds, const std::string& detail);

} // namespace touchstone::proofs
