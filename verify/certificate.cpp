// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone certificate`: why a value is what it is, for a checker that shares nothing with this program.
#include "touchstone/certificate/partial_area.hpp"
#include "touchstone/table/table.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"
#include "verify/own_rows.hpp"
#include "verify/progress.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace touchstone::program {
namespace {

constexpr long spare_digits = 4; ///< a printed digit is found right where the claim is narrower than what it was rounded by
constexpr long digits_of_a_value = 30;

struct CertificateOptions {
    std::string subject, out;
    std::vector<std::string> assignments;
    std::optional<long> digits;
};

/// The area a value rests on: segments are counted by A_(n-1), (8.1).
certificate::Area area_of(const Quantity& q, const Inputs& in)
{
    q.check(in);
    const long n = in.integer("n") - (q.name == "segments.count" ? 1 : 0);
    try {
        return {n, in.real("load"), as_root(in.G_exact())};
    }
    catch (const NotExact&) {
        throw Failure(bad_input, "G = gamma^(D-1) is no root of a rational number: there is no certificate");
    }
}

std::vector<certificate::Area> areas_of_table(const TableSpec& spec)
{
    const Quantity& q = quantity_named(spec.quantity);
    std::vector<certificate::Area> areas;
    std::string why;
    for (const auto& row : spec.grid()) {
        std::map<std::string, Rational> values;
        for (std::size_t k = 0; k < row.size(); ++k) values[q.inputs[k]] = exact_rational(row[k]);
        const certificate::Area a = area_of(q, Inputs(values));
        const std::string refused = certificate::refusal(a);
        if (refused.empty()) areas.push_back(a);
        else if (why.empty()) why = refused;
    }
    if (areas.empty()) throw Failure(undecided, fmt::format("no row of '{}' has a certificate: {}", spec.name, why));
    return areas;
}

int write_certificate(const CertificateOptions& o)
{
    const TableSpec* spec = o.assignments.empty() ? find_table(o.subject) : nullptr;
    const std::string quantity = spec != nullptr ? spec->quantity : o.subject;
    if (spec == nullptr) quantity_named(o.subject);
    if (quantity != "contact.area" && quantity != "segments.count")
        throw Failure(undecided, fmt::format("there are certificates of contact.area and segments.count only, not of '{}'; rows of closed "
                                             "form need none (checker/check.py)",
                                             quantity));
    std::vector<certificate::Area> areas;
    if (spec != nullptr) areas = areas_of_table(*spec);
    else {
        const Quantity& q = quantity_named(o.subject);
        areas.push_back(area_of(q, read_inputs(q, key_values(q, o.assignments))));
        if (const std::string why = certificate::refusal(areas.front()); !why.empty()) throw Failure(undecided, why);
    }
    const long digits = o.digits.value_or(spec != nullptr ? spec->digits + spare_digits : digits_of_a_value);
    const std::string text = [&] {
        const Progress progress("certificate");
        return certificate::partial_area(areas, {digits});
    }();
    if (o.out.empty()) fmt::print("{}", text);
    else write_file(o.out, text);
    return holds;
}

} // namespace

void add_certificate(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand(
        "certificate", "What checker/certificate.py replays: touchstone certificate contact.area n=3 G=3 load=1/10 --out FILE");
    auto o = std::make_shared<CertificateOptions>();
    command->add_option("subject", o->subject, "contact.area or segments.count with inputs, or a table of them")->required();
    command->add_option("inputs", o->assignments, "KEY=VALUE, exact, as for eval");
    command->add_option("--digits", o->digits, "Significant digits to be proved (default: 30; of a table its own and 4 more)")
        ->check(CLI::Range(1L, certificate::most_digits));
    command->add_option("--out", o->out, "File to write (default: standard output)")->check(not_empty());
    command->callback([&run, o] { run = [o] { return write_certificate(*o); }; });
}

} // namespace touchstone::program
