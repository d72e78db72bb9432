// SPDX-License-Identifier: MIT
#include "tests/fuzz/expect.hpp"
#include "tests/fuzz/targets.hpp"
#include "touchstone/quadrature/expression.hpp"

namespace touchstone::fuzz {

void expressions(std::string_view text)
{
    using namespace quadrature;
    const auto where = [text](const ExpressionError& e) {
        expect(e.column() >= 1 && e.column() <= text.size() + 1, "an error is at a column of the text");
    };
    try {
        const ExpressionPtr e = parse_expression(text, {{"a", {Rational(1, 2), Rational(0)}}});
        expect(e != nullptr, "a formula has a tree");
        depends_on_x(*e);
        is_real(*e);
        has_complex_point(*e);
    }
    catch (const ExpressionError& e) {
        where(e);
    }
    try {
        expect(parse_parameter(text).radius >= 0, "a ball has a radius");
    }
    catch (const ExpressionError& e) {
        where(e);
    }
}

} // namespace touchstone::fuzz
