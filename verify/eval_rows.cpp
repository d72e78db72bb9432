// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone eval QUANTITY --rows FILE`, or with ranges: a table of one's own rows, in their order.
///
/// Rows are read a window at a time, so that a million of them take no memory; in a window they are computed in the order in which most is
/// shared (touchstone/table/working_order.hpp), on several threads, and written as soon as all rows before them are.
/// An interrupt writes what is done, leaving out what is not, and ends the program at once: a row may take minutes.
#include "touchstone/scalar/thread_caches.hpp"
#include "touchstone/table/rows.hpp"
#include "touchstone/table/working_order.hpp"
#include "verify/eval.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"
#include "verify/kept_rows.hpp"
#include "verify/own_rows.hpp"
#include "verify/progress.hpp"
#include "verify/row_table.hpp"
#include "verify/shards.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace touchstone::program {
namespace {

constexpr std::size_t window_rows = 4096;
constexpr auto look_around = std::chrono::milliseconds(50); ///< for an interrupt, and to flush what is written

std::atomic<int> interrupted{0};
extern "C" void note_interrupt(int signal) { interrupted = signal; }

/// While rows are computed, an interrupt is noted and not obeyed.
class Interrupts {
public:
    Interrupts()
    {
        struct sigaction action {};
        action.sa_handler = note_interrupt; // no SA_RESTART: reading from a terminal or a pipe returns
        for (std::size_t k = 0; k < 2; ++k) ::sigaction(signals[k], &action, &before_[k]);
    }
    ~Interrupts()
    {
        for (std::size_t k = 0; k < 2; ++k) ::sigaction(signals[k], &before_[k], nullptr);
    }
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

private:
    static constexpr int signals[2] = {SIGINT, SIGTERM};
    struct sigaction before_[2] {};
};

/// The rows of one window, and what they came to.
struct Window {
    std::vector<OwnRow> rows;
    std::vector<std::optional<RowSink::Kept>> kept;
    std::vector<RowOutcome> outcomes;
    std::vector<char> done;
    std::vector<std::size_t> order;
    std::size_t next = 0; ///< place in order
    std::exception_ptr failure;
    std::mutex mutex;
    std::condition_variable changed;
};

struct Job {
    const Quantity& quantity;
    EvaluationOptions options;
    Rounding rounding;
    unsigned threads;
};

/// What one thread does, until no row of the window is left. It owns its share of the window: the program may end before it does.
void work(const std::shared_ptr<Window>& w, const Job& job)
{
    release_caches_with_thread();
    std::unique_lock lock(w->mutex);
    while (w->next < w->order.size() && !w->failure) {
        const std::size_t i = w->order[w->next++];
        lock.unlock();
        RowOutcome outcome;
        std::exception_ptr failure;
        try {
            outcome.result = evaluate(job.quantity, *w->rows[i].inputs, job.options, job.rounding);
        }
        catch (const DomainError& e) {
            outcome.refusal = fmt::format("{}: {}", w->rows[i].place, e.what());
        }
        catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) w->failure = failure;
        else {
            w->outcomes[i] = std::move(outcome);
            w->done[i] = 1;
        }
        w->changed.notify_all();
    }
}

/// The threads of a window. However it is left, by a disk that is full too, they take no more rows and are waited for.
class Workers {
public:
    Workers(std::shared_ptr<Window> w, const Job& job)
        : window_(std::move(w))
    {
        const std::size_t wanted = std::min<std::size_t>(job.threads, window_->order.size());
        for (std::size_t k = 0; k < wanted; ++k) threads_.emplace_back([w = window_, job] { work(w, job); });
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers() { stop(); } // then the threads are joined
    void stop()
    {
        const std::lock_guard lock(window_->mutex);
        window_->next = window_->order.size();
    }
    void join()
    {
        for (auto& t : threads_) t.join();
    }
    void detach()
    {
        for (auto& t : threads_) t.detach();
    }

private:
    std::shared_ptr<Window> window_;
    std::vector<std::jthread> threads_;
};

class RowsRun {
public:
    /// \param share nullptr: all rows
    RowsRun(const EvalOptions& o, const RowTableKind& kind, OwnRows& rows, const RowsShare* share)
        : o_(o)
        , job_{*kind.quantity, {.digits = o.digits, .start_bits = o.start_precision, .limit_bits = o.max_precision}, kind.rounding, o.jobs}
        , rows_(rows)
        , kind_(kind)
        , share_(share)
    {
        if (share_ != nullptr) table_ = std::make_unique<ShardSink>(share_->shard, shard_path(o.out, share_->shard));
        else table_ = std::make_unique<RowTable>(kind_, o.out, o.resume);
        // rows that come up on the terminal are their own progress
        if (!o.out.empty() || ::isatty(STDOUT_FILENO) == 0)
            progress_.emplace("rows", share_ == nullptr
                                          ? rows.count()
                                          : static_cast<std::size_t>(std::count(share_->mine.begin(), share_->mine.end(), true)));
    }

    int all()
    {
        while (!ended_) one_window();
        if (interrupted != 0) {
            finish_early();
            std::fflush(nullptr);
            std::_Exit(128 + interrupted); // threads may be in rows that take minutes
        }
        table_->finish(trouble_.empty());
        if (!trouble_.empty()) throw Failure(bad_input, trouble_);
        if (refused_ > 0)
            throw Failure(bad_input,
                          refused_ == 1 ? first_refusal_ : fmt::format("{} ({} rows have no value in all)", first_refusal_, refused_));
        return table_->counts().contains("undecided") ? undecided : holds;
    }

private:
    /// Reads as many rows as a window holds; what cannot be read ends the run after the rows before it.
    std::shared_ptr<Window> read()
    {
        auto w = std::make_shared<Window>();
        while (w->rows.size() < window_rows && interrupted == 0) {
            OwnRow row;
            try {
                if (!rows_.next(row)) {
                    ended_ = true;
                    break;
                }
            }
            catch (const BadRows& e) {
                if (interrupted == 0) trouble_ = e.what(); // else only the interrupted read complains
                ended_ = true;
                break;
            }
            if (share_ != nullptr && !share_->mine.at(row.number - 1)) continue;
            w->kept.push_back(row.refusal.empty() ? table_->kept(row.words) : std::nullopt);
            w->rows.push_back(std::move(row));
        }
        const std::size_t n = w->rows.size();
        w->outcomes.resize(n);
        w->done.assign(n, 0);
        std::vector<const Inputs*> wanted(n, nullptr);
        for (std::size_t i = 0; i < n; ++i) {
            if (w->rows[i].inputs && !w->kept[i]) wanted[i] = &*w->rows[i].inputs;
            else w->done[i] = 1;
            w->outcomes[i].refusal = w->rows[i].refusal;
        }
        w->order = working_order(job_.quantity, wanted);
        return w;
    }

    void one_window()
    {
        const auto w = read();
        Workers workers(w, job_);
        std::size_t written = 0;
        {
            std::unique_lock lock(w->mutex);
            for (bool idle = true; written < w->rows.size() && interrupted == 0 && !w->failure;) {
                if (w->done[written] == 0) {
                    if (idle) table_->flush();
                    idle = w->changed.wait_for(lock, look_around) == std::cv_status::timeout;
                    continue;
                }
                lock.unlock();
                put(*w, written++);
                if (progress_) progress_->done(table_->rows());
                lock.lock();
            }
            if (interrupted != 0 || w->failure) {
                for (; written < w->rows.size(); ++written)
                    if (w->done[written] != 0) put(*w, written);
                ended_ = true;
            }
        }
        workers.stop();
        if (interrupted != 0) return workers.detach();
        workers.join();
        if (w->failure) {
            table_->finish(false);
            std::rethrow_exception(w->failure);
        }
    }

    void put(const Window& w, std::size_t i)
    {
        if (w.kept[i]) {
            table_->write(w.rows[i].number, w.kept[i]->line, w.kept[i]->status);
            return;
        }
        const RowOutcome& outcome = w.outcomes[i];
        if (!outcome.refusal.empty() && refused_++ == 0) first_refusal_ = outcome.refusal;
        table_->write(w.rows[i].number, row_line(kind_, w.rows[i].number, w.rows[i].words, outcome),
                     outcome.refusal.empty() ? std::string(to_string(outcome.result.status)) : "refused");
    }

    void finish_early()
    {
        table_->finish(false);
        progress_.reset();
        remark(fmt::format("touchstone: interrupted; {} rows are done{}\n", table_->rows(),
                   share_ != nullptr ? ", and nothing is kept of a share broken off"
                   : o_.out.empty()  ? ""
                                     : fmt::format(" and in {}: the same command with --resume goes on", o_.out)));
    }

    const Interrupts guard_; ///< before the table's file exists
    const EvalOptions& o_;
    Job job_;
    OwnRows& rows_;
    RowTableKind kind_;
    const RowsShare* share_;
    std::unique_ptr<RowSink> table_;
    std::optional<Progress> progress_;
    bool ended_ = false;
    std::string trouble_, first_refusal_;
    std::size_t refused_ = 0;
};

} // namespace

int evaluate_rows(const EvalOptions& o, const Quantity& q, const NamedTexts& named)
{
    if (o.explain) throw Failure(usage_error, "--explain is for one value");
    if (o.resume && (o.out.empty() || o.json))
        throw Failure(usage_error, "--resume needs --out FILE, the table to go on with, and no --json");
    if (o.digits < 1 || o.digits > 10'000) throw Failure(bad_input, fmt::format("digits = {}: must be from 1 to 10000", o.digits));
    if (!o.shard.empty() && o.rows == "-")
        throw Failure(usage_error, "--shard reads the rows twice, to know whose they are: give a file, not standard input");
    if (!o.shard.empty() && (o.resume || o.json))
        throw Failure(usage_error, "--shard makes a share for touchstone merge, whole or not at all: no --resume, no --json");
    const auto rows_anew = [&] {
        return o.rows.empty() ? rows_of_ranges(q, named, {.binary64 = o.binary64})
                              : rows_of_file(q, o.rows, named, {.binary64 = o.binary64});
    };
    const auto rows = rows_anew();
    const RowTableKind kind{&q, rows->columns(), o.digits, *rounding_named(o.round), o.binary64, o.json};
    // rows of standard input come once: of those, what is kept is found by its inputs as they come
    if (const std::string before = o.resume && o.rows != "-" ? table_to_resume(o.out) : ""; !before.empty())
        require_rows_of(KeptRows(before, kind), *rows_anew());
    if (o.shard.empty()) return RowsRun(o, kind, *rows, nullptr).all();
    const RowsShare share = rows_share(*rows, kind, share_named(o.shard), o.rows);
    if (const std::string path = shard_path(o.out, share.shard); const auto code = code_if_there(path, share.shard)) return *code;
    return RowsRun(o, kind, *rows_anew(), &share).all();
}

} // namespace touchstone::program
