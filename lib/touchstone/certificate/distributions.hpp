// SPDX-License-Identifier: MIT
/// \file
/// The lines law, piece and reading: shares above a pressure and densities in partial contact (docs/certificate.md). Internal to
/// certificate/.
///
/// The search is in binary64 or pairs of it (law_pieces.hpp): x_m = p_(m-1)/p*_m has the density x phi_m(T), T = 1 - (x/Y_m)^2, on 0 < x <
/// Y_m, and phi_m is T^(power/2) times a polynomial on each of some pieces of 0 <= T <= 1.
#pragma once

#include "touchstone/certificate/contact.hpp"
#include "touchstone/certificate/law_pieces.hpp"
#include "touchstone/certificate/text.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace touchstone::certificate {

constexpr long most_digits_of_distributions = 10;

/// Why a share or density in partial contact needs none: its pressure or half-width is at its end or beyond. Empty: it needs one.
std::string exact_end(const Claim&);
/// Beyond the first law, which is known, loads next to 1 would need too many pieces.
bool law_serves(const Claim&);

/// Appends a section of these shares or densities, all of one G and one load, to the header and the lines.
/// \throws BeyondReach where the pieces would be too many
void write_distributions(const std::vector<Claim>&, long digits, std::size_t first_claim, std::size_t section, std::string& head, Lines&);

template <class Real>
class Laws;

/// The law of one load, level by level.
template <class Real>
class LawOfLoad {
public:
    /// \throws BeyondReach where the pieces would be too many
    LawOfLoad(const Root& G, const Rational& load, long levels);
    /// Of A_n, above the pressure P p*_n; n at most the number of levels.
    Real share(long n, const Rational& P) const;
    /// Appends it with so many levels, |phi_m - V_m| <= (m - 1) 2^-bits V_m. \returns by n - 1 what a share at scale n rests on
    std::vector<std::vector<std::size_t>> write(long levels, int bits, Lines&) const;

private:
    Root G_;
    Rational load_;
    std::shared_ptr<const Laws<Real>> laws_;
};
extern template class LawOfLoad<double>;
extern template class LawOfLoad<Wide>;

/// 1 - T of the law of scale n at the pressure P p*_n; not below 1: there is none above.
Ball rest_at_level(const Root& G, const Rational& load, long n, const Rational& P);

} // namespace touchstone::certificate
