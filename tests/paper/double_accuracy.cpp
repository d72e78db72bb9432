// SPDX-License-Identifier: GPL-3.0-or-later
/// The double instantiations of the formulas, and GSL's functions, against the certified tables.
///
/// Claim: error <= 4 ulp + what rounding the inputs alone forces, where the latter is how far the true
/// value moves when each binary64 input moves by half an ulp (certified balls, the worse side).
/// Run with -s to see the worst row of each table.
#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/gap.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/segments.hpp"
#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/paper/weierstrass_profile.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/table/format.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_gamma.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

using namespace touchstone;

namespace {

using Row = std::vector<double>;
using Code = std::function<double(const Row&)>;

constexpr double bound_in_ulps = 4;

StoredTable stored(const std::string& name)
{
    std::ifstream in(fmt::format("{}/reference/{}.txt", TOUCHSTONE_DATA, name), std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return parse_table(bytes.str(), name);
}

/// The spacing of binary64 numbers at |x|, the smallest subnormal at least.
Rational ulp(const Rational& x)
{
    const double d = std::fabs(nearest_double(x));
    if (!std::isfinite(d)) return exact_rational(std::ldexp(1.0, 971));
    return exact_rational(d == 0 ? 5e-324 : std::nextafter(d, INFINITY) - d);
}

double as_double(const Ball& b) { return mag_get_d(arb_radref(b.get())) + std::fabs(arf_get_d(arb_midref(b.get()), ARF_RND_UP)); }

/// How far, in units of `unit`, rounding of the inputs can move the true value.
/// Measured from the quantity itself, never from the table: a wrong table must not excuse itself.
double forced(const Quantity& q, const Row& row, const Rational& unit)
{
    const WorkingPrecision precision(300);
    std::map<std::string, Rational> at;
    for (std::size_t i = 0; i < row.size(); ++i) at[q.inputs[i]] = exact_rational(row[i]);
    const Ball here = first_ball(q, Inputs(at));
    double total = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (q.inputs[i] == "n") continue; // an integer is not rounded
        double worst = 0;
        for (const int side : {-1, 1}) {
            auto moved = at;
            moved[q.inputs[i]] += side * ulp(at[q.inputs[i]]) / 2;
            try {
                q.check(Inputs(moved));
                worst = std::max(worst, as_double((first_ball(q, Inputs(moved)) - here) / Ball(unit)));
            }
            catch (const DomainError&) { // no such neighbour
            }
        }
        total += worst;
    }
    return total;
}

struct Report {
    double worst = 0;                ///< ulps, where rounding the inputs forces less than one
    double worst_excess = -INFINITY; ///< ulps beyond what is forced, anywhere
    int over = 0;                 ///< rows beyond bound_in_ulps + forced
    std::string worst_row;
};

Report judge(const StoredTable& t, const Code& code)
{
    const Quantity& q = *find_quantity(t.quantity);
    Report report;
    for (const auto& row : t.rows) {
        const Rational value = *parse_rational(row.value);
        const Rational unit = ulp(value);
        const double answer = code(row.inputs);
        double error = INFINITY;
        const double nearest = nearest_double(value);
        if (answer == nearest || (std::isnan(answer) && std::isnan(nearest))) error = 0.5;
        else if (std::isfinite(answer)) error = nearest_double(Rational(abs(exact_rational(answer) - value) / unit));
        const double allowance = error <= 1 ? 0 : forced(q, row.inputs, unit);
        if (allowance < 1) report.worst = std::max(report.worst, error);
        if (!(error <= bound_in_ulps + allowance)) ++report.over;
        if (!(error - allowance <= report.worst_excess)) {
            report.worst_excess = error - allowance;
            report.worst_row = fmt::format("answer {} for {} at", hexfloat(answer), row.value);
            for (const double x : row.inputs) report.worst_row += fmt::format(" {}", hexfloat(x));
        }
    }
    return report;
}

const std::map<std::string, Code>& library_codes()
{
    static const std::map<std::string, Code> codes{
        {"westergaard_half_width", [](const Row& r) { return westergaard::half_width(r[0]); }},
        {"westergaard_pressure", [](const Row& r) { return westergaard::pressure(r[0], r[1]); }},
        {"westergaard_exceedance", [](const Row& r) { return westergaard::exceedance(r[0], r[1]); }},
        {"westergaard_density", [](const Row& r) { return westergaard::density(r[0], r[1]); }},
        {"westergaard_gap", [](const Row& r) { return westergaard::gap(r[0], r[1]); }},
        {"westergaard_mean_gap", [](const Row& r) { return westergaard::mean_gap(r[0]); }},
        {"westergaard_energy", [](const Row& r) { return westergaard::energy(r[0]); }},
        {"hertz_gap", [](const Row& r) { return hertz::gap(r[0], r[1]); }},
        {"hertz_half_width", [](const Row& r) { return hertz::half_width(r[0]); }},
        {"hertz_pressure", [](const Row& r) { return hertz::pressure(r[0], r[1]); }},
        {"weierstrass_bound", [](const Row& r) { return weierstrass::bound(r[0], r[1]); }},
        {"peaks_f", [](const Row& r) { return peaks::f(r[0]); }},
        {"peaks_iterate", [](const Row& r) { return peaks::iterate(static_cast<long>(r[0]), r[1], r[2]); }},
        {"peaks_fixed_point", [](const Row& r) { return peaks::fixed_point(r[0]); }},
        {"archard_K", [](const Row& r) { return archard::K(static_cast<long>(r[0])); }},
        {"archard_K_inf", [](const Row&) { return archard::K(-1); }},
        {"archard_delta", [](const Row& r) { return archard::delta<double>(static_cast<long>(r[0])); }},
        {"archard_alpha", [](const Row& r) { return archard::alpha(static_cast<long>(r[0]), r[1]); }},
        {"archard_area",
         [](const Row& r) {
             const long n = static_cast<long>(r[0]);
             return archard::area(n, r[1], r[2], archard::K(n));
         }},
        {"archard_segments",
         [](const Row& r) {
             const long n = static_cast<long>(r[0]);
             return archard::segments(n, r[1], r[2], r[3], archard::K(n - 1));
         }},
        {"archard_segments_limit",
         [](const Row& r) { return archard::segments_limit(static_cast<long>(r[0]), r[1], r[2], r[3], archard::K(-1)); }},
        {"segments_max_half_width", [](const Row& r) { return segments::max_half_width(static_cast<long>(r[0]), r[1], r[2]); }},
        {"weierstrass_profile", [](const Row& r) { return weierstrass::profile(r[0], r[1], r[2]); }},
    };
    return codes;
}

} // namespace

TEST_CASE("the library's double forms: 4 ulp plus what the inputs' rounding forces")
{
    for (const auto& [table, code] : library_codes()) {
        const Report r = judge(stored(table), code);
        MESSAGE(
            fmt::format("{:<26} worst {:.2f} ulp where well conditioned, {:+.2f} beyond the forced part", table, r.worst, r.worst_excess));
        CHECK_MESSAGE(r.over == 0, table << ": " << r.over << " rows; worst " << r.worst_row);
    }
}

TEST_CASE("the printed forms in double lose their digits at the edges: the comparison can fail")
{
    const Report q = judge(stored("westergaard_exceedance"), [](const Row& r) {
        return r[1] < 1 ? as_printed::exceedance_partial(r[0], r[1]) : as_printed::exceedance_full(r[0], r[1]);
    });
    CHECK(q.over > 10);
    const Report a = judge(stored("westergaard_half_width"), [](const Row& r) { return as_printed::half_width(r[0]); });
    CHECK(a.worst_excess > bound_in_ulps);
}

TEST_CASE("a planted wrong digit in a table is found, in that row alone")
{
    StoredTable t = stored("peaks_fixed_point");
    const Code& code = library_codes().at("peaks_fixed_point");
    CHECK(judge(t, code).over == 0);
    std::string& value = t.rows[200].value;
    char& digit = value[value.find('.') + 10]; // of a value between 0.1 and 10
    digit = digit == '9' ? '8' : static_cast<char>(digit + 1);
    CHECK(judge(t, code).over == 1);
}

TEST_CASE("GSL: Gamma ratios and arcsines against the tables")
{
    gsl_set_error_handler_off();
    const Report gamma = judge(stored("archard_K"), [](const Row& r) {
        const long n = std::min(static_cast<long>(r[0]), 64L); // later factors are 1 in double
        double K = 2 / M_PI;
        for (long i = 0; i < n; ++i) {
            const double d = 1 - std::ldexp(1, -static_cast<int>(i) - 1);
            K *= std::pow(2, d) * gsl_sf_gamma(1 + d / 2) / (std::sqrt(M_PI) * gsl_sf_gamma(1.5 + d / 2));
        }
        return K;
    });
    MESSAGE(fmt::format("gsl_sf_gamma recursion: worst {:.1f} ulp", gamma.worst));
    CHECK(gamma.worst < 8 * 64); // some 7 ulp a factor: the errors of 64 factors all count

    const Report beta = judge(stored("archard_K"), [](const Row& r) {
        double K = 2 / M_PI;
        for (long i = 0; i < std::min(static_cast<long>(r[0]), 64L); ++i) {
            const double d = 1 - std::ldexp(1, -static_cast<int>(i) - 1);
            K *= std::pow(2, d) * gsl_sf_beta(0.5, 1 + d / 2) / M_PI; // (7.13) as a Beta integral
        }
        return K;
    });
    MESSAGE(fmt::format("gsl_sf_beta recursion: worst {:.1f} ulp", beta.worst));
    CHECK(beta.worst < 8 * 64);

    const Report arcsine = judge(stored("westergaard_half_width"), [](const Row& r) {
        return GSL_REAL(gsl_complex_arcsin_real(std::sqrt(r[0]))) / M_PI;
    });
    MESSAGE(fmt::format("gsl_complex_arcsin_real: worst {:.2f} ulp where well conditioned, {:+.2f} beyond the forced part", arcsine.worst,
                        arcsine.worst_excess));
    CHECK(arcsine.worst < 8);
}
