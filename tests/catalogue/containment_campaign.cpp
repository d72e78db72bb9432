// SPDX-License-Identifier: MIT
/// Random (quantity, inputs, digits): what is printed against the equations of the paper as a reader would type them, in MPFR with digits
/// to spare; edges of the domain and ties more often than chance would have them. The recursion against its other proof at ten digits more.
/// TOUCHSTONE_SEED and TOUCHSTONE_COUNT choose the cases (ctest -R containment_campaign -V).
#include "touchstone/catalogue/evaluate.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <boost/multiprecision/mpfr.hpp>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>

using namespace touchstone;
using Real = boost::multiprecision::mpfr_float;

namespace {

/// A load of 1 - 1e-300 cancels 300 digits, at most four times over: four times the longest input, and some.
long spare_digits(const std::map<std::string, Rational>& inputs)
{
    std::size_t longest = 0;
    for (const auto& [name, value] : inputs) longest = std::max(longest, mpz_sizeinbase(value.get_den_mpz_t(), 10));
    return 120 + 4 * static_cast<long>(longest);
}

unsigned long setting(const char* name, unsigned long otherwise)
{
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

Real real(const Rational& r) { return Real(Real(r.get_num_mpz_t()) / Real(r.get_den_mpz_t())); }

Real pi()
{
    Real r;
    mpfr_const_pi(r.backend().data(), MPFR_RNDN); // MPFR keeps it
    return r;
}

Real squared(const Real& x) { return x * x; }

/// What a reader types from the paper, or from docs for what is not in it. Inputs by name.
struct Case {
    const char* quantity;
    std::function<Real(const std::function<Real(const char*)>&)> value;
    bool subtracts = true; ///< what can cancel
};
using In = const std::function<Real(const char*)>&;

Real half_width(const Real& load) { return load >= 1 ? Real(0.5) : Real(asin(sqrt(load)) / pi()); } // (2.5)

Real f(const Real& x) { return x > 1 ? Real(1 + x) : Real(2 * sqrt(x)); } // (5.4), (5.5)

Real iterate(long n, Real x, const Real& G)
{
    for (long k = 0; k <= n; ++k) x = f(x) / G;
    return x;
}

Real K(long n) // (7.13)
{
    static std::map<std::pair<long, unsigned>, Real> kept;
    Real& known = kept[{n, Real::default_precision()}];
    if (known != 0) return known;
    Real k = 2 / pi(), delta = Real(1) / 2;
    for (long i = 0; i < n; ++i) {
        k *= pow(Real(2), delta) / pi() * sqrt(pi()) * tgamma(Real(1 + delta / 2)) / tgamma(Real(Real(3) / 2 + delta / 2));
        delta = (delta + 1) / 2;
    }
    return known = k;
}

const std::vector<Case>& cases()
{
    static const std::vector<Case> all{
        {"westergaard.half_width", [](In in) { return half_width(in("load")); }},
        {"westergaard.pressure",
         [](In in) -> Real {
             const Real load = in("load"), x = in("x");
             if (load >= 1) return load + cos(2 * pi() * x);                                      // (2.2)
             const Real inside = load - squared(sin(pi() * x));
             return inside <= 0 ? Real(0) : Real(2 * cos(pi() * x) * sqrt(inside));               // (2.4) with (2.5)
         }},
        {"westergaard.exceedance",
         [](In in) -> Real {
             const Real load = in("load"), p = in("p");
             if (load >= 1) return p <= load - 1 ? Real(1) : p >= load + 1 ? Real(0) : Real(acos(p - load) / pi()); // (2.14)
             if (p >= 2 * sqrt(load)) return Real(0);
             // p^2/4 = (1 - s)(load - s), s = sin^2(pi x): the smaller root
             const Real b = 1 + load, s = (b - sqrt(b * b - 4 * (load - p * p / 4))) / 2;
             return 2 * asin(sqrt(s)) / pi();
         }},
        {"hertz.half_width", [](In in) -> Real { return sqrt(in("load")) / pi(); }, false}, // (2.7)
        {"hertz.pressure",
         [](In in) -> Real {
             const Real inside = in("load") - squared(pi() * in("x"));
             return inside <= 0 ? Real(0) : Real(2 * sqrt(inside));                                 // (2.6) with (2.7)
         }},
        {"westergaard.gap",
         [](In in) -> Real {
             const Real load = in("load"), v = sin(pi() * abs(in("x")));
             if (v * v <= load) return Real(0);
             const Real w = sqrt(v * v - load);
             return 2 * (v * w - load * log((v + w) / sqrt(load)));
         }},
        {"westergaard.mean_gap",
         [](In in) -> Real {
             const Real s = in("load");
             return s >= 1 ? Real(0) : Real(1 - s + s * log(s));
         }},
        {"westergaard.energy",
         [](In in) -> Real {
             const Real s = in("load");
             return s >= 1 ? Real(0.25) : Real(s * s * (1 - 2 * log(s)) / 4);
         }},
        {"weierstrass.bound", [](In in) -> Real { return 1 / (1 - pow(in("gamma"), Real(in("D") - 2))); }}, // (3.4)
        {"peaks.f", [](In in) { return f(in("x")); }},
        {"peaks.iterate", [](In in) { return iterate(in("n").convert_to<long>(), in("load"), in("G")); }},
        {"peaks.fixed_point",
         [](In in) -> Real {
             const Real G = in("G");
             return G > 2 ? Real(4 / (G * G)) : Real(1 / (G - 1));
         }},
        {"segments.max_half_width",
         [](In in) {
             const long n = in("n").convert_to<long>();
             return half_width(n == 0 ? in("load") : iterate(n - 1, in("load"), in("G")));
         }},
        {"archard.area",
         [](In in) -> Real {
             const long n = in("n").convert_to<long>();
             const Real last = pow(Real(2), -n);
             return K(n) * pow(in("G"), Real(-(n - 1 + last))) * pow(in("load"), Real(1 - last / 2)); // (7.18), corrected
         },
         false},
        {"archard.segments",
         [](In in) -> Real {
             const long n = in("n").convert_to<long>();
             const Real last = pow(Real(2), -n), D = in("D");
             return K(n - 1) * pow(in("gamma"), Real((2 - D) * n + 2 * (D - 1) * (1 - last))) * pow(in("load"), Real(1 - last)); // (8.2)
         },
         false}};
    return all;
}

class Draw {
public:
    explicit Draw(unsigned long seed) : random_(seed) {}
    std::size_t below(std::size_t n) { return random_() % n; }
    Rational binary64() { return exact_rational(std::ldexp(static_cast<double>(random_() >> 11), -53)); } ///< in [0, 1)
    Rational small() { return Rational(1) / power_of_ten(below(300)); }
    static Rational power_of_ten(std::size_t k) { return *parse_rational("1e" + std::to_string(k)); }

    Rational load()
    {
        switch (below(8)) {
        case 0: return small();
        case 1: return 1 - small();
        case 2: return 1 + small();
        case 3: return *parse_rational(std::to_string(below(4) + 1) + "/4"); // sines of rational angles: ties and exact values
        case 4: return Rational(1);
        case 5: return 10 * binary64() + small();
        default: return binary64() + small();
        }
    }
    Rational place() ///< x, often on an end of what there is
    {
        switch (below(6)) {
        case 0: return Rational(0);
        case 1: return Rational(1, 2);
        case 2: return *parse_rational(std::to_string(below(7)) + "/12");
        case 3: return small() / 2;
        default: return binary64() / 2;
        }
    }
    Rational surface()
    {
        return Rational(below(4) == 0   ? Rational(2 + small())
                        : below(4) == 0 ? Rational(1 + small())
                                        : Rational(1 + 9 * binary64() + small()));
    }

    Rational input(const std::string& name, const Rational& given_load)
    {
        if (name == "load") return given_load;
        if (name == "x") return place();
        if (name == "p") return below(5) == 0 ? Rational(abs(given_load - 1) + small()) : Rational(place() * 4);
        if (name == "n") return Rational(static_cast<long>(1 + below(4)));
        if (name == "D") return below(3) == 0 ? Rational(3, 2) : Rational(1 + Rational(1 + 8 * binary64()) / 10);
        return name == "gamma" ? Rational(2 + 8 * binary64()) : surface();
    }

private:
    std::mt19937_64 random_;
};

/// |value - truth| within half a unit of the last digit, as the program claims; and that claim itself no wider than the digits.
void check(const Evaluation& e, const Real& truth, long digits, const std::string& what)
{
    const Rational value = *parse_rational(e.value), bound = e.error_bound.empty() ? Rational(0) : *parse_rational(e.error_bound);
    // a root of what is exactly 0 keeps half of the reference's digits
    const Real off = abs(real(value) - truth), arithmetic = abs(truth) * pow(Real(10), -(digits + 100)) +
                                                            pow(Real(10), 5 - static_cast<long>(Real::default_precision()) / 2);
    const bool sound = off <= real(bound) + arithmetic;
    const bool tight = e.status == Status::exact ||
                       (e.status == Status::certified && e.digits == digits && real(bound) <= abs(truth) * pow(Real(10), Real(1 - digits)));
    const bool nearest =
        !e.binary64 || abs(Real(*e.binary64) - truth) <=
                           abs(Real(std::nextafter(*e.binary64, HUGE_VAL)) - Real(std::nextafter(*e.binary64, -HUGE_VAL))) / 2 + arithmetic;
    if (sound && tight && nearest) return;
    const std::string text =
        fmt::format("{}: {} +/- {}, {};{}{}{} {}", what, e.value, e.error_bound, to_string(e.status), sound ? "" : " does not hold",
                    tight ? "" : " is wide", nearest ? "" : " binary64 is not nearest", truth.str(40));
    FAIL_CHECK(text);
}

std::string shown(const std::string& quantity, const std::map<std::string, Rational>& inputs, long digits)
{
    std::string text = quantity;
    for (const auto& [name, value] : inputs) text += " " + name + "=" + value.get_str();
    return text + " --digits " + std::to_string(digits);
}

} // namespace

TEST_CASE("closed forms hold what the equations give")
{
    const unsigned long seed = setting("TOUCHSTONE_SEED", 20261122), count = setting("TOUCHSTONE_COUNT", 1'000'000);
    std::cout << "seed " << seed << ", " << count << " cases of " << cases().size() << " quantities" << std::endl;
    Draw draw(seed);
    unsigned long held = 0, exact = 0;
    for (unsigned long i = 0; i < count; ++i) {
        const Case& c = cases()[draw.below(cases().size())];
        const Quantity& q = *find_quantity(c.quantity);
        const long digits = draw.below(10) == 0 ? static_cast<long>(1 + draw.below(200)) : static_cast<long>(1 + draw.below(25));
        const Rational load = draw.load();
        std::map<std::string, Rational> inputs;
        for (const std::string& name : q.inputs) inputs[name] = draw.input(name, load);
        try {
            q.check(Inputs(inputs));
        }
        catch (const DomainError&) {
            continue;
        }
        Real::default_precision(c.subtracts ? static_cast<unsigned>(digits + spare_digits(inputs)) : digits <= 25 ? 180 : 360);
        const Evaluation e = evaluate(q, Inputs(inputs), {.digits = digits});
        check(e, c.value([&](const char* name) { return real(inputs.at(name)); }), digits, shown(c.quantity, inputs, digits));
        ++held;
        exact += e.status == Status::exact ? 1 : 0;
    }
    std::cout << held << " in their domain, " << exact << " of them exact" << std::endl;
    CHECK(held > count / 2);
}

TEST_CASE("areas of the recursion hold what the other proof gives at ten digits more")
{
    const unsigned long seed = setting("TOUCHSTONE_SEED", 20261122), count = setting("TOUCHSTONE_AREAS", 10'000);
    std::cout << "seed " << seed << ", " << count << " areas" << std::endl;
    Draw draw(seed);
    const Quantity& q = *find_quantity("contact.area");
    constexpr long digits = 12;
    unsigned long held = 0;
    for (unsigned long i = 0; i < count; ++i) {
        const std::vector<Rational> surfaces{Rational(9, 4), Rational(5, 2), Rational(3), Rational(5), Rational(20), Rational(1000)};
        Rational load = draw.load();
        if (load > 1) load = 1 / load;
        if (load < Rational(1, 1'000'000'000)) continue; // a mesh for each: forward_campaign and the tests of light loads have those
        const std::map<std::string, Rational> inputs{
            {"n", Rational(static_cast<long>(draw.below(21)))}, {"load", load}, {"G", surfaces[draw.below(surfaces.size())]}};
        const Inputs in(inputs);
        const Plan plan = plan_of(q, in, {digits});
        if (plan.proofs.size() < 2) continue;
        const Evaluation e = evaluate(q, in, {.digits = digits});
        const WorkingPrecision precision(256);
        const Ball other = plan.proofs[1].ball({digits + 10});
        const Ball printed = Ball(*parse_rational(e.value)), bound = Ball(*parse_rational(e.error_bound));
        CHECK_MESSAGE(!certainly(less(bound, abs(printed - other))), shown("contact.area", inputs, digits), ": ", e.value);
        CHECK_MESSAGE((e.status == Status::exact || e.digits == digits), shown("contact.area", inputs, digits), ": ", e.note);
        ++held;
    }
    std::cout << held << " areas with two proofs" << std::endl;
    CHECK(held > count / 2);
}
