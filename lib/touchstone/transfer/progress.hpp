// SPDX-License-Identifier: MIT
/// \file
/// What takes minutes says how far it is.
#pragma once

#include <functional>
#include <string_view>

namespace touchstone::transfer {

/// Called with what is being computed and how far it is, when set; from one thread at a time. done == total ends it.
using Progress = std::function<void(std::string_view what, long done, long total)>;
void report_progress_to(Progress);

/// For the computations of transfer/ themselves.
void progress(std::string_view what, long done, long total);

} // namespace touchstone::transfer
