// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_values.hpp"

#include "proofs/own/own_sides.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include <algorithm>
#include <functional>
#include <regex>

namespace touchstone::proofs {

namespace {

bool is_outside(const std::string& function, const Ball& argument)
{
    if (!argument.is_finite()) return false;
    if (function == "sqrt") return certainly(less(argument, Ball(0)));
    if (function == "log") return !possibly(less(Ball(0), argument));
    return certainly(less(Ball(1), abs(argument)));
}

/// What stands in the bracket that begins at `at`; all of the rest where it is not closed.
std::string in_bracket(const std::string& text, std::size_t at)
{
    int depth = 0;
    for (std::size_t end = at; end < text.size(); ++end) {
        depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
        if (depth == 0) return text.substr(at + 1, end - at - 1);
    }
    return text.substr(at + 1);
}

/// Each call in the text, those inside of others too. They are looked for in the text itself: what is read has them no more.
bool has_an_argument_outside(const std::string& text, const std::function<Ball(const ex&)>& value_of)
{
    static const std::regex limited(R"(\b(asin|acos|log|sqrt)\s*\()");
    return std::any_of(std::sregex_iterator(text.begin(), text.end(), limited), {}, [&](const std::smatch& call) {
        const auto bracket = static_cast<std::size_t>(call.position() + call.length() - 1);
        return is_outside(call[1], value_of(read(in_bracket(text, bracket))));
    });
}

/// The sides, part by part: what may be simplified away.
std::vector<std::string> sides_of(const Print& p)
{
    std::vector<std::string> all;
    for (const auto& [field, text] : p.fields)
        if (field.ends_with("lhs") || field.ends_with("rhs")) all.push_back(text);
    return all;
}

} // namespace

bool surely_has_no_value(const OwnLedger& ledger, const std::string& text, const Point& at)
{
    return has_an_argument_outside(text, [&](const ex& e) { return evaluate(written_out(ledger, e), at); });
}

bool surely_has_no_value(const std::string& text, const Point& at)
{
    return has_an_argument_outside(text, [&](const ex& e) { return evaluate(e, at); });
}

std::optional<Check> value_forbids(const OwnLedger& ledger, const OwnEntry& e, const Print& p)
{
    for (const std::string& text : sides_of(p)) {
        std::optional<Point> without;
        bool has_one = false;
        for (const Point& point : points_all_over(ledger)) {
            if (condition_at(ledger, p, "0.", {}, point) == Truth::no) continue;
            if (surely_has_no_value(ledger, text, point)) without = point;
            else has_one = true;
        }
        if (without && (!has_one || !e.over.empty()))
            return Check{Verdict::undecided, "'" + text + "' has no real value at " + as_text(*without)};
    }
    return std::nullopt;
}

} // namespace touchstone::proofs
