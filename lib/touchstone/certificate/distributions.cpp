// SPDX-License-Identifier: MIT
#include "touchstone/certificate/distributions.hpp"

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchstone::certificate {
namespace {

constexpr int terms = 24;             ///< of a polynomial, before those that make nothing are left out: some 12 digits where pieces are as narrow as these
constexpr double widest = 2.2;        ///< upper over lower end of a piece
constexpr double lower_overlap = 0.4; ///< of its width: a piece is continued below its end where an interval of the checker begins
constexpr std::size_t most_pieces = 64;
constexpr unsigned deepest = 3;       ///< halvings of a part of an integral

/// 0 <= T <= 1 and 1 - T, which near 1 is not had from T.
struct Place {
    double T, rest;
};

struct Piece {
    double low, high, centre, radius;
    int power;
    std::vector<double> coefficients; ///< of Chebyshev's polynomials of (T - centre)/radius

    double operator()(double T) const // Clenshaw
    {
        const double t = (T - centre) / radius;
        double a = 0, b = 0;
        for (std::size_t k = coefficients.size(); k-- > 1;) a = std::exchange(b, 2 * t * b - a + coefficients[k]);
        return std::pow(T, power / 2.0) * (t * b - a + coefficients[0]);
    }
};

/// In parts four times as long as the one before, the first of them as long as `least`: at load 1 the integrand is that steep next to v = 0.
template <class F>
double integral(F&& f, double from, double to, double least)
{
    double sum = 0, end = least;
    while (end <= from) end *= 4;
    for (; from < to; from = end, end *= 4) sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, std::min(end, to), deepest, 1e-12);
    return sum;
}

/// What follows, level by level, from one load.
class Laws {
public:
    Laws(double G, double load, long levels) : G_(G), tops_{load}
    {
        for (long m = 0; m <= levels; ++m) tops_.push_back(2 / G * std::sqrt(tops_.back()));
        for (long m = 1; m < levels; ++m) pieces_.push_back(pieces_of(m));
    }
    /// phi_(m+1)
    double density(long m, Place at) const { return G_ * G_ / std::numbers::pi * std::sqrt(top(m) * at.T) * over_pieces(m, at, false); }
    /// The share of p_m above the pressure where T_(m+1) is at this place.
    double share(long m, Place at) const { return 2 * top(m) * at.T * over_pieces(m, at, true); }
    /// phi_m, m >= 1
    double phi(long m, Place at) const
    {
        if (m == 1) {
            const double load = tops_[0], R = std::sqrt((1 - load) * (1 - load) + 4 * load * at.rest);
            return G_ * G_ / (2 * std::numbers::pi * std::sqrt(load * at.T)) * std::sqrt((1 + load + R) / (1 - load + R)) / R;
        }
        const auto& all = pieces_[static_cast<std::size_t>(m - 2)];
        return (*std::find_if(all.begin(), all.end() - 1, [&](const Piece& p) { return at.T <= p.high; }))(at.T);
    }
    const std::vector<Piece>& pieces(long m) const { return pieces_[static_cast<std::size_t>(m - 2)]; } ///< m >= 2

private:
    double G_;
    std::vector<double> tops_;
    std::vector<std::vector<Piece>> pieces_; ///< of level 2, 3 ...

    double top(long m) const { return tops_[static_cast<std::size_t>(m)]; }

    /// The integrand in u = v, or in u = s = sqrt(1 - v^2).
    double at(long m, Place place, double u, bool in_s, bool share) const
    {
        const double k = in_s ? u * u : 1 - u * u, c2 = in_s ? 1 - u * u : u * u;
        const double r = place.T * k, rest = place.rest + place.T * c2, x = top(m) * rest;
        const double R = std::sqrt((1 - x) * (1 - x) + 4 * top(m) * place.rest), here = phi(m, {r * (2 - r), rest * rest}) * x * (in_s ? u : 1);
        if (share) return here * 2 / std::numbers::pi * std::asin(std::sqrt(std::min(1.0, 2 * top(m) * place.T * c2 / (1 + x + R)))) * (in_s ? 1 : u);
        return here * std::sqrt((1 + x + R) / (1 - x + R)) / R / (in_s ? std::sqrt(c2) : 1);
    }

    /// The upper ends of V_m's pieces, as r = 1 - x/Y_m.
    std::vector<double> ends(long m) const
    {
        std::vector<double> r;
        if (m > 1)
            for (const Piece& p : pieces(m)) r.push_back(p.high / (1 + std::sqrt(1 - p.high)));
        else
            r.push_back(1);
        return r;
    }

    double over_pieces(long m, Place place, bool share) const
    {
        std::vector<double> k{0};
        for (const double r : ends(m)) k.push_back(std::min(1.0, r / place.T));
        k.back() = 1;
        const double steep = std::max(std::sqrt(place.rest), 1e-12);
        double sum = 0;
        for (std::size_t i = 0; i + 1 < k.size(); ++i) {
            sum += integral([&](double v) { return at(m, place, v, false, share); }, std::sqrt(1 - k[i + 1]), std::min(0.8, std::sqrt(1 - k[i])), steep);
            sum += integral([&](double s) { return at(m, place, s, true, share); }, std::sqrt(k[i]), std::min(0.6, std::sqrt(k[i + 1])), 1);
        }
        return sum;
    }

    /// Where V_(m+1) is cut: where V_m's cuts come to lie, so often between that pieces are narrow, and towards T = 1, next to which R vanishes.
    std::vector<double> cuts(long m) const
    {
        std::vector<double> E = ends(m);
        E.insert(E.begin(), 0.0);
        const double first = std::ldexp(1, static_cast<int>(1 - m));
        if (E.size() == 2 && m > 1) E.insert(E.begin() + 1, first);
        while (m > 1 && E[1] > 1.3 * first) E.insert(E.begin() + 1, E[1] / 2);
        for (std::size_t i = 1; i + 1 < E.size() && E.size() < most_pieces; ++i)
            if (E[i + 1] > widest * E[i])
                E.insert(E.begin() + static_cast<std::ptrdiff_t>(i) + 1, E[i + 1] < widest * widest * E[i] ? std::sqrt(E[i] * E[i + 1]) : 2 * E[i]);
        const auto distance = [](double Y) { return (1 - Y) * (1 - Y) / (4 * Y); };
        const double room = std::min(distance(top(m)), std::sqrt(distance(top(m - 1))));
        while (1 - E[E.size() - 2] > widest * room && E.size() < most_pieces) E.insert(E.end() - 1, (1 + E[E.size() - 2]) / 2);
        if (E.size() >= most_pieces) throw BeyondReach("the law of the load ratio has no certificate there: its pieces would be too many");
        return E;
    }

    std::vector<Piece> pieces_of(long m) const
    {
        const std::vector<double> E = cuts(m);
        std::vector<Piece> found;
        for (std::size_t i = 0; i + 1 < E.size(); ++i) {
            const double least = i == 0 ? 0 : std::max(E[i] - lower_overlap * (E[i + 1] - E[i]), 0.3 * E[i]);
            Piece p{E[i], E[i + 1], (least + E[i + 1]) / 2, 0, static_cast<int>(m - 1), {}};
            p.radius = (E[i + 1] - least) / 2 * (1 + 0x1p-40);
            if (i > 0) { // as phi rises there, so that the polynomial is nearly constant
                const double middle = std::sqrt(E[i] * E[i + 1]), up = (middle + E[i + 1]) / 2, down = (middle + E[i]) / 2;
                p.power = std::max(0, static_cast<int>(std::lround(2 * std::log(density(m, {up, 1 - up}) / density(m, {down, 1 - down})) / std::log(up / down))));
            }
            fit(p, m);
            found.push_back(std::move(p));
        }
        return found;
    }

    void fit(Piece& p, long m) const
    {
        std::vector<double> values(terms), c(terms, 0.0);
        for (int j = 0; j < terms; ++j) {
            const double T = p.centre + p.radius * std::cos(std::numbers::pi * (2 * j + 1) / (2 * terms));
            values[static_cast<std::size_t>(j)] = density(m, {T, 1 - T}) / std::pow(T, p.power / 2.0);
        }
        for (int k = 0; k < terms; ++k)
            for (int j = 0; j < terms; ++j)
                c[static_cast<std::size_t>(k)] += (k == 0 ? 1.0 : 2.0) / terms * values[static_cast<std::size_t>(j)] * std::cos(k * std::numbers::pi * (2 * j + 1) / (2 * terms));
        while (c.size() > 3 && std::abs(c.back()) < 1e-15 * std::abs(c[0])) c.pop_back();
        p.coefficients = std::move(c);
    }
};

Rational exactly(double x)
{
    Rational r;
    mpq_set_d(r.get_mpq_t(), x);
    return r;
}

Ball number(const Root& G) { return G.degree == 1 ? Ball(G.base) : pow(Ball(G.base), 1 / Ball(static_cast<long>(G.degree))); }
double nearest(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

/// From which level a claim is read, 1 - T there, and what the integral is multiplied by.
struct Reading {
    long level;
    Ball rest, factor;
};

Reading reading(const Claim& c)
{
    const Ball G = number(c.G);
    Ball Y(c.load);
    for (long m = 0; m < c.n; ++m) Y = 2 * sqrt(Y) / G;
    if (c.of == Claim::Of::segments) {
        Ball x, twice;
        arb_sin_pi(x.get(), Ball(c.at).get(), WorkingPrecision::bits());
        arb_sin_pi(twice.get(), Ball(Rational(2 * c.at)).get(), WorkingPrecision::bits());
        x = x * x;
        return {c.n - 1, x * x / (Y * Y), x * twice * pi<Ball>()};
    }
    const Ball P = Ball(c.at) / pow(G, Ball(c.n));
    return {c.n, P * P / (4 * Y), c.of == Claim::Of::share ? Ball(1) : P / pow(G, Ball(c.n + 2))};
}

double value(const Claim& c, const Laws& laws)
{
    const Reading r = reading(c);
    const Place place{nearest(1 - r.rest), nearest(r.rest)};
    return c.of == Claim::Of::share ? laws.share(r.level, place) : nearest(r.factor) * laws.density(r.level, place);
}

/// 128, and at loads next to 1 what R and 1 - T cancel next to T = 1: four bits for each of 1 - T's there.
long interval_bits(const std::vector<Claim>& claims)
{
    const auto bits_below_1 = [](const Ball& x) { return std::max(0L, -ARF_EXP(arb_midref(x.get())) + 1); };
    long cancelled = 0;
    for (const Claim& c : claims) cancelled = std::max(cancelled, bits_below_1(reading(c).rest));
    if (claims.front().load < 1) cancelled = std::min(cancelled, bits_below_1(Ball(Rational(1 - claims.front().load))));
    constexpr long most = 512; // that the checker takes
    if (128 + 4 * cancelled > most) throw BeyondReach("so near to pressure 0 at a load so near to 1 the law of the load ratio has no certificate");
    return 128 + 4 * cancelled;
}

/// The numbers of the lines of pieces, level 2 first.
std::vector<std::vector<std::size_t>> write_pieces(const Laws& laws, long levels, int bits, std::size_t law, Lines& lines)
{
    std::vector<std::vector<std::size_t>> numbers{{}};
    for (long m = 2; m <= levels; ++m) {
        std::vector<std::size_t> rests_on{law}, here;
        rests_on.insert(rests_on.end(), numbers.back().begin(), numbers.back().end());
        const Rational error = exactly(std::ldexp(static_cast<double>(m - 1), -bits));
        for (const Piece& p : laws.pieces(m)) {
            const int exponent = std::ilogb(*std::max_element(p.coefficients.begin(), p.coefficients.end())) - 52;
            std::string data = fmt::format("m={:x} low={} high={} centre={} radius={} power={} exponent={} error={}", m, dyadic(exactly(p.low)), dyadic(exactly(p.high)),
                                           dyadic(exactly(p.centre)), dyadic(exactly(p.radius)), p.power, exponent, dyadic(error));
            for (const double c : p.coefficients) data += ' ' + hex(mpz_class(std::nearbyint(std::ldexp(c, -exponent))));
            here.push_back(lines.add("piece", rests_on, data));
        }
        numbers.push_back(std::move(here));
    }
    return numbers;
}

} // namespace

bool law_serves(const Claim& c) { return reading(c).level == 1 || c.load <= 1 - Rational(1, 1000000); }

std::string exact_end(const Claim& c)
{
    const WorkingPrecision precision(256);
    if (c.of == Claim::Of::segments && c.n < 2) return "n = 1 is of closed form: the checker needs no certificate";
    if (c.at <= 0 || (c.of == Claim::Of::segments && 2 * c.at >= 1)) return "a pressure or half-width at its end is an area, or exact";
    if (!certainly(less(reading(c).rest, Ball(1)))) return "at the largest pressure or half-width and beyond the checker needs no certificate";
    return "";
}

void write_distributions(const std::vector<Claim>& claims, long digits, std::size_t first_claim, std::size_t section, std::string& head, Lines& lines)
{
    const WorkingPrecision precision(256);
    const Claim& any = claims.front();
    long levels = 1;
    for (const Claim& c : claims) levels = std::max(levels, reading(c).level);
    const double goal = std::pow(10.0, -static_cast<double>(digits)) / 2;
    constexpr double share = 2; // of the goal, for the levels
    const int bits = static_cast<int>(std::ceil(std::log2(share * static_cast<double>(levels) / goal)));
    const Laws laws(nearest(number(any.G)), any.load.get_d(), levels);
    const std::size_t first = lines.count() + 1;
    const std::size_t law = lines.add("law", {}, fmt::format("G={} load={} bits={:x}", named(any.G), any.load.get_str(), interval_bits(claims)));
    const auto numbers = write_pieces(laws, levels, bits, law, lines);
    std::size_t pieces = 0;
    for (const auto& level : numbers) pieces += level.size();
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const Claim& c = claims[i];
        std::vector<std::size_t> rests_on{law};
        const auto& level = numbers[static_cast<std::size_t>(reading(c).level - 1)];
        rests_on.insert(rests_on.end(), level.begin(), level.end());
        lines.add("reading", rests_on, fmt::format("claim={}", first_claim + i));
        const double v = value(c, laws);
        if (!(v > std::numeric_limits<double>::min())) throw BeyondReach("what is below the numbers of binary64 has no certificate");
        head += fmt::format("claim {} n={:x} {}={} load={} G={} value={} error={}\n", first_claim + i, c.n, c.of == Claim::Of::segments ? "a" : "p", c.at.get_str(),
                            c.load.get_str(), named(c.G), dyadic(exactly(v)), dyadic(rounded_up(goal * v)));
    }
    head += fmt::format("section {} span={}-{} grids=0 panels=0 levels=0 values=0 limits=0 meshes=0 polynomials=0 shares=0 laws=1 pieces={} readings={}\n", section,
                        first, lines.count(), pieces, claims.size());
}

} // namespace touchstone::certificate
