// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone certificate`: why a value is what it is, for a checker that shares nothing with this program.
#include "touchstone/certificate/contact.hpp"
#include "touchstone/certificate/limit_constant.hpp"
#include "touchstone/certificate/limit_distributions.hpp"
#include "touchstone/certificate/limit_scale.hpp"
#include "touchstone/certificate/second_eigenvalue.hpp"
#include "touchstone/scalar/rational.hpp"
#include "touchstone/scalar/rational_text.hpp"
#include "touchstone/table/table.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"
#include "verify/own_rows.hpp"
#include "verify/progress.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace touchstone::program {
namespace {

constexpr long spare_digits = 4; ///< a printed digit is found right where the claim is narrower than what it was rounded by
constexpr long digits_of_a_value = 30;

struct CertificateOptions {
    std::string subject, out;
    std::vector<std::string> assignments;
    std::optional<long> digits;
};

Root root_of(const Inputs& in)
{
    try {
        return as_root(in.G_exact());
    }
    catch (const NotExact&) {
        throw Failure(bad_input, "G = gamma^(D-1) is no root of a rational number: there is no certificate");
    }
}

std::optional<certificate::LimitClaim::Of> limiting_kind(const std::string& quantity)
{
    using Of = certificate::LimitClaim::Of;
    if (quantity == "limit.exceedance") return Of::exceedance;
    if (quantity == "limit.force") return Of::force;
    if (quantity == "limit.density") return Of::density;
    if (quantity == "limit.segments") return Of::segments;
    if (quantity == "limit.distance") return Of::distance;
    return std::nullopt;
}

/// What is claimed and has a certificate, and why the first that has none has none.
struct Claimed {
    std::vector<certificate::Claim> claims;
    std::vector<Root> limits, eigenvalues;
    std::vector<certificate::LimitClaim> limiting;
    std::vector<certificate::ScaleClaim> scales;
    std::string refused;

    bool none() const { return claims.empty() && limits.empty() && limiting.empty() && scales.empty() && eigenvalues.empty(); }

    /// \returns whether there is a certificate, the reason being none
    bool is_served(const std::string& why)
    {
        if (!why.empty() && refused.empty()) refused = why;
        return why.empty();
    }

    void add(const Quantity& q, const Inputs& in)
    {
        q.check(in);
        if (const auto kind = limiting_kind(q.name)) {
            certificate::LimitClaim c{root_of(in), *kind, in.real(q.name == "limit.segments" ? "a" : "p")};
            if (q.name == "limit.distance") c.n = in.integer("n"), c.load = in.real("load");
            if (is_served(certificate::refusal_of_limit_distribution(c))) limiting.push_back(c);
            return;
        }
        if (q.name == "limit.scale") {
            const certificate::ScaleClaim c{root_of(in), in.real("load"), in.real("tolerance")};
            if (is_served(certificate::refusal_of_scale(c))) scales.push_back(c);
            return;
        }
        if (q.name == "limit.gap") {
            const Root G = root_of(in);
            if (is_served(certificate::refusal_of_eigenvalue(G))) eigenvalues.push_back(G);
            return;
        }
        const bool limit = q.name == "limit.area_constant" || q.name == "limit.area_ratio";
        certificate::Claim a{1, Rational(1), root_of(in)};
        if (!limit) a.load = in.real("load"), a.n = in.integer("n");
        if (q.name == "contact.exceedance") a.of = certificate::Claim::Of::share, a.at = in.real("p");
        if (q.name == "contact.density") a.of = certificate::Claim::Of::density, a.at = in.real("p");
        if (q.name == "segments.density") a.of = certificate::Claim::Of::segments, a.at = in.real("a");
        if (q.name == "segments.count") --a.n; // (8.1): they are counted by A_(n-1)
        if (!is_served(limit ? certificate::refusal_of_limit(a.G) : certificate::refusal(a))) return;
        if (q.name == "contact.exceedance" && a.at == 0)
            refused = "p = 0 is an area";
        else if (limit)
            limits.push_back(a.G);
        else
            claims.push_back(a);
    }
};

/// What rows of a table are asked for by; no key: all of them.
std::map<std::string, Rational> of_columns(const Quantity& q, const NamedTexts& named)
{
    std::map<std::string, Rational> wanted;
    for (const auto& [key, text] : named) {
        const auto value = parse_rational(text);
        if (std::find(q.inputs.begin(), q.inputs.end(), key) == q.inputs.end())
            throw Failure(usage_error, fmt::format("the table has no column '{}'; it has {}", key, fmt::join(q.inputs, ", ")));
        if (!value) throw Failure(bad_input, fmt::format("{}={}: {}", key, text, why_not_rational(text)));
        if (!wanted.emplace(key, *value).second) throw Failure(usage_error, fmt::format("'{}' is given twice", key));
    }
    return wanted;
}

/// The table's numbers are binary64 and printed as decimals that round to them: one is named by any number that does.
bool is_named_by(const Rational& of_row, const Rational& wanted)
{
    return nearest_double(of_row) == nearest_double(wanted);
}

Claimed claims_of_table(const TableSpec& spec, const NamedTexts& named)
{
    const Quantity& q = quantity_named(spec.quantity);
    const auto wanted = of_columns(q, named);
    Claimed all;
    for (const auto& row : spec.grid()) {
        std::map<std::string, Rational> values;
        for (std::size_t k = 0; k < row.size(); ++k) values[q.inputs[k]] = exact_rational(row[k]);
        if (std::all_of(wanted.begin(), wanted.end(), [&](const auto& w) { return is_named_by(values[w.first], w.second); }))
            all.add(q, Inputs(values));
    }
    if (all.refused.empty()) all.refused = "there is no such row";
    return all;
}

/// e with |x| < 2^e, nearly, of the certificate's HEX:EXPONENT; nothing of 0.
std::optional<long> exponent_of(const std::string& number)
{
    const auto colon = number.find(':');
    const Integer mantissa(number.substr(0, colon), 16);
    if (mantissa == 0) return std::nullopt;
    return static_cast<long>(mpz_sizeinbase(mantissa.get_mpz_t(), 2)) + std::stol(number.substr(colon + 1));
}

/// Significant digits that the least accurate claim of a certificate has; nothing where none has an error.
std::optional<long> digits_claimed(const std::string& text)
{
    constexpr double digits_per_bit = 0.30103;
    std::optional<long> least;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const auto value = line.find(" value="), error = line.find(" error=");
        if (!line.starts_with("claim ") || value == std::string::npos || error == std::string::npos) continue;
        const auto word = [&](std::size_t at) { return line.substr(at + 7, line.find(' ', at + 7) - at - 7); };
        const auto size = exponent_of(word(value)), off = exponent_of(word(error));
        if (!size || !off) continue;
        const long digits = std::max(0L, static_cast<long>(std::floor(static_cast<double>(*size - *off) * digits_per_bit)));
        least = least ? std::min(*least, digits) : digits;
    }
    return least;
}

/// More digits than there are certificates of are no error, but are not passed over in silence.
void tell_digits_below(std::optional<long> asked, const std::string& text)
{
    const auto claimed = asked ? digits_claimed(text) : std::nullopt;
    if (claimed && *claimed + 1 < *asked) // powers of two tell digits to one
        fmt::print(stderr, "touchstone: the certificate proves some {} digits, not {}: of more there is none (docs/certificate.md)\n",
                   *claimed, *asked);
}

int write_certificate(const CertificateOptions& o)
{
    const TableSpec* spec = find_table(o.subject);
    const Quantity& q = quantity_named(spec != nullptr ? spec->quantity : o.subject);
    constexpr std::array served{"contact.area",        "contact.exceedance", "contact.density",  "segments.count", "segments.density",
                                "limit.area_constant", "limit.area_ratio",   "limit.exceedance", "limit.force",    "limit.density",
                                "limit.segments",      "limit.distance",     "limit.scale",      "limit.gap"};
    if (std::find(served.begin(), served.end(), q.name) == served.end())
        throw Failure(undecided, fmt::format("there are certificates of {}, not of '{}'; rows of closed form need none (checker/check.py)",
                                             fmt::join(served, ", "), q.name));
    Claimed claimed;
    if (spec != nullptr)
        claimed = claims_of_table(*spec, key_values(q, o.assignments));
    else
        claimed.add(q, read_inputs(q, key_values(q, o.assignments)));
    if (claimed.none())
        throw Failure(undecided, (spec == nullptr ? "" : fmt::format("no row of '{}' has a certificate: ", spec->name)) + claimed.refused);
    const long most = !claimed.eigenvalues.empty() ? certificate::most_digits_of_an_eigenvalue
                      : claimed.limits.empty()     ? certificate::most_digits
                                                   : certificate::most_digits_of_a_limit;
    const long digits = std::min(most, o.digits.value_or(spec != nullptr ? spec->digits + spare_digits : digits_of_a_value));
    const std::string text = [&] {
        const Progress progress("certificate");
        if (!claimed.eigenvalues.empty()) return certificate::second_eigenvalues(claimed.eigenvalues, {digits});
        if (!claimed.scales.empty()) return certificate::limit_scales(claimed.scales);
        if (!claimed.limiting.empty()) return certificate::limit_distributions(claimed.limiting, {digits});
        if (claimed.limits.empty()) return certificate::contact(claimed.claims, {digits});
        return certificate::limit_constants(claimed.limits, {digits});
    }();
    tell_digits_below(o.digits, text);
    if (o.out.empty())
        fmt::print("{}", text);
    else
        write_file(o.out, text);
    return holds;
}

} // namespace

void add_certificate(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand(
        "certificate", "What checker/certificate.py replays: touchstone certificate contact.area n=3 G=3 load=1/10 --out FILE");
    auto o = std::make_shared<CertificateOptions>();
    command
        ->add_option(
            "subject", o->subject,
            "A quantity with inputs: an area, a share above a pressure, a density, a count of segments or a limit of these; or a table")
        ->required();
    command->add_option("inputs", o->assignments,
                        "KEY=VALUE, exact, as for eval; of a table: rows with these inputs alone, as printed there");
    command->add_option("--digits", o->digits, "Significant digits to be proved (default: 30; of a table its own and 4 more)")
        ->check(CLI::Range(1L, certificate::most_digits));
    command->add_option("--out", o->out, "File to write (default: standard output)")->check(not_empty());
    command->callback([&run, o] { run = [o] { return write_certificate(*o); }; });
}

} // namespace touchstone::program
