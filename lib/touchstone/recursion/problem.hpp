// SPDX-License-Identifier: MIT
/// \file
/// What can be asked of the recursion (6.1)-(6.7), and how the error of an answer is made up.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/exact.hpp"
#include "touchstone/scalar/rational.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::recursion {

enum class Asked {
    area,       ///< A_n/lambda_0 (6.7)
    exceedance, ///< share of lambda_0 on which p_n > p
    density     ///< q_n(p) p*_0 (6.1)
};

/// An input: enclosed at the thread's precision, any precision, and the number itself if it is of the form that decides ties.
struct Number {
    std::function<Ball()> ball;
    std::optional<Exact> exact;
};

/// One value of the recursion. Pressures are in units of p*_0; G = gamma^(D-1) > 1, load > 0, n >= 0.
struct Problem {
    Asked asked = Asked::area;
    long n = 0;
    Rational load;
    Number G;
    std::function<int(const Rational&)> compare_G; ///< sign of G - r, always decided
    Number p{};                                    ///< of exceedances, > 0, and densities, >= 0
};

/// The error of a value, part by part.
struct Budget {
    std::string text;
    std::vector<Budget> parts = {};
};

/// A part a line, indented by its depth.
std::string to_text(const Budget&);

/// p_n^max in p*_0: G^{n+1} x_n by (5.2), (5.6). At the thread's precision.
Ball highest_pressure(const Problem&);
/// p*_n/p*_0 = G^n
Ball unit_pressure(const Problem&);

} // namespace touchstone::recursion
