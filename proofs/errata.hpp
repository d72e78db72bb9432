// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The erratum: for each equation that is refuted as printed and whose corrected form is proved, what is printed and what should be. Both
/// are the transcription and its proved edits set in the journal's notation; no formula is typed here.
#pragma once

#include <string>
#include <string_view>

namespace touchstone::proofs {

/// "md", "tex" or "html". \throws std::invalid_argument for another.
std::string errata(std::string_view format);

} // namespace touchstone::proofs
