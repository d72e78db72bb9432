// SPDX-License-Identifier: MIT
#include "touchstone/oracle/subject.hpp"

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
#include <fstream>
#include <istream>
#include <iterator>
#include <sstream>
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
constexpr std::chrono::milliseconds weighing{200}; ///< between two looks at the memory of a subject

class Descriptor {
public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    Descriptor(Descriptor&& o) noexcept : fd_(std::exchange(o.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& o) noexcept { std::swap(fd_, o.fd_); return *this; }
    ~Descriptor() { close(); }
    int get() const { return fd_; }
    bool open() const { return fd_ >= 0; }
    void close()
    {
        if (fd_ >= 0) ::close(fd_);
        fd_ = -1;
    }

private:
    int fd_;
};

struct Pipe {
    Descriptor read, write;
    Pipe()
    {
        int fd[2];
        if (::pipe2(fd, O_CLOEXEC) != 0) throw std::runtime_error(fmt::format("no pipe to the judged program: {}", std::strerror(errno)));
        read = Descriptor(fd[0]);
        write = Descriptor(fd[1]);
    }
};

volatile std::sig_atomic_t interrupted = 0;
void on_interrupt(int signal) { interrupted = signal; }

/// While a subject runs, writing to one that went away is an error code and not our death, and an
/// interrupted judge takes its subject along.
class Signals {
public:
    Signals()
    {
        interrupted = 0;
        set(0, SIGPIPE, SIG_IGN);
        set(1, SIGINT, on_interrupt);
        set(2, SIGTERM, on_interrupt);
        set(3, SIGHUP, on_interrupt);
    }
    ~Signals()
    {
        for (std::size_t i = 0; i < which_.size(); ++i) ::sigaction(which_[i], &before_[i], nullptr);
        if (interrupted != 0) ::raise(interrupted);
    }
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;

private:
    void set(std::size_t i, int signal, void (*handler)(int))
    {
        struct sigaction action{};
        action.sa_handler = handler;
        which_[i] = signal;
        ::sigaction(signal, &action, &before_[i]);
    }
    std::array<int, 4> which_{};
    std::array<struct sigaction, 4> before_{};
};

/// The child and whatever it started; gone, and its status collected, when this is.
class Process {
public:
    explicit Process(pid_t pid) : pid_(pid) {}
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() { end(); }
    bool ended()
    {
        if (!ended_) ended_ = ::waitpid(pid_, &status_, WNOHANG) == pid_;
        return ended_;
    }
    int status() const { return status_; }
    void end()
    {
        ::kill(-pid_, SIGKILL);
        if (ended_) return;
        ::kill(pid_, SIGKILL); // in case it has left its group
        while (::waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {}
        ended_ = true;
    }

private:
    pid_t pid_;
    int status_ = 0;
    bool ended_ = false;
};

/// Bytes of memory that the processes of a group hold. What they have merely reserved is not counted, since some languages' run-time
/// systems and the sanitizers reserve more than any machine has; so that no limit of the kernel's serves.
std::size_t resident(pid_t group)
{
    static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    std::size_t pages = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator process("/proc", error), end; !error && process != end; process.increment(error)) {
        const std::string name = process->path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        std::ifstream in(process->path() / "stat");
        std::string line;
        std::getline(in, line);
        const auto behind_name = line.rfind(')'); // which may hold blanks and brackets
        if (behind_name == std::string::npos) continue;
        std::istringstream words(line.substr(behind_name + 1));
        std::vector<std::string> word((std::istream_iterator<std::string>(words)), std::istream_iterator<std::string>());
        constexpr std::size_t of_group = 2, of_pages = 21; // the fields 5 and 24 of proc(5)
        if (word.size() > of_pages && word[of_group] == std::to_string(group)) pages += std::strtoul(word[of_pages].c_str(), nullptr, 10);
    }
    return pages * page;
}

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

/// Talks to a running child until it has ended or broken a limit.
Answers converse(pid_t pid, Descriptor to, Descriptor from, Descriptor chatter, const std::string& questions, std::size_t rows,
                 const Limits& limits)
{
    Process process(pid);
    Answers answers;
    Collector collector(answers, rows);
    for (const Descriptor* d : {&to, &from, &chatter})
        if (d->open()) ::fcntl(d->get(), F_SETFL, O_NONBLOCK);
    const auto start = Clock::now();
    auto active = start;
    bool spoke = false, stopped_reading = false;
    std::size_t sent = 0;
    const auto fault = [&](FaultKind kind, const std::string& what) {
        answers.fault = Fault{kind, fmt::format("{} after {} of {} rows", what, answers.values.size(), rows), answers.values.size()};
    };
    const auto left = [&]() { // until the first limit that would be broken; sets the fault if one is
        const auto now = Clock::now();
        const auto whole = start + limits.total - now;
        const auto quiet = (spoke ? active + limits.silence : start + limits.start) - now;
        if (whole.count() <= 0) fault(FaultKind::hang, fmt::format("was not done within {:g} s (the limit in all)", seconds(limits.total)));
        else if (quiet.count() <= 0 && spoke) fault(FaultKind::hang, fmt::format("was silent for {:g} s", seconds(limits.silence)));
        else if (quiet.count() <= 0)
            fault(FaultKind::hang, fmt::format("gave no answer within {:g} s of its start", seconds(limits.start)));
        return std::chrono::ceil<std::chrono::milliseconds>(std::min(whole, quiet)).count();
    };
    auto weighed = start - weighing;
    const auto weigh = [&]() { // now and then, since it reads of every process
        if (Clock::now() - weighed < weighing) return;
        if (const std::size_t bytes = resident(pid); bytes > limits.memory)
            fault(FaultKind::memory, fmt::format("held {:.1f} GiB of memory (the limit is {:g})", gib(bytes), gib(limits.memory)));
        weighed = Clock::now();
    };
    if (questions.empty()) to.close();
    std::array<char, 65536> buffer;
    while (!answers.fault && interrupted == 0 && from.open()) {
        const auto wait = left();
        if (!answers.fault) weigh();
        if (answers.fault) break;
        std::array<pollfd, 3> fds{pollfd{from.get(), POLLIN, 0}, pollfd{chatter.open() ? chatter.get() : -1, POLLIN, 0},
                                  pollfd{to.open() ? to.get() : -1, POLLOUT, 0}};
        if (::poll(fds.data(), fds.size(), static_cast<int>(std::min<long>(wait, weighing.count()))) <= 0) continue;
        if (fds[2].revents != 0) {
            const ssize_t n = ::write(to.get(), questions.data() + sent, questions.size() - sent);
            if (n > 0) {
                sent += static_cast<std::size_t>(n);
                active = Clock::now();
            }
            else if (n < 0 && errno != EAGAIN && errno != EINTR) stopped_reading = true;
            if (stopped_reading || sent == questions.size()) to.close();
        }
        if (fds[1].revents != 0) {
            const ssize_t n = ::read(chatter.get(), buffer.data(), buffer.size());
            if (n > 0) {
                answers.chatter.append(buffer.data(), static_cast<std::size_t>(n));
                if (answers.chatter.size() > kept_chatter) answers.chatter.erase(0, answers.chatter.size() - kept_chatter);
            }
            else if (n == 0 || (errno != EAGAIN && errno != EINTR)) chatter.close();
        }
        if (fds[0].revents != 0) {
            const ssize_t n = ::read(from.get(), buffer.data(), buffer.size());
            if (n > 0) {
                spoke = true;
                active = Clock::now();
                if (!collector.take({buffer.data(), static_cast<std::size_t>(n)})) break;
            }
            else if (n == 0) from.close();
            else if (errno != EAGAIN && errno != EINTR) from.close();
        }
    }
    if (!answers.fault && interrupted == 0) collector.finish();
    // a fault found here stands; else how it ended may be one
    active = Clock::now();
    spoke = true;
    while (!answers.fault && interrupted == 0 && !process.ended()) {
        weigh();
        if (!answers.fault && left() > 0) ::poll(nullptr, 0, 1);
    }
    if (chatter.open()) { // its last words
        const ssize_t n = ::read(chatter.get(), buffer.data(), buffer.size());
        if (n > 0) answers.chatter.append(buffer.data(), static_cast<std::size_t>(n));
    }
    if (!answers.fault && interrupted == 0) {
        const int status = process.status();
        if (WIFSIGNALED(status))
            fault(FaultKind::killed, fmt::format("was killed by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status))));
        else if (WEXITSTATUS(status) != 0) fault(FaultKind::exit_status, fmt::format("ended with exit status {}", WEXITSTATUS(status)));
        else if (stopped_reading)
            fault(FaultKind::closed_input,
                  fmt::format("closed its input when {} of {} bytes had been sent, and ended", sent, questions.size()));
        else if (answers.values.size() < rows) fault(FaultKind::too_few, "ended");
    }
    return answers;
}

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
[[noreturn]] void serve_library(const std::string& library, const std::string& symbol, const InputRows& rows, int answers)
{
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
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, in.read.get(), 0);
    posix_spawn_file_actions_adddup2(&files, out.write.get(), 1);
    posix_spawn_file_actions_adddup2(&files, err.write.get(), 2);
    posix_spawn_file_actions_addclosefrom_np(&files, first_of_others);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t defaults, none;
    sigemptyset(&none);
    sigemptyset(&defaults);
    for (const int s : {SIGPIPE, SIGINT, SIGTERM, SIGHUP}) sigaddset(&defaults, s);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    std::vector<char*> argv;
    for (const auto& word : command) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    pid_t pid = 0;
    const int error = ::posix_spawnp(&pid, argv[0], &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) return not_started(fmt::format("could not be run: {}", std::strerror(error)));
    in.read.close();
    out.write.close();
    err.write.close();
    return converse(pid, std::move(in.write), std::move(out.read), std::move(err.read), questions, rows.size(), limits);
}

Answers ask_library(const std::string& library, const std::string& symbol, const InputRows& rows, const Limits& limits)
{
    // with a slash in it dlopen takes the file meant, not one of that name elsewhere
    const std::string path = std::filesystem::absolute(library).string();
    const Signals signals;
    Pipe out, err;
    const pid_t pid = ::fork();
    if (pid < 0) return not_started(fmt::format("could not be run: {}", std::strerror(errno)));
    if (pid == 0) {
        ::setpgid(0, 0);
        for (const int s : {SIGPIPE, SIGINT, SIGTERM, SIGHUP}) ::signal(s, SIG_DFL);
        const int nothing = ::open("/dev/null", O_RDONLY);
        ::dup2(nothing, 0);
        ::dup2(err.write.get(), 1); // what the library prints is chatter, not an answer
        ::dup2(err.write.get(), 2);
        ::dup2(out.write.get(), first_of_others);
        ::close_range(first_of_others + 1, ~0U, 0);
        serve_library(path, symbol, rows, first_of_others);
    }
    ::setpgid(pid, pid);
    out.write.close();
    err.write.close();
    Answers answers = converse(pid, Descriptor(), std::move(out.read), std::move(err.read), "", rows.size(), limits);
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
