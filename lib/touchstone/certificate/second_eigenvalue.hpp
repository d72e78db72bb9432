// SPDX-License-Identifier: MIT
/// \file
/// Why the second eigenvalue is what it is, G >= 2.2: a certificate (docs/certificate.md, Z; docs/limit.md, theorem 8).
///
/// It says a function w of log s, as a polynomial, and nothing else: the checker finds how far w is from an eigenfunction, and what that
/// leaves open.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <string>
#include <vector>

namespace touchstone::certificate {

constexpr long most_digits_of_an_eigenvalue = 10;

/// 2.2 <= G <= 2^20. \returns why not; empty: there is a certificate
std::string refusal_of_eigenvalue(const Root& G);

/// A certificate of limit.gap for each G, to so many digits. \pre refusal_of_eigenvalue() is empty for each
std::string second_eigenvalues(const std::vector<Root>&, Accuracy);

} // namespace touchstone::certificate
