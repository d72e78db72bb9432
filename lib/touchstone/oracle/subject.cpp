// SPDX-License-Identifier: MIT
#include "touchstone/oracle/subject.hpp"

#include "touchstone/oracle/supervisor.hpp"
#include "touchstone/rounding/decimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <istream>
#include <poll.h>
#include <spawn.h>
#include <system_error>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace touchstone::oracle {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_line = 4096;   ///< no number needs more
constexpr int first_of_others = 3; ///< of the descriptors: a subject has none from here on that whoever started the judge left open
constexpr std::size_t kept_chatter = 2000;
constexpr std::size_t most_in_pipe = std::size_t{1} << 20; ///< bytes, as Linux has it
constexpr std::chrono::milliseconds weighing{200}; ///< between two looks at the memory of a subject

constexpr std::array judges_signals{SIGPIPE, SIGINT, SIGTERM, SIGHUP}; ///< which it handles and its subject does not inherit

volatile std::sig_atomic_t interrupted = 0;
void on_interrupt(int signal) { interrupted = signal; }

/// While a subject runs, writing to one that went away is an error code and not our death, and an
/// interrupted judge takes its subject along.
class Signals {
public:
    Signals()
    {
        interrupted = 0;
        for (std::size_t i = 0; i < judges_signals.size(); ++i) {
            struct sigaction action{};
            action.sa_handler = judges_signals[i] == SIGPIPE ? SIG_IGN : on_interrupt;
            ::sigaction(judges_signals[i], &action, &before_[i]);
        }
    }
    ~Signals()
    {
        for (std::size_t i = 0; i < judges_signals.size(); ++i) ::sigaction(judges_signals[i], &before_[i], nullptr);
        if (interrupted != 0) ::raise(interrupted);
    }
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;

private:
    std::array<struct sigaction, judges_signals.size()> before_{};
};

std::string quoted(std::string_view text)
{
    std::string shown;
    for (const char c : text.substr(0, 40)) {
        const auto u = static_cast<unsigned char>(c);
        shown += u >= 0x20 && u < 0x7f ? std::string(1, c) : fmt::format("\\x{:02x}", u);
    }
    return "'" + shown + (text.size() > 40 ? "'..." : "'");
}

std::string_view trimmed(std::string_view s)
{
    constexpr std::string_view blanks = " \t\r";
    const auto first = s.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view{} : s.substr(first, s.find_last_not_of(blanks) - first + 1);
}

double gib(std::size_t bytes) { return static_cast<double>(bytes) / static_cast<double>(std::size_t{1} << 30); }
double seconds(std::chrono::milliseconds t) { return static_cast<double>(t.count()) / 1000; }

/// Collects answers line by line out of pieces of output.
class Collector {
public:
    Collector(Answers& answers, std::size_t rows) : answers_(answers), rows_(rows) {}
    /// false once the subject has broken the protocol
    bool take(std::string_view bytes)
    {
        pending_ += bytes;
        std::size_t from = 0;
        for (std::size_t end; (end = pending_.find('\n', from)) != std::string::npos; from = end + 1)
            if (!line(std::string_view(pending_).substr(from, end - from))) return false;
        pending_.erase(0, from);
        if (pending_.size() > longest_line)
            return fault(FaultKind::endless_line, fmt::format("wrote {} bytes without a line end", pending_.size()));
        return true;
    }
    bool finish() { return pending_.empty() || line(pending_); }

private:
    bool line(std::string_view text)
    {
        text = trimmed(text);
        if (text.empty()) return true;
        const auto value = parse_answer(text);
        if (!value) return fault(FaultKind::garbage, fmt::format("answered {}, which is not one number,", quoted(text)));
        if (answers_.values.size() == rows_)
            return fault(FaultKind::too_many, fmt::format("wrote more answers than the {} rows asked,", rows_));
        answers_.values.push_back(*value);
        return true;
    }
    bool fault(FaultKind kind, const std::string& what)
    {
        answers_.fault = Fault{kind, fmt::format("{} after {} of {} rows", what, answers_.values.size(), rows_), answers_.values.size()};
        return false;
    }
    Answers& answers_;
    std::size_t rows_;
    std::string pending_;
};

/// Talks to a running code until it has ended or broken a limit.
class Conversation {
public:
    Conversation(Supervised& code, Descriptor to, Descriptor from, Descriptor chatter, const std::string& questions, std::size_t rows,
                 const Limits& limits)
        : code_(code)
        , to_(std::move(to))
        , from_(std::move(from))
        , chatter_(std::move(chatter))
        , questions_(questions)
        , rows_(rows)
        , limits_(limits)
        , collector_(answers_, rows)
    {
        for (const Descriptor* d : {&to_, &from_, &chatter_})
            if (d->open()) ::fcntl(d->get(), F_SETFL, O_NONBLOCK);
        if (questions_.empty()) to_.close();
    }

    Answers all()
    {
        while (on() && from_.open() && !over()) exchange();
        if (on()) collector_.finish();
        // a fault found here stands; else how it ended may be one
        active_ = Clock::now();
        spoke_ = true;
        while (on() && code_.watched() && !code_.ended()) {
            weigh();
            const auto wait = left();
            pollfd end{code_.word(), POLLIN, 0};
            if (on()) ::poll(&end, 1, static_cast<int>(std::min<long>(wait, weighing.count())));
        }
        hear_chatter(); // its last words
        if (on()) judge_the_end();
        if (!code_.end() && on()) fault(FaultKind::hang, "left processes that could not be ended");
        return std::move(answers_);
    }

private:
    bool on() const { return !answers_.fault && interrupted == 0; }

    /// It has ended, and what it has left behind has no say any more, though that may hold its output open: what is in the pipe is all.
    /// Only where rows are unanswered and it has not failed may those whom it has left behind be the ones that answer.
    bool over()
    {
        if (!code_.ended() || (answers_.values.size() < rows_ && code_.status() == 0)) return false;
        code_.end();
        for (std::size_t read = 0; read < most_in_pipe && on() && from_.open() && hear();) read += buffer_.size();
        return true;
    }

    void fault(FaultKind kind, const std::string& what)
    {
        answers_.fault = Fault{kind, fmt::format("{} after {} of {} rows", what, answers_.values.size(), rows_), answers_.values.size()};
    }

    /// Milliseconds until the first limit that would be broken; sets the fault if one is.
    long left()
    {
        const auto now = Clock::now();
        const auto whole = start_ + limits_.total - now;
        const auto quiet = (spoke_ ? active_ + limits_.silence : start_ + limits_.start) - now;
        if (whole.count() <= 0)
            fault(FaultKind::hang, fmt::format("was not done within {:g} s (the limit in all)", seconds(limits_.total)));
        else if (quiet.count() <= 0 && spoke_) fault(FaultKind::hang, fmt::format("was silent for {:g} s", seconds(limits_.silence)));
        else if (quiet.count() <= 0)
            fault(FaultKind::hang, fmt::format("gave no answer within {:g} s of its start", seconds(limits_.start)));
        return std::chrono::ceil<std::chrono::milliseconds>(std::min(whole, quiet)).count();
    }

    /// Now and then, since it reads of every process.
    void weigh()
    {
        if (Clock::now() - weighed_ < weighing) return;
        if (const std::size_t bytes = code_.resident(); bytes > limits_.memory)
            fault(FaultKind::memory, fmt::format("held {:.1f} GiB of memory (the limit is {:g})", gib(bytes), gib(limits_.memory)));
        weighed_ = Clock::now();
    }

    void exchange()
    {
        const auto wait = left();
        if (on()) weigh();
        if (!on()) return;
        std::array<pollfd, 4> fds{pollfd{from_.get(), POLLIN, 0}, pollfd{chatter_.get(), POLLIN, 0}, pollfd{to_.get(), POLLOUT, 0},
                                  pollfd{code_.word(), POLLIN, 0}};
        if (::poll(fds.data(), fds.size(), static_cast<int>(std::min<long>(wait, weighing.count()))) <= 0) return;
        if (fds[2].revents != 0) send();
        if (fds[1].revents != 0) hear_chatter();
        if (fds[0].revents != 0) hear();
        if (fds[3].revents != 0) code_.ended();
    }

    void send()
    {
        const ssize_t n = ::write(to_.get(), questions_.data() + sent_, questions_.size() - sent_);
        if (n > 0) {
            sent_ += static_cast<std::size_t>(n);
            active_ = Clock::now();
        }
        else if (n < 0 && errno != EAGAIN && errno != EINTR) stopped_reading_ = true;
        if (stopped_reading_ || sent_ == questions_.size()) to_.close();
    }

    /// Whether there was something to hear.
    bool hear()
    {
        const ssize_t n = ::read(from_.get(), buffer_.data(), buffer_.size());
        if (n > 0) {
            spoke_ = true;
            active_ = Clock::now();
            collector_.take({buffer_.data(), static_cast<std::size_t>(n)});
        }
        else if (n == 0 || (errno != EAGAIN && errno != EINTR)) from_.close();
        return n > 0;
    }

    void hear_chatter()
    {
        if (!chatter_.open()) return;
        const ssize_t n = ::read(chatter_.get(), buffer_.data(), buffer_.size());
        if (n > 0) {
            answers_.chatter.append(buffer_.data(), static_cast<std::size_t>(n));
            if (answers_.chatter.size() > kept_chatter) answers_.chatter.erase(0, answers_.chatter.size() - kept_chatter);
        }
        else if (n == 0 || (errno != EAGAIN && errno != EINTR)) chatter_.close();
    }

    void judge_the_end()
    {
        const int status = code_.status();
        if (!code_.ended()) fault(FaultKind::killed, "ended the process that watches over it");
        else if (WIFSIGNALED(status))
            fault(FaultKind::killed, fmt::format("was killed by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status))));
        else if (WEXITSTATUS(status) != 0) fault(FaultKind::exit_status, fmt::format("ended with exit status {}", WEXITSTATUS(status)));
        else if (stopped_reading_)
            fault(FaultKind::closed_input,
                  fmt::format("closed its input when {} of {} bytes had been sent, and ended", sent_, questions_.size()));
        else if (answers_.values.size() < rows_) fault(FaultKind::too_few, "ended");
    }

    Supervised& code_;
    Descriptor to_, from_, chatter_;
    const std::string& questions_;
    std::size_t rows_, sent_ = 0;
    const Limits& limits_;
    Answers answers_;
    Collector collector_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point active_ = start_, weighed_ = start_ - weighing;
    bool spoke_ = false, stopped_reading_ = false;
    std::array<char, 65536> buffer_{};
};

std::string question(const std::vector<double>& row)
{
    std::string line;
    for (const double x : row) {
        if (!line.empty()) line += ' ';
        line += hexfloat(x);
    }
    return line + "\n";
}

Answers not_started(std::string detail)
{
    Answers a;
    a.fault = Fault{FaultKind::not_started, std::move(detail), 0};
    return a;
}

template <std::size_t... I>
double call(void* symbol, const std::vector<double>& x, std::index_sequence<I...>)
{
    return reinterpret_cast<double (*)(decltype(static_cast<double>(I))...)>(symbol)(x[I]...);
}

double call(void* symbol, const std::vector<double>& x)
{
    switch (x.size()) {
    case 0: return call(symbol, x, std::make_index_sequence<0>{});
    case 1: return call(symbol, x, std::make_index_sequence<1>{});
    case 2: return call(symbol, x, std::make_index_sequence<2>{});
    case 3: return call(symbol, x, std::make_index_sequence<3>{});
    case 4: return call(symbol, x, std::make_index_sequence<4>{});
    default: return call(symbol, x, std::make_index_sequence<5>{});
    }
}

void say(int fd, std::string_view text)
{
    while (!text.empty()) {
        const ssize_t n = ::write(fd, text.data(), text.size());
        if (n < 0 && errno != EINTR) ::_exit(0);
        if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
    }
}

/// In the child: load, call, answer. A failure to load is the answer '!', with the reason on stderr.
[[noreturn]] void serve_library(const std::string& library, const std::string& symbol, const InputRows& rows, int out, int err)
{
    ::setpgid(0, 0);
    for (const int s : judges_signals) ::signal(s, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr); // its supervisor has them all blocked
    const int nothing = ::open("/dev/null", O_RDONLY), answers = first_of_others;
    ::dup2(nothing, 0);
    ::dup2(err, 1); // what the library prints is chatter, not an answer
    ::dup2(err, 2);
    ::dup2(out, answers);
    ::close_range(first_of_others + 1, ~0U, 0);
    void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* function = handle != nullptr ? ::dlsym(handle, symbol.c_str()) : nullptr;
    if (function == nullptr) {
        say(2, ::dlerror());
        say(answers, "!\n");
        ::_exit(0);
    }
    for (const auto& row : rows) say(answers, hexfloat(call(function, row)) + "\n"); // at once: a crash is then at the right row
    ::_exit(0);
}

/// All that starting a program takes, got ready beforehand: where it is started no memory may be asked for.
class Spawn {
public:
    Spawn(const std::vector<std::string>& command, int in, int out, int err)
    {
        posix_spawn_file_actions_init(&files_);
        posix_spawn_file_actions_adddup2(&files_, in, 0);
        posix_spawn_file_actions_adddup2(&files_, out, 1);
        posix_spawn_file_actions_adddup2(&files_, err, 2);
        posix_spawn_file_actions_addclosefrom_np(&files_, first_of_others);
        posix_spawnattr_init(&attributes_);
        sigset_t defaults, none;
        sigemptyset(&none);
        sigemptyset(&defaults);
        for (const int s : judges_signals) sigaddset(&defaults, s);
        posix_spawnattr_setsigdefault(&attributes_, &defaults);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setpgroup(&attributes_, 0);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
        for (const auto& word : command) argv_.push_back(const_cast<char*>(word.c_str()));
        argv_.push_back(nullptr);
    }
    Spawn(const Spawn&) = delete;
    Spawn& operator=(const Spawn&) = delete;
    ~Spawn()
    {
        posix_spawnattr_destroy(&attributes_);
        posix_spawn_file_actions_destroy(&files_);
    }
    /// \returns the number of its process, or an error, negative
    pid_t start() const
    {
        pid_t pid = 0;
        const int error = ::posix_spawnp(&pid, argv_[0], &files_, &attributes_, argv_.data(), environ);
        return error != 0 ? -error : pid;
    }

private:
    posix_spawn_file_actions_t files_{};
    posix_spawnattr_t attributes_{};
    std::vector<char*> argv_;
};

} // namespace

std::string_view to_string(FaultKind kind)
{
    switch (kind) {
    case FaultKind::not_started: return "not_started";
    case FaultKind::killed: return "killed";
    case FaultKind::exit_status: return "exit_status";
    case FaultKind::hang: return "hang";
    case FaultKind::too_few: return "too_few";
    case FaultKind::too_many: return "too_many";
    case FaultKind::garbage: return "garbage";
    case FaultKind::endless_line: return "endless_line";
    case FaultKind::memory: return "memory";
    case FaultKind::closed_input: break;
    }
    return "closed_input";
}

std::optional<double> parse_answer(std::string_view line)
{
    std::string text(trimmed(line));
    if (text.empty() || text.find_first_of(" \t") != std::string::npos || text.size() > longest_line) return std::nullopt;
    if (text.find_first_of("xXnN") == std::string::npos) // Fortran's 0.1D-3
        std::replace_if(text.begin(), text.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return end == text.c_str() + text.size() ? std::optional(value) : std::nullopt;
}

Answers ask_command(const std::vector<std::string>& command, const InputRows& rows, const Limits& limits)
{
    std::string questions;
    for (const auto& row : rows) questions += question(row);
    const Signals signals;
    Pipe in, out, err;
    const Spawn spawn(command, in.read.get(), out.write.get(), err.write.get());
    Supervised code([&] { return spawn.start(); });
    if (code.error() != 0) return not_started(fmt::format("could not be run: {}", std::strerror(code.error())));
    in.read.close();
    out.write.close();
    err.write.close();
    return Conversation(code, std::move(in.write), std::move(out.read), std::move(err.read), questions, rows.size(), limits).all();
}

Answers ask_library(const std::string& library, const std::string& symbol, const InputRows& rows, const Limits& limits)
{
    // with a slash in it dlopen takes the file meant, not one of that name elsewhere
    const std::string path = std::filesystem::absolute(library).string();
    const Signals signals;
    Pipe out, err;
    Supervised code([&] {
        const pid_t pid = ::fork();
        if (pid < 0) return -errno;
        if (pid == 0) serve_library(path, symbol, rows, out.write.get(), err.write.get());
        ::setpgid(pid, pid);
        return pid;
    });
    if (code.error() != 0) return not_started(fmt::format("could not be run: {}", std::strerror(code.error())));
    out.write.close();
    err.write.close();
    Answers answers = Conversation(code, Descriptor(), std::move(out.read), std::move(err.read), "", rows.size(), limits).all();
    if (answers.fault && answers.fault->kind == FaultKind::garbage && answers.fault->answered == 0) {
        answers.fault->kind = FaultKind::not_started;
        answers.fault->detail = fmt::format("cannot be loaded: {}", std::exchange(answers.chatter, {}));
    }
    return answers;
}

Answers read_answers(std::istream& in, std::size_t rows)
{
    Answers answers;
    Collector collector(answers, rows);
    std::string line;
    std::size_t unused = 0;
    const auto fault = [&](const std::string& what) {
        answers.fault =
            Fault{FaultKind::endless_line, fmt::format("{} after {} of {} rows", what, answers.values.size(), rows), answers.values.size()};
    };
    for (bool more = true; more && !answers.fault;) {
        errno = 0;
        const int c = in.rdbuf()->sbumpc(); // throws if a file cannot be read
        more = c != std::char_traits<char>::eof();
        if (!more && (errno == EIO || errno == EISDIR)) throw std::system_error(errno, std::generic_category());
        if (more && c != '\n') {
            line += static_cast<char>(c);
            if (line.size() > longest_line) fault(fmt::format("has {} bytes without a line end", line.size()));
            continue;
        }
        const std::string_view text = trimmed(line);
        const bool comment = text.empty() || text.front() == '#' || text.front() == '%';
        unused = comment ? unused + line.size() + 1 : 0;
        if (!comment) collector.take(std::string(text) + "\n");
        else if (unused > most_unused) fault(fmt::format("has {} bytes without an answer", unused));
        line.clear();
    }
    if (!answers.fault && answers.values.size() < rows)
        answers.fault = Fault{FaultKind::too_few, fmt::format("holds {} answers where {} rows were asked", answers.values.size(), rows),
                              answers.values.size()};
    return answers;
}

} // namespace touchstone::oracle
