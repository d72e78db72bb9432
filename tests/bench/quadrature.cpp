// SPDX-License-Identifier: MIT
// bench_quadrature TOOL CASE DIGITS: one integral by one tool, as "cold_ms warm_ms value".
// quadrature.py runs all of them, PARI and mpmath as well, and prints the ratios.
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/quadrature/estimate.hpp"
#include "touchstone/quadrature/half_powers.hpp"
#include "touchstone/quadrature/tanh_sinh.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#else
#include <acb_calc.h>
#endif

#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <string>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

const Rational load(1, 10), G(4);
Ball edge() { return 2 * sqrt(Ball(load)); }

// ---- the four integrands, in the arguments (x, distance to the left end, distance to the right end)
const auto profile = [](auto, auto l, auto r) { return to_power(l * r, Rational(3, 8)); };
const auto pole = [](auto, auto l, auto) { return to_power(l, Rational(-9, 10)); };
const auto root = [](auto, auto, auto r) { return sqrt(r); };
const auto area = [](auto p, auto, auto r) {
    using T = decltype(p);
    const T s(load), top = 2 * sqrt(s);
    return westergaard::density_partial(p, s, T(sqrt(r * (top + p)))) * 2 * asin(sqrt(p / T(G))) / pi<T>();
};

struct Timed {
    double cold = 0, warm = 0;
    std::string value;
};

/// First call, then the mean of as many as fit in 0.4 s (at least one).
Timed timed(const std::function<std::string()>& once)
{
    struct Clock { // of the processor, not of the wall
        static std::clock_t now() { return std::clock(); }
    };
    const auto milliseconds = [](std::clock_t d) { return 1000.0 * static_cast<double>(d) / CLOCKS_PER_SEC; };
    Timed t;
    const auto start = Clock::now();
    t.value = once();
    t.cold = milliseconds(Clock::now() - start);
    long n = 0;
    const auto again = Clock::now();
    do {
        once();
        ++n;
    } while (milliseconds(Clock::now() - again) < 400);
    t.warm = milliseconds(Clock::now() - again) / static_cast<double>(n);
    return t;
}

template <class F>
Timed by_ours(const F& f, const Interval& interval, long digits)
{
    return timed([&]() -> std::string {
        Options options;
        options.digits = digits;
        const Enclosure e = proven_integral(f, interval, options);
        return e.status == Status::certified ? e.value.to_string(digits + 5) : "refused: " + e.reason;
    });
}

template <class F>
Timed by_estimate(const F& f, const Interval& interval, long digits)
{
    Mpfr::default_precision(static_cast<unsigned>(digits));
    return timed([&] { return estimate<Mpfr>(f, interval).value.str(); });
}

template <class F>
Timed by_boost(const F& f, const Interval& interval, long digits)
{
    Mpfr::default_precision(static_cast<unsigned>(digits));
    using A = touchstone::quadrature::detail::RealArithmetic<Mpfr>;
    const Mpfr a = A::read(interval.left()), b = A::read(interval.right());
    std::unique_ptr<boost::math::quadrature::tanh_sinh<Mpfr>> rule;
    return timed([&] {
        if (!rule) rule = std::make_unique<boost::math::quadrature::tanh_sinh<Mpfr>>(20, Mpfr(pow(A::epsilon(), 20)));
        auto g = [&](Mpfr x, Mpfr nearest) -> Mpfr {
            return nearest < 0 ? f(x, Mpfr(-nearest), Mpfr(b - a + nearest)) : f(x, Mpfr(b - a - nearest), nearest);
        };
        Mpfr error, magnitude;
        std::size_t levels = 0;
        return Mpfr(rule->integrate(g, a, b, Mpfr(sqrt(A::epsilon())), &error, &magnitude, &levels)).str();
    });
}

using ComplexFunction = std::function<ComplexBall(const ComplexBall&, bool analytic)>;

Timed by_arb(const ComplexFunction& f, const std::function<Ball()>& a, const std::function<Ball()>& b, long digits)
{
    const slong bits = bits_for_digits(digits);
    const WorkingPrecision precision(bits);
    const auto call = [](acb_ptr out, const acb_t z, void* param, slong order, slong working) -> int {
        const WorkingPrecision here(working);
        ComplexBall argument;
        acb_set(argument.get(), z);
        acb_set(out, (*static_cast<const ComplexFunction*>(param))(argument, order != 0).get());
        return 0;
    };
    return timed([&]() -> std::string {
        mag_t tolerance;
        mag_init(tolerance);
        mag_set_ui_2exp_si(tolerance, 1, -bits);
        acb_calc_integrate_opt_t options;
        acb_calc_integrate_opt_init(options);
        options->eval_limit = 100000000;
        options->depth_limit = 100000;
        ComplexBall value;
        const int status = acb_calc_integrate(value.get(), call, const_cast<ComplexFunction*>(&f), ComplexBall(a()).get(),
                                              ComplexBall(b()).get(), bits, tolerance, options, bits);
        mag_clear(tolerance);
        if (!value.is_finite()) return status == ARB_CALC_SUCCESS ? "refused: NaN with a success code" : "refused: NaN";
        return value.real().to_string(digits + 5);
    });
}

ComplexBall analytic_root(const ComplexBall& z, bool analytic)
{
    ComplexBall w;
    acb_sqrt_analytic(w.get(), z.get(), analytic, WorkingPrecision::bits());
    return w;
}

ComplexBall analytic_power(const ComplexBall& z, const Rational& e, bool analytic)
{
    ComplexBall w;
    acb_pow_analytic(w.get(), z.get(), ComplexBall(e).get(), analytic, WorkingPrecision::bits());
    return w;
}

Mpfr mpfr_power(const Mpfr& x, int n, int d) { return pow(x, Mpfr(Mpfr(n) / d)); }

int usage()
{
    std::fputs("usage: bench_quadrature ours|mpfr|boost|arb profile|pole|root|area DIGITS\n", stderr);
    return 64;
}

} // namespace

int main(int count, char** words)
{
    if (count != 4) return usage();
    const std::string tool = words[1], which = words[2];
    const long digits = std::atol(words[3]);
    const Interval support = Interval::finite(0, Endpoint(edge));
    Timed t;
    const auto generic = [&](auto by) {
        const auto m_profile = [](const Mpfr&, const Mpfr& l, const Mpfr& r) { return mpfr_power(l * r, 3, 8); };
        const auto m_pole = [](const Mpfr&, const Mpfr& l, const Mpfr&) { return mpfr_power(l, -9, 10); };
        const auto m_root = [](const Mpfr&, const Mpfr&, const Mpfr& r) { return Mpfr(sqrt(r)); };
        const auto m_area = [](const Mpfr& p, const Mpfr&, const Mpfr& r) {
            const Mpfr s = Mpfr(1) / 10, top = 2 * sqrt(s);
            return Mpfr(westergaard::density_partial(p, s, Mpfr(sqrt(r * (top + p)))) * 2 * asin(Mpfr(sqrt(p / 4))) / pi<Mpfr>());
        };
        if (which == "profile") t = by(m_profile, Interval::finite(-1, 1));
        else if (which == "pole") t = by(m_pole, Interval::finite(0, 1));
        else if (which == "root") t = by(m_root, Interval::finite(0, 1));
        else t = by(m_area, support);
    };
    if (which != "profile" && which != "pole" && which != "root" && which != "area") return usage();
    if (tool == "ours") {
        if (which == "profile") t = by_ours(profile, Interval::finite(-1, 1), digits);
        else if (which == "pole") t = by_ours(pole, Interval::finite(0, 1), digits);
        else if (which == "root") t = by_ours(root, Interval::finite(0, 1), digits);
        else t = by_ours(area, support, digits);
    }
    else if (tool == "mpfr") generic([&](const auto& f, const Interval& i) { return by_estimate(f, i, digits); });
    else if (tool == "boost") generic([&](const auto& f, const Interval& i) { return by_boost(f, i, digits); });
    else if (tool == "arb") {
        const std::function<Ball()> zero = [] { return Ball(0); }, one = [] { return Ball(1); }, minus_one = [] { return Ball(-1); };
        if (which == "profile")
            t = by_arb([](const ComplexBall& z, bool a) { return analytic_power(1 - z * z, Rational(3, 8), a); }, minus_one, one, digits);
        else if (which == "pole")
            t = by_arb([](const ComplexBall& z, bool a) { return analytic_power(z, Rational(-9, 10), a); }, zero, one, digits);
        else if (which == "root") t = by_arb([](const ComplexBall& z, bool a) { return analytic_root(1 - z, a); }, zero, one, digits);
        else { // its best form: the bounded one, two steps of the recursion
            t = by_arb([](const ComplexBall& psi, bool analytic) {
                const ComplexBall s(load), sine = sin(psi), cosine = cos(psi), under = analytic_root(1 - s * sine * sine, analytic);
                const ComplexBall y = analytic_root(2 / ComplexBall(G) * analytic_root(s, false) * cosine * under, analytic);
                if (analytic && !arb_lt(acb_realref(y.get()), Ball(1).get())) return ComplexBall::indeterminate();
                return 4 / ComplexBall(pi<Ball>() * pi<Ball>()) * analytic_root(s, false) * cosine / under * asin(y);
            }, zero, [] { return pi<Ball>() / 2; }, digits);
        }
    }
    else return usage();
    std::printf("%.4f %.4f %s\n", t.cold, t.warm, t.value.c_str());
    return 0;
}
