// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Files read and written whole.
#pragma once

#include <filesystem>
#include <string>

namespace touchstone::program {

/// The old file or the new one, never half: a temporary file in the same folder, then a rename.
/// \throws Failure (cannot_write)
void write_file(const std::filesystem::path&, const std::string& bytes);

/// \throws Failure (no_input_file)
std::string read_file(const std::filesystem::path&);

} // namespace touchstone::program
