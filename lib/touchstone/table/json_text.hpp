// SPDX-License-Identifier: MIT
/// \file
/// JSON from a file that anybody may have written.
#pragma once

#include <string_view>

namespace touchstone {

/// The text, or an empty one, which is no JSON, where brackets nest deeper than in any file of ours: nlohmann_json reads such a text and
/// then writes, copies or frees it by recursion, until the stack is used up.
inline std::string_view shallow(std::string_view json)
{
    constexpr int deepest = 64;
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '"') quoted = !quoted;
        else if (quoted) i += c == '\\' ? 1 : 0;
        else if (c == '[' || c == '{') ++depth;
        else if (c == ']' || c == '}') --depth;
        if (depth > deepest) return {};
    }
    return json;
}

} // namespace touchstone
