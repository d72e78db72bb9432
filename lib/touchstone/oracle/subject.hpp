// SPDX-License-Identifier: MIT
/// \file
/// The code under test, asked row by row, whatever language it is written in and however it misbehaves.
///
/// A subject gets one line of blanks-separated C99 hexadecimal numbers for each row and answers one
/// number a line. It runs in a process group of its own, with three pipes and no other file of the judge's open: a crash, a hang, a flood
/// of output or of memory ends it and whatever it has started, is reported as what it is, and never reaches the judge.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::oracle {
/// How a subject broke the protocol.
enum class FaultKind {
    not_started,   ///< no such program, library or symbol
    killed,        ///< ended by a signal of its own making
    exit_status,   ///< ended with a status other than 0
    hang,          ///< silent, or slow in all, beyond the limits
    too_few,       ///< ended with rows unanswered
    too_many,      ///< more answers than rows
    garbage,       ///< a line that is not one number
    endless_line,  ///< no line end, or no answer, within what a number can need
    closed_input,  ///< stopped reading before all rows were sent
    memory,        ///< took more memory than the limit
};
std::string_view to_string(FaultKind); ///< in words
/// The first breach of the protocol, after which nothing is read.
struct Fault {
    FaultKind kind; ///< what kind of breach
    std::string detail;         ///< one line: what happened, after which answer
    std::size_t answered = 0;   ///< rows answered before
};

/// Start-up is slow in some languages and output may be held back until the end of the input,
/// hence three limits and not one a row: for the first answer, for silence after it, and in all.
struct Limits {
    std::chrono::milliseconds start{60'000}; ///< to the first answer
    std::chrono::milliseconds silence{10'000}; ///< between two answers
    std::chrono::milliseconds total{600'000}; ///< to the last answer
    std::size_t memory = std::size_t{8} << 30; ///< bytes resident in all its processes together
};
/// What a subject answered, in the order of the rows.
struct Answers {
    std::vector<double> values;   ///< as many as rows, unless there is a fault
    std::optional<Fault> fault; ///< nothing if all went well
    std::string chatter;          ///< the end of what it wrote to stderr
};
/// The inputs of each row, in the order of the quantity.
using InputRows = std::vector<std::vector<double>>;

/// Run a program without a shell; command[0] is looked up in PATH.
Answers ask_command(const std::vector<std::string>& command, const InputRows&, const Limits& = {});

/// Call `double symbol(double, ...)` of a shared library in a child process.
Answers ask_library(const std::string& library, const std::string& symbol, const InputRows&, const Limits& = {});

/// Answers given as text, one number a line; blank lines and lines starting with # or % are passed
/// over (Octave's save writes such). Reading ends at the first fault, and at `most_unused` bytes without an answer among them.
/// \throws std::system_error if the stream cannot be read
Answers read_answers(std::istream&, std::size_t rows);
inline constexpr std::size_t most_unused = std::size_t{1} << 20; ///< bytes

/// One number as C, Fortran, Python or Octave print it: decimal (D or E exponent), C99 hexadecimal, inf, nan.
std::optional<double> parse_answer(std::string_view line);

} // namespace touchstone::oracle
