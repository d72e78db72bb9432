// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The subcommands of `touchstone`. Each adds its options to the command line and leaves what is
/// to be run, returning an exit code, in `run`.
#pragma once

#include <functional>

namespace CLI {
class App;
class Validator;
}

namespace touchstone::program {

using Run = std::function<int()>;

/// Refuses '': a variable that a script forgot to set is no path.
CLI::Validator not_empty();

void add_list(CLI::App&, Run&);
void add_eval(CLI::App&, Run&);
void add_check(CLI::App&, Run&);
void add_formula(CLI::App&, Run&);
void add_integrate(CLI::App&, Run&);
void add_table(CLI::App&, Run&);
void add_merge(CLI::App&, Run&);
void add_paper(CLI::App&, Run&);
void add_judge(CLI::App&, Run&);
void add_report(CLI::App&, Run&);
void add_certificate(CLI::App&, Run&);

} // namespace touchstone::program
