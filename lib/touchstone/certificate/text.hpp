// SPDX-License-Identifier: MIT
/// \file
/// How a TOUCHSTONE-CERT 1 is written: its numbers and its numbered lines. Internal to certificate/.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchstone::certificate {

constexpr double narrow = 1.01; ///< bounds are found in binary64 and written down so much larger

std::string hex(const mpz_class&);
/// mantissa:exponent, the mantissa odd, of m 2^e
std::string dyadic(mpz_class m, long e);
std::string dyadic(const Rational& of_a_power_of_two_below);
/// Of the midpoint.
std::string dyadic_midpoint(const Ball&);
/// A bound of few bits, not below x.
Rational rounded_up(double x);
std::string named(const Root& G);

/// The numbered lines of one certificate. What a line is used by last is known only later.
class Lines {
public:
    std::size_t add(const std::string& reason, const std::vector<std::size_t>& rests_on, const std::string& data);
    std::size_t count() const { return lines_.size(); }
    std::string text() const;

private:
    struct Line {
        std::string reason;
        std::vector<std::size_t> rests_on;
        std::string data;
        std::size_t last;
    };
    std::vector<Line> lines_;
};

/// The number that is written so, at the working precision.
Ball number(const Root&);
double nearest(const Ball&);
/// The midpoint in units of 2^-bits, rounded down.
mpz_class units(const Ball&, long bits);

/// The line of the header for the section whose lines are first to last: how many there are of each reason, as its plural, in the order of
/// docs/certificate.md.
using Counts = std::vector<std::pair<std::string_view, std::size_t>>;
std::string section_line(std::size_t section, std::size_t first, std::size_t last, const Counts&);

/// What goes together, each in the order given, the groups in that of their first.
template <class T, class Same>
std::vector<std::vector<T>> grouped(const std::vector<T>& all, Same same)
{
    std::vector<std::vector<T>> groups;
    for (const T& x : all) {
        const auto found = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return same(x, g.front()); });
        if (found == groups.end())
            groups.push_back({x});
        else
            found->push_back(x);
    }
    return groups;
}
inline bool is_same(const Root& a, const Root& b) { return a.base == b.base && a.degree == b.degree; }

/// The whole text: header, claims and sections, lines, sha256.
std::string certificate_text(const std::string& quantity, std::size_t claims, std::size_t sections, const std::string& head, const Lines&);

} // namespace touchstone::certificate
