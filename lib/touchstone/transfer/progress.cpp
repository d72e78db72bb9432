// SPDX-License-Identifier: MIT
#include "touchstone/transfer/progress.hpp"

#include <mutex>

namespace touchstone::transfer {
namespace {
std::mutex progress_mutex;
Progress hook;
} // namespace

void report_progress_to(Progress to)
{
    const std::scoped_lock lock(progress_mutex);
    hook = std::move(to);
}

void progress(std::string_view what, long done, long total)
{
    const std::scoped_lock lock(progress_mutex);
    if (hook) hook(what, done, total);
}

} // namespace touchstone::transfer
