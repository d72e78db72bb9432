// SPDX-License-Identifier: MIT
/// The area for load > 1, against integrals nested by hand, the partial-contact routes, and what is exact.
#include "touchstone/transfer/heavy_load.hpp"
#include "touchstone/transfer/heavy_load_panels.hpp"

#include "touchstone/catalogue/evaluate.hpp"

#include <doctest/doctest.h>

#include <complex>
#include <initializer_list>
#include <numbers>
#include <tuple>

using namespace touchstone;
using namespace touchstone::transfer;
using namespace touchstone::transfer::heavy_load;

namespace {

/// What the precision of these balls is meant for.
Accuracy wanted() { return {accuracy_of(WorkingPrecision::bits()).digits + 1}; }

using Traits = ScalarTraits<Ball>;
constexpr slong bits = 56 + 64; // about 19 digits

Rational exactly(const char* text) { return *parse_rational(text); }

Arguments at(const char* load, const char* G)
{
    return {[load] { return Ball(exactly(load)); }, [G] { return Ball(exactly(G)); }};
}

Ball first_area(const Ball& x) { return certainly(less(x, Ball(1))) ? 2 / Traits::pi() * asin(sqrt(x)) : Ball(1); }

/// n = 1, 2 as midpoint sums over the angles (periodic and analytic while no ratio reaches 1 on its way), (F1) twice.
Ball nested(long n, const Ball& x, const Ball& G, long points)
{
    if (n == 0) return first_area(x);
    Ball sum(0);
    for (long i = 0; i < points; ++i) sum += nested(n - 1, (x + Traits::cos_pi(Ball(2 * i + 1) / Ball(2 * points))) / G, G, points);
    return sum / Ball(points);
}

bool near(const Ball& a, const Ball& b, const char* within) { return certainly(less(abs(a - b), Ball(exactly(within)))); }

} // namespace

TEST_CASE("two grids, two schemes, one area, and tight balls")
{
    const WorkingPrecision precision(bits);
    for (const auto& [load, G, n] : {std::tuple{"10", "4", 20L}, {"1.5", "16", 3L}, {"100", "12", 1L}}) {
        CAPTURE(load);
        CAPTURE(G);
        CAPTURE(n);
        const Ball a = area_at_heavy_load(Scheme::force_weighted, n, at(load, G), wanted()),
                   b = area_at_heavy_load(Scheme::area, n, at(load, G), wanted());
        CHECK(a.overlaps(b));
        CHECK(a.relative_bits() > 62);
        CHECK(b.relative_bits() > 62);
    }
}

TEST_CASE("slow: nested by hand, n = 1 and 2, to 19 digits" * doctest::skip()) // to fewer digits below
{
    const WorkingPrecision precision(bits);
    // x_1 in (0.31, 0.94) of 16: load 10, all of scale 1 below 1, nothing singular on the way
    const Ball one = area_at_heavy_load(Scheme::force_weighted, 1, at("10", "16"), wanted());
    CHECK(near(one, nested(1, Ball(10), Ball(16), 80), "1e-19"));
    const Ball two = area_at_heavy_load(Scheme::force_weighted, 2, at("10", "4"), wanted());
    CHECK(near(two, nested(2, Ball(10), Ball(4), 80), "1e-17"));
    // ratio 1, a point of S, is crossed: mpmath's quad over the last angle, split where the ratio is 1, midpoint sum over the first
    CHECK(near(area_at_heavy_load(Scheme::area, 1, at("1.5", "2.2"), wanted()), Ball(exactly("0.65525095502097439462")), "2e-19"));
}

TEST_CASE("slow: nested, n = 2, where a ratio of 1 is crossed" * doctest::skip())
{
    const WorkingPrecision precision(bits);
    CHECK(near(area_at_heavy_load(Scheme::force_weighted, 2, at("10", "3.2"), wanted()), Ball(exactly("0.8447896421110701457823348")),
               "2e-19"));
}

TEST_CASE("load -> 1 from above meets the partial-contact route, no faster than Lemma 4 allows")
{
    const WorkingPrecision precision(bits);
    for (const long n : {1L, 5L}) {
        const Ball below = area(Scheme::force_weighted, n, at("1", "4"), wanted());
        for (const char* beyond : {"1.0000000001", "1.0001"}) {
            CAPTURE(n); CAPTURE(beyond);
            const Ball rise = area_at_heavy_load(Scheme::force_weighted, n, at(beyond, "4"), wanted()) - below;
            CHECK_FALSE(certainly(less(rise, Ball(0))));
            CHECK(certainly(less(rise, sqrt((Ball(exactly(beyond)) - 1) / pow(Ball(4), Ball(n))))));
        }
    }
}

TEST_CASE("areas increase with the load")
{
    const WorkingPrecision precision(bits);
    for (const long n : {2L, 10L}) {
        Ball last = area(Scheme::force_weighted, n, at("1", "16"), wanted());
        for (const char* load : {"1.5", "5", "10"}) {
            const Ball a = area_at_heavy_load(Scheme::force_weighted, n, at(load, "16"), wanted());
            CHECK(certainly(less(last, a)));
            last = a;
        }
    }
}

TEST_CASE("full contact everywhere is exact, to the last load that keeps it; then it is certified")
{
    const auto eval = [](const char* name, std::map<std::string, Rational> in) {
        return evaluate(*find_quantity(name), Inputs(std::move(in)), {.digits = 17});
    };
    for (const char* G : {"4", "1.5"}) { // 1 + G + G^2
        const Rational g = exactly(G), load = 1 + g + g * g;
        CHECK(eval("contact.area", {{"n", 2}, {"load", load}, {"G", g}}).status == Status::exact);
        CHECK(eval("contact.area", {{"n", 2}, {"load", load}, {"G", g}}).value == "1");
        CHECK(eval("contact.area", {{"n", 0}, {"load", 1}, {"G", g}}).status == Status::exact);
    }
    CHECK(eval("segments.count", {{"n", 2}, {"load", 5}, {"D", exactly("1.5")}, {"gamma", 16}}).value == "256");
    const auto e = eval("contact.area", {{"n", 1}, {"load", exactly("16.9")}, {"G", 16}});
    CHECK(e.status == Status::certified);
    CHECK(e.value < "1");
}

namespace {

void check_same_G(long n, long digits)
{
    const auto eval = [n, digits](const char* D, long gamma) {
        return evaluate(*find_quantity("contact.area"), Inputs({{"n", n}, {"load", 10}, {"D", exactly(D)}, {"gamma", gamma}}),
                        {.digits = digits});
    };
    const auto a = eval("1.5", 16), b = eval("1.25", 256);
    CHECK(a.status == Status::certified);
    CHECK(a.value == b.value);
}

} // namespace

TEST_CASE("(1.5, 16) and (1.25, 256) give the same area, digit for digit") { check_same_G(2, 6); }
TEST_CASE("slow: (1.5, 16) and (1.25, 256) give the same area, digit for digit, to 17 digits" * doctest::skip()) { check_same_G(3, 17); }

TEST_CASE("panels too narrow for binary64 numbers are refused")
{
    CHECK(heavy_load_has_panels(100, Ball(1000)));
    CHECK(heavy_load_has_panels(140, Ball(5000))); // e^-(44 + 2 + 8.5) 5000^-70, some 10^-283
    CHECK_FALSE(heavy_load_has_panels(141, Ball(5000))); // as 160
    CHECK_FALSE(heavy_load_has_panels(150, Ball(10000)));
    const Arguments a{[] { return Ball(2); }, [] { return Ball(10000); }};
    CHECK_THROWS_WITH_AS(area_at_heavy_load(Scheme::area, 150, a, {15}),
                         "for load > 1 panels about G^(-n/2) wide would be needed, too narrow for binary64 numbers", BeyondReach);
}

TEST_CASE("out of reach is said")
{
    CHECK_THROWS_AS(area_at_heavy_load(Scheme::area, 1, at("10", "2"), wanted()), std::runtime_error);
    CHECK_THROWS_AS(area_at_heavy_load(Scheme::area, 1, at("1", "4"), wanted()), std::runtime_error);
    CHECK_THROWS_AS(area_at_heavy_load(Scheme::area, 1, at("1e6", "4"), wanted()), std::runtime_error);
}

TEST_CASE("the size of B_m: Q and M are those of Lemma 3, one step and two steps above 1")
{
    const WorkingPrecision precision(bits);
    for (const auto& [G_text, c_text] : {std::tuple{"4", "1.5"}, {"2.2", "1.25"}}) {
        const Ball G(exactly(G_text)), c(exactly(c_text));
        const auto is = [](const Ball& found, const Ball& expected) { // upper ends of 30 bits
            CHECK(certainly(less(expected * Ball(exactly("0.999999999")), found)));
            CHECK(certainly(less(found, expected * Ball(exactly("1.00000001")))));
        };
        const auto disc = [](const Ball& X) { return 2 / Traits::pi() * sqrt(X); };
        for (const char* X : {"0.3", "1"}) {
            is(largest_real(Ball(exactly(X)), G, c), c);
            is(largest_in_disc(Ball(exactly(X)), G, c), c);
        }
        // (1 + once)/G < 1; 1 < (1 + twice)/G, whose successor is below 1
        const Ball once = (1 + G - 1) / 2, twice = G - Ball(exactly("0.9"));
        is(largest_real(once, G, c), G * c);
        is(largest_in_disc(once, G, c), G * c * (1 + disc(once)));
        const Ball then = (twice + 1) / G;
        is(largest_real(twice, G, c), G * G * c);
        is(largest_in_disc(twice, G, c), G * G * c + disc(twice) * G * (G * c * (1 + disc(then))));
    }
}

TEST_CASE("the size of B_m below 1 is at most its limit, and not much more than level 64 has")
{
    const WorkingPrecision precision(bits);
    for (const char* G : {"2.1", "16", "1000"}) {
        const Ball limit = largest_size(Ball(exactly(G)));
        for (const long level : {0L, 1L, 64L, 100L}) CHECK(is_below(magnitudes(Ball(exactly(G)), level).back(), limit));
        CHECK(is_below(limit, magnitudes(Ball(exactly(G)), 64).back() * Ball(exactly("1.000000002"))));
    }
}

TEST_CASE("what is dropped next to 0 in partial contact is at least what the kernel has there, and next to G = 2, x = 1 not much more")
{
    for (const double G : {2.1, 4., 16.})
        for (const double beneath : {1e-9, 0.01})
            for (const double start : {1e-6, 0.05 / G}) {
                const double x = 1 - beneath;
                double sum = 0;
                for (int i = 0; i < 400; ++i) {
                    const double y = (i + 0.5) / 400 * start, R = std::hypot(beneath, G * y);
                    const double kernel = G * G * y / (2 * std::numbers::pi) / (R * std::sqrt(x - G * G * y * y / 4));
                    sum += std::sqrt(y) * kernel * std::sqrt((1 + x + R) / (beneath + R));
                }
                sum *= start / 400;
                CHECK(sum <= dropped_below(G, start));
                CHECK(is_dropped_below(G, x, start));
                if (G == 2.1 && beneath == 1e-9) CHECK(sum >= 0.9 * dropped_below(G, start));
            }
    // the wave, 2 x^(1/2)/G wide, must be much wider than what is dropped
    CHECK(is_dropped_below(1000, 0.0021, 7.9e-6));
    CHECK_FALSE(is_dropped_below(1000, 0.0021, 8.0e-6));
    CHECK(is_dropped_below(4, 1, 0.0224));
    CHECK_FALSE(is_dropped_below(4, 1, 0.0226));
}

TEST_CASE("distances between balls, and the room there is between them for certain")
{
    const WorkingPrecision precision(bits);
    Ball wide(3);
    mag_set_d(arb_radref(wide.get()), 0.125);
    CHECK(transfer::heavy_load::distance(Ball(1), Ball(3)) == 2);
    CHECK(transfer::heavy_load::distance(Ball(3), Ball(1)) == 0);
    CHECK(room_between(Ball(1), Ball(3)) < 2);
    CHECK(room_between(Ball(1), Ball(3)) > 1.99);
    CHECK(room_between(Ball(1), wide) < 1.875);
    CHECK(room_between(Ball(1), wide) > 1.87);
    CHECK(room_to_one(Ball(exactly("0.5"))) < 0.5);
    CHECK(room_to_one(Ball(exactly("0.5"))) > 0.49);
    const Piece piece{Ball(2), Ball(3), 1, 1, 0.25, 0.5, {}, {}};
    CHECK_FALSE(is_below(piece.farthest(), Ball(exactly("3.5"))));
    CHECK(is_below(piece.farthest(), Ball(exactly("3.6"))));
}

TEST_CASE("an ellipse about a panel is in its disc up to where it would reach the end that the panels shrink to")
{
    for (const double ratio : {2., 4., 6.}) {
        const double major = (ratio + 1) / (ratio - 1), most = major + std::sqrt(major * major - 1);
        CHECK((Shape{ratio, 0.97 * most}.stays_in_disc()));
        CHECK_FALSE((Shape{ratio, most}.stays_in_disc()));
    }
}

TEST_CASE("the singular points up to the largest ratio and beyond it, each in its bracket, and none twice")
{
    const WorkingPrecision precision(bits);
    const auto are = [](const char* load, const char* G, std::initializer_list<const char*> expected) {
        CAPTURE(load);
        const std::vector<Bracket> found = singular_points(Ball(exactly(load)), Ball(exactly(G)));
        REQUIRE(found.size() >= expected.size());
        std::size_t i = 0;
        for (const char* text : expected) {
            CAPTURE(text);
            const Ball s(exactly(text)), within(exactly("1e-20"));
            CHECK_FALSE(is_below(s, found[i].lo));
            CHECK_FALSE(is_below(found[i].hi, s));
            CHECK(is_below(found[i].hi - found[i].lo, within));
            ++i;
        }
        for (i = 1; i < found.size(); ++i) CHECK(is_below(found[i - 1].hi, found[i].lo));
    };
    are("10", "4", {"0", "1", "3", "5", "11", "13", "19", "21"});
    are("2", "2.5", {"0", "1", "1.5", "2.75", "3.5", "4.75", "5.875", "7.75", "7.875", "9.75"});
    are("1.5", "3", {"0", "1", "2", "4", "5", "7", "11"});
    const Ball G = 1 + sqrt(Ball(3)); // G (G - 1) - 1 = G + 1: one bracket, which holds them both
    const std::vector<Bracket> found = singular_points(Ball(2), G);
    REQUIRE(found.size() > 4);
    for (const Ball& s : {G + 1, G * (G - 1) - 1}) {
        CHECK_FALSE(is_below(below(s), found[3].lo));
        CHECK_FALSE(is_below(found[3].hi, above(s)));
    }
    CHECK(is_below(found[3].hi, G * (G - 1) + 1));
    CHECK(is_below(G - 1, found[3].lo));
}

TEST_CASE("a wave is cut at the singular points inside it, and goes on beyond an end only where none is there")
{
    const WorkingPrecision precision(bits);
    const auto at = [](const char* x) { return Bracket{below(Ball(exactly(x))), above(Ball(exactly(x)))}; };
    const std::vector<Bracket> S{at("0"), at("0.5"), at("1"), at("2"), at("3"), at("7")};
    const auto cuts = [&](const char* lo, const char* hi) { return cuts_between(Ball(exactly(lo)), Ball(exactly(hi)), S); };
    const auto is_at = [](const Bracket& b, const char* x) {
        return !is_below(Ball(exactly(x)), b.lo) && !is_below(b.hi, Ball(exactly(x)));
    };
    const Cuts open = cuts("1.5", "3.5");
    REQUIRE(open.at.size() == 4);
    CHECK(is_at(open.at[0], "1.5"));
    CHECK(is_at(open.at[1], "2"));
    CHECK(is_at(open.at[2], "3"));
    CHECK(is_at(open.at[3], "3.5"));
    CHECK(open.room_lo == doctest::Approx(0.4995).scale(0));
    CHECK(open.room_hi == doctest::Approx(3.4965).scale(0));
    const Cuts low = cuts("1", "2.5"); // the wave begins at a singular point
    REQUIRE(low.at.size() == 3);
    CHECK(is_at(low.at[0], "1"));
    CHECK(low.room_lo == 0);
    CHECK(low.room_hi == doctest::Approx(0.4995).scale(0));
    const Cuts high = cuts("0.7", "2"); // and ends at one
    REQUIRE(high.at.size() == 3);
    CHECK(is_at(high.at[2], "2"));
    CHECK(high.room_lo == doctest::Approx(0.1998).scale(0));
    CHECK(high.room_hi == 0);
    // what cannot be told apart from an end lies in its bracket
    Ball wide = Ball(exactly("2.99"));
    mag_set_d(arb_radref(wide.get()), 0.02);
    const Cuts unclear = cuts_between(Ball(exactly("1.1")), wide, S);
    REQUIRE(unclear.at.size() == 3);
    CHECK(is_at(unclear.at[2], "3"));
    CHECK(unclear.room_hi == 0);
    const Cuts beyond = cuts("8", "9");
    CHECK(beyond.at.size() == 2);
    CHECK(beyond.room_lo == doctest::Approx(0.999).scale(0));
}

TEST_CASE("the bounds of rules and of interpolation are the sums over the Chebyshev polynomials that they miss")
{
    for (const double rho : {1.5, 2.3, 2.9})
        for (const long n : {1L, 2L, 7L}) {
            double rule = 0, interpolation = 0;
            for (long k = 200; k >= 2 * n; --k) rule += 3 * 2 * 7 * std::pow(rho, -static_cast<double>(k)) * (2 + 2 / 3.);
            for (long k = 200; k >= n; --k) interpolation += 2 * 2 * std::pow(rho, -static_cast<double>(k));
            CHECK(gauss_error(3, 7, rho, n) >= rule);
            CHECK(gauss_error(3, 7, rho, n) <= 1.00001 * rule);
            CHECK(interpolation_error(n, rho) >= interpolation);
            CHECK(interpolation_error(n, rho) <= 1.00001 * interpolation);
        }
}

TEST_CASE("what a weight's and its place's radii and the roundings can do is counted")
{
    // a slope of 1/((rho + 1/rho)/2 - 1) at most, rho 2.3 or 2.9; p moments that enter twice
    for (const double weight : {0.1, 30.}) {
        CHECK(entry_error(weight, 0, 0x1p-20, 9) >= weight * 0x1p-20 / ((2.3 + 1 / 2.3) / 2 - 1));
        CHECK(entry_error(weight, 0, 0x1p-20, 9) <= 101 * weight * 0x1p-20);
    }
    CHECK(entry_error(3, 0x1p-20, 0, 9) >= 2 * 9 * 0x1p-20);
    CHECK(entry_error(3, 0x1p-20, 0, 9) <= 3 * 9 * 0x1p-20);
    for (const long p : {2L, 3L, 20L, 200L})
        for (const auto& [entered, terms] : {std::tuple{1., 1.}, {1., 1000.}, {100., 10.}}) {
            double units = 0;
            for (long k = 0; k < p; ++k)
                units += 2 * (static_cast<double>(k * k) * entered + static_cast<double>(k * (k + 1) / 2 + 1) * terms);
            CHECK(rounding_error(entered, terms, p, 0x1p-48) >= units * 0x1p-48);
            CHECK(rounding_error(entered, terms, p, 0x1p-48) <= 8 * units * 0x1p-48);
        }
}

namespace {

using Complex = std::complex<double>;

/// The largest |f| on the ellipse of parameter rho about [a, b].
template <class F>
double largest_on_ellipse(double a, double b, double rho, F f)
{
    double most = 0;
    for (int i = 0; i < 200; ++i) {
        const Complex z = std::polar(rho, 2 * std::numbers::pi * i / 200);
        most = std::max(most, std::abs(f((a + b) / 2 + (b - a) / 2 * (z + 1. / z) / 2.)));
    }
    return most;
}

} // namespace

TEST_CASE("the kernels are within their bounds, on the real line and on the ellipses, and reach them next to an end")
{
    const double x = 3, G = 4, lo = (x - 1) / G, hi = (x + 1) / G;
    const auto full = [&](Complex y) { return 1. / (std::numbers::pi * std::sqrt((hi - y) * (y - lo))); };
    for (const double y : {lo + 1e-9, lo + 0.1, hi - 0.2}) {
        CHECK(std::abs(full(y)) <= full_kernel_bound(y - lo, hi - y));
        CHECK(full_kernel_bound(y - lo, hi - y) <= 1.00001 * std::abs(full(y)));
    }
    for (const double near_one : {1e-13, 1e-9, 0.1, 0.5}) {
        const double u = 1 - near_one, end = 2 * std::sqrt(u) / G;
        const auto partial = [&](Complex y) {
            const Complex R = std::sqrt(near_one * near_one + G * G * y * y);
            return G * G * y / (2 * std::numbers::pi) / (R * std::sqrt(u - G * G * y * y / 4.)) * std::sqrt((1 + u + R) / (near_one + R));
        };
        const auto bound = [&](double right, double from_high, double largest) {
            return partial_kernel_bound(G, std::sqrt(u), right, from_high, largest);
        };
        for (const double y : {1e-8, 1e-7, 0.01, 0.2, end - 0.01, end - 1e-9}) CHECK(std::abs(partial(y)) <= bound(y, end - y, y));
        // as x^(-1/4), all else being equal: x - G^2 y^2/4 >= (G/2) x^(1/2) times the distance from the end
        CHECK(partial_kernel_bound(G, 1. / 16, 0.1, 0.2, 0.3) == doctest::Approx(4 * partial_kernel_bound(G, 1, 0.1, 0.2, 0.3)).scale(0));
        if (near_one == 1e-9)
            for (const double y : {1e-7, 1e-6}) CHECK(bound(y, end - y, y) <= (1.00001 + 0.02 * y / 1e-6) * std::abs(partial(y)));
        for (const double v : {1e-4, 0.1}) { // at the ends, in v
            CHECK(2 * v * std::abs(full(lo + v * v)) <= full_kernel_end_bound(hi - lo - v * v));
            CHECK(full_kernel_end_bound(hi - lo - v * v) <= 1.00001 * 2 * v * std::abs(full(lo + v * v)));
            CHECK(2 * v * std::abs(partial(end - v * v)) <= partial_kernel_end_bound(G, std::sqrt(u), end - v * v, end));
            const double far = 0.2 * end;
            CHECK(2 * std::sqrt(end - far) * std::abs(partial(far)) <= partial_kernel_end_bound(G, std::sqrt(u), far, far));
            CHECK(partial_kernel_end_bound(G, std::sqrt(u), end - v * v, end) <= 3 * 2 * v * std::abs(partial(end - v * v)));
        }
        for (const double rho : {2.3, 2.9})
            for (const double a : {1e-5, 1e-3, 0.05}) {
                const double b = 4 * a, reach = (b - a) / 2 * (rho + 1 / rho) / 2, left = (a + b) / 2 - reach, right = (a + b) / 2 + reach;
                CHECK(largest_on_ellipse(a, b, rho, partial) <= bound(left, end - right, right));
                CHECK(largest_on_ellipse(lo + a, lo + b, rho, full) <= full_kernel_bound(left, hi - lo - right));
                CHECK(largest_on_ellipse(hi - b, hi - a, rho, full) <= full_kernel_bound(hi - lo - right, left));
            }
    }
}

namespace {

auto cosines_of()
{
    return [kept = std::map<long, std::vector<Ball>>{}](long p) mutable -> const std::vector<Ball>& { return kept[p] = cosines(p); };
}

} // namespace

TEST_CASE("a measure on a grid: sums of what is analytic on the ellipses stay within what is lost, at edges and beyond ends too")
{
    const WorkingPrecision precision(300);
    const auto keep = cosines_of();
    const Ball lo(2), hi(exactly("3.5"));
    for (const Shape& shape : {Shape{4, 2.9}, Shape{6, 2.3}})
        for (const double wanted : {5., 40.})
            for (const char* pole : {"1.9", "3.7"}) {
                const auto f = [&](const Ball& y) { return 1 / (y - Ball(exactly(pole))); };
                Grid grid(lo, hi, shape, 1e-3, wanted, Ball(10), FixedFormat(40)); // 48 bits: roundings are seen
                const double depth = static_cast<double>(grid.g.depth), finest = 0.75 * std::pow(shape.ratio, -depth);
                Ball sum(0);
                double entered = 0, held = 0;
                const auto enter = [&](const Ball& y, const Ball& w) {
                    grid.enter(y, w);
                    sum += w * f(y);
                    entered += approximate(w);
                };
                enter(Ball(exactly("2.75")), Ball(1));
                for (long k = 0; k <= grid.g.depth; ++k) // panels' edges, and next to them
                    for (const double off : {-1e-3, 0., 1e-3}) {
                        const Ball d = grid.g.reach * grid.g.power(-k) * (1 + Ball::exactly(off));
                        if (k == grid.g.depth && off < 0) continue;
                        enter(lo + d, Ball(exactly("0.25")));
                        enter(hi - d, Ball(exactly("0.125")));
                    }
                for (int i = 1; i < 60; ++i) enter(lo + (hi - lo) * Ball(i) / Ball(60), Ball(exactly("0.01")));
                CHECK(grid.held < 1e-20);
                CHECK(grid.terms == 1 + 60 - 1 + 2 * (3 * depth + 2));
                Ball found(0), mass(0);
                for (const Node& v : grid.as_nodes(keep)) {
                    found += v.weight * f(v.x);
                    mass += v.weight;
                    CHECK(is_below(lo, v.x));
                    CHECK(is_below(v.x, hi));
                }
                const double lost = grid.lost();
                CHECK(is_below(abs(found - sum), Ball::exactly(lost)));
                CHECK(is_below(abs(mass - Ball::exactly(entered)), Ball::exactly(grid.terms * 0x1p-40)));
                const double rounded = rounding_error(entered, grid.terms, grid.most_points, 0x1p-48);
                CHECK(lost >= 10 * (entered * interpolation_error(grid.most_points, shape.rho) + rounded));
                CHECK(lost < 10 * (std::exp(-wanted) * entered * 3 + 1e-6));
                // what is nearer to an end than the panels is taken at their last edge
                const Ball near(exactly("1e-9")), low = lo + Ball::exactly(finest), high = hi - Ball::exactly(finest);
                for (const auto& [y, edge] : {std::tuple{lo + near, low}, {hi - near, high}, {lo, low}, {hi, high}}) {
                    grid.enter(y, Ball(2));
                    sum += 2 * f(edge);
                    held += 2 * std::sqrt(std::fabs(approximate(edge - y)));
                }
                CHECK(grid.held == doctest::Approx(held).scale(0).epsilon(1e-6));
                CHECK(grid.held >= held * (1 - 1e-12));
                found = Ball(0);
                for (const Node& v : grid.as_nodes(keep)) found += v.weight * f(v.x);
                CHECK(is_below(abs(found - sum), Ball::exactly(grid.lost() + 1e-11)));
                // radii are counted, and places that are not known are refused
                const double before = grid.lost();
                Ball loose(exactly("0.5"));
                mag_set_d(arb_radref(loose.get()), 0x1p-20);
                grid.enter(Ball(exactly("2.5")), loose);
                CHECK(grid.lost() >= before + 10 * 2 * static_cast<double>(grid.most_points - 1) * 0x1p-20);
                Ball wide(exactly("2.5"));
                mag_set_d(arb_radref(wide.get()), 0x1p-90);
                CHECK_THROWS_AS(grid.enter(wide, Ball(1)), std::runtime_error);
            }
}

TEST_CASE("a measure on a grid: what a panel's points interpolate exactly is summed exactly, to the last moment")
{
    const WorkingPrecision precision(300);
    Grid grid(Ball(2), Ball(3), Shape{4, 2.9}, 1e-3, 5, Ball(1), FixedFormat(100));
    const Panel panel = grid.left.at(1);
    const auto f = [&](const Ball& y) { // T_(p-1) of the panel
        const Ball t = (y - panel.mid) / panel.half;
        Ball before(1), now = t;
        for (long k = 2; k < panel.points; ++k) {
            const Ball next = 2 * t * now - before;
            before = now;
            now = next;
        }
        return now;
    };
    const Ball y = panel.mid + panel.half * Ball(exactly("0.3"));
    grid.enter(y, Ball(1));
    Ball found(0);
    for (const Node& v : grid.as_nodes(cosines_of())) found += v.weight * f(v.x);
    CHECK(is_below(abs(found - f(y)), Ball(exactly("1e-25"))));
    CHECK_FALSE(is_below(abs(f(y)), Ball(exactly("0.1"))));
}

TEST_CASE("a piece's integral: stretches side by side, each with the ellipse that its rule's error is for")
{
    const WorkingPrecision precision(bits);
    struct Stretch {
        bool at_end;
        double low, other, largest, error; // what the kernel's bound and the error were asked and noted for
        long nodes = 0;
        double length = 0, moment = 0;
    };
    const double a = 2, b = 3.5;
    const auto too_little = [](const Shape& shape) { return 0.75 * shape.beyond() * 0.995; };
    for (const Shape& shape : {Shape{4, 2.9}, Shape{6, 2.3}})
        // the last: the first stretch of either side reaches a little farther than there is room
        for (const auto& [room_a, room_b] :
             {std::tuple{0., 0.}, {0.05, 0.}, {0., 0.3}, {5., 0.001}, {too_little(shape), too_little(shape)}}) {
            CAPTURE(room_a); CAPTURE(room_b);
            const double A = (shape.rho + 1 / shape.rho) / 2, most = 3;
            std::vector<Stretch> stretches;
            std::map<long, Gauss> made_rules;
            const auto rules = [&](long n) -> const Gauss& {
                Gauss& rule = made_rules[n];
                if (rule.root.empty())
                    for (long k = 0; k < n; ++k) {
                        Ball root, weight;
                        arb_hypgeom_legendre_p_ui_root(root.get(), weight.get(), static_cast<ulong>(n), static_cast<ulong>(k), bits);
                        rule.root.push_back(root);
                        rule.weight.push_back(weight);
                    }
                return rule;
            };
            Piece piece{Ball(2), Ball(exactly("3.5")), 1e-6, 1e-4, room_a, room_b, {}, {}};
            integrate(
                piece, shape, most, rules,
                [&](const Ball& y, const Ball& share) {
                    Stretch& s = stretches.back();
                    ++s.nodes;
                    s.length += approximate(share);
                    s.moment += approximate(share) * approximate(y);
                },
                [&](double error) { stretches.back().error = error; }, [](const Ball&) { return Ball(1); },
                [&](double from_a, double from_b, double largest) {
                    stretches.push_back({false, from_a, from_b, largest, 0});
                    return 7.;
                },
                [&](bool, const Ball&) { return Ball(2); }, // of (distance from the end)^(-1/2): 2 l^(1/2) in all, a mean distance of l/3
                [&](bool left, double reach, double other) {
                    stretches.push_back({true, left ? 1. : 0., other, reach, 0});
                    return 7.;
                });
            const auto is = [](double found, double expected) { CHECK(found == doctest::Approx(expected).scale(0).epsilon(1e-9)); };
            double covered = 0;
            for (Stretch& s : stretches) {
                const double mean = s.moment / s.length;
                if (s.at_end) s.length *= s.length / 4;
                covered += s.length;
                if (s.at_end) { // from the end, l long, in v up to l^(1/2)
                    CHECK(s.length * (A - 1) / 2 < (s.low == 1 ? room_a : room_b));
                    is(s.largest, s.length * (A + 1) / 2);
                    is(s.other, b - a - s.length * (A + 1) / 2);
                    is(s.error, gauss_error(std::sqrt(s.length), most * 7, std::sqrt(shape.rho), 2 * s.nodes));
                    is(mean, s.low == 1 ? a + s.length / 3 : b - s.length / 3);
                } else {
                    const double mid = mean, half = s.length / 2;
                    is(s.low, mid - half * A - a);
                    is(s.other, b - mid - half * A);
                    is(s.largest, mid + half * A);
                    is(s.error, gauss_error(half, most * 7, shape.rho, s.nodes));
                }
            }
            is(covered, approximate(piece.to - piece.from));
            if (room_a > 0) CHECK(arb_equal(piece.from.get(), piece.a.get()));
            else {
                const long depth = graded(piece.a, piece.b, shape.ratio, 1e-4).depth;
                CHECK(piece.from.overlaps(piece.a + Ball::exactly(0.75) * pow(Ball::exactly(shape.ratio), Ball(-depth))));
            }
            if (room_b > 0) CHECK(arb_equal(piece.to.get(), piece.b.get()));
            else CHECK(is_below(piece.b - piece.to, Ball::exactly(1e-4)));
        }
}

namespace {

/// An area of few digits is proven, its ball is as narrow as asked for, holds the value near its middle, and the errors noted.
void is_area_of_few_digits(Scheme scheme, long n, const Arguments& a, double accuracy, const Ball& expected)
{
    CAPTURE(n);
    CAPTURE(accuracy);
    const Made found = made(scheme, n, a, accuracy, 5);
    const double radius = found.area.radius_bound();
    CHECK(radius < 0.1 * std::exp(-accuracy));
    CHECK(is_below(abs(found.area - expected), Ball::exactly(radius * (1 + 0.03)))); // the radius, and the middle's distance
    const double G = approximate(a.G());
    double noted = 0;
    for (const auto& [level, e] : found.errors)
        if (level <= n) noted += e * std::pow(G, static_cast<double>(level - n));
    for (const auto& [level, e] : found.moved)
        if (level <= n) noted += e * std::pow(G, static_cast<double>(level - n) / 2);
    CHECK(radius >= noted * (1 + 1e-7)); // summed up with roundings
    CHECK(noted > 0);
    for (const auto* by_level : {&found.errors, &found.moved}) // nothing is left of the load itself, at level 0
        for (const auto& [level, e] : *by_level) CHECK((e == 0 || level > 0));
}

} // namespace

TEST_CASE("few digits: load 10, G = 16, nothing singular on the way")
{
    const WorkingPrecision precision(bits);
    for (const Scheme scheme : {Scheme::force_weighted, Scheme::area})
        for (const double accuracy : {1., 8.})
            is_area_of_few_digits(scheme, 1, at("10", "16"), accuracy, nested(1, Ball(10), Ball(16), 80));
    const Made none = made(Scheme::force_weighted, 0, at("10", "16"), 1, 5);
    CHECK(arb_is_one(none.area.get()));
    CHECK(none.errors.rbegin()->first == 2); // scale 1 is below 1, in part above 2/G; scale 2 below 2/G
    CHECK(none.moved.rbegin()->first == 2);
}

TEST_CASE("few digits: two scales, load 10, G = 4, nested by hand")
{
    const WorkingPrecision precision(bits);
    is_area_of_few_digits(Scheme::force_weighted, 2, at("10", "4"), 8, nested(2, Ball(10), Ball(4), 80));
}

TEST_CASE("few digits: load 1.5, G = 2.2, across ratio 1")
{
    const WorkingPrecision precision(bits);
    for (const Scheme scheme : {Scheme::force_weighted, Scheme::area})
        for (const double accuracy : {1., 8.})
            is_area_of_few_digits(scheme, 1, at("1.5", "2.2"), accuracy, Ball(exactly("0.65525095502097439462")));
}

TEST_CASE("few digits: two scales, load 1.5, G = 2.2, through ratios in (2/G, 1)")
{
    const WorkingPrecision precision(bits);
    // mpmath's quad of (C2) and (F1) over the angles, split where the ratio is 1
    for (const double accuracy : {1., 8.})
        is_area_of_few_digits(Scheme::force_weighted, 2, at("1.5", "2.2"), accuracy, Ball(exactly("0.3141139115834798")));
}

TEST_CASE("few digits: two scales, load 10, G = 3.2, across ratio 1")
{
    const WorkingPrecision precision(bits);
    const Ball expected(exactly("0.8447896421110701457823348"));
    for (const double accuracy : {1., 5.}) is_area_of_few_digits(Scheme::force_weighted, 2, at("10", "3.2"), accuracy, expected);
}

TEST_CASE("few digits: where an end of the wave is a singular point, two grids have one area")
{
    const WorkingPrecision precision(bits);
    for (const char* load : {"3", "5"}) { // G - 1, G + 1
        CAPTURE(load);
        const Made a = made(Scheme::force_weighted, 2, at(load, "4"), 12, 5), b = made(Scheme::area, 2, at(load, "4"), 8, 5);
        CHECK(a.area.overlaps(b.area));
        CHECK(a.area.radius_bound() < std::exp(-12));
        CHECK(b.area.radius_bound() < std::exp(-8));
    }
}

TEST_CASE("few digits: no jump next to such a load, where the room at the wave's end is less than the last panel (Lemma 4)")
{
    const WorkingPrecision precision(bits);
    for (const auto& [load, beside] : {std::tuple{"3", "3.00001"}, {"3", "2.99999"}, {"5", "5.00001"}, {"5", "4.99999"}}) {
        CAPTURE(beside);
        const Made a = made(Scheme::force_weighted, 2, at(load, "4"), 3, 5), b = made(Scheme::force_weighted, 2, at(beside, "4"), 3, 5);
        CHECK(std::fabs(approximate(a.area - b.area)) < 0.001);
    }
}

TEST_CASE("many digits: nothing is lost to a fixed precision of the places")
{
    const WorkingPrecision precision(256);
    is_area_of_few_digits(Scheme::force_weighted, 1, at("10", "16"), 80, nested(1, Ball(10), Ball(16), 200));
}
