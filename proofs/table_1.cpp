// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/table_1.hpp"

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
    p.leading = p.true_value.starts_with(p.printed);
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

PrintedNumber check_limit_7_20()
{
    return judge("text.limit-0.39139", "0.39139", *find_quantity("archard.K_inf"), Inputs());
}

} // namespace touchstone::proofs
