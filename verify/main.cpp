// SPDX-License-Identifier: GPL-3.0-or-later
#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/oracle/baseline.hpp"
#include "touchstone/table/format.hpp"
#include "touchstone/table/rows.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"
#include "verify/progress.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

CLI::Validator touchstone::program::not_empty()
{
    return CLI::Validator([](const std::string& text) { return text.empty() ? std::string("is empty") : std::string(); }, "");
}

namespace {

using namespace touchstone;
using namespace touchstone::program;

/// One line on stderr, whatever the message was made of.
int complain(int code, std::string message)
{
    for (char& c : message)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    remark("touchstone: " + message + "\n");
    return code;
}

int guarded(const Run& run)
{
    try {
        const int code = run();
        flush_output();
        if (const int error = output_error())
            return complain(cannot_write, fmt::format("standard output cannot be written: {}", std::strerror(error)));
        return code;
    }
    catch (const Failure& f) {
        return complain(f.code(), f.what());
    }
    catch (const WrongKeys& e) {
        return complain(usage_error, e.what());
    }
    catch (const DomainError& e) {
        return complain(bad_input, e.what());
    }
    catch (const BeyondReach& e) {
        return complain(bad_input, e.what());
    }
    catch (const CorruptTable& e) {
        return complain(bad_input, e.what());
    }
    catch (const BadRows& e) {
        return complain(bad_input, e.what());
    }
    catch (const oracle::BadBaseline& e) {
        return complain(bad_input, e.what());
    }
    catch (const std::system_error& e) { // what fmt throws when a full disk refuses its buffer
        if (e.code() == std::errc::resource_unavailable_try_again)
            return complain(internal_error, "no thread could be started; try --jobs 1");
        return complain(cannot_write, fmt::format("standard output cannot be written: {}", e.code().message()));
    }
    catch (const std::bad_alloc&) {
        return complain(internal_error, "out of memory");
    }
    catch (const std::exception& e) {
        return complain(internal_error, fmt::format("internal error: {}", e.what()));
    }
}

/// The subcommand of that name alone, which saves the others' options; all of them where there is none. \returns whether there is.
bool add_commands(CLI::App& app, Run& run, std::string_view name)
{
    constexpr std::array<std::pair<std::string_view, void (*)(CLI::App&, Run&)>, 11> commands{{{"list", add_list},
                                                                                               {"eval", add_eval},
                                                                                               {"check", add_check},
                                                                                               {"formula", add_formula},
                                                                                               {"integrate", add_integrate},
                                                                                               {"table", add_table},
                                                                                               {"merge", add_merge},
                                                                                               {"paper", add_paper},
                                                                                               {"judge", add_judge},
                                                                                               {"report", add_report},
                                                                                               {"certificate", add_certificate}}};
    const auto asked = std::find_if(commands.begin(), commands.end(), [name](const auto& command) { return command.first == name; });
    if (asked != commands.end()) asked->second(app, run);
    else
        for (const auto& command : commands) command.second(app, run);
    return asked != commands.end();
}

/// `integrate` has formulas and ends that begin with a minus and no short options: a blank in front keeps them from being read as ones.
std::vector<std::string> words_of(int argc, char** argv)
{
    std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty() || words.front() != "integrate") return words;
    for (std::string& w : words)
        if (w.size() > 1 && w[0] == '-' && w[1] != '-' && w != "-h") w.insert(w.begin(), ' ');
    return words;
}

} // namespace

int main(int argc, char** argv)
{
    std::signal(SIGXFSZ, SIG_IGN); // a file size limit becomes a write error like any other
    CLI::App app{"Certified reference values for the elastic contact of the Weierstrass profile.\n"
                 "Exit codes: 0 holds, 1 fails, 2 undecided, 64 usage, 65 bad input, 66 no such file,\n"
                 "69 judged program broke the protocol, 70 internal error, 73 cannot write."};
    app.set_version_flag("--version", "touchstone " + std::string(version()));
    app.require_subcommand(1);
    app.fallthrough();
    app.add_flag_callback("--progress", [] { progress_in_logs(); }, "Long work says how far it is once a minute, in logs too");
    app.add_option_function<double>("--progress-every", progress_in_logs, "The same, every so many seconds")->check(CLI::Range(0.1, 1e6));
    Run run;
    const std::string_view first = argc > 1 ? argv[1] : "";
    if (!add_commands(app, run, first) && !first.empty() && first.front() != '-') { // before a --help after it is obeyed
        std::vector<std::string> names;
        for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
        return complain(usage_error,
                        fmt::format("no subcommand '{}'; nearest is '{}' (try: touchstone --help)", first, nearest_name(first, names)));
    }
    try {
        std::vector<std::string> words = words_of(argc, argv);
        std::reverse(words.begin(), words.end()); // as CLI11 takes them
        app.parse(std::move(words));
    }
    catch (const CLI::Success& e) { // --help, --version
        return app.exit(e);
    }
    catch (const CLI::ParseError& e) {
        return complain(usage_error, fmt::format("{} (try: touchstone --help)", e.what()));
    }
    show_steps_of_engines();
    return guarded(run);
}
