// SPDX-License-Identifier: MIT
/// Full contact: what each grid costs scale by scale, and how far the two are apart. bench_full_contact [G [largest n]]
#include "touchstone/transfer/full_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

using namespace touchstone;
using namespace touchstone::transfer;

int main(int argc, char** argv)
{
    const WorkingPrecision precision(256);
    Ball G = pow(Ball(5), Ball(Rational(1, 20))); // figure 3a
    if (argc > 1) G = Ball(*parse_rational(argv[1]));
    const long most = argc > 2 ? std::stol(argv[2]) : 20;
    const auto seconds = [] { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); };
    double total[2] = {0, 0}, worst = 0;
    fmt::print("n   blind s  tracked s  largest relative difference over 5 loads\n");
    for (long n = 1; n <= most; ++n) {
        double taken[2] = {0, 0}, apart = 0;
        for (const char* load : {"10", "1", "0.1", "0.01", "0.001"}) {
            Ball values[2];
            for (const Grid grid : {Grid::blind, Grid::tracked}) {
                const double start = seconds();
                values[static_cast<int>(grid)] = estimated_area(grid, n, Ball(*parse_rational(load)), G).value;
                taken[static_cast<int>(grid)] += seconds() - start;
            }
            const Ball off = abs(values[0] / values[1] - 1);
            apart = std::max(apart, arf_get_d(arb_midref(off.get()), ARF_RND_UP));
        }
        fmt::print("{:<3} {:7.2f}  {:9.2f}  {:.1e}\n", n, taken[0], taken[1], apart);
        for (int i : {0, 1}) total[i] += taken[i];
        worst = std::max(worst, apart);
    }
    fmt::print("all {:7.2f}  {:9.2f}  {:.1e}\n", total[0], total[1], worst);
}
