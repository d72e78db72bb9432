// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/sections.hpp"

#include "proofs/print.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace touchstone::data {
std::string_view sections_text();
}

namespace touchstone::proofs {

const std::vector<Section>& sections()
{
    static const std::vector<Section> all = [] {
        std::vector<Section> read;
        for (const auto& record : nlohmann::json::parse(data::sections_text()))
            read.push_back({record.at("section"), record.at("heading")});
        for (const auto& [id, print] : prints()) {
            const auto is_its_section = [&print = print](const Section& s) { return s.id == print.section; };
            if (std::none_of(read.begin(), read.end(), is_its_section))
                throw std::logic_error("data/paper/sections.json has no section '" + print.section + "', where " + id + " stands");
        }
        return read;
    }();
    return all;
}

} // namespace touchstone::proofs
