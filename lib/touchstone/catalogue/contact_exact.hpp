// SPDX-License-Identifier: MIT
/// \file
/// Where section 6 has values that are exactly known: full contact everywhere, outside and at the ends of the support, one wave at special
/// loads. Internal to catalogue/. All throw NotExact where nothing is known exactly.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

namespace touchstone::contact_exact {

/// A_n/lambda_0
Exact area(const Inputs&, long n);
/// lambda_0/lambda_n A_{n-1}/lambda_0
Exact segment_count(const Inputs&);
/// Share with p_n > p
Exact exceedance(const Inputs&);
/// q_n(p)
Exact density(const Inputs&);
/// (9.3), by half-width
Exact segment_density(const Inputs&);
/// The pressure, in p*_0, under which segments of scale n have half-width a: G^n sin^2(pi a).
Exact pressure_of_segments(const Inputs&);

} // namespace touchstone::contact_exact
