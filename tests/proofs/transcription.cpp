// SPDX-License-Identifier: GPL-3.0-or-later
// The equations were transcribed twice by different hands; the two say the same.
#include "proofs/print.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <regex>
#include <set>

using namespace touchstone::proofs;
using nlohmann::json;

namespace {

json load(const char* file)
{
    std::ifstream in(std::string(TOUCHSTONE_DATA) + "/paper/" + file);
    return json::parse(in);
}

/// Text without blanks, closing punctuation and the alignment mark before an equation number.
std::string squeezed(const std::string& s)
{
    std::string out;
    for (const char c : s)
        if (!std::isspace(static_cast<unsigned char>(c))) out += c;
    const std::string quad = "\\quad";
    for (bool again = true; again && !out.empty();) {
        again = out.ends_with(quad) || out.back() == ',' || out.back() == '.';
        if (again) out.resize(out.size() - (out.ends_with(quad) ? quad.size() : 1));
    }
    return out;
}

/// The second hand's names in those of the first.
std::string renamed(const std::string& text, const std::string& id)
{
    static const std::map<std::string, std::string> names = {{"zx", "z"},
                                                             {"px", "p"},
                                                             {"fx", "f"},
                                                             {"gam", "gamma"},
                                                             {"g0", "g_0"},
                                                             {"lambda0", "lambda_0"},
                                                             {"lambda1", "lambda_1"},
                                                             {"g1", "g_1"},
                                                             {"F0", "F_0"},
                                                             {"F1", "F_1"},
                                                             {"a0", "a_0"},
                                                             {"p0x", "p_0"},
                                                             {"pnx", "p_n"},
                                                             {"pstar0", "pstar_0"},
                                                             {"xP", "x_P"},
                                                             {"Kn", "K_n"},
                                                             {"Knp1", "K_np1"},
                                                             {"Knm1", "K_nm1"},
                                                             {"K0", "K_0"},
                                                             {"Kinf", "K_infinity"},
                                                             {"A0", "A_0"},
                                                             {"alpha0", "alpha_0"},
                                                             {"beta0", "beta_0"},
                                                             {"delta0", "delta_0"},
                                                             {"zgamx", "z_gx"},
                                                             {"q_cond", "q"},
                                                             {"I_1", "I1"},
                                                             {"I_2", "I2"},
                                                             {"dQ_dp", "dQdp"},
                                                             {"f_nm1", "f_x"},
                                                             {"Q_at", "Q_a"},
                                                             {"Q_nm1", "Q_p"},
                                                             {"q_at", "q_a"},
                                                             {"dN_n", "dN"},
                                                             {"limKn", "L"}};
    static const std::map<std::string, std::set<std::string>> single = { // an only sum, integral or product
        {"S1", {"3.1", "3.7"}}, {"J1", {"6.2", "6.4", "6.5", "7.7", "7.10", "7.13"}}, {"P1", {"7.17", "7.18"}}};
    static const std::map<std::string, std::string> single_name = {{"S1", "S"}, {"J1", "J"}, {"P1", "M"}};
    static const std::regex word(R"([A-Za-z_]\w*)");
    std::string out, rest = text;
    for (std::smatch m; std::regex_search(rest, m, word);) {
        std::string n = m.str();
        if (id == "3.5" && n == "zx") n = "z_x";
        else if (id == "5.7" && n == "fx") n = "f_x";
        else if (single.count(n) && single.at(n).count(id)) n = single_name.at(n);
        else if (names.count(n)) n = names.at(n);
        out += m.prefix().str() + n;
        rest = m.suffix().str();
    }
    return out + rest;
}

bool same(const ex& a, const ex& b) { return a.is_equal(b) || GiNaC::normal(GiNaC::expand(a - b)).is_zero(); }

std::vector<std::string> expressions_of_first(const json& m)
{
    std::vector<std::string> out;
    for (const auto& p : m["parts"]) out.insert(out.end(), {p["lhs"], p["rhs"]});
    if (m.contains("pieces"))
        for (const auto& [name, p] : m["pieces"].items())
            for (const char* f : {"term", "from", "to", "integrand", "index", "variable", "argument"})
                if (p.contains(f)) out.push_back(p[f]);
    return out;
}

std::vector<std::string> expressions_of_second(const json& m)
{
    std::vector<std::string> out{m["lhs"], m["rhs"]};
    if (m.contains("also"))
        for (const auto& p : m["also"]) out.insert(out.end(), {p["lhs"], p["rhs"]});
    if (m.contains("chain"))
        for (const auto& p : m["chain"]) out.push_back(p["rhs"]);
    if (m.contains("pieces"))
        for (const auto& p : m["pieces"])
            for (const char* f : {"sum", "product", "integrand", "index", "from", "to", "at"})
                if (p.contains(f)) out.push_back(p[f]);
    return out;
}

} // namespace

TEST_CASE("two transcriptions of the 84 equations agree")
{
    const json first = load("equations.json"), second = load("second_transcription.json");
    REQUIRE(first.size() == 84);
    REQUIRE(second.size() == 84);
    std::map<std::string, json> by_id;
    for (const auto& r : second) by_id[r["id"]] = r;
    const std::set<std::string> arguments_left_out = {"3.5", "9.2"}; // the second records no arguments of z and Q there
    int compared = 0;
    for (const auto& r : first) {
        const std::string id = r["id"];
        CAPTURE(id);
        const json& other = by_id.at(id);
        CHECK(squeezed(r["tex"]) == squeezed(other["tex"]));
        CHECK(squeezed(r["domain"]) == squeezed(other["domain"]));
        std::vector<ex> mine, theirs;
        for (const std::string& s : expressions_of_first(r["machine"])) mine.push_back(read(s));
        for (const std::string& s : expressions_of_second(other["machine"])) theirs.push_back(read(renamed(s, id)));
        const auto in = [](const ex& e, const std::vector<ex>& all) {
            return std::any_of(all.begin(), all.end(), [&](const ex& o) { return same(e, o); });
        };
        for (const ex& e : theirs) CHECK(in(e, mine));
        if (!arguments_left_out.count(id))
            for (const ex& e : mine) CHECK(in(e, theirs));
        compared += static_cast<int>(theirs.size());
    }
    CHECK(compared == 283);
}

TEST_CASE("a letter changed in one transcription is found")
{
    const ex right = read("2^(n+2^(-n))/Pi^((n+2)/2)*M");
    CHECK(same(right, read("Pi^(-(n+2)/2)*M*2^(2^(-n)+n)")));
    CHECK_FALSE(same(right, read("2^(n-2^(-n))/Pi^((n+2)/2)*M")));
    CHECK(same(read("0.2"), ex(1) / 5));
}
