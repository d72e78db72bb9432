// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/named_inputs.hpp"

#include "touchstone/scalar/exact_text.hpp"
#include "touchstone/scalar/rational_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace touchstone {
namespace {

constexpr std::size_t shown_characters = 60; ///< of a value in a message

bool among(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string shown(const std::string& text) { return text.size() > shown_characters ? text.substr(0, shown_characters) + "..." : text; }

DomainError no_number(const std::string& key, const std::string& text)
{
    return DomainError(fmt::format("{} = '{}' {}", key, shown(text), why_not_rational(text)));
}

/// G = base^(1/degree) > 1 as the pair that means the same surface.
void put_root(std::map<std::string, Rational>& values, const std::string& text, const Exact& G)
{
    Root root;
    try {
        root = as_root(G);
    }
    catch (const NotExact&) {
        throw DomainError(fmt::format("G = {}: too long to be held exactly", shown(text)));
    }
    const auto& [base, degree] = root;
    if (base <= 1) throw DomainError(fmt::format("G = {}: must be > 1", shown(text)));
    values["gamma"] = base;
    values["D"] = 1 + Rational(1, degree);
}

} // namespace

void check_keys(const Quantity& q, const std::vector<std::string>& keys)
{
    const std::string wanted = q.inputs.empty() ? "no inputs" : fmt::format("{}", fmt::join(q.inputs, ", "));
    const bool surface = among(q.inputs, "G");
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const std::string& key = keys[k];
        if (!among(q.inputs, key) && !(surface && (key == "D" || key == "gamma"))) {
            if (key == "G" && among(q.inputs, "D") && among(q.inputs, "gamma"))
                throw WrongKeys(fmt::format("G does not determine {}; it takes {}", q.name, wanted));
            throw WrongKeys(fmt::format("unknown key '{}'; {} takes {}", shown(key), q.name, wanted));
        }
        if (std::find(keys.begin(), keys.begin() + static_cast<long>(k), key) != keys.begin() + static_cast<long>(k))
            throw WrongKeys(fmt::format("key '{}' is given twice", key));
    }
    const bool pair = among(keys, "D") && among(keys, "gamma");
    if (surface && among(keys, "G") && (among(keys, "D") || among(keys, "gamma")))
        throw WrongKeys("give either G or D and gamma, not both");
    for (const auto& key : q.inputs)
        if (!among(keys, key) && !(key == "G" && pair))
            throw WrongKeys(fmt::format("missing key '{}'{}; {} takes {}", key, key == "G" ? " (or D and gamma)" : "", q.name, wanted));
}

Inputs read_inputs(const Quantity& q, const NamedTexts& given)
{
    std::vector<std::string> keys;
    for (const auto& [key, text] : given) keys.push_back(key);
    check_keys(q, keys);
    std::map<std::string, Rational> values;
    for (const auto& [key, text] : given) {
        const auto value = parse_exact(text);
        if (!value) throw no_number(key, text);
        if (value->is_rational()) values[key] = value->rational();
        else if (key == "G") put_root(values, text, *value);
        else throw DomainError(fmt::format("{} = '{}' is irrational: only G may be", key, shown(text)));
    }
    return Inputs(values);
}

} // namespace touchstone
