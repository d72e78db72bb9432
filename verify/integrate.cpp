// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone integrate`: the integral of a typed formula, with a proof.
#include "touchstone/quadrature/path.hpp"
#include "touchstone/rounding/decimal.hpp"
#include "touchstone/scalar/rational_text.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/progress.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace touchstone::program {
namespace {

struct IntegrateOptions {
    std::string formula, from, to, path, at, principal_value, tolerance;
    std::vector<std::string> set;
    long digits = 30;
    bool json = false, explain = false;
};

/// What is printed of an enclosure: digits that every number in it rounds to.
struct Shown {
    std::string value, error;
    long digits = 0;
    std::string imaginary; ///< of a complex value, to the same decimal place
    bool is_within_tolerance = false;
};

Shown shown(const Ball& value, long digits)
{
    for (long d = digits; d > 0; --d)
        if (const auto decimal = round_to_digits(value, d)) return {decimal->text(), decimal->half_unit(), d, ""};
    return {};
}

/// As many digits as an absolute error asks for; 0 if the enclosure has 0 in it and is that small.
Shown shown_within(const Ball& value, const Rational& tolerance, const std::string& text)
{
    const Ball size = abs(value);
    if (value.contains_zero()) return arb_le(size.get(), Ball(tolerance).get()) ? Shown{"0", text, 0, "", true} : Shown{};
    const long most =
        static_cast<long>(static_cast<double>(std::max<slong>(0, std::min<slong>(value.relative_bits(), 40000))) * 0.30103) + 1;
    for (long d = 1; d <= most; ++d)
        if (const auto decimal = round_to_digits(value, d); decimal && *parse_rational(decimal->half_unit()) <= tolerance)
            return {decimal->text(), decimal->half_unit(), d, "", true};
    return {};
}

/// The multiple of 10^place that all numbers of the ball round to.
std::optional<std::string> rounded_to_place(const Ball& x, long place, long digits)
{
    const WorkingPrecision precision(2 * bits_for_digits(digits) + 64);
    Ball units = x * Ball(power(Rational(10), -place)) + Ball(1) / Ball(2), n;
    arb_floor(n.get(), units.get(), WorkingPrecision::bits());
    const auto whole = exact_value(n);
    if (!whole) return std::nullopt;
    Decimal d;
    d.negative = *whole < 0;
    d.digits = *whole == 0 ? "" : Integer(abs(whole->get_num())).get_str();
    d.exponent = place + static_cast<long>(d.digits.size());
    return d.digits.empty() ? "0" : d.text();
}

/// Of the modulus, when both parts are rounded: sqrt 2 half units, 5 sqrt 2 < 7.1.
std::string half_unit_of_modulus(const Decimal& part) { return "7.1" + part.half_unit().substr(1); }

/// A complex value: N digits of the larger part, the smaller to the same place.
Shown shown(const Ball& real, const Ball& imaginary, long digits)
{
    const bool real_is_larger = arf_cmpabs(arb_midref(real.get()), arb_midref(imaginary.get())) >= 0;
    const Ball &large = real_is_larger ? real : imaginary, &small = real_is_larger ? imaginary : real;
    for (long d = digits; d > 0; --d) {
        const auto decimal = round_to_digits(large, d);
        if (!decimal || decimal->digits.empty()) continue;
        const auto other = rounded_to_place(small, decimal->exponent - static_cast<long>(decimal->digits.size()), digits);
        if (!other) continue;
        return {real_is_larger ? decimal->text() : *other, half_unit_of_modulus(*decimal), d, real_is_larger ? *other : decimal->text()};
    }
    return {};
}

quadrature::Vertex vertex_of(const std::string& text, const char* what, const quadrature::Parameters& parameters)
{
    try {
        return quadrature::parse_vertex(text, parameters);
    }
    catch (const quadrature::ExpressionError& e) {
        throw Failure(bad_input, fmt::format("{} '{:.60}': {} (an end is a number such as 0, 1/3, pi/2, log(2), 1+i, inf, -inf, i*inf)",
                                             what, text, e.what()));
    }
}

quadrature::Limit limit_of(const std::string& text, const char* what)
{
    try {
        return quadrature::parse_limit(text);
    }
    catch (const quadrature::ExpressionError& e) {
        throw Failure(bad_input,
                      fmt::format("{} '{:.60}': {} (a place is a number such as 0, 1/3, pi/2, log(2))", what, text, e.what()));
    }
}

/// What stands between the separators.
std::vector<std::string> words_of(const std::string& text, char separator)
{
    std::vector<std::string> words;
    int depth = 0;
    std::string word;
    for (const char c : text) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == separator && depth == 0)
            words.push_back(std::exchange(word, ""));
        else
            word += c;
    }
    if (!text.empty()) words.push_back(word); // "x;" has an empty second word, which is no formula
    return words;
}

std::vector<quadrature::Limit> points_of(const std::string& text, const char* what)
{
    std::vector<quadrature::Limit> points;
    for (const std::string& word : words_of(text, ',')) points.push_back(limit_of(word, what));
    return points;
}

/// --set a=0.5 --set b=1/3+/-1e-20
quadrature::Parameters parameters_of(const std::vector<std::string>& set)
{
    quadrature::Parameters parameters;
    for (const std::string& word : set) {
        const auto equals = word.find('=');
        const std::string name = word.substr(0, equals);
        if (equals == std::string::npos || !quadrature::is_free_name(name))
            throw Failure(bad_input, fmt::format("--set '{:.60}': NAME=NUMBER or NAME=NUMBER+/-RADIUS, the name one that means nothing yet "
                                                 "(a, b, c1, ...)",
                                                 word));
        try {
            if (!parameters.emplace(name, quadrature::parse_parameter(word.substr(equals + 1))).second)
                throw Failure(bad_input, fmt::format("--set: '{}' is set twice", name));
        }
        catch (const quadrature::ExpressionError& e) {
            throw Failure(bad_input, fmt::format("--set '{:.60}': {}", word, e.what()));
        }
    }
    return parameters;
}

bool has_certificate(const quadrature::Part& p) { return !p.certificate.panels.empty(); }

nlohmann::ordered_json as_json(const quadrature::Part& p)
{
    nlohmann::ordered_json j{
        {"from", p.from}, {"to", p.to}, {"rule", p.rule}, {"evaluations", p.evaluations}, {"enclosure", p.value.to_string(40)}};
    if (arb_is_zero(p.imaginary.get()) == 0) j["imaginary"] = p.imaginary.to_string(40);
    if (!p.proof.empty()) j["proof"] = p.proof;
    if (has_certificate(p)) j["certificate"] = nlohmann::ordered_json::parse(p.certificate.to_json());
    return j;
}

void explain(const quadrature::Part& p)
{
    const std::string imaginary = arb_is_zero(p.imaginary.get()) != 0 ? "" : fmt::format(" + i {}", p.imaginary.to_string(20));
    fmt::print("  [{}, {}] {}, {} evaluations: {}{}\n", p.from, p.to, p.rule, p.evaluations, p.value.to_string(20), imaginary);
    if (!p.proof.empty()) {
        fmt::print("    {}\n", p.proof);
        return;
    }
    if (!has_certificate(p)) {
        fmt::print("    each panel is analytic on an ellipse that was enclosed (Arb's acb_calc_integrate)\n");
        return;
    }
    for (const auto& panel : p.certificate.panels)
        fmt::print(
            "    fractions {} to {}: |f dx/du| <= K u^({}-1) (1-u)^({}-1), strip |Im t| <= {:.4g}, {} pieces, step log(2)/{}, {} points\n",
            panel.from.get_str(), panel.to.get_str(), panel.alpha.to_string(), panel.beta.to_string(), panel.strip, panel.pieces, panel.m,
            panel.left_nodes + panel.right_nodes + 1);
    fmt::print("    |discretisation| <= {}, |truncation| <= {}, |rounding| <= {}\n", p.certificate.discretisation().to_string(3),
               p.certificate.truncation().to_string(3), p.certificate.rounding().to_string(3));
}

/// What is to be integrated, and along what: several formulas are separated by semicolons.
struct Problem {
    std::vector<std::string> texts;
    std::vector<quadrature::ExpressionPtr> formulas;
    std::vector<quadrature::Vertex> path;
};

quadrature::ExpressionPtr formula_of(const std::string& text, const quadrature::Parameters& parameters)
{
    try {
        return quadrature::parse_expression(text, parameters);
    }
    catch (const quadrature::ExpressionError& e) {
        throw Failure(bad_input, fmt::format("formula '{:.60}', {}", text, e.what()));
    }
}

/// The integral, and its digits.
struct Answer {
    quadrature::Integral integral;
    Shown shown;
};

/// By the tolerance, if there is one and it is reached; else the digits.
Shown shown(const quadrature::Integral& i, const IntegrateOptions& o, const std::optional<Rational>& asked)
{
    if (asked && !i.is_complex) {
        if (const Shown real = shown_within(i.value, *asked, o.tolerance); real.is_within_tolerance) return real;
    }
    else if (asked) {
        const Rational of_each = *asked * Rational(7, 10); // sqrt 2 times as much for both
        const Shown real = shown_within(i.value, of_each, o.tolerance), imaginary = shown_within(i.imaginary, of_each, o.tolerance);
        if (real.is_within_tolerance && imaginary.is_within_tolerance)
            return {real.value, o.tolerance, std::max(real.digits, imaginary.digits), imaginary.value, true};
    }
    return i.is_complex ? shown(i.value, i.imaginary, o.digits) : shown(i.value, o.digits);
}

std::vector<quadrature::Integral> integrals(const Problem& problem, const quadrature::IntegralOptions& options)
{
    const auto& path = problem.path;
    if (problem.formulas.size() > 1 && path.size() == 2 && path[0].is_real && path[1].is_real)
        return quadrature::integrate_several(problem.formulas, quadrature::limit_of(path[0]), quadrature::limit_of(path[1]), options);
    std::vector<quadrature::Integral> all;
    for (const auto& formula : problem.formulas) all.push_back(quadrature::integrate_along(formula, path, options));
    return all;
}

std::vector<Answer> computed(const IntegrateOptions& o, const Problem& problem, const quadrature::IntegralOptions& options,
                             const std::optional<Rational>& asked)
{
    std::vector<Answer> answers;
    for (const long more : {0L, 4L, 16L}) { // a value close to the middle between two decimals asks for more
        auto with_more = options;
        with_more.digits += more;
        answers.clear();
        try {
            for (auto& i : integrals(problem, with_more)) answers.push_back({std::move(i), {}});
        }
        catch (const quadrature::ExpressionError& e) {
            throw Failure(bad_input, fmt::format("formula '{:.60}', {}", o.formula, e.what()));
        }
        bool close_to_a_tie = false;
        for (Answer& a : answers) {
            if (!a.integral.value.is_finite()) continue;
            a.shown = shown(a.integral, o, asked);
            const bool enough = a.shown.digits == o.digits || a.shown.is_within_tolerance;
            if (!enough && a.integral.status == quadrature::Status::certified) close_to_a_tie = true;
        }
        if (!close_to_a_tie) break;
    }
    return answers;
}

/// Without the blank that keeps a minus from being read as an option (main.cpp), and any other around it.
std::string bare(const std::string& text)
{
    const auto first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

quadrature::IntegralOptions options_of(const IntegrateOptions& o)
{
    if (o.digits < 1 || o.digits > 10000) throw Failure(bad_input, fmt::format("--digits {}: between 1 and 10000", o.digits));
    quadrature::IntegralOptions options;
    options.digits = o.digits;
    options.at = points_of(o.at, "break point");
    options.principal_value = points_of(o.principal_value, "pole");
    if (!o.tolerance.empty()) {
        options.tolerance = parse_rational(o.tolerance);
        if (!options.tolerance)
            throw Failure(bad_input, fmt::format("--tolerance '{:.40}' {}", o.tolerance, why_not_rational(o.tolerance)));
        if (*options.tolerance <= 0) throw Failure(bad_input, fmt::format("--tolerance {} is not positive", o.tolerance));
    }
    return options;
}

nlohmann::ordered_json as_json(const IntegrateOptions& o, const std::string& formula, const Answer& a, const char* status,
                               const std::string& reason)
{
    const auto& [result, s] = a;
    nlohmann::ordered_json j{{"formula", formula}, {"from", o.from}, {"to", o.to}};
    if (!o.path.empty()) j["path"] = o.path;
    const auto text_or_null = [&](const std::string& text) {
        return !s.value.empty() ? nlohmann::ordered_json(text) : nlohmann::ordered_json(nullptr);
    };
    j["value"] = text_or_null(s.value);
    if (result.is_complex) j["imaginary"] = text_or_null(s.imaginary);
    j["digits"] = s.digits;
    j["status"] = status;
    j["error"] = text_or_null(s.error);
    if (!reason.empty()) j["reason"] = reason;
    if (result.value.is_finite()) {
        j["enclosure"] = result.value.to_string(o.digits + 5);
        if (result.is_complex) j["imaginary_enclosure"] = result.imaginary.to_string(o.digits + 5);
        if (const auto d = nearest_double(result.value)) j["binary64"] = hexfloat(*d);
    }
    j["parts"] = nlohmann::ordered_json::array();
    for (const auto& p : result.parts) j["parts"].push_back(as_json(p));
    return j;
}

std::string value_text(const Answer& a, long digits)
{
    const auto& [result, s] = a;
    if (s.value.empty())
        return result.value.to_string(digits) + (result.is_complex ? " + " + result.imaginary.to_string(digits) + "*i" : "");
    if (!result.is_complex) return s.value;
    const bool negative = s.imaginary.starts_with('-');
    return fmt::format("{} {} {}*i", s.value, negative ? '-' : '+', negative ? s.imaginary.substr(1) : s.imaginary);
}

void print(const IntegrateOptions& o, const std::string& formula, const Answer& a, const char* status, const std::string& reason)
{
    const Shown& s = a.shown;
    fmt::print("{}\n", value_text(a, o.digits));
    const std::string accuracy = s.value.empty() ? "no digit proven"
                                 : s.digits > 0  ? fmt::format("{} digits, |error| <= {}", s.digits, s.error)
                                                 : fmt::format("|error| <= {}", s.error);
    fmt::print("  integral of {} from {}{} to {}: {}, {}\n", formula, o.from, o.path.empty() ? "" : " by " + o.path, o.to, status,
               accuracy);
    if (!reason.empty()) fmt::print("  {}\n", reason);
    if (o.explain)
        for (const auto& p : a.integral.parts) explain(p);
}

Problem problem_of(const IntegrateOptions& o)
{
    const quadrature::Parameters parameters = parameters_of(o.set);
    Problem problem;
    problem.texts = words_of(o.formula, ';');
    if (problem.texts.empty()) problem.texts.push_back("");
    for (std::string& text : problem.texts) {
        text = bare(text);
        problem.formulas.push_back(formula_of(text, parameters));
    }
    problem.path.push_back(vertex_of(o.from, "lower end", parameters));
    for (const std::string& word : words_of(o.path, ',')) problem.path.push_back(vertex_of(word, "point of the path", parameters));
    problem.path.push_back(vertex_of(o.to, "upper end", parameters));
    return problem;
}

/// Prints the answer, or adds it to `all`; its exit code.
int report(const IntegrateOptions& o, const std::string& formula, const Answer& a, bool alone, nlohmann::ordered_json& all)
{
    const quadrature::Integral& result = a.integral;
    if (result.divergent && !o.json && alone) throw Failure(bad_input, result.reason);
    const bool certified = result.status == quadrature::Status::certified && (a.shown.is_within_tolerance || a.shown.digits == o.digits);
    const std::string reason =
        certified ? ""
        : result.reason.empty()
            ? fmt::format("only {} of {} digits proven: it is too close to the middle between two numbers of so many digits",
                          a.shown.digits, o.digits)
            : result.reason;
    const char* status = result.divergent ? "divergent" : certified ? "certified" : "undecided";
    if (o.json)
        all.push_back(as_json(o, formula, a, status, reason));
    else if (!result.value.is_finite() && alone)
        throw Failure(undecided, reason);
    else if (!result.value.is_finite())
        fmt::print("-\n  integral of {} from {} to {}: {}\n  {}\n", formula, o.from, o.to, status, reason);
    else
        print(o, formula, a, status, reason);
    return result.divergent ? bad_input : certified ? holds : undecided;
}

int integrate_and_print(IntegrateOptions o)
{
    for (std::string* text : {&o.formula, &o.from, &o.to, &o.path, &o.at, &o.principal_value, &o.tolerance}) *text = bare(*text);
    quadrature::IntegralOptions options = options_of(o);
    const Problem problem = problem_of(o);
    const std::optional<Rational> tolerance = options.tolerance;
    if (tolerance) *options.tolerance /= 100; // so that a decimal within it exists
    const std::vector<Answer> answers = [&] {
        const Progress progress("integrate");
        return computed(o, problem, options, tolerance);
    }();
    auto all = nlohmann::ordered_json::array();
    int code = holds;
    for (std::size_t k = 0; k < answers.size(); ++k)
        code = std::max(code, report(o, problem.texts[k], answers[k], answers.size() == 1, all));
    if (o.json) fmt::print("{}\n", answers.size() == 1 ? all[0].dump() : nlohmann::ordered_json{{"integrals", all}}.dump());
    return code;
}

} // namespace

void add_integrate(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand(
        "integrate", "The integral of a formula in x, proven: touchstone integrate \"x^(-1/2)*log(1/x)/(1+x^2)\" 0 1 --digits 50");
    auto o = std::make_shared<IntegrateOptions>();
    command
        ->add_option("formula", o->formula,
                     "In x: + - * / ^, pi, e, i, exp, log, sqrt, sin, ..., gamma, erf, besselj(n, x), ... (docs/quadrature.md)")
        ->required();
    command->add_option("from", o->from, "Lower end: 0, 1/3, pi/2, log(2), -inf")->required();
    command->add_option("to", o->to, "Upper end, inf too")->required();
    command->add_option("--path", o->path, "Points of the plane between the ends, separated by commas: 1+i,-1+i");
    command->add_option("--set", o->set, "A parameter of the formula, a number or a ball: a=1/3, a=0.5+/-1e-20");
    command->add_option("--at", o->at, "Points where the formula changes, separated by commas");
    command->add_option("--principal-value", o->principal_value,
                        "Poles inside, separated by commas, about which Cauchy's principal value is meant");
    command->add_option("--digits", o->digits, "Significant digits, 1 to 10000")->capture_default_str();
    command->add_option("--tolerance", o->tolerance, "An absolute error that is enough (for an integral that may be 0)");
    command->add_flag("--json", o->json, "One JSON object");
    command->add_flag("--explain", o->explain, "The parts, their rules and the error bounds");
    command->callback([&run, o] { run = [o] { return integrate_and_print(*o); }; });
}

} // namespace touchstone::program
