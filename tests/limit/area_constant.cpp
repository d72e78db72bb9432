// SPDX-License-Identifier: MIT
/// The constant of the fractal limit: two routes that share nothing, its rate of approach, and what (7.21) makes of it.
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/limit/area_constant.hpp"
#include "touchstone/limit/area_series.hpp"
#include "touchstone/paper/archard_constants.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using transfer::Scheme;

namespace {

Ball ten_to(long k) { return pow(Ball(10), Ball(k)); }
Ball K_inf() { return archard::K_gamma_product(archard::infinity); }

std::string digits(const char* quantity, const char* G, long count)
{
    const Evaluation e = evaluate(*find_quantity(quantity), Inputs({{"G", *parse_rational(G)}}), {count});
    CHECK(e.status == Status::certified);
    return e.value;
}

} // namespace

TEST_CASE("the recursion backwards and the moments of the limit forwards give the same constant")
{
    for (const long G : {300, 1000}) {
        const Accuracy wanted{12};
        CAPTURE(G);
        const WorkingPrecision precision(160);
        const Ball backwards = limit::area_constant(Scheme::force_weighted, [G] { return Ball(G); }, wanted) / (K_inf() * G);
        const Ball forwards = limit::area_ratio_by_series(Ball(G), wanted);
        CHECK(backwards.overlaps(forwards));
        CHECK(certainly(less(abs(backwards - 1), ten_to(-2))));
        CHECK(backwards.relative_bits() > 3 * wanted.digits);
        CHECK(forwards.relative_bits() > 3 * wanted.digits);
        CHECK_FALSE(forwards.overlaps(backwards * (1 + ten_to(-wanted.digits + 1))));
    }
}

TEST_CASE("the constant does not depend on the load")
{
    const WorkingPrecision precision(160);
    const auto G = [] { return Ball(4); };
    const Ball C = limit::area_constant(Scheme::force_weighted, G, {15});
    for (const char* text : {"0.001", "0.3", "1"}) {
        const Ball load(*parse_rational(text));
        CAPTURE(text);
        for (const long n : {20L, 45L}) {
            const Ball h = transfer::area(Scheme::force_weighted, n, {[load] { return load; }, G}, {20}) * pow(G(), Ball(n)) / load;
            const Ball delta = limit::relative_error(n, G(), load);
            CHECK(certainly(less(abs(h / C - 1), delta + ten_to(-15))));
            if (n == 20) CHECK_FALSE(certainly(less(abs(h / C - 1), ten_to(-15)))); // not yet in the limit
        }
    }
}

TEST_CASE("the rate of approach")
{
    const WorkingPrecision precision(128);
    const auto at = [](long p, long q) { return Ball(Rational(p, q)); };
    CHECK(limit::contraction(Ball(0), at(1, 2)).overlaps(at(1, 2)));
    const Ball full = limit::contraction(Ball(0), Ball(1)); // (2/pi)(t/2 + (3/4) sin 2t), sin^2 t = 2/3
    const Ball t = asin(sqrt(at(2, 3)));
    CHECK(full.overlaps(2 / pi<Ball>() * (t / 2 + 3 * sin(2 * t) / 4)));
    CHECK(certainly(less(full, at(7544, 10000))));
    CHECK(certainly(less(limit::contraction(at(1, 8), Ball(1)), Ball(1)))); // scale() rests on it
    CHECK(certainly(less(limit::contraction(at(1, 16), Ball(1)), limit::contraction(at(1, 8), Ball(1)))));
    for (const long G : {4L, 100L}) {
        const long n = limit::scale(ten_to(-6), 1000, Ball(G), at(1, 2)).value();
        CHECK(certainly(less(limit::relative_error(n, Ball(G), at(1, 2)), ten_to(-6))));
        CHECK_FALSE(certainly(less(limit::relative_error(n - 1, Ball(G), at(1, 2)), ten_to(-6))));
    }
    CHECK_FALSE(limit::scale(ten_to(-6), 5, Ball(4), at(1, 2)).has_value());
}

TEST_CASE("the coefficients in powers of 4/G^2")
{
    const WorkingPrecision precision(160);
    CHECK((limit::hertzian_moment(Ball(-1)) / 4).overlaps(K_inf()));
    CHECK(limit::area_coefficients(0, {12}).size() == 1);
    CHECK(limit::area_coefficients(1, {12}).size() == 2);
    const std::vector<Ball> R = limit::area_coefficients(4, {12});
    REQUIRE(R.size() == 5);
    CHECK(R[0].overlaps(Ball(1)));
    for (const Ball& r : R) {
        CHECK(certainly(less(abs(r), Ball(2))));
        CHECK(certainly(less(Ball(r.radius_bound() < 1e-12 ? 0 : 1), Ball(1))));
    }
    const Ball e(Rational(1, 1'000'000));
    const Witness first = limit::area_ratio_to_first_order(2 / sqrt(e));
    CHECK(certainly(less(abs((first.value - 1) / e - R[1]), ten_to(-13))));
    // R_2 from the recursion at a small 4/G^2
    const Ball C = limit::area_constant(Scheme::force_weighted, [] { return Ball(2000); }, {30}) / (K_inf() * 2000);
    const Ball small(Rational(1, 1'000'000));
    CHECK(certainly(less(abs((C - 1 - R[1] * small) / (small * small) - R[2] - R[3] * small), 3 * small * small)));
}

TEST_CASE("the coefficients of the area law are those that are printed")
{
    const WorkingPrecision precision(160);
    const std::vector<Ball> R = limit::area_coefficients(4, {7});
    const Rational printed[] = {1, Rational(208379, 1'000'000), Rational(37321, 1'000'000), Rational(12173, 1'000'000),
                                Rational(5790, 1'000'000)};
    for (std::size_t N = 0; N < 5; ++N) CHECK(certainly(less(abs(R[N] - Ball(printed[N])), Ball(Rational(1, 2'000'000)))));
}

TEST_CASE("slow: the area law of four terms is within 0.01 (4/G^2)^5 where G >= 3" * doctest::skip())
{
    const WorkingPrecision precision(160);
    const std::vector<Ball> R = limit::area_coefficients(12, {4});
    const Ball most(Rational(4, 9));
    Ball rest(0), power(1);
    for (std::size_t N = 5; N <= 12; ++N, power *= most) rest += abs(R[N]) * power;
    rest += 2 * power / (1 - most); // |R_N| <= 2
    CHECK(certainly(less(rest, Ball(Rational(1, 100)))));
    CHECK_FALSE(certainly(less(rest, Ball(Rational(99, 10'000))))); // no slack is claimed that is not there
}

TEST_CASE("the paper's constant is wrong by 9 and 20 percent where D = 1.5")
{
    const auto ratio = [](long gamma) {
        const Inputs in({{"D", Rational(3, 2)}, {"gamma", Rational(gamma)}});
        return evaluate(*find_quantity("limit.area_ratio"), in, {6}).value;
    };
    CHECK(ratio(10) == "1.09029");
    CHECK(ratio(5) == "1.20136");
}

TEST_CASE("fewer digits are the rounding of more, and every value of the limit has a second look")
{
    const Inputs in({{"G", Rational(10)},
                     {"load", Rational(1, 2)},
                     {"tolerance", Rational(1, 100)},
                     {"n", 5},
                     {"p", Rational(1, 10)},
                     {"a", Rational(1, 100)}});
    for (const auto& q : catalogue()) {
        if (!q.name.starts_with("limit.")) continue;
        CAPTURE(q.name);
        const Plan plan = plan_of(q, in, {15});
        CHECK(plan.proofs.size() + plan.witnesses.size() + (plan.own_witness ? 1 : 0) >= 2);
        CHECK_FALSE(q.description.empty());
    }
    const Quantity& C = *find_quantity("limit.area_constant");
    const Evaluation more = evaluate(C, in, {25}), fewer = evaluate(C, in, {.digits = 9, .start_bits = 64});
    CHECK(more.status == Status::certified);
    CHECK(more.second_look->is_proof);
    CHECK(fewer.value == round_to_digits(*parse_rational(more.value), 9).text(9));
    CHECK(more.binary64.has_value());
}

TEST_CASE("limiting distributions at large G, where the residual counts G^4 times: few digits and more")
{
    const Quantity& force = *find_quantity("limit.force");
    for (const long G : {300, 1000}) {
        const Inputs in({{"p", Rational(1, 300)}, {"G", Rational(G)}});
        const Evaluation few = evaluate(force, in, {.digits = 3}), more = evaluate(force, in, {.digits = 8});
        CHECK(few.status == Status::certified);
        REQUIRE(more.status == Status::certified);
        CHECK(few.value == round_to_digits(*parse_rational(more.value), 3).text(3));
        REQUIRE(more.second_look);
        CHECK(more.second_look->agrees);
    }
}

TEST_CASE("edges of the limiting distributions: the highest pressure is not exceeded, what is out of the domain is one line")
{
    const auto at = [](const char* name, std::map<std::string, Rational> in) {
        return evaluate(*find_quantity(name), Inputs(std::move(in)), {6});
    };
    for (const auto& [p, G] :
         {std::pair{Rational(4, 3), Rational(3)}, {Rational(3), Rational(3, 2)}, {Rational(2), Rational(2)}, {Rational(7), Rational(1000)}})
        for (const char* name : {"limit.exceedance", "limit.force"}) {
            const Evaluation e = at(name, {{"p", p}, {"G", G}});
            CHECK(e.status == Status::exact);
            CHECK(e.value == "0");
        }
    CHECK(at("limit.segments", {{"a", Rational(1, 2)}, {"G", Rational(3)}}).value == "0"); // no full contact in the limit
    CHECK_THROWS_AS(at("limit.exceedance", {{"p", Rational(0)}, {"G", Rational(3)}}), DomainError);
    CHECK_THROWS_AS(at("limit.force", {{"p", Rational(1)}, {"G", Rational(1)}}), DomainError);
    CHECK_THROWS_AS(at("limit.segments", {{"a", Rational(3, 5)}, {"G", Rational(3)}}), DomainError);
    CHECK(at("limit.exceedance", {{"p", Rational(1)}, {"G", Rational(101, 100)}}).status == Status::undecided);
    CHECK(at("limit.exceedance", {{"p", Rational(1)}, {"G", Rational(1001)}}).value == "0"); // above the highest, wherever G is
}

TEST_CASE("edges of the domain")
{
    CHECK_THROWS_AS(evaluate(*find_quantity("limit.area_constant"), Inputs({{"G", Rational(1)}})), DomainError);
    CHECK(digits("limit.area_ratio", "1e300", 20) == "1.0000000000000000000");
    CHECK(digits("limit.area_ratio", "5000", 12) == "1.00000003334"); // the series from here on
    CHECK(digits("limit.area_ratio", "4999.999", 12) == "1.00000003334");
    const Evaluation none =
        evaluate(*find_quantity("limit.area_constant"), Inputs({{"G", Rational(101, 100)}})); // ratios up to 100: no mesh
    CHECK(none.status == Status::undecided);
    CHECK_FALSE(none.proven);
    CHECK_FALSE(none.note.empty());
}
