// SPDX-License-Identifier: MIT
/// \file
/// Ranges of inputs as they are typed: many exact numbers in one word.
#pragma once

#include "touchstone/scalar/rational.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone {

/// The values of one input:
///
///     0.01:0.99:0.01    first:last:step, exact; last is there if a whole number of steps leads to it; step may be negative
///     log:1e-9:1:50     50 values from 1e-9 to 1 with equal ratios. The ends are exact; each between is the shortest decimal of the
///                       binary64 number nearest to its place, and that decimal is then the exact input
///     0.1,1/3,sqrt(2)   these
///     1/3               this one
///
/// Values are made when asked for: a range of a million takes no memory.
class Range {
public:
    /// \throws DomainError, one line, for a range that has no end, no values or more than `most`
    explicit Range(std::string_view text);
    std::size_t size() const { return size_; }
    std::string at(std::size_t i) const;

    static constexpr std::size_t most = 100'000'000;

private:
    void read_steps(std::string_view text);
    void read_ratios(std::string_view text);

    std::size_t size_ = 0;
    std::vector<std::string> words_;             ///< a list
    std::optional<Rational> step_;               ///< first:last:step
    Rational first_, last_;
};

/// The exact number in its shortest form: a decimal if it has one of reasonable length, else p/q.
std::string exact_text(const Rational&);

} // namespace touchstone
