// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_fields.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace touchstone::proofs {

using nlohmann::json;

json::parser_callback_t no_key_twice(const Place& at)
{
    return [at, keys = std::vector<std::set<std::string>>()](int, json::parse_event_t event, json& parsed) mutable {
        if (event == json::parse_event_t::object_start) keys.emplace_back();
        if (event == json::parse_event_t::object_end) keys.pop_back();
        if (event == json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
            at.fail("the key '" + parsed.get<std::string>() + "' comes twice in one object");
        return true;
    };
}

void only(const json& object, std::initializer_list<const char*> keys, const Place& at)
{
    if (!object.is_object()) at.fail("an object { ... } is wanted, not " + object.dump().substr(0, 40));
    for (const auto& [key, value] : object.items())
        if (std::none_of(keys.begin(), keys.end(), [&](const char* k) { return key == k; })) {
            std::string known;
            for (const char* k : keys) known += std::string(known.empty() ? "" : ", ") + k;
            at.fail("no key '" + key + "' is known here; " + known);
        }
}

const std::string& of_some_length(const std::string& text, const Place& at)
{
    constexpr std::size_t longest = 4000;
    if (text.size() > longest) at.fail("'" + text.substr(0, 40) + "...' is longer than " + std::to_string(longest) + " characters");
    return text;
}

std::string text(const json& object, const char* key, const Place& at, const std::string& otherwise)
{
    if (!object.contains(key)) return otherwise;
    if (!object[key].is_string()) at.fail(std::string("'") + key + "' wants a string, not " + object[key].dump().substr(0, 40));
    return of_some_length(object[key], at);
}

json list(const json& object, const char* key, const Place& at)
{
    if (!object.contains(key)) return json::array();
    if (!object[key].is_array()) at.fail(std::string("'") + key + "' is a list [ ... ], not " + object[key].dump().substr(0, 40));
    return object[key];
}

std::string digits(const json& value, const Place& at)
{
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float())
        at.fail("a number with a point or an exponent, or a very long one, stands in quotes, \"0.1\", not as " + value.dump());
    return value.dump();
}

Rational number(const json& value, const Place& at)
{
    const std::string t = digits(value, at);
    const auto r = parse_rational(t);
    if (!r) at.fail("not an exact number: " + t);
    return *r;
}

std::pair<Rational, Rational> range(const json& value, const Place& at)
{
    if (!value.is_array() || value.size() != 2) at.fail("a range is [low, high], not " + value.dump().substr(0, 40));
    const std::pair<Rational, Rational> r{number(value[0], at), number(value[1], at)};
    if (!(r.first < r.second)) at.fail("an empty range " + value.dump());
    return r;
}

} // namespace touchstone::proofs
