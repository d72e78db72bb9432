// SPDX-License-Identifier: GPL-3.0-or-later
// bench_peer_integrals TOOL NAME DIGITS: one integral by one tool; peers.py runs it.
// TOOL: boost (tanh_sinh, exp_sinh, sinh_sinh on MPFR, or on double at 15 digits), gsl (QAGS, QAGIU, QAGI), arb (acb_calc_integrate).
//       ours: the formula of the environment's TOUCHSTONE_FORMULA from TOUCHSTONE_FROM to TOUCHSTONE_TO by `integrate`; (6.7) from the
//       header.
// Prints "times" (first call, then the means of up to five batches, fewer where they would take over 2 s; milliseconds of the processor),
// then "value" or "refused". The functions of the peers are written by formulas.py at build time.
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/quadrature/half_powers.hpp"
#include "touchstone/quadrature/integrate.hpp"
#include "touchstone/scalar/flint_headers.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/sinh_sinh.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf.h>
#include <mpfr.h>

#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#include <flint/acb_elliptic.h>
#include <flint/acb_hypgeom.h>
#else
#include <acb_calc.h>
#include <acb_elliptic.h>
#include <acb_hypgeom.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Mpfr = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;
using touchstone::WorkingPrecision;
using std::asin, std::atan, std::cos, std::cosh, std::exp, std::log, std::log1p, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;

struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};
[[noreturn]] void no_function(const char* name) { throw Refused(std::string("has no ") + name); }

// ---- what the formulas need of each number type
template <class T>
T number(const char* text);
template <class T>
T pi_of();
template <class T>
T integer_power(T base, long n)
{
    T result(1);
    for (; n > 0; n /= 2, base = T(base * base))
        if (n % 2) result = T(result * base);
    return result;
}

template <>
double number(const char* text) { return std::atof(text); }
template <>
double pi_of() { return M_PI; }
double power(double x, double y) { return std::pow(x, y); }
double sech(double x) { return 1 / std::cosh(x); }
double sinc(double x) { return x == 0 ? 1 : std::sin(x) / x; }
double erf_of(double x) { return std::erf(x); }
double gamma_of(double x) { return std::tgamma(x); }
double lgamma_of(double x) { return std::lgamma(x); }
double zeta_of(double x) { return gsl_sf_zeta(x); }
double airyai(double x) { return gsl_sf_airy_Ai(x, GSL_PREC_DOUBLE); }
double besselk(int n, double x) { return gsl_sf_bessel_Kn(n, x); }
double besseli(int n, double x) { return gsl_sf_bessel_In(n, x); }
double besselj(int n, double x) { return gsl_sf_bessel_Jn(n, x); }
double lambertw(double x) { return gsl_sf_lambert_W0(x); }
double ellipe(double m) { return gsl_sf_ellint_Ecomp(std::sqrt(m), GSL_PREC_DOUBLE); }
double agm(double a, double b)
{
    while (std::fabs(a - b) > 1e-15 * a) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}

template <class F>
Mpfr of_mpfr(F f, const Mpfr& x)
{
    Mpfr y;
    f(y.backend().data(), x.backend().data(), MPFR_RNDN);
    return y;
}
template <>
Mpfr number(const char* text) { return Mpfr(text); }
template <>
Mpfr pi_of()
{
    Mpfr y;
    mpfr_const_pi(y.backend().data(), MPFR_RNDN);
    return y;
}
Mpfr power(const Mpfr& x, const Mpfr& y) { return Mpfr(pow(x, y)); }
Mpfr sech(const Mpfr& x) { return of_mpfr(mpfr_sech, x); }
Mpfr sinc(const Mpfr& x) { return x == 0 ? Mpfr(1) : Mpfr(sin(x) / x); }
Mpfr log1p(const Mpfr& x) { return of_mpfr(mpfr_log1p, x); }
Mpfr erf_of(const Mpfr& x) { return of_mpfr(mpfr_erf, x); }
Mpfr gamma_of(const Mpfr& x) { return of_mpfr(mpfr_gamma, x); }
Mpfr lgamma_of(const Mpfr& x) { return of_mpfr(mpfr_lngamma, x); }
Mpfr zeta_of(const Mpfr& x) { return of_mpfr(mpfr_zeta, x); }
Mpfr airyai(const Mpfr& x) { return of_mpfr(mpfr_ai, x); }
Mpfr besselj(long n, const Mpfr& x)
{
    Mpfr y;
    mpfr_jn(y.backend().data(), n, x.backend().data(), MPFR_RNDN);
    return y;
}
Mpfr besselk(long, const Mpfr&) { no_function("Bessel function K"); }
Mpfr besseli(long, const Mpfr&) { no_function("Bessel function I"); }
Mpfr lambertw(const Mpfr&) { no_function("Lambert function"); }
Mpfr ellipe(const Mpfr&) { no_function("elliptic integral E"); }
Mpfr agm(const Mpfr& a, const Mpfr& b)
{
    Mpfr y;
    mpfr_agm(y.backend().data(), a.backend().data(), b.backend().data(), MPFR_RNDN);
    return y;
}

/// A ball of Arb with its arithmetic at the precision in force, and no more.
struct Complex {
    acb_t z;
    Complex() { acb_init(z); }
    Complex(long n) : Complex() { acb_set_si(z, n); }
    Complex(const Complex& o) : Complex() { acb_set(z, o.z); }
    Complex(Complex&& o) noexcept : Complex() { acb_swap(z, o.z); }
    Complex& operator=(Complex o) noexcept { acb_swap(z, o.z); return *this; }
    ~Complex() { acb_clear(z); }
    friend Complex operator+(const Complex& a, const Complex& b) { Complex c; acb_add(c.z, a.z, b.z, WorkingPrecision::bits()); return c; }
    friend Complex operator-(const Complex& a, const Complex& b) { Complex c; acb_sub(c.z, a.z, b.z, WorkingPrecision::bits()); return c; }
    friend Complex operator*(const Complex& a, const Complex& b) { Complex c; acb_mul(c.z, a.z, b.z, WorkingPrecision::bits()); return c; }
    friend Complex operator/(const Complex& a, const Complex& b) { Complex c; acb_div(c.z, a.z, b.z, WorkingPrecision::bits()); return c; }
    Complex operator-() const { Complex c; acb_neg(c.z, z); return c; }
    acb_ptr get() { return z; }
    acb_srcptr get() const { return z; }
};
/// Whether the integrator asks the function to be analytic on the box: what has a branch cut then answers NaN on it, as acb_calc's manual
/// says.
thread_local bool analytic = false;
Complex not_a_number()
{
    Complex w;
    acb_indeterminate(w.z);
    return w;
}
template <>
Complex number(const char* text) 
{
    const touchstone::Ball x(*touchstone::parse_rational(text));
    Complex w;
    acb_set_arb(w.z, x.get());
    return w;
}
template <>
Complex pi_of() 
{
    Complex w;
    acb_const_pi(w.z, WorkingPrecision::bits());
    return w;
}
template <class F>
Complex of_arb(F f, const Complex& z)
{
    Complex w;
    f(w.get(), z.get(), WorkingPrecision::bits());
    return w;
}
template <class F>
Complex of_analytic(F f, const Complex& z)
{
    Complex w;
    f(w.get(), z.get(), analytic, WorkingPrecision::bits());
    return w;
}
Complex integer_power(const Complex& z, long n)
{
    Complex w;
    acb_pow_ui(w.get(), z.get(), static_cast<ulong>(n), WorkingPrecision::bits());
    return w;
}
Complex power(const Complex& z, const Complex& y)
{
    Complex w;
    acb_pow_analytic(w.get(), z.get(), y.get(), analytic, WorkingPrecision::bits());
    return w;
}
Complex sqrt(const Complex& z) { return of_analytic(acb_sqrt_analytic, z); }
Complex log(const Complex& z) { return of_analytic(acb_log_analytic, z); }
Complex log1p(const Complex& z) { return log(1 + z); }
Complex off_cut(const Complex& w, const Complex& z, bool imaginary_axis)
{ // the cuts of asin leave -1 and 1 along the real axis, those of atan -i and i along the imaginary one
    if (!analytic) return w;
    const arb_srcptr across = imaginary_axis ? acb_realref(z.get()) : acb_imagref(z.get()),
                     along = imaginary_axis ? acb_imagref(z.get()) : acb_realref(z.get());
    touchstone::Ball size;
    arb_abs(size.get(), along);
    return arb_contains_zero(across) && !arb_lt(size.get(), touchstone::Ball(1).get()) ? not_a_number() : w;
}
Complex asin(const Complex& z) { return off_cut(of_arb(acb_asin, z), z, false); }
Complex atan(const Complex& z) { return off_cut(of_arb(acb_atan, z), z, true); }
Complex exp(const Complex& z) { return of_arb(acb_exp, z); }
Complex sin(const Complex& z) { return of_arb(acb_sin, z); }
Complex cos(const Complex& z) { return of_arb(acb_cos, z); }
Complex tan(const Complex& z) { return of_arb(acb_tan, z); }
Complex sinh(const Complex& z) { return of_arb(acb_sinh, z); }
Complex cosh(const Complex& z) { return of_arb(acb_cosh, z); }
Complex tanh(const Complex& z) { return of_arb(acb_tanh, z); }
Complex sech(const Complex& z) { return of_arb(acb_sech, z); }
Complex sinc(const Complex& z) { return of_arb(acb_sinc, z); }
Complex erf_of(const Complex& z) { return of_arb(acb_hypgeom_erf, z); }
Complex gamma_of(const Complex& z) { return of_arb(acb_gamma, z); }
Complex lgamma_of(const Complex& z) { return of_arb(acb_lgamma, z); } // right of 0 in these integrals
Complex zeta_of(const Complex& z) { return of_arb(acb_zeta, z); }
Complex ellipe(const Complex& z) { return of_arb(acb_elliptic_e, z); }
Complex airyai(const Complex& z)
{
    Complex w;
    acb_hypgeom_airy(w.get(), nullptr, nullptr, nullptr, z.get(), WorkingPrecision::bits());
    return w;
}
Complex besselj(long n, const Complex& z)
{
    Complex w;
    acb_hypgeom_bessel_j(w.get(), Complex(n).get(), z.get(), WorkingPrecision::bits());
    return w;
}
Complex besselk(long, const Complex&) { no_function("finite range"); }
Complex besseli(long, const Complex&) { no_function("finite range"); }
Complex lambertw(const Complex& z)
{
    Complex w;
    const fmpz_t branch = {0};
    acb_lambertw(w.get(), z.get(), branch, 0, WorkingPrecision::bits());
    return w;
}
Complex agm(const Complex& a, const Complex& b)
{
    Complex w;
    acb_agm(w.get(), a.get(), b.get(), WorkingPrecision::bits());
    return w;
}

/// An integrand, an end (none: infinite). Pointers, so that each integrator is compiled once.
template <class T>
using Function = T (*)(const T&);
template <class T>
using End = T (*)();
struct Infinite {};
template <class E, class T>
constexpr End<T> end_of()
{
    if constexpr (std::is_same_v<E, Infinite>) return nullptr;
    else return &E::template of<T>;
}

#include "integrals.inc"

// ---- the tools: each adds up the pieces of an integral
template <class T>
std::string text_of(const T& x)
{
    if constexpr (std::is_same_v<T, double>) {
        char digits[40];
        std::snprintf(digits, sizeof digits, "%.17g", x);
        return digits;
    }
    else return x.str();
}

template <class T>
struct ByBoost {
    T total = 0;
    template <class F, class A, class B>
    void piece() { add(&F::template of<T>, end_of<A, T>(), end_of<B, T>()); }
    void add(Function<T> f, End<T> a, End<T> b)
    {
        using namespace boost::math::quadrature;
        constexpr bool is_double = std::is_same_v<T, double>;
        const T eps = is_double ? T(std::numeric_limits<double>::epsilon()) : T(pow(T(10), -static_cast<int>(Mpfr::default_precision())));
        const T tolerance(sqrt(eps)); // the last step halves the error's exponent, says the manual
        T error = 0, size = 0;
        if (a != nullptr && b != nullptr) {
            static tanh_sinh<T> rule = [&] {
                if constexpr (is_double) return tanh_sinh<T>();
                else return tanh_sinh<T>(20, T(pow(eps, 20)));
            }();
            total += rule.integrate(f, a(), b(), tolerance, &error, &size);
        }
        else if (a != nullptr) {
            static exp_sinh<T> rule(is_double ? 9 : 14);
            const T from = a();
            const std::function<T(const T&)> shifted = [&](const T& x) -> T { return f(T(from + x)); };
            total += rule.integrate(shifted, tolerance, &error, &size);
        }
        else {
            static sinh_sinh<T> rule(is_double ? 9 : 14);
            total += rule.integrate(f, tolerance, &error, &size);
        }
        if (!(error <= 10 * tolerance * size)) throw Refused("its own estimate is too large");
    }
    std::string text() const { return text_of(total); }
};

struct ByGsl {
    double total = 0;
    template <class F, class A, class B>
    void piece() { add(&F::template of<double>, end_of<A, double>(), end_of<B, double>()); }
    void add(Function<double> function, End<double> a, End<double> b)
    {
        static const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> space(
            gsl_integration_workspace_alloc(5000), gsl_integration_workspace_free);
        gsl_function f{[](double x, void* g) { return (*static_cast<Function<double>*>(g))(x); }, &function};
        double value = 0, error = 0;
        const int status = a != nullptr && b != nullptr ? gsl_integration_qags(&f, a(), b(), 0, 1e-13, 5000, space.get(), &value, &error)
                           : a != nullptr               ? gsl_integration_qagiu(&f, a(), 0, 1e-13, 5000, space.get(), &value, &error)
                                                        : gsl_integration_qagi(&f, 0, 1e-13, 5000, space.get(), &value, &error);
        // QAGS reports roundoff next to the last bits even where all is well: what counts is its own estimate
        if (status != 0 && !(error <= 1e-12 * std::fabs(value))) throw Refused(gsl_strerror(status));
        total += value;
    }
    std::string text() const { return text_of(total); }
};

struct ByArb {
    long digits;
    Complex total = {};
    template <class F, class A, class B>
    void piece() { add(&F::template of<Complex>, end_of<A, Complex>(), end_of<B, Complex>()); }
    void add(Function<Complex> f, End<Complex> a, End<Complex> b)
    {
        if (a == nullptr || b == nullptr) throw Refused("needs a finite range");
        const auto call = [](acb_ptr out, const acb_t z, void* function, slong order, slong bits) -> int {
            const WorkingPrecision here(bits);
            Complex argument;
            acb_set(argument.z, z);
            analytic = order != 0;
            acb_set(out, (*static_cast<Function<Complex>*>(function))(argument).z);
            return 0;
        };
        const slong bits = WorkingPrecision::bits();
        mag_t tolerance;
        mag_init(tolerance);
        mag_set_ui_2exp_si(tolerance, 1, -bits);
        analytic = false;
        Complex value;
        acb_calc_integrate(value.z, call, &f, a().z, b().z, bits, tolerance, nullptr, bits);
        mag_clear(tolerance);
        total = total + value;
    }
    std::string text() const
    {
        touchstone::Ball real;
        acb_get_real(real.get(), total.z);
        if (!acb_is_finite(total.z)) throw Refused("NaN: wants a bounded integrand");
        if (static_cast<double>(real.relative_bits()) < 3.3219 * static_cast<double>(digits - 3))
            throw Refused("ball too wide: " + real.to_string(12));
        return real.to_string(digits + 5);
    }
};

// ---- ours
std::string by_integrate(long digits)
{
    using namespace touchstone::quadrature;
    IntegralOptions options;
    options.digits = digits;
    const Integral i = integrate(parse_expression(std::getenv("TOUCHSTONE_FORMULA")), parse_limit(std::getenv("TOUCHSTONE_FROM")),
                                 parse_limit(std::getenv("TOUCHSTONE_TO")), options);
    if (i.status != touchstone::quadrature::Status::certified) throw Refused(i.reason);
    return i.value.to_string(digits + 5);
}

/// (6.7), n = 1, load 1/10, G = 4, from the formulas of the library.
std::string area(long digits)
{
    using namespace touchstone;
    using namespace touchstone::quadrature;
    const Rational load(1, 10), G(4);
    const auto f = [&](auto p, auto, auto r) {
        using T = decltype(p);
        const T s(load), top = 2 * sqrt(s);
        return westergaard::density_partial(p, s, T(sqrt(r * (top + p)))) * 2 * asin(sqrt(p / T(G))) / touchstone::pi<T>();
    };
    Options options;
    options.digits = digits;
    const Enclosure e = proven_integral(f, Interval::finite(0, Endpoint([&] { return 2 * touchstone::sqrt(Ball(load)); })), options);
    if (e.status != touchstone::quadrature::Status::certified) throw Refused(e.reason);
    return e.value.to_string(digits + 5);
}

// ---- the clock
double milliseconds()
{
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

void report(const std::function<std::string()>& once)
{
    std::vector<double> times;
    std::string value, refused;
    const auto call = [&] {
        try {
            value = once();
        }
        catch (const std::exception& e) { // Boost reports a function that is not finite so
            refused = e.what();
        }
    };
    double start = milliseconds();
    call();
    times.push_back(milliseconds() - start);
    for (int batch = 0; batch < static_cast<int>(std::min(5.0, 2000 / std::max(times[0], 1.0))) && refused.empty(); ++batch) {
        long n = 0;
        start = milliseconds();
        do call();
        while (++n, milliseconds() - start < 24); // CPU time comes in ticks
        times.push_back((milliseconds() - start) / static_cast<double>(n));
    }
    std::printf("times");
    for (const double t : times) std::printf(" %.5f", t);
    std::printf("\n%s %s\n", refused.empty() ? "value" : "refused", (refused.empty() ? value : refused).c_str());
}

template <class Tool>
std::string by(const std::string& name, Tool tool)
{
    if (!run(name, tool)) throw Refused("unknown integral");
    return tool.text();
}

} // namespace

int main(int count, char** words)
{
    if (count != 4) {
        std::fputs("usage: bench_peer_integrals ours|boost|gsl|arb NAME DIGITS\n", stderr);
        return 64;
    }
    const std::string tool = words[1], name = words[2];
    const long digits = std::atol(words[3]);
    gsl_set_error_handler_off();
    if (tool == "ours") report([&] { return name == "area" ? area(digits) : by_integrate(digits); });
    else if (tool == "gsl") report([&] { return by(name, ByGsl{}); });
    else if (tool == "boost" && digits <= 15) report([&] { return by(name, ByBoost<double>{}); });
    else if (tool == "boost") {
        Mpfr::default_precision(static_cast<unsigned>(digits));
        report([&] { return by(name, ByBoost<Mpfr>{}); });
    }
    else if (tool == "arb") {
        const WorkingPrecision precision(touchstone::bits_for_digits(digits) + 16);
        report([&] { return by(name, ByArb{digits}); });
    }
    else return 64;
    return 0;
}
