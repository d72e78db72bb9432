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

/// Above `at`/G^scale, in p*_n whatever n is; 0: in contact.
struct Pressure {
    Rational at = 0;
    long scale = 0;
};
/// Shares of lambda_0, and the lines that they rest on.
struct WrittenShares {
    std::vector<std::size_t> lines; ///< a mesh and its polynomials
    std::vector<Ball> values;
};
/// Of these n and loads, all of one G. \param goal relative error
/// \throws BeyondReach where the mesh would be too large, or does not come below the goal
WrittenShares write_shares(const std::vector<Claim>&, const Pressure&, double goal, Lines&);

/// Appends a section of these areas, all of one G, to the header and the lines.
/// \throws BeyondReach where the mesh would be too large, or does not give the digits
void write_full_contact(const std::vector<Claim>&, long digits, std::size_t first_claim, std::size_t section, std::string& head, Lines&);

} // namespace touchstone::certificate
