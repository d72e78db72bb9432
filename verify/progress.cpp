// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/progress.hpp"

#include "touchstone/transfer/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <mutex>

namespace touchstone::program {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double quiet = 2;       ///< seconds before anything is shown: short work stays silent
constexpr double redraw = 0.2;    ///< seconds between two pictures of the bar
constexpr double log_every = 60;  ///< seconds between two lines in a log
constexpr int bar_width = 24;

/// Everything that is under way. One thread writes at a time.
struct Display {
    std::mutex mutex;
    bool terminal = ::isatty(STDERR_FILENO) != 0;
    bool logs = false;
    bool drawn = false;
    std::string what, step;
    std::size_t parts = 0, total = 0;   ///< total 0: no counted work
    long step_done = 0, step_total = 0; ///< of an engine
    Clock::time_point start, step_start, last_shown, begun = Clock::now();

    bool speaks() const { return terminal || logs; }
};

Display& display()
{
    static Display d;
    return d;
}

double since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

std::string left(double seconds)
{
    if (seconds < 90) return fmt::format("about {:.0f} s left", std::max(1.0, seconds));
    if (seconds < 90 * 60) return fmt::format("about {:.0f} min left", seconds / 60);
    return fmt::format("about {:.1f} h left", seconds / 3600);
}

std::string bar(double share)
{
    const int full = static_cast<int>(share * bar_width);
    return "[" + std::string(static_cast<std::size_t>(full), '#') + std::string(static_cast<std::size_t>(bar_width - full), '.') + "] ";
}

/// Called with the lock held.
void show(Display& d)
{
    if (!d.speaks() || since(d.begun) < quiet || since(d.last_shown) < (d.terminal ? redraw : log_every)) return;
    const bool counted = d.total > 0;
    const double share = counted ? static_cast<double>(d.parts) / static_cast<double>(d.total)
                                 : static_cast<double>(d.step_done) / static_cast<double>(std::max(1L, d.step_total));
    std::string line = counted ? progress_line(d.what, d.parts, d.total, since(d.start))
                               : progress_line(d.step, static_cast<std::size_t>(d.step_done), static_cast<std::size_t>(d.step_total), since(d.step_start));
    if (counted && d.step_total > 0) line += fmt::format("; {} {} of {}", d.step, d.step_done, d.step_total);
    if (d.terminal) fmt::print(stderr, "\r\033[K{}{}", bar(std::min(1.0, share)), line.substr(0, 90));
    else fmt::print(stderr, "touchstone: {}\n", line);
    std::fflush(stderr);
    d.drawn = true;
    d.last_shown = Clock::now();
}

void clear(Display& d)
{
    if (d.terminal && d.drawn) fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
    d.drawn = false;
}

} // namespace

void progress_in_logs(bool on) { display().logs = on; }

Progress::Progress(std::string what, std::size_t total)
{
    Display& d = display();
    const std::scoped_lock lock(d.mutex);
    d.what = std::move(what);
    d.parts = 0;
    d.total = std::max<std::size_t>(1, total);
    d.start = d.begun = d.last_shown = Clock::now();
    d.step_total = 0;
}

Progress::~Progress()
{
    Display& d = display();
    const std::scoped_lock lock(d.mutex);
    d.total = 0;
    d.step_total = 0;
    clear(d);
}

void Progress::done(std::size_t parts)
{
    Display& d = display();
    const std::scoped_lock lock(d.mutex);
    d.parts = std::max(d.parts, std::min(parts, d.total));
    d.step_total = 0; // the engine's step was part of what is done now
    show(d);
}

void show_steps_of_engines()
{
    if (!display().speaks()) return;
    transfer::report_progress_to([](std::string_view what, long done, long total) {
        Display& d = display();
        const std::scoped_lock lock(d.mutex);
        const bool new_step = d.step != what || done < d.step_done || d.step_total == 0;
        if (new_step) d.step_start = Clock::now();
        d.step = what;
        d.step_done = done;
        d.step_total = total;
        if (d.total == 0 && done == total) {
            clear(d);
            return;
        }
        show(d);
    });
}

std::string progress_line(std::string_view what, std::size_t done, std::size_t total, double seconds)
{
    const double share = static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(1, total));
    std::string line = fmt::format("{} {:.0f} % ({} of {})", what, std::min(100.0, 100 * share), done, total);
    // a guess needs something to stand on: a few parts, or a few seconds
    if (done > 0 && done < total && seconds > 1) line += ", " + left(seconds * (1 - share) / share);
    return line;
}

} // namespace touchstone::program
