// SPDX-License-Identifier: MIT
/// \file
/// Why shares and densities in the limit n -> infinity are what they are: a certificate (docs/certificate.md), in partial contact.
///
/// The law of the load ratio that a wave leaves as it is, by pieces; how near it is to the limit the checker finds. Nobody has
/// to trust it.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <string>
#include <vector>

namespace touchstone::certificate {

/// limit.exceedance, limit.force or limit.density at the pressure `at`, in p*_n, or limit.segments at the half-width `at`, in lambda_n; or
/// how far scale n of a load is from the first of these, limit.distance.
struct LimitClaim {
    enum class Of { exceedance, force, density, segments, distance };
    Root G;
    Of of = Of::exceedance;
    Rational at;
    long n = 0;
    Rational load = 0;
};

constexpr long most_digits_of_limit_distributions = 10;
/// 41/20 <= G <= 2^20, and `at` neither at its end nor beyond. \returns why not; empty: there is a certificate
std::string refusal_of_limit_distribution(const LimitClaim&);

/// A certificate of claims of one kind, to so many digits, a section for each G (and load) in the order in which they first come.
/// Distances are known to 2 10^-17 or so, whatever the digits are; those of which that leaves nothing are left out.
/// \pre refusal_of_limit_distribution() is empty for each \throws BeyondReach where the pieces would be too many
std::string limit_distributions(const std::vector<LimitClaim>&, Accuracy);

} // namespace touchstone::certificate
