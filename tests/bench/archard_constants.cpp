// SPDX-License-Identifier: MIT
/// K_inf: cost against digits, and against a peer on the same work in the same run.
///     bench_archard_constants [PYTHON]
/// The peer is mpmath's plain product of Gamma ratios (7.13), all the 3.3 d factors that d digits need.
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/paper/archard_constants.hpp"
#include "touchstone/paper/archard_interpolation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace touchstone;

namespace {

template <class F>
double seconds(F f)
{
    const auto start = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Median of several runs, so that caches of constants are warm and one slow run does not count.
template <class F>
double median_of_five(F f)
{
    double t[5];
    for (double& x : t) x = seconds(f);
    std::sort(t, t + 5);
    return t[2];
}

const char* const peer = R"(
import sys, time
from mpmath import mp, mpf, gamma, sqrt, pi
d = 1000
mp.dps = d + 15
best = None
start = time.perf_counter()
K = 2 / pi
for i in range(int(3.33 * d) + 20):
    delta = 1 - mpf(2) ** (-(i + 1))
    K *= 2 ** delta * gamma(1 + delta / 2) / (sqrt(pi) * gamma(mpf(3) / 2 + delta / 2))
t = time.perf_counter() - start
print(t)
mp.dps = d
print(K)
)";

} // namespace

int main(int argc, char** argv)
{
    const Quantity& K_inf = *find_quantity("archard.K_inf");
    std::printf("digits   gamma-product   interpolation   eval (rounded)   growth exponent\n");
    double before = 0, before_digits = 0, at_1000 = 0, one_route = 0;
    for (const long digits : {100L, 300L, 1000L, 3000L, 10000L}) {
        const WorkingPrecision precision(bits_for_digits(digits) + 48);
        const auto timed = [&](auto f) { return digits <= 1000 ? median_of_five(f) : seconds(f); };
        const double a = timed([] { archard::K_gamma_product(archard::infinity); });
        const double b = timed([] { archard::K_interpolated(archard::infinity); });
        const double e = timed([&] { evaluate(K_inf, Inputs(), {.digits = digits}); });
        std::printf("%6ld %13.4f s %10.4f s %20.4f s", digits, a, b, e);
        if (before > 0) std::printf(" %25.2f", std::log(e / before) / std::log(static_cast<double>(digits) / before_digits));
        std::printf("\n");
        if (digits == 1000) { at_1000 = e; one_route = std::min(a, b); }
        before = e;
        before_digits = static_cast<double>(digits);
    }
    const std::string python = argc > 1 ? argv[1] : "python3";
    FILE* pipe = popen((python + " - <<'EOF'\n" + peer + "EOF").c_str(), "r");
    double peer_time = 0;
    char value[1100] = "";
    if (pipe == nullptr || std::fscanf(pipe, "%lf %1099s", &peer_time, value) != 2) {
        std::printf("mpmath is not available: no comparison\n");
        return 0;
    }
    pclose(pipe);
    const std::string ours = evaluate(K_inf, Inputs(), {.digits = 1000}).value;
    std::printf(
        "1000 digits: mpmath's product %.2f s (%s); one proven enclosure %.4f s, %.0f times less; both routes and rounding %.4f s, %.0f times less\n",
        peer_time, ours.substr(0, 990) == std::string(value).substr(0, 990) ? "same digits" : "OTHER DIGITS", one_route,
        peer_time / one_route, at_1000, peer_time / at_1000);
}
