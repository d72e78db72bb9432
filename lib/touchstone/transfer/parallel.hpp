// SPDX-License-Identifier: MIT
/// \file
/// A loop on all cores. Internal to transfer/.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace touchstone::transfer {

/// work(0) ... work(count - 1), in any order; work must not throw.
template <class Work>
void in_parallel(std::size_t count, const Work& work)
{
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t i; (i = next++) < count;) work(i);
    };
    std::vector<std::jthread> others;
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t k = 1; k < std::min(cores, count / 4); ++k) others.emplace_back(run);
    run();
}

} // namespace touchstone::transfer
