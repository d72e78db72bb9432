// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/page.hpp"

#include "touchstone/table/format.hpp"
#include "verify/report/mathml.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>

namespace touchstone::data { // compiled in, see verify/CMakeLists.txt
std::string_view report_style_text();
std::string_view report_filter_text();
} // namespace touchstone::data

namespace touchstone::program::report {
namespace {

std::string base64(const std::string& bytes)
{
    std::string out(4 * ((bytes.size() + 2) / 3) + 1, '\0');
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(out.data()), reinterpret_cast<const unsigned char*>(bytes.data()),
                                       static_cast<int>(bytes.size()));
    out.resize(static_cast<std::size_t>(length));
    return out;
}

std::string data_uri(const char* type, const std::string& bytes) { return fmt::format("data:{};base64,{}", type, base64(bytes)); }

/// A caption's A_n, x_(n-1), γ^(D-1) with their indices set low and high.
std::string typeset(const std::string& caption)
{
    std::string out;
    bool code = false;
    for (std::size_t at = 0; at < caption.size(); ++at) {
        const char c = caption[at];
        if (c == '`') {
            out += code ? "</code>" : "<code>";
            code = !code;
            continue;
        }
        if ((c != '_' && c != '^') || at + 1 >= caption.size()) {
            out += escaped(std::string(1, c));
            continue;
        }
        const bool bracketed = caption[at + 1] == '(';
        const std::size_t from = at + (bracketed ? 2U : 1U);
        std::size_t to = from + 1;
        if (bracketed) to = std::min(caption.find(')', from), caption.size());
        else
            while (to < caption.size() && (static_cast<unsigned char>(caption[to]) & 0xc0U) == 0x80U)
                ++to; // the rest of one UTF-8 character
        const char* tag = c == '_' ? "sub" : "sup";
        out += fmt::format("<{0}>{1}</{0}>", tag, escaped(caption.substr(from, to - from)));
        at = bracketed ? to : to - 1;
    }
    return out;
}

std::string figure_html(const Drawn& d)
{
    const figures::Figure& f = d.figure;
    const auto download = [&f](const char* ending, const char* type, const std::string& bytes) {
        return fmt::format("<a download=\"{0}.{1}\" href=\"{2}\">{1}</a>", f.id, ending, data_uri(type, bytes));
    };
    return fmt::format(
        "<figure id=\"{}\">\n<picture><source media=\"(max-width: 640px)\" srcset=\"{}\"><img src=\"{}\" alt=\"{}\"></picture>\n"
        "<figcaption><b>{}.</b> {} <span class=\"status\">Points: {}.</span> <span class=\"command\"><code>touchstone paper {} --svg FILE "
        "--csv FILE</code></span> "
        "<span class=\"files\">{} {} {}</span></figcaption>\n</figure>\n",
        f.id, data_uri("image/svg+xml", d.narrow), data_uri("image/svg+xml", d.wide), escaped(f.alternative), typeset(f.title),
        typeset(f.caption), escaped(figures::status_line(f)), f.id, download("svg", "image/svg+xml", d.wide),
        download("pdf", "application/pdf", d.pdf), download("csv", "text/csv", figures::csv(f)));
}

/// A drawing that a phone scrolls sideways: it was made for a page.
std::string scrolled(const std::string& drawing, const char* alternative)
{
    if (drawing.empty()) return "";
    return fmt::format("<div class=\"scroll\"><img class=\"wide\" src=\"{}\" alt=\"{}\"></div>\n", data_uri("image/svg+xml", drawing),
                       alternative);
}

std::string judged(const Contents& c)
{
    const std::string drawing = scrolled(
        c.judged_drawing,
        "Error of the formula as printed over what is allowed, against x, load, 1 - load and the distance from the edge of the contact");
    return judged_section(c.judged, drawing.empty()
                                        ? ""
                                        : drawing + "<p>The first of them as <code>judge --svg</code> draws it. Above 1 a row fails; near "
                                                    "the edge of the contact the inputs' own rounding forces most of the error.</p>\n");
}

std::string contents(const std::vector<Drawn>& drawn)
{
    std::string html = "<nav aria-label=\"Contents\"><ul>";
    for (const Drawn& d : drawn) html += fmt::format("<li><a href=\"#{}\">{}</a></li>", d.figure.id, typeset(d.figure.title));
    return html + "<li><a href=\"#table1\">Table 1</a></li><li><a href=\"#judged\">Judged codes</a></li><li><a "
                  "href=\"#erratum\">Erratum</a></li><li><a href=\"#ledger\">Ledger</a></li></ul></nav>\n";
}

std::string section(const char* id, const char* title, const std::string& command, const std::string& body)
{
    return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n<p class=\"command\"><code>{}</code></p>\n{}</section>\n", id, title,
                       escaped(command), body);
}

} // namespace

std::string page(const Contents& c)
{
    const auto& drawn = c.drawn;
    const auto& ledger = c.ledger;
    std::string of_paper, beyond;
    for (const Drawn& d : drawn) (d.of_paper ? of_paper : beyond) += figure_html(d);
    std::string html = fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                                   "content=\"width=device-width, initial-scale=1\">\n"
                                   "<meta name=\"color-scheme\" content=\"light dark\">\n<title>Linear elastic contact of the Weierstrass "
                                   "profile, checked</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n",
                                   data::report_style_text());
    html += fmt::format("<header><h1>Linear elastic contact of the Weierstrass profile, checked</h1>\n<p>Ciavarella, Demelio, Barber &amp; "
                        "Jang, <cite>Proc. R. Soc. Lond. A</cite> <b>456</b> (2000) 387–405: its figures redrawn from "
                        "certified values, its Table 1, and a verdict on each of its {} checkable statements: {}. Loads are p̃ = "
                        "p̄/p*<sub>0</sub>, lengths in λ<sub>0</sub>, pressures in p*<sub>0</sub>. "
                        "<em>Certified</em> means proven: every source of error is bounded. Made by touchstone {}; <code>touchstone report "
                        "--out DIR</code> makes this page anew.</p></header>\n",
                        ledger.size(), tally(ledger), version());
    html += contents(drawn);
    html += section("figures", "The paper's figures", "touchstone report --out DIR", of_paper);
    html += section("table1", "Table 1", "touchstone paper table1.n07", table_1_section());
    html += section("beyond", "What the paper could not show", "touchstone report --out DIR", beyond);
    html += section("judged", "Judged codes", "touchstone judge TABLE --svg FILE -- COMMAND", judged(c));
    html += section("erratum", "Erratum", "touchstone paper --errata html", erratum_section(ledger));
    html += section("ledger", "The ledger", "touchstone paper", ledger_section(ledger));
    html += fmt::format("</main>\n<script>\n{}</script>\n</body>\n</html>\n", data::report_filter_text());
    return html;
}

} // namespace touchstone::program::report
