// SPDX-License-Identifier: MIT
// Proven integrals without the rest of the toolkit. With the package installed:
//   find_package(touchstone REQUIRED COMPONENTS quadrature)
//   target_link_libraries(mine PRIVATE touchstone::quadrature)
#include "touchstone/quadrature/integrate.hpp"

#include <iostream>

using namespace touchstone;
using namespace touchstone::quadrature;

int main()
{
    // A formula as text, at run time.
    const Integral typed = integrate(parse_expression("x^(-1/2)*log(1/x)/(1+x^2)"), parse_limit("0"), parse_limit("1"), {.digits = 50});
    std::cout << to_string(typed.status) << ": " << typed.value.to_string(50) << "\n";

    // The same as a generic callable in x and the distances to both ends: faster, and for what has no formula.
    const auto f = [](auto x, auto left, auto) { return to_power(left, Rational(-1, 2)) * -log(left) / (1 + x * x); };
    Options options;
    options.digits = 50;
    const Enclosure compiled = tanh_sinh(f, Interval::finite(0, 1), options);
    std::cout << to_string(compiled.status) << ": " << compiled.value.to_string(50) << "\n" << compiled.certificate.to_json() << "\n";

    // What cannot be proved is refused, with the reason; nothing is guessed.
    const Integral pole = integrate(parse_expression("1/(x-1/3)"), parse_limit("0"), parse_limit("1"));
    std::cout << to_string(pole.status) << ": " << pole.reason << "\n";

    return typed.status == Status::certified && compiled.status == Status::certified && typed.value.overlaps(compiled.value) &&
                   pole.divergent
               ? 0
               : 1;
}
