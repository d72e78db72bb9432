// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone check`: a printed table, entry by entry.
#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/oracle/printed.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/own_rows.hpp"
#include "verify/progress.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <array>

namespace touchstone::program {
namespace {

using oracle::PrintedVerdict;

struct CheckOptions {
    std::string file, quantity;
    std::vector<std::string> constants;
    bool json = false;
    bool quiet = false;
};

class Check {
public:
    Check(const CheckOptions& o, const Quantity& q, OwnRows& rows) : o_(o), q_(q), rows_(rows) {}

    int all()
    {
        if (o_.json) fmt::print("{{\"quantity\":\"{}\",\"file\":{},\"entries\":[", q_.name, nlohmann::json(o_.file).dump());
        judge_rows();
        const int code = count(PrintedVerdict::wrong) + count(PrintedVerdict::one_unit_off) > 0 ? fails
                         : count(PrintedVerdict::undecided) > 0                                 ? undecided
                                                                                                : holds;
        if (o_.json) {
            nlohmann::ordered_json counts;
            for (std::size_t k = 0; k < counts_.size(); ++k) counts[std::string(to_string(static_cast<PrintedVerdict>(k)))] = counts_[k];
            fmt::print("\n],\"counts\":{},\"verdict\":\"{}\"}}\n", counts.dump(),
                       code == holds   ? "pass"
                       : code == fails ? "fail"
                                       : "undecided");
            return code;
        }
        std::vector<std::string> parts;
        for (std::size_t k = 0; k < counts_.size(); ++k)
            if (counts_[k] > 0) parts.push_back(fmt::format("{} {}", counts_[k], to_string(static_cast<PrintedVerdict>(k))));
        fmt::print("{}: {} entries of {}: {}\n", o_.file, total_, q_.name, fmt::join(parts, ", "));
        return code;
    }

private:
    void judge_rows()
    {
        Progress progress("checking entries", rows_.count());
        for (OwnRow row; rows_.next(row);) {
            if (!row.refusal.empty()) throw Failure(bad_input, row.refusal);
            one(row);
            progress.done(static_cast<std::size_t>(total_));
        }
    }
    int count(PrintedVerdict v) const { return counts_[static_cast<std::size_t>(v)]; }

    void one(const OwnRow& row)
    {
        oracle::PrintedEntry e;
        try {
            e = oracle::check_printed(q_, *row.inputs, row.printed);
        }
        catch (const DomainError& wrong) {
            throw Failure(bad_input, fmt::format("{}: {}", row.place, wrong.what()));
        }
        ++counts_[static_cast<std::size_t>(e.verdict)];
        ++total_;
        Progress::clear(); // what follows may go to the same terminal
        if (o_.json) {
            nlohmann::ordered_json inputs;
            for (std::size_t k = 0; k < row.words.size(); ++k) inputs[rows_.columns()[k]] = row.words[k];
            nlohmann::ordered_json j{
                {"row", row.number}, {"inputs", inputs}, {"printed", row.printed}, {"verdict", std::string(to_string(e.verdict))}};
            if (!e.right.empty()) j["right"] = e.right;
            if (!e.note.empty()) j["note"] = e.note;
            fmt::print("{}\n{}", total_ > 1 ? "," : "", j.dump());
        }
        else if (!o_.quiet || e.verdict != PrintedVerdict::rounded) {
            std::string where;
            for (std::size_t k = 0; k < row.words.size(); ++k) where += fmt::format("{}={} ", rows_.columns()[k], row.words[k]);
            const bool other = e.verdict != PrintedVerdict::rounded && !e.right.empty();
            fmt::print("{:<24} {:<16} {}{}{}\n", where, row.printed, to_string(e.verdict),
                       other ? fmt::format("; rounded: {}", e.right) : "", e.note.empty() ? "" : ": " + e.note);
        }
    }

    const CheckOptions& o_;
    const Quantity& q_;
    OwnRows& rows_;
    std::array<int, 5> counts_{};
    int total_ = 0;
};

int check(const CheckOptions& o)
{
    const Quantity& q = quantity_named(o.quantity);
    const auto rows = rows_of_file(q, o.file, key_values(q, o.constants), {.printed = true});
    return Check(o, q, *rows).all();
}

} // namespace

void add_check(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand("check", "A printed table, entry by entry: touchstone check table.txt --quantity archard.K");
    auto o = std::make_shared<CheckOptions>();
    command
        ->add_option("file", o->file,
                     "Rows with inputs by column names; the last column is what was printed, whatever its name; - for standard input")
        ->required();
    command->add_option("--quantity", o->quantity, "Name, as `touchstone list` gives it")->required();
    command->add_option("inputs", o->constants, "KEY=VALUE for inputs that no column gives");
    command->add_flag("--json", o->json, "One JSON object");
    command->add_flag("--quiet", o->quiet, "Only entries that are not right as rounded, and the sum");
    command->callback([&run, o] { run = [o] { return check(*o); }; });
}

} // namespace touchstone::program
