// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/manifest.hpp"

#include "touchstone/table/format.hpp"
#include "touchstone/table/json_text.hpp"
#include "verify/files.hpp"

#include <algorithm>

namespace touchstone::program {

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

void renew_manifest(const std::filesystem::path& folder, const std::string& format, const nlohmann::ordered_json& fresh)
{
    const auto path = folder / ("manifest." + format + ".json");
    const auto entries = std::filesystem::exists(path) ? with_entries(path, fresh) : fresh;
    write_file(path, nlohmann::ordered_json{{"version", std::string(version())}, {"tables", entries}}.dump(1) + "\n");
}

} // namespace touchstone::program
