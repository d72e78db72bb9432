// SPDX-License-Identifier: MIT
#include "touchstone/certificate/law_pieces.hpp"

#include "touchstone/certificate/text.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchstone::certificate {
namespace {

constexpr int terms =
    24; ///< of a polynomial, before those that make nothing are left out: some 12 digits where pieces are as narrow as these
constexpr double lower_overlap = 0.4; ///< of its width: a piece is continued below its end where an interval of the checker begins
constexpr unsigned deepest = 3;       ///< halvings of a part of an integral

/// In parts four times as long as the one before, the first of them as long as `least`: at load 1 the integrand is that steep next to v =
/// 0.
template <class F>
double integral(F&& f, double from, double to, double least)
{
    double sum = 0, end = least;
    while (end <= from) end *= 4;
    for (; from < to; from = end, end *= 4)
        sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, std::min(end, to), deepest, 1e-12);
    return sum;
}

/// The integrand in u = v, or in u = s = sqrt(1 - v^2).
double integrand(double Y, const std::function<double(Place)>& phi, Place place, double u, bool in_s, Read read)
{
    const double k = in_s ? u * u : 1 - u * u, c2 = in_s ? 1 - u * u : u * u;
    const double r = place.T * k, rest = place.rest + place.T * c2, x = Y * rest;
    const double here = phi({r * (2 - r), rest * rest}) * x * (in_s ? u : 1);
    if (read == Read::force) return here * x * (in_s ? 1 : u);
    const double R = std::sqrt((1 - x) * (1 - x) + 4 * Y * place.rest);
    if (read == Read::share)
        return here * 2 / std::numbers::pi * std::asin(std::sqrt(std::min(1.0, 2 * Y * place.T * c2 / (1 + x + R)))) * (in_s ? 1 : u);
    return here * std::sqrt((1 + x + R) / (1 - x + R)) / R / (in_s ? std::sqrt(c2) : 1);
}

int exponent_of(const Piece& p) { return std::ilogb(*std::max_element(p.coefficients.begin(), p.coefficients.end())) - 52; }

} // namespace

double Piece::operator()(double T) const // Clenshaw
{
    const double t = (T - centre) / radius;
    double a = 0, b = 0;
    for (std::size_t k = coefficients.size(); k-- > 1;) a = std::exchange(b, 2 * t * b - a + coefficients[k]);
    return std::pow(T, power / 2.0) * (t * b - a + coefficients[0]);
}

double over_pieces(double Y, const std::vector<double>& cuts, const std::function<double(Place)>& phi, Place place, Read read)
{
    std::vector<double> k;
    for (const double r : cuts) k.push_back(std::min(1.0, r / place.T));
    k.back() = 1;
    const double steep = std::max(std::sqrt(place.rest), 1e-12);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < k.size(); ++i) {
        sum += integral([&](double v) { return integrand(Y, phi, place, v, false, read); }, std::sqrt(1 - k[i + 1]),
                        std::min(0.8, std::sqrt(1 - k[i])), steep);
        sum += integral([&](double s) { return integrand(Y, phi, place, s, true, read); }, std::sqrt(k[i]),
                        std::min(0.6, std::sqrt(k[i + 1])), 1);
    }
    return sum;
}

Piece fitted(double least, double low, double high, int power, const std::function<double(double T)>& density, double small)
{
    Piece p{low, high, (least + high) / 2, (high - least) / 2 * (1 + 0x1p-40), power, {}};
    std::vector<double> values(terms), c(terms, 0.0);
    for (int j = 0; j < terms; ++j) {
        const double T = p.centre + p.radius * std::cos(std::numbers::pi * (2 * j + 1) / (2 * terms));
        values[static_cast<std::size_t>(j)] = density(T) / std::pow(T, power / 2.0);
    }
    for (int k = 0; k < terms; ++k)
        for (int j = 0; j < terms; ++j)
            c[static_cast<std::size_t>(k)] += (k == 0 ? 1.0 : 2.0) / terms * values[static_cast<std::size_t>(j)] *
                                              std::cos(k * std::numbers::pi * (2 * j + 1) / (2 * terms));
    while (c.size() > 3 && std::abs(c.back()) < small * std::abs(c[0])) c.pop_back();
    p.coefficients = std::move(c);
    return p;
}

double least_of(double low, double high) { return std::max(low - lower_overlap * (high - low), 0.3 * low); }

int power_between(double low, double high, const std::function<double(double T)>& density)
{
    const double middle = std::sqrt(low * high), up = (middle + high) / 2, down = (middle + low) / 2;
    return std::max(0, static_cast<int>(std::lround(2 * std::log(density(up) / density(down)) / std::log(up / down))));
}

double ratio_cut(double T) { return T / (1 + std::sqrt(1 - T)); }

Rational exactly(double x)
{
    Rational r;
    mpq_set_d(r.get_mpq_t(), x);
    return r;
}


std::string shape(const Piece& p)
{
    return fmt::format("low={} high={} centre={} radius={} power={} exponent={}", dyadic(exactly(p.low)), dyadic(exactly(p.high)),
                       dyadic(exactly(p.centre)), dyadic(exactly(p.radius)), p.power, exponent_of(p));
}

std::string coefficients(const Piece& p)
{
    std::string text;
    for (const double c : p.coefficients) text += ' ' + hex(mpz_class(std::nearbyint(std::ldexp(c, -exponent_of(p)))));
    return text;
}

} // namespace touchstone::certificate
