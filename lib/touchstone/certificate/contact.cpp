// SPDX-License-Identifier: MIT
#include "touchstone/certificate/contact.hpp"

#include "touchstone/certificate/distributions.hpp"
#include "touchstone/certificate/full_contact.hpp"
#include "touchstone/certificate/written_levels.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace touchstone::certificate {
namespace {

struct Value {
    Ball area;    ///< its midpoint is what is claimed
    double error; ///< relative
};

/// All that a section says: found first, written when it is accurate enough.
struct Section {
    Grid grid;
    std::vector<Level> levels;
    std::vector<Value> values;
    double worst = 0;
};

Section find(const std::vector<Claim>& areas, const Root& G, double digits)
{
    long n = 0;
    Rational least(1), largest(0);
    for (const Claim& a : areas) n = std::max(n, a.n), least = std::min(least, a.load), largest = std::max(largest, a.load);
    Section s{grid_for(G, n, digits, least, largest), {}, {}, 0};
    const DiscreteOperator T(s.grid);
    s.levels = T.levels(n);
    std::map<Rational, Row> rows;
    for (const Claim& a : areas) {
        if (!rows.contains(a.load)) rows.emplace(a.load, T.row_at(a.load));
        const Applied h = T.apply(rows.at(a.load), s.levels[static_cast<std::size_t>(a.n - 1)]);
        const WorkingPrecision precision(s.grid.bits + 64);
        Value v{Ball(a.load) * h.value / pow(s.grid.G(), Ball(a.n)), 0};
        v.error = narrow * h.error / arf_get_d(arb_midref(h.value.get()), ARF_RND_DOWN);
        s.worst = std::max(s.worst, v.error);
        s.values.push_back(std::move(v));
    }
    return s;
}

/// The first that is accurate enough.
Section accurate(const std::vector<Claim>& areas, double digits)
{
    const double goal = std::pow(10.0, -digits) / 2;
    Section s = find(areas, areas.front().G, digits);
    for (int attempt = 0; s.worst > goal; ++attempt) {
        if (attempt == 2) throw BeyondReach(fmt::format("the certificate's errors do not come below {:.1e}", goal));
        digits += std::log10(s.worst / goal) + 1;
        s = find(areas, areas.front().G, digits);
    }
    return s;
}

void write(const Section& s, const std::vector<Claim>& areas, std::size_t first_claim, std::string& head, Lines& lines, std::size_t number)
{
    const WrittenSection written = write_levels(s.grid, s.levels, lines);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        std::vector<std::size_t> rests_on{written.grid};
        const auto& below = written.levels[static_cast<std::size_t>(areas[i].n - 1)];
        rests_on.insert(rests_on.end(), below.begin(), below.end());
        lines.add("value", rests_on, fmt::format("claim={}", first_claim + i));
        const Ball& area = s.values[i].area;
        const double error = s.values[i].error * arf_get_d(arb_midref(area.get()), ARF_RND_UP) + area.radius_bound();
        head += fmt::format("claim {} n={:x} load={} G={} value={} error={}\n", first_claim + i, areas[i].n, areas[i].load.get_str(),
                            named(areas[i].G), dyadic_midpoint(area), dyadic(rounded_up(narrow * error)));
    }
    Counts counts = written.counts();
    counts.emplace_back("values", areas.size());
    head += section_line(number, written.grid, lines.count(), counts);
}

} // namespace

std::string refusal(const Claim& a)
{
    if (a.n < 1) return "n = 0 is of closed form: the checker needs no certificate";
    if (a.n > largest_n) return fmt::format("n = {}: certificates are made up to n = {}", a.n, largest_n);
    if (a.load > highest_load) return fmt::format("load > {}: certificates are made up to there", highest_load);
    Rational least(1);
    mpz_mul_2exp(least.get_den_mpz_t(), least.get_den_mpz_t(), 40);
    if (a.load < least) return "load < 2^-40: certificates are made of loads from there on";
    if (power(Rational(51, 50), static_cast<long>(a.G.degree)) > a.G.base) return "G < 1.02: certificates are made where G >= 1.02";
    if (power(Rational(1 << 20), static_cast<long>(a.G.degree)) < a.G.base) return "G > 2^20: certificates are made where G <= 2^20";
    const bool density = a.of == Claim::Of::density || a.of == Claim::Of::segments;
    if (a.of == Claim::Of::segments && !only_partial(a)) return "segments have certificates in partial contact: G >= 2.05 and load <= 1";
    if (density && !only_partial(a)) {
        if (a.n == 1) return "n = 1 needs none with full contact: the checker finds it itself";
        return a.at > 0 ? "" : "a pressure of 0 is exact";
    }
    if (density && !law_serves(a)) return "densities beyond scale 1 have certificates at loads up to 1 - 10^-6";
    return a.of == Claim::Of::area || !only_partial(a) ? "" : exact_end(a);
}

bool only_partial(const Claim& a) { return a.load <= 1 && power(Rational(41, 20), static_cast<long>(a.G.degree)) <= a.G.base; }

namespace {

long most_digits_on_a_mesh(const Claim& a)
{
    return a.of == Claim::Of::density ? most_digits_of_distributions : most_digits_in_full_contact;
}

enum class Route { levels, law, mesh };

Route route(const Claim& a)
{
    if (!only_partial(a)) return Route::mesh;
    if (a.of == Claim::Of::area) return Route::levels;
    return law_serves(a) ? Route::law : Route::mesh;
}

/// What one section serves: levels any load and n, a law any n and place, a mesh of areas any load and n, one of shares any load, one of
/// densities its own.
bool in_one_section(const Claim& a, const Claim& b)
{
    const Route r = route(a);
    if (b.G.base != a.G.base || b.G.degree != a.G.degree || r != route(b)) return false;
    if (r == Route::law) return a.load == b.load;
    return r == Route::levels || (a.at == b.at && (a.at == 0 || a.n == b.n) && (a.of != Claim::Of::density || a.load == b.load));
}

std::string_view quantity(Claim::Of of)
{
    switch (of) {
    case Claim::Of::share: return "contact.exceedance";
    case Claim::Of::density: return "contact.density";
    case Claim::Of::segments: return "segments.density";
    default: return "contact.area";
    }
}

} // namespace

std::string contact(const std::vector<Claim>& all, Accuracy wanted)
{
    const auto sections = grouped(all, in_one_section);
    std::string head;
    Lines lines;
    std::size_t claims = 0, written = 0;
    for (const auto& members : sections) {
        try {
            switch (route(members.front())) {
            case Route::levels:
                write(accurate(members, static_cast<double>(wanted.digits)), members, claims + 1, head, lines, written + 1);
                break;
            case Route::law:
                write_distributions(members, std::min(wanted.digits, most_digits_of_distributions), claims + 1, written + 1, head, lines);
                break;
            case Route::mesh:
                write_full_contact(members, std::min(wanted.digits, most_digits_on_a_mesh(members.front())), claims + 1, written + 1, head,
                                   lines);
                break;
            }
        }
        catch (const BeyondReach&) {
            if (members.size() == all.size()) throw;
            continue;
        }
        ++written;
        claims += members.size();
    }
    if (claims == 0) throw BeyondReach("no certificate reaches these digits");
    return certificate_text(std::string(quantity(all.front().of)), claims, written, head, lines);
}

} // namespace touchstone::certificate
