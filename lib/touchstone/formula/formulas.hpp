// SPDX-License-Identifier: MIT
/// \file
/// The formulas of the catalogue as source code in other languages.
#pragma once

#include "touchstone/formula/term.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::formula {

/// One quantity as expressions in its inputs.
struct Formula {
    std::string name;                ///< "westergaard.pressure"
    std::vector<std::string> inputs; ///< those left open, in the quantity's order
    Term stable;                     ///< free of cancellation: what the library itself computes with
    std::optional<Term> printed;     ///< as the paper has it
};

/// \param n the scale, where the quantity has one: the recursion is written out for it
/// \throws DomainError for a quantity that is no closed formula, or lacks n
Formula formula_of(std::string_view quantity, std::optional<long> n);

/// What emit() can write.
inline const std::vector<std::string>& languages()
{
    static const std::vector<std::string> all{"latex", "c", "fortran", "python", "julia", "octave", "fpcore", "sympy"};
    return all;
}

/// Source text, complete in itself: functions NAME (stable) and NAME_as_printed with the inputs as arguments, and what they call.
/// Code has binary64 arithmetic and gives the library's own accuracy; latex, fpcore and sympy are the mathematics.
std::string emit(const Formula&, std::string_view language);

/// The name of a quantity as languages take it: westergaard_pressure.
std::string identifier(std::string quantity);

/// The helper functions that formulas call, each as an expression in its parameters (scalar.hpp's compound operations for `double`).
struct Helper {
    std::vector<std::string> parameters; ///< names, in order
    Term body;                           ///< the value, in the parameters
};
const std::map<std::string, Helper>& helpers(); ///< by name
/// The same as mathematics, in which nothing is rounded. Unchanged if it is no helper.
Term mathematical(const Term& call);

} // namespace touchstone::formula
