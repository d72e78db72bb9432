// SPDX-License-Identifier: MIT
/// The table of methods over the whole domain of the recursion: every point is served, or refused with the reason, never both; and what is
/// said about it elsewhere is what the table says.
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/recursion/light_load.hpp"
#include "touchstone/recursion/methods.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>
#include <sstream>

using namespace touchstone;
using namespace touchstone::recursion;

namespace {

Rational exactly(const std::string& text) { return *parse_rational(text); }
/// a +- 10^-digits
Rational beside(const Rational& a, int side, unsigned long digits) { return a + side * power(Rational(10), -static_cast<long>(digits)); }

Problem problem(Asked asked, long n, const Rational& load, const Rational& G, const Rational& p)
{
    return {asked,
            n,
            load,
            {[G] { return Ball(G); }, G},
            [G](const Rational& r) { return G < r ? -1 : G > r ? 1 : 0; },
            {[p] { return Ball(p); }, p}};
}

const std::vector<Asked> laws{Asked::area, Asked::exceedance, Asked::density};
const std::vector<long> scales{0, 1, 2, 3, 7, 20, 21, 100, 101, 10'000};
const std::vector<long> digit_counts{1, 15, 16, 20, 21, 61, 291, 10'000};

std::vector<Rational> loads()
{
    std::vector<Rational> all{power(Rational(10), -300), power(Rational(10), -301), power(Rational(10), -53), power(Rational(10), -30)};
    for (const char* at : {"1", "100", "1000", "1000000"})
        for (const int side : {-1, 0, 1}) all.push_back(beside(exactly(at), side, 30));
    all.push_back(beside(1, -1, 300));
    for (const char* text : {"0.001", "0.5", "1.5", "10"}) all.push_back(exactly(text));
    return all;
}

std::vector<Rational> surfaces()
{
    std::vector<Rational> all{exactly("1e12"), 10, 4, exactly("1.5")};
    for (const char* at : {"1.000001", "1.003", "2", "2.000001", "2.02", "3.2", "1000000000"})
        for (const int side : {-1, 0, 1}) all.push_back(beside(exactly(at), side, 20));
    return all;
}

/// Every seventh point: as 7 divides neither the number of points of one load and surface nor that of one load, each load has each surface,
/// and each surface each scale and question, though at a seventh of the loads.
constexpr long some = 7, every = 1;

/// Calls visit(problem) for all of them, or some; pressures from 0 to the upper edge of the support and beyond, about.
template <class Visit>
void over_the_domain(long step, Visit visit_all)
{
    long point = 0;
    const auto visit = [&](const Problem& p) {
        if (point++ % step == 0) visit_all(p);
    };
    for (const Rational& load : loads())
        for (const Rational& G : surfaces())
            for (const long n : scales)
                for (const Asked asked : laws) {
                    if (asked == Asked::area) {
                        visit(problem(asked, n, load, G, 0));
                        continue;
                    }
                    if (n > 21 && n != 10'000) continue; // as 21
                    const Rational unit = n > 100 ? Rational(1) : power(G, n);
                    for (const Rational& p : {Rational(unit / 1025), Rational(unit / 7), unit, Rational(3 * unit)})
                        visit(problem(asked, n, load, G, p));
                }
}

std::string file(const std::string& name)
{
    std::ifstream in(std::string(TOUCHSTONE_SOURCE) + "/" + name);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

bool answers(const Method& m, Asked asked) { return std::find(m.asked.begin(), m.asked.end(), asked) != m.asked.end(); }

} // namespace

namespace {

void check_served_or_refused(long step)
{
    long served = 0, refused = 0;
    over_the_domain(step, [&](const Problem& p) {
        long most = 0; // digits that some method claims
        for (const Method& m : methods())
            if (answers(m, p.asked) && m.refusal(p).empty()) most = std::max(most, m.most_digits(p));
        for (const long digits : digit_counts) {
            const Choice c = choose(p, {digits});
            CHECK((c.method != nullptr) == (most > 0));
            if (!c.method) {
                CHECK_FALSE(c.refusal.empty());
                CHECK(c.digits == 0);
                ++refused;
                continue;
            }
            ++served;
            CHECK(answers(*c.method, p.asked));
            CHECK(c.method->refusal(p).empty());
            CHECK(std::min(c.digits, digits) == std::min(most, digits)); // as many as anything gives
            CHECK(c.refusal.empty() == (c.digits >= digits));
        }
    });
    MESSAGE(served << " served, " << refused << " refused");
    CHECK(served > 70'000 / step);
    CHECK(refused > 7'000 / step);
}

void check_cost(long step)
{
    over_the_domain(step, [&](const Problem& p) {
        double last = 0;
        for (const long digits : digit_counts) {
            const Choice c = choose(p, {digits});
            if (!c.method || c.digits < digits) break;
            const double cost = c.method->cost(p, {digits});
            CHECK(cost >= last);
            last = cost;
        }
    });
}

} // namespace

TEST_CASE("a point is served or refused with the reason, never both, and served wherever a method claims it")
{
    check_served_or_refused(some);
}
TEST_CASE("fewer digits never cost more") { check_cost(some); }
TEST_CASE("slow: so it is at every point of the domain" * doctest::skip())
{
    check_served_or_refused(every);
    check_cost(every);
}

TEST_CASE("scale 1 is one integral at every load and G; partial contact has two proofs; a single proof has a witness")
{
    over_the_domain(every, [&](const Problem& p) {
        const Choice c = choose(p, {15});
        if (p.n == 1) {
            REQUIRE(c.method);
            CHECK(c.method->name == "scale-one-by-ratio");
        }
        if (p.asked == Asked::area && p.load >= power(Rational(10), -100) && p.load <= 1 && p.compare_G(Rational(21, 10)) > 0 &&
            p.compare_G(1000) < 0) {
            REQUIRE(c.method);
            CHECK(c.method->enclose_again);
        }
        if (c.method && !c.method->enclose_again) CHECK(c.method->second.empty());
        if (c.method) CHECK_FALSE(c.method->shares.empty());
    });
    CHECK(observers().size() == 2);
}

TEST_CASE("so near G = 2 that binary64 cannot tell, distributions are taken from proven levels, as at G = 2")
{
    const Rational half(1, 2);
    for (const Asked asked : {Asked::exceedance, Asked::density})
        for (const long digits : {13L, 20L, 45L}) {
            CAPTURE(digits);
            const Problem p = problem(asked, 3, half, beside(2, 1, static_cast<unsigned long>(digits)), half);
            const Choice c = choose(p, {8});
            REQUIRE(c.method);
            CHECK(c.method->name.starts_with("proven-levels"));
            CHECK(c.digits >= 8);
        }
    CHECK(choose(problem(Asked::density, 3, half, beside(2, 1, 11), half), {8}).method->name == "forward-density");
}

TEST_CASE("at loads above 1 many scales are taken from the limit where it has the digits, at once, and agree with panels scale by scale")
{
    const auto by = [](long n, long digits) { return choose(problem(Asked::area, n, 2, 100, 0), {digits}); };
    CHECK(by(20, 15).method->name == "heavy-load-force-weighted");
    CHECK(by(200, 15).method->name == "limit-of-scales");
    CHECK(by(200, 15).method->cost(problem(Asked::area, 200, 2, 100, 0), {15}) < 2);
    CHECK(by(200, 55).method->name == "heavy-load-force-weighted"); // more than the rate leaves
    const Problem p = problem(Asked::area, 70, 2, 10, 0);
    const WorkingPrecision precision(200);
    const auto enclosed = [&](const char* name, long digits) {
        const auto m = std::find_if(methods().begin(), methods().end(), [name](const Method& method) { return method.name == name; });
        REQUIRE(m->refusal(p).empty());
        const Ball area = m->enclose(p, {digits});
        CHECK(area.relative_bits() > 3 * (digits - 1));
        return area;
    };
    CHECK(enclosed("heavy-load-force-weighted", 6).overlaps(enclosed("limit-of-scales", 3)));
}

TEST_CASE("light loads are a matter of seconds up to scale 12: the power series, with a witness from 1e-300 on")
{
    for (const long exponent : {-101L, -300L})
        for (const Rational& G : {exactly("2.1"), exactly("3"), exactly("1000")})
            for (const long n : {2L, 5L, 12L}) {
                const Problem p = problem(Asked::area, n, power(Rational(10), exponent), G, 0);
                const Choice c = choose(p, {30});
                REQUIRE(c.method);
                CAPTURE(n); CAPTURE(exponent);
                CHECK(c.digits >= 30);
                CHECK(c.method->cost(p, {30}) < 20);
                if (n == 2 || exponent == -300) CHECK(c.method->name == "power-series");
                CHECK(observers_refusal(p).empty());
            }
}

TEST_CASE("the power series says where it would take too many terms, and at which G it is not used")
{
    const Method series = power_series();
    const auto refused = [&](long n, const char* load, const Rational& G) {
        return series.refusal(problem(Asked::area, n, exactly(load), G, 0));
    };
    CHECK(refused(14, "1e-300", exactly("2.1")).empty());
    CHECK(refused(18, "1e-300", exactly("2.1")).find("too many terms") != std::string::npos);
    CHECK(refused(21, "1e-300", exactly("2.1")).find("too many terms") != std::string::npos);
    CHECK(refused(2, "1e-99", 3).find("1e-100") != std::string::npos);
    CHECK(refused(2, "1e-300", exactly("2.0000005")).find("for G from 2.000001") != std::string::npos);
    CHECK(refused(2, "1e-300", exactly("2.000001")).empty());
    CHECK(refused(2, "1e-300", exactly("1e9")).find("to 10^9") != std::string::npos);
}

namespace {

void check_light_load(long n, long digits)
{
    const auto e =
        evaluate(*find_quantity("contact.area"), Inputs({{"n", n}, {"load", power(Rational(10), -300)}, {"G", 3}}), {.digits = digits});
    CHECK(e.status == Status::certified);
    REQUIRE(e.second_look);
    CHECK(e.second_look->agrees);
    CHECK(e.second_look->digits >= 15);
}

} // namespace

TEST_CASE("a light load's area agrees with its witness") { check_light_load(3, 20); }
TEST_CASE("slow: a light load's area of five scales agrees with its witness" * doctest::skip()) { check_light_load(5, 30); }

TEST_CASE("what is written about it is printed from it")
{
    const std::string table = reach_as_table();
    for (const Method& m : methods()) {
        CHECK(table.find("`" + m.name + "`") != std::string::npos);
        CHECK(table.find(m.reach) != std::string::npos);
    }
    CHECK_MESSAGE(file("docs/certified.md").find(table) != std::string::npos, "docs/certified.md is not up to date; its table is to be\n"
                                                                                  << table);
    CHECK(find_quantity("contact.area")->domain.find(reach_in_words(Asked::area)) != std::string::npos);
    CHECK(find_quantity("contact.density")->domain.find(reach_in_words(Asked::density)) != std::string::npos);
}

/// Evaluated, not only chosen: TOUCHSTONE_CAMPAIGN=SEED:COUNT test_methods -tc='campaign*'
TEST_CASE("densities at loads that double-double arithmetic does not tell from 1 are not promised")
{
    for (const int side : {-1, 1}) {
        CHECK(choose(problem(Asked::density, 8, 1 + side * power(Rational(10), -26), Rational(3, 2), 3), {6}).method);
        CHECK(choose(problem(Asked::density, 8, 1 + side * power(Rational(10), -30), Rational(3, 2), 3), {6}).method == nullptr);
    }
    CHECK(choose(problem(Asked::density, 8, 1, Rational(3, 2), 3), {6}).method);
}

constexpr double worth_a_message = 20; ///< seconds of CPU of one value: so that a campaign of hours says where it is

TEST_CASE("campaign: what the table claims is certified when it is asked for" *
          doctest::skip(std::getenv("TOUCHSTONE_CAMPAIGN") == nullptr))
{
    const char* set = std::getenv("TOUCHSTONE_CAMPAIGN");
    const std::string text = set ? set : "1:10";
    std::mt19937_64 random(std::stoull(text));
    const long count = std::stol(text.substr(text.find(':') + 1));
    MESSAGE("seed and count " << text);
    const auto pick = [&](const auto& from) { return from[random() % from.size()]; };
    const std::vector<Rational> all_loads = loads(), all_surfaces = surfaces();
    for (long i = 0; i < count; ++i) {
        const Rational load = pick(all_loads), G = pick(all_surfaces);
        const long n = pick(scales);
        std::map<std::string, Rational> values{{"n", n}, {"load", load}, {"G", G}};
        const std::string name = pick(std::vector<std::string>{"contact.area", "contact.exceedance", "contact.density"});
        if (name != "contact.area") values["p"] = power(G, std::min(n, 21L)) * Rational(1 + static_cast<long>(random() % 1000), 1000);
        const Quantity& q = *find_quantity(name);
        const Inputs in(values);
        const Plan plan = plan_of(q, in, {6});
        if (plan.proofs.empty()) continue;
        std::string asked = name;
        for (const auto& [key, value] : in.values()) asked += " " + key + "=" + value.get_str();
        const std::clock_t start = std::clock();
        const Evaluation e = evaluate(q, in, {.digits = 6});
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        if (seconds > worth_a_message) MESSAGE((i + 1) << " of " << count << ": " << asked << " took " << seconds << " s");
        CHECK_MESSAGE((e.status == Status::certified || e.status == Status::exact), asked << ": " << e.note);
        if (e.second_look) CHECK(e.second_look->agrees);
    }
}

namespace {

/// What the table's rows, their second proofs and their witnesses say of one area.
class Opinions {
public:
    void hold(const Problem& p, Accuracy a)
    {
        proofs_.clear();
        for (const Method& m : methods()) {
            const bool answers = std::find(m.asked.begin(), m.asked.end(), Asked::area) != m.asked.end();
            if (!answers || !m.refusal(p).empty() || m.most_digits(p) < a.digits || m.cost(p, a) > most_seconds) continue;
            if (m.name == heavy_load && asked_before_[m.name]++ % (1 + static_cast<long>(m.cost(p, a) / seconds_of_a_load)) != 0) continue;
            add(m.name, [&] { return m.enclose(p, a); });
            if (m.enclose_again) add(m.second, [&] { return m.enclose_again(p, a); });
            else if (m.witness) ask(*m.witness, p, a);
            else if (observers_refusal(p).empty()) ask(observers().front(), p, a);
        }
        ++points;
        pairs += static_cast<long>(proofs_.size() * (proofs_.size() - 1) / 2);
    }
    long points = 0, pairs = 0, witnesses = 0, beyond_own_error = 0, refusals = 0;

private:
    static constexpr double most_seconds = 1000;   // of a mesh, which serves all areas of one G
    static constexpr double seconds_of_a_load = 1; // where each load has a mesh of its own, a dear one is asked for in one of so many areas
    static constexpr const char* heavy_load = "heavy-load-force-weighted";
    static constexpr long allowed_errors = 64;     // as the program allows: evaluate.cpp
    static void hold(const std::string& one, const Ball& a, const std::string& other, const Ball& b)
    {
        CHECK_MESSAGE(a.overlaps(b), one << " " << a.to_string(15) << ", " << other << " " << b.to_string(15));
    }
    template <class F>
    void add(const std::string& name, F enclosure)
    {
        try {
            const Ball b = enclosure();
            for (const auto& [other, ball] : proofs_) hold(name, b, other, ball);
            proofs_.emplace_back(name, b);
        }
        catch (const BeyondReach&) {
            ++refusals;
        }
    }
    void ask(const Observer& witness, const Problem& p, Accuracy a)
    {
        if (proofs_.empty()) return;
        try {
            const Witness w = witness.look(p, a);
            const auto& [name, proof] = proofs_.back();
            Ball seen = w.value, allowed = w.value;
            arb_add_error(seen.get(), w.error.get());
            arb_add_error(allowed.get(), Ball(allowed_errors * w.error).get());
            hold(witness.name, allowed, name, proof);
            beyond_own_error += !seen.overlaps(proof);
            ++witnesses;
        }
        catch (const BeyondReach&) {
            ++refusals;
        }
    }
    std::vector<std::pair<std::string, Ball>> proofs_;
    std::map<std::string, long> asked_before_;
};

} // namespace

/// TOUCHSTONE_OPINIONS=SEED:SURFACES test_methods -tc='campaign*': for each of so many values of G a hundred areas, which share
/// their meshes.
TEST_CASE("campaign: all proofs of an area overlap, and its witness" * doctest::skip(std::getenv("TOUCHSTONE_OPINIONS") == nullptr))
{
    const char* set = std::getenv("TOUCHSTONE_OPINIONS");
    const std::string text = set ? set : "1:1";
    std::mt19937_64 random(std::stoull(text));
    const long surfaces = std::stol(text.substr(text.find(':') + 1));
    const auto between = [&](double low, double high) { return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53; };
    const auto rational = [](double x) { return Rational(static_cast<long>(x * 1e6) + 1, 1'000'000); };
    constexpr long of_a_surface = 100;
    Opinions opinions;
    for (long g = 0; g < surfaces; ++g) {
        // half of them where full contact never ends, the rest up to 10^3
        const Rational G =
            rational(random() % 2 ? 1 + std::exp(between(std::log(0.02), 0)) : 2 + std::exp(between(std::log(1e-3), std::log(1e3))));
        std::vector<Problem> all;
        for (long i = 0; i < of_a_surface; ++i)
            all.push_back(problem(Asked::area, 1 + static_cast<long>(random() % 20),
                                  rational(std::exp(between(std::log(1e-5), std::log(10.0)))), G, 0));
        for (const Problem& p : all) {
            CAPTURE(G.get_str());
            CAPTURE(p.load.get_str());
            CAPTURE(p.n);
            opinions.hold(p, {8});
        }
        MESSAGE("G=" << G.get_str() << ": " << opinions.points << " areas, " << opinions.pairs << " pairs of proofs, " << opinions.witnesses
                     << " witnesses (" << opinions.beyond_own_error << " further off than their own error, all within 64 of it), "
                     << opinions.refusals << " beyond reach");
    }
}
