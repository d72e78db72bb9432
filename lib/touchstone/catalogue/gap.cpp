// SPDX-License-Identifier: MIT
#include "touchstone/paper/gap.hpp"

#include "touchstone/catalogue/formula.hpp"
#include "touchstone/quadrature/half_powers.hpp"
#include "touchstone/scalar/accuracy.hpp"

#include <algorithm>

namespace touchstone {
namespace {

/// Of what the working precision holds, so much is asked of an integral: its parameters are balls of that precision.
long digits_of_integrals() { return std::max(2L, accuracy_of(WorkingPrecision::bits()).digits + 8); }

/// int_0^1 f by tanh-sinh, or by one ellipse where that is less work; not finite where nothing is proved.
template <class F>
Ball integral(F f)
{
    quadrature::Options options;
    options.digits = digits_of_integrals();
    const quadrature::Enclosure e = quadrature::proven_integral(std::move(f), quadrature::Interval::finite(0, 1), options);
    return e.status == quadrature::Status::indeterminate ? Ball::indeterminate() : e.value;
}

/// 4 int_{sqrt S}^v (t^2 - S)^(1/2) dt, the slope's integral, with v^2 - S = `square`; t = sqrt S + (v - sqrt S) u
/// makes it 4 (v - sqrt S)^2 int_0^1 (u (e + u))^(1/2) du, e = 2 sqrt S/(v - sqrt S). Where the two singular points nearly are one,
/// t = sqrt S cosh(b u), v = sqrt S cosh b, makes it 4 S b int_0^1 sinh(b u)^2 du.
Ball integrated_slope(const Ball& square, const Ball& load)
{
    if (!certainly(less(Ball(0), square))) return certainly(less(square, Ball(0))) ? Ball(0) : Ball::indeterminate();
    const Ball w = sqrt(square), v = sqrt(square + load), edge = sqrt(load), length = square / (v + edge), e = 2 * edge / length;
    constexpr long nearly_one = -64;
    if (certainly(less(e, power_of_two<Ball>(nearly_one)))) {
        const Ball b = log((v + w) / edge);
        return load * b * integral([b](auto u, auto, auto) {
                   const auto twice_sinh = exp(b * u) - exp(-(b * u));
                   return twice_sinh * twice_sinh;
               });
    }
    return 4 * length * length * sqrt(1 + e) * integral([e](auto, auto left, auto) { return sqrt(left) * sqrt((left + e) / (1 + e)); });
}

/// 1 - u(0), the peak's height over the displacement there: u(0) = -2 int p log|2 sin(pi x)| dx, the pressure (2.4)
/// against the half-plane's kernel, in t = sin(pi x)/sqrt(S): singular at both ends, like log t and (1 - t)^(1/2).
Ball undisplaced_peak(const Ball& load)
{
    const Ball part = integral([](auto t, auto left, auto right) { return sqrt(right) * sqrt(1 + t) * log(left); });
    return 1 + load * (log(4 * load) + 8 * part / pi<Ball>());
}

/// 1/2 <p u>: in partial contact u = cos(2 pi x) - C, and with t = sin(pi x)/sqrt(S) the load on dt is
/// (2 S/pi) (1 - t^2)^(1/2) dt; 1 - C = S - S log S.
Ball work_of_pressure(const Ball& load)
{
    const Ball rise = 1 - log(load);
    return 2 * load * load / pi<Ball>()
           * integral([rise](auto t, auto, auto right) { return sqrt(right) * sqrt(1 + t) * (rise - 2 * t * t); });
}

/// The gap where it is exactly 0: in full contact, and inside or at the edge of a contact whose edge has an exact sine.
Exact zero_gap(const Inputs& in)
{
    const Rational& load = in.real("load");
    if (load >= 1) return Exact(0);
    const Exact v = sin_pi(Exact(in.real("x")));
    if (certainly(less(Exact(load), v * v))) throw NotExact();
    return Exact(0);
}

} // namespace

void add_gap(std::vector<Quantity>& all)
{
    all.push_back({"westergaard.gap", "from 2.4", "g", "load > 0, |x| <= 1/2", {"x", "load"},
                   "gap between the surfaces at distance x from the peak; 0 in the contact",
                   [](const Inputs& in) {
                       require_load(in);
                       require(abs(in.real("x")) <= Rational(1, 2), in, "x", "from -1/2 to 1/2 (one wavelength)");
                   },
                   zero_gap,
                   {through("cancellation-free", [](auto a) { return westergaard::gap(a("x"), a("load")); }),
                    {"integrated-slope", [](const Inputs& in) {
                        if (in.real("load") >= 1) return Ball(0);
                        const Ball v = sin_pi(Ball(in.real("x"))), load(in.real("load"));
                        return integrated_slope(v * v - load, load);
                    }}}});

    all.push_back(
        {"westergaard.mean_gap",
         "from 2.4",
         "g",
         "load > 0",
         {"load"},
         "mean gap over a wavelength; 0 from full contact on",
         require_load,
         [](const Inputs& in) { return in.real("load") >= 1 ? Exact(0) : throw NotExact(); },
         {through("cancellation-free", [](auto a) { return westergaard::mean_gap(a("load")); }),
          {"displaced-peak", [](const Inputs& in) { return in.real("load") >= 1 ? Ball(0) : undisplaced_peak(Ball(in.real("load"))); }}}});

    all.push_back({"westergaard.energy",
                   "from 2.4",
                   "g p*",
                   "load > 0",
                   {"load"},
                   "elastic energy per unit nominal area beyond that of uniform pressure; 1/4 from full contact on",
                   require_load,
                   [](const Inputs& in) { return in.real("load") >= 1 ? Exact(Rational(1, 4)) : throw NotExact(); },
                   {through("work-of-load", [](auto a) { return westergaard::energy(a("load")); }),
                    {"work-of-pressure",
                     [](const Inputs& in) { return work_of_pressure(Ball(in.real("load") >= 1 ? Rational(1) : in.real("load"))); }}}});

    all.push_back({"hertz.gap", "from 2.6", "g", "load > 0", {"x", "load"},
                   "gap beside the contact in the Hertzian limit; 0 in the contact", require_load, {},
                   {through("cancellation-free", [](auto a) { return hertz::gap(a("x"), a("load")); }),
                    {"integrated-slope", [](const Inputs& in) {
                        const Ball v = pi<Ball>() * Ball(in.real("x")), load(in.real("load"));
                        return integrated_slope(v * v - load, load);
                    }}}});
}

} // namespace touchstone
