// SPDX-License-Identifier: MIT
/// B_0, the first level of what is proven level by level: its values beside their definitions, and its bounds on discs beside complex
/// ratios.
#include "touchstone/transfer/level_zero.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

using namespace touchstone;
using namespace touchstone::transfer;
using namespace touchstone::transfer::levels;

namespace {

using Complex = std::complex<double>;
constexpr double pi_ = std::numbers::pi;
constexpr double pressures[] = {0.1, 0.5, 1.3, 1.9, 2.0, 2.5, 5.0};

doctest::Approx nearly(double v, double off = 2e-3) { return doctest::Approx(v).scale(0).epsilon(off); }
std::pair<double, double> ends(double P) { return {P < 2 ? P * P / 4 : P - 1, P + 1}; }

/// The angle up to which one wave's pressure is above P, and the force there, by definition.
double angle_above(double x, double P)
{
    const double c = x >= 1 ? P - x : std::sqrt((1 - x) * (1 - x) + P * P) - x;
    return std::acos(std::clamp(c, -1., 1.));
}
double force_by_parts(double x, double P)
{
    const double end = angle_above(x, P);
    constexpr int parts = 2000;
    double sum = 0;
    for (int k = 0; k <= parts; ++k) {
        const double c = std::cos(end * k / parts), pressure = x >= 1 ? x + c : std::sqrt(std::max(0., (1 + c) * (2 * x - 1 + c)));
        sum += pressure * (k == 0 || k == parts ? 1 : k % 2 ? 4 : 2);
    }
    return sum * end / (3 * parts * pi_);
}

/// The functions that B_0 is on a disc, continued.
Complex in_contact_at(Complex x) { return 2 / pi_ * std::asin(std::sqrt(x)); }
Complex above_at(Complex x, double P, bool full) { return std::acos(full ? P - x : std::sqrt((1. - x) * (1. - x) + P * P) - x) / pi_; }
Complex force_at(Complex x, double P, bool full)
{
    if (full) {
        const Complex theta = std::acos(P - x);
        return (x * theta + std::sin(theta)) / pi_;
    }
    const Complex R = std::sqrt((1. - x) * (1. - x) + P * P), v = (4. * x - P * P) / (2. * x * (1. + x + R)), psi = std::asin(std::sqrt(v));
    return 2. * x / pi_ * (psi + std::sin(psi) * std::cos(psi));
}

/// The largest radius that a disc about x is allowed.
double largest_radius(const First& first, double x)
{
    double low = 0, high = 8;
    for (int k = 0; k < 60; ++k) {
        const double r = (low + high) / 2;
        const auto bounds_there = first.on_disc(Real(x), Real(x), Real(x), r);
        (bounds_there.value < bounds::infinite ? low : high) = r;
    }
    return low;
}

/// The largest |f| and |1 - f| on the circle.
std::array<double, 2> most_on(double x, double r, const std::function<Complex(Complex)>& f)
{
    std::array<double, 2> most{};
    for (int k = 0; k < 64; ++k) {
        const Complex v = f(x + std::polar(r, k * pi_ / 32));
        most = {std::max(most[0], std::abs(v)), std::max(most[1], std::abs(1. - v))};
    }
    return most;
}

Ball exact(const Real& x)
{
    const WorkingPrecision precision(400);
    return Ball::exactly(x.high) + Ball::exactly(x.low);
}
Ball clamped(const Ball& c) { return at_least(at_most(c, Ball(1)), Ball(-1)); }

void close_to(const First& first, const Real& x, const Ball& known)
{
    const auto [value, error] = first.value(x);
    const Ball off = abs(exact(value) - known);
    INFO("x = ", double(x), ": ", double(value), ", known ", known.to_string(), ", error ", error);
    REQUIRE(off.radius_bound() < 1e-36);
    CHECK_FALSE(certainly(less(Ball::exactly(error), off)));
    CHECK(error <= 2.01 * bounds::u * std::max(1.0, std::fabs(double(value))));
    CHECK(error >= 1.99 * bounds::u * std::max(1.0, std::fabs(double(value))));
}

} // namespace

TEST_CASE("the share of one wave in contact, and above a pressure: to all bits of 106")
{
    const auto contact = in_contact();
    CHECK(contact->is_area());
    CHECK(contact->is_share());
    for (const double x : {1e-30, 0.01, 0.3, 0.999, 1 - 0x1p-52, 1.0, 1.5, 7.0}) {
        const Real at = x < 1 ? Real(x) + Real(x * 0x1p-60) : Real(x);
        const WorkingPrecision precision(300);
        close_to(*contact, at, x < 1 ? 2 * asin(sqrt(exact(at))) / pi<Ball>() : Ball(1));
        for (const double P : pressures) {
            const auto above = exceeding(Ball::exactly(P));
            CHECK_FALSE(above->is_area());
            for (const double v : {x, ends(P).first, 1.01 * ends(P).first, ends(P).second, 0.99 * ends(P).second, 1.01 * ends(P).second}) {
                CAPTURE(P);
                const Ball y = Ball::exactly(v), p = Ball::exactly(P);
                const Ball c = v >= 1 ? p - y : sqrt((1 - y) * (1 - y) + p * p) - y;
                if (v < ends(P).first) CHECK(double(above->value(Real(v)).first) == 0);
                else if (std::fabs(v - ends(P).first) > 1e-9 && std::fabs(v - ends(P).second) > 1e-9)
                    close_to(*above, Real(v), acos(clamped(c)) / pi<Ball>());
                else CHECK(std::fabs(double(above->value(Real(v)).first) - angle_above(v, P) / pi_) < 1e-7);
            }
        }
    }
}

TEST_CASE("the force that one wave carries above a pressure is the mean of the pressures there")
{
    for (const double P : pressures) {
        const auto force = force_above(Ball::exactly(P));
        CAPTURE(P);
        for (const double x : {0.001, 0.1, 0.3, 0.5, 0.7, 0.95, 1.0, 1.2, 1.5, 1.9, 2.5, 4.0, 5.5, 7.0}) {
            CAPTURE(x);
            const auto [value, error] = force->value(Real(x));
            CHECK(double(value) == doctest::Approx(force_by_parts(x, P)).scale(1).epsilon(1e-9));
            CHECK(error >= 1.99 * bounds::u * std::max(1., x >= ends(P).second ? x : 0));
            CHECK(error < 1e-28);
            if (x < ends(P).first) CHECK(double(value) == 0);
            if (x >= ends(P).second) CHECK(double(value) == x);
        }
        const double next = std::nextafter(1., 0.), before = double(force->value(Real(next)).first),
            at_one = double(force->value(Real(1)).first);
        CHECK(before == doctest::Approx(at_one).scale(1).epsilon(1e-7));
    }
}

TEST_CASE("a share of contact is bounded on discs that meet neither 0 nor 1")
{
    const auto contact = in_contact();
    for (const double x : {0.01, 0.3, 0.5, 0.6, 0.99}) {
        const double most = largest_radius(*contact, x);
        CAPTURE(x);
        CHECK(most == nearly(std::min(x, 1 - x)));
        CHECK(most < std::min(x, 1 - x));
        for (const double r : {most, most / 3}) {
            const auto [value, complement] = contact->on_disc(Real(x), Real(x), Real(x), r);
            const auto known = most_on(x, r, in_contact_at);
            CHECK(value >= known[0]);
            CHECK(complement >= known[1]);
            CHECK(value == nearly(std::sqrt(x + r)));
            CHECK(complement == nearly(4 / pi_ * std::sqrt(1 - x + r)));
        }
    }
    for (const double low : {1.0, 1.5}) {
        const auto [value, complement] = contact->on_disc(Real(low), Real(2), Real(1.75), 0.5);
        CHECK(value == 1);
        CHECK(complement == 0);
    }
    CHECK(contact->on_disc(Real(0.999), Real(0.9999), Real(0.9995), 1).value == bounds::infinite);
    CHECK(contact->on_disc(Real(0.999), Real(0.9999), Real(0.9995), 1).complement == bounds::infinite);
}

TEST_CASE("what is above a pressure is bounded on discs on which it is analytic, and on no others")
{
    for (const double P : pressures) {
        const auto above = exceeding(Ball::exactly(P)), force = force_above(Ball::exactly(P));
        const auto [first, last] = ends(P);
        for (const double t : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 0.999}) {
            const double x = first + (last - first) * t;
            if (std::fabs(x - 1) < 1e-3) continue;
            const bool full = x > 1;
            CAPTURE(P);
            CAPTURE(x);
            const double may = full ? std::min(x - first, last - x) : std::min({x - first, x, std::hypot(1 - x, P)}),
                most = largest_radius(*above, x);
            CHECK(most == nearly(may));
            CHECK(most < may);
            CHECK(largest_radius(*force, x) == nearly(most, 1e-6));
            for (const double r : {0.999999 * most, most / 3, most / 100}) {
                const auto at = above->on_disc(Real(x), Real(x), Real(x), r);
                const auto known = most_on(x, r, [&](Complex v) { return above_at(v, P, full); });
                CHECK(at.value >= known[0]);
                CHECK(at.complement >= known[1]);
                const auto near_end = [](double from_one) { return from_one <= 1 ? 2 * std::sqrt(from_one) : bounds::infinite; };
                const double w = full ? std::fabs(P - x) + r : 1 - x + P + x + 2 * r, either = std::hypot(pi_, std::log(2 * w + 2));
                const double low_end = full ? x + 1 - P + r : 4 * (x - first + r), high_end = full ? last - x + r : 2;
                if (std::fabs(low_end - 1) > 2e-3) CHECK(at.value == nearly(std::min(either, near_end(low_end)) / pi_, 3e-3));
                if (std::fabs(high_end - 1) > 2e-3) CHECK(at.complement == nearly(std::min(either, near_end(high_end)) / pi_, 3e-3));
                const auto of_force = force->on_disc(Real(x), Real(x), Real(x), r);
                CHECK(of_force.value >= most_on(x, r, [&](Complex v) { return force_at(v, P, full); })[0]);
                CHECK(of_force.complement == bounds::infinite);
                const double v = 2 + P * P / (2 * (x - bounds::margin * r));
                const double bound = full ? ((x + r) * either + 1 + w) / pi_
                    : 2 * (x + r) / pi_ * (std::hypot(pi_ / 2, std::log(2 * std::sqrt(v) + 2)) + std::sqrt(v * (1 + v)));
                CHECK(of_force.value == nearly(bound, 5e-3));
                CHECK(of_force.value >= bound);
            }
            const auto beyond = force->on_disc(Real(x), Real(x), Real(x), 1.01 * most);
            CHECK(beyond.value == bounds::infinite);
            CHECK(beyond.complement == bounds::infinite);
        }
        // on either side of where it rises it is constant, or the force itself, however large the disc
        const auto on = [](const First& f, double low, double high) { return f.on_disc(Real(low), Real(high), Real((low + high) / 2),
            0.25); };
        CHECK(on(*above, 0.5 * first, first * (1 - 1e-15)).value == 0);
        CHECK(on(*above, 0.5 * first, first * (1 - 1e-15)).complement == 1);
        CHECK(on(*above, last * (1 + 1e-15), 2 * last).value == 1);
        CHECK(on(*above, last * (1 + 1e-15), 2 * last).complement == 0);
        CHECK(on(*force, 0.5 * first, first * (1 - 1e-15)).value == 0);
        CHECK(on(*force, last * (1 + 1e-15), 2 * last).value == nearly(last * (3 + 1e-15) / 2 + 0.25));
        CHECK(on(*force, last * (1 + 1e-15), 2 * last).value >= last * 1.5 + 0.25);
        for (const First* f : {above.get(), force.get()}) {
            CHECK(on(*f, 0.5 * first, first).value == bounds::infinite);
            CHECK(on(*f, last * (1 - 1e-15), 2 * last).value == bounds::infinite);
            CHECK(f->on_disc(Real(0.999), Real(1.001), Real(0.9995), 1e-9).value == (first > 1.001 ? 0 : bounds::infinite));
                // two functions
        }
    }
}

TEST_CASE("within two roundings of where a pressure's share rises or is all, neither is known")
{
    for (const auto& f : {exceeding(Ball::exactly(2.5)), force_above(Ball::exactly(2.5))}) { // from 1.5 to 3.5
        const auto on = [&](const Real& low, const Real& high) { return f->on_disc(low, high, (low + high) * 0.5, 0.25).value; };
        constexpr double u = bounds::u;
        CHECK(on(Real(1.25), Real(1.5) * Real{1, 2 * u}) == bounds::infinite);
        CHECK(on(Real(1.25), Real(1.5) * Real{1, -2 * u}) == bounds::infinite);
        CHECK(on(Real(1.25), Real(1.5) * Real{1, -8 * u}) == 0);
        CHECK(on(Real(3.5) * Real{1, -2 * u}, Real(4)) == bounds::infinite);
        CHECK(on(Real(3.5) * Real{1, 2 * u}, Real(4)) == bounds::infinite);
        CHECK(on(Real(3.5) * Real{1, 8 * u}, Real(4)) < 5);
    }
}

TEST_CASE("where a pressure's share rises, and the images where the density after two waves is singular")
{
    for (const double P : pressures) {
        const auto [low, high] = ends_of_exceeding(Ball::exactly(P));
        CHECK(double(to_real(low)) == nearly(ends(P).first, 1e-14));
        CHECK(double(to_real(high)) == nearly(ends(P).second, 1e-14));
    }
    const auto points = [](double G, double P) {
        std::vector<double> found;
        for (const Ball& s : singular_points_of_density(Ball::exactly(G), Ball::exactly(P))) found.push_back(double(to_real(s)));
        std::sort(found.begin(), found.end());
        return found;
    };
    const auto images = [](double G, double P) { // (x - 1)/G = s, and (x + 1)/G = s or 2 x^(1/2)/G = s
        std::vector<double> known;
        for (const double s : {ends(P).first, ends(P).second}) {
            known.push_back(G * s + 1);
            known.push_back(G * s - 1 >= 1 ? G * s - 1 : G * G * s * s / 4);
        }
        std::sort(known.begin(), known.end());
        return known;
    };
    for (const double G : {1.25, 1.5, 3.0})
        for (const double P : pressures) {
            const std::vector<double> found = points(G, P), known = images(G, P);
            REQUIRE(found.size() == known.size());
            for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == nearly(known[i], 1e-14));
        }
}

TEST_CASE("a density in a unit: values, errors and bounds are in it")
{
    const WorkingPrecision precision(384);
    const Ball G(Rational(3, 2)), P(Rational(1, 2));
    const Density density(G, P, 0.25, 1e-9);
    const TwoWaves waves(G, P, 0.25e-9);
    CHECK_FALSE(density.is_share());
    const Real x(2), low(1.99), high(2.01);
    CHECK(double(density.value(x).first) == nearly(4 * double(waves.value(x).first), 1e-12));
    CHECK(density.value(x).second == nearly(4 * waves.value(x).second, 1e-9));
    CHECK(density.on_disc(low, high, x, 0.011).value == nearly(4 * waves.on_disc(low, high, x, 0.011), 1e-9));
    CHECK(density.on_disc(low, high, x, 0.011).complement == bounds::infinite);
    CHECK(density.weight_on(2, 0.1, 7) == nearly(4 * waves.weight_on(2, 0.1) + 7, 1e-9));
}
