// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone integrate`: the integral of a typed formula, with a proof.
#include "touchstone/quadrature/integrate.hpp"
#include "touchstone/rounding/decimal.hpp"
#include "touchstone/scalar/rational_text.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace touchstone::program {
namespace {

struct IntegrateOptions {
    std::string formula, from, to, at, principal_value, tolerance;
    long digits = 30;
    bool json = false, explain = false;
};

/// What is printed of an enclosure: digits that every number in it rounds to.
struct Shown {
    std::string value, error;
    long digits = 0;
};

Shown shown(const Ball& value, long digits)
{
    for (long d = digits; d > 0; --d)
        if (const auto decimal = round_to_digits(value, d)) return {decimal->text(), decimal->half_unit(), d};
    return {};
}

/// As many digits as an absolute error asks for; 0 if the enclosure has 0 in it and is that small.
Shown shown_within(const Ball& value, const Rational& tolerance, const std::string& text)
{
    const Ball size = abs(value);
    if (value.contains_zero()) return arb_le(size.get(), Ball(tolerance).get()) ? Shown{"0", text, 0} : Shown{};
    const long most =
        static_cast<long>(static_cast<double>(std::max<slong>(0, std::min<slong>(value.relative_bits(), 40000))) * 0.30103) + 1;
    for (long d = 1; d <= most; ++d)
        if (const auto decimal = round_to_digits(value, d); decimal && *parse_rational(decimal->half_unit()) <= tolerance)
            return {decimal->text(), decimal->half_unit(), d};
    return {};
}

quadrature::Limit limit_of(const std::string& text, const char* what)
{
    try {
        return quadrature::parse_limit(text);
    }
    catch (const quadrature::ExpressionError& e) {
        throw Failure(bad_input,
                      fmt::format("{} '{:.60}': {} (an end is a number such as 0, 1/3, pi/2, log(2), inf, -inf)", what, text, e.what()));
    }
}

std::vector<quadrature::Limit> points_of(const std::string& text, const char* what)
{
    std::vector<quadrature::Limit> points;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t comma = std::min(text.find(',', start), text.size());
        points.push_back(limit_of(text.substr(start, comma - start), what));
        start = comma + 1;
    }
    return points;
}

nlohmann::ordered_json as_json(const quadrature::Part& p)
{
    nlohmann::ordered_json j{
        {"from", p.from}, {"to", p.to}, {"rule", p.rule}, {"evaluations", p.evaluations}, {"enclosure", p.value.to_string(40)}};
    if (p.rule == "tanh-sinh") j["certificate"] = nlohmann::ordered_json::parse(p.certificate.to_json());
    return j;
}

void explain(const quadrature::Part& p)
{
    fmt::print("  [{}, {}] {}, {} evaluations: {}\n", p.from, p.to, p.rule, p.evaluations, p.value.to_string(20));
    if (p.rule != "tanh-sinh") {
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

quadrature::Integral computed(const IntegrateOptions& o, quadrature::IntegralOptions options, const std::optional<Rational>& asked,
                              Shown& s)
{
    const auto formula = [&] {
        try {
            return quadrature::parse_expression(o.formula);
        }
        catch (const quadrature::ExpressionError& e) {
            throw Failure(bad_input, fmt::format("formula '{:.60}', {}", o.formula, e.what()));
        }
    }();
    const auto from = limit_of(o.from, "lower end"), to = limit_of(o.to, "upper end");
    quadrature::Integral result;
    for (const long more : {0L, 4L, 16L}) { // a value close to the middle between two decimals asks for more
        auto with_more = options;
        with_more.digits += more;
        try {
            result = quadrature::integrate(formula, from, to, with_more);
        }
        catch (const quadrature::ExpressionError& e) {
            throw Failure(bad_input, fmt::format("formula '{:.60}', {}", o.formula, e.what()));
        }
        if (!result.value.is_finite()) break;
        s = asked ? shown_within(result.value, *asked, o.tolerance) : shown(result.value, o.digits);
        if (s.digits == o.digits || result.status != quadrature::Status::certified || !s.value.empty()) break;
    }
    return result;
}

/// Without the blank that keeps a minus from being read as an option (main.cpp), and any other around it.
std::string bare(const std::string& text)
{
    const auto first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

int integrate_and_print(IntegrateOptions o)
{
    for (std::string* text : {&o.formula, &o.from, &o.to, &o.at, &o.principal_value, &o.tolerance}) *text = bare(*text);
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
    const std::optional<Rational> tolerance = options.tolerance;
    if (tolerance) *options.tolerance /= 100; // so that a decimal within it exists
    Shown s;
    const quadrature::Integral result = computed(o, options, tolerance, s);
    if (result.divergent && !o.json) throw Failure(bad_input, result.reason);
    const bool proven = result.value.is_finite();
    const bool certified = result.status == quadrature::Status::certified && (tolerance ? !s.value.empty() : s.digits == o.digits);
    const std::string reason = certified               ? ""
                               : result.reason.empty() ? fmt::format("only {} of {} digits proven", s.digits, o.digits)
                                                       : result.reason;
    if (o.json) {
        nlohmann::ordered_json j{{"formula", o.formula}, {"from", o.from}, {"to", o.to}};
        j["value"] = !s.value.empty() ? nlohmann::ordered_json(s.value) : nlohmann::ordered_json(nullptr);
        j["digits"] = s.digits;
        j["status"] = result.divergent ? "divergent" : certified ? "certified" : "undecided";
        j["error"] = !s.value.empty() ? nlohmann::ordered_json(s.error) : nlohmann::ordered_json(nullptr);
        if (!reason.empty()) j["reason"] = reason;
        if (proven) j["enclosure"] = result.value.to_string(o.digits + 5);
        if (const auto d = proven ? nearest_double(result.value) : std::nullopt) j["binary64"] = hexfloat(*d);
        j["parts"] = nlohmann::ordered_json::array();
        for (const auto& p : result.parts) j["parts"].push_back(as_json(p));
        fmt::print("{}\n", j.dump());
    }
    else if (!proven)
        throw Failure(undecided, reason);
    else {
        fmt::print("{}\n", !s.value.empty() ? s.value : result.value.to_string(o.digits));
        const std::string accuracy = s.value.empty() ? "no digit proven"
                                     : s.digits > 0  ? fmt::format("{} digits, |error| <= {}", s.digits, s.error)
                                                     : fmt::format("|error| <= {}", s.error);
        fmt::print("  integral of {} from {} to {}: {}, {}\n", o.formula, o.from, o.to, certified ? "certified" : "undecided", accuracy);
        if (!reason.empty()) fmt::print("  {}\n", reason);
        if (o.explain)
            for (const auto& p : result.parts) explain(p);
    }
    return result.divergent ? bad_input : certified ? holds : undecided;
}

} // namespace

void add_integrate(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand(
        "integrate", "The integral of a formula in x, proven: touchstone integrate \"x^(-1/2)*log(1/x)/(1+x^2)\" 0 1 --digits 50");
    auto o = std::make_shared<IntegrateOptions>();
    command
        ->add_option("formula", o->formula,
                     "In x: + - * / ^, pi, e, exp, log, sqrt, sin, ..., gamma, erf, besselj(n, x), ... (docs/quadrature.md)")
        ->required();
    command->add_option("from", o->from, "Lower end: 0, 1/3, pi/2, log(2), -inf")->required();
    command->add_option("to", o->to, "Upper end, inf too")->required();
    command->add_option("--at", o->at, "Points where the formula changes, separated by commas");
    command->add_option("--principal-value", o->principal_value, "Poles inside, separated by commas, about which Cauchy's principal value is meant");
    command->add_option("--digits", o->digits, "Significant digits, 1 to 10000")->capture_default_str();
    command->add_option("--tolerance", o->tolerance, "An absolute error that is enough (for an integral that may be 0)");
    command->add_flag("--json", o->json, "One JSON object");
    command->add_flag("--explain", o->explain, "The parts, their rules and the error bounds");
    command->callback([&run, o] { run = [o] { return integrate_and_print(*o); }; });
}

} // namespace touchstone::program
