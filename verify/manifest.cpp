// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/manifest.hpp"

#include "touchstone/table/format.hpp"
#include "touchstone/table/json_text.hpp"
#include "verify/files.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

namespace touchstone::program {
namespace {

using Json = nlohmann::ordered_json;

/// The entries of a stored manifest; nothing: it is none.
std::optional<Json> entries_of(const std::filesystem::path& manifest)
{
    const std::string text = read_file(manifest);
    auto entries = Json::parse(shallow(text), nullptr, false);
    const auto names_a_file = [](const auto& e) { return e.is_object() && e.contains("file") && e.at("file").is_string(); };
    if (!entries.is_object() || !entries.contains("tables") || !entries["tables"].is_array() ||
        !std::all_of(entries["tables"].begin(), entries["tables"].end(), names_a_file))
        return std::nullopt;
    return Json(entries["tables"]);
}

template <class Entries>
auto entry_of(Entries& entries, const Json& file)
{
    return std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.at("file") == file; });
}

/// The entries, those of the tables just written replaced or added.
Json with_entries(Json entries, const Json& fresh)
{
    for (const auto& entry : fresh) {
        const auto same = entry_of(entries, entry.at("file"));
        if (same == entries.end())
            entries.push_back(entry);
        else
            *same = entry;
    }
    return entries;
}

/// Whether the file is there as the entry says.
bool is_true(const Json& entry, const std::filesystem::path& folder)
{
    const std::filesystem::path name = entry.at("file").get<std::string>();
    std::error_code error;
    return name == name.filename() && std::filesystem::is_regular_file(folder / name, error) && entry.contains("sha256") &&
           entry.at("sha256") == sha256(read_file(folder / name));
}

std::string text_of(const Json& entries) { return Json{{"version", std::string(version())}, {"tables", entries}}.dump(1) + "\n"; }

Json stored_entries(const std::filesystem::path& folder, const std::string& format)
{
    const auto path = folder / manifest_name(format);
    return std::filesystem::exists(path) ? entries_of(path).value_or(Json::array()) : Json::array();
}

/// The first, then those of the others that are of other files and true.
Json with_others(Json entries, const Json& fresh, const Json& stored, const std::filesystem::path& folder)
{
    for (const auto& e : stored)
        if (entry_of(fresh, e.at("file")) == fresh.end() && is_true(e, folder)) entries.push_back(e);
    return entries;
}

} // namespace

std::string manifest_name(const std::string& format) { return "manifest." + format + ".json"; }

std::string manifest_of_all(const std::filesystem::path& folder, const std::string& format, const Json& fresh)
{
    return text_of(with_others(fresh, fresh, stored_entries(folder, format), folder));
}

void write_manifest_of_all(const std::filesystem::path& folder, const std::string& format, const Json& fresh)
{
    const FolderLock alone(folder);
    const Json stored = stored_entries(folder, format);
    auto entries = Json::array();
    for (const auto& ours : fresh) {
        const auto theirs = entry_of(stored, ours.at("file"));
        if (is_true(ours, folder)) entries.push_back(ours);
        else if (theirs != stored.end() && is_true(*theirs, folder)) entries.push_back(*theirs);
        // else another has written the file, and is about to say so
    }
    write_into_folder(folder, manifest_name(format), text_of(with_others(std::move(entries), fresh, stored, folder)));
}

void renew_manifest(const std::filesystem::path& folder, const std::string& format, const Json& fresh)
{
    const FolderLock alone(folder);
    auto ours = Json::array();
    std::copy_if(fresh.begin(), fresh.end(), std::back_inserter(ours), [&](const auto& e) { return is_true(e, folder); });
    const auto path = folder / manifest_name(format);
    auto entries = std::filesystem::exists(path) ? entries_of(path) : Json::array();
    if (!entries) throw CorruptTable(path.string() + ": not a manifest; remove it or write all tables");
    write_into_folder(folder, manifest_name(format), text_of(with_entries(std::move(*entries), ours)));
}

} // namespace touchstone::program
