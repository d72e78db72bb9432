// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/expression.hpp"

#include "touchstone/quadrature/expression_tree.hpp"

#include <boost/spirit/home/x3.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

namespace touchstone::quadrature {

ExpressionError::ExpressionError(std::size_t column, const std::string& what)
    : std::runtime_error("column " + std::to_string(column) + ": " + what)
    , column_(column)
{
}

namespace {

struct Function {
    Op op;
    std::size_t least, most; // number of arguments
};

const std::map<std::string, Function, std::less<>>& functions()
{
    static const std::map<std::string, Function, std::less<>> table = {
        {"exp", {Op::exp, 1, 1}},
        {"log", {Op::log, 1, 1}},
        {"ln", {Op::log, 1, 1}},
        {"sqrt", {Op::sqrt, 1, 1}},
        {"cbrt", {Op::cbrt, 1, 1}},
        {"abs", {Op::abs, 1, 1}},
        {"sign", {Op::sign, 1, 1}},
        {"floor", {Op::floor, 1, 1}},
        {"ceil", {Op::ceil, 1, 1}},
        {"max", {Op::max, 2, 64}},
        {"min", {Op::min, 2, 64}},
        {"pow", {Op::power, 2, 2}},
        {"sin", {Op::sin, 1, 1}},
        {"cos", {Op::cos, 1, 1}},
        {"tan", {Op::tan, 1, 1}},
        {"cot", {Op::cot, 1, 1}},
        {"sec", {Op::sec, 1, 1}},
        {"csc", {Op::csc, 1, 1}},
        {"sinh", {Op::sinh, 1, 1}},
        {"cosh", {Op::cosh, 1, 1}},
        {"tanh", {Op::tanh, 1, 1}},
        {"coth", {Op::coth, 1, 1}},
        {"sech", {Op::sech, 1, 1}},
        {"csch", {Op::csch, 1, 1}},
        {"asin", {Op::asin, 1, 1}},
        {"acos", {Op::acos, 1, 1}},
        {"atan", {Op::atan, 1, 1}},
        {"arcsin", {Op::asin, 1, 1}},
        {"arccos", {Op::acos, 1, 1}},
        {"arctan", {Op::atan, 1, 1}},
        {"asinh", {Op::asinh, 1, 1}},
        {"acosh", {Op::acosh, 1, 1}},
        {"atanh", {Op::atanh, 1, 1}},
        {"expm1", {Op::expm1, 1, 1}},
        {"log1p", {Op::log1p, 1, 1}},
        {"sinc", {Op::sinc, 1, 1}},
        {"gamma", {Op::gamma, 1, 1}},
        {"rgamma", {Op::rgamma, 1, 1}},
        {"lgamma", {Op::lgamma, 1, 1}},
        {"loggamma", {Op::lgamma, 1, 1}},
        {"digamma", {Op::digamma, 1, 1}},
        {"psi", {Op::digamma, 1, 1}},
        {"zeta", {Op::zeta, 1, 1}},
        {"erf", {Op::erf, 1, 1}},
        {"erfc", {Op::erfc, 1, 1}},
        {"erfi", {Op::erfi, 1, 1}},
        {"ei", {Op::ei, 1, 1}},
        {"si", {Op::si, 1, 1}},
        {"ci", {Op::ci, 1, 1}},
        {"li", {Op::li, 1, 1}},
        {"dilog", {Op::dilog, 1, 1}},
        {"airyai", {Op::airy_ai, 1, 1}},
        {"airybi", {Op::airy_bi, 1, 1}},
        {"lambertw", {Op::lambert_w, 1, 1}},
        {"ellipk", {Op::elliptic_k, 1, 1}},
        {"ellipe", {Op::elliptic_e, 1, 1}},
        {"besselj", {Op::bessel_j, 2, 2}},
        {"bessely", {Op::bessel_y, 2, 2}},
        {"besseli", {Op::bessel_i, 2, 2}},
        {"besselk", {Op::bessel_k, 2, 2}},
        {"polylog", {Op::polylog, 2, 2}},
        {"re", {Op::real_part, 1, 1}},
        {"im", {Op::imaginary_part, 1, 1}},
        {"conj", {Op::conjugate, 1, 1}},
        {"integral", {Op::integral, 4, 4}},
    };
    return table;
}

ExpressionPtr at(ExpressionPtr e, std::size_t column)
{
    Expression copy = *e;
    copy.column = column;
    return std::make_shared<const Expression>(std::move(copy));
}

namespace x3 = boost::spirit::x3;
using Text = std::string_view;
using Where = Text::const_iterator;

struct start_tag;

/// The column where the word begins that a semantic action was given.
template <class Context>
std::size_t column(const Context& context)
{
    return static_cast<std::size_t>(x3::_attr(context).begin() - x3::get<start_tag>(context).get()) + 1;
}

const auto take = [](auto& c) { x3::_val(c) = x3::_attr(c); };
const auto into = [](Op op) { return [op](auto& c) { x3::_val(c) = at(make(op, {x3::_val(c), x3::_attr(c)}), x3::_val(c)->column); }; };
const auto subtract = [](auto& c) {
    x3::_val(c) = at(make(Op::add, {x3::_val(c), make(Op::negate, {x3::_attr(c)})}), x3::_val(c)->column);
};
const auto negate = [](auto& c) { x3::_val(c) = make(Op::negate, {x3::_attr(c)}); };
const auto number = [](auto& c) {
    const auto& word = x3::_attr(c);
    const auto value = parse_rational(std::string_view(&*word.begin(), static_cast<std::size_t>(word.size())));
    if (!value) throw ExpressionError(column(c), "'" + std::string(word.begin(), word.end()) + "' is no number such as 12, 0.1 or 1e-4");
    x3::_val(c) = at(make_number(*value), column(c));
};
const auto name = [](auto& c) {
    const auto& word = x3::_attr(c);
    const std::string n(word.begin(), word.end());
    Expression e;
    e.column = column(c);
    if (n == "x")
        e.op = Op::variable;
    else if (n == "pi")
        e.op = Op::pi;
    else if (n == "e")
        e.op = Op::e;
    else if (n == "i")
        e.op = Op::imaginary_unit;
    else if (n == "inf")
        e.op = Op::infinity;
    else if (functions().contains(n))
        throw ExpressionError(e.column, "the function '" + n + "' needs its argument in brackets: " + n + "(...)");
    else {
        e.op = Op::parameter;
        e.name = n;
    }
    x3::_val(c) = std::make_shared<const Expression>(std::move(e));
};
using Call = std::pair<std::string, std::vector<ExpressionPtr>>;
const auto call_name = [](auto& c) {
    const auto& word = x3::_attr(c);
    const std::string n(word.begin(), word.end());
    const auto found = functions().find(n);
    if (found == functions().end()) throw ExpressionError(column(c), "no function '" + n + "' (a product needs its *: x*(1+x))");
    Expression e;
    e.op = found->second.op;
    e.name = n; // until its arguments are counted
    e.column = column(c);
    x3::_val(c) = std::make_shared<const Expression>(std::move(e));
};
const auto argument = [](auto& c) {
    Expression e = *x3::_val(c);
    e.args.push_back(x3::_attr(c));
    x3::_val(c) = std::make_shared<const Expression>(std::move(e));
};
const auto finish_call = [](auto& c) {
    Expression e = *x3::_attr(c);
    const std::string n = std::exchange(e.name, {});
    const Function& f = functions().find(n)->second;
    if (e.args.size() < f.least || e.args.size() > f.most)
        throw ExpressionError(e.column, n + " takes " + std::to_string(f.least) + (f.least == f.most ? "" : " or more") + " argument" +
                                            (f.least == 1 ? "" : "s") + ", not " + std::to_string(e.args.size()));
    x3::_val(c) = e.op == Op::power ? at(make(Op::power, e.args), e.column) : std::make_shared<const Expression>(std::move(e));
};

const x3::rule<struct sum_rule, ExpressionPtr> sum("a formula");
const x3::rule<struct product_rule, ExpressionPtr> product("a formula");
const x3::rule<struct unary_rule, ExpressionPtr> unary("a number, x, a function or '('");
const x3::rule<struct power_rule, ExpressionPtr> power("a number, x, a function or '('");
const x3::rule<struct primary_rule, ExpressionPtr> primary("a number, x, a function or '('");
const x3::rule<struct call_rule, ExpressionPtr> call("a function");
const x3::rule<struct callee_rule, ExpressionPtr> callee("a function");

// ascii: bytes beyond it are in no class, where the C library's classes take no negative number and ask the locale
const auto digits = +x3::ascii::digit;
const auto number_word =
    x3::raw[x3::lexeme[((digits >> -('.' >> *x3::ascii::digit)) | ('.' >> digits)) >> -(x3::char_("eE") >> -x3::char_("+-") >> digits)]];
const auto name_word = x3::raw[x3::lexeme[x3::ascii::alpha >> *(x3::ascii::alnum | '_')]];

const auto sum_def = product[take] >> *(('+' > product[into(Op::add)]) | ('-' > product[subtract]));
const auto product_def = unary[take] >> *((x3::lit('*') > unary[into(Op::multiply)]) | ('/' > unary[into(Op::divide)]));
const auto unary_def = ('-' > unary[negate]) | ('+' > unary[take]) | power[take];
const auto power_def = primary[take] >> -((x3::lit("**") | '^') > unary[into(Op::power)]);
const auto callee_def = (name_word >> &x3::lit('('))[([](auto& c) { call_name(c); })];
const auto call_def = callee[take] >> ('(' > sum[argument] > *(',' > sum[argument]) > ')');
const auto primary_def = number_word[number] | call[finish_call] | name_word[name] | ('(' > sum[take] > ')');

BOOST_SPIRIT_DEFINE(sum, product, unary, power, primary, call, callee)

} // namespace

std::vector<std::string> function_names()
{
    std::vector<std::string> names;
    for (const auto& [n, f] : functions()) names.push_back(n);
    return names;
}

namespace {

/// Functions and powers inside one another; more are no formula anybody integrates, and their proof would take minutes.
constexpr std::size_t deepest = 32;

void require_shallow(const Expression& e, std::size_t depth)
{
    const bool sum_or_product = e.op == Op::add || e.op == Op::multiply || e.op == Op::divide || e.op == Op::negate;
    if (!sum_or_product && !e.args.empty()) ++depth;
    if (depth > deepest) throw ExpressionError(e.column, "functions and powers nest deeper than " + std::to_string(deepest));
    for (const auto& a : e.args) require_shallow(*a, depth);
    if (e.integrand) require_shallow(*e.integrand, depth);
}

/// The same of the text, before it is parsed: with each bracket, each sign before a sign and each power of a power the parser goes deeper,
/// and a thread's stack has an end.
void require_shallow(std::string_view text)
{
    constexpr std::size_t most = 256;
    std::size_t brackets = 0, signs = 0, powers = 0;
    char before = '(';
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (std::isspace(static_cast<unsigned char>(c))) continue;
        const bool sign = c == '+' || c == '-', of_operand = sign && std::string_view("(,+-*/^").find(before) != std::string_view::npos;
        signs = of_operand ? signs + 1 : 0;
        if (c == '(') ++brackets;
        if (c == ')' && brackets > 0) --brackets;
        if (c == '^') ++powers;
        if (c == '*' || c == '/' || c == ',' || (sign && !of_operand)) powers = 0;
        const char* const what = brackets > most ? "brackets" : signs > most ? "signs" : powers > most ? "powers" : nullptr;
        if (what) throw ExpressionError(i + 1, std::string(what) + " nest deeper than " + std::to_string(most));
        before = c;
    }
}

} // namespace

ExpressionPtr parse_expression(std::string_view text, const Parameters& parameters)
{
    constexpr std::size_t longest = 4000;
    if (text.size() > longest) throw ExpressionError(longest, "the formula is longer than " + std::to_string(longest) + " characters");
    require_shallow(text);
    Where here = text.begin();
    const Where start = text.begin();
    ExpressionPtr result;
    try {
        if (!x3::phrase_parse(here, text.end(), x3::with<start_tag>(std::ref(start))[sum], x3::ascii::space, result))
            throw ExpressionError(static_cast<std::size_t>(here - start) + 1, "a number, x, a function or '(' is expected");
    }
    catch (const x3::expectation_failure<Where>& failure) {
        const auto position = static_cast<std::size_t>(failure.where() - start) + 1;
        const std::string expected = failure.which();
        throw ExpressionError(position,
                              (expected.starts_with('\'') ? expected : std::string("a number, x, a function or '('")) + " is expected");
    }
    if (here != text.end()) {
        const auto goes_on = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }; // a sign of several bytes, in UTF-8
        const std::string sign(here, std::find_if_not(here + 1, text.end(), goes_on));
        throw ExpressionError(static_cast<std::size_t>(here - start) + 1,
                              "an operator is expected before '" + sign + "' (a product needs its *)");
    }
    result = with_names_bound(result, parameters);
    require_shallow(*result, 0);
    return result;
}

bool is_free_name(std::string_view name)
{
    const bool word = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) &&
                      std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    return word && name != "x" && name != "pi" && name != "e" && name != "i" && name != "inf" && !functions().contains(name);
}

Parameter parse_parameter(std::string_view text)
{
    const auto number_at = [&](std::size_t from, std::size_t length) {
        const auto value = parse_rational(text.substr(from, length));
        if (!value) throw ExpressionError(from + 1, "a parameter is a number such as 0.5 or 1/3, or a ball: 0.5+/-1e-20");
        return *value;
    };
    const std::size_t sign = text.find("+/-");
    if (sign == std::string_view::npos) return {number_at(0, text.size()), 0};
    Parameter p{number_at(0, sign), number_at(sign + 3, std::string_view::npos)};
    if (p.radius < 0) throw ExpressionError(sign + 4, "the radius of a ball is not negative");
    return p;
}

} // namespace touchstone::quadrature
