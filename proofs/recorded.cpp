// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/recorded.hpp"

#include "proofs/severity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace touchstone::data {
std::string_view verdicts_text();
}

namespace touchstone::proofs {

std::string_view recorded_text() { return data::verdicts_text(); }

namespace {

/// "[0.33333333 +/- 3.34e-9]" as 0.333333: no more than six digits, and fewer where the ball says less, so that other versions of Arb write
/// the same.
std::string rounded(double middle, double radius)
{
    constexpr double most_digits = 6, nothing_known = 0.3; // of itself
    if (std::fabs(radius) > nothing_known * std::fabs(middle)) return "about 0";
    const double known = radius == 0 ? most_digits : -std::log10(radius / std::fabs(middle)) - 1;
    return fmt::format("{:.{}g}", middle, static_cast<int>(std::clamp(known, 1.0, most_digits)));
}

std::string without_radii(const std::string& text)
{
    static const std::regex ball(R"(\[([-+.0-9e]*) ?\+/- ([-+.0-9e]+)\])");
    std::string out;
    auto from = text.begin();
    for (std::sregex_iterator m(text.begin(), text.end(), ball), end; m != end; ++m) {
        out.append(from, text.begin() + m->position());
        out += (*m)[1].length() == 0 ? "about 0" : rounded(std::stod((*m)[1].str()), std::stod((*m)[2].str()));
        from = text.begin() + m->position() + m->length();
    }
    out.append(from, text.end());
    static const std::regex exact(
        R"(([0-9]+)(?:\.0{5,}|(\.[0-9]*[1-9])0{4,})(?![0-9e]))"); // "2.0000000" and "0.50000000", which another version may have as balls
    return std::regex_replace(out, exact, "$1$2");
}

bool has_a_number(const std::string& text) { return text.find_first_of("0123456789") != std::string::npos; }

/// What a step's check said, if that has a number in it: no control can see a bound that became weaker and still holds, nor a range made
/// smaller. How many pieces a subdivision took is left out: that is Arb's affair.
std::string numbers_of(const Finding& f)
{
    static const std::regex said(R"(\[(?:proved|verified|argued): (.*)\]$)"), pieces(R"(^enclosed for (.*) in [0-9]+ pieces(.*)$)");
    std::string all;
    for (const std::string& step : f.steps) {
        std::smatch m, range;
        if (!std::regex_search(step, m, said)) continue;
        const std::string detail = m[1].str();
        if (std::regex_match(detail, range, pieces)) all += "  range: " + without_radii(range[1].str() + range[2].str()) + "\n";
        else if (has_a_number(detail)) all += "  says: " + without_radii(detail) + "\n";
    }
    return all;
}

/// What is said of a sentence in the end, and by what each of its controls, or of a table's, is refuted: a wrong counterexample may refute
/// all the same.
std::string counterexamples_of(const Entry& e)
{
    const std::string& id = e.claim->id;
    if (!id.starts_with("text.") && !id.starts_with("figure") && !id.starts_with("table")) return {};
    std::string all;
    if (!id.starts_with("table") && has_a_number(e.finding.reason)) all += "  concludes: " + without_radii(e.finding.reason) + "\n";
    for (const auto& c : e.controls) all += "  control, " + c.what + ": " + without_radii(c.finding.reason) + "\n";
    return all;
}

} // namespace

std::string recorded_form(const std::vector<CheckedLemma>& lemmas)
{
    std::ostringstream out;
    out << "# What our own lemmas rest on, held by tests/proofs/operator.cpp: no control can see a smaller range, or a bound that became "
           "weaker and still holds.\n";
    for (const CheckedLemma& e : lemmas) {
        out << e.claim->id << " " << name(e.finding.verdict) << "\n  " << e.statement << "\n" << numbers_of(e.finding);
        for (const auto& control : e.controls) out << "  control: " << control.what << "\n";
    }
    return out.str();
}

std::string recorded_form(const std::vector<Entry>& entries)
{
    std::ostringstream out;
    out << "# The verdicts of the ledger, written by touchstone paper --verdicts. A change of this file is a change of what we say of the "
           "paper.\n";
    for (const Entry& e : entries) {
        const auto& c = e.claim->correction;
        out << e.claim->id << " " << name(e.finding.verdict);
        if (c) out << " " << severity(*c);
        out << "\n";
        if (!same_as(e.claim->id).empty()) out << "  same as: " << same_as(e.claim->id) << "\n";
        if (c) out << "  wrong: " << c->wrong << "\n  holds, " << name(e.corrected->verdict) << ": " << c->corrected << "\n";
        if (c && !c->consequence.empty()) out << "  consequence: " << c->consequence << "\n";
        if (!caveat(e.claim->id).empty()) out << "  caveat: " << caveat(e.claim->id) << "\n";
        if (!e.finding.method.empty()) out << "  by: " << e.finding.method << "\n";
        for (const std::string& lemma : e.finding.lemmas) out << "  lemma: " << lemma.substr(0, lemma.find(':')) << "\n";
        out << numbers_of(e.finding) << counterexamples_of(e);
        if (!e.finding.rows.empty()) out << "  stored values: " << e.finding.rows.size() << "\n";
    }
    return out.str();
}

Verdict expected_verdict(const std::string& id)
{
    static const std::map<std::string, std::string> recorded = [] {
        std::map<std::string, std::string> all;
        std::istringstream lines(std::string{recorded_text()});
        for (std::string line; std::getline(lines, line);) { // "ID verdict ...", what is indented says more
            if (line.empty() || line[0] == '#' || line[0] == ' ') continue;
            std::istringstream words(line);
            std::string entry, verdict;
            words >> entry >> verdict;
            all[entry] = verdict;
        }
        return all;
    }();
    const std::string& wanted = recorded.at(id);
    for (const Verdict v : {Verdict::proved, Verdict::verified, Verdict::argued, Verdict::refuted, Verdict::definition,
                            Verdict::qualitative, Verdict::undecided})
        if (name(v) == wanted) return v;
    throw std::out_of_range("not a verdict: " + wanted);
}

} // namespace touchstone::proofs
