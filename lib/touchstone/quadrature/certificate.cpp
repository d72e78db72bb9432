// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/tanh_sinh.hpp"
#include "touchstone/quadrature/upper.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace touchstone::quadrature {

std::string to_string(Status s)
{
    switch (s) {
    case Status::certified: return "certified";
    case Status::undecided: return "undecided";
    case Status::indeterminate: break;
    }
    return "indeterminate";
}

/// An upper bound as a short decimal, rounded up: "1.3e-105".
std::string bound_text(const Ball& x)
{
    if (!x.is_finite()) return "null";
    if (arb_is_zero(x.get())) return "0";
    constexpr double tells_fractions = 1e7, tells_exponents = 1e17; // a double as an exponent
    const double l = log2_upper(x) * M_LN2 / M_LN10, e = std::floor(l);
    if (l >= tells_exponents) return "null";
    if (std::fabs(l) > tells_fractions)
        return "1.00e" + std::to_string(static_cast<long>(std::max(std::ceil(l + 1 + std::fabs(l) * 1e-14), -tells_exponents)));
    std::ostringstream out;
    out.precision(2);
    out << std::fixed << std::ceil((std::pow(10.0, l - e) + 1e-6) * 100) / 100 << "e" << static_cast<long>(e);
    return out.str();
}

namespace {

/// A bound that binary64 cannot hold is a JSON string: as a number it would be read as 0 or not at all.
std::string json_bound(const Ball& x)
{
    constexpr double farthest = 300 * M_LN10 / M_LN2;
    const double l = log2_upper(x);
    const std::string text = bound_text(x);
    const bool is_double = text == "null" || text == "0" || std::fabs(l) < farthest;
    return is_double ? text : '"' + text + '"';
}

Ball sum(const std::vector<Panel>& panels, Ball Panel::*term)
{
    const WorkingPrecision precision(strip_bits);
    Ball total(0);
    for (const Panel& p : panels) total += p.*term;
    return total;
}

} // namespace

Ball Certificate::discretisation() const { return sum(panels, &Panel::discretisation); }
Ball Certificate::truncation() const { return sum(panels, &Panel::truncation); }
Ball Certificate::rounding() const { return sum(panels, &Panel::rounding); }
long Certificate::points() const
{
    long n = 0;
    for (const Panel& p : panels) n += p.left_nodes + p.right_nodes + 1;
    return n;
}

std::string Certificate::to_json() const
{
    std::ostringstream out;
    const bool logistic = !panels.empty() && panels.front().transformation == Transformation::logistic;
    out << "{\"method\":\"" << (logistic ? "logistic" : "tanh-sinh") << "\",\"interval\":\"" << interval << "\",\"digits\":" << digits
        << ",\"precision_bits\":" << precision << ",\"points\":" << points() << ",\"discretisation\":" << json_bound(discretisation())
        << ",\"truncation\":" << json_bound(truncation()) << ",\"rounding\":" << json_bound(rounding()) << ",\"panels\":[";
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Panel& p = panels[i];
        out << (i ? "," : "") << "{\"u\":[\"" << p.from << "\",\"" << p.to << "\"],\"alpha\":\"" << p.alpha.to_string() << "\",\"beta\":\""
            << p.beta.to_string() << "\",\"d\":" << p.strip << ",\"K\":[" << json_bound(p.bound_left) << "," << json_bound(p.bound_right)
            << "],\"strip_integral\":" << json_bound(p.strip_integral) << ",\"step\":\"log(2)/" << p.m << "\",\"points\":[" << p.left_nodes
            << "," << p.right_nodes << "],\"pieces\":" << p.pieces << ",\"discretisation\":" << json_bound(p.discretisation)
            << ",\"truncation\":" << json_bound(p.truncation) << ",\"rounding\":" << json_bound(p.rounding) << "}";
    }
    out << "]}";
    return out.str();
}

} // namespace touchstone::quadrature
