// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone report`: figures, Table 1, ledger and erratum in one file.
#include "verify/report.hpp"

#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/figures/gnuplot.hpp"
#include "verify/figures/tables.hpp"
#include "verify/files.hpp"
#include "verify/paper.hpp"
#include "verify/progress.hpp"
#include "verify/report/page.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
    std::string out;
    std::string ledger;
    unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
    bool recompute = false;
};

void make_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || ::access(folder.c_str(), W_OK) != 0) throw Failure(cannot_write, fmt::format("cannot write into {}", folder.string()));
}

/// The tables of data/figures made anew, written to DIR/data. \returns those that are not what the program was built with
std::vector<std::string> recompute(const ReportOptions& o)
{
    const fs::path folder = fs::path(o.out) / "data";
    make_folder(folder);
    std::vector<std::string> changed;
    for (const TableSpec& spec : figures::figure_tables()) {
        Progress progress(spec.name, spec.grid().size());
        const std::string text =
            figures::stored_form(compute(spec, spec.digits, o.jobs, [&progress](std::size_t done, std::size_t) { progress.done(done); }));
        write_into_folder(folder, spec.name + ".txt", text);
        if (text != figures::compiled_in(spec.name)) changed.push_back(spec.name);
    }
    return changed;
}

report::Drawn draw(const figures::Recipe& recipe, const fs::path& folder)
{
    const figures::Figure f = recipe.make();
    report::Drawn d{f, recipe.of_paper, figures::svg(f, figures::Layout::wide), figures::svg(f, figures::Layout::narrow), figures::pdf(f)};
    write_into_folder(folder, recipe.id + ".svg", d.wide);
    write_into_folder(folder, recipe.id + ".pdf", d.pdf);
    write_into_folder(folder, recipe.id + ".csv", figures::csv(f));
    return d;
}

int make_report(const ReportOptions& o)
{
    make_folder(o.out);
    report::Contents contents;
    if (!o.ledger.empty()) contents.ledger = report::parse_ledger(read_file(o.ledger), o.ledger); // what is wrong with it is said at once
    if (o.recompute) {
        const auto changed = recompute(o);
        if (!changed.empty())
            throw Failure(fails, fmt::format("recomputed tables differ from those compiled in: {} (the new ones are in {}/data; "
                                             "data/figures holds those of the program)",
                                             fmt::join(changed, ", "), o.out));
    }
    make_folder(fs::path(o.out) / "figures");
    const auto codes = report::shipped_codes();
    // parts as long as each other, about: a figure is drawn while two entries are judged
    constexpr std::size_t of_figure = 2, of_judgement = 3, of_ledger = 160;
    Progress progress("report", of_figure * figures::recipes().size() + (codes ? of_judgement * report::judgements() : 0) + of_ledger);
    for (const auto& recipe : figures::recipes()) {
        progress.next(of_figure, "drawing " + recipe.id);
        contents.drawn.push_back(draw(recipe, fs::path(o.out) / "figures"));
        progress.done(of_figure * contents.drawn.size());
    }
    if (codes) {
        const std::size_t before = of_figure * contents.drawn.size();
        progress.next(of_judgement, "judging codes");
        contents.judged = report::judge_shipped(*codes, [&](std::size_t done) { progress.done(before + of_judgement * done); });
        contents.judged_drawing = report::drawn_judgement(*codes);
    }
    progress.next(of_ledger);
    if (o.ledger.empty()) contents.ledger = ledger_json();
    const fs::path page = fs::path(o.out) / "index.html";
    write_into_folder(o.out, "index.html", report::page(contents));
    Progress::clear();
    fmt::print("{}: {} figures (SVG, PDF and CSV in {}/figures), {} entries of the ledger\n", page.string(), contents.drawn.size(), o.out,
               contents.ledger.size());
    return holds;
}

} // namespace

int write_figure(const std::string& id, const std::string& svg, const std::string& pdf, const std::string& csv)
{
    const figures::Recipe* recipe = figures::find_recipe(id);
    if (recipe == nullptr) {
        std::vector<std::string> names;
        for (const auto& r : figures::recipes()) names.push_back(r.id);
        throw Failure(bad_input, fmt::format("'{}' is no figure; figures: {}", id, fmt::join(names, " ")));
    }
    const figures::Figure f = recipe->make();
    if (!svg.empty()) write_file(svg, figures::svg(f, figures::Layout::wide));
    if (!pdf.empty()) write_file(pdf, figures::pdf(f));
    if (!csv.empty()) write_file(csv, figures::csv(f));
    fmt::print("{}: {}\n", f.title, figures::status_line(f));
    return holds;
}

void add_report(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand(
        "report", "The paper's figures, Table 1, the ledger and the erratum in one HTML file: touchstone report --out DIR");
    auto o = std::make_shared<ReportOptions>();
    command->add_option("--out", o->out, "Folder for index.html and figures/")->required();
    command->add_option("--ledger", o->ledger, "What `touchstone paper --json` wrote, instead of judging every entry now");
    command->add_flag("--recompute", o->recompute,
                      "Make the tables behind the figures anew (minutes), into DIR/data; fails if they differ from those compiled in");
    command->add_option("--jobs", o->jobs, "Threads of --recompute")->check(CLI::Range(1u, 1024u));
    command->callback([&run, o] { run = [o] { return make_report(*o); }; });
}

} // namespace touchstone::program
