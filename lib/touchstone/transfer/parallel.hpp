// SPDX-License-Identifier: MIT
/// \file
/// A loop on all cores. Internal to transfer/.
#pragma once

#include "touchstone/scalar/thread_caches.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace touchstone::transfer {

/// work(0) ... work(count - 1), in any order. What one of them throws ends the loop early and reaches the caller.
template <class Work>
void in_parallel(std::size_t count, const Work& work)
{
    std::atomic<std::size_t> next{0};
    std::exception_ptr thrown;
    std::mutex throwing;
    const auto run = [&] {
        try {
            for (std::size_t i; (i = next++) < count;) work(i);
        }
        catch (...) {
            const std::lock_guard lock(throwing);
            if (!thrown) thrown = std::current_exception();
            next = count; // nobody begins another
        }
    };
    {
        std::vector<std::jthread> others;
        const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
        for (std::size_t k = 1; k < std::min(cores, count / 4); ++k)
            others.emplace_back([&] {
                release_caches_with_thread();
                run();
            });
        run();
    }
    if (thrown) std::rethrow_exception(thrown);
}

} // namespace touchstone::transfer
