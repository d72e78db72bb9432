// SPDX-License-Identifier: GPL-3.0-or-later
/// Codes that are wrong on purpose: `broken mixup NAME QUANTITY` makes a mistake of convention,
/// `broken fault NAME` breaks the protocol while computing westergaard.half_width.
/// The tests run each and expect to be told which it was.
#include "touchstone/paper/segments.hpp"
#include "verify/subjects/rows.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace touchstone;
using touchstone::subjects::answer_rows;
using touchstone::subjects::numbers;
using touchstone::subjects::Row;

namespace {

using Formula = std::function<double(const Row&)>;

constexpr double pi_ = std::numbers::pi;

const std::map<std::string, Formula>& right()
{
    static const std::map<std::string, Formula> all{
        {"westergaard.half_width", [](const Row& r) { return westergaard::half_width(r[0]); }},
        {"westergaard.pressure", [](const Row& r) { return westergaard::pressure(r[0], r[1]); }},
        {"westergaard.exceedance", [](const Row& r) { return westergaard::exceedance(r[0], r[1]); }},
        {"hertz.half_width", [](const Row& r) { return hertz::half_width(r[0]); }},
        {"hertz.pressure", [](const Row& r) { return hertz::pressure(r[0], r[1]); }},
    };
    return all;
}

/// (7.17) as printed
double K_printed(long n)
{
    double k = std::exp2(static_cast<double>(n) + std::ldexp(1, static_cast<int>(-n))) / std::pow(pi_, (static_cast<double>(n) + 2) / 2);
    for (long i = 0; i < n; ++i) {
        const double h = std::ldexp(1, static_cast<int>(-(i + 2)));
        k *= std::tgamma(1 - h) / std::tgamma(1.5 - h);
    }
    return k;
}

int mixup(const std::string& name, const std::string& quantity)
{
    if (name == "printed-7.17") return answer_rows([](const Row& r) { return K_printed(static_cast<long>(r[0])); });
    if (name == "printed-9.4")
        return answer_rows([](const Row& r) {
            const double x = r[0] == 0 ? r[1] : peaks::iterate(static_cast<long>(r[0]) - 1, r[1], r[2]);
            return std::asin(std::min(x, 1.0)) / pi_;
        });
    const Formula f = right().at(quantity);
    const double nu = 0.3, other_nu = 0.27;
    const std::map<std::string, Formula> wrong{
        {"factor-pi", [f](const Row& r) { return pi_ * f(r); }},
        {"factor-2", [f](const Row& r) { return 2 * f(r); }},
        {"full-width", [f](const Row& r) { return 2 * f(r); }},
        {"phase", [f](const Row& r) { return f({r[0] / (2 * pi_), r[1]}); }},
        {"mean-pressure-unit", [f](const Row& r) { return f(r) / r[1]; }},
        {"p-in-mean-pressure", [f](const Row& r) { return f({r[0] * r[1], r[1]}); }},
        {"peak-to-valley", [f](const Row& r) { return 2 * f({r[0], r[1] / 2}); }},
        {"E-for-plane-strain", [f, nu](const Row& r) { return f({r[0], r[1] / (1 - nu * nu)}); }},
        {"unlisted-nu", [f, other_nu](const Row& r) { return (1 - other_nu * other_nu) * f(r); }},
        {"valley-origin", [f](const Row& r) { return f({0.5 - std::fabs(r[0]), r[1]}); }},
        {"sign", [f](const Row& r) { return -f(r); }},
        {"hertz", [](const Row& r) { return hertz::half_width(r[0]); }},
        {"none", [f](const Row& r) { return f(r) * (1 + 0.1 * std::sin(40 * std::log(r[0] + 1e-3))); }}, // no convention is like this
    };
    return answer_rows(wrong.at(name));
}

void wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

constexpr double longest_life = 20; ///< seconds: of what a judge that fails its test leaves behind

/// A process in a session of its own, whose parent is gone: no signal to a group reaches it.
bool daemon()
{
    if (::fork() != 0) return false;
    ::setsid();
    if (::fork() != 0) std::_Exit(0);
    return true;
}

/// Lives on in one new process after another, each in a session of its own: whoever looks for it finds a number that is no more. That it
/// lives shows in a file that grows.
[[noreturn]] void flee(const std::string& trace)
{
    std::ofstream steps(trace, std::ios::app);
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(longest_life);
    while (std::chrono::steady_clock::now() < end) {
        if (::fork() != 0) std::_Exit(0);
        ::setsid();
        steps << '.' << std::flush;
    }
    std::_Exit(0);
}

/// What a code leaves behind; in the code itself it returns.
void leave_behind(const std::string& name, const std::string& trace)
{
    if (name == "daemon-writes" && daemon())
        for (;; wait(0.01))
            if (::write(1, "\n", 1) < 0) std::_Exit(0);
    if (name == "daemon-holds-memory" && daemon()) {
        const std::vector<char> much(std::size_t{700} << 20, 'x');
        wait(longest_life + much.back() - 'x');
        std::_Exit(0);
    }
    if (name.starts_with("daemon") && daemon()) {
        wait(longest_life);
        std::_Exit(0);
    }
    if (name == "many-flee")
        for (int k = 0; k < 8; ++k)
            if (daemon()) flee(trace);
}

int fault(const std::string& name, const std::string& trace)
{
    leave_behind(name, trace);
    long row = 0;
    if (name == "slow-start") wait(0.3);
    if (name == "silent-start" || name == "daemon-holds-memory" || name == "daemon-at-silent-start") wait(1000);
    if (name == "close-input") {
        ::close(0);
        wait(0.2);
        return 0;
    }
    if (name == "endless-line")
        for (const std::string zeros(1 << 16, '0');;)
            if (::write(1, zeros.data(), zeros.size()) < 0) return 0;
    if (name == "child-holds-pipe") { // the parent ends, a child lives on with the pipe open
        if (::fork() == 0) wait(1000);
        return 0;
    }
    if (name == "ignore-term") std::signal(SIGTERM, SIG_IGN);
    for (std::string line; std::getline(std::cin, line); ++row) {
        const double answer = westergaard::half_width(numbers(line)[0]);
        if (row == 20) {
            std::fflush(stdout);
            if (name == "segfault" || name == "daemon-and-crash") std::raise(SIGSEGV);
            if (name == "ends-its-supervisor") ::kill(::getppid(), SIGKILL);
            if (name == "stops-its-supervisor") ::kill(::getppid(), SIGSTOP);
            if (name == "abort") std::abort();
            if (name == "exit-3") return 3;
            if (name == "hang" || name == "ignore-term" || name == "daemon-and-hang") wait(1000);
            if (name == "too-few") return 0;
            if (name == "garbage") std::printf("0.25 apples\n");
            if (name == "binary") std::printf("\x01\x02\xff\n");
            if (name == "two-numbers") std::printf("%a %a\n", answer, answer);
            if (name == "trickle") for (;; wait(0.02)) { std::printf("\n"); std::fflush(stdout); } // never silent, never done
        }
        if (name == "chatter") std::fprintf(stderr, "row %ld is fine, thank you\n", row);
        std::printf("%a\n", answer);
    }
    if (name == "too-many") std::printf("0x1p-1\n");
    if (name == "crash-at-exit") {
        std::fflush(stdout);
        std::raise(SIGFPE);
    }
    return 0;
}

/// Reads the table instead of computing: right on its rows, nearest row elsewhere.
int look_up(const char* table)
{
    std::map<Row, double> rows;
    std::ifstream file(table);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("#")) continue;
        Row r = numbers(line);
        const double value = r[r.size() - 3]; // then its error, and what rounded inputs force
        r.resize(r.size() - 3);
        rows[r] = value;
    }
    return answer_rows([&](const Row& r) {
        const auto at = rows.lower_bound(r);
        return at == rows.end() ? rows.rbegin()->second : at->second;
    });
}

} // namespace

int main(int argc, char** argv)
{
    const std::string kind = argc > 2 ? argv[1] : "";
    if (kind == "mixup" && argc == 4) return mixup(argv[2], argv[3]);
    if (kind == "fault") return fault(argv[2], argc > 3 ? argv[3] : "");
    if (kind == "look-up") return look_up(argv[2]);
    std::cerr << "usage: broken mixup NAME QUANTITY | broken fault NAME [FILE] | broken look-up TABLE\n";
    return 64;
}
