// SPDX-License-Identifier: MIT
#include <touchstone/scalar/ball.hpp>

int main()
{
    touchstone::Ball x(1);
    x = x * 0.1;
    return 0;
}
