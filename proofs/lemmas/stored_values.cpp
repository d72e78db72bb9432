// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/stored_values.hpp"

#include "touchstone/table/format.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace touchstone::data {
std::string_view values_text();
}

namespace touchstone::proofs {

namespace {

constexpr slong digits_kept = 12;
constexpr slong bits_that_may_be_lost = 3; ///< by another version of Arb; whoever computes less than is stored has not confirmed it
constexpr slong bits_kept = 192;

struct State {
    bool recompute = false;
    std::map<std::string, Ball> computed;
    std::vector<std::string> used;
};

State& state() // the ledger judges one entry at a time
{
    static State s;
    return s;
}

const std::map<std::string, Ball>& stored()
{
    static const std::map<std::string, Ball> all = [] {
        std::map<std::string, Ball> m;
        for (auto& [name, ball] : read_values(data::values_text())) m.emplace(name, ball);
        return m;
    }();
    return all;
}

std::optional<Ball> parsed(const std::string& text)
{
    Ball b;
    if (arb_set_str(b.get(), text.c_str(), bits_kept) != 0) return std::nullopt;
    return b;
}

} // namespace

std::vector<std::pair<std::string, Ball>> read_values(std::string_view table)
{
    std::vector<std::pair<std::string, Ball>> all;
    std::istringstream lines{std::string(table)};
    std::string rows, wanted;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("# {")) wanted = nlohmann::json::parse(line.substr(2)).at("sha256");
        if (line.empty() || line.front() == '#') continue;
        rows += line + "\n";
        const std::size_t cut = line.find(" = ");
        const auto ball = cut == std::string::npos ? std::nullopt : parsed(line.substr(cut + 3));
        if (!ball) throw std::runtime_error("data/paper/values.txt: not an enclosure: " + line);
        all.emplace_back(line.substr(0, cut), *ball);
    }
    if (sha256(rows) != wanted)
        throw std::runtime_error(
            "data/paper/values.txt: the hash of its rows is not the one in its header; touchstone paper --values prints the table anew");
    return all;
}

void recompute_values(bool on)
{
    state().recompute = on;
    if (!on) state().computed.clear();
}

Ball stored_value(const std::string& name, const std::function<Ball()>& compute)
{
    State& s = state();
    s.used.push_back(name);
    if (!s.recompute) {
        const auto found = stored().find(name);
        if (found == stored().end())
            throw std::out_of_range("data/paper/values.txt has no row " + name + "; touchstone paper --values prints the table anew");
        return found->second;
    }
    const auto known = s.computed.find(name);
    if (known != s.computed.end()) return known->second;
    const Ball ball = compute();
    const auto as_read = parsed(ball.to_string(digits_kept)); // as it will be read, so that the verdicts are the same
    if (!as_read || !as_read->is_finite())
        throw std::runtime_error(name + ": computed " + ball.to_string(digits_kept) + ", which is no enclosure");
    return s.computed.emplace(name, *as_read).first->second;
}

std::vector<std::string> values_used()
{
    std::vector<std::string> used;
    used.swap(state().used);
    return used;
}

std::string difference(const Ball& stored, const Ball& computed)
{
    const bool vague = computed.relative_bits() < stored.relative_bits() - bits_that_may_be_lost; // of an exact number the largest there is
    if (!vague && stored.overlaps(computed)) return {};
    return (vague ? "computed only to " : "computed ") + computed.to_string(digits_kept) + ", stored " + stored.to_string(digits_kept);
}

std::vector<std::string> values_that_differ()
{
    std::vector<std::string> all;
    for (const auto& [name, ball] : state().computed) {
        const auto found = stored().find(name);
        if (found == stored().end()) all.push_back(name + ": computed, not stored");
        else if (const std::string wrong = difference(found->second, ball); !wrong.empty()) all.push_back(name + ": " + wrong);
    }
    for (const auto& [name, ball] : stored())
        if (!state().computed.count(name)) all.push_back(name + ": stored, and no verdict asks for it");
    return all;
}

std::string computed_table()
{
    std::string rows;
    for (const auto& [name, ball] : state().computed) rows += name + " = " + ball.to_string(digits_kept) + "\n";
    const nlohmann::ordered_json header = {{"name", "values"},
                                           {"rows", state().computed.size()},
                                           {"status", "certified"},
                                           {"command", "touchstone paper --values"},
                                           {"sha256", sha256(rows)}};
    return "# Enclosures that the ledger rests on and that take long to compute, proven; one row a value, [midpoint +/- radius].\n# " +
           header.dump() + "\n" + rows;
}

} // namespace touchstone::proofs
