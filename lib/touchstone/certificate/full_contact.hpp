// SPDX-License-Identifier: MIT
/// \file
/// The lines mesh, polynomials and share: areas at any load and any G, full contact included (docs/certificate.md).
/// Internal to certificate/.
#pragma once

#include "touchstone/certificate/contact.hpp"
#include "touchstone/certificate/text.hpp"
#include "touchstone/scalar/double_double.hpp"

namespace touchstone::certificate {

constexpr long highest_load = 1000;
constexpr long most_digits_in_full_contact = 12;

/// x in units of 2^-b, rounded.
mpz_class units(const DoubleDouble<double>& x, long b);

/// Appends a section of these areas, all of one G, to the header and the lines.
/// \throws BeyondReach where the mesh would be too large, or does not give the digits
void write_full_contact(const std::vector<Claim>&, long digits, std::size_t first_claim, std::size_t section, std::string& head, Lines&);

} // namespace touchstone::certificate
