// SPDX-License-Identifier: MIT
/// \file
/// Why C(G) = lim A_n G^n/(lambda_0 load) is what it is: a certificate (docs/certificate.md).
///
/// In partial contact, for any m and numbers w_j of sum 1, C(G) is the limit of the mean of sum w_j h_{m+j}. The w_j are found so that this
/// sum hardly depends on the load ratio; nobody has to trust how. With full contact, G < 2.009: by Poisson's equation
/// (certificate/poisson.hpp).
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <string>
#include <vector>

namespace touchstone::certificate {

constexpr long most_digits_of_a_limit = 40;
/// 1.02 <= G <= 2^20. \returns why not; empty: there is a certificate
std::string refusal_of_limit(const Root& G);

/// A certificate of C(G) for each G, to so many digits.
/// \pre refusal_of_limit() is empty for each \throws BeyondReach where the digits are not reached
std::string limit_constants(const std::vector<Root>&, Accuracy);

} // namespace touchstone::certificate
