// SPDX-License-Identifier: MIT
#include "touchstone/oracle/mixup.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/segments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace touchstone::oracle {
namespace {

constexpr std::size_t most_rows = 96;
constexpr slong bits = 160;

using Values = std::map<std::string, Rational>;

/// What a subject did to the inputs before a right formula. Nothing: it cannot be applied to this row.
struct InputMistake {
    std::string name;
    int cost;
    std::function<bool(Values&)> apply;
};

/// What a subject did to the right value.
struct OutputMistake {
    std::string name;
    int cost;
    std::function<Ball(const Ball&, const Inputs&)> apply;
};

/// Another formula altogether.
struct OtherFormula {
    std::string quantity, name;
    std::function<Ball(const Inputs&)> value;
};

/// pi as a rational number close enough that nobody can tell at a part in 2^20.
Rational rational_pi() { return Rational(245850922, 78256779); }

struct Factor {
    std::string name;
    Rational value;
};

/// Factors that conventions differ by, of a length measured across the contact or of anything else. nu = 0.3 is steel's;
/// other ratios are found by fitting.
std::vector<Factor> convention_factors(bool width)
{
    const Rational pi = rational_pi();
    const std::string two = width ? "full width for half width" : "2: peak-to-valley for amplitude, or 2E* for E*";
    const std::string half = width ? "quarter width for half width" : "1/2: amplitude for peak-to-valley, or E* for 2E*";
    return {{two, 2}, {half, Rational(1, 2)}, {"pi", pi}, {"1/pi", 1 / pi}, {"2 pi", 2 * pi}, {"1/(2 pi)", 1 / (2 * pi)},
            {"4", 4}, {"1/4", Rational(1, 4)}, {"1 - nu^2: E for E/(1 - nu^2), nu = 0.3", Rational(91, 100)},
            {"1/(1 - nu^2): E/(1 - nu^2) for E, nu = 0.3", Rational(100, 91)},
            {"2 (1 - nu^2): E for 2E*, nu = 0.3", Rational(182, 100)}, {"1/(2 (1 - nu^2)): 2E* for E, nu = 0.3", Rational(100, 182)}};
}

bool takes(const Quantity& q, const std::string& key) { return std::find(q.inputs.begin(), q.inputs.end(), key) != q.inputs.end(); }

std::vector<InputMistake> input_mistakes(const Quantity& q)
{
    std::vector<InputMistake> all{{"", 0, [](Values&) { return true; }}};
    const auto scaled = [&all](const std::string& what, const std::vector<std::string>& keys, const Factor& f, int cost) {
        all.push_back({fmt::format("{} taken times {}", what, f.name), cost, [keys, c = f.value](Values& v) {
                           for (const auto& key : keys) v[key] *= c;
                           return true;
                       }});
    };
    for (const Factor& f : convention_factors(false)) {
        if (takes(q, "load") && takes(q, "p")) scaled("load and p (that is, p*)", {"load", "p"}, f, 2);
        if (takes(q, "load")) scaled("load", {"load"}, f, 2);
        if (takes(q, "p")) scaled("p", {"p"}, f, 2);
        if (takes(q, "x")) scaled("x (that is, lambda)", {"x"}, f, 2);
    }
    if (takes(q, "a")) // the half-width of a contact
        for (const Factor& f : convention_factors(true)) scaled("a (that is, lambda)", {"a"}, f, 2);
    if (takes(q, "p") && takes(q, "load")) {
        all.push_back({"p taken in units of the mean pressure, not of p*", 1, [](Values& v) { v["p"] *= v["load"]; return true; }});
        all.push_back({"p divided by the mean pressure", 1, [](Values& v) { v["p"] /= v["load"]; return true; }});
    }
    if (takes(q, "x"))
        all.push_back({"origin at the valley, not at the peak", 1, [](Values& v) { v["x"] = Rational(1, 2) - abs(v["x"]); return true; }});
    if (takes(q, "n")) {
        all.push_back({"n counted from 1, not from 0", 1, [](Values& v) { v["n"] -= 1; return v["n"] >= 0; }});
        all.push_back({"n + 1 for n", 1, [](Values& v) { v["n"] += 1; return true; }});
    }
    return all;
}

std::vector<OutputMistake> output_mistakes(const Quantity& q)
{
    std::vector<OutputMistake> all{{"", 0, [](const Ball& v, const Inputs&) { return v; }}};
    for (const Factor& f : convention_factors(q.name.ends_with("half_width")))
        all.push_back({"factor " + f.name, 1, [c = f.value](const Ball& v, const Inputs&) { return v * Ball(c); }});
    all.push_back({"opposite sign", 1, [](const Ball& v, const Inputs&) { return -v; }});
    if (takes(q, "load")) {
        all.push_back({"in units of the mean pressure, p/pbar for p/p*", 1, [](const Ball& v, const Inputs& in) { return v / in.ball("load"); }});
        all.push_back({"multiplied by the load", 1, [](const Ball& v, const Inputs& in) { return v * in.ball("load"); }});
    }
    return all;
}

/// (7.17) as printed, with the exponent n + 2^-n and the product of Gamma(1 - h)/Gamma(3/2 - h).
Ball K_as_printed(long n)
{
    Ball K = pow(Ball(2), Ball(Rational(n)) + power_of_two<Ball>(-n)) / pow(pi<Ball>(), Ball(Rational(n + 2, 2)));
    for (long i = 0; i < n; ++i) {
        const Ball h = power_of_two<Ball>(-(i + 2));
        K = K * gamma_function(Ball(1 - h)) / gamma_function(Ball(Ball(Rational(3, 2)) - h));
    }
    return K;
}

const std::vector<OtherFormula>& other_formulas()
{
    static const std::vector<OtherFormula> all{
        {"archard.K", "(7.17) as the paper prints it", [](const Inputs& in) { return K_as_printed(in.integer("n")); }},
        {"archard.area", "(7.18) as the paper prints it",
         [](const Inputs& in) { return archard::area(in.integer("n"), in.ball("load"), in.G_ball(), K_as_printed(in.integer("n"))); }},
        {"archard.segments", "(8.2) with K of (7.17) as the paper prints it",
         [](const Inputs& in) {
             return archard::segments(in.integer("n"), in.ball("load"), in.ball("D"), in.ball("gamma"), K_as_printed(in.integer("n") - 1));
         }},
        {"segments.max_half_width", "(9.4) as the paper prints it, without the square root",
         [](const Inputs& in) {
             const long n = in.integer("n");
             const Ball x = n == 0 ? in.ball("load") : peaks::iterate(n - 1, in.ball("load"), in.G_ball());
             return asin(at_most(x, Ball(1))) / pi<Ball>();
         }},
        {"westergaard.half_width", "the Hertzian half-width (2.7)", [](const Inputs& in) { return hertz::half_width(in.ball("load")); }},
        {"westergaard.pressure", "the Hertzian pressure (2.6)", [](const Inputs& in) { return hertz::pressure(in.ball("x"), in.ball("load")); }},
        {"westergaard.pressure", "(2.2) cut off at zero: the full-contact pressure where contact is partial",
         [](const Inputs& in) { return at_least(westergaard::pressure_full(in.ball("x"), in.ball("load")), Ball(0)); }},
        {"hertz.half_width", "Westergaard's half-width (2.5)", [](const Inputs& in) { return westergaard::half_width(in.ball("load")); }},
        {"hertz.pressure", "Westergaard's pressure (2.4)", [](const Inputs& in) { return westergaard::pressure(in.ball("x"), in.ball("load")); }},
    };
    return all;
}

/// The same to a part in 2^20. A value known no better than that is never the same.
bool alike(const Ball& a, const Ball& b)
{
    if (arb_is_zero(a.get()) && arb_is_zero(b.get())) return true;
    return certainly(less(power_of_two<Ball>(20) * abs(a - b), abs(b)));
}

/// The rows looked at, with what is known of each.
struct Evidence {
    Inputs in;
    Ball truth, answer;
    bool right;
};

struct Score {
    std::size_t telling = 0, matched = 0;
    double share() const { return telling < 3 ? 0 : static_cast<double>(matched) / static_cast<double>(telling); }
};

/// `value(row)` is what the candidate would have answered; nothing if it says nothing about the row.
template <class Value>
Score score(const std::vector<Evidence>& rows, Value value)
{
    Score s;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::optional<Ball> v = value(i);
        if (!v || !v->is_finite()) continue;
        const bool matches = alike(rows[i].answer, *v);
        if (rows[i].right && alike(*v, rows[i].truth)) continue;
        ++s.telling;
        s.matched += matches;
    }
    // what it says nothing about it does not explain: at least half of the wrong rows must be covered
    const auto wrong = static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const Evidence& e) { return !e.right; }));
    return 2 * s.telling < wrong ? Score{} : s;
}

std::vector<Evidence> evidence(const Quantity& q, const std::vector<Question>& questions, const std::vector<double>& answers)
{
    std::vector<Evidence> rows;
    const std::size_t stride = (questions.size() + most_rows - 1) / most_rows;
    for (std::size_t i = 0; i < questions.size(); i += std::max<std::size_t>(1, stride)) {
        if (!std::isfinite(answers[i])) continue;
        Evidence e{exact_inputs(q, questions[i].inputs), Ball(questions[i].truth.value), Ball::exactly(answers[i]), false};
        e.right = alike(e.answer, e.truth);
        rows.push_back(std::move(e));
    }
    return rows;
}

std::optional<Ball> value_of(const Quantity& q, const Inputs& in)
{
    try {
        q.check(in);
        return first_ball(q, in);
    }
    catch (const DomainError&) {
        return std::nullopt;
    }
    catch (const BeyondReach&) {
        return std::nullopt;
    }
}

struct Best {
    MixUp mixup;
    int cost = 0;
    void offer(const std::string& name, const Score& s, int c)
    {
        const double share = s.share();
        if (share < 0.9) return;
        if (share > mixup.explains + 0.02 || (share > mixup.explains - 0.02 && c < cost)) {
            mixup = {name, share};
            cost = c;
        }
    }
};

/// One factor for all rows that is in no list: the median of answer/truth, and the Poisson's ratio it would be.
void try_fitted_factor(const std::vector<Evidence>& rows, Best& best)
{
    std::vector<double> ratios;
    for (const auto& e : rows)
        if (!arb_contains_zero(e.truth.get())) ratios.push_back(arf_get_d(arb_midref((e.answer / e.truth).get()), ARF_RND_NEAR));
    if (ratios.size() < 3) return;
    std::nth_element(ratios.begin(), ratios.begin() + static_cast<long>(ratios.size() / 2), ratios.end());
    const double c = ratios[ratios.size() / 2];
    if (!std::isfinite(c) || c == 0) return;
    std::string name = fmt::format("factor {:.7g} throughout", c);
    const double complement = c < 1 ? 1 - c : 1 - 1 / c;
    if (complement > 0 && complement <= 0.25)
        name += fmt::format(": {} with nu = {:.4g}", c < 1 ? "1 - nu^2, E for E/(1 - nu^2)," : "1/(1 - nu^2), E/(1 - nu^2) for E,", std::sqrt(complement));
    const Ball factor = Ball::exactly(c);
    best.offer(name, score(rows, [&](std::size_t i) { return std::optional(rows[i].truth * factor); }), 3);
}

} // namespace

std::optional<MixUp> find_mixup(const Quantity& q, const std::vector<Question>& questions, const std::vector<double>& answers)
{
    const WorkingPrecision precision(bits);
    const auto rows = evidence(q, questions, answers);
    if (std::count_if(rows.begin(), rows.end(), [](const Evidence& e) { return !e.right; }) < 3) return std::nullopt;
    Best best;
    for (const auto& f : other_formulas()) {
        if (f.quantity != q.name) continue;
        best.offer(f.name, score(rows, [&](std::size_t i) { return std::optional(f.value(rows[i].in)); }), 1);
    }
    const auto outputs = output_mistakes(q);
    for (const auto& mistake : input_mistakes(q)) {
        std::vector<std::optional<Ball>> values;
        for (const auto& e : rows) {
            Values moved = e.in.values();
            if (mistake.cost == 0) values.emplace_back(e.truth);
            else values.push_back(mistake.apply(moved) ? value_of(q, Inputs(std::move(moved))) : std::nullopt);
        }
        for (const auto& o : outputs) {
            if (mistake.cost == 0 && o.cost == 0) continue;
            const std::string name = mistake.name.empty() ? o.name : o.name.empty() ? mistake.name : mistake.name + "; " + o.name;
            best.offer(name, score(rows, [&](std::size_t i) { return values[i] ? std::optional(o.apply(*values[i], rows[i].in)) : std::nullopt; }),
                       mistake.cost + o.cost);
        }
    }
    try_fitted_factor(rows, best);
    return best.mixup.name.empty() ? std::nullopt : std::optional(best.mixup);
}

} // namespace touchstone::oracle
