// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Enclosures that take seconds to minutes, taken from data/paper/values.txt: one row each, named as `touchstone eval` would be asked, with
/// the hash of the rows in the header. `touchstone paper --recompute` computes them instead and compares, `--values` prints the table anew.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchstone::proofs {

/// From now on values are computed, not looked up; or looked up again, and what was computed is forgotten.
void recompute_values(bool on = true);

/// The enclosure of that name: the stored one, or the computed one under `recompute_values`.
/// \throws std::runtime_error if the table's hash is wrong; std::out_of_range if no row has the name.
Ball stored_value(const std::string& name, const std::function<Ball()>& compute);

/// What has been asked for since the last call: the rows a verdict rests on.
std::vector<std::string> values_used();

/// What is wrong with a stored value that was computed anew; empty if nothing is.
std::string difference(const Ball& stored, const Ball& computed);

/// After everything was judged under `recompute_values`: rows that are stored otherwise, not at all, or for nothing. One line each.
std::vector<std::string> values_that_differ();

/// The table of all values computed so far.
std::string computed_table();

/// The enclosures of a table as computed_table() writes it, by name. \throws std::runtime_error if its hash is not that of its rows, or a
/// row is no enclosure.
std::vector<std::pair<std::string, Ball>> read_values(std::string_view table);

} // namespace touchstone::proofs
