// SPDX-License-Identifier: MIT
#include "touchstone/certificate/limit_quotients.hpp"

#include "touchstone/certificate/full_contact.hpp"
#include "touchstone/certificate/law_pieces.hpp"
#include "touchstone/certificate/poisson.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace touchstone::certificate {
namespace {

using Of = LimitClaim::Of;
constexpr double of_both = 2.1; ///< a quotient is off by what both its parts are, of themselves

/// In p*_n, as the line mesh has it: the half-width of segments.
limit::Question question(const LimitClaim& c)
{
    if (c.of == Of::force) return {limit::Question::Of::force, Ball(c.at)};
    if (c.of != Of::segments) return {limit::Question::Of::pressure, Ball(c.at)};
    Ball s(c.at);
    arb_sin_pi(s.get(), s.get(), WorkingPrecision::bits());
    return {limit::Question::Of::pressure, number(c.G) * s * s};
}

/// A line that says a value, and what is said.
struct Said {
    std::size_t line;
    double value, error;
};

/// Adds lines, and counts those of each reason in the order of docs/certificate.md.
class Section {
public:
    Section(const Root& G, Lines& lines)
        : G_(G)
        , first_(lines.count() + 1)
        , lines_(lines)
    {}

    Said mean(const limit::Question& q, const Rational& p, double goal)
    {
        const WrittenMean w = write_mean(q, p, G_, goal, lines_);
        count(w.lines);
        ++means_;
        return {lines_.add("mean", w.lines, fmt::format("value={} error={}", dyadic(w.value), dyadic(rounded_up(w.error)))), w.value.get_d(), w.error};
    }

    Said portion(const LimitClaim& c, const Rational& p, double goal)
    {
        const WrittenShares w = write_shares({{c.n, c.load, G_}}, {p, 0}, goal, lines_);
        count(w.lines);
        ++portions_;
        const double value = nearest(w.values.front()), error = goal * value;
        return {lines_.add("portion", w.lines, fmt::format("n={:x} load={} value={} error={}", c.n, c.load.get_str(), dyadic_midpoint(w.values.front()), dyadic(rounded_up(error)))),
                value, error};
    }

    void quotient(const std::vector<Said>& of, std::size_t claim)
    {
        std::vector<std::size_t> rests_on;
        for (const Said& s : of) rests_on.push_back(s.line);
        lines_.add("quotient", rests_on, fmt::format("claim={}", claim));
        ++quotients_;
    }

    std::string head(std::size_t number) const
    {
        return section_line(number, first_, lines_.count(),
                            {{"meshes", meshes_}, {"polynomials", polynomials_}, {"means", means_}, {"portions", portions_}, {"quotients", quotients_}});
    }

private:
    void count(const std::vector<std::size_t>& mesh)
    {
        ++meshes_;
        polynomials_ += mesh.size() - 1;
    }
    const Root& G_;
    std::size_t first_, meshes_ = 0, polynomials_ = 0, means_ = 0, portions_ = 0, quotients_ = 0;
    Lines& lines_;
};

/// How far the distance is from 0, about.
double size_of_distance(const LimitClaim& c)
{
    constexpr double coarse = 1e-5;
    Lines unused;
    Section s(c.G, unused);
    const double here = s.portion(c, c.at, coarse).value / s.portion(c, 0, coarse).value;
    const double there = s.mean(question(c), c.at, coarse).value / s.mean({}, 0, coarse).value;
    const double distance = std::fabs(here - there);
    constexpr double of_use = 100;
    if (!(distance > of_use * coarse)) throw BeyondReach(fmt::format("distances below {:g} have no certificate where G < 2.05", of_use * coarse));
    return distance;
}

std::string inputs(const LimitClaim& c)
{
    if (c.of == Of::distance) return fmt::format("n={:x} p={} load={}", c.n, c.at.get_str(), c.load.get_str());
    return fmt::format("{}={}", c.of == Of::segments ? "a" : "p", c.at.get_str());
}

} // namespace

std::string refusal_of_quotient(const LimitClaim& c)
{
    if (c.of == Of::density) return "the limit's density has certificates where G >= 2.05";
    if (power(Rational(51, 50), static_cast<long>(c.G.degree)) > c.G.base) return "G < 1.02: certificates are made where G >= 1.02";
    if (c.at <= 0) return "at 0 the checker needs no certificate";
    if (c.of == Of::segments && 2 * c.at > 1) return "no segment is wider than a wave: the checker needs no certificate";
    if (c.of == Of::force && 1024 * c.at < 1) return "the force has certificates from the pressure 1/1024 on where G < 2.05";
    if (c.of == Of::distance && (c.n < 1 || c.n > largest_n)) return fmt::format("n = {}: certificates are made of 1 <= n <= {}", c.n, largest_n);
    if (c.of == Of::distance && (c.load < Rational(1, 1 << 20) || c.load > highest_load))
        return fmt::format("distances from the limit have certificates where 2^-20 <= load <= {}", highest_load);
    return "";
}

void write_quotients(const std::vector<LimitClaim>& claims, long digits, std::size_t first_claim, std::size_t section, std::string& head, Lines& lines)
{
    const WorkingPrecision precision(256);
    const Of of = claims.front().of;
    double goal = std::pow(10.0, -static_cast<double>(digits)) / 2, least = 1;
    if (of == Of::distance)
        for (const LimitClaim& c : claims) least = std::min(least, size_of_distance(c));
    const double each = of == Of::distance ? goal * least / (2 * of_both) : goal / of_both;
    Section s(claims.front().G, lines);
    std::optional<Said> contact;
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const LimitClaim& c = claims[i];
        std::vector<Said> parts;
        if (of == Of::distance) parts = {s.portion(c, c.at, each), s.portion(c, 0, each)};
        parts.push_back(s.mean(question(c), c.at, of == Of::force ? goal : each));
        double value = parts.back().value;
        if (of != Of::force) {
            if (!contact) contact = s.mean({}, 0, each);
            parts.push_back(*contact);
            value /= contact->value;
        }
        if (of == Of::distance) value = parts[0].value / parts[1].value - value;
        s.quotient(parts, first_claim + i);
        head += fmt::format("claim {} {} G={} value={} error={}\n", first_claim + i, inputs(c), named(c.G), dyadic(exactly(value)),
                            dyadic(rounded_up(narrow * goal * (of == Of::distance ? least : value))));
    }
    head += s.head(section);
}

} // namespace touchstone::certificate
