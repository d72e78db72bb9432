// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone judge`: how wrong a code is, where, why, and whether any code could do better.
#include "touchstone/oracle/judge.hpp"
#include "touchstone/oracle/subject.hpp"
#include "touchstone/scalar/rational_text.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"
#include "verify/judge_adapter.hpp"
#include "verify/judge_report.hpp"
#include "verify/judge_rows.hpp"
#include "verify/progress.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <optional>
#include <random>
#include <system_error>
#include <thread>

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;

constexpr unsigned long default_seed = 1; ///< the same run gives the same verdict
constexpr std::size_t rechecked_rows = 16;

struct JudgeOptions {
    std::string table;
    std::vector<std::string> command;
    std::string library, symbol, answers, rows, emit;
    std::vector<std::string> where;
    oracle::Bound bound;
    bool strict = false, json = false, update = false;
    std::string junit, svg, baseline;
    std::size_t held_out = 32;
    std::optional<std::size_t> recheck; ///< else `rechecked_rows`, of those that take less than seconds
    std::string seed_text = std::to_string(default_seed);
    double start_limit = 60, silence_limit = 10, total_limit = 600, memory_limit = 8;
};

/// The table to judge by: a file, a stored one beside the program, or one computed now.
struct Reference {
    StoredTable table;
    std::string file; ///< where it was read; empty if computed now
};

Reference find_reference(const std::string& name)
{
    if (name.find('/') != std::string::npos || name.ends_with(".txt") || fs::is_regular_file(name))
        return {parse_table(read_file(name), name), name};
    const TableSpec* spec = find_table(name);
    if (spec == nullptr && fs::is_directory(name))
        throw Failure(bad_input, fmt::format("{} is a directory; give the name of a table, or the path of one in it", name));
    if (spec == nullptr)
        throw Failure(usage_error, fmt::format("unknown table '{}'; nearest is '{}' (or give the path of a canonical table)", name,
                                               nearest_name(name, table_names())));
    if (const std::string folder = reference_folder(); !folder.empty()) // else a file of that name in the working folder would be believed
        if (const fs::path file = fs::path(folder) / (name + ".txt"); fs::is_regular_file(file))
            return {parse_table(read_file(file), file.string()), file.string()};
    Progress progress("computing " + name, spec->grid().size());
    const Table t = compute(*spec, spec->digits, std::max(1u, std::thread::hardware_concurrency()),
                            [&progress](std::size_t done, std::size_t) { progress.done(done); });
    return {parse_table(format(t, "txt"), name), ""};
}

std::size_t bytes(double gib) { return static_cast<std::size_t>(gib * static_cast<double>(std::size_t{1} << 30)); }
std::chrono::milliseconds limit(double seconds) { return std::chrono::milliseconds(std::max(1L, std::lround(seconds * 1000))); }

oracle::Answers read_answers(const std::string& file, std::size_t rows)
{
    std::ifstream in(file);
    if (!in) read_file(file); // says why not
    try {
        return oracle::read_answers(in, rows);
    }
    catch (const std::system_error& e) {
        throw Failure(bad_input, fmt::format("cannot read {}: {}", file,
                                             std::strerror(e.code().category() == std::generic_category() ? e.code().value() : EIO)));
    }
}

/// `random`, or a natural number.
unsigned long seed_of(const std::string& text)
{
    if (text == "random") return std::random_device{}();
    unsigned long seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc() || end != text.data() + text.size())
        throw Failure(usage_error, fmt::format("--seed '{}': must be random, or an integer from 0 to {}", text,
                                               std::numeric_limits<unsigned long>::max()));
    return seed;
}

oracle::Answers ask(const JudgeOptions& o, const std::vector<oracle::Question>& questions)
{
    oracle::InputRows rows;
    for (const auto& q : questions) rows.push_back(q.inputs);
    const oracle::Limits limits{limit(o.start_limit), limit(o.silence_limit), limit(o.total_limit), bytes(o.memory_limit)};
    if (!o.answers.empty()) return read_answers(o.answers, rows.size());
    if (!o.library.empty()) return oracle::ask_library(o.library, o.symbol, rows, limits);
    return oracle::ask_command(o.command, rows, limits);
}

/// A sample of rows is certified anew, so that a table with a right hash and wrong digits is found out.
std::vector<std::size_t> sample(const Quantity& q, const StoredTable& table, const std::optional<std::size_t>& asked, unsigned long seed)
{
    std::vector<std::size_t> all;
    if (asked) {
        all.resize(table.rows.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
    }
    else all = oracle::quick_rows(q, oracle::questions(table), seed);
    const std::size_t count = std::min(asked.value_or(rechecked_rows), all.size());
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < count; ++i) std::swap(all[i], all[i + random() % (all.size() - i)]);
    all.resize(count);
    return all;
}

oracle::Baseline reached(const Case& c, const StoredTable& table)
{
    oracle::Baseline b{table.name, table.sha256, {}};
    for (std::size_t i = 0; i < c.questions.size(); ++i) {
        if (c.questions[i].held_out) continue;
        const auto& row = c.judgement.rows[i];
        if (row.special || row.error.most >= std::numeric_limits<double>::max())
            throw Failure(fails, fmt::format("no baseline is written: the answer {} at {} is not a finite number of ulps off",
                                             oracle::row_key({row.answer}), oracle::row_key(c.questions[i].inputs)));
        b.bounds[oracle::row_key(c.questions[i].inputs)] = row.error.most;
    }
    return b;
}

/// Every change is said on stderr, one line a row that got worse, one for the rest.
void update_baseline(const JudgeOptions& o, const Case& c, const StoredTable& table, const oracle::Baseline& before)
{
    const oracle::Baseline after = reached(c, table);
    std::size_t counts[4]{};
    for (const auto& line : differences(before, after)) {
        if (line.starts_with("raised")) remark(fmt::format("touchstone: {}: {}\n", o.baseline, line));
        ++counts[line.starts_with("raised") ? 0 : line.starts_with("lowered") ? 1 : line.starts_with("new") ? 2 : 3];
    }
    write_file(o.baseline, after.text());
    remark(fmt::format("touchstone: {} written: {} rows, {} raised, {} lowered, {} new, {} gone\n", o.baseline, after.bounds.size(),
                       counts[0], counts[1], counts[2], counts[3]));
}

oracle::Baseline stored_baseline(const JudgeOptions& o, const StoredTable& table)
{
    if (o.update && !fs::exists(o.baseline)) return {table.name, table.sha256, {}};
    oracle::Baseline b = oracle::parse_baseline(read_file(o.baseline), o.baseline);
    if (o.update) return b;
    if (b.table != table.name || b.sha256 != table.sha256)
        throw oracle::BadBaseline(fmt::format(
            "{}: belongs to table {} with rows of SHA-256 {:.12}..., not to {} with {:.12}... (--update-baseline makes a new one)",
            o.baseline, b.table, b.sha256, table.name, table.sha256));
    for (const auto& row : table.rows)
        if (!b.bounds.contains(oracle::row_key(row.inputs)))
            throw oracle::BadBaseline(fmt::format("{}: has no bound for row {}", o.baseline, oracle::row_key(row.inputs)));
    return b;
}

/// How many subjects are named: one is right.
int subjects(const JudgeOptions& o) { return (o.command.empty() ? 0 : 1) + (o.library.empty() ? 0 : 1) + (o.answers.empty() ? 0 : 1); }

constexpr const char* one_subject =
    "give one subject: -- COMMAND..., --library LIB.so --symbol NAME, --answers FILE, or --rows FILE with a column 'answer'";

void check_options(const JudgeOptions& o)
{
    if (subjects(o) > 1 || (o.rows.empty() && subjects(o) != 1)) throw Failure(usage_error, one_subject);
    if (!o.rows.empty() && !o.baseline.empty()) throw Failure(usage_error, "--baseline belongs to a table, not to --rows");
    if (o.library.empty() != o.symbol.empty()) throw Failure(usage_error, "--library LIB.so and --symbol NAME go together");
    if (o.update && o.baseline.empty()) throw Failure(usage_error, "--update-baseline needs --baseline FILE");
    for (const auto& [name, value] :
         {std::pair{"--ulps", o.bound.ulps}, {"--absolute", o.bound.absolute}, {"--rtol", o.bound.relative}, {"--atol", o.bound.at_least}})
        if (!std::isfinite(value) || value < 0) throw Failure(usage_error, fmt::format("{} {}: must be a finite number >= 0", name, value));
    for (const double seconds : {o.start_limit, o.silence_limit, o.total_limit})
        if (!(seconds > 0 && seconds <= 1e6))
            throw Failure(usage_error, fmt::format("a time limit of {} s: must be > 0 and <= 10^6", seconds));
    if (!(o.memory_limit > 0 && o.memory_limit <= 1e6))
        throw Failure(usage_error, fmt::format("a memory limit of {} GiB: must be > 0 and <= 10^6", o.memory_limit));
}

/// The steps of a judgement on one bar: rows certified anew, rows held out, rows judged.
class Steps {
public:
    Steps(const std::string& what, std::size_t rechecked, std::size_t held_out, std::size_t rows)
        : bar_(what, rechecked + 2 * held_out + rows), rechecked_(rechecked), held_out_(held_out), rows_(held_out + rows)
    {
    }
    void rechecked(std::size_t rows)
    {
        bar_.next(1, "certifying stored rows anew");
        bar_.done(rows);
    }
    void hold_out() { bar_.next(held_out_, "certifying rows that are held out"); }
    void ask()
    {
        bar_.done(rechecked_ + held_out_);
        bar_.next(0, "asking the code");
    }
    std::function<void(std::size_t, std::size_t)> judge()
    {
        bar_.next(rows_, "judging rows");
        return [this](std::size_t done, std::size_t total) {
            bar_.done(rechecked_ + held_out_ + done * rows_ / std::max<std::size_t>(1, total));
        };
    }

private:
    Progress bar_;
    std::size_t rechecked_, held_out_, rows_;
};

/// Nothing fails by a stored row that has not been certified again, but for rows that take minutes: those are left to --recheck. And
/// nothing passes by what a stored row alone says that rounded inputs force.
void recheck_what_decides(const Case& c, const Reference& reference, const std::vector<std::size_t>& rows)
{
    const auto row_of = [&](std::size_t i) { // questions held out stand between those of the table
        return rows[static_cast<std::size_t>(std::count_if(c.questions.begin(), c.questions.begin() + static_cast<long>(i),
                                                           [](const auto& q) { return !q.held_out; }))];
    };
    for (std::size_t i = 0; i < c.questions.size(); ++i)
        if (c.judgement.rows[i].verdict == oracle::Verdict::pass && c.judgement.rows[i].forced && c.questions[i].forced &&
            !c.questions[i].held_out)
            oracle::recheck_forced(*c.quantity, reference.table, row_of(i), reference.file);
    std::vector<std::size_t> decisive;
    const bool dear = oracle::of_the_recursion(*c.quantity); // the worst row is what a verdict needs
    for (const std::size_t i : c.judgement.worst) {
        if (decisive.size() == (dear ? 1 : oracle::shown_rows)) break;
        const bool spared = dear && (c.judgement.rows[i].verdict == oracle::Verdict::pass ||
                                     !oracle::quickly_certified(*c.quantity, c.questions[i].inputs));
        if (!c.questions[i].held_out && !spared) decisive.push_back(row_of(i));
    }
    oracle::recheck(*c.quantity, reference.table, decisive, reference.file, oracle::Recheck::what_decides);
}

int say(const JudgeOptions& o, const Case& c)
{
    fmt::print("{}", o.json ? as_json(c).dump() + "\n" : as_text(c)); // first: a report is not lost with a file that cannot be written
    if (!o.junit.empty()) write_file(o.junit, as_junit(c));
    if (!o.svg.empty() && !c.answers.fault) write_file(o.svg, as_svg(c));
    if (c.answers.fault) throw Failure(protocol_error, fmt::format("'{}' {}", c.subject, c.answers.fault->detail));
    switch (c.judgement.verdict) {
    case oracle::Verdict::pass: return c.left_out > 0 ? undecided : holds;
    case oracle::Verdict::fail: return fails;
    case oracle::Verdict::undecided: break;
    }
    return undecided;
}

Case new_case(const JudgeOptions& o)
{
    Case c;
    c.subject = !o.library.empty()   ? o.library + ":" + o.symbol
                : !o.answers.empty() ? o.answers
                : !o.command.empty() ? fmt::format("{}", fmt::join(o.command, " "))
                                     : o.rows;
    c.bound = o.bound;
    c.bound.forgive_inputs = !o.strict;
    c.seed = seed_of(o.seed_text);
    return c;
}

int judge_by_table(const JudgeOptions& o)
{
    const Reference reference = find_reference(o.table);
    const StoredTable& table = reference.table;
    Case c = new_case(o);
    c.table = table.name;
    c.quantity = find_quantity(table.quantity);
    if (c.quantity == nullptr || c.quantity->inputs != table.inputs)
        throw CorruptTable(fmt::format("{}: quantity '{}' with inputs '{}' is none of this program's", o.table, table.quantity,
                                       fmt::join(table.inputs, " ")));
    const Where where(*c.quantity, o.where);
    const auto rechecked = reference.file.empty() ? std::vector<std::size_t>{} : sample(*c.quantity, table, o.recheck, c.seed);
    std::optional<Steps> steps(std::in_place, "judging by " + table.name, rechecked.size(), o.answers.empty() ? o.held_out : 0,
                               table.rows.size());
    for (std::size_t i = 0; i < rechecked.size(); ++i) {
        oracle::recheck(*c.quantity, table, {rechecked[i]}, reference.file);
        steps->rechecked(i + 1);
    }
    const oracle::Baseline baseline = o.baseline.empty() ? oracle::Baseline{} : stored_baseline(o, table);
    if (!o.baseline.empty() && !o.update) c.bound.baseline = &baseline;

    std::vector<std::size_t> rows; // of the table, as they are asked
    const auto all = oracle::questions(table);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (where.holds(all[i].inputs)) rows.push_back(i);
    if (rows.empty()) throw Failure(bad_input, fmt::format("{}: --where leaves no row", table.name));
    for (const std::size_t i : rows) c.questions.push_back(all[i]);
    if (o.answers.empty()) { // a file of answers is to the table's own rows
        steps->hold_out();
        auto fresh = oracle::held_out(*c.quantity, c.questions, o.held_out, c.seed);
        std::erase_if(fresh, [&](const oracle::Question& q) { return !where.holds(q.inputs); });
        c.held_out = fresh.size();
        std::mt19937_64 random(c.seed + 1);
        for (auto& f : fresh)
            c.questions.insert(c.questions.begin() + static_cast<long>(random() % (c.questions.size() + 1)), std::move(f));
        steps->ask();
        c.answers = ask(o, c.questions);
    }
    else {
        c.answers = ask(o, all);
        if (!c.answers.fault) { // in the table's order, all of them
            std::vector<double> chosen;
            for (const std::size_t i : rows) chosen.push_back(c.answers.values[i]);
            c.answers.values = std::move(chosen);
        }
    }
    if (!c.answers.fault) {
        c.judgement = oracle::judge(*c.quantity, c.questions, c.answers.values, c.bound, steps->judge());
        c.regimes = oracle::regimes(*c.quantity, c.questions, c.judgement);
        if (!reference.file.empty()) recheck_what_decides(c, reference, rows);
    }
    steps.reset(); // before anything is printed
    const int verdict = say(o, c);
    if (o.update) update_baseline(o, c, table, baseline);
    return verdict;
}

/// The quantity of that name, or of the table of that name.
const Quantity& quantity_or_table(const std::string& name)
{
    const TableSpec* spec = find_table(name);
    if (const Quantity* q = find_quantity(spec != nullptr ? spec->quantity : name)) return *q;
    throw Failure(usage_error,
                  fmt::format("unknown quantity '{}'; nearest is '{}' (all: touchstone list)", name, nearest_name(name, quantity_names())));
}

/// KEY=VALUE words before the command: inputs that no column gives.
std::map<std::string, Rational> take_fixed_inputs(const Quantity& q, std::vector<std::string>& words)
{
    std::map<std::string, Rational> fixed;
    const bool surface = std::find(q.inputs.begin(), q.inputs.end(), "G") != q.inputs.end();
    while (!words.empty()) {
        const auto equals = words.front().find('=');
        if (equals == std::string::npos) break;
        const std::string key = words.front().substr(0, equals), text = words.front().substr(equals + 1);
        if (std::find(q.inputs.begin(), q.inputs.end(), key) == q.inputs.end() && !(surface && (key == "D" || key == "gamma"))) break;
        const auto value = parse_rational(text);
        if (!value) throw Failure(bad_input, fmt::format("{} = '{}' {}", key, text, why_not_rational(text)));
        if (!fixed.emplace(key, *value).second) throw Failure(usage_error, fmt::format("key '{}' is given twice", key));
        words.erase(words.begin());
    }
    return fixed;
}

int judge_by_rows(JudgeOptions o)
{
    const Quantity& q = quantity_or_table(o.table);
    const auto fixed = take_fixed_inputs(q, o.command);
    std::optional<Progress> progress(std::in_place, "steps of judging", 2); // certifying, judging
    progress->next(1);
    JudgedFile file = read_rows(q, o.rows, fixed, Where(q, o.where));
    progress->next(1);
    if (subjects(o) + (file.answers ? 1 : 0) != 1) throw Failure(usage_error, one_subject);
    Case c = new_case(o);
    c.table = o.rows;
    c.quantity = &q;
    c.questions = std::move(file.questions);
    c.left_out = file.left_out;
    c.why_left_out = file.why_left_out;
    if (file.answers) c.answers.values = std::move(*file.answers);
    else c.answers = ask(o, c.questions);
    if (!c.answers.fault) {
        Steps steps("judging rows", 0, 0, c.questions.size());
        c.judgement = oracle::judge(q, c.questions, c.answers.values, c.bound, steps.judge());
        c.regimes = oracle::regimes(q, c.questions, c.judgement);
    }
    progress.reset(); // before anything is printed
    return say(o, c);
}

int judge_subject(const JudgeOptions& o)
{
    if (!o.emit.empty()) {
        fmt::print("{}", adapter(quantity_or_table(o.table), o.emit));
        return holds;
    }
    check_options(o);
    return o.rows.empty() ? judge_by_table(o) : judge_by_rows(o);
}

} // namespace

void add_judge(CLI::App& app, Run& run)
{
    auto* command =
        app.add_subcommand("judge", "How wrong a code is, where and why: touchstone judge westergaard_pressure --ulps 4 -- ./mycode");
    auto o = std::make_shared<JudgeOptions>();
    command->add_option("table", o->table, "Name of a table, or the path of a canonical table; with --rows or --emit a quantity")
        ->required();
    command->add_option("command", o->command,
                        "After --: the program and its arguments; it reads rows of hexadecimal numbers and writes one number a line");
    command->add_option("--library", o->library, "Shared library whose function is called, in a process of its own")->check(not_empty());
    command->add_option("--symbol", o->symbol, "double SYMBOL(double, ...) in --library");
    command->add_option("--answers", o->answers, "File with one answer a line, in the table's order")->check(not_empty());
    command
        ->add_option("--rows", o->rows,
                     "File of rows, - for standard input: columns named by the inputs, and 'answer' last unless a subject is given; "
                     "KEY=VALUE for the rest, with a program after -- and before it")
        ->check(not_empty());
    command->add_option("--where", o->where, "Rows that count: 'load=1e-6..0.999,n=3'");
    command->add_option("--rtol", o->bound.relative, "Relative error that passes too: |answer - true| <= ATOL + RTOL |true|")
        ->capture_default_str();
    command->add_option("--atol", o->bound.at_least, "Absolute error that passes too")->capture_default_str();
    command->add_option("--emit", o->emit, "Print an adapter to fill in and nothing else: python, c, fortran or octave")
        ->check(CLI::IsMember(adapter_languages()));
    command->add_option("--ulps", o->bound.ulps, "Allowed error in ulps, beyond what the rounding of inputs forces")->capture_default_str();
    command->add_flag("--strict", o->strict, "The inputs are exact: forgive nothing for their rounding");
    command->add_option("--absolute", o->bound.absolute, "Allowed error where the true value is zero")->capture_default_str();
    command->add_flag("--keep-order", o->bound.keep_order, "Answers out of order or not symmetric fail too");
    command->add_option("--baseline", o->baseline, "Bounds row by row, as the code reached them before; they replace --ulps")
        ->check(not_empty());
    command->add_flag("--update-baseline", o->update, "Write --baseline from this run and say what changed");
    command->add_option("--held-out", o->held_out, "Rows that are not in the table, certified now")
        ->check(CLI::Range(0, 10000))
        ->capture_default_str();
    command
        ->add_option(
            "--recheck", o->recheck,
            fmt::format(
                "Rows of a stored table certified anew before it is trusted (default: {}, and what decides; none that takes minutes)",
                rechecked_rows))
        ->check(CLI::Range(0, 1000000000));
    command->add_option("--seed", o->seed_text, "Which rows are held out and rechecked: a number, or random (then printed)")
        ->capture_default_str();
    command->add_option("--start-limit", o->start_limit, "Seconds until the first answer")->capture_default_str();
    command->add_option("--row-limit", o->silence_limit, "Seconds of silence between answers")->capture_default_str();
    command->add_option("--time-limit", o->total_limit, "Seconds in all")->capture_default_str();
    command->add_option("--memory-limit", o->memory_limit, "GiB held by the code and its children")->capture_default_str();
    command->add_flag("--json", o->json, "One JSON object");
    command->add_option("--junit", o->junit, "Write JUnit XML, one test case a row")->check(not_empty());
    command->add_option("--svg", o->svg, "Write a plot of error against input")->check(not_empty());
    command->callback([&run, o] { run = [o] { return judge_subject(*o); }; });
}

} // namespace touchstone::program
