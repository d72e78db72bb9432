// SPDX-License-Identifier: MIT
/// \file
/// The lines mesh, polynomials and share of a limit C(G), full contact included (docs/certificate.md, lemmas W and X): a function near the
/// solution of Poisson's equation. Internal to certificate/.
#pragma once

#include "touchstone/certificate/text.hpp"
#include "touchstone/scalar/exact_text.hpp"

namespace touchstone::certificate {

constexpr long most_digits_by_poisson = 9;

/// Appends a section of one claim to the header and the lines. \pre 1.02 <= G
void write_poisson(const Root& G, long digits, std::size_t claim, std::size_t section, std::string& head, Lines&);

} // namespace touchstone::certificate
