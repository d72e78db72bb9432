// SPDX-License-Identifier: MIT
/// Every kind of row of the forward levels at random places: what a row claims to be off by, against a reference at twice the accuracy.
/// TOUCHSTONE_SEED=n tries others, TOUCHSTONE_COUNT=n more or fewer.
#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/recursion/first_steps/scale_one.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

/// Which integrand a value comes from: density law's step and share, exceedance law's step and slope, or its form for small p.
enum class Row { density_step, density_share, exceedance_step, exceedance_slope };
constexpr std::array rows{Row::density_step, Row::density_share, Row::exceedance_step, Row::exceedance_slope};
constexpr std::array names{"density law, step", "density law, share", "exceedance law, step", "exceedance law, slope or small p"};

/// One problem, whose levels serve several pressures.
struct Problem {
    long n;
    Rational G, load;
    double accuracy;
    Ball highest() const // p_n^max = G^(n+1) e_(n+1)
    {
        const Ball g(G);
        Ball edge(load), unit(1);
        for (long k = 0; k <= n; ++k) edge = 2 / g * sqrt(edge), unit = unit * g;
        return unit * edge;
    }
};

class Draw {
public:
    explicit Draw(unsigned long seed) : engine_(seed) {}
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
    double between_logarithms(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }
    Problem problem()
    {
        const double which = between(0, 1), near = between(0, 1);
        Problem p;
        p.n = which < 0.85 ? 1 : which < 0.97 ? 2 : 3;
        p.G = Rational(2 + between_logarithms(0.05, 40));
        p.load = near < 0.2 ? Rational(1) : near < 0.4 ? Rational(between(0.5, 0.998)) : Rational(between_logarithms(1e-12, 1));
        p.accuracy = std::floor(p.n == 1 ? between_logarithms(30, 600) : between_logarithms(30, p.n == 2 ? 100 : 50));
        return p;
    }
    /// At a distance d = log(p_n^max/p) from next to nothing to 100, half of them where many periods of e^-D are seen.
    Ball pressure(const Problem& of)
    {
        const double d = between(0, 1) < 0.4 ? between_logarithms(1e-8, 100) : between(1, 50);
        const WorkingPrecision precision(256);
        Ball p = of.highest() * exp(-Ball::exactly(d));
        arf_set_round(arb_midref(p.get()), arb_midref(p.get()), 100, ARF_RND_DOWN);
        mag_zero(arb_radref(p.get()));
        return p;
    }

private:
    std::mt19937_64 engine_;
};

class Levels {
public:
    Levels(const Problem& p, double accuracy)
        : problem_(p), density_(Law::density, [p] { return Ball(p.G); }, [p] { return Ball(p.load); }, accuracy),
          exceedance_(Law::exceedance, [p] { return Ball(p.G); }, [p] { return Ball(p.load); }, accuracy)
    {
    }
    Ball value(Row row, const Ball& p)
    {
        Forward& levels = row == Row::density_step || row == Row::density_share ? density_ : exceedance_;
        const WorkingPrecision precision(2 * levels.bits() + 200);
        const Ball d = log(problem_.highest() / p);
        return row == Row::density_step || row == Row::exceedance_slope ? levels.density(problem_.n, p, d)
                                                                        : levels.exceedance(problem_.n, d);
    }

private:
    Problem problem_;
    Forward density_, exceedance_;
};

/// What levels lose on the way to a value can be more than their accuracy when few digits are asked: the reference is not spared that.
constexpr double head_start = 40; // nats

/// To twice the accuracy and more: at n = 1 by another engine, else by levels of their own.
class Reference {
public:
    explicit Reference(const Problem& p) : problem_(p)
    {
        if (p.n > 1) levels_ = std::make_unique<Levels>(p, 2 * p.accuracy + head_start);
    }
    Ball value(Row row, const Ball& p)
    {
        if (levels_) return levels_->value(row, p);
        const WorkingPrecision precision(static_cast<slong>((2 * problem_.accuracy + head_start) / std::log(2.0)) + 200);
        const ScaleOne at{[&] { return p; }, problem_.load, [&] { return Ball(problem_.G); }, std::nullopt, problem_.G};
        return row == Row::density_step || row == Row::exceedance_slope ? scale_one_density(Variable::angle, at)
                                                                        : scale_one_exceedance(Variable::angle, at);
    }

private:
    Problem problem_;
    std::unique_ptr<Levels> levels_;
};

double off_to_claimed(const Ball& claimed, const Ball& known)
{
    const WorkingPrecision precision(4000);
    Ball middle;
    arf_set(arb_midref(middle.get()), arb_midref(claimed.get()));
    Ball radius;
    arf_set_mag(arb_midref(radius.get()), arb_radref(claimed.get()));
    const Ball off = abs(known - middle) / radius;
    return arf_get_d(arb_midref(off.get()), ARF_RND_NEAR);
}

unsigned long from_environment(const char* name, unsigned long otherwise)
{
    const char* given = std::getenv(name);
    return given ? std::strtoul(given, nullptr, 10) : otherwise;
}

} // namespace

TEST_CASE("no row of the forward levels is off by more than it claims")
{
    const unsigned long seed = from_environment("TOUCHSTONE_SEED", 1974), count = from_environment("TOUCHSTONE_COUNT", 100);
    constexpr int pressures = 4;
    MESSAGE("seed " << seed << ", " << count << " problems of " << pressures << " pressures");
    Draw draw(seed);
    std::array<unsigned long, rows.size()> compared{}, refused{};
    std::array<double, rows.size()> worst{};
    for (unsigned long i = 0; i < count; ++i) {
        const Problem problem = draw.problem();
        const std::string what = fmt::format("problem {}: n={} G={} load={} accuracy={:.0f}", i, problem.n, problem.G.get_str(),
                                             problem.load.get_str(), problem.accuracy);
        INFO(what);
        Levels levels(problem, problem.accuracy);
        Reference reference(problem);
        for (int j = 0; j < pressures; ++j) {
            const Ball p = draw.pressure(problem);
            const std::string where = p.to_string();
            INFO("p = ", where);
            std::optional<Ball> of_both_laws[2];
            for (const Row row : rows) {
                const auto r = static_cast<std::size_t>(row);
                const std::string kind = names[r];
                INFO(kind);
                std::optional<Ball> of_one_row;
                try {
                    const bool density = row == Row::density_step || row == Row::exceedance_slope;
                    const Ball claimed = levels.value(row, p);
                    std::optional<Ball>& known_before = problem.n == 1 ? of_both_laws[density] : of_one_row;
                    if (!known_before) known_before = reference.value(row, p);
                    const Ball known = *known_before;
                    ++compared[r];
                    CHECK(claimed.overlaps(known));
                    CHECK(known.radius_bound() <= 1e-3 * claimed.radius_bound()); // else it could not tell
                    worst[r] = std::max(worst[r], off_to_claimed(claimed, known));
                }
                catch (const BeyondReach&) {
                    ++refused[r];
                }
            }
        }
    }
    for (std::size_t r = 0; r < rows.size(); ++r) {
        MESSAGE(std::string(names[r]) << ": " << compared[r] << " compared, " << refused[r] << " refused; largest error " << worst[r]
                                      << " of what is claimed");
        CHECK(2 * compared[r] > pressures * count);
    }
}
