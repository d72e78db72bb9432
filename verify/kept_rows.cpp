// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/kept_rows.hpp"

#include "touchstone/table/format.hpp"
#include "touchstone/table/json_text.hpp"
#include "verify/exit_codes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* made_anew = "without --resume the table is made anew";

/// Of the rows behind the first page, with the hash that it gives if the table was finished or broken off.
void require_hash(const std::string& path, std::streamoff rows, const Json& head)
{
    if (!head.contains("sha256")) return;
    std::ifstream file(path, std::ios::binary);
    file.seekg(rows);
    RowsHash hash;
    for (std::string block(std::size_t{1} << 16, '\0'); file;) {
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        hash.add(std::string_view(block).substr(0, static_cast<std::size_t>(file.gcount())));
    }
    if (head.at("sha256") != hash.text())
        throw Failure(bad_input, fmt::format("{}: its rows do not have the SHA-256 that it gives; {}", path, made_anew));
}

} // namespace

std::string table_to_resume(const std::string& out)
{
    std::string longest;
    std::uintmax_t most = 0;
    for (const char* end : {"", ".part", ".part2"}) {
        std::error_code error;
        const std::string path = out + end;
        const auto size = fs::is_regular_file(path, error) ? fs::file_size(path, error) : 0;
        if (!error && size > most) {
            most = size;
            longest = path;
        }
    }
    return longest;
}

KeptRows::KeptRows(std::string path, const RowTableKind& kind)
    : path_(std::move(path))
    , kind_(kind)
    , file_(std::make_unique<std::ifstream>(path_, std::ios::binary))
{
    Json head;
    while (file_->peek() == '#' && read_line())
        if (text_.starts_with("# {")) head = Json::parse(shallow(std::string_view(text_).substr(2)), nullptr, false);
    if (!same_kind(head, kind_))
        throw Failure(usage_error, fmt::format("{} is not a table of {} with these columns, digits and rounding: nothing to resume", path_,
                                               kind_.quantity->name));
    if (!head.contains("version") || head.at("version") != version())
        throw Failure(usage_error, fmt::format("{} was not made by version {}, this one: nothing to resume", path_, version()));
    require_hash(path_, file_->tellg(), head);
}

/// False at the end, and where a line has no end: the run was killed in it.
bool KeptRows::read_line()
{
    ++line_;
    return std::getline(*file_, text_) && !file_->eof();
}

std::optional<KeptRows::Row> KeptRows::next()
{
    while (read_line()) {
        Row kept{text_ + "\n", fmt::format("{}:{}", path_, line_), {}};
        try {
            kept.row = read_row(kind_, text_);
        }
        catch (const CorruptTable& e) {
            throw Failure(bad_input, fmt::format("{}: the row {}; {}", kept.place, e.what(), made_anew));
        }
        if (kept.row.status != "refused") return kept; // else it is cheap, and perhaps no longer refused
    }
    return std::nullopt;
}

void require_rows_of(KeptRows kept, OwnRows& asked)
{
    OwnRow row;
    for (auto next = kept.next(); next; next = kept.next()) {
        bool found = false;
        while (!found && asked.next(row)) found = row.words == next->row.words;
        if (!found)
            throw Failure(bad_input,
                          fmt::format("{}: its inputs are not among the rows asked for, in their order; {}", next->place, made_anew));
    }
}

} // namespace touchstone::program
