// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone paper ID --with FIELD=TEXT`: what the ledger would say of a print in which a field reads otherwise.
#include "proofs/ledger.hpp"
#include "verify/exit_codes.hpp"
#include "verify/paper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

namespace touchstone::program {
namespace {

using namespace touchstone::proofs;

/// The field "rhs" is the first part's, as everywhere in the ledger.
std::string full_name(const std::string& field) { return field.find('.') == std::string::npos ? "0." + field : field; }

constexpr std::array fields_in_words{".condition", ".digits", ".kind"}; ///< anything but a relation or a formula

/// Whatever is no formula cannot be judged, and is not refuted either.
void expect_readable(const std::string& id, const std::string& field, const std::string& text)
{
    static const std::set<std::string> relations{"=", "==", "<", "<=", ">", ">=", "~", "->", "rounds to"};
    if (field.ends_with(".relation")) {
        if (!relations.contains(text))
            throw Failure(bad_input, fmt::format("{} {}: '{}' is no relation; {}", id, field, text, fmt::join(relations, "  ")));
        return;
    }
    if (std::any_of(fields_in_words.begin(), fields_in_words.end(), [&](const char* end) { return field.ends_with(end); })) return;
    try {
        read(text);
    } catch (const std::exception& e) {
        const std::string what = e.what();
        throw Failure(bad_input, fmt::format("{} {}: '{}' is no formula: {}", id, field, text, what.substr(0, what.find('\n'))));
    }
}

void change(Print& print, const std::string& with)
{
    const std::size_t equals = with.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == with.size())
        throw Failure(usage_error, fmt::format("--with {}: FIELD=TEXT is meant, such as --with 'rhs=2*Pi'", with));
    const auto field = print.fields.find(full_name(with.substr(0, equals)));
    if (field == print.fields.end()) {
        std::vector<std::string> names;
        for (const auto& [name, text] : print.fields) names.push_back(name);
        throw Failure(bad_input,
                      names.empty()
                          ? fmt::format("{} has no machine form that could be changed: it is judged by a number", print.id)
                          : fmt::format("{} has no field '{}'; it has {}", print.id, with.substr(0, equals), fmt::join(names, ", ")));
    }
    expect_readable(print.id, field->first, with.substr(equals + 1));
    field->second = with.substr(equals + 1);
}

int code(Verdict v) { return v == Verdict::refuted ? fails : v == Verdict::undecided ? undecided : holds; }

} // namespace

int print_changed(const Claim& claim, const std::vector<std::string>& changes, bool corrected, bool json)
{
    Print print = prints().at(claim.id);
    if (corrected && claim.correction) print = print.edited(claim.correction->edits);
    for (const std::string& with : changes) change(print, with);
    const Finding f = judge_whole(claim, print);
    if (json) {
        nlohmann::ordered_json j = {{"id", claim.id}, {"verdict", name(f.verdict)}, {"reason", f.reason}, {"method", f.method}};
        j["fields"] = print.fields;
        fmt::print("{}\n", j.dump());
        return code(f.verdict);
    }
    fmt::print("{:<12} {}\n", "entry", claim.id);
    for (const auto& [field, text] : print.fields) fmt::print("{:<12} {}\n", field, text);
    fmt::print("{:<12} {}, as it reads here\n", "verdict", name(f.verdict));
    if (!f.reason.empty()) fmt::print("{:<12} {}\n", "reason", f.reason);
    return code(f.verdict);
}

} // namespace touchstone::program
