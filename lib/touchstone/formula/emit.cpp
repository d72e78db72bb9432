// SPDX-License-Identifier: MIT
#include "touchstone/formula/mathematics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <stdexcept>

namespace touchstone::formula {
namespace {

/// How a language spells things. "{}" in a text is where a part goes.
struct Language {
    std::string comment;
    std::map<std::string, std::string> functions;  ///< where they differ from their name here
    std::set<std::string> missing;                 ///< primitives that a helper has to stand in for
    std::string number, literal;                   ///< of an integer; of a decimal constant
    std::string pi;
    std::string assign, begin_if, begin_else, end_if;
    std::string prelude;
};

const Language& language(std::string_view name)
{
    static const std::map<std::string, Language, std::less<>> all{
        {"c",
         {"//",
          {{"abs", "fabs"}, {"nearest", "nearbyint"}, {"min", "fmin"}, {"max", "fmax"}, {"gamma", "tgamma"}},
          {},
          "{}.0",
          "{}",
          "3.141592653589793",
          "{} = {};",
          "if ({} < {}) {{",
          "}} else {{",
          "}}",
          "#include <math.h>\n"}},
        {"fortran",
         {"!",
          {{"nearest", "anint"}},
          {"expm1"},
          "{}.0_dp",
          "{}_dp",
          "3.141592653589793_dp",
          "{} = {}",
          "if ({} < {}) then",
          "else",
          "end if",
          ""}},
        {"python",
         {"#",
          {{"sqrt", "math.sqrt"},
           {"exp", "math.exp"},
           {"log", "math.log"},
           {"sin", "math.sin"},
           {"cos", "math.cos"},
           {"asin", "math.asin"},
           {"acos", "math.acos"},
           {"atan2", "math.atan2"},
           {"pow", "math.pow"},
           {"expm1", "math.expm1"},
           {"hypot", "math.hypot"},
           {"gamma", "math.gamma"},
           {"nearest", "round"}},
          {"fma"},
          "{}.0",
          "{}",
          "math.pi",
          "{} = {}",
          "if {} < {}:",
          "else:",
          "",
          "import math\n"}},
        {"julia",
         {"#",
          {{"atan2", "atan"}, {"nearest", "round"}, {"pow", "^"}},
          {},
          "{}.0",
          "{}",
          "3.141592653589793",
          "{} = {}",
          "if {} < {}",
          "else",
          "end",
          ""}},
        {"octave", {"%", {{"nearest", "round"}, {"pow", "power"}}, {"fma"}, "{}", "{}", "pi", "{} = {};", "if {} < {}", "else", "end", ""}},
    };
    const auto found = all.find(name);
    if (found == all.end()) throw std::invalid_argument("no such language");
    return found->second;
}

/// Brackets open at once in an expression before a part of it gets a name: compilers stop at 63 (C99), 100 (CPython) or 256 (clang,
/// Octave), readers earlier.
constexpr int deepest = 12;

int nesting(std::string_view text)
{
    int open = 0, most = 0;
    for (const char c : text) {
        if (c == '(') most = std::max(most, ++open);
        if (c == ')') --open;
    }
    return most;
}

/// Statements of one function: each term used twice or nested deeply gets a name, each choice an if.
class Body {
public:
    Body(const Language& l, std::string_view name, std::set<std::string>& called) : l_(l), python_(name == "python"), called_(called) {}

    std::string run(const Term& whole)
    {
        std::set<const Term::Node*> seen;
        count(whole, seen);
        return expression(whole);
    }
    const std::vector<std::string>& lines() const { return lines_; }
    const std::vector<std::string>& variables() const { return variables_; }

private:
    void count(const Term& t, std::set<const Term::Node*>& seen)
    {
        ++uses_[t.id()];
        if (!seen.insert(t.id()).second) return;
        for (const Term& a : t->arguments) count(a, seen);
    }

    void line(const std::string& text)
    {
        if (!text.empty()) lines_.push_back(std::string(2 * depth_ * (python_ ? 2 : 1), ' ') + text);
    }

    std::string fresh()
    {
        variables_.push_back(fmt::format("t{}", variables_.size() + 1));
        return variables_.back();
    }

    std::string expression(const Term& t)
    {
        if (const auto named = names_.find(t.id()); named != names_.end()) return named->second;
        if (t->op == Op::select) return choice(t);
        const std::string text = spelled(t);
        const bool leaf = t->arguments.empty();
        if (leaf || (uses_[t.id()] < 2 && nesting(text) < deepest)) return text;
        const std::string name = fresh();
        line(fmt::format(fmt::runtime(l_.assign), name, text));
        return names_[t.id()] = name;
    }

    std::string choice(const Term& t)
    {
        const std::string below = expression(t->arguments[0]), above = expression(t->arguments[1]), name = fresh();
        line(fmt::format(fmt::runtime(l_.begin_if), below, above));
        const auto outside = names_;
        for (int branch = 0; branch < 2; ++branch) {
            if (branch == 1) line(fmt::format(fmt::runtime(l_.begin_else)));
            ++depth_;
            line(fmt::format(fmt::runtime(l_.assign), name, expression(t->arguments[static_cast<std::size_t>(2 + branch)])));
            --depth_;
            names_ = outside; // what a branch names is not known outside it
        }
        line(fmt::format(fmt::runtime(l_.end_if)));
        return names_[t.id()] = name;
    }

    std::string number(long n) const
    {
        const std::string text = fmt::format(fmt::runtime(l_.number), n);
        return n < 0 ? "(" + text + ")" : text;
    }

    std::string spelled(const Term& t)
    {
        const auto part = [&](std::size_t k) { return expression(t->arguments[k]); };
        const auto infix = [&](const char* sign) {
            const std::string left = part(0);
            return fmt::format("({} {} {})", left, sign, part(1));
        };
        switch (t->op) {
        case Op::number: return t->q == 1 ? number(t->p) : fmt::format("({} / {})", number(t->p), number(t->q));
        case Op::literal: return fmt::format(fmt::runtime(l_.literal), t->text);
        case Op::pi: return l_.pi;
        case Op::input: return t->text;
        case Op::negate: return fmt::format("(-{})", part(0));
        case Op::add: return infix("+");
        case Op::subtract: return infix("-");
        case Op::multiply: return infix("*");
        case Op::divide: return infix("/");
        case Op::call: return call(t);
        case Op::select: break;
        }
        throw std::logic_error("a choice is no expression");
    }

    std::string call(const Term& t)
    {
        std::vector<std::string> arguments;
        for (const Term& a : t->arguments) arguments.push_back(expression(a));
        const auto primitive = l_.functions.find(t->text);
        const std::string name = primitive != l_.functions.end() ? primitive->second : t->text;
        if (t->text == "pow" && (name == "^" || l_.comment == "!"))
            return fmt::format("({} {} {})", arguments[0], name == "^" ? "^" : "**", arguments[1]);
        if (helpers().contains(t->text) && (t->text != "fma" || l_.missing.contains("fma"))) called_.insert(t->text);
        return fmt::format("{}({})", name, fmt::join(arguments, ", "));
    }

    const Language& l_;
    bool python_;
    std::set<std::string>& called_;
    std::map<const Term::Node*, int> uses_;
    std::map<const Term::Node*, std::string> names_;
    std::vector<std::string> lines_, variables_;
    std::size_t depth_ = 1;
};

std::string function_text(std::string_view name, const std::string& function, const std::vector<std::string>& parameters, const Term& body,
                          bool helper, std::set<std::string>& called)
{
    Body b(language(name), name, called);
    const std::string result = b.run(body);
    const std::string inside = fmt::format("{}", fmt::join(b.lines(), "\n")) + (b.lines().empty() ? "" : "\n");
    const auto joined = [](const std::vector<std::string>& words, const char* before) {
        std::string text;
        for (const auto& w : words) text += (text.empty() ? "" : ", ") + std::string(before) + w;
        return text;
    };
    const std::string plain = joined(parameters, "");
    const std::string& f = function;
    if (name == "c")
        return fmt::format("{}double {}({})\n{{\n{}{}  return {};\n}}\n", helper ? "static " : "", f,
                           parameters.empty() ? "void" : joined(parameters, "double "),
                           b.variables().empty() ? "" : "  double " + joined(b.variables(), "") + ";\n", inside, result);
    if (name == "fortran")
        return fmt::format(
            "  elemental function {0}({1}) result(value)\n{2}    real(dp) :: value\n{3}{4}    value = {5}\n  end function {0}\n", f, plain,
            plain.empty() ? "" : "    real(dp), intent(in) :: " + plain + "\n",
            b.variables().empty() ? "" : "    real(dp) :: " + joined(b.variables(), "") + "\n", inside, result);
    if (name == "python") return fmt::format("def {}({}):\n{}    return {}\n", f, plain, inside, result);
    if (name == "julia") return fmt::format("function {}({})\n{}  return {}\nend\n", f, plain, inside, result);
    return fmt::format("function value = {}({})\n{}  value = {};\nend\n", f, plain, inside, result); // octave
}

/// Fortran breaks long lines: they may have 132 characters.
std::string broken_lines(const std::string& text)
{
    constexpr std::size_t longest = 100;
    std::string out, rest;
    for (std::size_t at = 0; at < text.size();) {
        const auto end = text.find('\n', at);
        rest = text.substr(at, end - at);
        at = end + 1;
        while (rest.size() > longest) {
            const auto blank = rest.rfind(' ', longest);
            if (blank == std::string::npos || blank < rest.find_first_not_of(' ')) { // one long word: it goes on after a second ampersand
                out += rest.substr(0, longest) + "&\n";
                rest = "      &" + rest.substr(longest);
                continue;
            }
            out += rest.substr(0, blank) + " &\n";
            rest = "      " + rest.substr(blank + 1);
        }
        out += rest + "\n";
    }
    return out;
}

std::string code(const Formula& f, std::string_view name)
{
    const Language& l = language(name);
    std::set<std::string> called, done;
    const std::string name_here = identifier(f.name);
    std::string functions =
        fmt::format("{} free of cancellation\n", l.comment) + function_text(name, name_here, f.inputs, f.stable, false, called);
    if (f.printed)
        functions += fmt::format("\n{} as the paper prints it: loses digits at edges\n", l.comment) +
                     function_text(name, name_here + "_as_printed", f.inputs, *f.printed, false, called);
    std::string before;
    while (called != done) { // helpers call helpers; those called stand first
        const auto next = *std::find_if(called.begin(), called.end(), [&](const auto& c) { return !done.contains(c); });
        done.insert(next);
        const Helper& h = helpers().at(next);
        before = function_text(name, next, h.parameters, h.body, true, called) + "\n" + before;
    }
    if (name == "c") { // each before its use, whatever the order
        std::string declared;
        for (const auto& helper : done)
            declared += fmt::format("static double {}({});\n", helper,
                                    helpers().at(helper).parameters.size() == 1   ? "double"
                                    : helpers().at(helper).parameters.size() == 2 ? "double, double"
                                                                                  : "double, double, double");
        before = declared + (declared.empty() ? "" : "\n") + before;
    }
    const std::string first =
        fmt::format("{} {}: written by Touchstone from the template that it computes with. SPDX-License-Identifier: MIT\n", l.comment,
                    f.name) +
        fmt::format("{} binary64 arithmetic; compile without -ffast-math.\n", l.comment);
    if (name == "fortran") {
        const std::string fma =
            "  interface\n    pure real(c_double) function c_fma(a, b, c) bind(C, name=\"fma\")\n      import :: c_double\n      real(c_double), value :: a, b, c\n    end function\n"
            "    pure real(c_double) function c_expm1(x) bind(C, name=\"expm1\")\n      import :: c_double\n      real(c_double), value :: x\n    end function\n  end interface\n";
        const std::string wrappers =
            "  elemental function fma(a, b, c) result(value)\n    real(dp), intent(in) :: a, b, c\n    real(dp) :: value\n    value = c_fma(a, b, c)\n  end function fma\n\n"
            "  elemental function expm1(x) result(value)\n    real(dp), intent(in) :: x\n    real(dp) :: value\n    value = c_expm1(x)\n  end function expm1\n\n";
        return first +
               broken_lines(fmt::format(
                   "module {0}_formula\n  use, intrinsic :: iso_c_binding, only : c_double\n  implicit none\n  integer, parameter :: dp = c_double\n{1}contains\n{2}{3}{4}end module {0}_formula\n",
                   name_here, fma, wrappers, before, functions));
    }
    const bool special = name == "julia" && functions.find("gamma(") != std::string::npos;
    if (name == "octave")
        return first + functions + (before.empty() ? "" : "\n" + before); // the file's first function is the one that is called
    return first + (special ? "using SpecialFunctions: gamma\n" : l.prelude) + "\n" + before + functions;
}

} // namespace

std::string emit(const Formula& f, std::string_view name)
{
    if (name == "latex" || name == "fpcore" || name == "sympy") return mathematics(f, name);
    return code(f, name);
}

} // namespace touchstone::formula
