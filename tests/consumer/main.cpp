// SPDX-License-Identifier: MIT
#include <touchstone/catalogue/evaluate.hpp>
#include <touchstone/paper/westergaard.hpp>

#include <cstdio>

int main()
{
    using namespace touchstone;
    const Evaluation e = evaluate(*find_quantity("archard.K"), Inputs({{"n", Rational(3)}}), {.digits = 10});
    std::printf("%s %.17g\n", e.value.c_str(), westergaard::half_width(0.3));
    return e.value == "0.4165503718" ? 0 : 1;
}
