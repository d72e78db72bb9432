// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/shards.hpp"

#include "touchstone/table/format.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"
#include "verify/progress.hpp"
#include "verify/row_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;

/// Of a row as it stands in a share: {"status":"certified", ...} or certified: why.
bool has_status(const std::string& line, std::string_view status)
{
    const auto mark = line.find(" # ");
    if (mark == std::string::npos) return false;
    const std::string_view rest = std::string_view(line).substr(mark + 3);
    return rest.starts_with(status) || rest.starts_with(fmt::format("{{\"status\":\"{}\"", status));
}

} // namespace

std::string shard_path(const std::string& out, const Shard& s)
{
    if (out.empty() || out.ends_with(".txt")) return out;
    std::error_code error;
    fs::create_directories(out, error);
    if (!error && ::access(out.c_str(), W_OK) != 0) error = std::error_code(errno, std::generic_category());
    if (error) throw Failure(cannot_write, fmt::format("cannot write into {}: {}", out, error.message()));
    return (fs::path(out) / s.file_name()).string();
}

std::optional<int> code_if_there(const std::string& path, const Shard& wanted)
{
    std::error_code error;
    if (path.empty() || !fs::is_regular_file(path, error)) return std::nullopt;
    try {
        const Shard there = parse_shard(read_file(path), path);
        if (!there.same_as(wanted)) return std::nullopt;
        if (there.kind == "rows") check_rows(there);
        fmt::print("{}: share {} of {} is there already\n", path, wanted.share.index, wanted.share.count);
        const auto any = [&](std::string_view status) {
            return std::any_of(there.rows.begin(), there.rows.end(), [&](const auto& r) { return has_status(r.line, status); });
        };
        return any("refused") ? bad_input : any("undecided") ? undecided : holds; // a job that is started again does not change its mind
    }
    catch (const CorruptTable&) {
        return std::nullopt; // made anew
    }
}

void put_shard(const std::string& path, const Shard& s)
{
    const std::string text = format_shard(s);
    if (path.empty())
        fmt::print("{}", text);
    else if (fs::path(path).filename() == s.file_name()) // our name in a folder
        write_into_folder(fs::path(path).parent_path(), s.file_name(), text);
    else
        write_file(path, text);
}

int table_share(const TableSpec& spec, long digits, unsigned jobs, Share share, const std::string& out)
{
    Shard s = shard_of(spec, digits, share);
    const std::string path = shard_path(out, s);
    if (const auto code = code_if_there(path, s)) return *code;
    const auto numbers = rows_of_share(spec, share);
    TableSpec part = spec;
    part.grid = [&spec, &numbers] {
        const auto whole = spec.grid();
        std::vector<std::vector<double>> mine;
        for (const std::size_t n : numbers) mine.push_back(whole[n - 1]);
        return mine;
    };
    Progress progress(fmt::format("{}, share {} of {}", spec.name, share.index, share.count), numbers.size());
    const Table t = compute(part, digits, jobs, [&](std::size_t done, std::size_t) { progress.done(done); });
    s.rows = shard_rows(t, numbers);
    put_shard(path, s);
    Progress::clear();
    if (!path.empty()) fmt::print("{}: {} of {} rows\n", path, s.rows.size(), s.total);
    return t.status() == Status::undecided ? undecided : holds;
}

void RowsSpec::add(const std::vector<std::string>& words)
{
    constexpr std::size_t block_bytes = 1U << 16;
    block_ += fmt::format("{}\n", fmt::join(words, " "));
    if (block_.size() <= block_bytes) return;
    chain_ = sha256(chain_ + block_);
    block_.clear();
}

std::string RowsSpec::text() const { return sha256(chain_ + block_); }

void check_rows(const Shard& s)
{
    const RowTableKind kind = kind_from(s.about);
    for (const auto& r : s.rows) {
        try {
            read_row(kind, r.line);
        }
        catch (const CorruptTable& e) {
            throw CorruptTable(fmt::format("row {} {}", r.number, e.what()));
        }
    }
}

RowsShare rows_share(OwnRows& rows, const RowTableKind& kind, Share share, const std::string& file)
{
    std::string stem = file.empty() ? "ranges" : fs::path(file).stem().string();
    std::string name = kind.quantity->name + "-" + stem;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '_';
    RowsShare r;
    Deal deal(*kind.quantity, share.count);
    RowsSpec spec(kind);
    OwnRow row;
    while (rows.next(row)) {
        spec.add(row.words);
        r.mine.push_back(deal.next(row.inputs ? &*row.inputs : nullptr) == share.index);
    }
    r.shard = {name, "rows", spec.text(), std::string(version()), share, r.mine.size(), kind_text(kind), {}};
    return r;
}

void ShardSink::add(std::size_t number, const std::string& line) { shard_.rows.push_back({number, line.substr(0, line.size() - 1)}); }

void ShardSink::finish(bool complete)
{
    if (!complete) return;
    put_shard(path_, shard_);
    if (!path_.empty()) fmt::print("{}: {} of {} rows\n", path_, shard_.rows.size(), shard_.total);
}

} // namespace touchstone::program
