// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/progress.hpp"

#include "verify/files.hpp"

#include "touchstone/quadrature/progress.hpp"
#include "touchstone/transfer/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace touchstone::program {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::string_view integration = "integrate";
constexpr double quiet = 2;      ///< seconds before anything is shown: short work stays silent
constexpr double redraw = 0.25;  ///< seconds between two pictures of the bar
constexpr std::size_t bar_width = 24;
constexpr std::size_t narrowest = 40, widest = 120; ///< columns of a terminal that are made use of

/// Work under way: `parts` of `total`, and the next `next` of them are what is being done.
struct Work {
    std::string what, step;
    std::size_t parts = 0, total = 0, next = 0;
    bool by_steps = false; ///< its share is that of the engine's steps
};

/// The steps of an engine: the greatest share seen of each kind. Proof and witness run side by side, so that they come mixed.
struct Steps {
    std::map<std::string, double, std::less<>> shares;
    std::string last;
    long done = 0, total = 0;

    void see(std::string_view what, long step, long of)
    {
        // levels of a mesh are followed by panels of a proof, beside which a witness looks
        if (what.starts_with("mesh"))
            for (const char* follows : {"proof, panel", "estimate, scale"}) shares.try_emplace(follows, 0);
        last = what;
        done = step;
        total = of;
        auto& share = shares[last];
        share = std::max(share, of > 0 ? std::min(1.0, static_cast<double>(step) / static_cast<double>(of)) : 0);
    }
    double share() const
    {
        double sum = 0;
        for (const auto& [name, s] : shares) sum += s;
        return shares.empty() ? 0 : sum / static_cast<double>(shares.size());
    }
};

/// Everything that is under way. One thread writes at a time.
class Display {
public:
    std::mutex mutex;
    std::vector<Work> work; ///< the outermost first
    Steps steps;
    double log_every = 0; ///< seconds; 0: no lines in logs

    bool speaks() const { return terminal_ || log_every > 0; }

    /// Lock held. Something began: the first thing starts the clock.
    void begin()
    {
        if (begun_) return;
        begun_ = true;
        start_ = last_ = Clock::now();
        shown_ = 0;
        if (speaks() && !ticker_.joinable()) ticker_ = std::jthread([this](const std::stop_token& stop) { tick(stop); });
    }
    /// Lock held. Nothing is under way any more.
    void end()
    {
        clear();
        begun_ = false;
        steps = {};
    }
    void clear()
    {
        if (drawn_) remark("\r\033[K");
        std::fflush(stderr);
        drawn_ = false;
    }
    void show()
    {
        const double often = log_every > 0 ? log_every : quiet;
        if (!begun_ || !speaks() || since(start_) < std::min(quiet, often) ||
            since(last_) < (terminal_ ? std::min(redraw, often) : log_every))
            return;
        last_ = Clock::now();
        const double share = shown_ = std::max(shown_, share_now());
        const std::string text = line(share);
        if (!terminal_) remark("touchstone: " + text + "\n");
        else remark("\r\033[K" + (bar(share) + text).substr(0, columns() - 1));
        drawn_ = terminal_;
        std::fflush(stderr);
    }

private:
    bool by_steps() const { return work.empty() || work.front().by_steps; }
    static double since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

    double share_now() const
    {
        if (by_steps()) return steps.share();
        double inside = 0; // of the parts that are being done
        for (auto w = work.rbegin(); w != work.rend(); ++w) {
            if (w->total == 0) continue;
            const std::size_t next = std::min(w->next, w->total - w->parts);
            inside = (static_cast<double>(w->parts) + static_cast<double>(next) * inside) / static_cast<double>(w->total);
        }
        return inside;
    }
    std::string line(double share) const
    {
        const double seconds = since(start_);
        if (by_steps() && steps.total > 0)
            return progress_line(steps.last, static_cast<std::size_t>(steps.done), static_cast<std::size_t>(steps.total), share, seconds);
        if (work.empty()) return "";
        const Work& outer = work.front();
        std::string text = progress_line(outer.what, outer.parts, outer.total, share, seconds);
        for (auto w = work.begin() + 1; w != work.end(); ++w)
            text += fmt::format("; {} {}{}", w->what, w->parts, w->total > 0 ? fmt::format(" of {}", w->total) : "");
        if (const std::string& step = work.back().step; !step.empty()) text += "; " + step;
        if (steps.total > 0) text += fmt::format("; {} {} of {}", steps.last, steps.done, steps.total);
        return text;
    }
    std::string bar(double share) const
    {
        if (by_steps() ? steps.total == 0 : work.front().total == 0) return "";
        const auto full = static_cast<std::size_t>(share * static_cast<double>(bar_width));
        return fmt::format("[{:#<{}}{:.<{}}] ", "", full, "", bar_width - full);
    }
    static std::size_t columns()
    {
        winsize size{};
        if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
        return std::clamp<std::size_t>(size.ws_col, narrowest, widest);
    }
    /// Time passes while nothing is reported, too.
    void tick(const std::stop_token& stop)
    {
        std::mutex own;
        std::unique_lock waiting(own);
        std::condition_variable_any never;
        while (!stop.stop_requested()) {
            never.wait_for(waiting, stop, std::chrono::duration<double>(log_every > 0 ? std::min(redraw, log_every) : redraw),
                           [] { return false; });
            const std::scoped_lock lock(mutex);
            show();
        }
    }

    const bool terminal_ = ::isatty(STDERR_FILENO) != 0;
    bool begun_ = false, drawn_ = false;
    double shown_ = 0; ///< the greatest share that was said
    Clock::time_point start_, last_;
    std::jthread ticker_; ///< last: it ends before what it reads
};

Display& display()
{
    static Display d;
    return d;
}

std::string duration(double seconds)
{
    if (seconds < 90) return fmt::format("{:.0f} s", std::max(1.0, seconds));
    if (seconds < 90 * 60) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

} // namespace

void progress_in_logs(double seconds) { display().log_every = seconds; }

Progress::Progress(std::string what) : Progress(std::move(what), 0)
{
    Display& d = display();
    const std::scoped_lock lock(d.mutex);
    d.work[depth_ - 1].by_steps = true;
}

Progress::Progress(std::string what, std::size_t total)
{
    Display& d = display();
    const std::scoped_lock lock(d.mutex);
    d.work.push_back({std::move(what), "", 0, total, 0, false});
    depth_ = d.work.size();
    d.begin();
}

Progress::~Progress()
{
    Display& d = display();
    const std::scoped_lock lock(d.mutex);
    d.work.resize(depth_ - 1);
    d.steps = {};
    if (!d.work.empty()) { // what this was a part of is so much further
        Work& w = d.work.back();
        w.parts = std::min(w.total, w.parts + w.next);
        w.next = 0;
    }
    else d.end();
}

void Progress::done(std::size_t parts)
{
    Display& d = display();
    const std::scoped_lock lock(d.mutex);
    Work& w = d.work[depth_ - 1];
    if (w.total > 0) parts = std::min(parts, w.total);
    w.parts = std::max(w.parts, parts);
    w.next = 0;
    d.steps = {}; // the engine's step was part of what is done now
    d.show();
}

void Progress::next(std::size_t parts, std::string step)
{
    Display& d = display();
    const std::scoped_lock lock(d.mutex);
    Work& w = d.work[depth_ - 1];
    w.next = parts;
    w.step = std::move(step);
}

void Progress::clear()
{
    Display& d = display();
    const std::scoped_lock lock(d.mutex);
    d.clear();
}

void show_steps_of_engines()
{
    if (!display().speaks()) return;
    transfer::report_progress_to([](std::string_view what, long done, long total) {
        Display& d = display();
        const std::scoped_lock lock(d.mutex);
        d.steps.see(what, done, total);
        d.show();
    });
    quadrature::report_progress_to([](long done, long total) {
        Display& d = display();
        const std::scoped_lock lock(d.mutex);
        if (d.work.empty() || !d.work.front().by_steps || d.work.front().what != integration)
            return; // integrals are but parts of other work
        d.steps.see("values", done, total);
        d.show();
    });
}

std::string progress_line(std::string_view what, std::size_t done, std::size_t total, double share, double seconds)
{
    if (total == 0) return fmt::format("{}{}, {} so far", what, done > 0 ? fmt::format(" {}", done) : "", duration(seconds));
    // a guess needs something to stand on: a few parts, or a few seconds
    constexpr double least_share = 0.005;
    const bool guess = share >= least_share && share < 1 && seconds > 1;
    const std::string time = guess ? fmt::format("about {} left", duration(seconds * (1 - share) / share)) : duration(seconds) + " so far";
    // the count last: it is what a narrow terminal cuts off
    return fmt::format("{} {:.0f} %, {} ({} of {})", what, std::floor(100 * std::clamp(share, 0.0, 1.0)), time, done, total);
}

} // namespace touchstone::program
