// SPDX-License-Identifier: MIT
// Product integration: its weights against closed forms, the numbers with logarithms as symbols, which formulas it takes and which it must
// not.
#include "touchstone/quadrature/ellipse_rule.hpp"
#include "touchstone/quadrature/elliptic.hpp"
#include "touchstone/quadrature/integrate.hpp"
#include "touchstone/quadrature/product_rule.hpp"
#include "touchstone/quadrature/singular_weights.hpp"
#include "touchstone/quadrature/upper.hpp"

#include "arb_elliptic.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

Ball decimal(const char* text) { return Ball(*parse_rational(text)); }

Ball beta(const Ball& x, const Ball& y)
{
    const auto gamma = [](const Ball& z) { return ScalarTraits<Ball>::gamma(z); };
    return gamma(x) * gamma(y) / gamma(x + y);
}

/// sum of W_l u^k: the integral of w u^k over z.
Ball by_rule(const SingularWeight& w, long k, long n, slong bits)
{
    const auto nodes = GaussNodes::get(n, bits);
    const auto weights = WeightedNodes::get(w, n, bits);
    Ball sum(0);
    const auto& entries = nodes->entries();
    for (std::size_t l = 0; l < entries.size(); ++l)
        for (const bool mirrored : {false, true}) {
            if (mirrored && n % 2 != 0 && l + 1 == entries.size()) continue;
            const Ball u = (Ball(1) + (mirrored ? -entries[l].z : entries[l].z)) / Ball(2);
            sum += weights->at(l, mirrored) * analytic::integer_power(u, k);
        }
    return sum;
}

void agree(const Ball& x, const Ball& y, slong bits)
{
    CHECK_MESSAGE(x.overlaps(y), x.to_string(30), " is not ", y.to_string(30));
    CHECK(x.relative_bits() >= bits);
}

Integral integral(const std::string& formula, const char* from, const char* to, long digits = 30)
{
    IntegralOptions o;
    o.digits = digits;
    return integrate(parse_expression(formula), parse_limit(from), parse_limit(to), o);
}

} // namespace

TEST_CASE("a weight that has no integral has no moments either, though the formulas for them are finite")
{
    const WorkingPrecision precision(100);
    for (const Rational& power : {Rational(-3, 2), Rational(-1), Rational(-5, 4)})
        for (const bool on_the_left : {true, false}) {
            const SingularWeight w =
                on_the_left ? SingularWeight{Exponent(power), Exponent(0)} : SingularWeight{Exponent(0), Exponent(power)};
            CHECK_FALSE(w.has_integral());
            for (const Ball& m : moments(w, 3)) CHECK_FALSE(m.is_finite());
        }
    CHECK(moments({Exponent(Rational(-99, 100)), Exponent(0)}, 1).front().overlaps(Ball(100)));
}

TEST_CASE("the weights integrate powers of u exactly, up to degree n - 1 and no further")
{
    constexpr slong bits = 200, wanted = 150;
    const WorkingPrecision precision(bits);
    for (const long n : {1L, 2L, 7L, 40L})
        for (const long k : {0L, n - 1}) {
            // u^p r^q u^k: 2 B(p + k + 1, q + 1)
            for (const auto& [p, q] : {std::pair(Exponent(-9, 10), Exponent(0)), std::pair(Exponent(0), Exponent(1, 3)),
                                       std::pair(Exponent(-1, 2), Exponent(2, 5)), std::pair(Exponent(2, 5), Exponent(2, 5))})
                agree(by_rule({p, q}, k, n, bits), Ball(2) * beta(p.ball() + Ball(k + 1), q.ball() + Ball(1)), wanted);
            // u^p log(u)^i u^k: (-1)^i i!/(p + k + 1)^(i + 1), twice
            const Ball s = Ball(k + 1) + Exponent(1, 2).ball();
            agree(by_rule({Exponent(1, 2), 0, 1, 0}, k, n, bits), Ball(-2) / (s * s), wanted);
            agree(by_rule({Exponent(1, 2), 0, 2, 0}, k, n, bits), Ball(4) / (s * s * s), wanted);
            agree(by_rule({Exponent(1, 2), 0, 3, 0}, k, n, bits), Ball(-12) / (s * s * s * s), wanted);
        }
    // log(1 - u) u^k: -H_(k+1)/(k + 1)
    agree(by_rule({0, 0, 0, 1}, 2, 7, bits), Ball(-2) * (Ball(11) / Ball(6)) / Ball(3), wanted);
    // log(u) log(1 - u): 2 - pi^2/6
    agree(by_rule({0, 0, 1, 1}, 0, 7, bits), Ball(2) * (Ball(2) - pi<Ball>() * pi<Ball>() / Ball(6)), wanted);
    CHECK(moments({0, 0, 1, 0}, 5).size() == 5);
    // log(u)^2 log(1 - u): -2 sum of 1/(k (k + 1)^3) = 2 zeta(2) + 2 zeta(3) - 6
    Ball zeta_3;
    arb_zeta_ui(zeta_3.get(), 3, bits);
    const Ball cubic = pi<Ball>() * pi<Ball>() / Ball(3) + Ball(2) * zeta_3 - Ball(6);
    agree(by_rule({0, 0, 2, 1}, 0, 7, bits), Ball(2) * cubic, wanted);
    agree(by_rule({0, 0, 1, 2}, 0, 7, bits), Ball(2) * cubic, wanted);
    CHECK_FALSE(by_rule({0, 0, 1, 0}, 3, 3, bits).overlaps(Ball(-2) / Ball(16)));
}

TEST_CASE("the size of a rule: the integral of |w|, and the sum of the sizes of its weights")
{
    constexpr slong bits = 128;
    const WorkingPrecision precision(bits);
    struct Weight {
        SingularWeight w;
        Ball integral;
    };
    const Exponent half(1, 2);
    for (const auto& [w, integral] : {Weight{{Exponent(-9, 10), 0}, Ball(20)}, Weight{{0, 0, 1, 0}, Ball(2)}, Weight{{0, 0, 0, 2}, Ball(4)},
                                      Weight{{half, 0, 1, 0}, Ball(8) / Ball(9)}, Weight{{-half, -half}, Ball(2) * pi<Ball>()}})
        for (const long n : {1L, 4L, 9L}) {
            const auto rule = WeightedNodes::get(w, n, bits);
            Ball sum = integral;
            for (long k = 0; k < (n + 1) / 2; ++k)
                for (const bool mirrored : {false, true})
                    if (!mirrored || 2 * k + 1 < n) sum += abs(rule->at(static_cast<std::size_t>(k), mirrored));
            CHECK(arb_le((sum * (Ball(1) - ScalarTraits<Ball>::power_of_two(-100))).get(), rule->size().get()));
            CHECK(arb_le(rule->size().get(), (sum * (Ball(1) + ScalarTraits<Ball>::power_of_two(-20))).get()));
        }
}

TEST_CASE("what is taken, and by which rule")
{
    struct Case {
        const char *formula, *from, *to, *value;
    };
    const std::vector<Case> taken = {{"log(x)/(1+x^2)", "0", "1", "-0.915965594177219015054603514932384110774"},
                                     {"log(x)^2", "0", "1", "2"},
                                     {"log(sin(x))", "0", "pi", "-2.177586090303602130500688898237613947"},
                                     {"log(cos(x))", "0", "pi/2", "-1.088793045151801065250344449118806973"},
                                     {"x^(-0.9)*log(1/x)", "0", "1", "100"},
                                     {"(x*(1-x))^(-1/3)*log(x/(1-x))^2*exp(0*x)", "0", "1", ""},
                                     {"log(x)*log(1-x)", "0", "1", "0.355065933151773563527584833353974810"},
                                     {"ellipk(x^2)", "0", "1", "1.831931188354438030109207029864768221"},
                                     {"ellipe(x^2)", "0", "1", "1.415965594177219015054603514932384110"},
                                     {"log(x)^2/(1+x^2)", "0", "inf", "3.875784585037477521934539383387674"}};
    for (const Case& c : taken) {
        CAPTURE(std::string(c.formula));
        const Integral i = integral(c.formula, c.from, c.to);
        const bool proven = i.status == Status::certified || i.value.contains_zero();
        REQUIRE(proven);
        CHECK(i.parts.front().rule == "product integration");
        if (*c.value) {
            Ball v = decimal(c.value);
            arb_add_error(v.get(), decimal("1e-28").get());
            CHECK(i.value.overlaps(v));
        }
    }
    // a function of a logarithm, a power inside a sum: what stands beside the weight would not be analytic
    for (const char* formula : {"log(x)/(1+log(x)^2)", "1/(1+x^0.3)", "exp(x^0.7)", "log(1+x^0.3)", "x^x"}) {
        CAPTURE(std::string(formula));
        const Integral i = integral(formula, "0", "1", 15);
        CHECK(i.status == Status::certified);
        CHECK(i.parts.front().rule == "tanh-sinh");
    }
}

TEST_CASE("what is singular inside its own factors is cut close to the end with the logarithm")
{
    for (const char* formula : {"ellipk(x^2)", "ellipe(x^2)"}) {
        CAPTURE(std::string(formula));
        const Integral i = integral(formula, "0", "1", 50);
        REQUIRE(i.parts.size() == 1);
        CHECK(i.parts.front().rule == "product integration");
        CHECK(i.parts.front().evaluations < 260); // 338 and 323 where it was cut in the middle
        const Integral mirrored = integral(formula, "-1", "0", 50);
        CHECK(mirrored.value.overlaps(i.value));
        CHECK(mirrored.parts.front().evaluations < 260);
    }
}

TEST_CASE("a bound is not improved where that costs more than the nodes it saves")
{
    const Integral i = integral("x*sqrt(x)", "0", "1", 50);
    CHECK(i.value.contains(Rational(2, 5)));
    CHECK(i.parts.front().evaluations < 40); // 43 with the boxes of the ellipse's boundary
    const Integral wave = integral("sin(60*x)/sqrt(x)", "0", "1", 50); // whose bound is worth it
    CHECK(wave.status == Status::certified);
}

TEST_CASE("both rules agree where both apply")
{
    for (const char* formula :
         {"x^(-0.7)*exp(x)", "log(x)*cos(3*x)", "x^0.3*(1-x)^(-0.4)/(2+x)", "log(x)^2*sin(10*x)/x^0.2", "log(1-x)*log(x)*exp(x)",
          "besselk(0,x)", "bessely(1,x)*x", "ellipk(x)", "ellipe(1-x)", "log(x)*(1-cos(x))/x^2"}) {
        CAPTURE(std::string(formula));
        IntegralOptions o;
        const Integral a = integrate(parse_expression(formula), parse_limit("0"), parse_limit("1"), o);
        o.gauss_legendre = false;
        const Integral b = integrate(parse_expression(formula), parse_limit("0"), parse_limit("1"), o);
        REQUIRE(a.status == Status::certified);
        REQUIRE(b.status == Status::certified);
        CHECK(a.parts.front().rule == "product integration");
        CHECK(b.parts.front().rule == "tanh-sinh");
        CHECK_MESSAGE(a.value.overlaps(b.value), a.value.to_string(32), " and ", b.value.to_string(32));
    }
}

TEST_CASE("a number with logarithms has no value but in sums and products")
{
    class Symbols : public Frame<ComplexBall> {
    public:
        ComplexBall distance(Side) const override { return Ball(1) / Ball(2); }
        ComplexBall logarithm(Side) const override { return ComplexBall::indeterminate(); }
        bool keeps_logarithms() const override { return true; }
    } frame;
    using N = EndpointNumber<ComplexBall>;
    const N u(&frame, {1, 0}, {}, ComplexBall(1)), l = log(u);
    REQUIRE(l.has_logarithms());
    CHECK((l * l + u).has_logarithms());
    CHECK(((l + N(1)) * (l - N(1))).logarithms().size() == 2);
    CHECK(to_power(l, Exponent(8)).logarithms().back().left == 8); // as many products are multiplied out
    for (const long n : {9L, 0L}) CHECK_FALSE(to_power(l, Exponent(n)).has_logarithms());
    for (const N& x : {l, N(l + N(1)), N(l * u)}) {
        CHECK_FALSE(x.factor().is_finite());
        CHECK_FALSE(x.value().is_finite());
    }
    // (2 u log u + 3)(log u - 1/2), u = 1/2 in this frame: log(u)^2 + 5/2 log(u) - 3/2
    const N product = (N(2) * u * l + N(3)) * (l - N(ComplexBall(Ball(1) / Ball(2))));
    CHECK(product.factor_without_logarithm().overlaps(ComplexBall(Ball(-3) / Ball(2))));
    for (const auto& t : product.logarithms())
        CHECK((t.left == 2 ? t.c.overlaps(ComplexBall(1)) : t.c.overlaps(ComplexBall(Ball(5) / Ball(2)))));
    for (const N& x :
         {sqrt(l), exp(l), sin(l), log(l), N(N(1) / l), pow(l, Ball(1) / Ball(3)), atan(l), asin(l), abs(l), to_power(l, Exponent(-1))}) {
        CHECK_FALSE(x.factor_without_logarithm().is_finite());
        CHECK_FALSE(x.value().is_finite());
    }
}

TEST_CASE("K and E by means against Arb's")
{
    constexpr slong bits = 200;
    const WorkingPrecision precision(bits);
    std::mt19937 random(20261125);
    std::uniform_real_distribution<double> part(-3, 3);
    for (int k = 0; k < 200; ++k) {
        const ComplexBall m(Ball::exactly(part(random)), Ball::exactly(k % 3 == 0 ? 0 : part(random)));
        if (k % 3 == 0 && !arb_lt(acb_realref(m.get()), Ball(1).get())) continue;
        const auto own = elliptic_of_complement(ComplexBall(1) - m);
        const ComplexBall K = elliptic_k(m, bits), E = elliptic_e(m, bits);
        CHECK(own.k.overlaps(K));
        CHECK(own.e.overlaps(E));
        CHECK(acb_rel_accuracy_bits(own.k.get()) > bits - 30);
        CHECK(acb_rel_accuracy_bits(own.e.get()) > bits - 30);
        // a box holds what it holds at its middle
        ComplexBall box = m;
        mag_set_d(arb_radref(acb_realref(box.get())), 0.05);
        mag_set_d(arb_radref(acb_imagref(box.get())), 0.05);
        const auto wide = elliptic_of_complement(ComplexBall(1) - box);
        CHECK((!wide.k.is_finite() || wide.k.overlaps(K)));
        CHECK((!wide.e.is_finite() || wide.e.overlaps(E)));
    }
    CHECK_FALSE(elliptic_of_complement(Ball(-1)).k.is_finite());
    CHECK_FALSE(elliptic_of_complement(Ball(0)).e.is_finite());
}

TEST_CASE("the boxes of an ellipse cover it, and hold the sine and the cosine of the angle there")
{
    const WorkingPrecision precision(strip_bits);
    std::vector<EllipseBox> boxes;
    EllipseFunction f;
    f.in_plane = [&](const EllipseBox& box, std::vector<ComplexBall>& c) {
        c.assign(1, ComplexBall(1) / (2 + box.z * box.z));
        if (c[0].is_finite()) boxes.push_back(box);
    };
    f.at_node = [](const GaussNodes::Entry& e, bool, std::vector<Ball>& c) { c.assign(1, 1 / (2 + e.z * e.z)); };
    for (const bool even : {false, true}) {
        f.is_even = even;
        boxes.clear();
        const auto found = by_ellipse(f, 100, false, 700);
        REQUIRE(found);
        constexpr int points = 500;
        for (int k = 0; k <= points; ++k) {
            const ComplexBall w(Ball::exactly(found->sigma), pi<Ball>() * Ball(k) / Ball(points * (even ? 2 : 1)));
            const ComplexBall z = (exp(w) + exp(-w)) / ComplexBall(2);
            CHECK(std::any_of(boxes.begin(), boxes.end(), [&](const EllipseBox& b) { return acb_overlaps(b.z.get(), z.get()) != 0; }));
        }
        for (const EllipseBox& box : boxes) {
            ComplexBall middle, sine, cosine;
            acb_get_mid(middle.get(), box.z.get());
            const ComplexBall angle = (ComplexBall(1) + middle) * ComplexBall(pi<Ball>() / Ball(4));
            acb_sin_cos(sine.get(), cosine.get(), angle.get(), strip_bits);
            CHECK(acb_contains(box.sine.get(), sine.get()));
            CHECK(acb_contains(box.cosine.get(), cosine.get()));
            const Ball re = middle.real();
            if (box.side) CHECK((*box.side == Side::left ? arb_is_negative(re.get()) : arb_is_positive(re.get())) != 0);
            else CHECK(!even);
            const Ball allowed = radius_of(box.z) * Ball(2); // |d sin| <= cosh |d angle|
            CHECK(arb_le(radius_of(box.sine).get(), allowed.get()));
            CHECK(arb_le(radius_of(box.cosine).get(), allowed.get()));
        }
    }
}

TEST_CASE("the logarithms of the shares that are kept at a node are those of its z, to all its bits")
{
    for (const slong bits : {60, 200, 500}) {
        const auto nodes = GaussNodes::get(17, bits);
        {
            const WorkingPrecision few(30); // of whoever asks first
            (void)nodes->entries().front().log_of_share(Side::left);
        }
        const WorkingPrecision precision(bits + 100);
        for (const GaussNodes::Entry& e : nodes->entries()) {
            agree(e.log_of_share(Side::left), log((Ball(1) + e.z) / Ball(2)), bits - 12);
            agree(e.log_of_share(Side::right), log((Ball(1) - e.z) / Ball(2)), bits - 12);
        }
    }
}

TEST_CASE("the one node of the smallest rule, which is exact, keeps its logarithm as well")
{
    const GaussNodes::Entry& middle = GaussNodes::get(1, 60)->entries().front();
    const WorkingPrecision precision(60);
    CHECK(middle.weight.is_exact());
    agree(middle.log_of_share(Side::left), -log(Ball(2)), 50);
}

TEST_CASE("the reciprocal of a weight at the nodes is that of the product of its powers and logarithms")
{
    const WorkingPrecision precision(200);
    constexpr long n = 5;
    for (const SingularWeight& w : {SingularWeight{Exponent(-1, 3), Exponent(1, 2), 1, 2},
                                    SingularWeight{Exponent(0), Exponent(-9, 10), 0, 1},
                                    SingularWeight{Exponent(3, 4), Exponent(0), 0, 0}, SingularWeight{Exponent(0), Exponent(0), 3, 0}}) {
        const auto rule = WeightedNodes::get(w, n, 200);
        const auto& entries = GaussNodes::get(n, 200)->entries();
        for (std::size_t k = 0; k < entries.size(); ++k)
            for (const bool mirrored : {false, true}) {
                const Ball z = mirrored ? -entries[k].z : entries[k].z, u = (Ball(1) + z) / Ball(2), r = (Ball(1) - z) / Ball(2);
                Ball weight = exp(w.left.ball() * log(u) + w.right.ball() * log(r));
                for (int j = 0; j < w.left_logarithms; ++j) weight *= log(u);
                for (int j = 0; j < w.right_logarithms; ++j) weight *= log(r);
                agree(rule->reciprocal(k, mirrored) * weight, Ball(1), 180);
            }
    }
}

TEST_CASE("a function known with its one weight, and without it, has the same integral")
{
    const WorkingPrecision precision(220);
    EllipseFunction f;
    const SingularWeight w{Exponent(1, 3), Exponent(0), 1, 0};
    f.weights = {w};
    f.in_plane = [](const EllipseBox& box, std::vector<ComplexBall>& c) { c.assign(1, exp(box.z)); };
    f.at_node = [](const GaussNodes::Entry& e, bool mirrored, std::vector<Ball>& c) { c.assign(1, exp(mirrored ? -e.z : e.z)); };
    const auto without = by_ellipse(f, 150, false, 700);
    long asked = 0;
    f.with_weight = [&](const GaussNodes::Entry& e, bool mirrored) -> std::optional<Ball> {
        if (++asked % 3 == 0) return std::nullopt; // now and then it cannot be had
        const Ball z = mirrored ? -e.z : e.z, u = (Ball(1) + z) / Ball(2), r = (Ball(1) - z) / Ball(2);
        return value_of(w, u, r) * exp(z);
    };
    const auto with = by_ellipse(f, 150, false, 700);
    REQUIRE(without);
    REQUIRE(with);
    CHECK(asked > 20);
    agree(with->value, without->value, 150);
    CHECK(with->nodes == without->nodes);
}

TEST_CASE("a factor of a logarithm that is 0 where one happens to look is not forgotten")
{
    struct Row {
        const char *formula, *from, *to, *value;
    };
    // 3/8 and 9/13 are fractions of the range at which it is asked which weights there are
    for (const Row& row :
         {Row{"log(x)+x-3/8", "0", "1", "-7/8"}, Row{"log(x)^2+8*x-3", "0", "1", "3"}, Row{"x*log(x)+3-8*x", "0", "1", "-5/4"},
          Row{"log(1/x)+8*x-3", "0", "1", "2"}, Row{"log(x)+log(1-x)+(8*x-3)^2", "0", "1", "13/3"},
          Row{"(log(x)+8*x-3)/sqrt(x*(1-x))", "0", "1", "pi-2*pi*log(2)"}, Row{"log(1-x)*(8*x-3)+log(x)", "0", "1", "-4"},
          Row{"(log(x)+3-8*x)*x^(1/3)", "0", "1", "-195/112"}, Row{"log((1+x)/(1-x))^2+4*x+1", "-1", "1", "2*pi^2/3+2"},
          Row{"(log(x)+5*x-3)/(1+x)^4", "0", "inf", "-2/3"}, Row{"log(x)+13*x-9", "0", "1", "-7/2"},
          Row{"(8*x-3)*(13*x-9)*log(x)+1", "0", "1", "-353/36"}, Row{"(8*x-3)*log(x)", "0", "1", "1"},
          Row{"(13*x-9)*(8*x-3)/sqrt(x*(1-x))", "0", "1", "21*pi/2"}}) {
        const Integral i = integral(row.formula, row.from, row.to, 25);
        CHECK_MESSAGE(i.status == Status::certified, std::string(row.formula), ": ", i.reason);
        const WorkingPrecision precision(120);
        CHECK_MESSAGE(i.value.overlaps(parse_limit(row.value).ball()), std::string(row.formula), " is not ", i.value.to_string(20));
    }
}

TEST_CASE("where one of several factors is not analytic on a box nothing is kept of the others")
{
    for (const char* formula : {"log(1-x)+log(x)*log(1+x)", "log(1-x)+log(x)*sqrt(x+1/100)", "log(1-x)+log(x)/(x^2+1/20)",
                                "log(x)^2+log(1-x)*log(1+x)", "log(x)^2+log(1-x)*log(1+x)+log(x)*log(1-x)*tan(x)"}) {
        IntegralOptions cut;
        cut.digits = 25;
        cut.at = {parse_limit("1/7")};
        const Integral whole = integral(formula, "0", "1", 25);
        const Integral in_parts = integrate(parse_expression(formula), parse_limit("0"), parse_limit("1"), cut);
        CHECK_MESSAGE(whole.status == Status::certified, std::string(formula), ": ", whole.reason);
        CHECK_MESSAGE(whole.value.overlaps(in_parts.value), std::string(formula));
    }
    // the first box gives one of two: the constant of the other is that of a box on which both are
    EllipseFunction f;
    f.weights = {SingularWeight{}, SingularWeight{0, 0, 1, 0}};
    int boxes = 0;
    f.in_plane = [&](const EllipseBox& box, std::vector<ComplexBall>& c) {
        c.assign({exp(box.z), ++boxes == 1 ? ComplexBall::indeterminate() : exp(box.z)});
    };
    f.at_node = [](const GaussNodes::Entry& e, bool mirrored, std::vector<Ball>& c) {
        const Ball z = mirrored ? -e.z : e.z;
        c.assign({exp(z), exp(z)});
    };
    const auto found = by_ellipse(f, 80, false, 700);
    REQUIRE(found);
    const WorkingPrecision precision(120);
    CHECK(arb_is_finite(found->bound.get()) != 0);
    CHECK(arb_lt(found->bound.get(), exp(Ball(30)).get()) != 0);
}

TEST_CASE("Chebyshev's nodes: cosines, with the sines and cosines of their angles, exact for polynomials below degree 2n and not at 2n")
{
    for (const auto& [n, bits] : {std::pair{1L, 64L}, {2L, 200L}, {7L, 128L}, {16L, 300L}, {801L, 1000L}}) {
        const WorkingPrecision precision(bits + 20);
        const auto nodes = GaussNodes::get(n, bits, GaussRule::chebyshev);
        const auto& entries = nodes->entries();
        REQUIRE(entries.size() == static_cast<std::size_t>((n + 1) / 2));
        for (std::size_t k = 0; k < entries.size(); ++k) {
            const GaussNodes::Entry& e = entries[k];
            Ball sine, cosine;
            const Ball angle = pi<Ball>() * Ball(static_cast<long>(2 * k + 1)) / Ball(4 * n); // of -z
            arb_sin_cos(cosine.get(), sine.get(), angle.get(), bits + 20);
            agree(e.sine, sine, bits - 4);
            agree(e.cosine, cosine, bits - 4);
            CHECK(e.z.overlaps(sine * sine - cosine * cosine));
            agree(e.z + Ball(1), Ball(2) * sine * sine, bits - 4);
            agree(e.weight, pi<Ball>() / Ball(n), bits - 4);
        }
        const auto sum_of_powers = [&](long k) { // of z^(2k)
            Ball sum(0);
            for (std::size_t l = 0; l < entries.size(); ++l) {
                const bool is_middle = n % 2 != 0 && l + 1 == entries.size();
                sum += entries[l].weight * analytic::integer_power(entries[l].z, 2 * k) * Ball(is_middle ? 1 : 2);
            }
            return sum;
        };
        const auto moment = [&](long k) { // pi (2k)!/(2^k k!)^2
            Ball m = pi<Ball>();
            for (long j = 1; j <= k; ++j) m *= Ball(2 * j - 1) / Ball(2 * j);
            return m;
        };
        agree(sum_of_powers(n - 1), moment(n - 1), bits - 24);
        if (n < 20) CHECK_FALSE(sum_of_powers(n).overlaps(moment(n)));
    }
}

TEST_CASE("beside Chebyshev's weight an ellipse bounds the function without the weight, even ones by half of it")
{
    const WorkingPrecision precision(250);
    EllipseFunction f;
    f.rule = GaussRule::chebyshev;
    f.in_plane = [](const EllipseBox& box, std::vector<ComplexBall>& c) { c.assign(1, ComplexBall(1) / (2 + box.z * box.z)); };
    f.at_node = [](const GaussNodes::Entry& e, bool, std::vector<Ball>& c) { c.assign(1, 1 / (2 + e.z * e.z)); };
    const Ball truth = pi<Ball>() / sqrt(Ball(6));
    const auto whole = by_ellipse(f, 150, false, 700);
    f.is_even = true;
    const auto half = by_ellipse(f, 150, false, 700);
    REQUIRE(whole);
    REQUIRE(half);
    for (const auto& found : {*whole, *half}) {
        agree(found.value, truth, 150);
        CHECK(std::exp(found.sigma) < std::sqrt(2.0) + std::sqrt(3.0)); // the poles at +-i sqrt(2)
        CHECK(std::exp(found.sigma) > 1.9);
    }
    CHECK(half->nodes < whole->nodes);
    CHECK_FALSE(by_ellipse(f, 150, false, 10)); // too few nodes
    // what is told of the integral of a formula is what is told of the rule, whose weight has pi for its integral
    const Integral typed = integral("1/((2+x^2)*sqrt(1-x^2))", "-1", "1", 45);
    const auto again = by_ellipse(f, 45 * 3.3219281 + 1, false, 380);
    REQUIRE(again);
    const std::string told = again->proof(Ball(1));
    CHECK(typed.parts.front().proof.substr(0, 20) == told.substr(0, 20)); // |f| <= ...
    CHECK(typed.parts.front().evaluations == again->nodes + again->pieces);
}

TEST_CASE("what is told of an ellipse's proof are its bounds, of the integral as it is scaled")
{
    const WorkingPrecision precision(200);
    EllipseFunction f;
    f.in_plane = [](const EllipseBox& box, std::vector<ComplexBall>& c) { c.assign(1, exp(box.z)); };
    f.at_node = [](const GaussNodes::Entry& e, bool mirrored, std::vector<Ball>& c) { c.assign(1, exp(mirrored ? -e.z : e.z)); };
    const auto found = by_ellipse(f, 100, false, 700);
    REQUIRE(found);
    CHECK(found->value.overlaps(exp(Ball(1)) - exp(Ball(-1))));
    CHECK(found->value.relative_bits() >= 100);
    CHECK(arb_le(radius_of(found->value).get(), (found->discretisation * Ball(2)).get()));
    const std::string text = found->proof(Ball(-1000));
    const auto scaled = [](const Ball& x) { return bound_text(x * Ball(1000)); };
    for (const std::string& part :
         {"|f| <= " + scaled(found->bound), "rho = " + std::to_string(std::exp(found->sigma)).substr(0, 4),
          "at most " + std::to_string(found->pieces) + " boxes", "|discretisation| <= " + scaled(found->discretisation),
          "rounding <= " + scaled(radius_of(found->value))})
        CHECK_MESSAGE(text.find(part) != std::string::npos, part, " is not in ", text);
}
