// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The cases of figures 3 and 4 and their certified areas.
#pragma once

#include "verify/figures/figure.hpp"
#include "verify/figures/tables.hpp"

#include <array>

namespace touchstone::figures {

/// A panel of figures 3 and 4.
struct Surface {
    const char* letter;
    Rational D;
    long gamma;
    double G; ///< the binary64 number the areas are tabulated at
};

inline const std::array<Surface, 4>& surfaces()
{
    static const std::array<Surface, 4> all{{{"a", Rational(21, 20), 5, 1.0837983867343681},
                                             {"b", Rational(21, 20), 10, 1.1220184543019633},
                                             {"c", Rational(3, 2), 5, 2.2360679774997896},
                                             {"d", Rational(3, 2), 10, 3.1622776601683795}}};
    return all;
}

/// The paper's five loads, and how a legend and a CSV write them.
struct Load {
    double value;
    const char* text;
};
inline constexpr std::array<Load, 5> loads{{{0.001, "0.001"}, {0.01, "0.01"}, {0.1, "0.1"}, {1, "1"}, {10, "10"}}};
inline constexpr long last_scale = 20;

/// A_n/lambda_0 as stored, whichever table has it.
class Areas {
public:
    Areas();
    const Ball& at(long n, double load, double G) const;
    std::string status(double load, double G) const;

private:
    const Data& table(double load, double G) const;
    Data partial_, full_, heavy_;
};

std::string title(const Surface&);
std::string name(const Surface&);

/// A point that can claim no more than the table it was made from.
Point no_better_than(const std::string& status, Point);

} // namespace touchstone::figures
