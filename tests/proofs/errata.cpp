// SPDX-License-Identifier: GPL-3.0-or-later
// The erratum is what the ledger proves, and the committed one is it.
#include "proofs/errata.hpp"
#include "proofs/ledger.hpp"
#include "proofs/notation.hpp"
#include "proofs/severity.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

using namespace touchstone::proofs;

TEST_CASE("the committed erratum is the generated one")
{
    std::ifstream in(std::string(TOUCHSTONE_DATA) + "/paper/errata.md");
    const std::string committed{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    CHECK(committed == errata("md")); // touchstone paper --errata md > data/paper/errata.md
}

TEST_CASE("each refuted equation has its line, in each format")
{
    for (const char* format : {"md", "tex", "html"}) {
        const std::string text = errata(format);
        CAPTURE(format);
        for (const Claim& c : claims())
            if (prints().at(c.id).quote.empty()) {
                CAPTURE(c.id);
                CHECK((text.find("(" + c.id + ")") != std::string::npos) == c.correction.has_value());
            }
        CHECK(std::count(text.begin(), text.end(), '{') == std::count(text.begin(), text.end(), '}'));
    }
    CHECK_THROWS(errata("pdf"));
}

TEST_CASE("formulas keep their order and the journal's letters")
{
    const Print& p = prints().at("7.17");
    CHECK(in_notation("(p_nm1/pstar_n)^(1/2)", p, Notation::tex) == "{\\left(\\frac{p_{n-1}}{{p_{n}}^{*}}\\right)}^{\\frac{1}{2}}");
    CHECK(in_notation("(a-b)/(2*c)", p, Notation::tex) == "\\frac{a-b}{2 c}");
    CHECK(in_notation("I1+phat", p, Notation::tex) == "I_{1}+\\hat{p}");
    CHECK_THROWS(in_notation("1+", p, Notation::tex));
    CHECK_THROWS(in_notation("(1", p, Notation::tex));
    // every equation of the paper can be set
    for (const auto& [id, print] : prints())
        if (print.quote.empty() && !id.starts_with("beyond") && !id.starts_with("table1"))
            for (std::size_t i = 0; i < print.parts(); ++i) {
                CAPTURE(id);
                const std::string part = std::to_string(i);
                bool simple = true; // limits and derivatives have no notation of their own here
                for (const auto& [field, text] : print.fields) simple = simple && text != "limit" && text != "derivative";
                if (simple) CHECK_NOTHROW(in_notation(print.text(part + ".rhs"), print, Notation::mathml));
            }
}

TEST_CASE("each correction has a severity, and a claim said again names the first")
{
    int misprints = 0;
    for (const Claim& c : claims()) {
        if (c.correction) misprints += severity(*c.correction) == "misprint" ? 1 : 0;
        if (const std::string first = same_as(c.id); !first.empty()) {
            CHECK(std::any_of(claims().begin(), claims().end(), [&](const Claim& k) { return k.id == first; }));
            CHECK(same_as(first).empty());
        }
    }
    CHECK(misprints == 10);
    CHECK_FALSE(caveat("7.21").empty());
    CHECK(caveat("2.2").empty());
}
