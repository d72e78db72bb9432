// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/manifest.hpp"

#include "touchstone/table/format.hpp"
#include "touchstone/table/json_text.hpp"
#include "verify/files.hpp"

#include <algorithm>
#include <iterator>

namespace touchstone::program {
namespace {

/// The entries of a stored manifest, those of the tables just written replaced or added.
nlohmann::ordered_json with_entries(const std::filesystem::path& manifest, const nlohmann::ordered_json& fresh)
{
    const std::string text = read_file(manifest);
    auto entries = nlohmann::ordered_json::parse(shallow(text), nullptr, false);
    const auto names_a_file = [](const auto& e) { return e.is_object() && e.contains("file"); };
    if (!entries.is_object() || !entries.contains("tables") || !entries["tables"].is_array() ||
        !std::all_of(entries["tables"].begin(), entries["tables"].end(), names_a_file))
        throw CorruptTable(manifest.string() + ": not a manifest; remove it or write all tables");
    entries = nlohmann::ordered_json(entries["tables"]);
    for (const auto& entry : fresh) {
        const auto same = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.at("file") == entry.at("file"); });
        if (same == entries.end())
            entries.push_back(entry);
        else
            *same = entry;
    }
    return entries;
}

} // namespace

std::string manifest_name(const std::string& format) { return "manifest." + format + ".json"; }

std::string manifest_text(const nlohmann::ordered_json& entries)
{
    return nlohmann::ordered_json{{"version", std::string(version())}, {"tables", entries}}.dump(1) + "\n";
}

void renew_manifest(const std::filesystem::path& folder, const std::string& format, const nlohmann::ordered_json& fresh)
{
    const FolderLock alone(folder);
    auto ours = nlohmann::ordered_json::array();
    std::copy_if(fresh.begin(), fresh.end(), std::back_inserter(ours),
                 [&](const auto& e) { return sha256(read_file(folder / e.at("file").template get<std::string>())) == e.at("sha256"); });
    const auto path = folder / manifest_name(format);
    write_into_folder(folder, manifest_name(format), manifest_text(std::filesystem::exists(path) ? with_entries(path, ours) : ours));
}

} // namespace touchstone::program
