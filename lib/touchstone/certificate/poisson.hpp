// SPDX-License-Identifier: MIT
/// \file
/// The lines mesh, polynomials and share or mean of the limit, full contact included (docs/certificate.md, lemmas W and X): a function near
/// the solution of Poisson's equation. Internal to certificate/.
#pragma once

#include "touchstone/certificate/text.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/scalar/exact_text.hpp"

namespace touchstone::certificate {

constexpr long most_digits_by_poisson = 9;

/// A mean E[f/x] of the limit, and the lines that it rests on.
struct WrittenMean {
    std::vector<std::size_t> lines; ///< a mesh and its polynomials
    Rational value;
    double error;
};
/// \param p what the line mesh says of the pressure asked about \param goal relative error
WrittenMean write_mean(const limit::Question&, const Rational& p, const Root& G, double goal, Lines&);

/// Appends a section of one claim to the header and the lines. \pre 1.02 <= G
void write_poisson(const Root& G, long digits, std::size_t claim, std::size_t section, std::string& head, Lines&);

} // namespace touchstone::certificate
