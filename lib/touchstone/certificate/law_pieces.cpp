// SPDX-License-Identifier: MIT
#include "touchstone/certificate/law_pieces.hpp"

#include "touchstone/certificate/text.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchstone::certificate {
namespace {

/// Of a polynomial, before those that make nothing are left out: some 12 or 21 digits where pieces are as narrow as these.
template <class Real>
constexpr int terms = std::is_same_v<Real, double> ? 24 : 46;
constexpr double lower_overlap = 0.4; ///< of its width: a piece is continued below its end where an interval of the checker begins
constexpr slong bits_of_constants = 160;
template <class Real>
constexpr double least_weight = std::is_same_v<Real, double> ? 1e-300 : 1e-260; ///< below which a number keeps too few of its digits

double arcsine(double x) { return std::asin(x); }
Wide arcsine(const Wide& x)
{
    const WorkingPrecision precision(bits_of_constants);
    Ball b(exactly(x));
    arb_asin(b.get(), b.get(), WorkingPrecision::bits());
    return rounded<Wide>(b);
}

/// cos(k pi (2j + 1)/(2 count)), count = terms<Real>
template <class Real>
Real cosine(int k, int j)
{
    if constexpr (std::is_same_v<Real, double>) {
        return std::cos(k * std::numbers::pi * (2 * j + 1) / (2 * terms<double>));
    } else {
        constexpr int period = 4 * terms<Wide>;
        static const std::array<Wide, period> all = [] {
            const WorkingPrecision precision(bits_of_constants);
            std::array<Wide, period> c;
            for (int i = 0; i < period; ++i) {
                Ball b = Ball(i) / Ball(2 * terms<Wide>);
                arb_cos_pi(b.get(), b.get(), WorkingPrecision::bits());
                c[static_cast<std::size_t>(i)] = rounded<Wide>(b);
            }
            return c;
        }();
        return all[static_cast<std::size_t>(k * (2 * j + 1) % period)];
    }
}

template <class F>
double integral_of_part(F&& f, double from, double to)
{
    constexpr unsigned deepest = 3; // halvings
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, to, deepest, 1e-12);
}

/// By one rule of Gauss: where the integrand is analytic on an ellipse 2.6, as it is on these parts, its error is some 1e-24.
template <class F>
Wide integral_of_part(F&& f, const Wide& from, const Wide& to)
{
    constexpr int points = 30;
    static const auto rule = [] {
        const WorkingPrecision precision(bits_of_constants);
        std::array<std::pair<Wide, Wide>, points> all;
        for (int i = 0; i < points; ++i) {
            Ball x, w;
            arb_hypgeom_legendre_p_ui_root(x.get(), w.get(), points, static_cast<ulong>(i), WorkingPrecision::bits());
            all[static_cast<std::size_t>(i)] = {rounded<Wide>(x), rounded<Wide>(w)};
        }
        return all;
    }();
    const Wide middle = (from + to) / 2, half = (to - from) / 2;
    Wide sum = 0;
    for (const auto& [x, w] : rule) sum += w * f(middle + half * x);
    return sum * half;
}

/// In parts four times as long as the one before, the first of them as long as `least`: at load 1 the integrand is that steep next to v =
/// 0.
template <class Real, class F>
Real integral(F&& f, const Real& from, const Real& to, const Real& least)
{
    Real sum = 0, begin = from, end = least;
    while (end <= begin) end *= 4;
    for (; begin < to; begin = end, end *= 4) sum += integral_of_part(f, begin, std::min(end, to));
    return sum;
}

/// The integrand in u = v, or in u = s = sqrt(1 - v^2).
template <class Real>
Real integrand(const Real& Y, const std::function<Real(const Place<Real>&)>& phi, const Place<Real>& place, const Real& u, bool in_s,
               Read read)
{
    const Real k = in_s ? u * u : 1 - u * u, c2 = in_s ? 1 - u * u : u * u;
    const Real r = place.T * k, rest = place.rest + place.T * c2, x = Y * rest;
    const Real here = phi({r * (2 - r), rest * rest}) * x * (in_s ? u : Real(1));
    if (read == Read::force) return here * x * (in_s ? Real(1) : u);
    const Real R = root((1 - x) * (1 - x) + 4 * Y * place.rest);
    if (read == Read::share)
        return here * 2 / pi_number<Real>() * arcsine(root(std::min(Real(1), 2 * Y * place.T * c2 / (1 + x + R)))) * (in_s ? Real(1) : u);
    return here * root((1 + x + R) / (1 - x + R)) / R / (in_s ? root(c2) : Real(1));
}

template <class Real>
constexpr int kept_bits = std::is_same_v<Real, double> ? 52 : 84; ///< of the largest coefficient

template <class Real>
int exponent_of(const Piece<Real>& p)
{
    return std::ilogb(static_cast<double>(*std::max_element(p.coefficients.begin(), p.coefficients.end()))) - kept_bits<Real>;
}

mpz_class in_units(double x, int exponent) { return mpz_class(std::nearbyint(std::ldexp(x, -exponent))); }
mpz_class in_units(const Wide& x, int exponent)
{
    const WorkingPrecision precision(2 * bits_of_constants);
    return units(Ball(exactly(x) + exactly(std::ldexp(0.5, exponent))), -exponent);
}

template <class Real>
TOUCHSTONE_INLINE Real sum_of_series(const std::vector<Real>& coefficients, const Real& t) // Clenshaw
{
    Real a = 0, b = 0;
    for (std::size_t k = coefficients.size(); k-- > 1;) a = std::exchange(b, 2 * t * b - a + coefficients[k]);
    return t * b - a + coefficients[0];
}
double series(const std::vector<double>& coefficients, double t) { return sum_of_series(coefficients, t); }
TOUCHSTONE_CLONES Wide series(const std::vector<Wide>& coefficients, const Wide& t) { return sum_of_series(coefficients, t); }

} // namespace

double half_power(double T, int power) { return std::pow(T, power / 2.0); }
Wide half_power(const Wide& T, int power)
{
    Wide z = power % 2 ? sqrt(T) : Wide(1);
    for (int k = power / 2; k > 0; --k) z *= T;
    return z;
}

double root(double x) { return std::sqrt(x); }
Wide root(const Wide& x) { return sqrt(x); }

template <>
double rounded(const Ball& x)
{
    return nearest(x);
}
template <>
Wide rounded(const Ball& x)
{
    const double high = nearest(x);
    Ball rest;
    arf_set_d(arb_midref(rest.get()), high);
    arb_sub(rest.get(), x.get(), rest.get(), WorkingPrecision::bits());
    return {high, nearest(rest)};
}
template <class Real>
Real Piece<Real>::operator()(const Real& T) const
{
    return half_power(T, power) * series(coefficients, (T - centre) / radius);
}

template <class Real>
Real over_pieces(const Real& Y, const std::vector<Real>& cuts, const std::function<Real(const Place<Real>&)>& phi, const Place<Real>& place,
                 Read read)
{
    std::vector<Real> k;
    for (const Real& r : cuts) k.push_back(std::min(Real(1), r / place.T));
    k.back() = 1;
    const Real steep = std::max(root(place.rest), Real(1e-12));
    Real sum = 0;
    for (std::size_t i = 0; i + 1 < k.size(); ++i) {
        sum += integral<Real>([&](const Real& v) { return integrand(Y, phi, place, v, false, read); }, root(1 - k[i + 1]),
                              std::min(Real(4) / 5, root(1 - k[i])), steep);
        sum += integral<Real>([&](const Real& s) { return integrand(Y, phi, place, s, true, read); }, root(k[i]),
                              std::min(Real(3) / 5, root(k[i + 1])), Real(1));
    }
    return sum;
}

template <class Real>
Piece<Real> fitted(double least, double low, double high, int power, const std::function<Real(const Real& T)>& density, double small)
{
    constexpr int count = terms<Real>;
    Piece<Real> p{low, high, (least + high) / 2, (high - least) / 2 * (1 + 0x1p-40), power, {}};
    std::vector<Real> values(count), c(count, Real(0));
    for (int j = 0; j < count; ++j) {
        const Real T = p.centre + p.radius * cosine<Real>(1, j);
        const Real weight = half_power(T, power);
        if (!(weight > least_weight<Real>))
            throw BeyondReach("next to where it begins the law of so many scales is below the numbers of binary64");
        values[static_cast<std::size_t>(j)] = density(T) / weight;
    }
    for (int k = 0; k < count; ++k)
        for (int j = 0; j < count; ++j)
            c[static_cast<std::size_t>(k)] += Real(k == 0 ? 1.0 : 2.0) / count * values[static_cast<std::size_t>(j)] * cosine<Real>(k, j);
    p.coefficients = std::move(c);
    return shortened(std::move(p), small);
}

template <class Real>
Piece<Real> shortened(Piece<Real> p, double small)
{
    auto& c = p.coefficients;
    const double beside = small * std::abs(static_cast<double>(c[0]));
    while (c.size() > 3 && std::abs(static_cast<double>(c.back())) < beside) c.pop_back();
    return p;
}

double least_of(double low, double high) { return std::max(low - lower_overlap * (high - low), 0.3 * low); }

template <class Real>
int power_between(double low, double high, const std::function<Real(const Real& T)>& density)
{
    const double middle = std::sqrt(low * high), up = (middle + high) / 2, down = (middle + low) / 2;
    return std::max(0, static_cast<int>(std::lround(2 * std::log(static_cast<double>(density(up) / density(down))) / std::log(up / down))));
}

template <class Real>
Real ratio_cut(const Real& T)
{
    return T / (1 + root(1 - T));
}

Rational exactly(double x)
{
    Rational r;
    mpq_set_d(r.get_mpq_t(), x);
    return r;
}
Rational exactly(const Wide& x) { return exactly(x.high) + exactly(x.low); }

template <class Real>
std::string shape(const Piece<Real>& p)
{
    return fmt::format("low={} high={} centre={} radius={} power={} exponent={}", dyadic(exactly(p.low)), dyadic(exactly(p.high)),
                       dyadic(exactly(p.centre)), dyadic(exactly(p.radius)), p.power, exponent_of(p));
}

template <class Real>
std::string coefficients(const Piece<Real>& p)
{
    std::string text;
    for (const Real& c : p.coefficients) text += ' ' + hex(in_units(c, exponent_of(p)));
    return text;
}

#define TOUCHSTONE_LAW_PIECES(Real)                                                                                                        \
    template struct Piece<Real>;                                                                                                           \
    template Real over_pieces(const Real&, const std::vector<Real>&, const std::function<Real(const Place<Real>&)>&, const Place<Real>&,   \
                              Read);                                                                                                       \
    template Piece<Real> fitted(double, double, double, int, const std::function<Real(const Real&)>&, double);                             \
    template Piece<Real> shortened(Piece<Real>, double);                                                                                   \
    template int power_between(double, double, const std::function<Real(const Real&)>&);                                                   \
    template Real ratio_cut(const Real&);                                                                                                  \
    template std::string shape(const Piece<Real>&);                                                                                        \
    template std::string coefficients(const Piece<Real>&);
TOUCHSTONE_LAW_PIECES(double)
TOUCHSTONE_LAW_PIECES(Wide)
#undef TOUCHSTONE_LAW_PIECES

} // namespace touchstone::certificate
