// SPDX-License-Identifier: MIT
/// contact.area: all of 4 loads x 21 scales at 50 certified digits for G = sqrt 10, both routes, against PARI's
/// time for the one nested integral A_2 in the same run; then cost against digits and against n.
///     bench_contact_area [nested_area.gp]
#include "touchstone/catalogue/evaluate.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <sys/resource.h>

using namespace touchstone;

namespace {

template <class F>
double seconds(F f)
{
    const auto start = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

long undecided = 0;

std::string area(long n, const char* load, const char* gamma, long digits)
{
    const Inputs in({{"n", Rational(n)}, {"load", *parse_rational(load)}, {"D", Rational(3, 2)}, {"gamma", *parse_rational(gamma)}});
    const Evaluation e = evaluate(*find_quantity("contact.area"), in, {.digits = digits});
    undecided += e.status == Status::undecided;
    return e.value;
}

} // namespace

int main(int argc, char** argv)
{
    std::string A_2;
    const double ours = seconds([&] {
        for (const char* load : {"0.001", "0.01", "0.1", "1"})
            for (long n = 0; n <= 20; ++n) {
                const std::string a = area(n, load, "10", 50);
                if (n == 2 && std::string(load) == "0.1") A_2 = a;
            }
    });
    std::printf("84 areas at 50 certified digits, two routes: %.3f s\n", ours);
    if (argc > 1) {
        const std::string command = "gp -q " + std::string(argv[1]) + " </dev/null";
        if (FILE* gp = popen(command.c_str(), "r")) {
            std::array<char, 200> value{};
            double ms = 0;
            if (std::fscanf(gp, "%199s %lf", value.data(), &ms) == 2)
                std::printf("PARI, one nested A_2: %.3f s; ours/PARI = %.2f\n  PARI  %s\n  ours  %s\n", ms / 1000, ours * 1000 / ms,
                            value.data(), A_2.c_str());
            pclose(gp);
        }
    }
    double last = 0;
    for (const long digits : {13L, 25L, 50L, 100L}) {
        const double t = seconds([&] { area(20, "0.1", "11", digits); });
        std::printf("first value of a G, %3ld digits: %.3f s%s\n", digits, t,
                    last > 0 ? (", exponent " + std::to_string(std::log2(t / last))).c_str() : "");
        last = t;
    }
    for (const long n : {1L, 5L, 20L, 100L})
        std::printf("another load, n = %3ld, 50 digits: %.3f s\n", n, seconds([&] { area(n, "0.3", "10", 50); }));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("undecided: %ld; peak memory %ld MB\n", undecided, usage.ru_maxrss / 1024);
    return undecided == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
