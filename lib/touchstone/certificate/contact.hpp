// SPDX-License-Identifier: MIT
/// \file
/// Why an area, a share above a pressure or a density is what it is: a text that a program sharing nothing with this one can check.
///
/// The text is `TOUCHSTONE-CERT 1` of docs/certificate.md, the checker is checker/certificate.py. What is here is a search: nobody has to
/// trust it.
/// In partial contact (G >= 2.05, load <= 1) a certificate of areas holds, for each G, a quadrature rule of T, panels of s = -log x,
/// polynomials V_m on them with a bound of |h_m - V_m|, h_m(x) = G^m A_m(x)/(x lambda_0), and the values that follow; one of shares and
/// densities holds, for each G and load, the densities of the load ratios by pieces; else a mesh and polynomials on it.
/// How to use it:
///
///     const Root G{Rational(5), 2};                                                    // 5^(1/2)
///     const std::string text = certificate::contact({{3, Rational(1, 10), G}}, {30});
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <string>
#include <vector>

namespace touchstone::certificate {

/// What is claimed, and where.
struct Claim {
    enum class Of {
        area,    ///< A_n/lambda_0 (6.7)
        share,   ///< of lambda_0 above the pressure `at` > 0, in p*_0, at scale n
        density, ///< q_n p*_0 (6.1) at the pressure `at` > 0
        segments ///< the density (9.3) of segments of half-width `at`, in lambda_n, 0 < at < 1/2, n >= 2
    };
    long n = 1;
    Rational load;
    Root G;
    Of of = Of::area;
    Rational at = 0;
};

inline constexpr long largest_n = 60;    ///< errors grow by up to 4 a level
inline constexpr long most_digits = 120; ///< of areas in partial contact
/// 51/50 <= G <= 2^20, 2^-40 <= load <= 1000, 1 <= n <= largest_n; segments in partial contact, densities with full contact from n = 2 on.
/// \returns why not; empty: there is a certificate
std::string refusal(const Claim&);
/// G >= 41/20 and load <= 1: areas to any digits; with full contact there are fewer.
bool only_partial(const Claim&);

/// A certificate of claims of one kind, to so many digits, sections by G (and load or pressure) in the order in which they first come.
/// What does not reach its digits is left out. \pre refusal() is empty for each \throws BeyondReach where nothing reaches them
std::string contact(const std::vector<Claim>&, Accuracy);

} // namespace touchstone::certificate
