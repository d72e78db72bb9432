// SPDX-License-Identifier: MIT
// Proven integrals without the rest of the toolkit. With the package installed:
//   find_package(touchstone REQUIRED COMPONENTS quadrature)
//   target_link_libraries(mine PRIVATE touchstone::quadrature)
#include "touchstone/quadrature/path.hpp"

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

    // Along a path in the plane: around the pole of 1/x, 2 pi i.
    std::vector<Vertex> square;
    for (const char* corner : {"1", "i", "-1", "-i", "1"}) square.push_back(parse_vertex(corner));
    const Integral around = integrate_along(parse_expression("1/x"), square);
    std::cout << to_string(around.status) << ": " << around.value.to_string(30) << " + i " << around.imaginary.to_string(30) << "\n";

    // Several formulas with one proof, one with a parameter that is a ball: the result holds the integral for each of its numbers.
    const Parameters known{{"a", {Rational(1, 2), Rational(1, 1000000)}}};
    const std::vector<Integral> several =
        integrate_several({parse_expression("x^(-a)", known), parse_expression("log(x)/sqrt(x)")}, parse_limit("0"), parse_limit("1"));
    for (const Integral& i : several) std::cout << to_string(i.status) << ": " << i.value.to_string(20) << "\n";

    // What cannot be proved is refused, with the reason; nothing is guessed.
    const Integral pole = integrate(parse_expression("1/(x-1/3)"), parse_limit("0"), parse_limit("1"));
    std::cout << to_string(pole.status) << ": " << pole.reason << "\n";

    return typed.status == Status::certified && compiled.status == Status::certified && typed.value.overlaps(compiled.value) &&
                   around.status == Status::certified && several[0].digits >= 5 && several[1].status == Status::certified && pole.divergent
               ? 0
               : 1;
}
