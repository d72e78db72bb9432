// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/severity.hpp"

#include <map>
#include <stdexcept>

namespace touchstone::proofs {

std::string_view severity(const Correction& c)
{
    if (c.fault == "misprint") return "misprint";
    if (c.fault == "wording") return "imprecise";
    if (c.fault == "substance") return "false";
    throw std::logic_error("not a fault: " + c.fault);
}

std::string same_as(const std::string& id)
{
    static const std::map<std::string, std::string> first{{"text.increasingly-hertzian-2", "text.increasingly-hertzian"},
                                                          {"text.hertz-dominates", "text.increasingly-hertzian"},
                                                          {"text.hertz-prevalence", "text.increasingly-hertzian"},
                                                          {"text.first-scales", "text.archard-small-n"},
                                                          {"text.converges-on-8.6", "text.defines-limit"}};
    const auto found = first.find(id);
    return found == first.end() ? "" : found->second;
}

std::string caveat(const std::string& id)
{
    if (id.starts_with("figure")) return "judged from the caption and the text; the curves are not in the source text and were not seen";
    static const std::map<std::string, std::string> all{
        {"7.21", "the limiting form of the Hertzian area (7.18), not of the model's (6.7), whose "
         "constant is larger for G > 2 (text.defines-limit)"},
        {"8.3", "the limiting form of the Hertzian number (8.2), not of the model's, whose "
         "constant is larger for G > 2 (text.defines-limit)"},
        {"8.6", "the limiting form of the Hertzian number (8.2), not of the model's, whose "
         "constant is larger for G > 2 (text.defines-limit)"}};
    const auto found = all.find(id);
    return found == all.end() ? "" : found->second;
}

} // namespace touchstone::proofs
