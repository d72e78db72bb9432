// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How far long work is, said on stderr: a bar on a terminal, a line a minute in a log with --progress, else nothing.
///
/// The share shown is of what is counted (rows, entries, panels of a proof) and never goes back. What cannot be counted beforehand
/// is not guessed at: then the time spent so far stands where the share would.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchstone::program {

/// --progress was given: say something this often, in seconds, even where stderr is no terminal.
void progress_in_logs(double seconds = 60);

/// Work of a known number of parts, 0: not known. One made while another is under way is the part of that one that next() announced.
/// Its end clears the line.
class Progress {
public:
    Progress(std::string what, std::size_t total);
    /// Work whose only parts are the steps of the recursion's engines, if it has any.
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// `done` of `total` parts are done; a smaller number than before changes nothing.
    void done(std::size_t parts);
    /// What comes next is so many parts of this, and is called so.
    void next(std::size_t parts, std::string step = {});
    /// The line goes, to come again: something else is to be printed.
    static void clear();

private:
    std::size_t depth_;
};

/// What the engines of the recursion say of their own steps: shown after the share of the work they are part of, or alone.
void show_steps_of_engines();

/// The line as it is shown: "table 42 %, about 3 min left (210 of 500)". A total of 0 is not known: "rows 210, 34 s so far".
/// \param share from 0 to 1
std::string progress_line(std::string_view what, std::size_t done, std::size_t total, double share, double seconds);

} // namespace touchstone::program
