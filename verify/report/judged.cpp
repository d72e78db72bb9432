// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/judged.hpp"

#include "verify/exit_codes.hpp"
#include "verify/figures/tool.hpp"
#include "verify/report/mathml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <system_error>

namespace touchstone::program::report {
namespace {

namespace fs = std::filesystem;

/// A judgement: a code, what it computes, the table, and options of `touchstone judge`.
struct Asked {
    const char *code, *program, *quantity, *table;
    std::vector<const char*> options = {};
};

const std::vector<Asked>& all_asked()
{
    // the last two: their many rows at large n, and what rounded inputs force there, take minutes and would say no more
    static const std::vector<Asked> all{
        {"formulas as printed", "subject_printed_formulas", "westergaard.pressure", "westergaard_pressure"},
        {"formulas as printed", "subject_printed_formulas", "westergaard.half_width", "westergaard_half_width"},
        {"formulas as printed", "subject_printed_formulas", "westergaard.exceedance", "westergaard_exceedance"},
        {"formulas as printed", "subject_printed_formulas", "westergaard.density", "westergaard_density"},
        {"formulas as printed", "subject_printed_formulas", "westergaard.gap", "westergaard_gap"},
        {"this library, double", "subject_library_forms", "westergaard.pressure", "westergaard_pressure"},
        {"this library, double", "subject_library_forms", "westergaard.half_width", "westergaard_half_width"},
        {"this library, double", "subject_library_forms", "westergaard.exceedance", "westergaard_exceedance"},
        {"this library, double", "subject_library_forms", "westergaard.density", "westergaard_density"},
        {"this library, double", "subject_library_forms", "westergaard.gap", "westergaard_gap"},
        {"GSL's functions", "subject_gsl", "westergaard.pressure", "westergaard_pressure"},
        {"GSL's functions", "subject_gsl", "westergaard.half_width", "westergaard_half_width"},
        {"GSL's functions", "subject_gsl", "westergaard.gap", "westergaard_gap"},
        {"GSL's functions", "subject_gsl", "archard.K", "archard_K", {"--where", "n=0..64", "--held-out", "0"}},
        {"recursion of section 6 on GSL",
         "subject_recursion",
         "contact.area",
         "contact_area",
         {"--where", "n=0..10", "--held-out", "0", "--recheck", "0", "--strict"}},
    };
    return all;
}

std::vector<std::string> command_of(const Asked& a, const fs::path& program, const fs::path& codes, const std::vector<std::string>& more)
{
    std::vector<std::string> words{program.string(), "judge", a.table};
    words.insert(words.end(), a.options.begin(), a.options.end());
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), {"--", (codes / a.program).string(), a.quantity});
    return words;
}

fs::path this_program()
{
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error);
}

double number_at(const nlohmann::json& interval, std::size_t k)
{
    return interval.is_array() && interval.size() > k && interval[k].is_number() ? interval[k].get<double>() : -1;
}

std::string ulps(double u) { return u < 0 ? "" : fmt::format("{:.2g}", u); }

std::string row(const Judged& j)
{
    const auto& said = j.said;
    const std::string verdict = said.value("verdict", "protocol");
    const auto worst = said.contains("worst") && !said["worst"].empty() ? said["worst"].front() : nlohmann::json::object();
    const bool strict = j.command.find("--strict") != std::string::npos;
    const char* const colour = verdict == "pass" ? "proved" : verdict == "fail" ? "refuted" : "undecided";
    const std::string worst_ulps = ulps(number_at(worst.value("ulps", nlohmann::json()), 1));
    const std::string forced = strict ? "not asked" : ulps(number_at(worst.value("forced_by_inputs", nlohmann::json()), 0));
    return fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td><span class=\"badge {}\">{}</span></td><td class=\"number\">{} of {}</td>"
        "<td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n"
        "<tr class=\"regenerate\"><td colspan=\"6\"><code>{}</code></td></tr>\n",
        escaped(j.code), escaped(j.table), colour, escaped(verdict), said.value("failed", 0), said.value("rows", 0), worst_ulps, forced,
        escaped(j.command));
}

} // namespace

std::optional<fs::path> shipped_codes()
{
    const fs::path folder = this_program().parent_path() / "verify/subjects";
    return fs::is_regular_file(folder / all_asked().front().program) ? std::optional(folder) : std::nullopt;
}

std::size_t judgements() { return all_asked().size(); }

std::vector<Judged> judge_shipped(const fs::path& codes, const std::function<void(std::size_t)>& judged_one)
{
    std::vector<Judged> all;
    for (const Asked& a : all_asked()) {
        const auto answer = figures::run_tool(command_of(a, this_program(), codes, {"--json"}), "");
        auto said = nlohmann::json::parse(answer ? answer->output : "", nullptr, false);
        if (!said.is_object())
            throw Failure(internal_error,
                          fmt::format("judging {} by {} said nothing: {}", a.program, a.table, answer ? answer->complaint : "not started"));
        all.push_back(
            {a.code, a.table, fmt::format("{}", fmt::join(command_of(a, "touchstone", "verify/subjects", {}), " ")), std::move(said)});
        judged_one(all.size());
    }
    return all;
}

std::string drawn_judgement(const fs::path& codes)
{
    const auto answer = figures::run_tool(command_of(all_asked().front(), this_program(), codes, {"--svg", "/dev/stdout"}), "");
    const auto from = answer ? answer->output.find("<svg") : std::string::npos;
    return from == std::string::npos ? "" : answer->output.substr(from);
}

std::string judged_section(const std::vector<Judged>& all, const std::string& drawing_html)
{
    if (all.empty())
        return "<p>The judged codes of <code>verify/subjects</code> are built beside the program and not installed; a report made from the "
               "build folder judges them. "
               "Your own code: <code>touchstone judge westergaard_pressure --svg errors.svg -- ./mycode</code></p>\n";
    std::string rows;
    for (const Judged& j : all) rows += row(j);
    return "<p>Codes in double precision, judged while this page was made: a row fails if it is more than 4 ulps off beyond what the "
           "rounding of its inputs forces. The library's own forms pass everywhere; the formulas as printed, "
           "and GSL's functions put together in the same way, fail where they subtract what is nearly equal. The recursion of section 6 on "
           "GSL's quadrature is judged strictly: 4 ulps, nothing forgiven. "
           "Run from the build folder.</p>\n"
           "<div class=\"scroll\"><table class=\"judged\"><thead><tr><th>code</th><th>table</th><th>verdict</th><th>rows that "
           "fail</th><th>ulps, worst row</th><th>of these forced</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n" + drawing_html +
           "<p>Your own code beside these: <code>touchstone judge westergaard_pressure --svg errors.svg -- ./mycode</code></p>\n";
}

} // namespace touchstone::program::report
