// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How far long work is, said on stderr: a bar on a terminal, a line a minute in a log with --progress, else nothing.
///
/// The share shown is of what is counted (rows, entries, panels of a proof) and never goes back; what is not counted
/// yet is not guessed at: a computation whose number of steps is unknown shows them one after another, each with its own share.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchstone::program {

/// --progress was given: say something once a minute even where stderr is no terminal.
void progress_in_logs(bool);

/// Work of a known number of parts. The last to be made is the one shown; its end clears the line.
class Progress {
public:
    Progress(std::string what, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// `done` of `total` parts are done; a smaller number than before changes nothing.
    void done(std::size_t parts);
};

/// What the engines of the recursion say of their own steps: shown after the share of the work they are part of, or alone.
void show_steps_of_engines();

/// The line as it is shown, for tests: "table 42 % (210 of 500), about 3 min left".
std::string progress_line(std::string_view what, std::size_t done, std::size_t total, double seconds);

} // namespace touchstone::program
