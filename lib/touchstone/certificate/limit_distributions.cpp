// SPDX-License-Identifier: MIT
#include "touchstone/certificate/limit_distributions.hpp"

#include "touchstone/certificate/contact.hpp"
#include "touchstone/certificate/distributions.hpp"
#include "touchstone/certificate/law_pieces.hpp"
#include "touchstone/certificate/limit_quotients.hpp"
#include "touchstone/certificate/text.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace touchstone::certificate {
namespace {

/// What is left of the law begun with falls by about 1/2 each, and weighs twice as much on each part below another.
constexpr int waves = 60;
constexpr int interval_bits = 128;

/// The law that one wave leaves as it is, 0 below its first piece, as if the force were 1.
template <class Real>
class LimitLaw {
public:
    LimitLaw(const Root& G, int halvings, double small)
        : G_(rounded<Real>(number(G)))
        , Y_(4 / (G_ * G_))
        , small_(small)
    {
        if constexpr (std::is_same_v<Real, double>) {
            cuts_ = cuts(halvings);
            for (std::size_t i = 0; i + 1 < cuts_.size(); ++i)
                pieces_.push_back(between(i, [&](double T) { return std::pow(T, halvings / 2.0); }));
            follow(waves + 2 * halvings);
        } else { // binary64 has most of it at little cost
            const LimitLaw<double> start(G, halvings, smallest_coefficient);
            cuts_ = start.cuts_;
            for (const Piece<double>& p : start.pieces_)
                pieces_.push_back({p.low, p.high, p.centre, p.radius, p.power, {p.coefficients.begin(), p.coefficients.end()}});
            follow(waves / 2 + halvings);
        }
    }
    const std::vector<Piece<Real>>& pieces() const { return pieces_; }
    /// What one wave makes of it.
    Real density(const Place<Real>& at) const { return G_ * G_ * G_ / pi_number<Real>() * root(Y_ * at.T) * over(at, Read::density); }
    Real read(const Place<Real>& at, Read what) const { return 2 * Y_ * at.T * over(at, what); }

private:
    template <class>
    friend class LimitLaw;

    Real G_, Y_;
    double small_;
    std::vector<double> cuts_;
    std::vector<Piece<Real>> pieces_;

    void follow(int many)
    {
        for (int k = 0; k < many; ++k) {
            std::vector<Piece<Real>> next;
            for (std::size_t i = 0; i + 1 < cuts_.size(); ++i)
                next.push_back(between(i, [&](const Real& T) { return density({T, 1 - T}); }));
            pieces_ = std::move(next);
            const Real force = read({1, 0}, Read::force);
            for (Piece<Real>& p : pieces_)
                for (Real& c : p.coefficients) c /= force;
        }
    }

    Piece<Real> between(std::size_t i, const std::function<Real(const Real&)>& density) const
    {
        const double low = cuts_[i], high = cuts_[i + 1];
        return fitted(i == 0 ? low : least_of(low, high), low, high, power_between(low, high, density), density, small_);
    }

    Real over(const Place<Real>& place, Read read) const
    {
        std::vector<Real> r;
        for (const double T : cuts_) r.push_back(ratio_cut(Real(T)));
        const auto phi = [&](const Place<Real>& p) {
            return (*std::find_if(pieces_.begin(), pieces_.end() - 1, [&](const Piece<Real>& q) { return p.T <= q.high; }))(p.T);
        };
        return over_pieces<Real>(Y_, r, phi, place, read);
    }

    /// From 2^-halvings on, each twice the one before, or less next to where the law begins, and towards T = 1, next to which R vanishes
    /// where G is next to 2.
    std::vector<double> cuts(int halvings) const
    {
        std::vector<double> E;
        for (int k = halvings; k >= 0; --k) {
            E.push_back(std::ldexp(1, -k));
            if (halvings - k < 2) E.push_back(std::ldexp(1.5, -k));
        }
        const double room = static_cast<double>((1 - Y_) * (1 - Y_) / (4 * Y_));
        while (1 - E[E.size() - 2] > widest * std::min(room, std::sqrt(room)) && E.size() < most_pieces)
            E.insert(E.end() - 1, (1 + E[E.size() - 2]) / 2);
        if (E.size() >= most_pieces) throw BeyondReach("the law of the load ratio has no certificate there: its pieces would be too many");
        return E;
    }
};

/// 1 - T where a claim is read.
Ball rest_at(const LimitClaim& c)
{
    const Ball G = number(c.G);
    if (c.of == LimitClaim::Of::force) return Ball(c.at) * G / 4;
    Ball P(c.at);
    if (c.of == LimitClaim::Of::segments) {
        arb_sin_pi(P.get(), P.get(), WorkingPrecision::bits());
        P = G * P * P;
    }
    return P * P * G * G / 16;
}

template <class Real>
Real value(const LimitClaim& c, const LimitLaw<Real>& law)
{
    const Ball rest = rest_at(c);
    const Place<Real> place{rounded<Real>(1 - rest), rounded<Real>(rest)};
    if (c.of == LimitClaim::Of::force) return law.read(place, Read::force) / law.read({1, 0}, Read::force);
    const Real area = law.read({1, 0}, Read::share);
    if (c.of == LimitClaim::Of::density) return rounded<Real>(c.at) / half_power(rounded<Real>(number(c.G)), 6) * law.density(place) / area;
    return law.read(place, Read::share) / area;
}

std::string_view quantity(LimitClaim::Of of)
{
    switch (of) {
    case LimitClaim::Of::exceedance: return "limit.exceedance";
    case LimitClaim::Of::force: return "limit.force";
    case LimitClaim::Of::density: return "limit.density";
    case LimitClaim::Of::segments: return "limit.segments";
    default: return "limit.distance";
    }
}

std::vector<std::size_t> joined(std::vector<std::size_t> all, const std::vector<std::size_t>& more)
{
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// |G W V - V| <= error V: what a claim is off is some hundred times that.
Rational balance_error(long digits)
{
    constexpr int more_bits = 8;
    return exactly(std::ldexp(1, -static_cast<int>(std::ceil(static_cast<double>(digits) * std::log2(10.0))) - more_bits));
}

/// From 2^-halvings on there is a law: it weighs some 2^-(k^2/4) below 2^-k.
int halvings_for(long digits) { return static_cast<int>(std::ceil(2 * std::sqrt(-std::log2(balance_error(digits).get_d()) + 3))); }

struct Written {
    std::size_t law;
    std::vector<std::size_t> parts, balances;

    std::vector<std::size_t> all() const { return joined(joined({law}, parts), balances); }
};

/// Of the first coefficient of a part.
double smallest_for(long digits)
{
    constexpr double beside_the_error = 0x1p-5;
    return beside_the_error * balance_error(digits).get_d();
}

template <class Real>
Written write_law(const LimitLaw<Real>& law, const Root& G, long digits, Lines& lines)
{
    Written w{lines.add("steady", {}, fmt::format("G={} bits={:x}", named(G), interval_bits)), {}, {}};
    for (const Piece<Real>& whole : law.pieces()) {
        const Piece<Real> p = shortened(whole, smallest_for(digits));
        w.parts.push_back(lines.add("part", {w.law}, shape(p) + coefficients(p)));
    }
    for (std::size_t i = 0; i < w.parts.size(); ++i)
        w.balances.push_back(
            lines.add("balance", joined({w.law}, w.parts), fmt::format("part={} error={}", i, dyadic(balance_error(digits)))));
    return w;
}

/// What a section says of one claim.
struct Found {
    LimitClaim claim;
    Rational value;
    double error;
    std::vector<std::size_t> rests_on;
};

/// A law in these numbers is known to so many digits, and distances from it so well.
template <class Real>
constexpr long digits_known = std::is_same_v<Real, double> ? most_digits_of_limit_distributions : 17;
template <class Real>
constexpr double distances_known_to = std::is_same_v<Real, double> ? 1.6e-11 : 1.6e-17;

template <class Real>
LimitLaw<Real> law_for(const std::vector<LimitClaim>& claims, long digits)
{
    int halvings = halvings_for(digits);
    constexpr int above_the_first_piece = 6; // what lies below it would count next to the largest pressure
    for (const LimitClaim& c : claims) halvings = std::max(halvings, above_the_first_piece - std::ilogb(nearest(1 - rest_at(c))));
    return {claims.front().G, halvings, smallest_for(digits)};
}

/// Appends the law of the limit, and the claims that rest on it.
Written write_limits(const std::vector<LimitClaim>& claims, long digits, double accuracy, std::vector<Found>& all, Lines& lines)
{
    const auto law = law_for<double>(claims, digits);
    const Written w = write_law(law, claims.front().G, digits, lines);
    for (const LimitClaim& c : claims) {
        const double v = value(c, law);
        if (!(v > std::numeric_limits<double>::min())) throw BeyondReach("what is below the numbers of binary64 has no certificate");
        all.push_back({c, exactly(v), accuracy * v, w.all()});
    }
    return w;
}

/// Two laws, of the limit and of a load, and how far what is read off one is from what is read off the other.
template <class Real>
struct Distances {
    LimitLaw<Real> limit;
    LawOfLoad<Real> of_load;
    std::vector<Real> values;

    explicit Distances(const std::vector<LimitClaim>& claims)
        : limit(law_for<Real>(claims, digits_known<Real>)), of_load(claims.front().G, claims.front().load, last_level(claims))
    {
        for (const LimitClaim& c : claims) values.push_back(of_load.share(c.n, c.at) - value(c, limit));
    }
    /// The least error that a claim has, where each is to be known to `accuracy` of itself.
    double least_error(double accuracy) const
    {
        double least = 1;
        for (const Real& v : values) least = std::min(least, accuracy * std::fabs(static_cast<double>(v)));
        return least;
    }

private:
    static long last_level(const std::vector<LimitClaim>& claims)
    {
        long n = 1;
        for (const LimitClaim& c : claims) n = std::max(n, c.n);
        return n;
    }
};

/// How well the two laws are to be proved for distances to be within `error`: each may have about a quarter of it.
struct Aim {
    long digits;
    int level_bits;
};
Aim aim_for(double error, long levels)
{
    constexpr double parts = 4, both_shares = 2;
    return {static_cast<long>(std::ceil(-std::log10(error / 2))),
            static_cast<int>(std::ceil(std::log2(parts * both_shares * static_cast<double>(levels) / error)))};
}

/// Appends both laws, and the claims that rest on them, each at least a hundred times its error.
/// \param pieces how many the law of the load has
template <class Real>
Written write_distances(const std::vector<LimitClaim>& claims, const Distances<Real>& found, double accuracy, std::vector<Found>& all,
                        std::size_t& pieces, Lines& lines)
{
    constexpr double known_to = distances_known_to<Real>, of_use = 100;
    long levels = 0;
    double least_error = 1;
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const double size = std::fabs(static_cast<double>(found.values[i]));
        if (size < of_use * known_to) continue;
        all.push_back({claims[i], exactly(found.values[i]), std::max(accuracy * size, known_to), {}});
        levels = std::max(levels, claims[i].n);
        least_error = std::min(least_error, all.back().error);
    }
    if (all.empty()) throw BeyondReach("distances below 2 10^-15 have no certificate");
    constexpr Aim in_binary64{digits_known<double>, 42};
    const Aim aim = std::is_same_v<Real, double> ? in_binary64 : aim_for(least_error, levels);
    const Written w = write_law(found.limit, claims.front().G, aim.digits, lines);
    const std::size_t before = lines.count();
    const auto numbers = found.of_load.write(levels, aim.level_bits, lines);
    pieces = lines.count() - before - 1;
    for (Found& f : all) f.rests_on = joined(w.all(), numbers[static_cast<std::size_t>(f.claim.n - 1)]);
    return w;
}

std::string named_inputs(const LimitClaim& c)
{
    if (c.of == LimitClaim::Of::distance) return fmt::format("n={:x} p={} load={}", c.n, c.at.get_str(), c.load.get_str());
    return fmt::format("{}={}", c.of == LimitClaim::Of::segments ? "a" : "p", c.at.get_str());
}

/// \returns how many claims there are
std::size_t write_section(const std::vector<LimitClaim>& claims, long digits, std::size_t first_claim, std::size_t section,
                          std::string& head, Lines& lines)
{
    const bool distances = claims.front().of == LimitClaim::Of::distance;
    const double accuracy = std::pow(10.0, -static_cast<double>(digits)) / 2;
    const std::size_t first = lines.count() + 1;
    std::size_t number = first_claim, pieces = 0;
    std::vector<Found> all;
    const Written w = [&] {
        if (!distances) return write_limits(claims, digits, accuracy, all, lines);
        const Distances<double> found(claims);
        if (found.least_error(accuracy) >= distances_known_to<double>) return write_distances(claims, found, accuracy, all, pieces, lines);
        return write_distances(claims, Distances<Wide>(claims), accuracy, all, pieces, lines);
    }();
    for (const Found& f : all) {
        lines.add("tending", f.rests_on, fmt::format("claim={}", number));
        head += fmt::format("claim {} {} G={} value={} error={}\n", number++, named_inputs(f.claim), named(f.claim.G), dyadic(f.value),
                            dyadic(rounded_up(f.error)));
    }
    head += section_line(section, first, lines.count(),
                         {{"laws", distances ? 1 : 0},
                          {"pieces", pieces},
                          {"steadies", 1},
                          {"parts", w.parts.size()},
                          {"balances", w.balances.size()},
                          {"tendings", number - first_claim}});
    return number - first_claim;
}

/// With full contact in the limit a law has singular points inside, and means are found without it.
bool is_partial(const Root& G) { return power(Rational(41, 20), static_cast<long>(G.degree)) <= G.base; }

} // namespace

std::string refusal_of_limit_distribution(const LimitClaim& c)
{
    const WorkingPrecision precision(256);
    if (!is_partial(c.G)) return refusal_of_quotient(c);
    if (power(Rational(1 << 20), static_cast<long>(c.G.degree)) < c.G.base) return "G > 2^20: certificates are made where G <= 2^20";
    if (c.at <= 0) return "at 0 the checker needs no certificate";
    const bool wider = c.of == LimitClaim::Of::segments && 2 * c.at >= 1;
    if (c.of == LimitClaim::Of::distance) {
        if (c.n < 1 || c.n > largest_n) return fmt::format("n = {}: certificates are made of 1 <= n <= {}", c.n, largest_n);
        if (c.load < Rational(1, 1 << 20) || c.load > Rational(99, 100))
            return "distances from the limit have certificates where 2^-20 <= load <= 0.99";
        if (!certainly(less(rest_at_level(c.G, c.load, c.n, c.at), Ball(1))))
            return "beyond the largest pressure of scale n the distance is a share of the limit";
    }
    if (wider || !certainly(less(rest_at(c), Ball(1))))
        return "at the largest pressure or half-width and beyond the checker needs no certificate";
    return "";
}

std::string limit_distributions(const std::vector<LimitClaim>& all, Accuracy wanted)
{
    const WorkingPrecision precision(256);
    const auto sections = grouped(all, [](const LimitClaim& a, const LimitClaim& b) { return is_same(a.G, b.G) && a.load == b.load; });
    std::string head;
    Lines lines;
    std::size_t claims = 0, written = 0;
    for (const auto& members : sections) {
        if (is_partial(members.front().G)) {
            claims +=
                write_section(members, std::min(wanted.digits, most_digits_of_limit_distributions), claims + 1, ++written, head, lines);
        }
        else {
            write_quotients(members, std::min(wanted.digits, most_digits_of_quotients), claims + 1, ++written, head, lines);
            claims += members.size();
        }
    }
    return certificate_text(std::string(quantity(all.front().of)), claims, written, head, lines);
}

} // namespace touchstone::certificate
