// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone table`: certified tables, written whole or not at all.
#include "touchstone/table/format.hpp"
#include "touchstone/table/own_table.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"
#include "verify/manifest.hpp"
#include "verify/progress.hpp"
#include "verify/shards.hpp"
#include "verify/table_list.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <list>
#include <optional>
#include <sstream>
#include <thread>

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;

struct TableOptions {
    std::vector<std::string> names;
    std::optional<long> digits; ///< else each table's own
    std::string format = "txt";
    std::string out;
    unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
    bool check = false;
    bool skip_slow = false;
    bool renew_forced = false;
    std::string shard;
};

/// Some characters of a line from about a place on; what cannot be seen is named.
std::string shown_from(const std::string& line, std::size_t place)
{
    constexpr std::size_t before = 60, most = 120;
    const std::size_t begin = place > before ? place - before : 0;
    std::string shown = begin > 0 ? "..." : "";
    for (const char c : line.substr(begin, most)) {
        const auto u = static_cast<unsigned char>(c);
        shown += c == '\r' ? "<CR>" : u < 0x20 || u >= 0x7f ? fmt::format("\\x{:02x}", u) : std::string(1, c);
    }
    return shown + (begin + most < line.size() ? "..." : "");
}

/// Where two texts part: the line number and the two lines.
std::string first_difference(const std::string& expected, const std::string& found)
{
    std::istringstream a(expected), b(found);
    std::string x, y;
    for (int line = 1;; ++line) {
        const bool more_a = static_cast<bool>(std::getline(a, x));
        const bool more_b = static_cast<bool>(std::getline(b, y));
        if (!more_a && !more_b) return "line ends";
        if (more_a != more_b || x != y) {
            const auto place = static_cast<std::size_t>(std::mismatch(x.begin(), x.end(), y.begin(), y.end()).first - x.begin());
            const bool returns = y == x + "\r";
            return fmt::format("line {}: regenerated '{}', stored '{}'{}", line, more_a ? shown_from(x, place) : "",
                               more_b ? shown_from(y, place) : "",
                               returns ? "; lines end in CR LF where LF is right (git's core.autocrlf?)" : "");
        }
    }
}

/// \param own keeps the tables that are described in files
std::vector<const TableSpec*> chosen(const std::vector<std::string>& names, std::list<TableSpec>& own)
{
    std::vector<const TableSpec*> specs;
    for (const auto& name : names) {
        if (name == "all") {
            for (const auto& t : table_specs()) specs.push_back(&t);
            continue;
        }
        if (name.ends_with(".json")) {
            own.push_back(own_table(read_file(name), name));
            specs.push_back(&own.back());
            continue;
        }
        const TableSpec* t = find_table(name);
        if (t == nullptr)
            throw Failure(usage_error, fmt::format("unknown table '{}'; nearest is '{}'", name, nearest_name(name, table_names())));
        specs.push_back(t);
    }
    // each once, in the order first named
    std::vector<const TableSpec*> once;
    for (const TableSpec* t : specs)
        if (std::find(once.begin(), once.end(), t) == once.end()) once.push_back(t);
    return once;
}

/// Only what rounded inputs force is worked out anew, in the stored tables; their values stay as they are.
int renew_forced(const TableOptions& o)
{
    if (o.out.empty() || o.check || o.format != "txt")
        throw Failure(usage_error, "--renew-forced needs --out DIR, the folder of the stored txt tables, and no --check");
    std::list<TableSpec> own;
    nlohmann::ordered_json fresh = nlohmann::ordered_json::array();
    for (const TableSpec* spec : chosen(o.names, own)) {
        const fs::path path = fs::path(o.out) / (spec->name + ".txt");
        const std::string text = read_file(path);
        const StoredTable stored = parse_table(text, path.string());
        const std::string renewed = with_forced(stored, text);
        if (renewed != text) write_into_folder(o.out, path.filename(), renewed);
        fresh.push_back({{"name", spec->name},
                         {"file", spec->name + ".txt"},
                         {"quantity", spec->quantity},
                         {"rows", stored.rows.size()},
                         {"digits", stored.digits},
                         {"status", nlohmann::json::parse(stored.header_json).at("status")},
                         {"sha256", sha256(renewed)}});
        fmt::print("{:<28} {:>5} rows, {}\n", spec->name + ".txt", stored.rows.size(), renewed == text ? "unchanged" : "written");
        flush_output();
    }
    if (fs::exists(fs::path(o.out) / manifest_name("txt"))) renew_manifest(o.out, "txt", fresh);
    return holds;
}

/// One share of each table; merge makes them whole.
int make_shares(const TableOptions& o)
{
    if (o.check || o.format != "txt")
        throw Failure(usage_error, "--shard makes shares of txt tables, for touchstone merge: no --check, no --format");
    const Share share = share_named(o.shard);
    std::list<TableSpec> own;
    const auto specs = chosen(o.names, own);
    if (specs.size() > 1 && (o.out.empty() || o.out.ends_with(".txt"))) throw Failure(usage_error, "several tables need --out DIR");
    if (o.digits && (*o.digits < 1 || *o.digits > 10'000))
        throw Failure(bad_input, fmt::format("digits = {}: must be from 1 to 10000", *o.digits));
    int code = holds;
    for (const TableSpec* spec : specs)
        if (!o.skip_slow || !spec->slow) code = std::max(code, table_share(*spec, o.digits.value_or(spec->digits), o.jobs, share, o.out));
    return code;
}

int make_tables(const TableOptions& o)
{
    if (o.names.empty()) {
        if (o.check || o.renew_forced || o.digits || !o.shard.empty() || o.format != "txt")
            throw Failure(usage_error, "names of tables are missing; touchstone table alone, or with --out DIR, lists them");
        return list_tables(o.out.empty() ? reference_folder() : o.out);
    }
    if (o.renew_forced) return renew_forced(o);
    if (!o.shard.empty()) return make_shares(o);
    std::list<TableSpec> own;
    auto specs = chosen(o.names, own);
    if (o.skip_slow) std::erase_if(specs, [](const TableSpec* t) { return t->slow; });
    if (o.digits && (*o.digits < 1 || *o.digits > 10'000))
        throw Failure(bad_input, fmt::format("digits = {}: must be from 1 to 10000", *o.digits));
    if (o.out.empty() && (specs.size() > 1 || o.check))
        throw Failure(usage_error, o.check ? "--check needs --out DIR, the folder of the stored tables" : "several tables need --out DIR");
    if (!o.out.empty() && !o.check) {
        std::error_code error;
        fs::create_directories(o.out, error);
        if (!error && ::access(o.out.c_str(), W_OK) != 0) error = std::error_code(errno, std::generic_category());
        if (error) throw Failure(cannot_write, fmt::format("cannot write into {}: {}", o.out, error.message()));
    }
    std::size_t rows = 0;
    for (const TableSpec* spec : specs) rows += spec->grid().size();
    Progress progress(specs.size() == 1 ? specs.front()->name : "tables", rows);
    rows = 0; // of the tables before
    const bool whole_set = own.empty() && specs.size() == table_specs().size();
    nlohmann::ordered_json manifest = nlohmann::ordered_json::array();
    std::vector<std::string> changed;
    bool any_undecided = false;
    for (const TableSpec* spec : specs) {
        const auto start = std::chrono::steady_clock::now();
        const Table t = compute(*spec, o.digits.value_or(spec->digits), o.jobs, [&](std::size_t done, std::size_t) {
            progress.next(0, spec->name);
            progress.done(rows + done);
        });
        rows += t.rows.size();
        progress.clear();
        any_undecided = any_undecided || t.status() == Status::undecided;
        const std::string text = format(t, o.format);
        const std::string file = spec->name + "." + o.format;
        manifest.push_back({{"name", spec->name},
                            {"file", file},
                            {"quantity", spec->quantity},
                            {"rows", t.rows.size()},
                            {"digits", t.digits},
                            {"status", std::string(to_string(t.status()))},
                            {"sha256", sha256(text)}});
        if (o.out.empty()) {
            fmt::print("{}", text);
            continue;
        }
        const fs::path path = fs::path(o.out) / file;
        std::string verdict = "written";
        if (o.check) {
            const std::string stored = read_file(path);
            verdict = stored == text ? "unchanged" : "CHANGED";
            if (stored != text) {
                if (!stored.starts_with(text.substr(0, 8)))
                    throw CorruptTable(fmt::format("{}: not a table in {} format", path.string(), o.format)); // not even a changed one
                changed.push_back(fmt::format("{} differs: {}", path.string(), first_difference(text, stored)));
            }
        }
        else write_into_folder(o.out, file, text);
        fmt::print("{:<28} {:>5} rows, {:>4} digits, {}, {} ({:.1f} s)\n", file, t.rows.size(), t.digits, to_string(t.status()), verdict,
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        flush_output(); // minutes may pass until the next
    }
    const fs::path manifest_path = fs::path(o.out) / manifest_name(o.format);
    if (!o.out.empty() && whole_set) {
        if (!o.check) write_manifest_of_all(o.out, o.format, manifest);
        else if (const std::string stored = read_file(manifest_path), text = manifest_of_all(o.out, o.format, manifest); stored != text)
            changed.push_back(fmt::format("{} differs: {}", manifest_path.string(), first_difference(text, stored)));
    }
    else if (!o.out.empty() && !o.check && (!own.empty() || fs::exists(manifest_path))) renew_manifest(o.out, o.format, manifest);
    if (!changed.empty()) throw Failure(fails, fmt::format("{}", fmt::join(changed, "; ")));
    return any_undecided ? undecided : holds;
}

} // namespace

void add_table(CLI::App& app, Run& run)
{
    auto* command =
        app.add_subcommand("table", "Certified tables: touchstone table archard_K, touchstone table all --out DIR; without a name: "
                                    "which there are, and what the independent checker has confirmed of each");
    auto o = std::make_shared<TableOptions>();
    command->add_option("names", o->names,
                        "Table names, files FILE.json that describe a table of your own, or all: " +
                            fmt::format("{}", fmt::join(table_names(), " ")));
    command->add_option("--digits", o->digits, "Significant digits, 1 to 10000 (default: each table's own)");
    command->add_option("--format", o->format, "txt, csv, json, hpp (constexpr array) or ipp (Boost.Math)")
        ->check(CLI::IsMember(table_formats()))
        ->capture_default_str();
    command->add_option("--out", o->out, "Folder for the files; without it one table goes to standard output")->check(not_empty());
    command->add_option("--jobs", o->jobs, "Threads")->check(CLI::Range(1u, 1024u));
    command->add_flag("--skip-slow", o->skip_slow, "Leave out the tables that take minutes (full contact, distributions at all scales)");
    command->add_flag("--check", o->check, "Write nothing: regenerate and compare with the files in --out, byte for byte");
    command->add_flag("--renew-forced", o->renew_forced,
                      "Only what rounded inputs force is worked out anew, in the tables in --out; their values are kept");
    command
        ->add_option("--shard", o->shard,
                     "I/N: only share I of N, a file of its own in --out, for touchstone merge; kept if it is there already")
        ->check(not_empty());
    command->callback([&run, o] { run = [o] { return make_tables(*o); }; });
}

} // namespace touchstone::program
