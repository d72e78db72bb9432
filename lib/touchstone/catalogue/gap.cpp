// SPDX-License-Identifier: MIT
#include "touchstone/paper/gap.hpp"

#include "touchstone/catalogue/formula.hpp"

#include "touchstone/scalar/flint_headers.hpp"

namespace touchstone {
namespace {

/// An integrand for complex arguments; `analytic` asks for a ball that is not finite where it is not analytic.
using Integrand = std::function<ComplexBall(const ComplexBall&, bool analytic)>;

/// int_a^b of a function that is bounded there (Arb's requirement), by Arb's adaptive Gauss-Legendre
/// quadrature with rigorous bounds (Johansson 2018), to about the working precision for integrals of order 1.
Ball integral(const Integrand& f, const Ball& a, const Ball& b)
{
    const auto callback = [](acb_ptr out, const acb_t z, void* f_, slong order, slong bits) -> int {
        const WorkingPrecision precision(bits);
        ComplexBall argument;
        acb_set(argument.get(), z);
        acb_set(out, (*static_cast<const Integrand*>(f_))(argument, order != 0).get());
        return 0;
    };
    ComplexBall result;
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -WorkingPrecision::bits());
    acb_calc_integrate(result.get(), callback, const_cast<Integrand*>(&f), ComplexBall(a).get(), ComplexBall(b).get(), WorkingPrecision::bits(),
                       tolerance, nullptr, WorkingPrecision::bits());
    mag_clear(tolerance);
    return result.real();
}

ComplexBall analytic_sqrt(const ComplexBall& z, bool analytic)
{
    ComplexBall r;
    acb_sqrt_analytic(r.get(), z.get(), analytic, WorkingPrecision::bits());
    return r;
}

/// 4 int_0^w t^2/sqrt(S + t^2) dt: the slope's integral over t = sqrt(v^2 - S), with w^2 = `square`.
/// Written as 4 w^3/sqrt(S + w^2) times an integral over [0, 1] between 1/3 and 1/2.
Ball integrated_slope(const Ball& square, const Ball& load)
{
    if (!certainly(less(Ball(0), square))) return certainly(less(square, Ball(0))) ? Ball(0) : Ball::indeterminate();
    const ComplexBall c(load / square), c1(1 + load / square);
    const Ball shape = integral([&](const ComplexBall& t, bool analytic) { return t * t * analytic_sqrt(c1, analytic) / analytic_sqrt(c + t * t, analytic); },
                                Ball(0), Ball(1));
    return 4 * square * sqrt(square) / sqrt(load + square) * shape;
}

/// 1 - u(0), the peak's height over the displacement there: u(0) = -2 int p log|2 sin(pi x)| dx, the pressure (2.4)
/// against the half-plane's kernel. With sin(pi x) = sqrt(S) sin(phi) as below, and cos^2 phi log sin phi
/// integrated by parts, only int_0^{pi/2} phi cot(phi) + cos^2 phi is left.
Ball undisplaced_peak(const Ball& load)
{
    const Ball parts = integral(
        [](const ComplexBall& phi, bool) {
            ComplexBall sinc;
            acb_sinc(sinc.get(), phi.get(), WorkingPrecision::bits());
            return cos(phi) / sinc + cos(phi) * cos(phi);
        },
        Ball(0), pi<Ball>() / 2);
    return 1 + load * (log(4 * load) - 4 * parts / pi<Ball>());
}

/// 1/2 <p u>: in partial contact u = cos(2 pi x) - C, and with sin(pi x) = sqrt(S) sin(phi) the
/// load on dphi is (2 S/pi) cos^2 phi dphi; 1 - C = S - S log S.
Ball work_of_pressure(const Ball& load)
{
    const ComplexBall rise(1 - log(load));
    return load * load / pi<Ball>()
           * integral([&](const ComplexBall& phi, bool) { return cos(phi) * cos(phi) * (rise - 2 * sin(phi) * sin(phi)); }, -pi<Ball>() / 2, pi<Ball>() / 2);
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

    all.push_back({"westergaard.mean_gap", "from 2.4", "g", "load > 0", {"load"},
                   "mean gap over a wavelength; 0 from full contact on", require_load,
                   [](const Inputs& in) { return in.real("load") >= 1 ? Exact(0) : throw NotExact(); },
                   {through("cancellation-free", [](auto a) { return westergaard::mean_gap(a("load")); }),
                    {"displaced-peak", [](const Inputs& in) { return in.real("load") >= 1 ? Ball(0) : undisplaced_peak(Ball(in.real("load"))); }}}});

    all.push_back({"westergaard.energy", "from 2.4", "g p*", "load > 0", {"load"},
                   "elastic energy per unit nominal area beyond that of uniform pressure; 1/4 from full contact on", require_load,
                   [](const Inputs& in) { return in.real("load") >= 1 ? Exact(Rational(1, 4)) : throw NotExact(); },
                   {through("work-of-load", [](auto a) { return westergaard::energy(a("load")); }),
                    {"work-of-pressure", [](const Inputs& in) { return work_of_pressure(Ball(in.real("load") >= 1 ? Rational(1) : in.real("load"))); }}}});

    all.push_back({"hertz.gap", "from 2.6", "g", "load > 0", {"x", "load"},
                   "gap beside the contact in the Hertzian limit; 0 in the contact", require_load, {},
                   {through("cancellation-free", [](auto a) { return hertz::gap(a("x"), a("load")); }),
                    {"integrated-slope", [](const Inputs& in) {
                        const Ball v = pi<Ball>() * Ball(in.real("x")), load(in.real("load"));
                        return integrated_slope(v * v - load, load);
                    }}}});
}

} // namespace touchstone
