// SPDX-License-Identifier: MIT
#include "touchstone/table/rows.hpp"

#include <doctest/doctest.h>

#include <sstream>
#include <vector>

using namespace touchstone;

namespace {

RowsReader::Format two_inputs() { return {.known = {"x", "load", "answer"}, .ignored = {"value", "error"}}; }

std::vector<RowsReader::Row> all_of(const std::string& text)
{
    std::istringstream in(text);
    RowsReader rows(in, "grid.txt", two_inputs());
    std::vector<RowsReader::Row> all;
    for (RowsReader::Row row; rows.next(row);) all.push_back(row);
    return all;
}

/// What a file is refused with.
std::string refusal(const std::string& text)
{
    try {
        std::istringstream in(text);
        RowsReader rows(in, "grid.txt", two_inputs());
        for (RowsReader::Row row; rows.next(row);)
            for (std::size_t k = 0; k < row.words.size(); ++k) rows.exact(row, k);
    }
    catch (const BadRows& e) {
        return e.what();
    }
    return "";
}

/// The same bytes for ever.
class Endless : public std::streambuf {
public:
    explicit Endless(char byte) : page_(4096, byte) {}
    std::size_t handed_out = 0;

private:
    int_type underflow() override
    {
        setg(page_.data(), page_.data(), page_.data() + page_.size());
        handed_out += page_.size();
        return traits_type::to_int_type(page_.front());
    }
    std::string page_;
};

} // namespace

TEST_CASE("rows are read with their columns by name, in whatever dress they come")
{
    const std::string plain = "# x load\n0.1 1/3\n0x1.8p-3 1e-300\n";
    const std::vector<std::vector<std::string>> right{{"0.1", "1/3"}, {"0x1.8p-3", "1e-300"}};
    const auto in_another_dress = [](const std::string& text, const std::string& from, const std::string& to) {
        std::string dressed;
        std::size_t begin = 0;
        for (std::size_t at = 0; (at = text.find(from, begin)) != std::string::npos; begin = at + from.size())
            dressed += text.substr(begin, at - begin) + to;
        return dressed + text.substr(begin);
    };
    for (const std::string& text :
         {plain, in_another_dress(plain, "\n", "\r\n"), in_another_dress(plain, "\n", "\r"), "\xEF\xBB\xBF" + plain,
          in_another_dress(plain, " 1", ",1"), in_another_dress(plain, " 1", " , 1"), in_another_dress(plain, " 1", "\t 1"),
          plain.substr(0, plain.size() - 1), "# a banner\n" + plain, plain + "\n\n# the end\n", plain.substr(2),
          "\xEF\xBB\xBF" + plain.substr(2), std::string("\"x\",\"load\"\r\n0.1,1/3\n0x1.8p-3,1e-300"),
          std::string("% x load\n0.1 1/3\r\n\r\n0x1.8p-3 1e-300\r"),
          in_another_dress(plain, "# x load\n", "# x load\n# in lambda, in p*\n")}) {
        CAPTURE(text);
        const auto rows = all_of(text);
        REQUIRE(rows.size() == 2);
        CHECK(rows[0].words == right[0]);
        CHECK(rows[1].words == right[1]);
        CHECK(rows[1].number == 2);
    }
    std::istringstream in("# load x\n0.1 1D-3\n");
    RowsReader rows(in, "grid.txt", two_inputs());
    RowsReader::Row row;
    REQUIRE(rows.next(row));
    CHECK(rows.column("x") == 1);
    CHECK_FALSE(rows.column("answer"));
    CHECK(rows.exact(row, 0) == Rational(1, 10));
    CHECK(rows.exact(row, 1) == Rational(1, 1000));
    CHECK(rows.fault(row, "load = 1/10: no").what() == std::string("grid.txt:2: row 1: load = 1/10: no"));
    CHECK_FALSE(rows.next(row));
}

TEST_CASE("what is wrong with a file is said in one line, with its place")
{
    const std::string head = "# x load\n";
    CHECK(refusal(head + "0.1 0.2\n0.3\n") == "grid.txt:3: row 2: 1 columns where 2 are named (x load)");
    CHECK(refusal(head + "0.1 0.2 0.3\n") == "grid.txt:2: row 1: 3 columns where 2 are named (x load)");
    CHECK(refusal(head + "0.1,\n") == "grid.txt:2: row 1: column 'load' is empty");
    CHECK(refusal(head + "0.1,,0.2\n") == "grid.txt:2: row 1: 3 columns where 2 are named (x load)");
    CHECK(refusal(head + "\n\n# here\n0.1 nan\n") ==
          "grid.txt:5: row 1: load = 'nan' is not a number such as 12, 0.1, 1e-300, 1/3 or 0x1.8p-3");
    CHECK(refusal(head + "0.1 inf\n").find("load = 'inf'") != std::string::npos);
    CHECK(refusal(head + "0.1 1;2\n").find("load = '1;2'") != std::string::npos);
    CHECK(refusal(head + std::string("0.1 \0\x1b\n", 7)).find("load = '\\x00\\x1b'") != std::string::npos);
    CHECK(refusal("# x lod\n0.1 0.2\n") == "grid.txt:1: unknown column 'lod'; columns may be x, load, answer");
    CHECK(refusal("x,lod\n0.1,0.2\n") == "grid.txt:1: unknown column 'lod'; columns may be x, load, answer");
    CHECK(refusal("# x x\n0.1 0.2\n") == "grid.txt:1: column 'x' is there twice");
    CHECK(refusal("0.1 0.2\n") == "grid.txt:1: no line before the rows names the columns; right is '# x load answer' or some of these");
    CHECK(refusal("nan nan\n").find("names the columns") != std::string::npos);
    CHECK(refusal("") == "grid.txt: no rows");
    CHECK(refusal("\n\n# nothing\n") == "grid.txt: no rows");
    CHECK(refusal(head) == "grid.txt: no rows");
    CHECK(refusal("x,load\n") == "grid.txt: no rows");
    CHECK(refusal(std::string("\xFF\xFEx\0", 4)) == "grid.txt:1: is UTF-16 text; save it as UTF-8");
}

TEST_CASE("an endless line ends the reading, not the memory; many rows stream")
{
    for (const char byte : {'1', '#', ' '}) {
        Endless bytes(byte);
        std::istream in(&bytes);
        CHECK_THROWS_WITH_AS(RowsReader(in, "grid.txt", two_inputs()), "grid.txt:1: no line end within 1048576 bytes", BadRows);
        CHECK(bytes.handed_out < std::size_t{2} << 20);
    }
    std::string text = "# x load\n";
    constexpr std::size_t many = 100'000;
    for (std::size_t i = 0; i < many; ++i) text += "0.25 1e-3\n";
    std::istringstream in(text);
    RowsReader rows(in, "grid.txt", two_inputs());
    std::size_t seen = 0;
    for (RowsReader::Row row; rows.next(row);) seen = row.number;
    CHECK(seen == many);
}
