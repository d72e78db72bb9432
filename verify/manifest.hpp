// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a folder of tables holds: manifest.txt.json and its like for other formats.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace touchstone::program {

/// "manifest.txt.json" for format "txt"
std::string manifest_name(const std::string& format);

/// The manifest of a folder in which all tables stand: these entries, then those of other tables that are there as their entries say. An
/// old one that cannot be read has none. \throws Failure
std::string manifest_of_all(const std::filesystem::path& folder, const std::string& format, const nlohmann::ordered_json& fresh);

/// Written so. Writers wait for one another, and an entry whose file another writer has replaced since is left to that one. \throws Failure
void write_manifest_of_all(const std::filesystem::path& folder, const std::string& format, const nlohmann::ordered_json& fresh);

/// The manifest of a folder with these entries; made if there is none. Writers wait for one another, and an entry whose file another writer
/// has replaced since is left to that one. \throws CorruptTable, Failure
void renew_manifest(const std::filesystem::path& folder, const std::string& format, const nlohmann::ordered_json& fresh);

} // namespace touchstone::program
