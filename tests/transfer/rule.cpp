// SPDX-License-Identifier: MIT
/// The quadrature rules against closed forms: h = 1 averages to 1, and h = x^(s-1) to the hypergeometric
/// series of T[y^s]; the proven bounds must hold, and hold tightly.
#include "touchstone/transfer/rule.hpp"

#include "touchstone/scalar/refusal.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

using Traits = ScalarTraits<Ball>;

/// int (4/pi) sech^3 v (x/y)^(1/2) y^e dv by a rule; e = 1/2 is F = x^(1/2) h with h = 1.
Ball by_rule(const Rule& rule, const Ball& G, const Ball& x, const Ball& e)
{
    Ball sum(0);
    for (const auto& q : rule.nodes) {
        const Ball y = 2 / G * sqrt(x * (1 + (1 - x) * q.sinh_squared)) * q.sech_squared;
        sum += q.area_weight * q.sech_squared * sqrt(x / y) * pow(y, e);
    }
    return sum;
}

/// The same in closed form: with y = (2/G) x^(1/2) (1-u^2)^(1/2) (1-x u^2)^(1/2) and b = e - 1/2,
/// x^(1/2) (2/G)^b x^(b/2) (2/pi) B(1/2, (b+3)/2) 2F1(-b/2, 1/2; b/2 + 2; x).
Ball closed_form(const Ball& G, const Ball& x, const Ball& e)
{
    const Ball b = e - Traits::quotient(1, 2);
    Ball beta = Traits::gamma(Traits::quotient(1, 2)) * Traits::gamma((b + 3) / 2) / Traits::gamma(b / 2 + 2), series;
    arb_hypgeom_2f1(series.get(), (-b / 2).get(), Traits::quotient(1, 2).get(), (b / 2 + 2).get(), x.get(), 0, WorkingPrecision::bits());
    return sqrt(x) * pow(2 / G, b) * pow(x, b / 2) * 2 / Traits::pi() * beta * series;
}

} // namespace

TEST_CASE("both rules agree with closed forms within their proven bounds")
{
    const WorkingPrecision precision(300);
    for (const char* g : {"2.05", "2.25", "10", "1000"}) {
        const Ball G(*parse_rational(g));
        for (const double accuracy : {50.0, 120.0}) {
            const Ratios all{2 / G, false}, one{Ball(1), true}, near{Ball(*parse_rational("0.999")), true};
            for (const Ratios* ratios : {&all, &one, &near})
                for (const bool gauss : {false, true}) {
                    CAPTURE(g); CAPTURE(accuracy); CAPTURE(gauss); CAPTURE(ratios->highest);
                    const double V = cut_off(*ratios, accuracy);
                    const Rule rule = gauss ? gauss_panel_rule(G, *ratios, accuracy, V) : double_exponential_rule(G, *ratios, accuracy, V);
                    for (const char* part : {"1", "0.5", "0.01", "1e-9"}) {
                        const Ball x = ratios->single ? ratios->highest : ratios->highest * Ball(*parse_rational(part));
                        for (const char* exponent : {"0", "1/4", "1/2"}) { // |F| <= 1, the bounds' only assumption
                            const Ball e(*parse_rational(exponent));
                            const Ball off = abs(by_rule(rule, G, x, e) - closed_form(G, x, e));
                            const Ball bound = (rule.discretisation + rule.truncation) * sqrt(sqrt(x));
                            CHECK(certainly(less(off, bound)));
                            CHECK(certainly(less(bound, exp(Ball(-static_cast<long>(accuracy) + 10)))));
                        }
                    }
                }
        }
    }
}

TEST_CASE("the bounds are not idle: with F_0, singular at y = 1, errors come near them")
{
    const WorkingPrecision precision(400);
    for (const char* g : {"2.05", "3.2", "10"}) {
        const Ball G(*parse_rational(g));
        const Ratios all{2 / G, false};
        const Ball& x = all.highest;
        const auto apply = [&](const Rule& rule) { // F_0 = (2/pi) arcsin(sqrt y)/sqrt y
            Ball sum(0);
            for (const auto& q : rule.nodes) {
                const Ball y = 2 / G * sqrt(x * (1 + (1 - x) * q.sinh_squared)) * q.sech_squared;
                sum += q.area_weight * q.sech_squared * sqrt(x / y) * 2 * asin(sqrt(y)) / (sqrt(y) * Traits::pi());
            }
            return sum;
        };
        const double far = cut_off(all, 120); // no truncation worth the name
        const Ball reference = apply(gauss_panel_rule(G, all, 120, far));
        for (const bool gauss : {false, true}) {
            CAPTURE(g); CAPTURE(gauss);
            const Rule rule = gauss ? gauss_panel_rule(G, all, 30, far) : double_exponential_rule(G, all, 30, far);
            const Ball off = abs(apply(rule) - reference), bound = rule.discretisation * sqrt(sqrt(x));
            CHECK(certainly(less(off, bound)));
            CHECK(certainly(less(bound, off * 10'000'000)));
        }
    }
}

TEST_CASE("bounds of the chain hold at complex points, for every load ratio in the range")
{
    const WorkingPrecision precision(128);
    for (const char* g : {"2.25", "20"}) { // where ratios are small, 1 - x tanh^2 v is smallest next to i pi/2
        const Ball G(*parse_rational(g));
        const Ratios range{2 / G, false};
        for (int i = 0; i <= 12; ++i)
            for (int k = 0; k <= 14; ++k) {
                const ComplexBall v(Ball(i) / 4, Ball(k) / 9);
                const ChainBounds b = chain_bounds(v, G, range);
                const ComplexBall c = (exp(v) + exp(-v)) / 2, s = (exp(v) - exp(-v)) / 2;
                for (int j = 1; j <= 20; ++j) {
                    const Ball x = range.highest * Ball(j) / 20;
                    const Ball y = 2 / G * sqrt(x * abs(1 + ComplexBall(1 - x) * s * s)) / abs(c * c);
                    CHECK_FALSE(certainly(less(b.modulus, y)));
                    CHECK_FALSE(certainly(less(abs(1 - ComplexBall(x) * s * s / (c * c)), b.factor)));
                }
                CHECK(b.cosh_squared.overlaps(abs(c * c)));
                const ChainBounds alone = chain_bounds(v, G, {range.highest, true});
                CHECK_FALSE(certainly(less(abs(1 - ComplexBall(range.highest) * s * s / (c * c)), alone.factor)));
            }
    }
}

namespace {

double to_double(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }

/// (R2)/(c_m x^(1/4)) at v, in double: the largest over the ratios, of which some are looked at. `lost` is 1 - highest.
double integrand(std::complex<double> v, double G, double highest, double lost, bool single)
{
    const std::complex<double> cosh = std::cosh(v), square = 1.0 / (cosh * cosh); // 1 - tanh^2 v
    double least = HUGE_VAL;
    for (int k = single ? 256 : 0; k <= 256; ++k) {
        const double x = highest * k / 256;
        least = std::min(least, std::abs((k == 256 ? lost : 1 - x) + x * square));
    }
    return 4 / std::numbers::pi * std::sqrt(G / 2) / (std::pow(std::abs(cosh), 2.5) * std::sqrt(std::sqrt(least)));
}

struct Case {
    const char *G, *highest; ///< "" is 2/G
    bool single;
    Ball g() const { return Ball(*parse_rational(G)); }
    Ratios ratios() const { return {*highest ? Ball(*parse_rational(highest)) : 2 / g(), single}; }
    double at(std::complex<double> v) const
    {
        const Ratios r = ratios();
        return integrand(v, to_double(g()), to_double(r.highest), to_double(1 - r.highest), single);
    }
};

/// The integral of f over [from, to] by Simpson's rule.
template <class F>
double simpson(const F& f, double from, double to, int pieces)
{
    double sum = 0;
    const double h = (to - from) / (2 * pieces);
    for (int k = 0; k <= 2 * pieces; ++k) sum += (k == 0 || k == 2 * pieces ? 1 : k % 2 ? 4 : 2) * f(from + k * h);
    return sum * h / 3;
}

const std::vector<Case> cases{{"2.25", "", false}, {"10", "", false}, {"1000", "", false}, {"10", "0.9", false},
                              {"10", "0.9", true}, {"3", "1", true},  {"10", "1", true},   {"40", "0.99999", true}};

} // namespace

TEST_CASE("the trapezoid's bound is 2 J/(e^(2 pi d/h) - 1), J the integral of (R2) along the strip's edge, or little more")
{
    const WorkingPrecision precision(128);
    for (const Case& at : cases)
        for (const double d : {0.15, 0.4, 1.2}) {
            const double c = at.highest == std::string("0.99999") ? 0.2 : 0.8;
            const bool wide = to_double(at.g()) >= 10 && to_double(at.ratios().zeros()) < 0.5;
            if ((c == 0.2 && d > 0.15) || (d == 1.2 && !wide)) continue; // zeros or |y| = 1 are in the strip
            INFO(at.G, " ", at.highest); CAPTURE(d);
            const Rule rule = proven_double_exponential(at.g(), at.ratios(), 20, 12, c, d);
            const double h = std::asinh(to_double(rule.nodes[1].v) / c);
            const double J = simpson([&](double r) {
                const std::complex<double> v = c * std::sinh(std::complex<double>(r, d)), dv = c * std::cosh(std::complex<double>(r, d));
                return at.at(v) * std::abs(dv);
            }, 0, 4.5, 400);
            const double expected = 2 * J / std::expm1(2 * std::numbers::pi * d / h);
            CHECK(to_double(rule.discretisation) > expected);
            CHECK(to_double(rule.discretisation) < (d == 1.2 ? 1.8 : 1.2) * expected);
        }
}

TEST_CASE("a Gauss panel's bound is l (16/3) M rho^(-2n)/(1 - 1/rho), M the largest of (R2) on the ellipse, or little more")
{
    const WorkingPrecision precision(128);
    for (const Case& at : cases)
        for (const auto& [lo, hi, rho] :
             {std::tuple{0.0, 0.25, 2.5}, {0.0, 0.5, 1.5}, {0.75, 1.75, 1.5}, {4.0, 12.0, 1.1}, {6.0, 14.0, 2.2}}) {
            const bool even = lo == 0;
            const double mid = even ? 0 : (lo + hi) / 2, half = even ? hi : (hi - lo) / 2;
            const double major = half * (rho + 1 / rho) / 2, minor = half * (rho - 1 / rho) / 2;
            double M = 0;
            for (int k = 0; k <= 720; ++k) {
                const double phi = std::numbers::pi * k / 720;
                M = std::max(M, at.at({mid + major * std::cos(phi), minor * std::sin(phi)}));
            }
            for (const long n : {3L, 20L}) {
                INFO(at.G, " ", at.highest); CAPTURE(lo); CAPTURE(n);
                // the positive half of a rule of 2n points has half of its error
                const double decay = std::pow(rho, (even ? -4.0 : -2.0) * static_cast<double>(n));
                const double expected = half * 16 / 3 * M * decay / (1 - 1 / rho) / (even ? 2 : 1);
                const Ball middle = Ball::exactly(mid), length = Ball::exactly(half);
                const auto proven = [&] { return to_double(proven_panel_error(at.g(), at.ratios(), middle, length, rho, even, n)); };
                if (minor > std::numbers::pi / 2 && to_double(at.ratios().zeros()) > mid - major) {
                    CHECK_THROWS_AS(proven(), BeyondReach); // zeros at +-A + i pi/2 are in the ellipse
                    continue;
                }
                const double bound = proven();
                CHECK(bound > expected * (1 - 1e-9));
                CHECK(bound < (even ? 1.5 : 1.1) * expected);
            }
        }
}

TEST_CASE("beyond v = V, and along a strip's edge beyond Re v = alpha, the bound is the integral of (R2), or little more")
{
    const WorkingPrecision precision(128);
    for (const Case& at : cases) {
        INFO(at.G, " ", at.highest);
        for (const double least : {8.0, 14.0}) {
            const Rule rule = proven_double_exponential(at.g(), at.ratios(), 20, least, 0.2, 0.15);
            const double V = to_double(rule.nodes.back().v);
            const double left_out = simpson([&](double v) { return at.at(v); }, V, V + 20, 2000);
            CHECK(to_double(rule.truncation) > left_out * (1 - 1e-8)); // what is left out beyond V + 20 is less
            CHECK(to_double(rule.truncation) < 1.05 * left_out);
        }
        // along any strip (R2) is at most this over cos d, with coth for tanh and sinh for cosh; or e^(u/2) for |1 - tanh^2|^(-1/4)
        const double G = to_double(at.g()), x = to_double(at.ratios().highest);
        if (const double alpha = 1; at.ratios().at_one() || x < 0.5) {
            const double any = simpson([&](double u) {
                const double sh = std::sinh(u), coth = std::cosh(u) / sh;
                const double factor = at.ratios().at_one() ? std::exp(u / 2) : std::pow(1 - x * coth * coth, -0.25);
                return 4 / std::numbers::pi * std::sqrt(G / 2) * std::pow(sh, -2.5) * factor;
            }, alpha, alpha + 20, 2000) / std::cos(0.5);
            const double bound = to_double(beyond_on_strip(at.g(), at.ratios(), Ball::exactly(alpha), Ball::exactly(0.5)));
            CHECK(bound > any);
            CHECK(bound < 1.3 * any);
        }
        const bool light = at.ratios().highest.overlaps(2 / at.g());
        for (const double alpha : {light ? 3.0 : 9.0, 12.0})
            for (const double d : {0.2, 0.9}) {
                CAPTURE(alpha); CAPTURE(d);
                // (R2) at Re v = u, over u, and |dv/du| is at most 1/cos d
                const double c = 0.5, left_out = simpson([&](double u) {
                    const double r = std::asinh(u / (c * std::cos(d)));
                    const double longer = std::abs(std::cosh(std::complex<double>(r, d))) / (std::cosh(r) * std::cos(d));
                    return at.at({u, c * std::cosh(r) * std::sin(d)}) * longer;
                }, alpha, alpha + 20, 2000);
                const double bound = to_double(beyond_on_strip(at.g(), at.ratios(), Ball::exactly(alpha), Ball::exactly(d)));
                CHECK(bound > left_out);
                CHECK(bound < (at.ratios().at_one() ? 1.45 : 1.04) * left_out);
            }
    }
}

TEST_CASE("a strip or an ellipse that reaches a zero or |y| = 1 proves nothing")
{
    const WorkingPrecision precision(128);
    const auto strip = [](const Case& at, double c, double d, double V = 12) {
        return proven_double_exponential(at.g(), at.ratios(), 300, V, c, d);
    };
    // c sin d = pi/2 +- 0.5%, where x = 1 has no other zeros and G is so large that |y| < 1 in boxes next to the zero of cosh v
    const Case one{"1e9", "1", true};
    const double d = 0.5, c = std::numbers::pi / 2 / std::sin(d);
    CHECK_THROWS_AS(strip(one, 1.005 * c, d), BeyondReach);
    CHECK(strip(one, 0.97 * c, d).discretisation.is_finite());
    // the zeros A + i pi/2
    const Case heavy{"1000", "0.9999", true};
    const double A = to_double(heavy.ratios().zeros());
    CHECK(A == doctest::Approx(std::acosh(1 / std::sqrt(1e-4))));
    // (pi/2)^2/(c sin d)^2 - A^2/(c cos d)^2 = 1
    const double e = 0.15, edge = std::sqrt(std::pow(std::numbers::pi / 2 / std::sin(e), 2) - std::pow(A / std::cos(e), 2));
    CHECK_THROWS_AS(strip(heavy, 1.01 * edge, e), BeyondReach);
    CHECK(strip(heavy, 0.97 * edge, e).discretisation.is_finite());
    // |y| = (2/G)/cos^2 beta at v = i beta, where x = 1
    const Case three{"3", "1", true};
    const double beta = std::acos(std::sqrt(2.0 / 3));
    CHECK_THROWS_AS(strip(three, 1.01 * beta / std::sin(d), d), BeyondReach);
    CHECK(strip(three, 0.98 * beta / std::sin(d), d).discretisation.is_finite());
    // beyond Re v = alpha, |y|^2 <= (4/G^2) x (1 + x coth^2 alpha)/sinh^2 alpha
    for (const Case& at : {three, Case{"2.05", "0.1", true}}) {
        const double G = to_double(at.g()), x = to_double(at.ratios().highest);
        const auto y_squared = [&](double alpha) {
            return 4 / (G * G) * x * (1 + x / std::pow(std::tanh(alpha), 2)) / std::pow(std::sinh(alpha), 2);
        };
        double alpha = 0.01;
        while (y_squared(alpha) > 1) alpha *= 1.001;
        const auto bound = [&](double from) { return beyond_on_strip(at.g(), at.ratios(), Ball::exactly(from), Ball::exactly(0.5)); };
        CHECK_FALSE(bound(0.99 * alpha).is_finite());
        CHECK(bound(1.01 * alpha).is_finite());
    }
    // sums beyond the last node: 2 V tanh V > 1 from V = 0.7717 on
    CHECK_THROWS_AS(strip({"10", "", false}, 0.5, 0.5, 0.76), BeyondReach);
    CHECK(strip({"10", "", false}, 0.5, 0.5, 0.79).discretisation.is_finite());
}
