// SPDX-License-Identifier: MIT
// bench_typed_integrals DIGITS: the finite ranges of public_integrals.txt by `integrate` and by acb_calc_integrate alone, the same compiled
// formula in both. Prints the ratio of the times where both certify, its median, and how many each certifies.
#include "tests/quadrature/public_integrals.hpp"
#include "touchstone/quadrature/integrate.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

/// Of the processor, not of the wall.
double milliseconds(const std::function<void()>& once)
{
    double best = 1e300;
    for (int i = 0; i < 3; ++i) {
        const std::clock_t start = std::clock();
        once();
        best = std::min(best, 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        if (best > 300) break;
    }
    return best;
}

/// Whether acb_calc_integrate with its default limits has the digits.
bool by_arb(const Integrand& f, long digits)
{
    const slong bits = bits_for_digits(digits);
    const WorkingPrecision precision(bits);
    const auto call = [](acb_ptr out, const acb_t z, void* data, slong, slong working) -> int {
        const WorkingPrecision here(working);
        ComplexBall argument;
        acb_set(argument.get(), z);
        acb_set(out, static_cast<const Integrand*>(data)->in_plane(argument).get());
        return 0;
    };
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -bits);
    ComplexBall value;
    acb_calc_integrate(value.get(), call, const_cast<Integrand*>(&f), ComplexBall(f.range().from.ball()).get(),
                       ComplexBall(f.range().to.ball()).get(), bits, tolerance, nullptr, bits);
    mag_clear(tolerance);
    return value.is_finite() && static_cast<double>(value.real().relative_bits()) > 3.3219 * static_cast<double>(digits);
}

} // namespace

int main(int count, char** words)
{
    const long digits = count > 1 ? std::atol(words[1]) : 30;
    std::vector<double> ratios;
    long ours_alone = 0, arb_alone = 0, both = 0, neither = 0;
    for (const PublicIntegral& row : public_integrals(count > 2 ? words[2] : "tests/quadrature/public_integrals.txt")) {
        const Limit from = parse_limit(row.from), to = parse_limit(row.to);
        if (from.infinite || to.infinite) continue;
        IntegralOptions options;
        options.digits = digits;
        const ExpressionPtr e = parse_expression(row.formula);
        bool ours = false, arb = false;
        const double t = milliseconds([&] { ours = integrate(e, from, to, options).status == Status::certified; });
        const double a = milliseconds([&] { arb = by_arb(Integrand(e, {from, to, Map::finite}), digits); });
        (ours && arb ? both : ours ? ours_alone : arb ? arb_alone : neither) += 1;
        if (ours && arb) ratios.push_back(t / a);
        std::printf("%-14s ours %9.2f ms%s  acb_calc_integrate %9.2f ms%s\n", row.name.c_str(), t, ours ? "" : " (refused)", a,
                    arb ? "" : " (fails)");
    }
    std::sort(ratios.begin(), ratios.end());
    if (!ratios.empty())
        std::printf(
            "%ld digits: both %ld, ours alone %ld, acb_calc_integrate alone %ld, neither %ld; ratio of times: median %.2f, largest %.2f\n",
            digits, both, ours_alone, arb_alone, neither, ratios[ratios.size() / 2], ratios.back());
    return 0;
}
