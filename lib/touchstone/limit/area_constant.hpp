// SPDX-License-Identifier: MIT
/// \file
/// C(G) = lim A_n G^n/load, the constant of the fractal limit: docs/limit.md.
#pragma once

#include "touchstone/limit/approach.hpp"
#include "touchstone/transfer/contact.hpp"

namespace touchstone::limit {

/// C(G) for G > 2: the certified area at a scale n at which theorem 2 leaves nothing to be seen, h_n(1/2) (1 +- delta_n).
/// The two schemes are independent of one another up to that theorem.
/// \throws BeyondReach where transfer::area does
Ball area_constant(transfer::Scheme, const std::function<Ball()>& G, Accuracy);

/// The most digits of area_constant() for that G > 2.
long most_digits_of_area_constant(const Ball& G);

/// How the error of area_constant() is made up.
std::string area_constant_certificate(transfer::Scheme, const std::function<Ball()>& G, Accuracy);

/// A_n/lambda_0 = C(G) G^-n load (1 +- delta_n) for G > 2, load <= 1, in no more time for n = 10^6 than for 10^2.
Ball area_in_the_limit(transfer::Scheme, long n, const transfer::Arguments&, Accuracy);
/// The most digits of it that delta_n leaves: 240 and more where n >= 2000.
long most_digits_of_area_in_the_limit(long n, const Ball& load, const Ball& G);


/// The same for any load and G >= 1.02, full contact too, by theorem 1 and, below 2.000001, theorem 4.
Ball area_in_any_limit(long n, const transfer::Arguments&, Accuracy);
/// The most digits of it: none for the first hundreds of scales, 15 later for G < 2.000001.
long most_digits_of_area_in_any_limit(long n, const Ball& load, const Ball& G);
/// From the limit law.
Witness area_by_limit_law(long n, const transfer::Arguments&);

} // namespace touchstone::limit
