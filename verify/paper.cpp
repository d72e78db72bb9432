// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone paper`: the ledger, one verdict for each equation, table entry and sentence.
#include "proofs/coq_theorems.hpp"
#include "proofs/errata.hpp"
#include "proofs/ledger.hpp"
#include "proofs/lemmas/stored_values.hpp"
#include "proofs/mutation/survivors.hpp"
#include "proofs/recorded.hpp"
#include "proofs/sections.hpp"
#include "proofs/severity.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/paper.hpp"
#include "verify/paper_ledger.hpp"
#include "verify/progress.hpp"
#include "verify/report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace touchstone::program {
namespace {

using namespace touchstone::proofs;

struct PaperOptions {
    std::string id;
    bool json = false;
    bool controls = false;
    std::string svg, pdf, csv;
    bool mutate = false;
    bool recompute = false, values = false, verdicts = false;
    bool own = false;
    std::vector<std::string> with; ///< "FIELD=TEXT"
    bool corrected = false;
    std::string errata; ///< md, tex, html
    std::string ledger; ///< a directory with a ledger of one's own
};

std::string corrected_form(const Entry& e)
{
    const auto& c = e.claim->correction;
    return e.finding.verdict == Verdict::refuted && c ? c->corrected : "";
}

/// Everything that should hold of an entry and does not, one line each.
std::vector<std::string> failures(const Entry& e)
{
    std::vector<std::string> all = e.surviving();
    const Verdict expected = expected_verdict(e.claim->id);
    if (e.finding.verdict != expected)
        all.push_back(fmt::format("verdict {}, recorded {}", name(e.finding.verdict), name(expected)));
    return all;
}

std::vector<Entry> judge_all()
{
    Progress progress("judging entries", claims().size());
    std::vector<Entry> entries;
    for (const Claim& c : claims()) {
        entries.push_back(run(c, prints().at(c.id)));
        progress.done(entries.size());
    }
    return entries;
}

nlohmann::ordered_json json_of(const Entry& e)
{
    const auto& c = e.claim->correction;
    nlohmann::ordered_json j = {{"id", e.claim->id},
                                {"verdict", name(e.finding.verdict)},
                                {"method", e.finding.method},
                                {"statement", e.claim->statement},
                                {"reason", e.finding.reason},
                                {"correction", corrected_form(e)},
                                {"assumptions", e.claim->assumptions},
                                {"print", e.print.tex.empty() ? e.print.quote : e.print.tex},
                                {"rests_on", e.claim->rests_on},
                                {"steps", e.finding.steps},
                                {"judge", e.finding.judge},
                                {"lemmas", e.finding.lemmas},
                                {"rows", e.finding.rows},
                                {"caveat", caveat(e.claim->id)},
                                {"same_as", same_as(e.claim->id)}};
    if (c) {
        j["fault"] = c->fault;
        j["severity"] = severity(*c);
        j["wrong"] = c->wrong;
        j["consequence"] = c->consequence;
        j["correction_verdict"] = name(e.corrected->verdict);
    }
    j["controls"] = nlohmann::ordered_json::array();
    for (const auto& k : e.controls)
        j["controls"].push_back({{"what", k.what}, {"verdict", name(k.finding.verdict)}, {"reason", k.finding.reason}});
    const CoqTheorem* coq = coq_theorem(e.claim->id);
    j["ground"] = ground(e);
    j["coq"] = coq == nullptr ? "" : fmt::format("{} {}", coq->theorem, coq->file);
    j["failures"] = failures(e);
    return j;
}

/// "2.2 2.3 2.4" in lines of a width that fits a terminal.
void print_ids(std::string_view label, const std::vector<std::string>& ids)
{
    if (ids.empty()) return;
    std::string line = fmt::format("  {:<11}", label);
    for (const std::string& id : ids) {
        if (line.size() + id.size() > 110) {
            fmt::print("{}\n", line);
            line = std::string(13, ' ');
        }
        line += " " + id;
    }
    fmt::print("{}\n", line);
}

int print_ledger(const std::vector<Entry>& entries)
{
    std::map<std::string, std::vector<const Entry*>> by_section; // the sentences follow the equations of their section
    for (const Entry& e : entries) by_section[e.print.section].push_back(&e);
    std::map<Verdict, int> count;
    std::map<std::string, int> refuted, again; // by severity; of these the ones that say what another entry said
    int controls = 0, failed = 0;
    for (const auto& [s, heading] : sections()) {
        if (!by_section.contains(s)) continue;
        fmt::print("{}\n", heading);
        for (const Verdict v : {Verdict::proved, Verdict::verified, Verdict::argued, Verdict::definition}) {
            std::vector<std::string> ids;
            for (const Entry* e : by_section[s])
                if (e->finding.verdict == v) ids.push_back(e->claim->id);
            print_ids(name(v), ids);
        }
        for (const Verdict v : {Verdict::qualitative, Verdict::undecided, Verdict::refuted})
            for (const Entry* e : by_section[s]) {
                if (e->finding.verdict != v) continue;
                const auto& c = e->claim->correction;
                if (v == Verdict::refuted && c)
                    fmt::print("  refuted     {}  {}{}: {}\n              holds ({}): {}\n", e->claim->id, severity(*c),
                               same_as(e->claim->id).empty() ? "" : ", as " + same_as(e->claim->id), c->wrong, name(e->corrected->verdict),
                               c->corrected);
                else fmt::print("  {:<11} {}  {}\n", name(v), e->claim->id, e->finding.reason);
            }
        for (const Entry* e : by_section[s])
            if (!caveat(e->claim->id).empty()) fmt::print("  caveat      {}  {}\n", e->claim->id, caveat(e->claim->id));
    }
    for (const Entry& e : entries) {
        ++count[e.finding.verdict];
        if (e.finding.verdict == Verdict::refuted && e.claim->correction) {
            ++refuted[std::string(severity(*e.claim->correction))];
            if (!same_as(e.claim->id).empty()) ++again[std::string(severity(*e.claim->correction))];
        }
        controls += static_cast<int>(e.controls.size()) + (e.corrected ? 1 : 0);
        for (const std::string& f : failures(e)) {
            fmt::print("FAILED {}: {}\n", e.claim->id, f);
            ++failed;
        }
    }
    fmt::print("\n{} entries:", entries.size());
    const char* comma = " ";
    for (const auto& [v, n] : count) {
        fmt::print("{}{} {}", comma, n, name(v));
        comma = ", ";
    }
    fmt::print("; {} controls and corrected forms judged\n", controls);
    std::map<std::string_view, int> grounds;
    for (const Entry& e : entries) ++grounds[ground(e)];
    fmt::print("proved or verified: {} by Coq, {} by symbols, {} by balls; {} argued (Coq: proofs/coq, ./bootstrap.sh prove)\n",
               grounds["Coq"], grounds["symbols"], grounds["balls"], grounds["argument"]);
    if (!refuted.empty()) {
        fmt::print("of the refuted:");
        comma = " ";
        for (const char* kind : {"misprint", "imprecise", "false"}) {
            fmt::print("{}{} {}", comma, refuted[kind] - again[kind], kind);
            if (again[kind] > 0) fmt::print(" (said {} times more)", again[kind]);
            comma = ", ";
        }
        fmt::print("\n");
    }
    if (failed == 0)
        fmt::print("every verdict is the recorded one and every control was caught; `touchstone paper 7.17` explains one entry\n");
    return failed == 0 ? holds : fails;
}

int print_controls(const std::vector<Entry>& entries)
{
    int survivors = 0, all = 0;
    for (const Entry& e : entries) {
        for (const auto& k : e.controls) {
            const bool caught = k.finding.verdict == Verdict::refuted;
            fmt::print("{:<8} {:<28} {}\n         {}\n", caught ? "caught" : "SURVIVES", e.claim->id, k.what, k.finding.reason);
            survivors += caught ? 0 : 1;
            ++all;
        }
        if (e.corrected)
            fmt::print("{:<8} {:<28} {}\n", name(e.corrected->verdict), e.claim->id, "corrected: " + e.claim->correction->corrected);
    }
    int failed = 0;
    for (const Entry& e : entries) failed += static_cast<int>(e.surviving().size());
    fmt::print("{} perturbed prints, {} survive\n", all, survivors);
    return failed == 0 ? holds : fails;
}

/// The typesetter's changes of one entry or of all, and which of them no judge sees.
int print_mutation(const std::string& id)
{
    std::vector<const Claim*> some;
    for (const Claim& c : claims())
        if (id.empty() || c.id == id) some.push_back(&c);
    const Mutation m = [&some] {
        Progress progress("judging changed prints", some.size());
        return mutate(some, 1, 0, [&progress](std::size_t done) { progress.done(done); });
    }();
    int excused = 0;
    if (!id.empty())
        for (const Survivor& s : m.caught) fmt::print("refuted  {}\n         {}\n", s.change, s.reason);
    for (const Survivor& s : m.survivors) {
        if (s.excuse.empty()) fmt::print("SURVIVES as {:<11} {:<28} {}: {}\n", s.verdict, s.id, s.kind, s.change);
        if (s.verdict == "exception") fmt::print("         {}\n", s.reason);
        excused += s.excuse.empty() ? 0 : 1;
        if (!id.empty() && !s.excuse.empty()) fmt::print("excused  {:<14} {}\n         {}\n", s.id, s.change, s.excuse);
    }
    for (const std::string& idle : m.idle_excuses) fmt::print("IDLE EXCUSE {}\n", idle);
    fmt::print("{} changes:", m.changes);
    const char* comma = " ";
    for (const auto& [kind, n] : m.by_kind) {
        fmt::print("{}{} {}", comma, n, kind);
        comma = ", ";
    }
    fmt::print("\n{} refuted, {} excused as saying the same, {} survive\n", m.refuted, excused, m.unexcused());
    return m.unexcused() == 0 && m.idle_excuses.empty() ? holds : fails;
}

int explain(const Entry& e)
{
    const auto section = [](std::string_view title, const std::string& text) {
        if (!text.empty()) fmt::print("{:<12} {}\n", title, text);
    };
    const auto joined = [](const std::vector<std::string>& ids) { return fmt::format("{}", fmt::join(ids, ", ")); };
    section("entry", e.claim->id);
    section("print", e.print.tex.empty() ? e.print.quote : e.print.tex);
    section("statement", e.claim->statement);
    section("assuming", e.claim->assumptions);
    section("verdict", std::string(name(e.finding.verdict)));
    section("reason", e.finding.reason);
    section("caveat", caveat(e.claim->id));
    section("same as", same_as(e.claim->id));
    if (const auto& c = e.claim->correction) {
        section("goes wrong", fmt::format("{}: {}", severity(*c), c->wrong));
        section("holds", fmt::format("{} ({})", c->corrected, name(e.corrected->verdict)));
        section("consequence", c->consequence);
    }
    section("method", e.finding.method);
    if (const CoqTheorem* t = coq_theorem(e.claim->id))
        section("Coq",
                fmt::format("{} in {}{}{}{}", t->theorem, t->file, t->whole ? "" : " (in part)", t->sense.empty() ? "" : ": ", t->sense));
    section("judged in", e.finding.judge);
    for (std::size_t i = 0; i < e.finding.lemmas.size(); ++i) section(i == 0 ? "lemmas" : "", e.finding.lemmas[i]);
    if (!e.finding.rows.empty())
        section("rows",
                fmt::format("{} of data/paper/values.txt, {} to {}", e.finding.rows.size(), e.finding.rows.front(), e.finding.rows.back()));
    for (std::size_t i = 0; i < e.finding.steps.size(); ++i)
        section(i == 0 ? "steps" : "", fmt::format("{}. {}", i + 1, e.finding.steps[i]));
    if (e.corrected)
        for (std::size_t i = 0; i < e.corrected->steps.size(); ++i)
            section(i == 0 ? "corrected" : "", fmt::format("{}. {}", i + 1, e.corrected->steps[i]));
    for (std::size_t i = 0; i < e.controls.size(); ++i)
        section(i == 0 ? "controls" : "",
                fmt::format("{}: {} ({})", e.controls[i].what, name(e.controls[i].finding.verdict), e.controls[i].finding.reason));
    section("rests on", joined(e.claim->rests_on));
    std::vector<std::string> used_by;
    for (const Claim& c : claims())
        if (std::find(c.rests_on.begin(), c.rests_on.end(), e.claim->id) != c.rests_on.end()) used_by.push_back(c.id);
    section("used by", joined(used_by));
    section("replay", "touchstone paper " + e.claim->id);
    const auto bad = failures(e);
    for (const std::string& f : bad) section("FAILED", f);
    return bad.empty() ? holds : fails;
}

int run_paper(const PaperOptions& options)
{
    if (!options.ledger.empty()) return run_own_ledger(options.ledger, options.id, options.json, options.mutate);
    if (options.recompute || options.values) recompute_values();
    if (!options.svg.empty() || !options.pdf.empty() || !options.csv.empty())
        return write_figure(options.id, options.svg, options.pdf, options.csv);
    if (options.own) return print_own(options.id, options.json);
    if (!options.id.empty()) {
        const auto claim = std::find_if(claims().begin(), claims().end(), [&](const Claim& c) { return c.id == options.id; });
        if (claim == claims().end())
            throw Failure(
                bad_input,
                fmt::format("no entry '{}' in the ledger; an equation number such as 7.17, or an id that `touchstone paper --json` lists",
                            options.id));
        if (options.mutate) return print_mutation(options.id);
        if (!options.with.empty() || options.corrected) return print_changed(*claim, options.with, options.corrected, options.json);
        const Entry e = run(*claim, prints().at(claim->id));
        if (!options.json) return explain(e);
        fmt::print("{}\n", json_of(e).dump());
        return failures(e).empty() ? holds : fails;
    }
    if (options.mutate) return print_mutation("");
    if (options.verdicts) {
        fmt::print("{}", recorded_form(judge_all()));
        return holds;
    }
    if (options.values) {
        judge_all();
        fmt::print("{}", computed_table());
        return holds;
    }
    if (!options.errata.empty()) {
        fmt::print("{}", errata(options.errata));
        return holds;
    }
    const std::vector<Entry> entries = judge_all();
    if (options.json) {
        nlohmann::ordered_json out = nlohmann::ordered_json::array();
        bool good = true;
        for (const Entry& e : entries) {
            out.push_back(json_of(e));
            good = good && failures(e).empty();
        }
        fmt::print("{}\n", out.dump());
        return good ? holds : fails;
    }
    const int status = options.controls ? print_controls(entries) : print_ledger(entries);
    if (!options.recompute) return status;
    const std::vector<std::string> differ = values_that_differ();
    for (const std::string& line : differ) fmt::print("DIFFERS {}\n", line);
    if (differ.empty()) fmt::print("every value computed is the stored one\n");
    return differ.empty() ? status : fails;
}

} // namespace

nlohmann::ordered_json ledger_json()
{
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Entry& e : judge_all()) all.push_back(json_of(e));
    return all;
}

void add_paper(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand("paper", "Every equation, table entry and checkable sentence of the paper: one verdict each");
    auto options = std::make_shared<PaperOptions>();
    command->add_option("entry", options->id, "One entry in full: 7.17, table1.n07, text.limit-0.39139, ...");
    command->add_flag("--json", options->json, "An array of objects");
    command->add_flag("--controls", options->controls, "The perturbed prints, each of which must be refuted");
    command->add_option("--svg", options->svg, "Draw a figure: touchstone paper figure5 --svg FILE");
    command->add_option("--pdf", options->pdf, "Draw a figure");
    command->add_option("--csv", options->csv, "The points of a figure, each with its error and status");
    command->add_option("--errata", options->errata, "The erratum, from the proved corrections of the equations")
        ->check(CLI::IsMember({"md", "tex", "html"}));
    command->add_flag("--mutate", options->mutate, "What a typesetter could change in the print, and what no judge would see");
    command
        ->add_option("--with", options->with,
                     "FIELD=TEXT: judge the entry as if a field of its print read so (repeatable); `rhs`, `relation`, `M.from`, ...")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_flag("--corrected", options->corrected, "Judge the corrected form of a refuted entry, with the changes of --with");
    command->add_option("--ledger", options->ledger, "A ledger of one's own: the directory with its ledger.json (docs/ledger.md)")
        ->check(not_empty());
    command->add_flag("--recompute", options->recompute,
                      "Compute what takes long, instead of taking it from data/paper/values.txt (hash checked), and compare");
    command->add_flag("--values", options->values, "Print data/paper/values.txt, computed anew");
    command->add_flag("--verdicts", options->verdicts, "Print data/paper/verdicts.txt, as judged now");
    command->add_flag("--own", options->own,
                      "What the program itself rests on: the lemmas of its operator and every constant of its proofs, each with a control");
    command->callback([&run, options, command] {
        if (command->count("entry") > 0 && options->id.empty())
            throw CLI::ValidationError("entry", "is empty; an equation number such as 7.17, or nothing for all");
        if ((!options->with.empty() || options->corrected) && (options->id.empty() || !options->ledger.empty()))
            throw CLI::ValidationError("--with, --corrected", "are for one entry of the paper, such as 7.18");
        run = [options] { return run_paper(*options); };
    });
}

} // namespace touchstone::program
