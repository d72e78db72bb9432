// SPDX-License-Identifier: MIT
/// \file
/// Inputs of a quantity from texts: the one way in for the command line, for rows of a file and for other languages.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace touchstone {

/// An input that the quantity does not take, lacks, or was given twice. One line.
class WrongKeys : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// KEY and VALUE.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// The keys are those of the quantity, once each; D and gamma may stand for G. \throws WrongKeys
void check_keys(const Quantity&, const std::vector<std::string>& keys);

/// Exact inputs. Each is what parse_exact() reads, and a rational number, but for G, which may be any root of one: G = b^(1/m) is kept as
/// gamma = b, D = 1 + 1/m, with which it is the same surface (3.3).
/// \throws WrongKeys, DomainError for a text that is no such number; the domain itself is not checked
Inputs read_inputs(const Quantity&, const NamedTexts&);

} // namespace touchstone
