// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/errata.hpp"
#include "proofs/table_1.hpp"
#include "touchstone/table/json_text.hpp"
#include "verify/exit_codes.hpp"
#include "verify/report/mathml.hpp"
#include "verify/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace touchstone::program::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array verdicts{"refuted", "undecided", "qualitative", "argued", "proved", "verified", "definition"};

std::string text_at(const Json& entry, const char* key)
{
    return entry.contains(key) && entry[key].is_string() ? entry[key].get<std::string>() : "";
}

/// How grave a refuted entry is: what the ledger says, else what kind of fault it is.
std::string severity(const Json& entry)
{
    const std::string said = text_at(entry, "severity");
    return said.empty() ? text_at(entry, "fault") : said;
}

bool is_sentence(const Json& entry)
{
    return text_at(entry, "print").find('$') != std::string::npos || text_at(entry, "print").find('\\') == std::string::npos;
}

/// A print as the paper has it: an equation, or a sentence in quotation marks.
std::string printed(const Json& entry)
{
    const std::string print = text_at(entry, "print");
    if (print.empty()) return "";
    if (is_sentence(entry)) return "<blockquote><p>" + prose(print) + "</p></blockquote>";
    return "<div class=\"equation\">" + formula(print, true) + "</div>";
}

std::string term(const char* title, const std::string& html)
{
    return html.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>", title, html);
}

std::string list_of(const Json& entry, const char* key)
{
    if (!entry.contains(key) || entry[key].empty()) return "";
    std::string items;
    for (const auto& step : entry[key]) items += "<li>" + escaped(step.get<std::string>()) + "</li>";
    return "<ol>" + items + "</ol>";
}

std::string controls_of(const Json& entry)
{
    if (!entry.contains("controls") || entry["controls"].empty()) return "";
    std::string items;
    for (const auto& c : entry["controls"])
        items += fmt::format("<li>{}: {}</li>", escaped(text_at(c, "what")), escaped(text_at(c, "verdict")));
    return "<ul>" + items + "</ul>";
}

std::string links_of(const Json& entry, const std::set<std::string>& ids)
{
    std::string text;
    if (entry.contains("rests_on"))
        for (const auto& id : entry["rests_on"]) {
            const std::string name = id.get<std::string>();
            text += (text.empty() ? "" : ", ") +
                    (ids.contains(name) ? fmt::format("<a href=\"#entry-{0}\">{0}</a>", escaped(name)) : escaped(name));
        }
    return text;
}

/// Where the judge of an entry stands, with the lemmas and the rows of data it asked: file and line.
std::string source_of(const Json& entry)
{
    std::string html;
    const auto add = [&html](const std::string& place) { html += (html.empty() ? "<code>" : "<br><code>") + escaped(place) + "</code>"; };
    if (const std::string judge = text_at(entry, "judge"); !judge.empty()) add(judge);
    for (const char* key : {"lemmas", "rows"})
        if (entry.contains(key))
            for (const auto& place : entry[key])
                add((std::string(key) == "rows" ? "data/paper/values.txt: " : "") + place.get<std::string>());
    return html;
}

std::string entry_html(const Json& entry, const std::set<std::string>& ids)
{
    const std::string id = text_at(entry, "id"), verdict = text_at(entry, "verdict"), kind = severity(entry),
                      command = "touchstone paper " + id;
    std::string body = printed(entry);
    body += "<dl>" + term("assuming", escaped(text_at(entry, "assumptions"))) + term("reason", escaped(text_at(entry, "reason")));
    if (verdict == "refuted") {
        body += term("goes wrong", escaped(text_at(entry, "wrong")));
        body += term("holds",
                     escaped(text_at(entry, "correction")) +
                         (text_at(entry, "correction_verdict").empty() ? "" : " (" + escaped(text_at(entry, "correction_verdict")) + ")"));
        body += term("consequence", escaped(text_at(entry, "consequence")));
    }
    body += term("method", escaped(text_at(entry, "method"))) + term("steps", list_of(entry, "steps")) +
            term("changed prints", controls_of(entry)) + term("rests on", links_of(entry, ids)) + term("judged by", source_of(entry)) +
            term("regenerate", "<code>" + escaped(command) + "</code>") + "</dl>";
    return fmt::format("<details class=\"entry\" id=\"entry-{0}\" data-verdict=\"{1}\" data-severity=\"{2}\"><summary><span class=\"badge "
                       "{1}\">{1}</span>{3} <b>{0}</b> "
                       "<span class=\"statement\">{4}</span></summary>{5}</details>\n",
                       escaped(id), escaped(verdict), escaped(kind),
                       kind.empty() ? "" : " <span class=\"kind\">" + escaped(kind) + "</span>", escaped(text_at(entry, "statement")),
                       body);
}

std::string box(const char* group, const std::string& value, std::size_t count)
{
    return fmt::format("<label><input type=\"checkbox\" data-filter=\"{0}\" value=\"{1}\" checked> {1} ({2})</label>\n", group,
                       escaped(value), count);
}

} // namespace

Json parse_ledger(const std::string& text, const std::string& file)
{
    Json ledger = Json::parse(shallow(text), nullptr, false);
    const auto list = [](const Json& e, const char* key, auto of) {
        return !e.contains(key) || (e[key].is_array() && std::all_of(e[key].begin(), e[key].end(), of));
    };
    const auto good = [&list](const Json& e) {
        const auto text = [](const Json& item) { return item.is_string(); };
        return e.is_object() && e.contains("id") && e["id"].is_string() && e.contains("verdict") && e["verdict"].is_string() &&
               list(e, "steps", text) && list(e, "rests_on", text) && list(e, "lemmas", text) && list(e, "rows", text) &&
               list(e, "controls", [](const Json& item) { return item.is_object(); });
    };
    if (!ledger.is_array() || ledger.empty() || !std::all_of(ledger.begin(), ledger.end(), good))
        throw Failure(bad_input, fmt::format("{}: not what `touchstone paper --json` writes", file));
    return ledger;
}

std::string tally(const Json& ledger)
{
    std::map<std::string, int> count;
    for (const auto& e : ledger) ++count[text_at(e, "verdict")];
    std::string text;
    for (const char* v : verdicts)
        if (count.contains(v)) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count[v], v);
    return text;
}

std::string ledger_section(const Json& ledger)
{
    std::map<std::string, std::size_t> by_verdict, by_severity;
    std::set<std::string> ids;
    for (const auto& e : ledger) {
        ++by_verdict[text_at(e, "verdict")];
        if (!severity(e).empty()) ++by_severity[severity(e)];
        ids.insert(text_at(e, "id"));
    }
    std::string html = "<fieldset class=\"filter\"><legend>Verdict</legend>\n";
    for (const char* v : verdicts)
        if (by_verdict.contains(v)) html += box("verdict", v, by_verdict[v]);
    html += "</fieldset>\n<fieldset class=\"filter\"><legend>What is wrong with a refuted one</legend>\n";
    for (const auto& [value, count] : by_severity) html += box("severity", value, count);
    html += "</fieldset>\n<p class=\"shown\" id=\"shown\" aria-live=\"polite\"></p>\n";
    for (const auto& e : ledger) html += entry_html(e, ids);
    return html;
}

std::string erratum_section(const Json& ledger)
{
    // what `paper --errata html` prints, without its frame
    std::string whole = proofs::errata("html");
    for (const auto& e : ledger) { // each equation leads to its entry
        const std::string id = escaped(text_at(e, "id")), heading = "<dt>(" + id + ")";
        if (const auto at = whole.find(heading); at != std::string::npos)
            whole.replace(at, heading.size(), fmt::format("<dt><a href=\"#entry-{0}\">({0})</a>", id));
    }
    const auto from = whole.find("<dl>"), to = whole.rfind("</dl>");
    if (from == std::string::npos || to == std::string::npos) throw Failure(internal_error, "the erratum has no list of equations");
    std::string html = "<h3>Equations</h3>\n<p>The forms to read are proved; both columns of symbols are set from the transcription and "
                       "its proved correction.</p>\n<dl class=\"errata\">" +
                       whole.substr(from + 4, to - from - 4) + "</dl>\n";
    std::string sentences;
    for (const auto& e : ledger) {
        if (text_at(e, "verdict") != "refuted" || !is_sentence(e)) continue;
        sentences += fmt::format(
            "<div class=\"erratum\"><h4><a href=\"#entry-{0}\">{0}</a> <span class=\"kind\">{1}</span></h4>{2}<dl>{3}{4}</dl></div>\n",
            escaped(text_at(e, "id")), escaped(severity(e)), printed(e), term("wrong", escaped(text_at(e, "wrong"))),
            term("holds", escaped(text_at(e, "correction"))));
    }
    return sentences.empty() ? html : html + "<h3>Sentences</h3>\n" + sentences;
}

std::string table_1_section()
{
    std::string rows;
    std::size_t right = 0, all = 0;
    for (const auto& n : proofs::check_table_1(proofs::table_1_text())) {
        if (!n.id.starts_with("table1.")) continue;
        const long scale = std::stol(n.id.substr(n.id.find_last_not_of("0123456789") + 1));
        rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td "
                            "class=\"number\">{}</td><td>{}</td><td><code>touchstone eval archard.K n={}</code></td></tr>\n",
                            scale, escaped(n.printed), escaped(n.true_value), n.holds ? "right" : "<b>wrong</b>", scale);
        right += n.holds ? 1U : 0U;
        ++all;
    }
    return fmt::format(
        "<p>{} of {} printed values are right in every digit. Certified values are correctly rounded to 20 digits.</p>\n<div "
        "class=\"scroll\"><table><thead><tr><th>n</th><th>printed</th>"
        "<th>certified K<sub>n</sub></th><th>verdict</th><th>regenerate</th></tr></thead><tbody>\n{}</tbody></table></div>\n",
        right, all, rows);
}

} // namespace touchstone::program::report
