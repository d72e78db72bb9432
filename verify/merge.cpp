// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone merge DIR`: shares to tables, all of them or none.
#include "touchstone/table/format.hpp"
#include "touchstone/table/shard.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"
#include "verify/manifest.hpp"
#include "verify/row_reader.hpp"
#include "verify/shards.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <unordered_map>

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;

/// The shares of one table that are there, and what is wrong with those that are of no use.
struct Found {
    std::vector<Shard> shards;
    std::vector<std::string> files;
    std::vector<std::string> faults; ///< one a file
    std::set<std::size_t> bad;       ///< their indices, where they say them
    std::size_t count = 0;           ///< N, as far as it is known
    std::vector<std::pair<const std::string*, std::string>> rows; ///< of a table of rows: lines of the shards, and their statuses
};

bool looks_like_a_shard(const fs::path& path)
{
    if (path.filename().string().find(".shard-") != std::string::npos && path.extension() == ".txt") return true;
    std::ifstream in(path, std::ios::binary);
    std::string begin(shard_mark.size(), '\0');
    return in.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == shard_mark;
}

/// A file that cannot be read still has a name: contact_area.shard-03-of-16.txt.
void note_by_name(std::map<std::string, Found>& all, const std::string& file, const std::string& fault)
{
    static const std::regex pattern(R"((.+)\.shard-0*(\d{1,7})-of-(\d{1,7})\.txt)");
    std::smatch parts;
    const bool named = std::regex_match(file, parts, pattern);
    Found& f = all[named ? parts[1].str() : file];
    f.faults.push_back(fault);
    if (!named) return;
    f.bad.insert(std::stoul(parts[2].str()));
    f.count = std::max<std::size_t>(f.count, std::stoul(parts[3].str()));
}

/// \throws CorruptTable with the file's name
void check(const Shard& s, const std::string& file)
{
    try {
        if (s.kind == "rows") check_rows(s);
        else if (s.kind != "table") throw CorruptTable(fmt::format("is of the kind '{:.40}', which is none", s.kind));
    }
    catch (const CorruptTable& e) {
        throw CorruptTable(fmt::format("{}: {}", file, e.what()));
    }
}

std::map<std::string, Found> find_shards(const std::string& folder)
{
    std::error_code error;
    if (!fs::is_directory(folder, error)) throw Failure(no_input_file, fmt::format("{} is no folder", folder));
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        std::error_code of_entry; // a link that leads nowhere is no shard
        if (entry.is_regular_file(of_entry) && looks_like_a_shard(entry.path())) paths.push_back(entry.path());
    }
    if (error) throw Failure(bad_input, fmt::format("{}: {}", folder, error.message()));
    std::sort(paths.begin(), paths.end());
    std::map<std::string, Found> all;
    for (const auto& path : paths) {
        const std::string file = path.filename().string();
        try {
            Shard s = parse_shard(read_file(path), file);
            check(s, file);
            Found& f = all[s.name];
            f.count = std::max(f.count, s.share.count);
            f.shards.push_back(std::move(s));
            f.files.push_back(file);
        }
        catch (const CorruptTable& e) {
            note_by_name(all, file, e.what());
        }
    }
    if (all.empty())
        throw Failure(no_input_file,
                      fmt::format("{}: no shards there (touchstone table NAME --shard 1/16 --out {} makes one)", folder, folder));
    return all;
}

long digits_of(const Shard& s)
{
    const auto about = nlohmann::json::parse(s.about, nullptr, false);
    return about.is_object() && about.contains("digits") && about["digits"].is_number_integer() ? about["digits"].get<long>() : 0;
}

/// Shares that do not belong together, or not to this program; rows that are there twice.
void find_strangers(Found& f)
{
    std::map<std::string, std::size_t> specs; // what most of them are of is right
    for (const Shard& s : f.shards) ++specs[s.spec + fmt::format("/{}", s.share.count)];
    const auto most = std::max_element(specs.begin(), specs.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    std::map<std::size_t, std::string> seen;
    std::unordered_map<std::size_t, std::size_t> row_from; // as many as there are, whatever number of rows a share promises
    std::size_t total = 0;
    for (std::size_t i = 0; i < f.shards.size(); ++i) {
        const Shard& s = f.shards[i];
        std::string fault;
        const TableSpec* own = find_table(s.name);
        if (s.version != version())
            fault = fmt::format("was made by version {}, this is {}", s.version, version());
        else if (own != nullptr && s.kind == "table" && shard_of(*own, digits_of(s), s.share).spec != s.spec)
            fault = "is of another table of that name";
        else if (s.spec + fmt::format("/{}", s.share.count) != most->first)
            fault = fmt::format("is of another table or another number of shares ({}) than the others", s.share.count);
        else if (const auto [at, fresh] = seen.emplace(s.share.index, f.files[i]); !fresh)
            fault = fmt::format("is share {}, and so is {}", s.share.index, at->second);
        if (!fault.empty()) {
            f.faults.push_back(fmt::format("{} {}", f.files[i], fault));
            f.bad.insert(s.share.index);
            continue;
        }
        f.count = s.share.count;
        total = s.total;
        for (const auto& r : s.rows) {
            if (const auto [at, fresh] = row_from.emplace(r.number, i); !fresh) {
                f.faults.push_back(fmt::format("{} has row {}, and so has {}", f.files[i], r.number, f.files[at->second]));
                f.bad.insert(s.share.index);
                break;
            }
        }
    }
    if (f.faults.empty() && seen.size() == f.count && row_from.size() != total)
        f.faults.push_back(fmt::format("all shares are there, but not all rows: {} of {}", row_from.size(), total));
}

/// What is to be made again: "--array=3,7-9", or nothing.
std::string missing(const Found& f)
{
    std::set<std::size_t> there;
    for (const Shard& s : f.shards) there.insert(s.share.index);
    std::vector<std::size_t> wanted;
    for (std::size_t i = 1; i <= f.count; ++i)
        if (!there.contains(i) || f.bad.contains(i)) wanted.push_back(i);
    return wanted.empty() ? "" : "--array=" + array_text(wanted);
}

/// \returns the weakest status of its rows
std::string write_table(const Table& t, const fs::path& folder)
{
    const std::string text = format(t, "txt"), file = t.name + ".txt";
    // a seal says that a share is whole, not who made it: what is written is what a reader of tables takes
    if (t.status() != Status::undecided) parse_table(text, file);
    write_into_folder(folder, file, text);
    renew_manifest(folder, "txt",
                   {{{"name", t.name},
                     {"file", file},
                     {"quantity", t.quantity->name},
                     {"rows", t.rows.size()},
                     {"digits", t.digits},
                     {"status", std::string(to_string(t.status()))},
                     {"sha256", sha256(text)}}});
    fmt::print("{}: {} rows, {}\n", (folder / file).string(), t.rows.size(), to_string(t.status()));
    return std::string(to_string(t.status()));
}

/// That the rows, in their order, are the ones of which the shares say that they are shares, each dealt to the share that has it.
/// \throws CorruptTable
void put_rows_in_order(Found& f)
{
    const Shard& any = f.shards.front();
    const RowTableKind kind = kind_from(any.about);
    struct Place {
        const std::string* line;
        std::size_t share;
    };
    std::vector<Place> places(any.total);
    for (const Shard& s : f.shards)
        for (const auto& r : s.rows) places.at(r.number - 1) = {&r.line, s.share.index};
    RowsSpec spec(kind);
    Deal deal(*kind.quantity, any.share.count);
    for (const Place& p : places) {
        const WrittenRow row = read_row(kind, *p.line);
        spec.add(row.words);
        if (deal.next(row.inputs ? &*row.inputs : nullptr) != p.share)
            throw CorruptTable(fmt::format("row {} is in share {}, which is not the one that it is dealt to", f.rows.size() + 1, p.share));
        f.rows.emplace_back(p.line, row.status);
    }
    if (spec.text() != any.spec)
        throw CorruptTable("the inputs of its rows are not those of the table that they are shares of");
}

std::string write_rows(const Found& f, const fs::path& folder)
{
    const Shard& any = f.shards.front();
    const RowTableKind kind = kind_from(any.about);
    const fs::path path = folder / (any.name + ".txt");
    RowTable table(kind, path.string(), false);
    for (std::size_t i = 0; i < f.rows.size(); ++i) table.write(i + 1, *f.rows[i].first + "\n", f.rows[i].second);
    table.finish(true);
    const std::string weakest = table.counts().contains("refused")     ? "refused"
                                : table.counts().contains("undecided") ? "undecided"
                                : table.counts().contains("estimated") ? "estimated"
                                                                       : "certified";
    renew_manifest(folder, "txt",
                   {{{"name", any.name},
                     {"file", any.name + ".txt"},
                     {"quantity", kind.quantity->name},
                     {"rows", any.total},
                     {"digits", kind.digits},
                     {"status", weakest},
                     {"sha256", sha256(read_file(path))}}});
    fmt::print("{}: {} rows, {}\n", path.string(), any.total, weakest);
    return weakest;
}

int merge(const std::string& folder)
{
    auto all = find_shards(folder);
    std::vector<std::string> complaints, arrays;
    bool faulty = false;
    for (auto& [name, f] : all) {
        find_strangers(f);
        const std::string again = missing(f);
        if (f.faults.empty() && again.empty() && f.shards.front().kind == "rows") {
            try {
                put_rows_in_order(f);
            }
            catch (const CorruptTable& e) {
                f.faults.emplace_back(e.what());
            }
        }
        if (f.faults.empty() && again.empty()) continue;
        faulty = faulty || !f.faults.empty();
        const std::string lacking = again.empty() ? "" : fmt::format("{}to be made: {}", f.faults.empty() ? "" : "; ", again);
        complaints.push_back(fmt::format("{}: {}{}", name, fmt::join(f.faults, "; "), lacking));
        if (!again.empty()) arrays.push_back(again);
    }
    if (!complaints.empty()) {
        if (arrays.size() == 1 && all.size() == 1) fmt::print("{}\n", arrays.front()); // for sbatch $(touchstone merge DIR) job.sh
        flush_output();
        throw Failure(faulty ? bad_input : fails, fmt::format("{}", fmt::join(complaints, " | ")));
    }
    bool any_undecided = false;
    require_plain_inside(folder, manifest_name("txt"));
    for (const auto& [name, f] : all) {
        require_plain_inside(folder, name + ".txt");
        const std::string status =
            f.shards.front().kind == "table" ? write_table(table_of_shards(f.shards), folder) : write_rows(f, folder);
        any_undecided = any_undecided || status == "undecided";
    }
    return any_undecided ? undecided : holds;
}

} // namespace

void add_merge(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand(
        "merge", "Shares of tables to tables: touchstone merge DIR, after touchstone table NAME --shard 1/16 --out DIR and all the others");
    auto folder = std::make_shared<std::string>();
    command->add_option("folder", *folder, "Folder of the shards; the tables and their manifest are left there")
        ->required()
        ->check(not_empty());
    command->callback([&run, folder] { run = [folder] { return merge(*folder); }; });
}

} // namespace touchstone::program
