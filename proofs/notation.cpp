// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/notation.hpp"

#include <cctype>
#include <map>
#include <stdexcept>
#include <vector>

namespace touchstone::proofs {

namespace {

/// The few constructions of a formula, in TeX or in MathML.
class Writer {
public:
    explicit Writer(Notation n) : mathml_(n == Notation::mathml) {}
    std::string number(const std::string& s) const { return mathml_ ? "<mn>" + s + "</mn>" : s; }
    std::string letter(const char* tex, const char* unicode) const
    {
        return mathml_ ? std::string("<mi>") + unicode + "</mi>" : std::string(tex);
    }
    std::string word(const std::string& s) const { return mathml_ ? "<mtext>" + s + "</mtext>" : "\\text{" + s + "}"; }
    std::string sign(const char* tex, const char* unicode) const
    {
        return mathml_ ? std::string("<mo>") + unicode + "</mo>" : std::string(tex);
    }
    std::string group(const std::string& s) const { return mathml_ ? "<mrow>" + s + "</mrow>" : "{" + s + "}"; }
    std::string fraction(const std::string& a, const std::string& b) const
    {
        return mathml_ ? "<mfrac>" + group(a) + group(b) + "</mfrac>" : "\\frac" + group(a) + group(b);
    }
    std::string root(const std::string& a) const { return mathml_ ? "<msqrt>" + a + "</msqrt>" : "\\sqrt" + group(a); }
    std::string power(const std::string& a, const std::string& b) const
    {
        return mathml_ ? "<msup>" + group(a) + group(b) + "</msup>" : group(a) + "^" + group(b);
    }
    std::string index(const std::string& a, const std::string& b) const
    {
        return mathml_ ? "<msub>" + group(a) + group(b) + "</msub>" : a + "_" + group(b);
    }
    std::string accent(const std::string& a, const char* tex, const char* unicode) const
    {
        return mathml_ ? "<mover>" + group(a) + "<mo>" + unicode + "</mo></mover>" : std::string(tex) + group(a);
    }
    std::string bracketed(const std::string& a) const
    {
        return mathml_ ? "<mrow><mo>(</mo>" + a + "<mo>)</mo></mrow>" : "\\left(" + a + "\\right)";
    }
    std::string apply(const char* name, const std::string& a) const
    {
        return (mathml_ ? std::string("<mi>") + name + "</mi>" : std::string("\\") + name + " ") + bracketed(a);
    }
    std::string big(const char* tex, const char* unicode, const std::string& below, const std::string& above) const
    {
        return mathml_ ? std::string("<munderover><mo>") + unicode + "</mo>" + group(below) + group(above) + "</munderover>"
                       : std::string(tex) + "_" + group(below) + "^" + group(above) + " ";
    }

private:
    bool mathml_;
};

class Parser {
public:
    Parser(const std::string& text, const Print& print, Notation n) : text_(text), print_(print), notation_(n), w_(n) {}
    std::string whole()
    {
        const std::string s = sum();
        if (at_ != text_.size()) throw std::invalid_argument("not a formula: " + text_);
        return s;
    }

private:
    char peek()
    {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c)
    {
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    std::string sum()
    {
        std::string s = take('-') ? w_.sign("-", "\u2212") + product() : product();
        while (true) {
            if (take('+')) s += w_.sign("+", "+") + product();
            else if (take('-')) s += w_.sign("-", "\u2212") + product();
            else return s;
        }
    }
    /// a*b/c: the factors before the stroke over those behind it.
    std::string product()
    {
        const bool bracket = peek() == '(';
        const std::size_t first = at_;
        std::string above = power(), below;
        if (bracket && peek() == '/' && text_[at_ - 1] == ')' && closes(first) == at_ - 1) { // a numerator needs no brackets
            at_ = first;
            above = atom(true);
        }
        while (true) {
            if (take('*')) {
                if (!below.empty()) {
                    above = w_.fraction(above, below);
                    below.clear();
                }
                above += notation_ == Notation::tex ? " " + power() : power();
            } else if (take('/')) {
                strip_ = true;
                below += power();
                strip_ = false;
            } else {
                return below.empty() ? above : w_.fraction(above, below);
            }
        }
    }
    /// The place of the bracket that closes the one at `from`.
    std::size_t closes(std::size_t from) const
    {
        int open = 0;
        for (std::size_t i = from; i < text_.size(); ++i) {
            open += text_[i] == '(' ? 1 : text_[i] == ')' ? -1 : 0;
            if (open == 0) return i;
        }
        return std::string::npos;
    }
    std::string power()
    {
        const bool bare = strip_;
        strip_ = false;
        const std::size_t from = at_;
        std::string base = atom(false);
        const bool raised = peek() == '^';
        if (!raised && bare) { // a denominator needs no brackets
            at_ = from;
            base = atom(true);
        }
        if (!take('^')) return base;
        const std::string exponent = take('-') ? w_.sign("-", "\u2212") + atom(true) : atom(true);
        return w_.power(base, exponent);
    }
    std::string atom(bool bare)
    {
        const char c = peek();
        if (take('(')) {
            const std::string inside = sum();
            if (!take(')')) throw std::invalid_argument("a bracket is open in " + text_);
            return bare ? inside : w_.bracketed(inside);
        }
        std::string name;
        if (std::isdigit(static_cast<unsigned char>(c))) {
            while (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) || text_[at_] == '.')) name += text_[at_++];
            return w_.number(name);
        }
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) name += text_[at_++];
        if (name.empty()) throw std::invalid_argument("not a formula: " + text_);
        if (peek() == '(') return function(name);
        if (print_.has(name + ".kind")) return piece(name);
        return symbol(name);
    }
    std::string function(const std::string& name)
    {
        const std::string argument = atom(true);
        if (name == "sqrt") return w_.root(argument);
        if (name == "tgamma") return w_.letter("\\Gamma", "\u0393") + w_.bracketed(argument);
        static const std::map<std::string, const char*> names{{"sin", "sin"},     {"cos", "cos"}, {"asin", "arcsin"},
                                                              {"acos", "arccos"}, {"log", "ln"},  {"exp", "exp"}};
        const auto found = names.find(name);
        if (found == names.end()) throw std::invalid_argument("no notation for the function " + name);
        return w_.apply(found->second, argument);
    }
    std::string piece(const std::string& name)
    {
        const auto field = [&](const char* f) { return in_notation(print_.text(name + "." + f), print_, notation_); };
        const std::string& kind = print_.text(name + ".kind");
        if (kind == "sum" || kind == "product") {
            const std::string below = field("index") + w_.sign("=", "=") + field("from");
            return (kind == "sum" ? w_.big("\\sum", "\u2211", below, field("to")) : w_.big("\\prod", "\u220f", below, field("to"))) +
                   field("term");
        }
        if (kind == "integral")
            return w_.big("\\int", "\u222b", field("from"), field("to")) + field("integrand") + w_.letter("\\,d", "d") + field("variable");
        if (kind == "function") return in_notation(print_.text(name + ".of"), print_, notation_) + w_.bracketed(field("argument"));
        throw std::invalid_argument("no notation for " + kind);
    }
    std::string symbol(const std::string& name)
    {
        const std::size_t cut = name.find('_');
        const std::string base = name.substr(0, cut), index = cut == std::string::npos ? "" : name.substr(cut + 1);
        std::string star;
        std::string s = base;
        const auto ends = [&](const char* tail) { return base.size() > std::string(tail).size() && base.ends_with(tail); };
        const auto stem = [&](const char* tail) { return letter(base.substr(0, base.size() - std::string(tail).size())); };
        if (ends("bar")) s = w_.accent(stem("bar"), "\\bar", "\u00af");
        else if (ends("tilde")) s = w_.accent(stem("tilde"), "\\tilde", "~");
        else if (ends("hat")) s = w_.accent(stem("hat"), "\\hat", "^");
        else if (ends("star")) star = w_.sign("*", "*"), s = stem("star");
        else if (ends("max")) star = w_.letter("\\max", "max"), s = stem("max");
        else s = letter(base);
        if (!index.empty()) s = w_.index(s, subscript(index));
        return star.empty() ? s : w_.power(s, star);
    }
    std::string subscript(const std::string& index)
    {
        if (index == "nm1") return letter("n") + w_.sign("-", "\u2212") + w_.number("1");
        if (index == "np1") return letter("n") + w_.sign("+", "+") + w_.number("1");
        return std::isdigit(static_cast<unsigned char>(index[0])) ? w_.number(index) : letter(index);
    }
    std::string letter(const std::string& name)
    {
        static const std::map<std::string, std::pair<const char*, const char*>> greek{
            {"Pi", {"\\pi", "\u03c0"}},         {"alpha", {"\\alpha", "\u03b1"}},   {"beta", {"\\beta", "\u03b2"}},
            {"gamma", {"\\gamma", "\u03b3"}},   {"delta", {"\\delta", "\u03b4"}},   {"epsilon", {"\\epsilon", "\u03b5"}},
            {"lambda", {"\\lambda", "\u03bb"}}, {"nu", {"\\nu", "\u03bd"}},         {"xi", {"\\xi", "\u03be"}},
            {"rho", {"\\rho", "\u03c1"}},       {"infinity", {"\\infty", "\u221e"}}};
        if (const auto found = greek.find(name); found != greek.end()) return w_.letter(found->second.first, found->second.second);
        if (name.size() == 2 && std::isdigit(static_cast<unsigned char>(name[1])))
            return w_.index(letter(name.substr(0, 1)), w_.number(name.substr(1))); // I1
        return name.size() == 1 ? w_.letter(name.c_str(), name.c_str()) : w_.word(name);
    }

    const std::string& text_;
    const Print& print_;
    Notation notation_;
    Writer w_;
    std::size_t at_ = 0;
    bool strip_ = false;
};

} // namespace

std::string in_notation(const std::string& formula, const Print& print, Notation n) { return Parser(formula, print, n).whole(); }

std::string relation_in_notation(const std::string& relation, Notation n)
{
    static const std::map<std::string, std::pair<const char*, const char*>> signs{
        {"=", {"=", "="}},          {"==", {"\\equiv", "\u2261"}}, {"<", {"<", "&lt;"}},       {">", {">", "&gt;"}},
        {"<=", {"\\le", "\u2264"}}, {">=", {"\\ge", "\u2265"}},    {"->", {"\\to", "\u2192"}}, {"~", {"\\approx", "\u2248"}}};
    const auto found = signs.find(relation);
    if (found == signs.end()) throw std::invalid_argument("no notation for the relation " + relation);
    return n == Notation::tex ? std::string(" ") + found->second.first + " " : std::string("<mo>") + found->second.second + "</mo>";
}

} // namespace touchstone::proofs
