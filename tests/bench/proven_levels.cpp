// SPDX-License-Identifier: MIT
/// Proven levels: all scales and loads to 10 of one G, to one tolerance. bench_proven_levels [G|D,gamma [tolerance]]
#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/transfer/proven_levels.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <string>

using namespace touchstone;

int main(int argc, char** argv)
{
    const WorkingPrecision precision(256);
    const std::string surface = argc > 1 ? argv[1] : "1.05,5", tolerance = argc > 2 ? argv[2] : "1e-12";
    const auto comma = surface.find(',');
    const Ball G =
        comma == std::string::npos
            ? Ball(*parse_rational(surface))
            : Inputs({{"D", *parse_rational(surface.substr(0, comma))}, {"gamma", *parse_rational(surface.substr(comma + 1))}}).G_ball();
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    const transfer::ProvenLevels levels(G, 10, std::stod(tolerance));
    fmt::print("{:.1f} s, {:.1f} s CPU, {} MB\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
               static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, levels.memory() >> 20);
    for (const char* load : {"10", "1", "0.1", "0.01", "0.001"})
        for (const long n : {1L, 2L, 5L, 10L, 20L}) {
            const Ball area = levels.share(n, Ball(*parse_rational(load)));
            fmt::print("n = {:2}, load {:5}: {}\n", n, load, area.to_string());
        }
    fmt::print("{}", levels.certificate(20, Ball(1)));
}
