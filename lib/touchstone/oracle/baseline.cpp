// SPDX-License-Identifier: MIT
#include "touchstone/oracle/baseline.hpp"

#include "touchstone/rounding/decimal.hpp"
#include "touchstone/table/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace touchstone::oracle {

using Json = nlohmann::ordered_json;

std::string row_key(const std::vector<double>& inputs)
{
    std::string key;
    for (const double x : inputs) {
        if (!key.empty()) key += ' ';
        key += hexfloat(x);
    }
    return key;
}

std::string Baseline::text() const
{
    std::string rows;
    for (const auto& [key, bound] : bounds) rows += fmt::format("{}\n{}: {}", rows.empty() ? "" : ",", Json(key).dump(), shortest(bound));
    return fmt::format("{{\"table\": {}, \"sha256\": {}, \"ulps\": {{{}\n}}}}\n", Json(table).dump(), Json(sha256).dump(), rows);
}

Baseline parse_baseline(std::string_view text, std::string_view file)
{
    const auto bad = [&](std::string_view what) { return BadBaseline(fmt::format("{}: not a baseline: {}", file, what)); };
    std::set<std::string> seen;
    std::string twice;
    const auto once = [&](int depth, nlohmann::json::parse_event_t event, Json& parsed) {
        if (event == nlohmann::json::parse_event_t::key && depth == 2 && !seen.insert(parsed.get<std::string>()).second) twice = parsed;
        return true;
    };
    const Json j = Json::parse(shallow(text), once, false);
    if (j.is_discarded()) throw bad("it is not JSON (NaN and Infinity are not either)");
    if (!twice.empty()) throw bad(fmt::format("row {} is there twice", twice));
    Baseline b;
    try {
        b.table = j.at("table").get<std::string>();
        b.sha256 = j.at("sha256").get<std::string>();
        for (const auto& [key, bound] : j.at("ulps").items()) {
            if (!bound.is_number()) throw bad(fmt::format("the bound of row {} is not a number", key));
            b.bounds[key] = bound.get<double>();
            if (!std::isfinite(b.bounds[key]) || b.bounds[key] < 0 || b.bounds[key] >= std::numeric_limits<double>::max())
                throw bad(fmt::format("the bound {} of row {} is not a finite number >= 0", bound.dump(), key));
        }
    }
    catch (const nlohmann::json::exception&) {
        throw bad("it needs table, sha256 and ulps");
    }
    return b;
}

std::vector<std::string> differences(const Baseline& before, const Baseline& after)
{
    std::vector<std::string> lines;
    for (const auto& [key, bound] : after.bounds) {
        const auto old = before.bounds.find(key);
        if (old == before.bounds.end()) lines.push_back(fmt::format("new      {}: {} ulps", key, shortest(bound)));
        else if (bound > old->second)
            lines.push_back(fmt::format("raised   {}: {} to {} ulps", key, shortest(old->second), shortest(bound)));
        else if (bound < old->second)
            lines.push_back(fmt::format("lowered  {}: {} to {} ulps", key, shortest(old->second), shortest(bound)));
    }
    for (const auto& [key, bound] : before.bounds)
        if (!after.bounds.contains(key)) lines.push_back(fmt::format("gone     {}: {} ulps", key, shortest(bound)));
    return lines;
}

} // namespace touchstone::oracle
