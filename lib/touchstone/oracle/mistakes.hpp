// SPDX-License-Identifier: MIT
/// \file
/// The mistakes of convention that diagnose() tries, by name.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::oracle {

/// What a subject did to the inputs before a right formula. Nothing: it cannot be applied to this row.
struct InputMistake {
    std::string name;                                         ///< empty: none
    int cost;                                                 ///< the simpler of two explanations wins
    std::function<bool(std::map<std::string, Rational>&)> apply; ///< changes them; false: not here
};

/// What a subject multiplied the right value by.
struct OutputMistake {
    std::string name;                                         ///< empty: none
    int cost;
    std::function<double(const Inputs&)> factor; ///< at these inputs
};

/// Another formula altogether.
struct OtherFormula {
    std::string name;
    std::function<Ball(const Inputs&)> value; ///< at these inputs
};

std::vector<InputMistake> input_mistakes(const Quantity&); ///< that make sense for its inputs
std::vector<OutputMistake> output_mistakes(const Quantity&); ///< that make sense for its unit
std::vector<OtherFormula> other_formulas(const Quantity&); ///< of the same unit, misprints among them

} // namespace touchstone::oracle
