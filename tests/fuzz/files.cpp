// SPDX-License-Identifier: MIT
#include "tests/fuzz/expect.hpp"
#include "tests/fuzz/targets.hpp"
#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/client/touchstone_reference.hpp"
#include "touchstone/oracle/baseline.hpp"
#include "touchstone/table/format.hpp"
#include "touchstone/table/own_table.hpp"
#include "touchstone/table/rows.hpp"
#include "touchstone/table/shard.hpp"

#include <nlohmann/json.hpp>

#include <sys/mman.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>

namespace touchstone::fuzz {
namespace {

/// A hash stands between a changed byte and what reads the rows. A text whose hash is SHA is given the right one, so that both sides are
/// tried.
std::string sealed(std::string text, const std::string& rows)
{
    if (const auto at = text.find("\"SHA\""); at != std::string::npos) text.replace(at + 1, 3, sha256(rows));
    return text;
}

/// Rows of a table: what stands after its last line that begins with '#'.
std::string after_comments(const std::string& text)
{
    const auto last = text.rfind("\n#");
    const auto end = text.find('\n', last == std::string::npos ? 0 : last + 1);
    return end == std::string::npos ? "" : text.substr(end + 1);
}

} // namespace

void rows(std::string_view text)
{
    std::istringstream in{std::string(text)};
    try {
        RowsReader reader(in, "rows.txt",
                          {.known = {"x", "load", "n", "p"}, .ignored = {"error"}, .free_last = text.size() % 2 == 0, .longest_line = 200});
        RowsReader::Row row;
        while (reader.next(row)) {
            expect(row.words.size() == reader.columns().size(), "a row has as many words as columns");
            for (std::size_t c = 0; c < row.words.size(); ++c) {
                expect(!row.words[c].empty() && row.words[c].size() <= 200, "a word is of its line");
                reader.exact(row, c);
            }
        }
    }
    catch (const BadRows& e) {
        expect(std::string_view(e.what()).find('\n') == std::string_view::npos, "one line says what is wrong");
    }
}

void tables(std::string_view bytes)
{
    std::string text(bytes);
    text = sealed(text, after_comments(text));
    try {
        const StoredTable table = parse_table(text, "table.txt");
        expect(!table.rows.empty(), "a table has rows");
        for (const auto& row : table.rows) expect(row.inputs.size() == table.inputs.size(), "a row has as many inputs as columns");
    }
    catch (const CorruptTable&) {
    }
}

void shards(std::string_view bytes)
{
    std::string text(bytes);
    // the seal of a shard is over its head without the seal, and its rows
    static const std::regex seal(R"(,"sha256":"SHA"\}\n)");
    if (std::smatch m; std::regex_search(text, m, seal)) {
        const auto head = text.find('\n') + 1;
        if (head < static_cast<std::size_t>(m.position()) && text.compare(head, 2, "# ") == 0) {
            const std::string all = text.substr(head + 2, static_cast<std::size_t>(m.position()) - head - 2) + "}\n" + m.suffix().str();
            text.replace(static_cast<std::size_t>(m.position()) + 11, 3, sha256(all));
        }
    }
    try {
        const Shard shard = parse_shard(text, "shard.txt");
        const Shard again = parse_shard(format_shard(shard), "again.txt");
        expect(shard.same_as(again) && shard.rows.size() == again.rows.size() && shard.about == again.about,
               "a shard written is the same shard");
    }
    catch (const CorruptTable&) {
    }
}

void own_tables(std::string_view text)
{
    try {
        const TableSpec spec = own_table(text, "mine.json");
        expect(!spec.name.empty() && spec.digits >= 1, "a table has a name and digits");
    }
    catch (const DomainError&) {
    }
    catch (const WrongKeys&) {
    }
}

void baselines(std::string_view text)
{
    try {
        const oracle::Baseline b = oracle::parse_baseline(text, "baseline.json");
        const oracle::Baseline again = oracle::parse_baseline(b.text(), "again.json");
        expect(b.bounds == again.bounds && b.table == again.table, "a baseline written is the same baseline");
    }
    catch (const oracle::BadBaseline&) {
    }
}

void client_header(std::string_view text)
{
    static const std::string path = [] { // a file in memory: the header opens it by its name
        static const int memory = ::memfd_create("table", 0);
        expect(memory >= 0, "there is memory for a file");
        return "/proc/self/fd/" + std::to_string(memory);
    }();
    std::ofstream(path, std::ios::binary) << text;
    try {
        const auto table = touchstone_reference::load(path);
        const auto wrong = table.failing([](const std::vector<double>& x) { return x.empty() ? 0.0 : x[0]; });
        expect(wrong.size() <= table.rows.size() && !touchstone_reference::message(wrong).empty(), "rows fail or pass");
    }
    catch (const std::runtime_error&) {
    }
}

} // namespace touchstone::fuzz
