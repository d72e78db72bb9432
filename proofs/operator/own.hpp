// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the program itself rests on: the lemmas of its operator (lib/touchstone/wave) and every constant of its proofs that a person
/// counted, each proved or refuted by a judge that is handed the constants. The judge is run once with the code's constants, and once for
/// each perturbed one, which it must refute: the same discipline as for the equations of the paper (ledger.hpp).
#pragma once

#include "proofs/enclosure/enclosure.hpp"
#include "proofs/ledger.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::proofs {

/// A number in the statement of a lemma: where the code has it as a binary64 number, exactly that one.
struct Constant {
    std::string name;
    double value;
};

/// The constants a judge is handed.
class Constants {
public:
    explicit Constants(const std::vector<Constant>& all) : all_(all) {}
    Ball ball(std::size_t i) const { return Ball::exactly(all_.at(i).value); }
    ex exact(std::size_t i) const;
    double number(std::size_t i) const { return all_.at(i).value; }

private:
    const std::vector<Constant>& all_;
};

struct OwnClaim {
    std::string id;        ///< as the code and docs/method.md call it
    std::string statement; ///< the constants as {0}, {1}, ...
    std::string used_in;   ///< files that rely on it
    std::vector<Constant> constants;
    std::function<Finding(const Constants&)> judge;
    struct Perturbed {
        std::size_t which;
        double value;
    };
    std::vector<Perturbed> controls;
};

struct CheckedLemma {
    const OwnClaim* claim = nullptr;
    std::string statement; ///< with the constants in it
    Finding finding;
    std::vector<Entry::ControlResult> controls;
    /// What speaks against it: not proved or verified, no control, a control that is not refuted.
    std::vector<std::string> failures() const;
};

CheckedLemma run(const OwnClaim&);

/// Something positive that is to lie below its bound at each of many points. How near it comes, and the mean share of its bound that it
/// takes, are said, to six digits: another choice of points, or another bound, is a change of what is on record (recorded.hpp).
class Worst {
public:
    void below(const Ball& value, const Ball& bound, const std::string& where);
    /// Verified, or refuted by the first point where it is not below.
    Check result() const;

private:
    std::string refuted_;
    double most_ = 0, sum_ = 0;
    int points_ = 0;
};

/// All of them: the operator's first.
const std::vector<OwnClaim>& own_claims();

// A file each: proofs/operator.cpp and proofs/operator/.
std::vector<OwnClaim> operator_claims();
std::vector<OwnClaim> approximation_claims();
std::vector<OwnClaim> partial_contact_claims();
std::vector<OwnClaim> full_contact_claims();
std::vector<OwnClaim> two_waves_claims();
std::vector<OwnClaim> distribution_claims();
std::vector<OwnClaim> rounding_claims();

} // namespace touchstone::proofs
