// SPDX-License-Identifier: GPL-3.0-or-later
/// The README's first screen: one formula, called in four arithmetics.
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/mpfr.hpp"
#include "touchstone/scalar/symbol.hpp"

#include <iomanip>
#include <iostream>

using namespace touchstone;

int main()
{
    std::cout << std::setprecision(17) << westergaard::half_width(0.3) << "\n";

    Mpfr::default_precision(50);
    std::cout << std::setprecision(50) << westergaard::half_width(Mpfr(3) / 10) << "\n";

    const WorkingPrecision precision(128);
    std::cout << westergaard::half_width(Ball(Rational(3, 10))).to_string(45) << "\n";

    const GiNaC::symbol load("load");
    std::cout << westergaard::half_width(Symbol(load)) << "\n";
}
