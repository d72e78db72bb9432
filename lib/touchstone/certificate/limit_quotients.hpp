// SPDX-License-Identifier: MIT
/// \file
/// The lines mean and quotient: limiting shares of the area and of the force above a pressure and of segments, full contact included
/// (docs/certificate.md, lemma W). Internal to certificate/.
#pragma once

#include "touchstone/certificate/limit_distributions.hpp"
#include "touchstone/certificate/text.hpp"

namespace touchstone::certificate {

constexpr long most_digits_of_quotients = 9;

/// \returns why there is none; empty: there is a certificate
std::string refusal_of_quotient(const LimitClaim&);

/// Appends a section of these claims, all of one kind and G, to the header and the lines. \pre 1.02 <= G < 2.05
/// \throws BeyondReach where a mesh would be too large, or a mean is too small
void write_quotients(const std::vector<LimitClaim>&, long digits, std::size_t first_claim, std::size_t section, std::string& head, Lines&);

} // namespace touchstone::certificate
