// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The exit codes of every subcommand, and the error that carries one.
#pragma once

#include <stdexcept>
#include <string>

namespace touchstone::program {

enum ExitCode : int {
    holds = 0,
    fails = 1,             ///< a refuted claim, a judged code over its bound, a changed table
    undecided = 2,
    usage_error = 64,
    bad_input = 65,        ///< out of domain or unreadable
    no_input_file = 66,
    protocol_error = 69,   ///< the judged program could not be run or broke the protocol
    internal_error = 70,
    cannot_write = 73,
};

/// Ends the program with that code; what() is the one line that stderr gets.
class Failure : public std::runtime_error {
public:
    Failure(ExitCode code, const std::string& line) : std::runtime_error(line), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

} // namespace touchstone::program
