// SPDX-License-Identifier: MIT
#include "touchstone/oracle/supervisor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <poll.h>
#include <sstream>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace touchstone::oracle {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto longest_killing = std::chrono::seconds(5);
constexpr auto patience = 2 * longest_killing; ///< with a supervisor that has been asked to end, and may be stopped

/// What the supervisor says to the judge: small enough for a pipe to take or give it whole.
struct Word {
    enum Kind : int { started, not_started, ended } kind; ///< and the value is a process's number, an error, a status
    int value;
};

/// What follows runs in a fork of the judge, which may have other threads: no memory is asked for in it, and nothing is thrown.
void tell(int fd, Word word)
{
    while (::write(fd, &word, sizeof word) < 0 && errno == EINTR) {}
}

/// Sends SIGKILL to each child, which as long as nobody has waited for it is the one of that number. False: no list of them is to be had.
bool kill_children()
{
    const int list = ::open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
    if (list < 0) return false;
    char buffer[4096];
    pid_t child = 0;
    for (ssize_t n; (n = ::read(list, buffer, sizeof buffer)) > 0;)
        for (ssize_t i = 0; i < n; ++i) {
            if (buffer[i] >= '0' && buffer[i] <= '9') child = child * 10 + (buffer[i] - '0');
            else if (child > 0) ::kill(std::exchange(child, 0), SIGKILL);
        }
    if (child > 0) ::kill(child, SIGKILL);
    ::close(list);
    return true;
}

class Supervisor {
public:
    Supervisor(pid_t subject, int word)
        : subject_(subject)
        , word_(word)
    {
    }
    /// Until the judge has enough of the code, or is no more.
    void wait()
    {
        sigset_t awaited;
        sigemptyset(&awaited);
        for (const int s : {SIGCHLD, SIGTERM}) sigaddset(&awaited, s);
        for (int signal = 0; signal != SIGTERM; signal = ::sigwaitinfo(&awaited, nullptr)) collect();
    }
    /// Whoever is killed leaves its children to us, to be killed in the next round; one that forks all the time is met by being
    /// killed again at once. False: some are left.
    bool end_all()
    {
        const auto deadline = Clock::now() + longest_killing;
        for (;;) {
            const bool listed = kill_children();
            if (!ended_ || !listed) ::kill(-subject_, SIGKILL); // once it has been waited for, its number may become another's
            const bool some = collect();
            if (none_left_) return true;
            if (Clock::now() > deadline) return false;
            if (!some) ::poll(nullptr, 0, 1);
        }
    }

private:
    /// The statuses of all who have ended; whether there were any.
    bool collect()
    {
        bool some = false;
        int status = 0;
        pid_t child = 0;
        for (; (child = ::waitpid(-1, &status, WNOHANG)) > 0; some = true)
            if (child == subject_ && !std::exchange(ended_, true)) tell(word_, {Word::ended, status});
        none_left_ = child < 0 && errno == ECHILD;
        return some;
    }
    pid_t subject_;
    int word_;
    bool ended_ = false, none_left_ = false;
};

[[noreturn]] void supervise(const std::function<pid_t()>& start, int word, pid_t judge)
{
    ::setpgid(0, 0); // what ends the judge from its terminal is for the judge to pass on
    ::signal(SIGCHLD, SIG_DFL); // where it is ignored, nobody's status is kept
#ifdef __linux__
    ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM, 0, 0, 0);
#endif
    if (::getppid() != judge) ::_exit(0); // it died before that
    const pid_t subject = start();
    tell(word, subject > 0 ? Word{Word::started, subject} : Word{Word::not_started, -subject});
    if (subject <= 0) ::_exit(0);
    // an end of a pipe left open here would keep the code from seeing the end of its input, and the judge that of its output
    if (word > 0) ::close_range(0, static_cast<unsigned>(word - 1), 0);
    ::close_range(static_cast<unsigned>(word + 1), ~0U, 0);
    Supervisor supervisor(subject, word);
    supervisor.wait();
    ::_exit(supervisor.end_all() ? 0 : 1);
}

/// No handler of the judge's runs in its fork.
class AllBlocked {
public:
    AllBlocked()
    {
        sigset_t all;
        sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~AllBlocked() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    AllBlocked(const AllBlocked&) = delete;
    AllBlocked& operator=(const AllBlocked&) = delete;

private:
    sigset_t before_{};
};

/// Of a process: whose child it is, and what it holds.
struct Holder {
    pid_t parent = 0;
    std::size_t pages = 0;
};

std::map<pid_t, Holder> all_processes()
{
    std::map<pid_t, Holder> all;
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
        constexpr std::size_t of_parent = 1, of_pages = 21; // the fields 4 and 24 of proc(5)
        if (word.size() > of_pages)
            all[std::stoi(name)] = {std::stoi(word[of_parent]), std::strtoul(word[of_pages].c_str(), nullptr, 10)};
    }
    return all;
}

} // namespace

void Descriptor::close()
{
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
}

Pipe::Pipe()
{
    int fd[2];
    if (::pipe2(fd, O_CLOEXEC) != 0) throw std::runtime_error(fmt::format("no pipe to the judged program: {}", std::strerror(errno)));
    read = Descriptor(fd[0]);
    write = Descriptor(fd[1]);
}

Supervised::Supervised(const std::function<pid_t()>& start)
{
    Pipe word;
    const pid_t judge = ::getpid();
    {
        const AllBlocked quiet;
        supervisor_ = ::fork();
        if (supervisor_ == 0) supervise(start, word.write.get(), judge);
    }
    if (supervisor_ < 0) {
        error_ = errno;
        return;
    }
    word.write.close();
    word_ = std::move(word.read);
    if (!hear()) error_ = ECHILD; // somebody has ended it
    if (word_.open()) ::fcntl(word_.get(), F_SETFL, O_NONBLOCK);
}

/// Takes one word; false: there is none.
bool Supervised::hear()
{
    Word word{};
    ssize_t n = 0;
    while ((n = ::read(word_.get(), &word, sizeof word)) < 0 && errno == EINTR) {}
    if (n < 0 && errno == EAGAIN) return false;
    if (n != sizeof word) {
        word_.close();
        return false;
    }
    if (word.kind == Word::started) subject_ = word.value;
    else if (word.kind == Word::not_started) error_ = word.value;
    else {
        ended_ = true;
        status_ = word.value;
    }
    return true;
}

bool Supervised::ended()
{
    if (!ended_ && word_.open()) hear();
    return ended_;
}

/// What they have merely reserved is not counted, since some languages' run-time systems and the sanitizers reserve more than any machine
/// has; so that no limit of the kernel's serves.
std::size_t Supervised::resident() const
{
    static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    const auto all = all_processes();
    std::size_t pages = 0;
    for (const auto& [process, holder] : all) {
        pid_t ancestor = holder.parent;
        std::size_t steps = 0; // read one after another, they may seem to be in a ring
        for (auto at = all.find(ancestor); ancestor != supervisor_ && at != all.end() && ++steps < all.size(); at = all.find(ancestor))
            ancestor = at->second.parent;
        if (ancestor == supervisor_) pages += holder.pages;
    }
    return pages * page;
}

bool Supervised::end()
{
    if (supervisor_ <= 0) return all_gone_;
    ::kill(supervisor_, SIGTERM);
    ::kill(supervisor_, SIGCONT); // the code may have stopped it
    const auto deadline = Clock::now() + patience;
    int status = 0;
    pid_t waited = 0;
    while ((waited = ::waitpid(supervisor_, &status, WNOHANG)) == 0 || (waited < 0 && errno == EINTR)) {
        if (Clock::now() > deadline) ::kill(supervisor_, SIGKILL);
        pollfd fd{word(), POLLIN, 0};
        const bool said = ::poll(&fd, 1, 1) > 0;
        if (said && !hear()) word_.close(); // it is about to be gone
    }
    // where the caller's process ignores SIGCHLD, or waits for all, nothing is known of it but that it is gone
    all_gone_ = error_ != 0 || waited < 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 0);
    if (!all_gone_ && subject_ > 0) ::kill(-subject_, SIGKILL);
    supervisor_ = -1;
    word_.close();
    return all_gone_;
}

} // namespace touchstone::oracle
