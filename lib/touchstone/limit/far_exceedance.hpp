// SPDX-License-Identifier: MIT
/// \file
/// How much of lambda_0 is above a pressure at scales where the distribution has come near its limit: docs/limit.md, theorem 7.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/transfer/contact.hpp"

#include <functional>
#include <string>

namespace touchstone::limit {

/// A scale, and a pressure there in units of its own p*_n, enclosed at the thread's precision.
struct FarPressure {
    long n;
    std::function<Ball()> in_own_units;
};

/// The share of lambda_0 where p_n is above that: load G^-n (E_pi[Q_P/x] +- rho_n), for any load and full contact too.
/// \pre no_far_exceedance() has nothing to say
Ball far_exceedance(const FarPressure&, const transfer::Arguments&, Accuracy);
/// Why it is not served at any scale: a pressure below p*_n/1024, or that the limit does not meet; G outside 1.02 to 1000. Empty: it is.
std::string no_far_exceedance(const FarPressure&, const Ball& G);
/// The most digits that the rate of approach leaves of a share that is not much smaller than the area; fewer next to the highest pressure.
long most_digits_of_far_exceedance(long n, const Ball& load, const Ball& G);
/// From the limit law.
Witness far_exceedance_by_limit_law(const FarPressure&, const transfer::Arguments&);
/// How its error is made up.
std::string far_exceedance_certificate(const FarPressure&, const transfer::Arguments&, Accuracy);

} // namespace touchstone::limit
