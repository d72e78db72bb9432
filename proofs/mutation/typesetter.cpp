// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/mutation/typesetter.hpp"

#include "proofs/symbols.hpp"

#include <cctype>
#include <map>
#include <regex>
#include <set>

namespace touchstone::proofs {

namespace {

const std::set<std::string> functions{"sin", "cos", "asin", "acos", "atan", "sqrt", "log", "exp", "tgamma", "pow", "abs"};

struct Text {
    std::string kind, text;
};

struct Token {
    std::size_t at, length;
    std::string text;
};

std::vector<Token> tokens(const std::string& text)
{
    static const std::regex token(R"(\d+(\.\d+)?|[A-Za-z_]\w*|[-+*/^()])");
    std::vector<Token> all;
    for (std::sregex_iterator it(text.begin(), text.end(), token), end; it != end; ++it)
        all.push_back({static_cast<std::size_t>(it->position()), static_cast<std::size_t>(it->length()), it->str()});
    return all;
}

/// Every name that occurs in the transcription.
const std::set<std::string>& names_in_print()
{
    static const std::set<std::string> all = [] {
        std::set<std::string> names;
        if (!paper_alphabet_in_use()) {
            for (const auto& [name, kind] : alphabet().symbols) names.insert(name);
            return names;
        }
        for (const auto& [id, p] : prints())
            if (p.quote.empty())
                for (const auto& [field, text] : p.fields)
                    if (field.ends_with("hs") || field.ends_with("term") || field.ends_with("integrand") || field.ends_with("argument") ||
                        field.ends_with(".of"))
                        for (const Token& t : tokens(text))
                            if (std::isalpha(static_cast<unsigned char>(t.text[0])) && !functions.count(t.text)) names.insert(t.text);
        return names;
    }();
    return all;
}

/// The same letter with another index, as far as the paper has it.
std::vector<std::string> other_indices(const std::string& name)
{
    const std::size_t cut = name.find('_');
    if (cut == std::string::npos) return {};
    std::vector<std::string> all;
    for (const char* index : {"_n", "_nm1", "_np1", "_0", "_1", ""}) {
        const std::string other = name.substr(0, cut) + index;
        if (other != name && names_in_print().count(other)) all.push_back(other);
    }
    return all;
}

std::vector<std::string> neighbours(const std::string& name)
{
    std::vector<std::string> all;
    for (const auto& group : alphabet().alike)
        for (const std::string& member : group)
            if (member == name)
                for (const std::string& other : group)
                    if (other != name) all.push_back(other);
    return all;
}

std::string raised(const std::string& number, int by)
{
    std::string s = number;
    char& last = s.back();
    if (by > 0) last = last == '9' ? '8' : static_cast<char>(last + 1);
    else last = last == '0' ? '1' : static_cast<char>(last - 1);
    return s;
}

/// The changes of one expression, or of a condition.
std::vector<Text> changed(const std::string& text, bool whole_factors)
{
    std::vector<Text> all;
    const std::vector<Token> ts = tokens(text);
    const auto put = [&](const char* kind, const Token& t, const std::string& by) {
        all.push_back({kind, text.substr(0, t.at) + by + text.substr(t.at + t.length)});
    };
    const auto without = [&](const char* kind, std::size_t from, std::size_t to) {
        all.push_back({kind, text.substr(0, from) + text.substr(to)});
    };
    static const std::map<std::string, std::string> other_function{{"sin", "cos"},   {"cos", "sin"}, {"asin", "acos"},
                                                                   {"acos", "asin"}, {"log", "exp"}, {"tgamma", "log"}};
    for (std::size_t i = 0; i < ts.size(); ++i) {
        const Token& t = ts[i];
        const std::string before = i > 0 ? ts[i - 1].text : "", after = i + 1 < ts.size() ? ts[i + 1].text : "";
        const char c = t.text[0];
        if (std::isdigit(static_cast<unsigned char>(c))) {
            for (const int by : {1, -1}) put("digit", t, raised(t.text, by));
            if (t.text == "2" && after == "*") without("factor", t.at, ts[i + 1].at + 1);
            if (t.text == "2" && (before == "*" || before == "/") && after != "^") without("factor", ts[i - 1].at, t.at + 1);
            if (t.text == "2" && before == "^") without("lost square", ts[i - 1].at, t.at + 1);
        } else if (c == '+' || c == '-') {
            const bool leading = before.empty() || before == "(";
            if (leading) without("sign", t.at, t.at + 1);
            else put("sign", t, c == '+' ? "-" : "+");
        } else if (c == '/') {
            put("fraction", t, "*");
        } else if (c == '^' && text.compare(t.at, 6, "^(1/2)") == 0) {
            without("lost root", t.at, t.at + 6);
        } else if (t.text == "Pi") {
            if (after == "*") without("factor", t.at, ts[i + 1].at + 1);
            else if (before == "*" || before == "/") without("factor", ts[i - 1].at, t.at + 2);
            put("factor", t, "2*Pi");
        } else if (t.text == "sqrt") {
            put("lost root", t, "");
        } else if (functions.count(t.text)) {
            if (const auto other = other_function.find(t.text); other != other_function.end()) put("function", t, other->second);
        } else if (std::isalpha(static_cast<unsigned char>(c)) && t.text != "infinity" && t.text != "or") {
            for (const std::string& other : other_indices(t.text)) put("index", t, other);
            for (const std::string& other : neighbours(t.text)) put("symbol", t, other);
        } else if (t.text == "infinity") {
            put("bound", t, "n");
            put("bound", t, "1");
        }
    }
    if (whole_factors) {
        all.push_back({"factor", "2*(" + text + ")"});
        all.push_back({"factor", "Pi*(" + text + ")"});
        all.push_back({"sign", "-(" + text + ")"});
    }
    for (std::size_t i = 0; i < text.size(); ++i) { // a condition: its direction, and whether the point of equality belongs to it
        if (text[i] != '<' && text[i] != '>') continue;
        all.push_back({"condition", text.substr(0, i) + (text[i] == '<' ? '>' : '<') + text.substr(i + 1)});
        const bool closed = i + 1 < text.size() && text[i + 1] == '=';
        all.push_back({"condition", text.substr(0, i + 1) + (closed ? "" : "=") + text.substr(i + (closed ? 2 : 1))});
    }
    return all;
}

std::vector<Text> changed_relation(const std::string& relation)
{
    static const std::map<std::string, std::vector<std::string>> others{
        {"=", {"<", ">"}},        {"==", {"<", ">"}}, {"<", {">", "=", "<="}}, {">", {"<", "=", ">="}}, {"<=", {">=", "<", "="}},
        {">=", {"<=", ">", "="}}, {"~", {"="}},       {"->", {"="}},           {"rounds to", {"="}}};
    std::vector<Text> all;
    if (const auto found = others.find(relation); found != others.end())
        for (const std::string& r : found->second) all.push_back({"relation", r});
    return all;
}

/// Does it read as the same expression? Then nothing was changed.
bool reads_the_same(const std::string& a, const std::string& b)
{
    if (a == b) return true;
    try {
        return GiNaC::normal(GiNaC::expand(read(a) - read(b))).is_zero();
    } catch (const std::exception&) {
        return false;
    }
}

bool is_expression(const std::string& field)
{
    for (const char* end :
         {".lhs", ".rhs", ".term", ".integrand", ".argument", ".from", ".to", ".of", ".by", ".variable", ".index", ".far", ".at_infinity"})
        if (field.ends_with(end)) return true;
    return false;
}

} // namespace

std::vector<Change> typesetters_changes(const Print& print)
{
    std::vector<Change> all;
    std::set<std::string> seen;
    const auto make = [&](const std::string& label, const std::vector<std::string>& fields, const Text& t) {
        const std::string name = label + ": " + t.text;
        if (!seen.insert(name).second) return;
        Print changed_print = print;
        for (const std::string& f : fields) changed_print.fields[f] = t.text;
        all.push_back({name, t.kind, std::move(changed_print)});
    };
    for (const auto& [field, text] : print.fields) {
        if (field.ends_with(".relation")) {
            for (const Text& t : changed_relation(text)) make(field, {field}, t);
        } else if (field.ends_with(".condition")) {
            for (const Text& t : changed(text, false)) make(field, {field}, t);
        } else if (field.ends_with(".digits")) {
            for (const Text& t : changed(text, false)) make(field, {field}, t);
        } else if (is_expression(field)) {
            const bool whole = field.ends_with(".rhs") || field.ends_with("term") || field.ends_with("integrand");
            const std::size_t part = std::isdigit(static_cast<unsigned char>(field[0])) ? std::stoul(field) : 0;
            const std::string next = std::to_string(part + 1) + ".lhs";
            const bool chained = field == std::to_string(part) + ".rhs" && print.fields.count(next) && print.fields.at(next) == text;
            for (const Text& t : changed(text, whole)) {
                if (reads_the_same(text, t.text)) continue;
                make(field, {field}, t);
                if (chained) make(field + "=" + next, {field, next}, t);
            }
        }
    }
    return all;
}

} // namespace touchstone::proofs
