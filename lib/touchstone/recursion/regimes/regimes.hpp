// SPDX-License-Identifier: MIT
/// \file
/// The methods of methods(), by the regime that they serve, and what their refusals ask of a problem.
#pragma once

#include "touchstone/recursion/methods.hpp"
#include "touchstone/transfer/contact.hpp"

namespace touchstone::recursion {

// ---- one wave: n = 0 in closed form, n = 1 and the area at n = 2 by one integral
Method single_wave_area();
Method single_wave_exceedance();
Method single_wave_density();
Method one_integral();
Method second_area();

// ---- partial contact at every scale
Method partial_area();
Method partial_distribution();

// ---- full contact
Method heavy_load();
Method proven_shares();
Method third_wave_density();
Method proven_densities();

// ---- so many scales that their limit gives the digits
Method area_in_any_limit();
Method exceedance_in_any_limit();

// ---- what they ask

constexpr const char* no_density_at_0 = "not computed at p = 0, where q_n is 0 unless a singular point lies there; ask for p > 0";
bool p_is_0(const Problem&);
/// 0 < 1 - load < 1e-300: the zeros of 1 + (1 - load) sinh^2 v go out like -log(1 - load), and the strips of the discretised operator's
/// rules become so much narrower (measured to 1e-300).
bool too_near_1(const Rational& load);
double about_G(const Problem&);
bool G_above(const Problem&, const Rational& least);
bool G_below_10_9(const Problem&);
/// p certainly exceeds p_n^max: the value is 0.
bool above_support(const Problem&);
transfer::Arguments arguments(const Problem&);
/// Cost against digits, relative to that of twenty.
double growth(Accuracy, double power);
/// Areas of more scales are not followed scale by scale.
constexpr long last_followed_scale = 10'000;
/// Above it areas are taken from the limit where that leaves the digits asked for: docs/limit.md, theorem 2.
constexpr long first_scale_of_limit = 200;

} // namespace touchstone::recursion
