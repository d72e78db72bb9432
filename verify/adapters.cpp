// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/adapters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace touchstone::program {
namespace {

/// "westergaard.half_width" as a name in any language.
std::string identifier(const Quantity& q)
{
    std::string name = q.name;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

/// Names of the arguments; Fortran is blind to case, so that K and k, or G and g, must not both be there: they are not.
std::string arguments(const Quantity& q, const std::string& before)
{
    std::string text;
    for (const std::string& name : q.inputs) text += (text.empty() ? "" : ", ") + before + name;
    return text;
}

} // namespace

std::string python_adapter(const Quantity& q)
{
    return fmt::format("import sys\n\ndef {}({}):\n    return float('nan')  # your function\n\nfor line in sys.stdin:\n    print({}(*map(float.fromhex, line.split())).hex(), flush=True)\n",
                       identifier(q), arguments(q, ""), identifier(q));
}

std::string cpp_adapter(const Quantity& q)
{
    std::string read;
    for (std::size_t k = 0; k < q.inputs.size(); ++k) read += fmt::format("        const double {} = std::strtod(at, &at);\n", q.inputs[k]);
    std::string silence;
    for (const std::string& name : q.inputs) silence += fmt::format("    (void){};\n", name);
    return fmt::format("#include <cmath>\n#include <cstdio>\n#include <cstdlib>\n\nstatic double {0}({1})\n{{\n{3}    return NAN; // your function\n}}\n\nint main()\n{{\n    char line[1000];\n"
                       "    while (std::fgets(line, sizeof line, stdin)) {{\n        char* at = line;\n{4}{5}        std::printf(\"%a\\n\", {0}({2}));\n        std::fflush(stdout);\n    }}\n}}\n",
                       identifier(q), arguments(q, "double "), arguments(q, ""), silence, read, q.inputs.empty() ? "        (void)at;\n" : "");
}

std::string fortran_adapter(const Quantity& q)
{
    const std::size_t count = q.inputs.size();
    std::string passed;
    for (std::size_t k = 0; k < count; ++k) passed += fmt::format("{}x({})", k > 0 ? ", " : "", k + 1);
    const std::string declared = q.inputs.empty() ? "" : fmt::format("    real(c_double), intent(in) :: {}\n", arguments(q, ""));
    // hexadecimal numbers are read by C's strtod, which list-directed READ is not asked to know
    return fmt::format("program adapter\n  use, intrinsic :: iso_c_binding\n  use, intrinsic :: iso_fortran_env, only: iostat_end\n  use, intrinsic :: ieee_arithmetic\n  implicit none\n"
                       "  interface\n    real(c_double) function strtod(text, rest) bind(c)\n      import :: c_double, c_char, c_ptr\n      character(kind=c_char), intent(in) :: text(*)\n"
                       "      type(c_ptr), value :: rest\n    end function\n  end interface\n  character(len=1000) :: line\n  real(c_double) :: x({0})\n  integer :: status, k, at\n"
                       "  do\n    read (*, '(a)', iostat=status) line\n    if (status == iostat_end) exit\n    do k = 1, {1}\n      line = adjustl(line)\n      at = index(line, ' ')\n"
                       "      x(k) = strtod(line(:at - 1)//c_null_char, c_null_ptr)\n      line = line(at:)\n    end do\n    write (*, '(es26.17e3)') {2}({3})\n    flush (6)\n  end do\ncontains\n"
                       "  real(c_double) function {2}({4})\n{5}    {2} = ieee_value(0.0_c_double, ieee_quiet_nan) ! your function\n  end function\nend program\n",
                       std::max<std::size_t>(1, count), count, identifier(q), passed, arguments(q, ""), declared);
}

} // namespace touchstone::program
