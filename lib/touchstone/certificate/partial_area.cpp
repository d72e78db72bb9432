// SPDX-License-Identifier: MIT
#include "touchstone/certificate/partial_area.hpp"

#include "touchstone/certificate/discrete_operator.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/table/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace touchstone::certificate {
namespace {

constexpr double narrow = 1.01; ///< bounds are found in binary64 and written down so much larger

std::string hex(const mpz_class& n) { return n.get_str(16); }

/// mantissa:exponent, the mantissa odd
std::string dyadic(mpz_class m, long e)
{
    if (m == 0) return "0:0";
    const auto zeros = static_cast<long>(mpz_scan1(m.get_mpz_t(), 0));
    return fmt::format("{}:{}", hex(m >> static_cast<unsigned long>(zeros)), e + zeros);
}

std::string dyadic(const Rational& r) // of a power of two below
{
    return dyadic(r.get_num(), -static_cast<long>(mpz_sizeinbase(r.get_den_mpz_t(), 2) - 1));
}

constexpr int bound_bits = 12;
/// A bound of few bits, not below x.
Rational rounded_up(double x)
{
    int e = 0;
    const double m = std::frexp(x, &e);
    Rational r(mpz_class(static_cast<long>(std::ceil(std::ldexp(m, bound_bits)))));
    e -= bound_bits;
    if (e >= 0) mpz_mul_2exp(r.get_num_mpz_t(), r.get_num_mpz_t(), static_cast<mp_bitcnt_t>(e));
    else mpz_mul_2exp(r.get_den_mpz_t(), r.get_den_mpz_t(), static_cast<mp_bitcnt_t>(-e));
    r.canonicalize();
    return r;
}

std::string named(const Root& G) { return G.degree == 1 ? G.base.get_str() : fmt::format("{}^1/{}", G.base.get_str(), G.degree); }

/// The numbered lines of one certificate. What a line is used by last is known only later.
class Lines {
public:
    std::size_t add(const std::string& reason, const std::vector<std::size_t>& rests_on, const std::string& data)
    {
        lines_.push_back({reason, rests_on, data, 0});
        const std::size_t number = lines_.size();
        for (const std::size_t r : rests_on) lines_[r - 1].last = number;
        return number;
    }
    std::size_t count() const { return lines_.size(); }
    std::string text() const
    {
        std::string all;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const Line& l = lines_[i];
            all += fmt::format("{} {} {} {} {}\n", i + 1, l.reason, in_short(l.rests_on), l.last == 0 ? i + 1 : l.last, l.data);
        }
        return all;
    }

private:
    struct Line {
        std::string reason;
        std::vector<std::size_t> rests_on;
        std::string data;
        std::size_t last;
    };
    static std::string in_short(const std::vector<std::size_t>& numbers) // 1,4,10-17
    {
        if (numbers.empty()) return "-";
        std::string text;
        for (std::size_t i = 0, j = 0; i < numbers.size(); i = j) {
            for (j = i + 1; j < numbers.size() && numbers[j] == numbers[j - 1] + 1; ++j) {}
            if (!text.empty()) text += ',';
            text += std::to_string(numbers[i]);
            if (j - i > 1) text += fmt::format("-{}", numbers[j - 1]);
        }
        return text;
    }
    std::vector<Line> lines_;
};

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

Section find(const std::vector<Area>& areas, const Root& G, double digits)
{
    long n = 0;
    Rational least(1), largest(0);
    for (const Area& a : areas) n = std::max(n, a.n), least = std::min(least, a.load), largest = std::max(largest, a.load);
    Section s{grid_for(G, n, digits, least, largest), {}, {}, 0};
    const DiscreteOperator T(s.grid);
    s.levels = T.levels(n);
    std::map<Rational, Row> rows;
    for (const Area& a : areas) {
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

void write(const Section& s, const std::vector<Area>& areas, std::size_t first_claim, std::string& head, Lines& lines, std::size_t number)
{
    const std::size_t first = lines.count() + 1;
    const std::size_t grid = lines.add("grid", {}, fmt::format("G={} bits={:x} step={} points={:x}", named(s.grid.root), s.grid.bits, dyadic(s.grid.step), s.grid.points));
    std::vector<std::size_t> panels;
    for (std::size_t p = 0; p + 1 < s.grid.edges.size(); ++p)
        panels.push_back(lines.add("panel", {grid}, fmt::format("low={} high={} terms={:x} rho={}", dyadic(s.grid.edges[p]), dyadic(s.grid.edges[p + 1]), s.grid.terms, dyadic(ellipse()))));
    std::vector<std::vector<std::size_t>> numbers;
    std::size_t level_lines = 0;
    for (std::size_t m = 0; m < s.levels.size(); ++m) {
        numbers.emplace_back();
        for (std::size_t p = 0; p < panels.size(); ++p, ++level_lines) {
            std::vector<std::size_t> rests_on{grid, panels[p]};
            if (m > 0) rests_on.insert(rests_on.end(), numbers[m - 1].begin(), numbers[m - 1].end());
            const Polynomial& v = s.levels[m].panels[p];
            std::string data = fmt::format("m={:x} error={} exponent={}", m, dyadic(rounded_up(v.error)), -s.grid.kept_bits);
            for (const auto& c : v.coefficients) data += ' ' + hex(c);
            numbers.back().push_back(lines.add("level", rests_on, data));
        }
    }
    for (std::size_t i = 0; i < areas.size(); ++i) {
        std::vector<std::size_t> rests_on{grid};
        const auto& below = numbers[static_cast<std::size_t>(areas[i].n - 1)];
        rests_on.insert(rests_on.end(), below.begin(), below.end());
        lines.add("value", rests_on, fmt::format("claim={}", first_claim + i));
        fmpz_t mantissa, exponent;
        fmpz_init(mantissa);
        fmpz_init(exponent);
        arf_get_fmpz_2exp(mantissa, exponent, arb_midref(s.values[i].area.get()));
        mpz_class m;
        fmpz_get_mpz(m.get_mpz_t(), mantissa);
        const double error = s.values[i].error * arf_get_d(arb_midref(s.values[i].area.get()), ARF_RND_UP) + s.values[i].area.radius_bound();
        head += fmt::format("claim {} n={:x} load={} G={} value={} error={}\n", first_claim + i, areas[i].n, areas[i].load.get_str(), named(areas[i].G),
                            dyadic(m, fmpz_get_si(exponent)), dyadic(rounded_up(narrow * error)));
        fmpz_clear(mantissa);
        fmpz_clear(exponent);
    }
    head += fmt::format("section {} span={}-{} grids=1 panels={} levels={} values={}\n", number, first, lines.count(), panels.size(), level_lines, areas.size());
}

} // namespace

std::string refusal(const Area& a)
{
    if (a.n < 1) return "n = 0 is of closed form: the checker needs no certificate";
    if (a.n > largest_n) return fmt::format("n = {}: certificates are made up to n = {}", a.n, largest_n);
    if (a.load > 1) return "load > 1: certificates are made in partial contact, load <= 1";
    Rational least(1);
    mpz_mul_2exp(least.get_den_mpz_t(), least.get_den_mpz_t(), 40);
    if (a.load < least) return "load < 2^-40: certificates are made of loads from 2^-40 to 1";
    if (power(Rational(41, 20), static_cast<long>(a.G.degree)) > a.G.base) return "G < 2.05: certificates are made where G >= 2.05";
    if (power(Rational(1 << 20), static_cast<long>(a.G.degree)) < a.G.base) return "G > 2^20: certificates are made where G <= 2^20";
    return "";
}

std::string partial_area(const std::vector<Area>& areas, Accuracy wanted)
{
    std::vector<std::pair<Root, std::vector<Area>>> scales;
    for (const Area& a : areas) {
        const auto same = std::find_if(scales.begin(), scales.end(), [&](const auto& s) { return s.first.base == a.G.base && s.first.degree == a.G.degree; });
        if (same == scales.end()) scales.push_back({a.G, {a}});
        else same->second.push_back(a);
    }
    std::string head;
    Lines lines;
    std::size_t claims = 0;
    const double goal = std::pow(10.0, -static_cast<double>(wanted.digits)) / 2;
    for (std::size_t i = 0; i < scales.size(); ++i) {
        const auto& [G, members] = scales[i];
        auto digits = static_cast<double>(wanted.digits);
        Section s = find(members, G, digits);
        for (int attempt = 0; s.worst > goal; ++attempt) {
            if (attempt == 2) throw BeyondReach(fmt::format("the certificate's errors do not come below {:.1e}", goal));
            digits += std::log10(s.worst / goal) + 1;
            s = find(members, G, digits);
        }
        write(s, members, claims + 1, head, lines, i + 1);
        claims += members.size();
    }
    const std::string text = fmt::format("TOUCHSTONE-CERT 1\nquantity contact.area\ncounts claims={} sections={} lines={}\n{}{}", claims, scales.size(), lines.count(), head, lines.text());
    return text + fmt::format("sha256 {}\n", sha256(text));
}

} // namespace touchstone::certificate
