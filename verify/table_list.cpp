// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/table_list.hpp"

#include "touchstone/table/format.hpp"
#include "touchstone/table/table.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <optional>

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;

/// What checker/check.py found of one stored table, when its rows had this hash.
struct Coverage {
    std::size_t rows = 0, confirmed = 0, wrong = 0;
    std::optional<long> digits; ///< none: every confirmed row is exact
    std::string sha256;
};

std::map<std::string, Coverage> read_coverage(const fs::path& path)
{
    std::map<std::string, Coverage> all;
    if (!fs::is_regular_file(path)) return all;
    try {
        for (const auto& entry : nlohmann::json::parse(read_file(path))) {
            Coverage& c = all[entry.at("table").get<std::string>()];
            c = {entry.at("rows"), entry.at("confirmed"), entry.at("wrong"), {}, entry.at("sha256")};
            if (!entry.at("digits").is_null()) c.digits = entry.at("digits").get<long>();
        }
    }
    catch (const nlohmann::json::exception& e) {
        throw Failure(bad_input, fmt::format("{}: not a file of coverage: {}", path.string(), e.what()));
    }
    return all;
}

std::string in_words(const Coverage& c, const StoredTable& stored)
{
    if (c.sha256 != stored.sha256) return "not checked since it changed";
    if (c.rows != stored.rows.size()) return "not checked as a whole";
    const std::string digits = c.digits ? fmt::format("{} digits", *c.digits) : "exactly";
    if (c.wrong > 0) return fmt::format("{} rows WRONG", c.wrong);
    return c.confirmed == 0 ? "no row" : fmt::format("{} of {} rows, {}", c.confirmed, c.rows, digits);
}

} // namespace

int list_tables(const std::string& folder)
{
    const auto coverage = folder.empty() ? std::map<std::string, Coverage>() : read_coverage(fs::path(folder) / "coverage.json");
    fmt::print("{:<28} {:>6} {:>6}  {:<26} {}\n", "table", "rows", "digits", "quantity", "confirmed by the checker, to at least");
    for (const TableSpec& spec : table_specs()) {
        const fs::path path = fs::path(folder) / (spec.name + ".txt");
        const auto found = coverage.find(spec.name);
        std::string rows = "-", digits = std::to_string(spec.digits), said = "not stored";
        if (!folder.empty() && fs::is_regular_file(path)) {
            const StoredTable stored = parse_table(read_file(path), path.string());
            rows = std::to_string(stored.rows.size());
            digits = std::to_string(stored.digits);
            said = found == coverage.end() ? "not checked" : in_words(found->second, stored);
        }
        fmt::print("{:<28} {:>6} {:>6}  {:<26} {}\n", spec.name, rows, digits, spec.quantity, said);
    }
    return holds;
}

} // namespace touchstone::program
