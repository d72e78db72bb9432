// SPDX-License-Identifier: GPL-3.0-or-later
// Four lanes and one number give the same bits in a build without optimisation (tests/CMakeLists.txt compiles this file with -O0): what
// takes Lanes by value and is not inlined there would look for them elsewhere than a clone for newer machines puts them.
#include "touchstone/scalar/double_double.hpp"

#include <cstdio>

using touchstone::DoubleDouble;
using touchstone::Lanes;

namespace {

template <class D>
TOUCHSTONE_INLINE DoubleDouble<D> formula(const DoubleDouble<D>& x, const DoubleDouble<D>& y)
{
    return sqrt((x * y + 3) / (x - DoubleDouble<D>(1)) + DoubleDouble<D>(DoubleDouble<double>(0.25)));
}

TOUCHSTONE_CLONES void in_lanes(const double* x, const double* y, double* high, double* low)
{
    const Lanes a{x[0], x[1], x[2], x[3]}, b{y[0], y[1], y[2], y[3]};
    const auto f = formula(DoubleDouble<Lanes>(a, Lanes{}), DoubleDouble<Lanes>(b, Lanes{}));
    for (int i = 0; i < 4; ++i) {
        high[i] = f.high[i];
        low[i] = f.low[i];
    }
}

} // namespace

int main()
{
    const double x[] = {2.5, 3.125, 7, 1.0625}, y[] = {0.3, 0.7, 1e-9, 12};
    double high[4], low[4];
    in_lanes(x, y, high, low);
    int wrong = 0;
    for (int i = 0; i < 4; ++i) {
        const auto f = formula(DoubleDouble<double>(x[i]), DoubleDouble<double>(y[i]));
        if (high[i] == f.high && low[i] == f.low) continue;
        std::printf("lane %d: %a + %a, alone %a + %a\n", i, high[i], low[i], f.high, f.low);
        ++wrong;
    }
    return wrong;
}
