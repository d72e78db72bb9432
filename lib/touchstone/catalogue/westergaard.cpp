// SPDX-License-Identifier: MIT
#include "touchstone/paper/westergaard.hpp"

#include "touchstone/catalogue/formula.hpp"
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/westergaard_nearest.hpp"

namespace touchstone {
namespace {

void check_load(const Inputs& in) { require_load(in); }

void check_partial_load(const Inputs& in) { require(in.real("load") > 0 && in.real("load") <= 1, in, "load", "> 0 and <= 1"); }

void check_position(const Inputs& in)
{
    require_load(in);
    require(abs(in.real("x")) <= Rational(1, 2), in, "x", "from -1/2 to 1/2 (one wavelength)");
}

void check_pressure(const Inputs& in)
{
    require_load(in);
    require(in.real("p") >= 0, in, "p", ">= 0");
}

void check_density(const Inputs& in)
{
    check_pressure(in);
    const Rational& p = in.real("p");
    const Rational& load = in.real("load");
    const bool edge = load < 1 ? p * p == 4 * load : (p == load - 1 || p == load + 1);
    require(!edge, in, "p", "off the edges of the support, where the density is unbounded");
}

/// Which of two formulas holds is decided on the exact load.
template <class Partial, class Full>
Route printed(std::string name, Partial partial, Full full)
{
    return {std::move(name), [partial, full](const Inputs& in) -> Ball {
                const Arguments<Ball> a(in);
                return in.real("load") < 1 ? partial(in, a) : full(in, a);
            }};
}

} // namespace

void add_westergaard(std::vector<Quantity>& all)
{
    const auto half_width = [](auto a) { return westergaard::half_width(a("load")); };
    all.push_back({"westergaard.half_width", "2.5", "lambda", "0 < load <= 1", {"load"},
                   "half-width a of a contact segment under a sine wave", check_partial_load,
                   exactly(half_width),
                   {through("arctangent", half_width),
                    through("arcsine-as-printed", [](auto a) { return as_printed::half_width(a("load")); })}});
    all.back().nearest = [](const double* in) { return westergaard::nearest_half_width(in[0]); };

    const auto pressure = [](auto a) { return westergaard::pressure(a("x"), a("load")); };
    all.push_back({"westergaard.pressure", "2.2, 2.4", "p*", "load > 0, |x| <= 1/2", {"x", "load"},
                   "contact pressure at distance x from the peak; 0 outside the contact", check_position,
                   exactly(pressure),
                   {through("cancellation-free", pressure),
                    printed("as-printed",
                            [](const Inputs&, const Arguments<Ball>& a) { return as_printed::pressure_partial(a("x"), a("load")); },
                            [](const Inputs&, const Arguments<Ball>& a) { return as_printed::pressure_full(a("x"), a("load")); })}});

    const auto exceedance = [](auto a) { return westergaard::exceedance(a("p"), a("load")); };
    all.push_back({"westergaard.exceedance", "2.11-2.18", "1", "load > 0, p >= 0", {"p", "load"},
                   "share Q of the wavelength on which the pressure exceeds p", check_pressure,
                   exactly(exceedance),
                   {through("cancellation-free", exceedance),
                    printed("as-printed",
                            [](const Inputs& in, const Arguments<Ball>& a) {
                                const Rational& p = in.real("p");
                                return p * p >= 4 * in.real("load") ? Ball(0) : as_printed::exceedance_partial(a("p"), a("load"));
                            },
                            [](const Inputs& in, const Arguments<Ball>& a) {
                                const Rational t = in.real("p") - in.real("load");
                                if (t <= -1) return Ball(1);
                                return t >= 1 ? Ball(0) : as_printed::exceedance_full(a("p"), a("load"));
                            })}});
    all.back().nearest = [](const double* in) { return westergaard::nearest_exceedance(in[0], in[1]); };

    const auto density = [](auto a) { return westergaard::density(a("p"), a("load")); };
    all.push_back({"westergaard.density",
                   "2.15-2.20",
                   "1/p*",
                   "load > 0, p >= 0, not at an edge of the support",
                   {"p", "load"},
                   "probability density q of the contact pressure, as q p*; 0 outside the support",
                   check_density,
                   exactly(density),
                   {through("cancellation-free", density), printed(
                                                               "as-printed",
                                                               [](const Inputs& in, const Arguments<Ball>& a) {
                                                                   const Rational& p = in.real("p");
                                                                   return p * p > 4 * in.real("load")
                                                                              ? Ball(0)
                                                                              : as_printed::density_partial(a("p"), a("load"));
                                                               },
                                                               [](const Inputs& in, const Arguments<Ball>& a) {
                                                                   return abs(Rational(in.real("p") - in.real("load"))) > 1
                                                                              ? Ball(0)
                                                                              : as_printed::density_full(a("p"), a("load"));
                                                               })}});
    all.back().nearest = [](const double* in) { return westergaard::nearest_density(in[0], in[1]); };

    const auto hertz_width = [](auto a) { return hertz::half_width(a("load")); };
    all.push_back({"hertz.half_width", "2.7", "lambda", "load > 0", {"load"},
                   "half-width of the contact in the Hertzian limit", check_load,
                   exactly(hertz_width),
                   {through("square-root", hertz_width),
                    {"power", [](const Inputs& in) { return pow(Ball(in.real("load")), Ball(Rational(1, 2))) / pi<Ball>(); }}}});

    const auto hertz_pressure = [](auto a) { return hertz::pressure(a("x"), a("load")); };
    all.push_back({"hertz.pressure", "2.6", "p*", "load > 0", {"x", "load"},
                   "contact pressure in the Hertzian limit; 0 outside the contact", check_load,
                   exactly(hertz_pressure),
                   {through("cancellation-free", hertz_pressure),
                    through("as-printed", [](auto a) { return as_printed::hertz_pressure(a("x"), a("load")); })}});
}

} // namespace touchstone
