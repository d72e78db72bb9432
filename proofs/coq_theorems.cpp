// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/coq_theorems.hpp"

#include <map>
#include <sstream>
#include <stdexcept>

namespace touchstone::data {
std::string_view coq_text();
}

namespace touchstone::proofs {

const CoqTheorem* coq_theorem(const std::string& id)
{
    static const std::map<std::string, CoqTheorem> theorems = [] {
        std::map<std::string, CoqTheorem> all;
        std::istringstream lines{std::string(data::coq_text())};
        for (std::string line; std::getline(lines, line);) {
            if (line.empty() || line.front() == '#') continue;
            std::istringstream words(line);
            std::string entry, extent;
            CoqTheorem t;
            words >> entry >> extent >> t.theorem >> t.file >> std::ws;
            std::getline(words, t.sense);
            if (t.file.empty() || (extent != "whole" && extent != "part")) throw std::logic_error("data/paper/coq.txt: " + line);
            t.whole = extent == "whole";
            all.emplace(entry, t);
        }
        return all;
    }();
    const auto found = theorems.find(id);
    return found == theorems.end() ? nullptr : &found->second;
}

std::string_view ground(const Entry& e)
{
    if (e.finding.verdict == Verdict::argued) return "argument";
    if (e.finding.verdict != Verdict::proved && e.finding.verdict != Verdict::verified) return "";
    if (const CoqTheorem* t = coq_theorem(e.claim->id); t != nullptr && t->whole) return "Coq";
    for (const std::string_view word : {"certified", "bound", "enclosure"})
        if (e.finding.method.find(word) != std::string::npos) return "balls";
    return "symbols";
}

} // namespace touchstone::proofs
