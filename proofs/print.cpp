// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/print.hpp"

#include "proofs/symbols.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace touchstone::data {
std::string_view equations_text();
std::string_view sentences_text();
std::string_view beyond_text();
std::string_view table_1_text();
} // namespace touchstone::data

namespace touchstone::proofs {

ex sym(const std::string& name)
{
    static std::map<std::string, ex> all;
    const auto found = all.find(name);
    if (found != all.end()) return found->second;
    const auto kind = alphabet().symbols.find(name); // one that is not listed is positive
    const ex made = kind != alphabet().symbols.end() && kind->second.real ? ex(GiNaC::realsymbol(name)) : ex(GiNaC::possymbol(name));
    return all.emplace(name, made).first->second;
}

namespace {

/// Puts the operands of a formula in place from the innermost outwards, and stops before a number that would be too long is made of them.
class Bounded : public GiNaC::map_function {
public:
    /// \param least_bits of a base without numbers: 0, if high powers of it are left as they are
    Bounded(GiNaC::exmap operands, double least_bits) : operands_(std::move(operands)), least_bits_(least_bits) {}

    ex operator()(const ex& e) override
    {
        if (const auto found = operands_.find(e); found != operands_.end()) return found->second;
        if (GiNaC::is_a<GiNaC::power>(e)) {
            const ex base = (*this)(e.op(0)), exponent = (*this)(e.op(1));
            if (base.is_equal(e.op(0)) && exponent.is_equal(e.op(1))) return e;
            if (GiNaC::is_a<GiNaC::numeric>(exponent) && magnitude(exponent) * std::max(least_bits_, bits(base)) > most_bits) refuse();
            return GiNaC::pow(base, exponent);
        }
        const bool factorial = GiNaC::is_the_function<GiNaC::tgamma_SERIAL>(e);
        const ex made = factorial ? (*this)(e.op(0)) : e.map(*this);
        if (factorial && GiNaC::is_a<GiNaC::numeric>(made) && magnitude(made) > most_argument) refuse();
        if (bits(made) > most_bits) refuse();
        return factorial ? ex(GiNaC::tgamma(made)) : made;
    }

private:
    static constexpr double most_bits = 100'000, most_argument = 1000;

    [[noreturn]] static void refuse() { throw std::length_error("a number of it is too long"); }
    static double magnitude(const ex& x) { return std::abs(GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(x)).to_double()); }
    /// Of the longest number in e.
    static double bits(const ex& e)
    {
        if (GiNaC::is_a<GiNaC::numeric>(e)) {
            const auto& x = GiNaC::ex_to<GiNaC::numeric>(e);
            double most = 0;
            for (const GiNaC::numeric& part : {x.real(), x.imag()})
                if (part.is_rational()) most = std::max<double>(most, std::max(part.numer().int_length(), part.denom().int_length()));
            return most;
        }
        double most = 0;
        for (std::size_t i = 0; i < e.nops(); ++i) most = std::max(most, bits(e.op(i)));
        return most;
    }

    GiNaC::exmap operands_;
    double least_bits_;
};

/// GiNaC evaluates numbers while it reads: 9^9^8 takes it a minute, tgamma(10^9) longer. So the formula is read first with a symbol of its
/// own for each operand, of which nothing is evaluated. \throws std::length_error
void must_be_of_bearable_size(const std::string& text, const std::set<std::string>& functions)
{
    static const std::regex operand(R"(\d+(?:\.\d*)?(?:[eE][-+]?\d+)?|[A-Za-z_]\w*)"), number_with_exponent(R"(\d[\d.]*[eE].*)");
    GiNaC::symtab table;
    GiNaC::exmap operands;
    std::string form;
    std::size_t at = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), operand), end; it != end; ++it) {
        const std::string word = it->str();
        form += text.substr(at, static_cast<std::size_t>(it->position()) - at);
        at = static_cast<std::size_t>(it->position() + it->length());
        if (functions.count(word)) {
            form += word;
            continue;
        }
        const std::string name = "operand" + std::to_string(table.size());
        const GiNaC::symbol stands(name);
        table[name] = stands;
        form += " " + name + " ";
        if (std::regex_match(word, number_with_exponent)) throw std::invalid_argument("a number with an exponent is not exact");
        if (std::isdigit(static_cast<unsigned char>(word[0]))) {
            const auto value = parse_rational(word);
            operands[stands] = GiNaC::numeric(value->get_num().get_str().c_str()) / GiNaC::numeric(value->get_den().get_str().c_str());
        }
    }
    form += text.substr(at);
    Bounded evaluate(std::move(operands), 1);
    evaluate(GiNaC::parser(table, true)(form));
}

/// GiNaC's parser ends the program at a function of nothing, `sqrt()`; what it takes for a comment may stand between the brackets.
void must_call_functions_of_something(const std::string& text)
{
    static const std::regex nothing_between(R"(\(\s*\))");
    if (std::regex_search(text, nothing_between)) throw std::invalid_argument("there is nothing between two brackets");
    if (text.find('#') != std::string::npos) throw std::invalid_argument("a formula has no comments");
}

/// Where the operand that begins at `at` ends, with its powers: a name, a number, a bracket, a function with its bracket.
std::size_t end_of_operand(const std::string& text, std::size_t at)
{
    const auto past = [&](std::size_t i, const auto& is) {
        while (i < text.size() && is(static_cast<unsigned char>(text[i]))) ++i;
        return i;
    };
    const auto is_blank = [](unsigned char c) { return std::isspace(c) != 0; };
    while (true) {
        const std::size_t begin = past(at, is_blank);
        std::size_t end = past(begin, [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.'; });
        if (const std::size_t bracket = past(end, is_blank); bracket < text.size() && text[bracket] == '(') {
            int depth = 0;
            for (end = bracket; end < text.size(); ++end) {
                depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
                if (depth == 0) break;
            }
            if (end++ == text.size()) throw std::invalid_argument("a bracket is not closed");
        }
        if (end == begin) throw std::invalid_argument("a sign of nothing");
        const std::size_t power = past(end, is_blank);
        if (power == text.size() || text[power] != '^') return end;
        at = power + 1;
    }
}

/// After an operator GiNaC takes all that follows for the operand of a sign, and 10^-3*x for 10^(-3*x). So brackets are put around each
/// such sign with its operand, from the last one on: what follows a sign has none left that is not in brackets.
std::string with_signs_in_brackets(std::string text)
{
    static const std::string operators = "^*/+-", signs = "+-";
    for (std::size_t i = text.size(); i-- > 0;) {
        if (signs.find(text[i]) == std::string::npos) continue;
        std::size_t before = i;
        while (before > 0 && std::isspace(static_cast<unsigned char>(text[before - 1]))) --before;
        if (before == 0 || operators.find(text[before - 1]) == std::string::npos) continue;
        text.insert(end_of_operand(text, i + 1), ")");
        text.insert(i, "(");
    }
    return text;
}

} // namespace

ex with_put_in(const ex& e, const GiNaC::exmap& with)
{
    if (std::none_of(with.begin(), with.end(), [&](const auto& one) { return e.has(one.first); })) return e;
    return Bounded(with, 0)(e);
}

ex read(const std::string& as_written)
{
    must_call_functions_of_something(as_written);
    const std::string text = with_signs_in_brackets(as_written);
    // Decimals as exact fractions: GiNaC would read a float.
    static const std::regex decimal(R"((\d+)\.(\d*))"), identifier(R"([A-Za-z_]\w*)");
    std::string exact;
    std::string rest = text;
    for (std::smatch m; std::regex_search(rest, m, decimal); rest = m.suffix()) {
        exact += m.prefix().str() + "(" + m[1].str() + m[2].str() + "/1" + std::string(m[2].str().size(), '0') + ")";
    }
    exact += rest;
    // GiNaC's names of numbers are symbols here, under a name that nothing in the formula has: a moment of inertia I is no imaginary unit.
    static const std::regex number_of_ginac(R"(\b(I|Euler|Catalan)\b)");
    std::string prefix = "symbol_";
    while (exact.find(prefix) != std::string::npos) prefix += "_";
    exact = std::regex_replace(exact, number_of_ginac, prefix + "$1");
    static const std::set<std::string> functions = {"sin", "cos", "asin",   "acos", "atan", "sqrt",
                                                    "log", "exp", "tgamma", "pow",  "Pi",   "abs"};
    if (!paper_alphabet_in_use()) must_be_of_bearable_size(text, functions);
    GiNaC::symtab table;
    for (std::sregex_iterator it(exact.begin(), exact.end(), identifier), end; it != end; ++it) {
        const std::string name = it->str();
        if (!functions.count(name)) table[name] = sym(name.starts_with(prefix) ? name.substr(prefix.size()) : name);
    }
    GiNaC::parser parser(table, true);
    return parser(exact);
}

std::string Print::full_name(const std::string& field)
{
    return field.find('.') == std::string::npos ? "0." + field : field;
}

const std::string& Print::text(const std::string& field) const
{
    const auto found = fields.find(full_name(field));
    if (found == fields.end()) throw std::out_of_range(id + " has no field " + field);
    return found->second;
}

Rational Print::rational(const std::string& field) const
{
    const auto value = parse_rational(text(field));
    if (!value) throw std::invalid_argument(id + ": not a number: " + text(field));
    return *value;
}

std::size_t Print::parts() const
{
    std::size_t n = 0;
    while (fields.count(std::to_string(n) + ".rhs")) ++n;
    return n;
}

std::vector<ex> Print::sides(const std::string& field) const
{
    std::vector<ex> out;
    const std::string& t = text(field);
    std::string side;
    for (const char c : t + "<") {
        if (c == '<' || c == '>' || c == '=') {
            if (side.find_first_not_of(' ') != std::string::npos) out.push_back(read(side));
            side.clear();
        } else {
            side += c;
        }
    }
    return out;
}

Print Print::edited(const std::vector<Edit>& edits) const
{
    Print changed = *this;
    for (const Edit& e : edits) {
        const auto field = changed.fields.find(full_name(e.field));
        if (field == changed.fields.end()) throw std::invalid_argument(id + " has no field " + e.field);
        const std::size_t at = field->second.find(e.from);
        if (at == std::string::npos) throw std::invalid_argument(id + ": '" + e.from + "' is not in " + field->second);
        field->second.replace(at, e.from.size(), e.to);
    }
    return changed;
}

namespace {

struct Transcription {
    std::map<std::string, Print> prints;
    std::vector<std::string> order;

    void take(std::string_view text)
    {
        for (const auto& record : nlohmann::json::parse(text)) {
            Print p;
            p.id = record.at("id");
            p.section = record.at("section");
            p.tex = record.value("tex", "");
            p.domain = record.value("domain", "");
            p.quote = record.value("quote", "");
            p.statement = record.value("claim", "");
            if (record.contains("machine")) {
                const auto& machine = record["machine"];
                for (std::size_t i = 0; i < machine["parts"].size(); ++i)
                    for (const auto& [key, value] : machine["parts"][i].items()) p.fields[std::to_string(i) + "." + key] = value;
                if (machine.contains("pieces"))
                    for (const auto& [piece, content] : machine["pieces"].items())
                        for (const auto& [key, value] : content.items()) p.fields[piece + "." + key] = value;
            }
            order.push_back(p.id);
            prints.emplace(p.id, std::move(p));
        }
    }
    /// The rows "n K_n" as K_n = number, with the ids table1.n00, ...
    void take_table(std::string_view text)
    {
        std::istringstream lines{std::string(text)};
        for (std::string line; std::getline(lines, line);) {
            if (line.empty() || line.front() == '#') continue;
            std::istringstream words(line);
            std::string n, printed;
            words >> n >> printed;
            Print p;
            p.id = "table1.n" + std::string(n.size() < 2 ? "0" : "") + n;
            p.section = "table 1";
            p.tex = "K_{" + n + "} = " + printed;
            p.fields = {{"0.lhs", "K_" + n}, {"0.relation", "rounds to"}, {"0.rhs", printed}, {"0.n", n}};
            order.push_back(p.id);
            prints.emplace(p.id, std::move(p));
        }
    }
    Transcription()
    {
        take(data::equations_text());
        take_table(data::table_1_text());
        take(data::sentences_text());
        take(data::beyond_text());
    }
};

const Transcription& transcription()
{
    static const Transcription all;
    return all;
}

} // namespace

const std::map<std::string, Print>& prints() { return transcription().prints; }
const std::vector<std::string>& print_order() { return transcription().order; }

} // namespace touchstone::proofs
