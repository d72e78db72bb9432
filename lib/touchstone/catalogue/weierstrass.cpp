// SPDX-License-Identifier: MIT
#include "touchstone/paper/weierstrass.hpp"

#include "touchstone/catalogue/formula.hpp"
#include "touchstone/paper/weierstrass_profile.hpp"

#include <stdexcept>

namespace touchstone {
namespace {

using Profile = Ball (*)(const Rational&, const Rational&, const Rational&);

Route profile_route(std::string name, Profile profile)
{
    return {std::move(name), [profile](const Inputs& in) {
                try {
                    return profile(in.real("x"), in.real("D"), in.real("gamma"));
                }
                catch (const std::length_error& e) {
                    throw BeyondReach(std::string("the series needs ") + e.what());
                }
            }};
}

} // namespace

void add_weierstrass(std::vector<Quantity>& all)
{
    all.push_back({"weierstrass.profile", "3.1", "g0", "gamma > 1, 1 < D < 2, any x", {"x", "D", "gamma"},
                   "height z of the Weierstrass profile, all scales summed, at x in lambda0",
                   [](const Inputs& in) { require_surface(in); },
                   [](const Inputs& in) { return weierstrass::profile_exact(in.real("x"), in.real("D"), in.real("gamma")); },
                   {profile_route("terms", weierstrass::profile_by_terms),
                    profile_route("scaling-relation", weierstrass::profile_by_scaling)}});

    const auto bound = [](auto a) { return weierstrass::bound(a("D"), a("gamma")); };
    all.push_back({"weierstrass.bound", "3.4", "g0", "gamma > 1, 1 < D < 2", {"D", "gamma"},
                   "bound zhat of the height of the profile", [](const Inputs& in) { require_surface(in); },
                   exactly(bound),
                   {through("expm1", bound),
                    through("as-printed", [](auto a) { return 1 / (1 - weierstrass::amplitude_ratio(a("D"), a("gamma"))); })}});
}

} // namespace touchstone
