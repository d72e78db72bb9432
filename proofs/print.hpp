// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The print: what the source text says, as data that a judge can read and a control can perturb.
///
/// data/paper/equations.json holds the numbered equations, sentences.json the checkable sentences.
/// Nothing there is repaired; a corrected form exists only as an edit of the print.
#pragma once

#include "touchstone/scalar/rational.hpp"

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

namespace touchstone::proofs {

using GiNaC::ex;

/// The symbol of that name, the same one throughout the process. All are positive except the
/// few that need not be (coordinates, exponents, Poisson's ratio).
ex sym(const std::string& name);

/// Read a formula. Decimals are exact: 0.2 is 1/5. \throws std::exception if it is not one.
ex read(const std::string& text);

/// e with what is put for its symbols, all at once. \throws std::length_error before a number that would be too long is made
ex with_put_in(const ex& e, const GiNaC::exmap& with);

/// Replace the first `from` in a field of the print by `to`.
struct Edit {
    std::string field; ///< "rhs" (of the first part), "1.rhs" (of the second), "J.integrand" (of piece J), ...
    std::string from, to;
};

class Print {
public:
    std::string id, section, tex, domain, quote, statement;
    std::map<std::string, std::string> fields; ///< "0.lhs", "0.rhs", "J.integrand", ...

    bool has(const std::string& field) const { return fields.count(full_name(field)) != 0; }
    /// \throws std::out_of_range if the print has no such field.
    const std::string& text(const std::string& field) const;
    ex operator()(const std::string& field) const { return read(text(field)); }
    /// A number printed as such. \throws std::invalid_argument if it is none.
    Rational rational(const std::string& field) const;
    std::size_t parts() const;
    /// The sides of a chain of inequalities such as "0 < p < 2*sqrt(pstar*pbar)".
    std::vector<ex> sides(const std::string& field) const;
    /// \throws std::invalid_argument if an edit does not apply: a control that changes nothing tests nothing.
    Print edited(const std::vector<Edit>&) const;

private:
    static std::string full_name(const std::string& field);
};

/// All prints by id, from the transcription compiled into the program.
const std::map<std::string, Print>& prints();
/// The ids in the order of the files.
const std::vector<std::string>& print_order();

} // namespace touchstone::proofs
