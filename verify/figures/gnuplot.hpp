// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Figures drawn by gnuplot. The SVG follows the reader's light or dark mode and asks nothing of the network.
#pragma once

#include "verify/figures/figure.hpp"

#include <string>

namespace touchstone::figures {

enum class Layout {
    wide,  ///< panels side by side, for a page or a screen
    narrow ///< panels below one another, for a phone
};

/// \throws Failure where gnuplot is missing or refuses
std::string svg(const Figure&, Layout);
std::string pdf(const Figure&);

/// What gnuplot is told, without terminal and output: for a reader who wants to change it.
std::string script(const Figure&, Layout);

} // namespace touchstone::figures
