// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/table_1.hpp"

#include "proofs/ledger.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/catalogue/evaluate.hpp"

#include <fmt/format.h>

#include <sstream>

namespace touchstone::data {
std::string_view table_1_text();
}

namespace touchstone::proofs {
namespace {

PrintedNumber judge(std::string id, std::string printed, const Quantity& quantity, const Inputs& in)
{
    const auto point = printed.find('.');
    const long digits = static_cast<long>(printed.size() - point - 1); // all printed numbers here are 0.ddd
    const Evaluation precise = evaluate(quantity, in, {.digits = 20});
    PrintedNumber p{std::move(id), std::move(printed), precise.value, evaluate(quantity, in, {.digits = digits}).value};
    p.holds = p.printed == p.rounded;
    return p;
}

} // namespace

std::string_view table_1_text() { return data::table_1_text(); }

std::vector<PrintedNumber> check_table_1(std::string_view transcription)
{
    const Quantity& K = *find_quantity("archard.K");
    std::vector<PrintedNumber> all;
    std::istringstream lines{std::string(transcription)};
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words(line);
        long n = 0;
        std::string printed;
        words >> n >> printed;
        all.push_back(judge(fmt::format("table1.n{:02d}", n), printed, K, Inputs({{"n", Rational(n)}})));
    }
    return all;
}

namespace {

Finding judge_entry(const Print& p)
{
    const PrintedNumber e = check_table_1(p.text("n") + " " + p.text("rhs")).front();
    const std::string numbers = fmt::format("true value {}, rounded to as many digits {}", e.true_value, e.rounded);
    return Argument("certified evaluation, correct rounding")
        .add("the entry says what K_n rounds to",
             exactly(p.text("lhs") == "K_" + p.text("n") && p.text("relation") == "rounds to", p.text("lhs") + " " + p.text("relation")))
        .add("the printed digits are the correct rounding of K_n", {e.holds ? Verdict::verified : Verdict::refuted, numbers})
        .conclude(numbers);
}

/// The entry with its last digit raised or lowered by one.
Control last_digit(const Print& p, bool raised)
{
    const std::string& shown = p.text("rhs");
    const char last = shown.back();
    const char other = raised ? (last == '9' ? '8' : static_cast<char>(last + 1)) : (last == '0' ? '9' : static_cast<char>(last - 1));
    return {std::string("last digit ") + other, {{"rhs", shown, shown.substr(0, shown.size() - 1) + other}}};
}

} // namespace

std::vector<Claim> table_1()
{
    std::vector<Claim> all;
    for (const std::string& id : print_order())
        if (id.starts_with("table1.")) {
            const Print& p = prints().at(id);
            all.push_back({id,
                           p.text("lhs") + " = " + p.text("rhs"),
                           "Hertzian contact at every scale",
                           judge_entry,
                           {last_digit(p, true), last_digit(p, false)},
                           {},
                           {"7.13", "7.15", "7.16"}});
        }
    return all;
}

} // namespace touchstone::proofs
