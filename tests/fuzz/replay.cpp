// SPDX-License-Identifier: MIT
/// Every text of the corpora, and changes of them drawn from a seed, through every parser: none ends the program. TOUCHSTONE_SEED and
/// TOUCHSTONE_COUNT (changes a text) take it further.
#include "tests/fuzz/targets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace {

using touchstone::fuzz::Target;

unsigned long setting(const char* name, unsigned long otherwise)
{
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

std::vector<std::string> corpus(const Target& target)
{
    std::vector<std::string> texts;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TOUCHSTONE_FUZZ_CORPUS) / target.name)) {
        std::ifstream in(entry.path(), std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return texts;
}

/// A byte changed, left out, doubled, or a piece of another text put in.
std::string changed(std::string text, const std::vector<std::string>& others, std::mt19937_64& random)
{
    const auto place = [&random](std::size_t size) { return size == 0 ? 0 : random() % size; };
    static const std::string telling = "0123456789.-+eExp/^()[]{}\",:;=# \n\r\tnaif\0";
    const std::size_t at = place(text.size());
    switch (random() % 5) {
    case 0: text.insert(at, 1, telling[place(telling.size())]); break;
    case 1:
        if (!text.empty()) text[at] = static_cast<char>(random());
        break;
    case 2: text.erase(at, 1 + place(8)); break;
    case 3: text.insert(at, text.substr(place(text.size()), 1 + place(20))); break;
    default: {
        const std::string& other = others[place(others.size())];
        text.insert(at, other.substr(place(other.size()), 1 + place(40)));
    }
    }
    return text;
}

} // namespace

TEST_CASE("no text ends a parser but by the error it promises")
{
    const unsigned long seed = setting("TOUCHSTONE_SEED", 20261122), count = setting("TOUCHSTONE_COUNT", 40);
    MESSAGE("seed " << seed << ", " << count << " changes of each text");
    std::mt19937_64 random(seed);
    for (const Target& target : touchstone::fuzz::targets()) {
        const std::vector<std::string> texts = corpus(target);
        CHECK_MESSAGE(!texts.empty(), target.name);
        for (const std::string& text : texts) {
            INFO(target.name, ": ", text);
            CHECK_NOTHROW(target.run(text));
            for (unsigned long k = 0; k < count; ++k) {
                std::string other = changed(text, texts, random);
                if (k % 4 == 3) other = changed(other, texts, random);
                other.resize(std::min(other.size(), target.longest));
                INFO("changed to: ", other);
                CHECK_NOTHROW(target.run(other));
            }
        }
    }
}
