// SPDX-License-Identifier: MIT
/// Every line of data/hard/values.txt: the value as another program computed it, digit for digit.
#include "touchstone/catalogue/evaluate.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

using namespace touchstone;

namespace {

std::string trimmed(const std::string& s)
{
    const auto first = s.find_first_not_of(' ');
    return first == std::string::npos ? "" : s.substr(first, s.find_last_not_of(' ') - first + 1);
}

} // namespace

TEST_CASE("inputs that once hurt")
{
    std::ifstream file(TOUCHSTONE_DATA "/hard/values.txt");
    int lines = 0;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("#")) continue;
        std::istringstream fields(line);
        std::string name, inputs, digits, value, why;
        std::getline(fields, name, '|');
        std::getline(fields, inputs, '|');
        std::getline(fields, digits, '|');
        std::getline(fields, value, '|');
        CAPTURE(line);
        std::map<std::string, Rational> values;
        std::istringstream words(inputs);
        for (std::string w; words >> w;) values[w.substr(0, w.find('='))] = *parse_rational(w.substr(w.find('=') + 1));
        const Quantity* q = find_quantity(trimmed(name));
        REQUIRE(q != nullptr);
        const Evaluation e = evaluate(*q, Inputs(values), {.digits = std::stol(digits)});
        CHECK((e.status == Status::certified || e.status == Status::exact));
        CHECK(*parse_rational(e.value) == *parse_rational(trimmed(value)));
        ++lines;
    }
    CHECK(lines >= 16);
}
