// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/symbols.hpp"

#include <nlohmann/json.hpp>

namespace touchstone::data {
std::string_view symbols_text();
}

namespace touchstone::proofs {

namespace {

Alphabet of_the_paper()
{
    Alphabet a;
    const auto all = nlohmann::json::parse(data::symbols_text());
    const std::string here = "dimension in section ";
    for (const auto& [name, content] : all.at("symbols").items()) {
        SymbolKind& kind = a.symbols[name];
        kind.real = content.value("sign", "positive") == "real";
        for (const auto& [key, value] : content.items()) {
            if (key == "dimension") kind.dimension = value;
            if (key.starts_with(here)) kind.in_section[key.substr(here.size())] = value;
        }
    }
    for (const auto& [name, content] : all.at("functions").items()) a.functions[name] = {content.at("argument"), content.at("value")};
    a.alike = all.at("alike");
    return a;
}

std::optional<Alphabet>& another()
{
    static std::optional<Alphabet> a;
    return a;
}

} // namespace

const Alphabet& alphabet()
{
    static const Alphabet paper = of_the_paper();
    return another() ? *another() : paper;
}

void use_alphabet(Alphabet a) { another() = std::move(a); }
bool paper_alphabet_in_use() { return !another(); }

} // namespace touchstone::proofs
