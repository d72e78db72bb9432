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
#include <numbers>
#include <string_view>

namespace touchstone::certificate {
namespace {

constexpr int waves = 60; ///< what is left of the law begun with falls by about 1/2 each, and weighs twice as much on each part below another
constexpr int interval_bits = 128;

/// The law that one wave leaves as it is, 0 below its first piece, as if the force were 1.
class LimitLaw {
public:
    LimitLaw(double G, int halvings, double small)
        : G_(G)
        , Y_(4 / (G * G))
        , small_(small)
        , cuts_(cuts(halvings))
    {
        for (std::size_t i = 0; i + 1 < cuts_.size(); ++i)
            pieces_.push_back(between(i, [&](double T) { return std::pow(T, halvings / 2.0); }));
        for (int k = 0; k < waves + 2 * halvings; ++k) {
            std::vector<Piece> next;
            for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) next.push_back(between(i, [&](double T) { return density({T, 1 - T}); }));
            pieces_ = std::move(next);
            const double force = read({1, 0}, Read::force);
            for (Piece& p : pieces_)
                for (double& c : p.coefficients) c /= force;
        }
    }
    const std::vector<Piece>& pieces() const { return pieces_; }
    /// What one wave makes of it.
    double density(Place at) const { return G_ * G_ * G_ / std::numbers::pi * std::sqrt(Y_ * at.T) * over(at, Read::density); }
    double read(Place at, Read what) const { return 2 * Y_ * at.T * over(at, what); }

private:
    double G_, Y_, small_;
    std::vector<double> cuts_;
    std::vector<Piece> pieces_;

    template <class F>
    Piece between(std::size_t i, F&& density) const
    {
        const double low = cuts_[i], high = cuts_[i + 1];
        return fitted(i == 0 ? low : least_of(low, high), low, high, power_between(low, high, density), density, small_);
    }

    double over(Place place, Read read) const
    {
        std::vector<double> r;
        for (const double T : cuts_) r.push_back(ratio_cut(T));
        const auto phi = [&](Place p) {
            return (*std::find_if(pieces_.begin(), pieces_.end() - 1, [&](const Piece& q) { return p.T <= q.high; }))(p.T);
        };
        return over_pieces(Y_, r, phi, place, read);
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
        const double room = (1 - Y_) * (1 - Y_) / (4 * Y_);
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

double value(const LimitClaim& c, const LimitLaw& law)
{
    const Ball rest = rest_at(c);
    const Place place{nearest(1 - rest), nearest(rest)};
    if (c.of == LimitClaim::Of::force) return law.read(place, Read::force) / law.read({1, 0}, Read::force);
    const double area = law.read({1, 0}, Read::share);
    if (c.of == LimitClaim::Of::density) return c.at.get_d() / std::pow(nearest(number(c.G)), 3) * law.density(place) / area;
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

std::vector<std::size_t> joined(std::size_t first, const std::vector<std::size_t>& more, const std::vector<std::size_t>& most = {})
{
    std::vector<std::size_t> all{first};
    all.insert(all.end(), more.begin(), more.end());
    all.insert(all.end(), most.begin(), most.end());
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
};

Written write_law(const LimitLaw& law, const Root& G, long digits, Lines& lines)
{
    Written w{lines.add("steady", {}, fmt::format("G={} bits={:x}", named(G), interval_bits)), {}, {}};
    for (const Piece& p : law.pieces()) w.parts.push_back(lines.add("part", {w.law}, shape(p) + coefficients(p)));
    for (std::size_t i = 0; i < w.parts.size(); ++i)
        w.balances.push_back(
            lines.add("balance", joined(w.law, w.parts), fmt::format("part={} error={}", i, dyadic(balance_error(digits)))));
    return w;
}

/// What a section says of one claim.
struct Found {
    double value, error;
    std::vector<std::size_t> rests_on;
};

LimitLaw law_for(const std::vector<LimitClaim>& claims, long digits)
{
    int halvings = halvings_for(digits);
    constexpr int above_the_first_piece = 6; // what lies below it would count next to the largest pressure
    for (const LimitClaim& c : claims) halvings = std::max(halvings, above_the_first_piece - std::ilogb(nearest(1 - rest_at(c))));
    constexpr double beside_the_error = 0x1p-5;
    return {nearest(number(claims.front().G)), halvings, beside_the_error * balance_error(digits).get_d()};
}

/// Those of the section that have a certificate, each with its claim; and how many pieces of the law of a load there are.
std::vector<std::pair<LimitClaim, Found>> find(const std::vector<LimitClaim>& claims, const LimitLaw& law, const Written& w,
                                               double accuracy, std::size_t& pieces, Lines& lines)
{
    std::vector<std::pair<LimitClaim, Found>> all;
    if (claims.front().of != LimitClaim::Of::distance) {
        for (const LimitClaim& c : claims) {
            const double v = value(c, law);
            if (!(v > std::numeric_limits<double>::min())) throw BeyondReach("what is below the numbers of binary64 has no certificate");
            all.push_back({c, {v, accuracy * v, joined(w.law, w.parts, w.balances)}});
        }
        return all;
    }
    constexpr int level_bits = 42; // the pieces are in binary64
    constexpr double known_to = 1.6e-11, of_use = 100;
    std::vector<std::pair<long, Rational>> places;
    for (const LimitClaim& c : claims) places.emplace_back(c.n, c.at);
    const std::vector<double> shares = level_shares(claims.front().G, claims.front().load, places);
    long levels = 0;
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const double v = shares[i] - value(claims[i], law);
        if (std::fabs(v) < of_use * known_to) continue;
        all.push_back({claims[i], {v, std::max(accuracy * std::fabs(v), known_to), joined(w.law, w.parts, w.balances)}});
        levels = std::max(levels, claims[i].n);
    }
    if (all.empty()) throw BeyondReach("distances below 2 10^-9 have no certificate");
    const std::size_t before = lines.count();
    const auto numbers = write_law_of_load(claims.front().G, claims.front().load, levels, level_bits, lines);
    pieces = lines.count() - before - 1;
    for (auto& [c, found] : all) {
        const auto& level = numbers[static_cast<std::size_t>(c.n - 1)];
        found.rests_on.insert(found.rests_on.end(), level.begin(), level.end());
    }
    return all;
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
    const long of_the_law = distances ? most_digits_of_limit_distributions : digits;
    const LimitLaw law = law_for(claims, of_the_law);
    const std::size_t first = lines.count() + 1;
    const Written w = write_law(law, claims.front().G, of_the_law, lines);
    std::size_t number = first_claim, pieces = 0;
    for (const auto& [c, found] : find(claims, law, w, std::pow(10.0, -static_cast<double>(digits)) / 2, pieces, lines)) {
        lines.add("tending", found.rests_on, fmt::format("claim={}", number));
        head += fmt::format("claim {} {} G={} value={} error={}\n", number++, named_inputs(c), named(c.G), dyadic(exactly(found.value)),
                            dyadic(rounded_up(found.error)));
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
            claims += write_section(members, std::min(wanted.digits, most_digits_of_limit_distributions), claims + 1, ++written, head, lines);
        }
        else {
            write_quotients(members, std::min(wanted.digits, most_digits_of_quotients), claims + 1, ++written, head, lines);
            claims += members.size();
        }
    }
    return certificate_text(std::string(quantity(all.front().of)), claims, written, head, lines);
}

} // namespace touchstone::certificate
