// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the changes compiled in (switch.hpp) anybody finds: every test case linked and, where it is linked, the ledger (finders.hpp).
// Numbers of changes come on stdin; one line "NUMBER found|survives|unreached WHO" goes out for each. With --plain the program as it was
// compiled is judged, and the first who finds something is named.
#include "finders.hpp"
#include "switch.hpp"

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace mutant {
int active = -1;
unsigned char at_start[most];
unsigned char* reached = at_start;
} // namespace mutant

namespace {

constexpr double least_seconds = 10;      // of CPU, for each who looks at a change,
constexpr double times_as_long = 5;       // or this many times what is needed without it, whatever is more
constexpr double times_by_the_clock = 60; // as many seconds of the clock: the machine may be busy, but what waits for ever has an end
constexpr double longest_usual = 600;     // nobody takes longer without a change
constexpr double dear_share = 20;         // whoever takes more than a twentieth of all is named
constexpr rlim_t most_bytes = rlim_t{3} << 30;

__attribute__((constructor(101))) void switch_on_before_anything_else()
{
    if (const char* id = std::getenv("TOUCHSTONE_MUTANT")) mutant::active = std::atoi(id);
}

bool test_finds(std::string name)
{
    std::replace(name.begin(), name.end(), ',', '?'); // a comma would separate two filters; ? is any character
    static std::ofstream nowhere("/dev/null");
    doctest::Context context;
    context.addFilter("test-case", name.c_str());
    context.setOption("abort-after", 1);
    context.setOption("no-skip", true);
    context.setCout(&nowhere);
    return context.run() != 0;
}

/// The claims are handed over one by one below: those who take them all again would find the same, later.
bool looks_at_everything(const std::string& test)
{
    return test.starts_with("every entry has its recorded verdict") || test.starts_with("every lemma and every constant holds");
}

/// What is skipped by default takes minutes: asked only beside the ledger, whose record it computes.
std::vector<Finder> all_finders()
{
    std::vector<Finder> all;
    if (finders_of_the_ledger) all = finders_of_the_ledger();
    for (const auto& test : doctest::detail::getRegisteredTests())
        if (const std::string name = test.m_name; !looks_at_everything(name) && (finders_of_the_ledger || !test.m_skip))
            all.push_back({"test '" + name + "'", [name] { return test_finds(name); }});
    return all;
}

/// Whether one finds it; an exception is a find, as every program here reports one.
bool asks(const Finder& f)
{
    try {
        return f.finds();
    } catch (...) {
        return true;
    }
}

double cpu_seconds()
{
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Shared {
    unsigned char reached[mutant::most];
    double seconds;
    int who;
};

Shared* shared()
{
    static Shared* const s = static_cast<Shared*>(mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    return s;
}

/// From now on, for something that usually takes so long.
void limit_time(double usual_seconds)
{
    const double seconds = std::max(least_seconds, times_as_long * usual_seconds);
    const rlimit limit{static_cast<rlim_t>(cpu_seconds() + seconds) + 1, RLIM_INFINITY};
    setrlimit(RLIMIT_CPU, &limit);
    alarm(static_cast<unsigned>(times_by_the_clock * seconds));
}

/// Run in a child, which leaves no kept value behind. The exit status, or minus the signal.
int in_child(double usual_seconds, const std::function<int()>& work)
{
    std::cout.flush();
    const pid_t child = fork();
    if (child == 0) {
        limit_time(usual_seconds);
        const rlimit memory{most_bytes, most_bytes}; // a sum that does not end asks for all there is
        setrlimit(RLIMIT_AS, &memory);
        const rlimit none{0, 0};
        setrlimit(RLIMIT_CORE, &none);
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO); // verdicts alone are told there
        _exit(work());
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// The first of the finders that finds something is put down in shared()->who before each is asked.
int first_who_finds(const std::vector<Finder>& finders, const std::vector<std::size_t>& order)
{
    for (const std::size_t i : order) {
        shared()->who = static_cast<int>(i);
        if (finders[i].seconds > 0) limit_time(finders[i].seconds);
        if (asks(finders[i])) return 1;
    }
    return 0;
}

/// What each comes by, and what it costs, with no change on; whoever takes more than so many seconds comes by nothing.
bool look_around(std::vector<Finder>& finders, double dearest)
{
    bool good = true;
    for (Finder& f : finders) {
        std::memset(shared()->reached, 0, mutant::most);
        const int status = in_child(longest_usual, [&] {
            mutant::reached = shared()->reached;
            const double start = cpu_seconds();
            const rlimit limit{static_cast<rlim_t>(start + dearest) + 1, RLIM_INFINITY};
            setrlimit(RLIMIT_CPU, &limit);
            const bool found = asks(f);
            shared()->seconds = cpu_seconds() - start;
            return found ? 1 : 0;
        });
        if (status == -SIGXCPU && dearest < longest_usual) {
            f.seconds = dearest + 1;
            f.reached.assign(mutant::most, 0);
            continue;
        }
        f.seconds = shared()->seconds;
        f.reached.assign(shared()->reached, shared()->reached + mutant::most);
        if (status != 0) std::cerr << "without any change, " << f.name << " finds something (" << status << ")\n";
        good = good && status == 0;
    }
    return good;
}

void report(int id, int status, const std::string& who)
{
    if (status == 0) std::cout << id << " survives -" << std::endl;
    else if (status == 1) std::cout << id << " found " << who << std::endl;
    else if (status == -SIGXCPU) std::cout << id << " found " << who << ", which does not end" << std::endl;
    else if (status == -SIGALRM) std::cout << id << " found " << who << ", which waits for ever" << std::endl;
    else std::cout << id << " found " << who << ", which crashes" << std::endl;
}

/// What ran before main, or when the claims were put together, cannot be switched on afterwards: a fresh process, which looks at
/// everything.
int look_from_the_start(int id, double usual_seconds, const char* program)
{
    return in_child(usual_seconds, [&] {
        setenv("TOUCHSTONE_MUTANT", std::to_string(id).c_str(), 1);
        execl(program, program, "--plain", static_cast<char*>(nullptr));
        return 1;
    });
}

std::vector<std::size_t> cheapest_first(const std::vector<Finder>& finders)
{
    std::vector<std::size_t> order(finders.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return finders[a].seconds < finders[b].seconds; });
    return order;
}

} // namespace

int main(int argc, char** argv)
{
    const bool plain = argc > 1 && std::string(argv[1]) == "--plain";
    std::vector<Finder> finders;
    try {
        finders = all_finders();
    } catch (const std::exception& e) {
        std::cerr << e.what() << "\n";
        return 1;
    }
    const char* limit = std::getenv("TOUCHSTONE_DEAREST"); // whoever takes more seconds without a change is not asked
    const double dearest = limit ? std::atof(limit) : longest_usual;
    if (plain) {
        const int found = first_who_finds(finders, cheapest_first(finders));
        std::cerr << (found ? finders[static_cast<std::size_t>(shared()->who)].name : "nobody") << "\n";
        return found;
    }
    const std::vector<unsigned char> before(mutant::at_start, mutant::at_start + mutant::most);
    if (!look_around(finders, dearest)) return 70;
    double all = 0;
    for (const Finder& f : finders) all += f.seconds;
    const std::vector<std::size_t> order = cheapest_first(finders);
    std::cerr << "# " << finders.size() << " finders, " << all << " s; the dearest";
    for (std::size_t i = order.size(); i > 0 && finders[order[i - 1]].seconds > all / dear_share; --i)
        std::cerr << ", " << finders[order[i - 1]].name << " " << finders[order[i - 1]].seconds;
    std::cerr << "\n";
    for (int id = 0; std::cin >> id;) {
        const auto at = static_cast<std::size_t>(id);
        if (before[at]) {
            report(id, look_from_the_start(id, all, argv[0]), "a fresh start");
            continue;
        }
        std::vector<std::size_t> who;
        double usual_seconds = 0;
        for (const std::size_t i : order)
            if (finders[i].reached[at] && finders[i].seconds <= dearest) {
                who.push_back(i);
                usual_seconds += finders[i].seconds;
            }
        if (who.empty()) {
            std::cout << id << " unreached -" << std::endl;
            continue;
        }
        const int status = in_child(usual_seconds, [&] {
            mutant::active = id;
            return first_who_finds(finders, who);
        });
        report(id, status, finders[static_cast<std::size_t>(shared()->who)].name);
    }
    return 0;
}
