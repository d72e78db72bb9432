// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The paper's equations typeset: from TeX to MathML, by blahtexml.
#pragma once

#include <string>

namespace touchstone::program::report {

/// `<math>` of a formula; its TeX as code where blahtexml is missing or refuses it, so that nothing is lost.
std::string formula(const std::string& tex, bool display);

/// Prose with formulas between dollar signs, **bold** and *italics*.
std::string prose(const std::string& text);

/// What HTML gives a meaning of its own, replaced.
std::string escaped(const std::string& text);

} // namespace touchstone::program::report
