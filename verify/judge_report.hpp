// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What `touchstone judge` says: to a person in ten seconds, to a script, to a CI system, as a picture.
#pragma once

#include "touchstone/oracle/judge.hpp"
#include "touchstone/oracle/regime.hpp"
#include "touchstone/oracle/subject.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace touchstone::program {

/// Everything that is known about one judged code.
struct Case {
    std::string table;
    std::string subject;               ///< the command, library or file as typed
    const Quantity* quantity = nullptr;
    oracle::Bound bound;
    std::vector<oracle::Question> questions;
    oracle::Answers answers;
    oracle::Judgement judgement;       ///< empty if the protocol was broken
    std::vector<oracle::Regime> regimes;
    std::size_t left_out = 0;          ///< rows of a file that have no certified value
    std::string why_left_out;
    unsigned long seed = 0;            ///< which rows were held out
    std::size_t held_out = 0;
};

std::string as_text(const Case&);
nlohmann::ordered_json as_json(const Case&);
/// A test suite with one test case a row, as Jenkins and GitLab read it.
std::string as_junit(const Case&);
/// Error over what is allowed against each input, 1 - load and the distance from the edge of the contact; drawn by gnuplot.
std::string as_svg(const Case&);

} // namespace touchstone::program
