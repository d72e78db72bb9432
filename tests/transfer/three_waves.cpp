// SPDX-License-Identifier: MIT
#include "touchstone/transfer/three_waves.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/transfer/arc.hpp"
#include "touchstone/transfer/proven_levels.hpp"

#include <doctest/doctest.h>

#include <complex>
#include <numbers>

using namespace touchstone;
using transfer::density_after_three_waves;
using transfer::to_ball;

namespace {

Ball number(const char* text) { return Ball(*parse_rational(text)); }

} // namespace

namespace {

using transfer::Arc;

/// The arc with what it is made of, in binary64.
struct ArcAt {
    Arc::Kind kind;
    double G, x;
    Arc arc{kind, Ball::exactly(G), Ball::exactly(x)};
    /// By (2.10), (2.4): y of the cosine c of the angle, for any complex t.
    std::complex<double> ratio(std::complex<double> t) const
    {
        const std::complex<double> c = kind == Arc::Kind::from_bottom ? 2. * t * t - 1. : 1. - 2. * t * t;
        return kind == Arc::Kind::partial ? std::sqrt((1. + c) * (2 * x - 1 + c)) / G : (x + c) / G;
    }
    double end() const { return kind == Arc::Kind::partial ? std::sqrt(x) : std::sqrt(0.5); }
    /// theta/pi between two t
    static double between(double from, double to) { return 2 / std::numbers::pi * (std::asin(to) - std::asin(from)); }
};
const ArcAt arcs[] = {{Arc::Kind::from_top, 1.5, 1},
                      {Arc::Kind::from_bottom, 1.25, 3},
                      {Arc::Kind::partial, 1.5, 0.25}, {Arc::Kind::partial, 3, 0.9375}};
double middle(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }

} // namespace

TEST_CASE("an arc of a wave: the ratio, what it moves by on a disc, and the most of dtheta/dt there")
{
    const WorkingPrecision precision(200);
    for (const ArcAt& a : arcs)
        for (const double share : {0., 0.1, 0.5, 0.9, 0.99}) {
            const double t = share * a.end();
            CAPTURE(a.x);
            CAPTURE(t);
            CHECK(middle(a.arc.ratio(Ball::exactly(t))) == doctest::Approx(a.ratio(t).real()));
            for (double r = 0.4; r > 1e-4; r /= 3) {
                double moved = 0, weight = 0;
                for (int k = 0; k < 40; ++k) {
                    const std::complex<double> z = t + std::polar(r, std::numbers::pi * k / 20);
                    moved = std::max(moved, std::abs(a.ratio(z) - a.ratio(t)));
                    weight = std::max(weight, 2 / std::abs(std::numbers::pi * std::sqrt(1. - z * z)));
                }
                CAPTURE(r);
                CHECK(moved <= a.arc.moved(t, r));
                CHECK(weight <= Arc::weight_near(t, r));
                if (r > 0.01 * (a.end() - t)) continue;
                CHECK(a.arc.moved(t, r) <= 1.25 * moved);
                CHECK(Arc::weight_near(t, r) <= 1.05 * weight);
            }
            CHECK(middle(to_ball(Arc::weight(t))) == doctest::Approx(2 / (std::numbers::pi * std::sqrt(1 - t * t))));
        }
}

TEST_CASE("an arc of a wave: the share of the angle that an interval of ratios has at most")
{
    const WorkingPrecision precision(200);
    for (const ArcAt& a : arcs)
        for (const double from : {0., 1e-6, 0.1, 0.6, 0.9})
            for (const double length : {1e-9, 1e-3, 0.05}) {
                const double low = from * a.end(), high = std::min(from + length, 0.999999) * a.end();
                const double width = middle(abs(a.arc.ratio(Ball::exactly(high)) - a.arc.ratio(Ball::exactly(low))));
                CAPTURE(a.x);
                CAPTURE(low);
                CAPTURE(high);
                const double bound = a.arc.share(low, high, width), own = ArcAt::between(low, high);
                CHECK(own <= bound);
                if (from >= 0.1 && length <= 1e-3) CHECK(bound <= 1.1 * own);
                if (from == 0) CHECK(bound <= 3 * own); // next to the wave's end, by the root of the length
            }
}

namespace {

/// In partial contact, to twenty digits.
void is_that_of_the_forward_chain(const char* G_text, const char* P_text, const char* load_text)
{
    const WorkingPrecision precision(256);
    const Ball G = number(G_text), P = number(P_text), load = number(load_text);
    const auto p = [&] { return P * G * G; };
    const Ball known = transfer::density(transfer::Law::density, 2, p, {[&] { return load; }, [&] { return G; }}, Accuracy{24}) * G * G;
    const Ball own = density_after_three_waves(G, P, load, 1e-20).value;
    INFO("G ", G_text, " P ", P_text, " load ", load_text, ": ", own.to_string(), " ", known.to_string());
    CHECK(own.overlaps(known));
    CHECK(own.radius_bound() < 2e-20);
    CHECK(known.radius_bound() < 1e-22);
}

} // namespace

TEST_CASE("three waves in partial contact: the forward chain's density, to twenty digits")
{
    is_that_of_the_forward_chain("5/2", "1/4", "1/2");
}

TEST_CASE("three waves in partial contact: the forward chain's density at a low pressure and load 1")
{
    is_that_of_the_forward_chain("3", "1/100", "1");
}

TEST_CASE("three waves in partial contact: the forward chain's density at a high pressure")
{
    is_that_of_the_forward_chain("5/2", "3/5", "9/10");
}

TEST_CASE("three waves with full contact: a third route")
{
    const WorkingPrecision precision(256);
    const Ball G(2), own = density_after_three_waves(G, Ball(9) / 40, Ball(1), 1e-17).value / (G * G);
    INFO(own.to_string());
    CHECK(own.overlaps(number("0.02439282952663530310"))); // nested integrals, cut at singular points
    CHECK(own.radius_bound() < 1e-17);
}

TEST_CASE("three waves with full contact: the levels proven on a mesh")
{
    const WorkingPrecision precision(256);
    const Ball G = Ball(3) / 2, P = Ball(1) / 2;
    const auto levels = transfer::ProvenLevels::densities(G, P, 3, 1e-6, 1);
    for (const char* load : {"1/10", "1", "3", "2.640625"}) { // the last one's wave ends on a logarithm
        const Ball own = density_after_three_waves(G, P, number(load), 1e-12).value, known = levels.share(1, number(load));
        INFO("load ", load, ": ", own.to_string(), " ", known.to_string());
        CHECK(own.overlaps(known));
        CHECK(own.radius_bound() < 1e-12);
        CHECK(known.radius_bound() < 1e-5);
    }
}

namespace {

void coarse_holds_fine(const char* G, const char* P, std::initializer_list<const char*> loads)
{
    const WorkingPrecision precision(256);
    for (const char* load : loads) {
        const Ball coarse = density_after_three_waves(number(G), number(P), number(load), 1e-4).value;
        const Ball fine = density_after_three_waves(number(G), number(P), number(load), 1e-14).value;
        INFO("G ", G, " P ", P, " load ", load, ": ", coarse.to_string(), " ", fine.to_string());
        CHECK(coarse.overlaps(fine));
        CHECK(coarse.radius_bound() < 1e-4);
        CHECK(fine.radius_bound() < 1e-14);
    }
}

} // namespace

TEST_CASE("three waves: the tolerances there are, and the error that is told is the value's")
{
    const WorkingPrecision precision(160);
    const auto density = [](double tolerance) { return density_after_three_waves(Ball(3), Ball(1), Ball(1) / 2, tolerance); };
    for (const double tolerance : {1e-26, 1e-3, 0.0, 1.0}) CHECK_THROWS_AS(density(tolerance), std::invalid_argument);
    const auto found = density(1e-6);
    const auto at = found.certificate.find("within ");
    REQUIRE(at != std::string::npos);
    CHECK(std::stod(found.certificate.substr(at + 7)) / found.value.radius_bound() == doctest::Approx(1).epsilon(0.01));
}

TEST_CASE("three waves: what is claimed coarsely holds what is claimed finely, next to singular points too")
{
    coarse_holds_fine("3/2", "6/5", {"1.31", "1.31000000000000000000001"});
}

TEST_CASE("three waves: what is claimed coarsely holds what is claimed finely, where a wave's end and a jump meet")
{
    coarse_holds_fine("2", "1", {"1"});
}

TEST_CASE("three waves: what is claimed coarsely holds what is claimed finely, next to load 1")
{
    coarse_holds_fine("3/2", "1/2", {"0.999999999999999999999999999999"});
}

TEST_CASE("three waves: what is claimed coarsely holds what is claimed finely, far above load 1")
{
    coarse_holds_fine("21/20", "3", {"90"});
}

TEST_CASE("three waves: the finest tolerance that is offered ends, where a wave's end and a logarithm meet (G = 2, load 1)")
{
    const WorkingPrecision precision(256);
    const Ball own = density_after_three_waves(Ball(2), Ball(9) / 40, Ball(1), 1e-24).value,
               coarse = density_after_three_waves(Ball(2), Ball(9) / 40, Ball(1), 1e-10).value;
    INFO(own.to_string(), " ", coarse.to_string());
    CHECK(own.overlaps(coarse));
    CHECK(own.radius_bound() < 1e-23);
}

TEST_CASE("three waves: what cannot be had is refused")
{
    CHECK_THROWS_AS(density_after_three_waves(Ball(1), Ball(1), Ball(1), 1e-9), BeyondReach);
    CHECK_THROWS_AS(density_after_three_waves(Ball(2), Ball(0), Ball(1), 1e-9), BeyondReach);
    CHECK_THROWS_AS(density_after_three_waves(Ball(2), Ball(1), Ball(0), 1e-9), BeyondReach);
    Ball vague(1);
    arb_add_error_2exp_si(vague.get(), -60);
    CHECK_THROWS_AS(density_after_three_waves(Ball(2), Ball(1), vague, 1e-9), BeyondReach);
}
