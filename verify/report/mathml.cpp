// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/mathml.hpp"

#include "verify/figures/tool.hpp"

#include <map>
#include <optional>
#include <regex>

namespace touchstone::program::report {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
    return text;
}

/// The inside of `<math>`, or nothing.
std::optional<std::string> markup(const std::string& tex)
{
    const auto answer = figures::run_tool({"blahtexml", "--mathml"}, tex);
    if (!answer || !answer->succeeded) return std::nullopt;
    const std::string open = "<markup>", close = "</markup>";
    const auto from = answer->output.find(open), to = answer->output.find(close);
    if (from == std::string::npos || to == std::string::npos) return std::nullopt;
    // a length of MathML Core has a unit
    const std::string inside = answer->output.substr(from + open.size(), to - from - open.size());
    return replaced(replaced(replaced(inside, "space=\"0\"", "space=\"0em\""), "width=\"0\"", "width=\"0em\""), "\n", "");
}

} // namespace

std::string escaped(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else if (c == '"') out += "&quot;";
        else out += c;
    }
    return out;
}

std::string formula(const std::string& tex, bool display)
{
    static std::map<std::string, std::optional<std::string>> known;
    auto found = known.find(tex);
    if (found == known.end()) found = known.emplace(tex, markup(tex)).first;
    if (!found->second) return "<code class=\"tex\">" + escaped(tex) + "</code>";
    return std::string("<math") + (display ? " display=\"block\"" : "") + ">" + *found->second + "</math>";
}

namespace {

/// What the print has in bold or italics, **4** and *et al.* in the transcription.
std::string emphasised(const std::string& words)
{
    static const std::regex bold(R"(\*\*([^*]+)\*\*)"), italics(R"(\*([^*]+)\*)");
    return std::regex_replace(std::regex_replace(escaped(words), bold, "<strong>$1</strong>"), italics, "<em>$1</em>");
}

} // namespace

std::string prose(const std::string& text)
{
    std::string out;
    bool inside = false;
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t to = std::min(text.find('$', from), text.size());
        const std::string piece = text.substr(from, to - from);
        if (!piece.empty()) out += inside ? formula(piece, false) : emphasised(piece);
        inside = !inside;
        from = to + 1;
    }
    return out;
}

} // namespace touchstone::program::report
