// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge_adapter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace touchstone::program {
namespace {

/// Names that are no good as a function's or a variable's are made so: "westergaard.half_width" -> westergaard_half_width.
std::string identifier(const Quantity& q)
{
    std::string name = q.name;
    for (char& c : name)
        if (c == '.') c = '_';
    return name;
}

/// What every adapter says first; `comment` begins a comment in its language.
std::string banner(const Quantity& q, std::string_view comment, const std::vector<std::string>& usage)
{
    std::string text = fmt::format("{0} {1}: {2}\n{0} unit: {3}; domain: {4}\n", comment, q.name, q.description, q.unit, q.domain);
    for (const auto& line : usage) text += fmt::format("{}   {}\n", comment, line);
    return text;
}

std::string python(const Quantity& q)
{
    return "#!/usr/bin/env python3\n" + banner(q, "#", {fmt::format("touchstone judge {} -- python3 adapter.py", identifier(q))})
         + fmt::format("import sys\n\n\ndef {0}({1}):\n    return float(\"nan\")  # <- your code here\n\n\n"
                       "for line in sys.stdin:\n    print(float({0}(*map(float.fromhex, line.split()))).hex(), flush=True)\n",
                       identifier(q), fmt::join(q.inputs, ", "));
}

std::string c(const Quantity& q)
{
    std::string parameters, arguments;
    for (std::size_t k = 0; k < q.inputs.size(); ++k) {
        parameters += fmt::format("{}double {}", k > 0 ? ", " : "", q.inputs[k]);
        arguments += fmt::format("{}x[{}]", k > 0 ? ", " : "", k);
    }
    std::string text = banner(q, "//", {"cc -O2 -o adapter adapter.c -lm", fmt::format("touchstone judge {} -- ./adapter", identifier(q))});
    text += fmt::format("#include <math.h>\n#include <stdio.h>\n#include <stdlib.h>\n\nstatic double {}({})\n{{\n", identifier(q),
                        parameters.empty() ? "void" : parameters);
    for (const auto& name : q.inputs) text += fmt::format("    (void)"
                                                          "{};\n", name);
    text += "    return NAN; // <- your code here\n}\n\nint main(void)\n{\n    char line[4096];\n    while (fgets(line, sizeof line, "
            "stdin)) {\n";
    if (!q.inputs.empty())
        text += fmt::format("        double x[{0}];\n        char *rest = line;\n        for (int k = 0; k < {0}; ++k) x[k] = strtod(rest, "
                            "&rest); // C99 hexadecimal\n",
                            q.inputs.size());
    return text + fmt::format("        printf(\"%a\\n\", {}({}));\n        fflush(stdout);\n    }}\n    return 0;\n}}\n", identifier(q),
                              arguments);
}

std::string fortran(const Quantity& q)
{
    const std::size_t count = q.inputs.size();
    std::string text =
        banner(q, "!", {"gfortran -O2 -o adapter adapter.f90", fmt::format("touchstone judge {} -- ./adapter", identifier(q))});
    text += R"(program adapter
  use, intrinsic :: iso_c_binding
  implicit none
  interface   ! Fortran reads no hexadecimal numbers: C does
    real(c_double) function strtod(text, rest) bind(c)
      import :: c_double, c_char, c_ptr
      character(kind=c_char), intent(in) :: text(*)
      type(c_ptr), value :: rest
    end function
  end interface
  character(len=4096) :: line
)";
    text += fmt::format("  character(len=64) :: word({0})\n  real(c_double) :: x({0})\n  integer :: status, k\n  do\n    read (*, '(a)', "
                        "iostat=status) line\n    if (status /= 0) exit\n",
                        std::max<std::size_t>(1, count));
    if (count > 0)
        text += fmt::format(
            "    read (line, *) word\n    do k = 1, {}\n      x(k) = strtod(trim(word(k))//c_null_char, c_null_ptr)\n    end do\n", count);
    text += "    write (*, '(es24.16e3)') answer(x)\n    flush (6)\n  end do\n\ncontains\n\n  real(c_double) function answer(x)\n    use, "
            "intrinsic :: ieee_arithmetic\n"
            "    real(c_double), intent(in) :: x(:)\n";
    for (std::size_t k = 0; k < count; ++k) text += fmt::format("    ! x({}) is {}\n", k + 1, q.inputs[k]);
    return text + "    answer = ieee_value(x(1), ieee_quiet_nan)   ! <- your code here\n  end function answer\nend program adapter\n";
}

std::string octave(const Quantity& q)
{
    std::string text = banner(q, "%",
                              {fmt::format("touchstone table {0} > {0}.txt", identifier(q)),
                               fmt::format("octave-cli adapter.m {0}.txt answers.txt", identifier(q)),
                               fmt::format("touchstone judge {0}.txt --answers answers.txt", identifier(q))});
    text += "names = argv();\nlines = strsplit(strtrim(fileread(names{1})), \"\\n\");\nlines = lines(! strncmp(lines, \"#\", 1));\nanswers "
            "= zeros(numel(lines), 1);\n"
            "for k = 1:numel(lines)\n  row = sscanf(lines{k}, \"%f\");\n";
    for (std::size_t k = 0; k < q.inputs.size(); ++k) text += fmt::format("  {} = row({});\n", q.inputs[k], k + 1);
    return text + "  answers(k) = NaN;   % <- your code here\nendfor\nfile = fopen(names{2}, \"w\");\nfprintf(file, \"%.17g\\n\", "
                  "answers);\nfclose(file);\n";
}

} // namespace

const std::vector<std::string>& adapter_languages()
{
    static const std::vector<std::string> all{"python", "c", "fortran", "octave"};
    return all;
}

std::string adapter(const Quantity& q, std::string_view language)
{
    if (language == "python") return python(q);
    if (language == "c") return c(q);
    if (language == "fortran") return fortran(q);
    return octave(q);
}

} // namespace touchstone::program
