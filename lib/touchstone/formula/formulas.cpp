// SPDX-License-Identifier: MIT
#include "touchstone/formula/formulas.hpp"

#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/gap.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/segments.hpp"
#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/paper/westergaard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace touchstone::formula {
namespace {

constexpr long most_scales = 30; ///< written out one after another

/// (7.20), to the digits of binary64; a test compares it with archard.K_inf.
constexpr const char* K_infinity = "0.3913876963120100124";

using Build = std::function<Term(const std::function<Term(const char*)>& in, long n)>;

struct Entry {
    Build stable, printed;
};

Term by_load(const Term& load, const Term& partial, const Term& full) { return select(load, Term(1), partial, full); }

/// The density inside its support; 0 outside, as the library decides it.
Term density(const Term& p, const Term& load)
{
    const Term root = sqrt_minus_square(Term(4 * load), p);
    const Term partial = select(Term(0), root, Term::call("density_partial", {p, load}), Term(0));
    const Term low = westergaard::above_lowest(p, load), high = westergaard::below_highest(p, load);
    return by_load(load, partial, select(low, Term(0), Term(0), select(high, Term(0), Term(0), westergaard::density_full(p, load))));
}

const std::map<std::string, Entry>& entries()
{
    static const std::map<std::string, Entry> all{
        {"westergaard.half_width",
         {[](auto in, long) { return westergaard::half_width(in("load")); },
          [](auto in, long) { return as_printed::half_width(in("load")); }}},
        {"westergaard.pressure",
         {[](auto in, long) { return westergaard::pressure(in("x"), in("load")); },
          [](auto in, long) {
              return by_load(in("load"), as_printed::pressure_partial(in("x"), in("load")), as_printed::pressure_full(in("x"), in("load")));
          }}},
        {"westergaard.exceedance",
         {[](auto in, long) { return westergaard::exceedance(in("p"), in("load")); },
          [](auto in, long) {
              return by_load(in("load"), as_printed::exceedance_partial(in("p"), in("load")),
                             as_printed::exceedance_full(in("p"), in("load")));
          }}},
        {"westergaard.density",
         {[](auto in, long) { return density(in("p"), in("load")); },
          [](auto in, long) {
              return by_load(in("load"), as_printed::density_partial(in("p"), in("load")), as_printed::density_full(in("p"), in("load")));
          }}},
        {"westergaard.energy", {[](auto in, long) { return westergaard::energy(in("load")); }, {}}},
        {"westergaard.gap",
         {[](auto in, long) { return westergaard::gap(in("x"), in("load")); },
          [](auto in, long) { return by_load(in("load"), westergaard::gap_closed_form(in("x"), in("load")), Term(0)); }}},
        {"westergaard.mean_gap", {[](auto in, long) { return westergaard::mean_gap(in("load")); }, {}}},
        {"hertz.gap", {[](auto in, long) { return hertz::gap(in("x"), in("load")); }, {}}},
        {"hertz.half_width", {[](auto in, long) { return hertz::half_width(in("load")); }, {}}},
        {"hertz.pressure",
         {[](auto in, long) { return hertz::pressure(in("x"), in("load")); },
          [](auto in, long) { return as_printed::hertz_pressure(in("x"), in("load")); }}},
        {"weierstrass.bound",
         {[](auto in, long) { return weierstrass::bound(in("D"), in("gamma")); },
          [](auto in, long) { return 1 / (1 - pow(in("gamma"), in("D") - 2)); }}},
        {"peaks.f", {[](auto in, long) { return peaks::f(in("x")); }, {}}},
        {"peaks.fixed_point",
         {[](auto in, long) { return peaks::fixed_point(in("G")); },
          [](auto in, long) { return select(in("G"), Term(2), 1 / (in("G") - 1), 4 / (in("G") * in("G"))); }}},
        {"peaks.iterate", {[](auto in, long n) { return peaks::iterate(n, in("load"), in("G")); }, {}}},
        {"archard.K", {[](auto, long n) { return archard::K_by_recursion<Term>(n); }, {}}},
        {"archard.delta", {[](auto, long n) { return archard::delta<Term>(n); }, {}}},
        {"archard.alpha", {[](auto in, long n) { return archard::alpha<Term>(n, in("D")); }, {}}},
        {"archard.area", {[](auto in, long n) { return archard::area(n, in("load"), in("G"), archard::K_by_recursion<Term>(n)); }, {}}},
        {"archard.segments",
         {[](auto in, long n) { return archard::segments(n, in("load"), in("D"), in("gamma"), archard::K_by_recursion<Term>(n - 1)); },
          {}}},
        {"archard.segments_limit",
         {[](auto in, long n) { return archard::segments_limit(n, in("load"), in("D"), in("gamma"), Term::literal(K_infinity)); }, {}}},
        {"segments.max_half_width", {[](auto in, long n) { return segments::max_half_width(n, in("load"), in("G")); }, {}}},
    };
    return all;
}

/// (a - (pi x)^2) with pi x carried to twice the precision
Term minus_pi_square(const Term& a, const Term& x) { return Term::call("minus_pi_square", {a, x}); }
Term minus_sin_square(const Term& a, const Term& x) { return Term::call("minus_sin_square", {a, x}); }
Term fma(const Term& a, const Term& b, const Term& c) { return Term::call("fma", {a, b, c}); }
Term absolute(const Term& x) { return Term::call("abs", {x}); }
Term positive(const Term& x) { return sqrt(at_least(x, Term(0))); }
/// A binary64 constant in the shortest decimal that reads back as it.
Term constant(double value)
{
    const Term size = Term::literal(fmt::format("{}", std::fabs(value)));
    return value < 0 ? -size : size;
}

/// The power of two by which numbers whose square is near tiny a are scaled.
Term scale(const Term& a) { return select(a, constant(0x1p-800), constant(0x1p500), Term(1)); }
/// x less its nearest even number, exactly: an angle in half turns.
Term turn(const Term& x) { return x - 2 * Term::call("nearest", {x / 2}); }

/// touchstone::sum_of_powers, written down.
template <std::size_t n>
Term sum_of_powers(const std::array<double, n>& terms, const Term& x)
{
    static_assert(n % 2 == 0);
    const Term square = x * x;
    Term even = constant(terms[n - 2]), odd = constant(terms[n - 1]);
    for (std::size_t j = n - 2; j != 0; j -= 2) {
        even = even * square + constant(terms[j - 2]);
        odd = odd * square + constant(terms[j - 1]);
    }
    return even + x * odd;
}

std::map<std::string, Helper> make_helpers()
{
    const Term a = Term::input("a"), b = Term::input("b"), c = Term::input("c"), x = Term::input("x"), y = Term::input("y");
    const Term pi_ = pi<Term>(), half = ratio<1, 2, Term>(), quarter = ratio<1, 4, Term>();
    std::map<std::string, Helper> h;
    const Term t = turn(x), m = absolute(t), s = sin(pi_ * at_most(m, 1 - m));
    h["sin_pi"] = {{"x"}, select(t, Term(0), -s, s)};
    h["cos_pi"] = {{"x"}, sin(pi_ * (half - m))};
    h["powm1"] = {{"x", "y"}, Term::call("expm1", {y * log(x)})};
    h["sqrt_positive_part"] = {{"x"}, positive(x)};
    const Term f = scale(a);
    h["sqrt_minus_square"] = {{"a", "b"}, positive(fma(-(b * f), b * f, a * f * f)) / f};
    h["sqrt_minus_pi_square"] = {{"a", "x"}, positive(minus_pi_square(a * f * f, x * f)) / f};
    const Term z = pi_ * x;
    const Term low = fma(pi_, x, -z) + constant(std::sin(std::numbers::pi)) * x; // what the binary64 pi lacks of pi
    h["minus_pi_square"] = {{"a", "x"}, fma(-z, z, a) - 2 * z * low};
    const Term square = (pi_ * x) * (pi_ * x);
    h["minus_sin_square"] = {{"a", "x"}, minus_pi_square(a, x) + square * square * sum_of_powers(sine_terms, square)};
    // the gap's roots: the same differences, the other way round
    h["sqrt_pi_square_minus"] = {
        {"x", "a"},
        select(a, constant(0x1p-800),
               select(constant(0x1p-300), absolute(x), pi_ * absolute(x), positive(-minus_pi_square(a * f * f, x * f)) / f),
               positive(-minus_pi_square(a, x)))};
    const Term far = positive(minus_sin_square(1 - a, half - absolute(x)));
    const Term close = select(
        a, constant(0x1p-800),
        select(constant(0x1p-300), absolute(x), ScalarTraits<Term>::sin_pi(absolute(x)), ScalarTraits<Term>::sqrt_pi_square_minus(x, a)),
        positive(-minus_sin_square(a, absolute(x))));
    h["sqrt_sin_pi_square_minus"] = {
        {"x", "a"}, select(Term::literal("0.3"), absolute(x), far, select(quarter, absolute(x), select(a, half, close, far), close))};
    const auto half_angle = [](const Term& of) { const Term root = 1 + sqrt(1 - of); return of / (root * root); };
    const auto doubled = [](const Term& half_of, const Term& sum) { return (1 + half_of) * (1 + (1 - half_of) * sum) / 4; };
    const Term once = half_angle(x), twice = half_angle(once);
    h["series_3_15"] = {{"x"}, doubled(once, doubled(twice, sum_of_powers(detail::gap_terms, twice)))};
    const Term root = 1 + sqrt(1 - x), tangent = x / (root * root), its_square = tangent * tangent;
    h["series_2_6"] = {{"x"}, (1 + tangent * (1 + (1 - its_square) * sum_of_powers(detail::gap_terms, its_square))) / 2};
    const Term of_smaller = asin(sqrt(at_most(at_least(1 - x, Term(0)), x))) / pi_;
    h["asin_sqrt_over_pi"] = {{"x"}, select(half, x, half - of_smaller, of_smaller)};
    const Term n = at_least(a, Term(0)), d = at_least(b, Term(0)), of_quotient = asin(sqrt(at_most(n, d) / (n + d))) / pi_;
    h["atan_sqrt_over_pi"] = {{"a", "b"}, select(d, n, half - of_quotient, of_quotient)};
    h["atan_minus_square_over_pi"] = {{"a", "b", "c"},
                                      select(a, constant(0x1p-800), atan2(ScalarTraits<Term>::sqrt_minus_square(a, b), sqrt(c)) / pi_,
                                             ScalarTraits<Term>::atan_sqrt_over_pi(fma(-b, b, a), c))};
    const Term squares = a * a + b * b, hypot = Term::call("hypot", {a, b});
    h["root_of_squares"] = {{"a", "b"},
                            select(constant(0x1p-900), squares, select(squares, constant(0x1p900), sqrt(squares), hypot), hypot)};
    const Term share = 1 - b, sum_of_squares = share * share + a * a, room = at_least(fma(-a, a, 4 * b), Term(0)),
               least = constant(0x1p-300);
    const Term safe = westergaard::density_partial(a, b, ScalarTraits<Term>::sqrt_minus_square(4 * b, a));
    h["density_partial"] = {
        {"a", "b"},
        select(least, sum_of_squares, select(least, b, westergaard::density_under_one_root(a, b, sum_of_squares, room), safe), safe)};
    const Term e = a * b;
    h["pow_product"] = {{"x", "a", "b"}, pow(x, e) * (1 + fma(a, b, -e) * log(x))};
    const Term size = absolute(x);
    h["sqrt_minus_sin_pi_square"] = {
        {"a", "x"},
        select(quarter, size, positive(-minus_sin_square(1 - a, half - size)),
               select(a, constant(0x1p-800), ScalarTraits<Term>::sqrt_minus_pi_square(a, x), positive(minus_sin_square(a, size))))};
    // for languages without it: a product in two parts (Veltkamp and Dekker) and a sum in two parts (Knuth)
    const auto high = [](const Term& v) {
        const Term g = Term(134217729) * v;
        return g - (g - v);
    };
    const Term ah = high(a), al = a - ah, bh = high(b), bl = b - bh, p = a * b;
    const Term rest = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
    const Term sum = p + c, part = sum - p;
    h["fma"] = {{"a", "b", "c"}, sum + (((p - (sum - part)) + (c - part)) + rest)};
    return h;
}

} // namespace

const std::map<std::string, Helper>& helpers()
{
    static const std::map<std::string, Helper> all = make_helpers();
    return all;
}

std::string identifier(std::string quantity)
{
    std::replace(quantity.begin(), quantity.end(), '.', '_');
    return quantity;
}

Term mathematical(const Term& t)
{
    if (t->op != Op::call) return t;
    const auto& a = t->arguments;
    const auto root_of = [](const Term& x) { return sqrt(x); };
    const auto square = [](const Term& x) { return pow(x, Term(2)); };
    if (t->text == "sin_pi") return sin(pi<Term>() * a[0]);
    if (t->text == "cos_pi") return cos(pi<Term>() * a[0]);
    if (t->text == "powm1") return pow(a[0], a[1]) - 1;
    if (t->text == "sqrt_positive_part") return root_of(at_least(a[0], Term(0)));
    if (t->text == "sqrt_minus_square") return root_of(at_least(a[0] - square(a[1]), Term(0)));
    if (t->text == "sqrt_minus_pi_square") return root_of(at_least(a[0] - square(pi<Term>() * a[1]), Term(0)));
    if (t->text == "sqrt_minus_sin_pi_square") return root_of(at_least(a[0] - square(sin(pi<Term>() * a[1])), Term(0)));
    if (t->text == "sqrt_pi_square_minus") return root_of(at_least(square(pi<Term>() * a[0]) - a[1], Term(0)));
    if (t->text == "sqrt_sin_pi_square_minus") return root_of(at_least(square(sin(pi<Term>() * a[0])) - a[1], Term(0)));
    if (t->text == "pow_product") return pow(a[0], a[1] * a[2]);
    if (t->text == "series_2_6") return select(Term(0), a[0], (a[0] + (1 - a[0]) * log(1 - a[0])) / square(a[0]), ratio<1, 2, Term>());
    if (t->text == "series_3_15") { // artanh by its logarithm
        const Term s = sqrt(a[0]), artanh = log((1 + s) / (1 - s)) / 2;
        return select(Term(0), a[0], ((1 - 1 / a[0]) * artanh / s + 1 / a[0]) / 2, ratio<1, 3, Term>());
    }
    if (t->text == "asin_sqrt_over_pi") return ComposedTraits<Term>::asin_sqrt_over_pi(a[0]);
    if (t->text == "atan_sqrt_over_pi") return ComposedTraits<Term>::atan_sqrt_over_pi(a[0], a[1]);
    if (t->text == "atan_minus_square_over_pi") return ComposedTraits<Term>::atan_minus_square_over_pi(a[0], a[1], a[2]);
    if (t->text == "density_partial") return westergaard::density_partial(a[0], a[1], root_of(4 * a[1] - square(a[0])));
    if (t->text == "root_of_squares") return root_of(square(a[0]) + square(a[1]));
    return t;
}

Formula formula_of(std::string_view name, std::optional<long> n)
{
    const Quantity* q = find_quantity(name);
    if (q == nullptr) throw DomainError(fmt::format("unknown quantity '{}'; nearest is '{}'", name, nearest_name(name, quantity_names())));
    const auto entry = entries().find(q->name);
    if (entry == entries().end()) {
        std::string all;
        for (const auto& [other, unused] : entries()) all += (all.empty() ? "" : ", ") + other;
        throw DomainError(fmt::format("{} is no closed formula in elementary functions; these are: {}", name, all));
    }
    Formula f{q->name, {}, Term(0), std::nullopt};
    bool scale = false;
    for (const auto& input : q->inputs) {
        if (input == "n") scale = true;
        else f.inputs.push_back(input);
    }
    if (scale && !n) throw DomainError(fmt::format("{} is written out for one scale: give n=0, 1, ... {}", name, most_scales));
    if (!scale && n) throw DomainError(fmt::format("{} has no n", name));
    const long first = name.starts_with("archard.segments") ? 1 : 0;
    if (n && (*n < first || *n > most_scales))
        throw DomainError(fmt::format("n = {}: must be an integer from {} to {}", *n, first, most_scales));
    std::map<std::string, Term> inputs; // the same node wherever it occurs
    for (const auto& input : f.inputs) inputs.emplace(input, Term::input(input));
    const auto in = [&inputs](const char* key) { return inputs.at(key); };
    f.stable = entry->second.stable(in, n.value_or(0));
    if (entry->second.printed) f.printed = entry->second.printed(in, n.value_or(0));
    return f;
}

} // namespace touchstone::formula
