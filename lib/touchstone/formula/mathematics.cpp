// SPDX-License-Identifier: MIT
#include "touchstone/formula/mathematics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace touchstone::formula {
namespace {

/// Operations up to which a formula is written out whole, repeated parts and all: readers prefer that. A longer one is too unless that
/// more than doubles it.
constexpr double most_written_out = 300, most_repetition = 2;
/// A repeated part shorter than this stands for itself: a name would say less.
constexpr std::size_t shortest_named = 16;

/// The same formula with the library's compound operations as mathematics, each part that is shared still shared.
class Expansion {
public:
    Term operator()(const Term& t)
    {
        if (const auto done = done_.find(t.id()); done != done_.end()) return done->second.expanded;
        const Term plain = mathematical(t);
        const Term whole = plain.id() == t.id() ? with_expanded_arguments(t) : (*this)(plain);
        done_.emplace(t.id(), Entry{t, whole});
        return whole;
    }

private:
    struct Entry {
        Term kept; ///< so that no other node is made where this one was
        Term expanded;
    };

    Term with_expanded_arguments(const Term& t)
    {
        if (t->arguments.empty()) return t;
        Term::Node node = *t;
        for (Term& a : node.arguments) a = (*this)(a);
        return Term(std::move(node));
    }

    std::map<const Term::Node*, Entry> done_;
};

struct Part {
    std::string name, text;
};

/// Writes terms in one notation and names what is repeated.
class Writer {
public:
    virtual ~Writer() = default;

    std::string run(const Term& whole)
    {
        count(whole);
        naming_ = size(whole) > std::max(most_written_out, most_repetition * static_cast<double>(uses_.size()));
        return part(whole, false);
    }
    /// In the order in which they are needed; empty if the formula stands whole.
    const std::vector<Part>& parts() const { return parts_; }

protected:
    /// \param inside of a product or a power, where a sum needs brackets
    virtual std::string spelled(const Term&, bool inside) = 0;
    virtual std::string name(std::size_t k) const { return fmt::format("t{}", k); }

    std::string part(const Term& t, bool inside)
    {
        if (const auto named = names_.find(t.id()); named != names_.end()) return named->second;
        if (!naming_ || t->arguments.empty() || uses_[t.id()] < 2) return spelled(t, inside);
        std::string text = spelled(t, false);
        if (text.size() < shortest_named) return inside ? spelled(t, true) : text;
        const std::string called = name(parts_.size() + 1);
        parts_.push_back({called, std::move(text)});
        return names_[t.id()] = called;
    }

private:
    void count(const Term& t)
    {
        if (++uses_[t.id()] > 1) return;
        for (const Term& a : t->arguments) count(a);
    }
    /// Operations if nothing were named.
    double size(const Term& t)
    {
        if (const auto known = sizes_.find(t.id()); known != sizes_.end()) return known->second;
        double sum = 1;
        for (const Term& a : t->arguments) sum += size(a);
        return sizes_[t.id()] = sum;
    }

    bool naming_ = false;
    std::map<const Term::Node*, int> uses_;
    std::map<const Term::Node*, double> sizes_;
    std::map<const Term::Node*, std::string> names_;
    std::vector<Part> parts_;
};

class Latex : public Writer {
    std::string name(std::size_t k) const override { return fmt::format("t_{{{}}}", k); }

    static std::string input(const std::string& given)
    {
        static const std::map<std::string, std::string> names{{"load", "\\tilde p"}, {"gamma", "\\gamma"}};
        const auto found = names.find(given);
        return found == names.end() ? given : found->second;
    }

    std::string call(const Term& t)
    {
        const auto plain = [&](std::size_t k) { return part(t->arguments[k], false); };
        if (t->text == "sqrt") return fmt::format("\\sqrt{{{}}}", plain(0));
        if (t->text == "pow") {
            const std::string base = part(t->arguments[0], true);
            return fmt::format("{}^{{{}}}", base, plain(1));
        }
        if (t->text == "exp") return fmt::format("e^{{{}}}", plain(0));
        if (t->text == "gamma") return fmt::format("\\Gamma\\left({}\\right)", plain(0));
        if (t->text == "atan2" || t->text == "min" || t->text == "max") {
            const std::string first = plain(0), operation = t->text == "atan2" ? "\\operatorname{arctan2}" : "\\" + t->text;
            return fmt::format("{}\\left({}, {}\\right)", operation, first, plain(1));
        }
        if (t->text == "asin" || t->text == "acos") return fmt::format("\\arc{}\\left({}\\right)", t->text.substr(1), plain(0));
        return fmt::format("\\{}\\left({}\\right)", t->text, plain(0));
    }

    std::string spelled(const Term& t, bool inside) override
    {
        const auto bracketed = [inside](const std::string& text) { return inside ? "\\left(" + text + "\\right)" : text; };
        const auto infix = [&](bool left_inside, std::string_view sign, bool right_inside) {
            const std::string left = part(t->arguments[0], left_inside);
            return fmt::format("{}{}{}", left, sign, part(t->arguments[1], right_inside));
        };
        switch (t->op) {
        case Op::number:
            return t->q != 1  ? fmt::format("\\frac{{{}}}{{{}}}", t->p, t->q)
                   : t->p < 0 ? bracketed(std::to_string(t->p))
                              : std::to_string(t->p);
        case Op::literal: return t->text;
        case Op::pi: return "\\pi";
        case Op::input: return input(t->text);
        case Op::negate: return bracketed("-" + part(t->arguments[0], true));
        case Op::add: return bracketed(infix(false, " + ", false));
        case Op::subtract: return bracketed(infix(false, " - ", true));
        case Op::multiply: return infix(true, " \\, ", true);
        case Op::divide: {
            const std::string above = part(t->arguments[0], false);
            return fmt::format("\\frac{{{}}}{{{}}}", above, part(t->arguments[1], false));
        }
        case Op::call: return call(t);
        case Op::select: break;
        }
        std::vector<std::string> of; // in the order in which parts are named
        for (const Term& a : t->arguments) of.push_back(part(a, false));
        return fmt::format("\\begin{{cases}} {} & {} < {} \\\\ {} & \\text{{else}} \\end{{cases}}", of[2], of[0], of[1], of[3]);
    }
};

class FPCore : public Writer {
    std::string spelled(const Term& t, bool) override
    {
        std::vector<std::string> of;
        for (const Term& a : t->arguments) of.push_back(part(a, false));
        const auto applied = [&of](std::string_view operation) { return fmt::format("({} {})", operation, fmt::join(of, " ")); };
        switch (t->op) {
        case Op::number: return t->q == 1 ? std::to_string(t->p) : fmt::format("{}/{}", t->p, t->q);
        case Op::literal: return t->text;
        case Op::pi: return "PI";
        case Op::input: return t->text;
        case Op::negate:
        case Op::subtract: return applied("-");
        case Op::add: return applied("+");
        case Op::multiply: return applied("*");
        case Op::divide: return applied("/");
        case Op::call: return applied(t->text == "min" || t->text == "max" ? "f" + t->text : t->text == "gamma" ? "tgamma" : t->text);
        case Op::select: break;
        }
        return fmt::format("(if (< {} {}) {} {})", of[0], of[1], of[2], of[3]);
    }
};

class SymPy : public Writer {
    std::string spelled(const Term& t, bool) override
    {
        std::vector<std::string> of;
        for (const Term& a : t->arguments) of.push_back(part(a, false));
        const auto infix = [&of](std::string_view sign) { return fmt::format("({} {} {})", of[0], sign, of[1]); };
        switch (t->op) {
        case Op::number: return t->q == 1 ? fmt::format("sympy.Integer({})", t->p) : fmt::format("sympy.Rational({}, {})", t->p, t->q);
        case Op::literal: return fmt::format("sympy.Float(\"{}\")", t->text);
        case Op::pi: return "sympy.pi";
        case Op::input: return t->text;
        case Op::negate: return fmt::format("(-{})", of[0]);
        case Op::add: return infix("+");
        case Op::subtract: return infix("-");
        case Op::multiply: return infix("*");
        case Op::divide: return infix("/");
        case Op::call: {
            static const std::map<std::string, std::string> names{{"min", "Min"}, {"max", "Max"}, {"pow", "Pow"}};
            const auto found = names.find(t->text);
            return fmt::format("sympy.{}({})", found == names.end() ? t->text : found->second, fmt::join(of, ", "));
        }
        case Op::select: break;
        }
        return fmt::format("sympy.Piecewise(({}, {} < {}), ({}, True))", of[2], of[0], of[1], of[3]);
    }
};

/// \text takes no bare underscore.
std::string latex_text(const std::string& name)
{
    std::string escaped;
    for (const char c : name) escaped += c == '_' ? "\\_" : std::string(1, c);
    return escaped;
}

std::string latex(const Formula& f, const Term& t, std::string_view what)
{
    Latex writer;
    const std::string whole = writer.run(t), first = fmt::format("% {}, {}\n", f.name, what);
    if (writer.parts().empty()) return first + whole + "\n";
    std::string lines;
    for (const Part& p : writer.parts()) lines += fmt::format("{} &= {} \\\\\n", p.name, p.text);
    return fmt::format("{}\\begin{{aligned}}\n{}\\text{{{}}} &= {}\n\\end{{aligned}}\n", first, lines, latex_text(f.name), whole);
}

std::string fpcore(const Formula& f, const Term& t, std::string_view what, std::string_view id)
{
    FPCore writer;
    std::string body = writer.run(t);
    if (!writer.parts().empty()) {
        std::string bindings;
        for (const Part& p : writer.parts()) bindings += fmt::format("{}[{} {}]", bindings.empty() ? "" : "\n        ", p.name, p.text);
        body = fmt::format("(let* ({})\n   {})", bindings, body);
    }
    return fmt::format("; {}, {}\n(FPCore ({})\n :name \"{}\"\n :precision binary64\n {})\n", f.name, what, fmt::join(f.inputs, " "), id,
                       body);
}

std::string sympy(const Term& t, std::string_view what, std::string_view id)
{
    SymPy writer;
    const std::string whole = writer.run(t);
    std::string symbols, parts;
    for (const Part& p : writer.parts()) {
        symbols += fmt::format("{0} = sympy.Symbol(\"{0}\", real=True)\n", p.name);
        parts += fmt::format("    ({}, {}),\n", p.name, p.text);
    }
    if (!parts.empty())
        parts = fmt::format("{}_parts = [  # what is used more than once, in order, as sympy.cse gives it\n{}]\n", id, parts);
    return fmt::format("{}{}{} = {}  # {}\n", symbols, parts, id, whole, what);
}

} // namespace

std::string mathematics(const Formula& f, std::string_view language)
{
    std::string text;
    if (language == "sympy") {
        text = "import sympy\n\n";
        for (const auto& input : f.inputs) text += fmt::format("{0} = sympy.Symbol(\"{0}\", positive=True)\n", input);
    }
    for (const bool printed : {false, true}) {
        if (printed && !f.printed) break;
        Expansion expanded;
        const Term t = expanded(printed ? *f.printed : f.stable);
        const std::string what = printed ? "as the paper prints it" : "free of cancellation";
        const std::string id = identifier(f.name) + (printed ? "_as_printed" : "");
        text += language == "latex" ? latex(f, t, what) : language == "fpcore" ? fpcore(f, t, what, id) : sympy(t, what, id);
    }
    return text;
}

} // namespace touchstone::formula
