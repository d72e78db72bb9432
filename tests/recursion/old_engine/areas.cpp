// SPDX-License-Identifier: MIT
/// contact.area of each row "n load G" of standard input, eight digits: its status and its ball, a line each.
/// The same source is compiled against the library of today and against that of an earlier commit: see compare.py beside it.
#include "touchstone/catalogue/evaluate.hpp"

#include <exception>
#include <iostream>
#include <sstream>

using namespace touchstone;

int main()
{
    const Quantity& area = *find_quantity("contact.area");
    std::string row, n, load, G;
    while (std::getline(std::cin, row)) {
        std::istringstream(row) >> n >> load >> G;
        try {
            const Evaluation e = evaluate(
                area, Inputs({{"n", *parse_rational(n)}, {"load", *parse_rational(load)}, {"G", *parse_rational(G)}}), {.digits = 8});
            // arb_dump_str is exact; no decimal rounds what is compared
            char* ball = arb_dump_str(e.ball.get());
            std::cout << to_string(e.status) << ' ' << e.digits << ' ' << e.value << ' ' << ball << std::endl;
            flint_free(ball);
        }
        catch (const std::exception& e) {
            std::cout << "refused 0 - - " << e.what() << std::endl;
        }
    }
}
