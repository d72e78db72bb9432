// SPDX-License-Identifier: MIT
/// The parts that the discretised operator is made of, each against numbers had otherwise.
#include "touchstone/transfer/discretisation.hpp"
#include "touchstone/transfer/moments.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

Rational exactly(const char* text) { return *parse_rational(text); }
Ball power_of_two(long e) { return ScalarTraits<Ball>::power_of_two(e); }
double number(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }

/// An integer of so many words in two's complement, as an exact ball.
Ball integer(const mp_limb_t* words, std::size_t count)
{
    const FixedFormat f(64 * static_cast<long>(count) - FixedFormat::headroom);
    fmpz_t n;
    fmpz_init(n);
    f.get(n, words);
    Ball r;
    arb_set_fmpz(r.get(), n);
    fmpz_clear(n);
    return r;
}

/// Words that often are all ones, 0 or next to it.
mp_limb_t word(std::mt19937_64& engine)
{
    const mp_limb_t any[] = {engine(), engine() >> 40, 0, ~mp_limb_t{0}, mp_limb_t{1} << 63, (mp_limb_t{1} << 63) - 1, 1, ~mp_limb_t{1}};
    return any[engine() % 8];
}

Ball with_radius(const Ball& mid, long exponent)
{
    Ball b = mid;
    arb_add_error(b.get(), power_of_two(exponent).get());
    return b;
}

/// At least what is counted, and but what is rounded up more.
void check_counted(const Ball& part, double counted, double rounded = 1e-8)
{
    CAPTURE(counted);
    CAPTURE(part.to_string(12));
    CHECK(part.is_exact());
    CHECK(number(part) > counted * (1 - 1e-13));
    CHECK(number(part) < counted * (1 + rounded));
}

} // namespace

TEST_CASE("a moment of order k does without words worth rho^k, and keeps what is worth more")
{
    const WorkingPrecision precision(20'000);
    for (const double rho : {1.5, 2.0, std::nextafter(2.0, 1), 3.7, std::nextafter(16.0, 17), std::nextafter(256.0, 1)}) {
        CAPTURE(rho);
        const std::vector<std::size_t> spare = words_to_spare(rho, 300);
        REQUIRE(spare.size() == 300);
        Ball power(1);
        for (const std::size_t words : spare) {
            CAPTURE(words);
            CHECK_FALSE(certainly(less(power, power_of_two(64 * static_cast<long>(words)))));
            CHECK(certainly(less(power, power_of_two(64 * static_cast<long>(words) + 64) * Ball(exactly("1.00000001")))));
            power = power * Ball::exactly(rho);
        }
        CHECK(power.is_exact());
    }
}

TEST_CASE("words that hold a number with 18 bits to spare: the fewest")
{
    std::mt19937_64 engine(1);
    for (std::size_t limbs = 1; limbs <= 4; ++limbs)
        for (int trial = 0; trial < 400; ++trial) {
            std::vector<mp_limb_t> guarded(limbs + 4);
            for (mp_limb_t& w : guarded) w = trial % 2 ? 0 : ~mp_limb_t{0};
            mp_limb_t* const number = &guarded[2];
            const auto bits = static_cast<long>(engine() % (64 * limbs)); // below 2^bits, often just below, or 2^(bits - 1)
            const int kind = trial % 3;
            for (std::size_t i = 0; i < limbs; ++i) {
                const long here = std::clamp(bits - 64 * static_cast<long>(i), 0L, 64L);
                const mp_limb_t ones = here == 64 ? ~mp_limb_t{0} : (mp_limb_t{1} << here) - 1;
                number[i] = kind == 0 ? ones : kind == 1 ? ones & engine() : ones ^ ones >> 1;
            }
            const Ball value = integer(number, limbs);
            std::size_t fewest = 1;
            while (fewest < limbs && !certainly(less(value, power_of_two(64 * static_cast<long>(fewest) - 18)))) ++fewest;
            CAPTURE(limbs); CAPTURE(bits); CAPTURE(kind);
            CHECK(Moments::significant(number, limbs) == fewest);
        }
}

TEST_CASE("a number of few words is added at its place, with its sign carried over all words above and no further")
{
    const WorkingPrecision precision(2000);
    std::mt19937_64 engine(2);
    for (std::size_t limbs = 1; limbs <= 4; ++limbs)
        for (std::size_t words = 1; words <= limbs; ++words)
            for (std::size_t gone = 0; gone + words <= limbs; ++gone)
                for (int trial = 0; trial < 200; ++trial) {
                    std::vector<mp_limb_t> sum(limbs + 2), u(words + 1);
                    for (mp_limb_t& w : sum) w = word(engine);
                    for (mp_limb_t& w : u) w = word(engine);
                    const std::vector<mp_limb_t> before = sum;
                    Moments::add_at(&sum[1], limbs, u.data(), words, gone);
                    CHECK(sum.front() == before.front());
                    CHECK(sum.back() == before.back());
                    const Ball off = integer(&before[1], limbs) + power_of_two(64 * static_cast<long>(gone)) * integer(u.data(), words)
                                   - integer(&sum[1], limbs); // a multiple of 2^(64 limbs)
                    CHECK(arb_is_int((off / power_of_two(64 * static_cast<long>(limbs))).get()) != 0);
                }
}

TEST_CASE("moments W T_k(tau) are off by less than 3 k^2 units, of the lowest word that order k has")
{
    std::mt19937_64 engine(3);
    const WorkingPrecision precision(4000);
    for (const long fraction : {40L, 200L, 300L}) {
        const FixedFormat f(fraction);
        const auto limbs = static_cast<std::size_t>(f.limbs());
        for (const double rho : {1.3, 9.0, 90.0})
            for (const long points : {1L, 2L, 3L, 70L}) {
                const std::vector<std::size_t> spare = words_to_spare(rho, points);
                std::vector<mp_limb_t> guarded((static_cast<std::size_t>(points) + 2) * limbs, 7);
                mp_limb_t* const sum = &guarded[limbs];
                std::fill_n(sum, static_cast<std::size_t>(points) * limbs, 0);
                Moments moments(f);
                std::vector<Ball> exact(static_cast<std::size_t>(points), Ball(0));
                int terms = 0;
                for (const long size : {11L, 0L, -5L, -30L, -100L, -250L})
                    for (const double t : {1.0, -1.0, 0.0, 0.3, -0.77, 0.999}) {
                        ++terms;
                        // of all bits that the format has, and none more
                        Ball tau = Ball::exactly(t), weight = power_of_two(size);
                        if (std::fabs(t) < 1) tau += Ball(static_cast<long>(engine() >> 30)) * f.unit();
                        weight += Ball(static_cast<long>(engine() >> 30)) * f.unit();
                        arb_floor(weight.get(), (weight / f.unit()).get(), 4000);
                        weight = weight * f.unit();
                        arb_floor(tau.get(), (tau / f.unit()).get(), 4000);
                        tau = tau * f.unit();
                        moments.add(weight, tau, spare, sum);
                        Ball before = weight * tau, now = weight; // T_{-1} = T_1
                        for (Ball& sum_of_all : exact) {
                            sum_of_all += now;
                            const Ball next = 2 * tau * now - before;
                            before = now, now = next;
                        }
                    }
                for (std::size_t k = 0; k < exact.size(); ++k) {
                    CAPTURE(fraction); CAPTURE(rho); CAPTURE(points); CAPTURE(k);
                    const Ball off = abs(integer(sum + k * limbs, limbs) * f.unit() - exact[k]);
                    const Ball unit = f.unit() * power_of_two(64 * static_cast<long>(spare[k]));
                    const auto order = static_cast<long>(k);
                    CHECK(off.is_finite());
                    CHECK_FALSE(certainly(less(3 * order * order * terms * unit, off)));
                }
                for (std::size_t i = 0; i < limbs; ++i) {
                    CHECK(guarded[i] == 7);
                    CHECK(guarded[guarded.size() - 1 - i] == 7);
                }
            }
    }
}

TEST_CASE("moduli are above what the numbers may be, by more than the roundings of sums of them")
{
    const std::vector<double> near{3, -0.5, 0, 1e-3, -1e-30};
    for (const double off : {0.25, 0x1p-60}) {
        const std::vector<double> all = moduli(near, off);
        REQUIRE(all.size() == near.size());
        for (std::size_t j = 0; j < near.size(); ++j) {
            const double most = std::fabs(near[j]) * (1 + 0x1p-52) + off;
            CHECK(all[j] > most * (1 + 5e-10));
            CHECK(all[j] < most * (1 + 2e-9));
        }
    }
    for (const double w : moduli({0, 1e-320}, 0)) {
        CHECK(w > 0x1p-401);
        CHECK(w < 0x1p-399);
    }
}

namespace {

using Matrix = std::vector<Ball>; ///< N x N, by rows

Matrix product(const Matrix& a, const Matrix& b, std::size_t N)
{
    Matrix c(N * N, Ball(0));
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k < N; ++k)
            for (std::size_t j = 0; j < N; ++j) c[i * N + j] += a[i * N + k] * b[k * N + j];
    return c;
}

Matrix moduli_of(Matrix a)
{
    for (Ball& entry : a) entry = abs(entry);
    return a;
}

/// Of what is above the exact value by the factor 1e-9 made up for roundings, and little more.
void check_rounded_up(double bound, const Ball& exact, double more = 2e-9)
{
    CAPTURE(bound);
    CAPTURE(exact.to_string(12));
    CHECK(certainly(less(exact * (1 + Ball(exactly("5e-10"))), Ball::exactly(bound))));
    CHECK(certainly(less(Ball::exactly(bound), exact * (1 + Ball::exactly(more)))));
}

} // namespace

TEST_CASE("powers of a matrix that vanish are bounded by what its entries may be off by")
{
    // B^2 = 0, |B|^p = 2^(p-1) everywhere; factors for roundings: one of |B|, and one of each product and its sum
    for (const double off : {0.0, 0x1p-60, 0x1p-52}) {
        CarriedErrors c;
        c.add_row({1, 1}, off);
        c.add_row({-1, -1}, off);
        c.begin({1, 2});
        double relative = 0x1p-50, majorant = 1 + off / relative, ups = 1;
        for (const double w : c.last_power()) check_rounded_up(w, Ball::exactly(majorant));
        for (int r = 1; r <= 4; ++r) {
            CAPTURE(r);
            c.square();
            relative = 2.1 * relative + 6 * 0x1p-52;
            majorant = 2 * majorant * majorant;
            ups = 2 * ups + 1;
            REQUIRE(c.last_power().size() == 4);
            for (const double w : c.last_power()) {
                CHECK(w > relative * majorant * (1 + (ups + 0.5) * 1e-9));
                CHECK(w < relative * majorant * (1 + (ups + 1.5) * 1e-9));
            }
        }
    }
}

TEST_CASE("powers of a matrix are bounded, whatever its entries within what they are off by, and not by much more")
{
    const WorkingPrecision precision(600);
    std::mt19937_64 engine(4);
    constexpr std::size_t N = 5;
    const double off = 0x1p-70;
    CarriedErrors c;
    Matrix B, majorant;
    for (std::size_t i = 0; i < N; ++i) {
        std::vector<double> near;
        for (std::size_t j = 0; j < N; ++j) {
            near.push_back(std::ldexp(static_cast<double>(engine() >> 11), j == 0 ? -56 : -53) * (engine() & 1 ? 1 : -1));
            const Ball w = Ball::exactly(near.back());
            B.push_back(w + (engine() & 1 ? 1 : -1) * (abs(w) * power_of_two(-52) + Ball::exactly(off)));
            majorant.push_back(abs(w) + Ball::exactly(off) * power_of_two(50));
        }
        c.add_row(near, off);
    }
    c.begin(std::vector<double>(N, 1));
    for (std::size_t k = 0; k < N * N; ++k) check_rounded_up(c.last_power()[k], majorant[k]);
    double relative = 0x1p-50;
    for (int r = 1; r <= 6; ++r) {
        CAPTURE(r);
        c.square();
        B = product(B, B, N);
        majorant = product(majorant, majorant, N);
        relative = 2.1 * relative + (N + 4) * 0x1p-52;
        const Matrix exact = moduli_of(B);
        for (std::size_t k = 0; k < N * N; ++k) {
            const Ball bound = Ball::exactly(c.last_power()[k]), beyond = Ball::exactly(relative) * majorant[k];
            CHECK(certainly(less(exact[k] * (1 + Ball(exactly("5e-10"))), bound)));
            CHECK(certainly(less(bound, (exact[k] + 2 * beyond) * (1 + Ball(exactly("2e-9"))))));
        }
    }
}

TEST_CASE("what all levels add is bounded by W, each from those before it by the last power made")
{
    const WorkingPrecision precision(300);
    // |B| has the spectral radius 1.39, B 0.99
    constexpr std::size_t N = 2;
    const std::vector<double> alpha{1, 0.25}, rows[]{{0.792, -0.594}, {0.594, 0.792}};
    CarriedErrors c;
    Matrix B, power{Ball(1), Ball(0), Ball(0), Ball(1)};
    for (const auto& row : rows) {
        c.add_row(row, 0);
        for (const double w : row) B.push_back(Ball::exactly(w));
    }
    c.begin(alpha);
    std::vector<std::vector<double>> W;
    std::vector<Ball> all(N, Ball(0)); // what level after level, each with the worst of signs, comes to
    std::vector<double> last = c.last_power();
    std::size_t p = 1;
    for (std::size_t level = 0; level < 200; ++level) {
        CAPTURE(level);
        W.push_back(c.at(level));
        REQUIRE(W.back().size() == N);
        if (c.last_power() != last) p *= 2;
        last = c.last_power();
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j) all[i] += abs(power[i * N + j]) * Ball::exactly(alpha[j]);
            CHECK_FALSE(certainly(less(Ball::exactly(W.back()[i]), all[i])));
            if (level == 0) continue;
            REQUIRE(level >= p);
            Ball sum = Ball::exactly(W[p - 1][i]);
            for (std::size_t j = 0; j < N; ++j) sum += Ball::exactly(last[i * N + j]) * Ball::exactly(W[level - p][j]);
            check_rounded_up(W.back()[i], sum);
        }
        power = product(power, B, N);
    }
    CHECK(W.front() == alpha);
    CHECK(p >= 8);
    CHECK(W.back()[0] < 1e9); // 1.39^200 > 1e28
    const std::vector<double> row{3, 0.5};
    for (const std::size_t level : {std::size_t{0}, std::size_t{7}, std::size_t{150}})
        check_rounded_up(c.into(row, level), 3 * Ball::exactly(W[level][0]) + Ball::exactly(W[level][1]) / 2);
}

TEST_CASE("errors that grow fast take powers of no more terms than there are")
{
    CarriedErrors c;
    c.add_row({10'000}, 0);
    c.begin({1});
    double sum = 1;
    for (std::size_t level = 0; level < 40; ++level) {
        CAPTURE(level);
        CHECK(c.at(level)[0] >= sum);
        CHECK(c.at(level)[0] < sum * (1 + 1e-6));
        sum = sum * 10'000 + 1;
    }
}

TEST_CASE("errors that binary64 does not hold are more, not none")
{
    CarriedErrors c;
    c.add_row({1e-200}, 0);
    c.begin({0});
    for (const std::size_t level : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
        CHECK(c.at(level)[0] >= 0x1p-900);
        CHECK(c.at(level)[0] < 0x1p-890);
        CHECK(c.into({1e-250}, level) >= 0x1p-900);
    }
    c.square();
    CHECK(c.last_power()[0] > 0x1p-460);
    CHECK(c.last_power()[0] < 0x1p-390);
}

TEST_CASE("each part of a row's budget is what is counted for it, where all are of a size")
{
    for (const double rho : {1.01, 1.25, 3.0}) {
        CAPTURE(rho);
        const double u = 0x1p-10, scale = 4, total = 5, tau_error = 0x1p-7, weight_error = 0x1p-9;
        const Resolution resolution{3, rho, 6, Ball::exactly(u), Ball::exactly(scale)};
        const RowSums sums{Ball::exactly(total), Ball::exactly(tau_error), Ball::exactly(weight_error), 7};
        Rule rule;
        rule.discretisation = Ball::exactly(0.75);
        rule.truncation = Ball::exactly(0.625);
        const Budget b = resolution.budget(sums, rule, Ball(exactly("1/16")));
        check_counted(b.rule, 0.75 / 2);
        check_counted(b.truncation, 0.625 / 2);
        check_counted(b.interpolation, 4 * total / (rho * rho * (rho - 1)));
        check_counted(b.abscissae, (tau_error + total * u) / ((rho + 1 / rho) / 2 - 1 - 0x1p-29));
        check_counted(b.weights, 7 * (weight_error + u));
        const double coefficient = 2 + 4 / (rho * rho - 1), off = (4 * 3 + 1 + scale) * u, moment = 7 * 4 * u * 9;
        check_counted(resolution.coefficient_bound(), coefficient);
        check_counted(resolution.coefficient_error(), off);
        check_counted(resolution.moment_error(7), moment);
        check_counted(b.entries, 3 * moment * coefficient + (3 * total + 6 * moment * rho * rho * rho) * off, 2e-8);
        const double radius = 0x1p-8, row = total + moment * rho * rho * rho;
        check_counted(resolution.weighting(sums, Ball::exactly(radius)), 6 * ((radius + u) * row + u) * (coefficient + off), 2e-8);
        const Budget parts{Ball(1), Ball(2), Ball(4), Ball(8), Ball(16), Ball(32)};
        CHECK(number(parts.total()) == 63);
    }
}

TEST_CASE("an abscissa is taken inside [-1, 1], with what that moves it by and what it is known to, or refused")
{
    const WorkingPrecision precision(200);
    const auto check = [](const Ball& tau, double moved) {
        CAPTURE(tau.to_string(20));
        const Discretisation::Abscissa a = Discretisation::abscissa(tau);
        CHECK(a.tau.is_exact());
        CHECK_FALSE(certainly(less(1, abs(a.tau))));
        CHECK(a.tau.overlaps(at_least(at_most(tau, Ball(1)), Ball(-1))));
        CHECK(number(a.moved) >= moved);
        CHECK(number(a.moved) < 4 * moved);
    };
    const auto refused = [](const Ball& tau) {
        CAPTURE(tau.to_string(20));
        CHECK_THROWS_WITH_AS(Discretisation::abscissa(tau), "the load is below the reach of the grid", BeyondReach);
    };
    for (const long sign : {1L, -1L}) {
        check(with_radius(sign * Ball(exactly("0.3")), -40), 0x1p-40);
        check(sign * (1 + power_of_two(-35)), 0x1p-35);
        check(with_radius(sign * (1 - power_of_two(-35)), -33), 0x1p-33);
        check(with_radius(sign * (1 - power_of_two(-21)), -32), 0x1p-32);
        check(with_radius(sign * (1 - power_of_two(-19)), -31), 0x1p-31);
        refused(sign * (1 + power_of_two(-21)));
        refused(sign * (1 + power_of_two(-29)));
        refused(sign * Ball(3));
        refused(with_radius(sign * Ball(exactly("0.3")), -29));
        refused(with_radius(sign * (1 - power_of_two(-40)), -29));
    }
}

TEST_CASE("magnitudes are bounded at all levels, beyond the last too, and not by much more")
{
    const WorkingPrecision precision(200);
    for (const char* G : {"2.0001", "3", "900000000"}) {
        CAPTURE(G);
        const std::vector<Ball> bounds = Discretisation::magnitude_bounds(Ball(exactly(G))), exact = magnitudes(Ball(exactly(G)), 180);
        REQUIRE(bounds.size() > 100);
        for (std::size_t m = 0; m < exact.size(); ++m) {
            CAPTURE(m);
            const Ball& bound = bounds[std::min(m, bounds.size() - 1)];
            CHECK(certainly(less(exact[m] * Ball(exactly("1.0000009")), bound)));
            CHECK(certainly(less(bound, exact[m] * Ball(exactly("1.000001")))));
        }
    }
}

TEST_CASE("one rule serves all points: the one there is, or up to the upper end of the highest")
{
    const WorkingPrecision precision(200);
    const Ball low(exactly("0.625")), high(exactly("0.9")), wide = with_radius(low, -4);
    const Ratios one = Discretisation::ratios_of({{high, Ball(1)}});
    CHECK(one.single);
    CHECK(one.highest.contains(high));
    for (const std::vector<Discretisation::Point>& points : {std::vector<Discretisation::Point>{{low, Ball(1)}, {high, Ball(1)}},
                                                              {{high, Ball(1)}, {low, Ball(1)}},
                                                              {{low, Ball(1)}, {wide, Ball(1)}},
                                                              {{wide, Ball(1)}, {low, Ball(1)}, {low, Ball(1)}}}) {
        const Ratios all = Discretisation::ratios_of(points);
        CHECK_FALSE(all.single);
        CHECK(all.highest.is_exact());
        for (const Discretisation::Point& p : points) CHECK_FALSE(certainly(less(all.highest, upper(p.x))));
        CHECK(certainly(less(all.highest, Ball(exactly("0.901")))));
    }
}

TEST_CASE("a chain has at most 10000 scales; those beyond the magnitudes that are computed have the bound of all further ones")
{
    const auto G = [] { return Ball(3); };
    Discretisation D(Scheme::force_weighted, G, 40), fresh(Scheme::force_weighted, G, 40);
    const WorkingPrecision precision(D.bits());
    const Ball load(exactly("0.3")), F = D.force_share(150, load);
    CHECK(F.overlaps(D.force_share(100, load))); // F tends to a limit
    CHECK(F.relative_bits() > 15);
    const std::string text = fresh.certificate(150);
    CHECK(text == D.certificate(150));
    CHECK(text.find("level 149: ") != std::string::npos);
    CHECK(text.find("level 150: ") == std::string::npos);
    for (const auto& ask : {std::function<void(long)>([&](long n) { D.force_share(n, load); }), {[&](long n) { D.certificate(n); }}})
        CHECK_THROWS_WITH_AS(ask(10'001), "n must be at most 10000", BeyondReach);
    Discretisation rough(Scheme::force_weighted, [] { return Ball(1000); }, 20);
    CHECK_THROWS_AS(rough.force_share(10'000, load), ErrorsHaveOutgrown);
}

TEST_CASE("a certificate is refused from the level on whose errors have outgrown the values")
{
    const auto G = [] { return Ball(100'000); };
    Discretisation D(Scheme::force_weighted, G, 20), before(Scheme::force_weighted, G, 20), there(Scheme::force_weighted, G, 20);
    const WorkingPrecision precision(D.bits());
    long n = 1;
    try {
        for (; n < 200; ++n) D.force_share(n, Ball(exactly("0.5")));
    }
    catch (const ErrorsHaveOutgrown&) {
    }
    REQUIRE(n < 200);
    REQUIRE(n > 1);
    CHECK_NOTHROW(before.certificate(n - 1));
    CHECK_THROWS_AS(there.certificate(n), ErrorsHaveOutgrown);
}
