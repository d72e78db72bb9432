// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/directed.hpp"
#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/scalar/exact_text.hpp"
#include "touchstone/table/ranges.hpp"
#include "touchstone/table/working_order.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace touchstone;

TEST_CASE("powers and roots are read exactly")
{
    const auto is = [](const char* text, const Rational& r) {
        return parse_exact(text).has_value() && parse_exact(text)->is_rational() && parse_exact(text)->rational() == r;
    };
    CHECK(is("1/3", Rational(1, 3)));
    CHECK(is("-2^2", -4));
    CHECK(is("2^3^2", 512));
    CHECK(is("2^-3", Rational(1, 8)));
    CHECK(is("2^1/2", 1));
    CHECK(is("sqrt(4)", 2));
    CHECK(is("sqrt(2)*sqrt(2)", 2));
    CHECK(is("(1/4)^(3/2)", Rational(1, 8)));
    CHECK(is("0x1p-3*8", 1));
    CHECK(is("1e-3/ 1e-4", 10));
    CHECK(*parse_exact("10^(1/2)") == sqrt(Exact(10)));
    CHECK(*parse_exact("10^0.5") == *parse_exact("sqrt(10)"));
    CHECK(*parse_exact("2^0.25") == Exact(2).power(Rational(1, 4)));
    for (const char* text : {"",    " ",   "sqrt",     "sqrt(2", "sqrt()", "(1",        "1)",     "2^",  "^2",  "2**3", "1+1",
                             "nan", "inf", "sqrt(-1)", "1/0",    "0^-1",   "0^0", "2*0^(1-1)", "2^sqrt(2)", "10^1e9", "--1", "1 2", "pi"})
        CHECK_MESSAGE(!parse_exact(text).has_value(), text);
    CHECK_FALSE(parse_exact(std::string(100'000, '(')).has_value());
    CHECK_FALSE(parse_exact("2" + std::string(1000, '^') + "1").has_value());
}

TEST_CASE("G may be a root: the same surface as gamma and D, and decided exactly at 2")
{
    const Quantity& fixed_point = *find_quantity("peaks.fixed_point");
    const auto value = [&](const NamedTexts& named) { return evaluate(fixed_point, read_inputs(fixed_point, named), {.digits = 40}); };
    CHECK(value({{"G", "sqrt(10)"}}).value == value({{"gamma", "10"}, {"D", "3/2"}}).value);
    CHECK(value({{"G", "10^(1/2)"}}).value == value({{"gamma", "100"}, {"D", "1.25"}}).value);
    CHECK(value({{"G", "sqrt(10)"}}).value != value({{"G", "3.1622776601683795"}}).value);
    CHECK(value({{"G", "4^(1/2)"}}).status == Status::exact);
    CHECK(read_inputs(fixed_point, {{"G", "3/sqrt(2)"}}).compare_G(2) == 1);
    CHECK(read_inputs(fixed_point, {{"G", "sqrt(3.999999999999999999999999)"}}).compare_G(2) == -1);
    CHECK_THROWS_AS(read_inputs(fixed_point, {{"G", "sqrt(1/2)"}}), DomainError);
    const Quantity& width = *find_quantity("hertz.half_width");
    CHECK_THROWS_AS(read_inputs(width, {{"load", "sqrt(2)"}}), DomainError);
    CHECK_THROWS_AS(read_inputs(width, {{"load", "nan"}}), DomainError);
    CHECK_THROWS_AS(read_inputs(width, {{"load", "1"}, {"load", "1"}}), WrongKeys);
    CHECK_THROWS_AS(read_inputs(width, {}), WrongKeys);
}

TEST_CASE("directed roundings enclose the value, a unit apart; what is exact stays")
{
    std::mt19937_64 random(7);
    INFO("seed 7");
    for (int k = 0; k < 3000; ++k) {
        Rational r(static_cast<long>(random() % 2'000'001) - 1'000'000, 1 + static_cast<long>(random() % (k % 2 ? 1'000 : 1'000'000)));
        r.canonicalize();
        if (k % 5 == 0) r *= power(Rational(10), static_cast<long>(random() % 40) - 20);
        for (const long digits : {1L, 2L, 5L}) {
            const Rational up = round_to_digits(r, digits, Rounding::up).value(), down = round_to_digits(r, digits, Rounding::down).value();
            const Rational zero = round_to_digits(r, digits, Rounding::zero).value(),
                           away = round_to_digits(r, digits, Rounding::away).value();
            CAPTURE(r.get_str());
            CHECK((down <= r && r <= up));
            CHECK((zero == (r > 0 ? down : up) && away == (r > 0 ? up : down)));
            CHECK((up == down) == (round_to_digits(r, digits).value() == r));
            const Decimal nearest = round_to_digits(r, digits);
            CHECK((nearest.value() == up || nearest.value() == down));
            if (r != 0 && up != down) CHECK(up - down <= power(Rational(10), nearest.exponent - digits));
            for (const Rounding how : {Rounding::up, Rounding::down})
                CHECK((r == 0 || static_cast<long>(round_to_digits(r, digits, how).digits.size()) == digits));
        }
    }
    CHECK(round_to_digits(Rational(9996, 100), 3, Rounding::down).text() == "99.9");
    CHECK(round_to_digits(Rational(9991, 100), 3, Rounding::up).text() == "100");
    CHECK(round_to_digits(Rational(-9991, 100), 3, Rounding::down).text() == "-100");
    for (const long e : {-3L, 0L, 2L}) { // one digit just below a power of ten: 10^e - 10^(e-1), not 0
        const Rational ten = power(Rational(10), e), below = ten * Rational(98, 100), nine = ten * Rational(9, 10);
        for (const Rounding how : {Rounding::down, Rounding::zero}) CHECK(round_to_digits(below, 1, how).value() == nine);
        for (const Rounding how : {Rounding::up, Rounding::away}) CHECK(round_to_digits(below, 1, how).value() == ten);
        for (const Rounding how : {Rounding::up, Rounding::zero}) CHECK(round_to_digits(-below, 1, how).value() == -nine);
        for (const Rounding how : {Rounding::down, Rounding::away}) CHECK(round_to_digits(-below, 1, how).value() == -ten);
    }
}

TEST_CASE("eval rounds in a direction what is proven")
{
    const Quantity& K = *find_quantity("archard.K");
    const Inputs three = read_inputs(K, {{"n", "3"}});
    const std::string digits = "0.416550371832813487722720256733"; // to 30, to nearest
    CHECK(evaluate(K, three, {.digits = 6}, Rounding::down).value == "0.416550");
    CHECK(evaluate(K, three, {.digits = 6}, Rounding::up).value == "0.416551");
    CHECK(evaluate(K, three, {.digits = 6}, Rounding::up).error_bound == "1e-06");
    CHECK(evaluate(K, three, {.digits = 30}, Rounding::nearest).value == digits);
    CHECK(evaluate(K, three, {.digits = 12}, Rounding::zero).value == "0.416550371832");
    const Quantity& width = *find_quantity("westergaard.half_width");
    const Evaluation half = evaluate(width, read_inputs(width, {{"load", "1"}}), {.digits = 5}, Rounding::up);
    CHECK((half.value == "0.50000" || half.value == "0.5"));
    CHECK(half.status == Status::exact);
    const Quantity& f = *find_quantity("peaks.f");
    CHECK(evaluate(f, read_inputs(f, {{"x", "1e-30"}}), {.digits = 5}, Rounding::away).status != Status::undecided);
}

TEST_CASE("ranges are exact and end where they say")
{
    const Range steps("0.01:0.99:0.01");
    CHECK(steps.size() == 99);
    CHECK(steps.at(0) == "0.01");
    CHECK(steps.at(98) == "0.99");
    CHECK(Range("0:1:1/3").at(2) == "2/3");
    CHECK(Range("0:1:0.3").size() == 4);
    CHECK(Range("3:1:-1").at(2) == "1");
    CHECK(Range("5:5:1").size() == 1);
    const Range ratios("log:1e-9:1:50");
    CHECK(ratios.size() == 50);
    CHECK(ratios.at(0) == "1e-09");
    CHECK(ratios.at(49) == "1");
    CHECK(Range("log:1:100:3").at(1) == "10");
    for (std::size_t i = 1; i < 50; ++i) CHECK(*parse_rational(ratios.at(i - 1)) < *parse_rational(ratios.at(i)));
    CHECK(Range("log:1e-400:1e-390:11").at(5) == "1.0000000000000000e-395");
    CHECK(Range("1/3,sqrt(2)").at(1) == "sqrt(2)");
    for (const char* text :
         {"1:2", "1:2:0", "1:2:-1", "a:2:1", "1:2:3:4", "log:0:1:5", "log:1:2:1", "log:1:2:1.5", "1,,2", "0:1:1e-300", "log:1:2:1e12"})
        CHECK_THROWS_AS(Range{text}, DomainError);
}

TEST_CASE("rows that share a surface come together, the most demanding first, and none is lost")
{
    const Quantity& density = *find_quantity("contact.density");
    std::vector<Inputs> rows;
    for (const char* G : {"4", "5"})
        for (const char* load : {"0.1", "0.2"})
            for (const char* p : {"3", "1", "2"}) rows.push_back(read_inputs(density, {{"n", "5"}, {"p", p}, {"load", load}, {"G", G}}));
    std::vector<const Inputs*> mixed;
    const std::size_t n = rows.size();
    for (std::size_t i = 0; i < n; ++i) mixed.push_back(i == 7 ? nullptr : &rows[(i * 5) % n]); // 5 and 12 have no common factor
    const auto order = working_order(density, mixed);
    CHECK(order.size() == n - 1);
    std::size_t changes = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Inputs& in = *mixed[order[k]];
        if (k > 0 && in.real("G") == mixed[order[k - 1]]->real("G") && in.real("load") == mixed[order[k - 1]]->real("load")) continue;
        ++changes;
        for (std::size_t other = k;
             other < order.size() && mixed[order[other]]->real("G") == in.real("G") && mixed[order[other]]->real("load") == in.real("load");
             ++other)
            CHECK(in.real("p") <= mixed[order[other]]->real("p"));
    }
    CHECK(changes == 4);
    auto sorted = order;
    std::sort(sorted.begin(), sorted.end());
    CHECK(std::unique(sorted.begin(), sorted.end()) == sorted.end());
    CHECK(std::find(sorted.begin(), sorted.end(), 7) == sorted.end());
}
