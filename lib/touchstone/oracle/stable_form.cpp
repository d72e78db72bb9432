// SPDX-License-Identifier: MIT
#include "touchstone/oracle/stable_form.hpp"

#include <map>

namespace touchstone::oracle {

std::string stable_form(std::string_view quantity)
{
    // atan2 as in C; cos_pi and sin_pi take multiples of pi, reduced before they are multiplied by it
    static const std::map<std::string_view, std::string_view> forms{
        {"westergaard.half_width", "atan2(sqrt(load), sqrt(1 - load))/pi; arcsin(sqrt(load)) loses half the digits as load -> 1"},
        {"westergaard.pressure",
         "load < 1: 2 cos_pi(x) sqrt(load - sin_pi(x)^2), the difference as load - y^2 + (y^2 - sin(y)^2), y = pi x, with y^2 carried exactly (fma), "
         "and as cos_pi(x)^2 - (1 - load) for |x| > 1/4; load >= 1: (load - 1) + 2 cos_pi(x)^2"},
        {"westergaard.exceedance", "load < 1, R = hypot(1 - load, p): (2/pi) atan2(sqrt(4 load - p^2), sqrt(2 (1 - load) + 2 R + p^2)); "
                                   "load >= 1: (2/pi) atan2(sqrt(1 - (p - load)), sqrt(p - (load - 1)))"},
        {"westergaard.density", "load < 1, R = hypot(1 - load, p): p/(pi R sqrt(4 load - p^2)) sqrt((1 + load + R)/(1 - load + R)); "
                                "load >= 1: 1/(pi sqrt((p - (load - 1)) (1 - (p - load))))"},
        {"westergaard.gap",
         "v = |sin_pi(x)|, w = sqrt(v^2 - load), m = (w/v)^2: 4 (w^3/v) sum_j m^j/((2j + 1)(2j + 3)) for m < 3/4, else 2 (v w - load log((v + w)/sqrt(load)))"},
        {"hertz.gap",
         "v = pi |x|, w = sqrt(v^2 - load), m = (w/v)^2: 4 (w^3/v) sum_j m^j/((2j + 1)(2j + 3)) for m < 3/4, else 2 (v w - load log((v + w)/sqrt(load)))"},
        {"westergaard.mean_gap", "load > 1/4, e = 1 - load: e^2 sum_j e^j/((j + 1)(j + 2)); else 1 + load (log(load) - 1)"},
        {"westergaard.energy", "load (load (1 - 2 log(load)))/4 in this order: load^2 alone underflows"},
        {"hertz.pressure", "2 sqrt(load - (pi x)^2) with pi x and its square carried exactly (two doubles each, fma)"},
        {"weierstrass.bound", "-1/expm1((D - 2) log(gamma))"},
        {"weierstrass.profile",
         "sum gamma^((D-2)n) cos(2 pi gamma^n x) with the phase gamma^n x reduced modulo 1 exactly: in double it has no right digit after a few terms"},
        {"peaks.f", "x < 1: 2 sqrt(x); else 1 + x"},
        {"peaks.fixed_point", "G > 2: (2/G)^2; else 1/(G - 1)"},
        {"segments.max_half_width", "atan2(sqrt(y), sqrt(G - y))/pi with y = f(x_(n-2)) of (5.6): the quotient y/G is not formed"},
    };
    const auto it = forms.find(quantity);
    return it == forms.end() ? "" : std::string(it->second);
}

} // namespace touchstone::oracle
