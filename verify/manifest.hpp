// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a folder of tables holds: manifest.txt.json and its like for other formats.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace touchstone::program {

/// The entries of a stored manifest, those of the tables just written replaced or added. \throws CorruptTable
nlohmann::ordered_json with_entries(const std::filesystem::path& manifest, const nlohmann::ordered_json& fresh);

/// The manifest of a folder with these entries; made if there is none. \throws CorruptTable, Failure
void renew_manifest(const std::filesystem::path& folder, const std::string& format, const nlohmann::ordered_json& fresh);

} // namespace touchstone::program
