// SPDX-License-Identifier: MIT
#include "touchstone/certificate/limit_quotients.hpp"

#include "touchstone/certificate/law_pieces.hpp"
#include "touchstone/certificate/poisson.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

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
    if (c.of == Of::density) return {limit::Question::Of::density, Ball(c.at)};
    if (c.of != Of::segments) return {limit::Question::Of::pressure, Ball(c.at)};
    Ball s(c.at);
    arb_sin_pi(s.get(), s.get(), WorkingPrecision::bits());
    return {limit::Question::Of::pressure, number(c.G) * s * s};
}

/// A line that says a value, and what is said.
struct Said {
    std::size_t line;
    double value;
};

} // namespace

std::string refusal_of_quotient(const LimitClaim& c)
{
    if (c.of == Of::distance)
        return "where G < 2.05 contact.exceedance, contact.area and limit.exceedance have certificates: checker/check.py makes a distance of them";
    if (power(Rational(51, 50), static_cast<long>(c.G.degree)) > c.G.base) return "G < 1.02: certificates are made where G >= 1.02";
    if (c.of == Of::density && 512 * c.at < 1) return "the density has certificates from the pressure 1/512 on where G < 2.05";
    if (c.at <= 0) return "at 0 the checker needs no certificate";
    if (c.of == Of::segments && 2 * c.at > 1) return "no segment is wider than a wave: the checker needs no certificate";
    if (c.of == Of::force && 1024 * c.at < 1) return "the force has certificates from the pressure 1/1024 on where G < 2.05";
    return "";
}

void write_quotients(const std::vector<LimitClaim>& claims, long digits, std::size_t first_claim, std::size_t section, std::string& head,
                     Lines& lines)
{
    const WorkingPrecision precision(256);
    const Of of = claims.front().of;
    const double goal = std::pow(10.0, -static_cast<double>(digits)) / 2, each = of == Of::force ? goal : goal / of_both;
    const Root& G = claims.front().G;
    const std::size_t first = lines.count() + 1;
    std::size_t means = 0, polynomials = 0;
    const auto mean = [&](const limit::Question& q, const Rational& p) -> Said {
        const WrittenMean w = write_mean(q, p, G, each, lines);
        ++means;
        polynomials += w.lines.size() - 1;
        return {lines.add("mean", w.lines, fmt::format("value={} error={}", dyadic(w.value), dyadic(rounded_up(w.error)))),
                w.value.get_d()};
    };
    std::optional<Said> contact;
    if (of != Of::force) contact = mean({}, 0);
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const LimitClaim& c = claims[i];
        const Said above = mean(question(c), c.at);
        const double value = contact ? above.value / contact->value : above.value;
        const std::vector<std::size_t> rests_on = contact ? std::vector{contact->line, above.line} : std::vector{above.line};
        lines.add("quotient", rests_on, fmt::format("claim={}", first_claim + i));
        head += fmt::format("claim {} {}={} G={} value={} error={}\n", first_claim + i, of == Of::segments ? "a" : "p", c.at.get_str(),
                            named(G), dyadic(exactly(value)), dyadic(rounded_up(narrow * goal * value)));
    }
    head += section_line(section, first, lines.count(),
                         {{"meshes", means}, {"polynomials", polynomials}, {"means", means}, {"quotients", claims.size()}});
}

} // namespace touchstone::certificate
