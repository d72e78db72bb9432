// SPDX-License-Identifier: MIT
/// Gap, mean gap and energy: the derivation in gap.hpp against the contact problem itself, and the forms
/// against one another.
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/oracle/error.hpp"
#include "touchstone/paper/gap.hpp"
#include "touchstone/paper/westergaard.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

using namespace touchstone;

namespace {

constexpr double pi_ = std::numbers::pi;

/// The contact problem without any formula of ours but the pressure (2.4): its Fourier coefficients by the
/// midpoint rule in phi (sin(pi x) = sqrt(S) sin(phi), p dx = (2S/pi) cos^2 phi dphi, smooth and periodic, so the
/// rule converges geometrically), the displacement as their sum.
class Solved {
public:
    explicit Solved(double load)
    {
        constexpr int nodes = 20000;
        std::vector<double> x, weight;
        for (int i = 0; i < nodes; ++i) {
            const double phi = pi_ * ((i + 0.5) / nodes - 0.5);
            x.push_back(std::asin(std::sqrt(load) * std::sin(phi)) / pi_);
            weight.push_back(2 * load / nodes * std::cos(phi) * std::cos(phi));
        }
        for (int j = 0; j <= 800; ++j) {
            double p = 0;
            for (int i = 0; i < nodes; ++i)
                p += weight[static_cast<std::size_t>(i)] * std::cos(2 * pi_ * j * x[static_cast<std::size_t>(i)]);
            coefficients_.push_back(j == 0 ? p : 2 * p);
        }
    }
    double mean_pressure() const { return coefficients_[0]; }
    double displacement(double x) const
    {
        double u = 0;
        for (std::size_t j = 1; j < coefficients_.size(); ++j)
            u += coefficients_[j] / static_cast<double>(j) * std::cos(2 * pi_ * static_cast<double>(j) * x);
        return u;
    }
    double mean_gap() const { return 1 - displacement(0); }
    double gap(double x) const { return displacement(x) - std::cos(2 * pi_ * x) + mean_gap(); }
    double energy() const
    {
        double sum = 0;
        for (std::size_t j = 1; j < coefficients_.size(); ++j) sum += coefficients_[j] * coefficients_[j] / static_cast<double>(j);
        return sum / 4;
    }

private:
    std::vector<double> coefficients_;
};

Ball exact(double x) { return Ball::exactly(x); }

} // namespace

TEST_CASE("the formulas solve the contact problem")
{
    for (const double load : {0.05, 0.3, 0.8}) {
        CAPTURE(load);
        const Solved contact(load);
        const double a = westergaard::half_width(load);
        CHECK(std::fabs(contact.mean_pressure() - load) < 1e-12); // (2.4) carries the load
        for (const double part : {0.1, 0.5, 0.95}) CHECK(std::fabs(contact.gap(part * a)) < 2e-5); // closed in the contact
        for (const double part : {0.05, 0.3, 1.0}) {
            const double x = a + part * (0.5 - a);
            CHECK(contact.gap(x) == doctest::Approx(westergaard::gap(x, load)).epsilon(0).scale(1).epsilon(2e-5));
        }
        CHECK(std::fabs(contact.mean_gap() - westergaard::mean_gap(load)) < 2e-5);
        CHECK(std::fabs(contact.energy() - westergaard::energy(load)) < 1e-7);
    }
}

TEST_CASE("closed form and series agree as balls, and are tight")
{
    const WorkingPrecision precision(200);
    for (const double load : {1e-300, 1e-6, 0.1, 0.5, 0.9, 1 - 0x1p-30})
        for (const double x : {0.5, 0.4999, 0.3, 0.26}) {
            const Ball v = sin_pi(exact(x));
            if (!certainly(less(exact(load), v * v))) continue;
            const Ball h = westergaard::gap(exact(x), exact(load));
            CHECK(h.overlaps(westergaard::gap_closed_form(exact(x), exact(load))));
            CHECK(h.relative_bits() > 150);
        }
    for (const double load : {1e-300, 0.2, 0.25, 0.3, 0.9, 1 - 0x1p-53}) {
        const Ball s = exact(load);
        const Ball c = westergaard::mean_gap(s);
        CHECK(c.overlaps(1 - s + s * log(s)));
        CHECK(c.relative_bits() > 150);
    }
}

TEST_CASE("limits, symmetry, and the seams")
{
    CHECK(westergaard::gap(0.5, 1e-300) == doctest::Approx(2).epsilon(1e-15)); // no load: the wave itself, valley to peak
    CHECK(westergaard::gap(0.25, 0.5) < 1e-15);
    CHECK(westergaard::gap(0.1, 0.5) == 0);
    CHECK(westergaard::gap(0.5, 1.0) == 0);
    CHECK(westergaard::gap(0.3, 7.0) == 0);
    CHECK(westergaard::gap(-0.4, 0.3) == westergaard::gap(0.4, 0.3));
    CHECK(westergaard::mean_gap(1.0) == 0);
    CHECK(westergaard::mean_gap(1.5) == 0);
    CHECK(westergaard::mean_gap(5e-324) == 1);
    CHECK(westergaard::energy(1.0) == 0.25);
    CHECK(westergaard::energy(3.0) == 0.25);
    CHECK(hertz::gap(0.01, 1e-5) == doctest::Approx(westergaard::gap(0.01, 1e-5)).scale(0).epsilon(1e-3));
    // a ball across the seams encloses both sides
    const WorkingPrecision precision(100);
    const Inputs seam = Inputs({{"load", Rational(1, 4)}}).box({{"load", Rational(1, 1000)}});
    const Ball c = westergaard::mean_gap(seam.ball("load"));
    for (const double s : {0.2491, 0.25, 0.2509}) CHECK(c.contains(westergaard::mean_gap(exact(s))));
}

TEST_CASE("both certified routes agree to 60 digits where it is hard")
{
    for (const auto& [name, values] : std::vector<std::pair<std::string, std::map<std::string, std::string>>>{
             {"westergaard.gap", {{"x", "0x1.0000000000001p-2"}, {"load", "1/2"}}},
             {"westergaard.gap", {{"x", "1/2"}, {"load", "0x1.fffffffffffffp-1"}}},
             {"westergaard.gap", {{"x", "0x1p-40"}, {"load", "1e-300"}}},
             {"hertz.gap", {{"x", "3"}, {"load", "1e-6"}}},
             {"westergaard.mean_gap", {{"load", "0x1.fffffffffffffp-1"}}},
             {"westergaard.mean_gap", {{"load", "1e-300"}}},
             {"westergaard.energy", {{"load", "0x1.fffffffffffffp-1"}}},
             {"westergaard.energy", {{"load", "1e-300"}}}}) {
        CAPTURE(name);
        std::map<std::string, Rational> in;
        for (const auto& [key, text] : values) in[key] = *parse_rational(text);
        CHECK(evaluate(*find_quantity(name), Inputs(in), {.digits = 60}).status == Status::certified);
    }
}
