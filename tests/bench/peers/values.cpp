// SPDX-License-Identifier: GPL-3.0-or-later
// What peers.py times inside a process: constants, points, double forms.
//   bench_peer_values product DIGITS     K_inf by Arb as its user would write it: the plain product of Gamma ratios (7.13), and what is
//                                        left out bounded
//   bench_peer_values gamma DIGITS       milliseconds of one arb_gamma of a full-length argument
//   bench_peer_values multiply BITS      nanoseconds of one arb_addmul
//   bench_peer_values nested N DIGITS    A_N, load 1/10, G = sqrt 10, by N nested integrals: Boost's tanh_sinh on MPFR, at 15 digits GSL's
//                                        QAGS in doubles
//   bench_peer_values areas N G TOLERANCE LOAD...   A_N at each load by N nested integrals of GSL's QAGS in doubles, waves of full contact
//                                        included, each integral cut where the next wave comes to full contact
//   bench_peer_values points QUANTITY    a file of "p load" in hexfloats from standard input: `evaluate` at each; seconds, then the nearest
//                                        binary64 numbers
//   bench_peer_values doubles            nanoseconds a value of our double forms, of the printed ones and of GSL's, and the largest error
//                                        of each
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/scalar/flint_headers.hpp"
#include "touchstone/scalar/mpfr.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gsl/gsl_complex.h>
#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <random>
#include <string>
#include <vector>

using namespace touchstone;

namespace {

double seconds()
{
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// delta_i -> 1: the factors past i = N multiply by exp(-t), 0 <= t <= 2^-(N+1), as log step = -x + ... is an alternating sum of x =
/// 2^-(i+2).
void product(long digits)
{
    const slong bits = bits_for_digits(digits) + 64;
    arb_t K, delta, a, b, root;
    arb_init(K), arb_init(delta), arb_init(a), arb_init(b), arb_init(root);
    arb_const_pi(root, bits);
    arb_set_ui(K, 2);
    arb_div(K, K, root, bits);
    arb_sqrt(root, root, bits);
    for (slong i = 0; i < bits; ++i) {
        arb_one(delta);
        arb_mul_2exp_si(delta, delta, -(i + 1));
        arb_sub_ui(delta, delta, 1, bits);
        arb_neg(delta, delta);
        arb_set_ui(a, 2);
        arb_pow(a, a, delta, bits);
        arb_mul(K, K, a, bits);
        arb_mul_2exp_si(delta, delta, -1);
        arb_add_ui(a, delta, 1, bits);
        arb_gamma(a, a, bits);
        arb_mul(K, K, a, bits);
        arb_set_d(a, 1.5);
        arb_add(a, a, delta, bits);
        arb_rgamma(b, a, bits);
        arb_mul(K, K, b, bits);
        arb_div(K, K, root, bits);
    }
    arb_one(a);
    arb_mul_2exp_si(a, a, -bits);
    arb_add_error(K, a);
    char* text = arb_get_str(K, digits, ARB_STR_NO_RADIUS);
    std::puts(text);
    flint_free(text);
    arb_clear(K), arb_clear(delta), arb_clear(a), arb_clear(b), arb_clear(root);
}

void gamma_time(long digits)
{
    const slong bits = bits_for_digits(digits) + 64;
    arb_t x, y;
    arb_init(x), arb_init(y);
    arb_const_euler(x, bits);
    arb_add_ui(x, x, 1, bits);
    arb_gamma(y, x, bits); // tables of Bernoulli numbers and of constants are there from now on
    long n = 0;
    const double start = seconds();
    do {
        arb_mul_2exp_si(y, x, -(n % 7 + 2));
        arb_add_ui(y, y, 1, bits);
        arb_gamma(y, y, bits);
        ++n;
    } while (seconds() - start < 0.3);
    std::printf("%.6f\n", 1e3 * (seconds() - start) / static_cast<double>(n));
    arb_clear(x), arb_clear(y);
}

void multiply_time(slong bits)
{
    arb_t x, y;
    arb_init(x), arb_init(y);
    arb_const_euler(x, bits);
    long n = 0;
    const double start = seconds();
    do
        for (int i = 0; i < 1000; ++i, ++n) arb_addmul(y, x, x, bits);
    while (seconds() - start < 0.2);
    std::printf("%.3f\n", 1e9 * (seconds() - start) / static_cast<double>(n));
    arb_clear(x), arb_clear(y);
}

/// B_n(x) = (T B_(n-1))(x), where T is (2/pi) sqrt(x) times an integral over the angle that has no singular end.
template <class T, class Integrate>
T nested_area(int n, const T& x, const Integrate& integrate)
{
    using std::asin, std::cos, std::sin, std::sqrt;
    const T root = sqrt(x), pi = touchstone::pi<T>();
    if (n == 0) return T(2 / pi * asin(root));
    const T slope = T(2 / sqrt(T(10)) * root);
    return T(2 / pi * root * integrate(n, [&](const T& t) -> T {
        const T s = sin(t), c = cos(t), d = sqrt(T(1 - x * s * s));
        return T(nested_area<T>(n - 1, T(slope * c * d), integrate) * c / d);
    }, T(pi / 2)));
}

/// GSL's QAGS, a workspace for each of the nested integrals.
class NestedQags {
public:
    NestedQags(int levels, double tolerance) : tolerance_(tolerance)
    {
        gsl_set_error_handler_off();
        for (int i = 0; i <= levels; ++i) space_.push_back(gsl_integration_workspace_alloc(intervals));
    }
    NestedQags(const NestedQags&) = delete;
    NestedQags& operator=(const NestedQags&) = delete;
    ~NestedQags()
    {
        for (gsl_integration_workspace* w : space_) gsl_integration_workspace_free(w);
    }
    double operator()(int level, const std::function<double(double)>& g, double start, double end) const
    {
        gsl_function f{[](double t, void* h) { return (*static_cast<const std::function<double(double)>*>(h))(t); },
                       const_cast<std::function<double(double)>*>(&g)};
        double value = 0, error = 0;
        gsl_integration_qags(&f, start, end, 0, tolerance_, intervals, space_[static_cast<std::size_t>(level)], &value, &error);
        return value;
    }

private:
    static constexpr std::size_t intervals = 200;
    double tolerance_;
    std::vector<gsl_integration_workspace*> space_;
};

/// As nested_area, waves of full contact included: from x = 1 on B_n is a mean over (x + cos t)/G, and B_0 = 1. Below G = 2 the argument of
/// B_(n-1) comes to 1 inside of the range, where B_(n-1) has a singular point: the integral is cut there, as QAGS wants it at an end.
double nested_area_any_contact(int n, double x, double G, const NestedQags& integrate)
{
    const bool full = x >= 1;
    if (n == 0) return full ? 1 : M_2_PI * std::asin(std::sqrt(x));
    const double root = std::sqrt(x);
    const auto below = [&](double t) {
        if (full) return nested_area_any_contact(n - 1, (x + std::cos(t)) / G, G, integrate);
        const double s = std::sin(t), c = std::cos(t), d = std::sqrt(1 - x * s * s);
        return nested_area_any_contact(n - 1, 2 / G * root * c * d, G, integrate) * c / d;
    };
    // Below x = 1 the argument falls from 2 sqrt(x)/G to 0; its square is 1 where x u^2 - (1 + x) u + 1 = G^2/(4 x), u = sin^2 t.
    const double end = full ? M_PI : M_PI_2;
    double cut = 0;
    if (full && std::abs(G - x) < 1) cut = std::acos(G - x);
    if (!full && 2 * root > G) cut = std::asin(std::sqrt((1 + x - std::sqrt((1 - x) * (1 - x) + G * G)) / (2 * x)));
    const double sum = (cut > 0 ? integrate(n, below, 0, cut) : 0) + integrate(n, below, cut, end);
    return full ? M_1_PI * sum : M_2_PI * root * sum;
}

void areas(int n, double G, double tolerance, int loads, char** load)
{
    const NestedQags integrate(n, tolerance);
    for (int i = 0; i < loads; ++i) std::printf("%.17g\n", nested_area_any_contact(n, std::atof(load[i]), G, integrate));
}

void nested(int n, long digits)
{
    if (digits <= 15) {
        const NestedQags qags(n, 1e-13);
        const auto integrate = [&](int level, const auto& g, double end) { return qags(level, g, 0, end); };
        std::printf("%.17g\n", nested_area<double>(n, 0.1, integrate));
        return;
    }
    Mpfr::default_precision(static_cast<unsigned>(digits) + 3);
    const Mpfr eps(pow(Mpfr(10), -static_cast<int>(digits) - 3)), tolerance(sqrt(eps));
    boost::math::quadrature::tanh_sinh<Mpfr> rule(20, Mpfr(eps * eps));
    const auto integrate = [&](int, const std::function<Mpfr(const Mpfr&)>& g, const Mpfr& end) {
        return Mpfr(rule.integrate(g, Mpfr(0), end, tolerance));
    };
    std::puts(nested_area<Mpfr>(n, Mpfr(Mpfr(1) / 10), integrate).str(digits).c_str());
}

/// As touchstone_eval_rows does it: points of standard input, hexfloats.
void points(const std::string& name)
{
    std::string text;
    for (char part[1 << 16];;) {
        const std::size_t n = std::fread(part, 1, sizeof part, stdin);
        if (n == 0) break;
        text.append(part, n);
    }
    std::vector<std::array<double, 2>> all;
    const char *at = text.data(), *const end = at + text.size();
    const auto number = [&] {
        double x = NAN;
        at = std::from_chars(at + std::strlen("0x"), end, x, std::chars_format::hex).ptr + 1;
        return x;
    };
    while (at + 2 < end) {
        const double p = number(), load = number();
        all.push_back({p, load});
    }
    const Quantity& q = *find_quantity(name);
    std::vector<double> nearest;
    const double start = seconds();
    for (const auto& row : all) {
        const auto quick = q.nearest(row.data());
        nearest.push_back(quick ? *quick
                                : evaluate(q, Inputs({{"p", exact_rational(row[0])}, {"load", exact_rational(row[1])}}), {.digits = 17})
                                      .binary64.value_or(NAN));
    }
    std::printf("%.6f\n", seconds() - start);
    text.resize(32 * nearest.size());
    char* to = text.data();
    for (const double x : nearest) *(to = std::to_chars(to, text.data() + text.size(), x, std::chars_format::hex).ptr) = '\n', ++to;
    std::fwrite(text.data(), 1, static_cast<std::size_t>(to - text.data()), stdout);
}

// ---- double forms
struct Form {
    const char *name, *equation;
    std::function<void(const std::vector<double>&, const std::vector<double>&, std::vector<double>&)> ours, printed, gsl;
    std::function<Mpfr(Mpfr, Mpfr)> exact;
};

/// A loop over points with the form in it, so that the call is not what is timed.
template <class F>
auto over(F f)
{
    return [f](const std::vector<double>& x, const std::vector<double>& load, std::vector<double>& out) {
        for (std::size_t i = 0; i < x.size(); ++i) out[i] = f(x[i], load[i]);
    };
}

double gsl_exceedance(double p, double load)
{
    const double R = gsl_hypot(1 - load, p);
    return 2 / M_PI * GSL_REAL(gsl_complex_arcsin_real(std::sqrt(0.5 * ((load + 1) - R))));
}
double gsl_density(double p, double load)
{
    const double m = 1 - load, R = gsl_hypot(m, p);
    return p / (M_PI * R * std::sqrt(2 * load * (m + R) - gsl_pow_2(p)));
}
double gsl_pressure(double x, double load)
{
    const double sa = gsl_sf_sin(M_PI * (GSL_REAL(gsl_complex_arcsin_real(std::sqrt(load))) / M_PI)), sx = gsl_sf_sin(M_PI * x);
    return 2 * load * gsl_sf_cos(M_PI * x) / gsl_pow_2(sa) * std::sqrt(std::max(0.0, gsl_pow_2(sa) - gsl_pow_2(sx)));
}
template <class T>
T step_as_printed(const T& delta)
{
    return std::pow(2.0, delta) * std::tgamma(1 + delta / 2) / (std::sqrt(M_PI) * std::tgamma(1.5 + delta / 2));
}
double gsl_step(double delta) { return std::pow(2.0, delta) * gsl_sf_gamma(1 + delta / 2) / (M_SQRTPI * gsl_sf_gamma(1.5 + delta / 2)); }

template <class F>
std::vector<double> timed(const F& f, const std::vector<double>& x, const std::vector<double>& load, std::vector<double>& out)
{
    std::vector<double> times;
    for (int batch = 0; batch < 5; ++batch) {
        long n = 0;
        const double start = seconds();
        do f(x, load, out), n += static_cast<long>(x.size());
        while (seconds() - start < 0.1);
        times.push_back(1e9 * (seconds() - start) / static_cast<double>(n));
    }
    return times;
}

/// In ulps of the value, beyond what half an ulp of each input can move it: near an edge that is what no double form can help.
double largest_error(const Form& form, const std::vector<double>& x, const std::vector<double>& load, const std::vector<double>& out)
{
    Mpfr::default_precision(60);
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); i += 71) {
        const Mpfr a(x[i]), s(load[i]), exact = form.exact(a, s);
        const double nearest = static_cast<double>(exact), unit = std::nextafter(std::fabs(nearest), INFINITY) - std::fabs(nearest);
        const auto moved = [&](const Mpfr& b, const Mpfr& t) {
            return static_cast<double>(Mpfr(abs(form.exact(b, t) - exact) / Mpfr(unit)));
        };
        const Mpfr half_x = Mpfr(std::nextafter(x[i], INFINITY) - x[i]) / 2, half_s = Mpfr(std::nextafter(load[i], INFINITY) - load[i]) / 2;
        const double forced = std::max(moved(a + half_x, s), moved(a - half_x, s)) + std::max(moved(a, s + half_s), moved(a, s - half_s));
        if (!std::isfinite(out[i])) return INFINITY;
        if (std::isfinite(forced)) worst = std::max(worst, static_cast<double>(Mpfr(abs(exact - Mpfr(out[i])) / Mpfr(unit))) - forced);
    }
    return worst;
}

void doubles()
{
    // loads all over (0, 1); a tenth of the points within 1e-6 of the edge of contact or of the highest pressure
    std::mt19937_64 random(20261123);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> load, p, x, delta, out(70000);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double s = std::max(1e-6, unit(random)), share = i % 10 == 0 ? 1 - 1e-6 * unit(random) : unit(random);
        load.push_back(s);
        p.push_back(2 * std::sqrt(s) * share);
        x.push_back(std::asin(std::sqrt(s)) / M_PI * share);
        delta.push_back(0.5 + 0.5 * share);
    }
    const std::vector<Form> forms{
        {"westergaard::half_width", "2.5", over([](double, double s) { return westergaard::half_width(s); }),
         over([](double, double s) { return as_printed::half_width(s); }),
         over([](double, double s) { return GSL_REAL(gsl_complex_arcsin_real(std::sqrt(s))) / M_PI; }),
         [](const Mpfr&, const Mpfr& s) { return westergaard::half_width(s); }},
        {"westergaard::pressure_partial", "2.4", over([](double y, double s) { return westergaard::pressure_partial(y, s); }),
         over([](double y, double s) { return as_printed::pressure_partial(y, s); }), over(gsl_pressure),
         [](const Mpfr& y, const Mpfr& s) { return westergaard::pressure_partial(y, s); }},
        {"westergaard::exceedance_partial", "2.17", over([](double y, double s) { return westergaard::exceedance_partial(y, s); }),
         over([](double y, double s) { return as_printed::exceedance_partial(y, s); }), over(gsl_exceedance),
         [](const Mpfr& y, const Mpfr& s) { return westergaard::exceedance_partial(y, s); }},
        {"westergaard::density_partial", "2.19", over([](double y, double s) { return westergaard::density_partial(y, s); }),
         over([](double y, double s) { return as_printed::density_partial(y, s); }), over(gsl_density),
         [](const Mpfr& y, const Mpfr& s) { return westergaard::density_partial(y, s); }},
        {"hertz::pressure", "2.6", over([](double y, double s) { return hertz::pressure(y, s); }),
         over([](double y, double s) { return as_printed::hertz_pressure(y, s); }), nullptr,
         [](const Mpfr& y, const Mpfr& s) { return hertz::pressure(y, s); }},
        {"archard::step", "7.13", over([](double d, double) { return archard::step(d); }),
         over([](double d, double) { return step_as_printed(d); }), over([](double d, double) { return gsl_step(d); }),
         [](const Mpfr& d, const Mpfr&) { return archard::step(d); }}};
    for (const Form& form : forms) {
        const std::vector<double>& at = std::strstr(form.name, "pressure") != nullptr ? x
                                        : std::strstr(form.name, "step") != nullptr   ? delta
                                                                                      : p;
        const auto row = [&](const char* tool, const auto& f) {
            if (!f) return;
            const std::vector<double> times = timed(f, at, load, out);
            std::printf("%s %s %s", form.name, form.equation, tool);
            for (const double t : times) std::printf(" %.4f", t);
            std::printf(" %.3g\n", largest_error(form, at, load, out));
        };
        row("ours", form.ours);
        row("printed", form.printed);
        row("gsl", form.gsl);
    }
}

} // namespace

int main(int count, char** words)
{
    const std::string what = count > 1 ? words[1] : "", argument = count > 2 ? words[2] : "";
    if (what == "product" && count == 3) product(std::stol(argument));
    else if (what == "gamma" && count == 3) gamma_time(std::stol(argument));
    else if (what == "multiply" && count == 3) multiply_time(std::stol(argument));
    else if (what == "nested" && count == 4) nested(std::stoi(argument), std::stol(words[3]));
    else if (what == "areas" && count > 5) areas(std::stoi(argument), std::atof(words[3]), std::atof(words[4]), count - 5, words + 5);
    else if (what == "points" && count == 3) points(argument);
    else if (what == "doubles" && count == 2) doubles();
    else {
        std::fputs("usage: bench_peer_values product DIGITS | gamma DIGITS | multiply BITS | nested N DIGITS | "
                   "areas N G TOLERANCE LOAD... | points QUANTITY | doubles\n",
                   stderr);
        return 64;
    }
    return 0;
}
