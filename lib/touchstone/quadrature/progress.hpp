// SPDX-License-Identifier: MIT
/// \file
/// A sum of many values says how far it is.
#pragma once

#include <functional>

namespace touchstone::quadrature {

/// Called now and then with how many values of the formula a sum of `total` has, from the thread that integrates. Set it before any does.
using Progress = std::function<void(long done, long total)>;
void report_progress_to(Progress);

/// Counts the values of one sum.
class ValueCount {
public:
    explicit ValueCount(long total)
        : total_(total)
    {
    }
    void one_more();

private:
    long done_ = 0, total_;
};

} // namespace touchstone::quadrature
