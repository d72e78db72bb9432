// SPDX-License-Identifier: MIT
#include "touchstone/certificate/distributions.hpp"

#include "touchstone/certificate/law_pieces.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::certificate {

/// What follows, level by level, from one load.
template <class Real>
class Laws {
public:
    /// \param small of a piece's first coefficient: smaller ones at its end are left out
    Laws(const Root& G, const Rational& load, long levels, double small)
        : G_(rounded<Real>(number(G)))
        , tops_{rounded<Real>(load)}
        , small_(small)
    {
        for (long m = 0; m <= levels; ++m) tops_.push_back(2 / G_ * root(tops_.back()));
        for (long m = 1; m < levels; ++m) pieces_.push_back(pieces_of(m));
    }
    /// phi_(m+1)
    Real density(long m, const Place<Real>& at) const
    {
        return G_ * G_ / pi_number<Real>() * root(top(m) * at.T) * over(m, at, Read::density);
    }
    /// The share of p_m above the pressure where T_(m+1) is at this place.
    Real share(long m, const Place<Real>& at) const { return 2 * top(m) * at.T * over(m, at, Read::share); }
    /// phi_m, m >= 1
    Real phi(long m, const Place<Real>& at) const
    {
        if (m == 1) {
            const Real load = tops_[0], R = root((1 - load) * (1 - load) + 4 * load * at.rest);
            return G_ * G_ / (2 * pi_number<Real>() * root(load * at.T)) * root((1 + load + R) / (1 - load + R)) / R;
        }
        const auto& all = pieces_[static_cast<std::size_t>(m - 2)];
        return (*std::find_if(all.begin(), all.end() - 1, [&](const Piece<Real>& p) { return at.T <= p.high; }))(at.T);
    }
    const std::vector<Piece<Real>>& pieces(long m) const { return pieces_[static_cast<std::size_t>(m - 2)]; } ///< m >= 2

private:
    Real G_;
    std::vector<Real> tops_;
    double small_;
    std::vector<std::vector<Piece<Real>>> pieces_; ///< of level 2, 3 ...

    const Real& top(long m) const { return tops_[static_cast<std::size_t>(m)]; }

    /// V_m's pieces, as r = 1 - x/Y_m.
    std::vector<Real> ends(long m) const
    {
        std::vector<Real> r{Real(0)};
        if (m > 1)
            for (const Piece<Real>& p : pieces(m)) r.push_back(ratio_cut(Real(p.high)));
        else
            r.push_back(Real(1));
        return r;
    }

    Real over(long m, const Place<Real>& place, Read read) const
    {
        return over_pieces<Real>(top(m), ends(m), [&](const Place<Real>& p) { return phi(m, p); }, place, read);
    }

    /// Where V_(m+1) is cut: where V_m's cuts come to lie, so often between that pieces are narrow, and towards T = 1, next to which R
    /// vanishes.
    std::vector<double> cuts(long m) const
    {
        std::vector<double> E;
        for (const Real& r : ends(m)) E.push_back(static_cast<double>(r));
        const double first = std::ldexp(1, static_cast<int>(1 - m));
        if (E.size() == 2 && m > 1) E.insert(E.begin() + 1, first);
        while (m > 1 && E[1] > 1.3 * first) E.insert(E.begin() + 1, E[1] / 2);
        for (std::size_t i = 1; i + 1 < E.size() && E.size() < most_pieces; ++i)
            if (E[i + 1] > widest * E[i])
                E.insert(E.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                         E[i + 1] < widest * widest * E[i] ? std::sqrt(E[i] * E[i + 1]) : 2 * E[i]);
        const auto distance = [](double Y) { return (1 - Y) * (1 - Y) / (4 * Y); };
        const double room = std::min(distance(static_cast<double>(top(m))), std::sqrt(distance(static_cast<double>(top(m - 1)))));
        while (1 - E[E.size() - 2] > widest * room && E.size() < most_pieces) E.insert(E.end() - 1, (1 + E[E.size() - 2]) / 2);
        if (E.size() >= most_pieces) throw BeyondReach("the law of the load ratio has no certificate there: its pieces would be too many");
        return E;
    }

    std::vector<Piece<Real>> pieces_of(long m) const
    {
        const std::vector<double> E = cuts(m);
        std::vector<Piece<Real>> found;
        for (std::size_t i = 0; i + 1 < E.size(); ++i) {
            const std::function<Real(const Real&)> here = [&](const Real& T) { return density(m, {T, 1 - T}); };
            const double low = E[i], high = E[i + 1];
            found.push_back(i == 0 ? fitted(0, low, high, static_cast<int>(m - 1), here, small_)
                                   : fitted(least_of(low, high), low, high, power_between(low, high, here), here, small_));
        }
        return found;
    }
};

namespace {

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

double value(const Claim& c, const Laws<double>& laws)
{
    const Reading r = reading(c);
    const Place<double> place{nearest(1 - r.rest), nearest(r.rest)};
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
    if (128 + 4 * cancelled > most)
        throw BeyondReach("so near to pressure 0 at a load so near to 1 the law of the load ratio has no certificate");
    return 128 + 4 * cancelled;
}

/// The numbers of the lines of pieces, level 2 first.
template <class Real>
std::vector<std::vector<std::size_t>> write_pieces(const Laws<Real>& laws, long levels, int bits, std::size_t law, Lines& lines)
{
    constexpr double beside_the_error = 0x1p-5;
    std::vector<std::vector<std::size_t>> numbers{{}};
    for (long m = 2; m <= levels; ++m) {
        std::vector<std::size_t> rests_on{law}, here;
        rests_on.insert(rests_on.end(), numbers.back().begin(), numbers.back().end());
        const Rational error = exactly(std::ldexp(static_cast<double>(m - 1), -bits));
        for (const Piece<Real>& whole : laws.pieces(m)) {
            const Piece<Real> p = shortened(whole, std::min(smallest_coefficient, std::ldexp(beside_the_error, -bits)));
            here.push_back(lines.add("piece", rests_on, fmt::format("m={:x} {} error={}{}", m, shape(p), dyadic(error), coefficients(p))));
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
    if (!certainly(less(reading(c).rest, Ball(1))))
        return "at the largest pressure or half-width and beyond the checker needs no certificate";
    return "";
}

void write_distributions(const std::vector<Claim>& claims, long digits, std::size_t first_claim, std::size_t section, std::string& head,
                         Lines& lines)
{
    const WorkingPrecision precision(256);
    const Claim& any = claims.front();
    long levels = 1;
    for (const Claim& c : claims) levels = std::max(levels, reading(c).level);
    const double goal = std::pow(10.0, -static_cast<double>(digits)) / 2;
    constexpr double share = 2; // of the goal, for the levels
    const int bits = static_cast<int>(std::ceil(std::log2(share * static_cast<double>(levels) / goal)));
    const Laws<double> laws(any.G, any.load, levels, smallest_coefficient);
    const std::size_t first = lines.count() + 1;
    const std::size_t law =
        lines.add("law", {}, fmt::format("G={} load={} bits={:x}", named(any.G), any.load.get_str(), interval_bits(claims)));
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
        head += fmt::format("claim {} n={:x} {}={} load={} G={} value={} error={}\n", first_claim + i, c.n,
                            c.of == Claim::Of::segments ? "a" : "p", c.at.get_str(), c.load.get_str(), named(c.G), dyadic(exactly(v)),
                            dyadic(rounded_up(goal * v)));
    }
    head += section_line(section, first, lines.count(), {{"laws", 1}, {"pieces", pieces}, {"readings", claims.size()}});
}

Ball rest_at_level(const Root& G, const Rational& load, long n, const Rational& P)
{
    const Ball root = number(G);
    Ball Y(load);
    for (long m = 0; m < n; ++m) Y = 2 * sqrt(Y) / root;
    return Ball(P) * Ball(P) / (4 * Y);
}

template <class Real>
LawOfLoad<Real>::LawOfLoad(const Root& G, const Rational& load, long levels)
    : G_(G)
    , load_(load)
    , laws_(std::make_shared<const Laws<Real>>(G, load, levels, std::is_same_v<Real, double> ? smallest_coefficient : 0))
{
}

template <class Real>
Real LawOfLoad<Real>::share(long n, const Rational& P) const
{
    const Ball rest = rest_at_level(G_, load_, n, P);
    return laws_->share(n, {rounded<Real>(1 - rest), rounded<Real>(rest)}) / laws_->share(n, {1, 0});
}

template <class Real>
std::vector<std::vector<std::size_t>> LawOfLoad<Real>::write(long levels, int bits, Lines& lines) const
{
    constexpr int bits_of_intervals = 128;
    const std::size_t law = lines.add("law", {}, fmt::format("G={} load={} bits={:x}", named(G_), load_.get_str(), bits_of_intervals));
    auto numbers = write_pieces(*laws_, levels, bits, law, lines);
    for (auto& level : numbers) level.insert(level.begin(), law);
    return numbers;
}

template class LawOfLoad<double>;
template class LawOfLoad<Wide>;

} // namespace touchstone::certificate
