// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A program of the system that draws or typesets for us.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchstone::figures {

struct ToolAnswer {
    bool succeeded = false;
    std::string output;   ///< what it wrote to its standard output
    std::string complaint;///< what it wrote to its standard error
};

/// Runs a program without a shell, `input` on its standard input. \returns nothing if there is no such program
std::optional<ToolAnswer> run_tool(const std::vector<std::string>& command, const std::string& input);

} // namespace touchstone::figures
