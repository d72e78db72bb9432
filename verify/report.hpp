// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// `touchstone report` and `touchstone paper figureN`.
#pragma once

#include <string>

namespace touchstone::program {

/// Writes one figure alone; empty names are left out. \returns an exit code
int write_figure(const std::string& id, const std::string& svg, const std::string& pdf, const std::string& csv);

} // namespace touchstone::program
