// SPDX-License-Identifier: MIT
/// \file
/// Why a contact area is what it is: a text that a program sharing nothing with this one can check.
///
/// The text is `TOUCHSTONE-CERT 1` of docs/certificate.md, the checker is checker/certificate.py. What is here is a search: nobody has to
/// trust it.
/// In partial contact (G >= 2.05, load <= 1) a certificate holds, for each G, a quadrature rule of T, panels of s = -log x, polynomials V_m
/// on them with a bound of |h_m - V_m|, h_m(x) = G^m A_m(x)/(x lambda_0), and the values that follow; else a mesh and polynomials on it.
/// How to use it:
///
///     const Root G{Rational(5), 2};                                                    // 5^(1/2)
///     const std::string text = certificate::areas({{3, Rational(1, 10), G}}, {30});
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <string>
#include <vector>

namespace touchstone::certificate {

/// A_n/lambda_0 (6.7) at these inputs, or the share of lambda_0 above the pressure p > 0, in p*_0.
struct Area {
    long n = 1;
    Rational load;
    Root G;
    Rational p = 0;
};

inline constexpr long largest_n = 60;    ///< errors grow by up to 4 a level
inline constexpr long most_digits = 120; ///< in partial contact
/// 51/50 <= G <= 2^20, 2^-40 <= load <= 1000, 1 <= n <= largest_n. \returns why not; empty: there is a certificate
std::string refusal(const Area&);
/// G >= 41/20 and load <= 1: any digits; with full contact there are fewer.
bool only_partial(const Area&);

/// A certificate of these areas, or shares all with p > 0, to so many digits, sections by G in the order in which they first come. What
/// does not reach its digits is left out. \pre refusal() is empty for each \throws BeyondReach where nothing reaches them
std::string areas(const std::vector<Area>&, Accuracy);

} // namespace touchstone::certificate
