// SPDX-License-Identifier: MIT
#include "touchstone/table/shard.hpp"

#include "touchstone/rounding/decimal.hpp"
#include "touchstone/table/format.hpp"
#include "touchstone/table/json_text.hpp"
#include "touchstone/table/working_order.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <sstream>

namespace touchstone {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view row_mark = " # "; ///< between the row as it will stand in the table and what else is known of it

std::optional<std::size_t> natural(std::string_view text)
{
    std::size_t n = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(n) : std::nullopt;
}

/// FNV-1a: the same on every machine.
std::uint64_t hash_of(std::string_view text)
{
    std::uint64_t h = 0xcbf29ce484222325;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return h;
}

Json head_of(const Shard& s)
{
    return {{"name", s.name},   {"kind", s.kind},       {"shard", s.share.index}, {"of", s.share.count},          {"rows", s.rows.size()},
            {"total", s.total}, {"version", s.version}, {"spec", s.spec},         {"about", Json::parse(s.about)}};
}

std::string first_line(const Shard& s)
{
    return fmt::format("{}{} of {} of {}: `touchstone merge DIR` makes the table of all of them", shard_mark, s.share.index, s.share.count,
                       s.name);
}

/// Over the head and the rows, so that neither can change alone.
std::string seal(const Json& head, std::string_view rows) { return sha256(head.dump() + "\n" + std::string(rows)); }

Status status_named(const std::string& name)
{
    for (const Status s : {Status::exact, Status::certified, Status::estimated, Status::undecided})
        if (name == to_string(s)) return s;
    throw CorruptTable(fmt::format("a row has the status '{:.40}'", name));
}

/// It becomes the name of a file in the folder of the shares, and nowhere else.
bool names_a_file(std::string_view name)
{
    return !name.empty() &&
           std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

/// Over all that the table is: its name, what its first page says of it, and the inputs of all its rows.
std::string spec_text(const std::string& name, const std::string& about, const std::vector<std::vector<double>>& rows)
{
    std::string inputs;
    for (const auto& row : rows)
        for (const double x : row) inputs += shortest(x) + " "; // how many a row has, `about` says
    return sha256(name + about + inputs);
}

TableRow row_of(const std::string& line, const std::vector<std::string>& inputs, bool has_forced)
{
    const auto mark = line.find(row_mark);
    if (mark == std::string::npos) throw CorruptTable("a row has no status");
    std::istringstream words(line.substr(0, mark));
    TableRow row;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        std::string word;
        words >> word;
        row.inputs.push_back(std::strtod(word.c_str(), nullptr));
    }
    words >> row.result.value >> row.result.error_bound;
    const Json known = Json::parse(shallow(std::string_view(line).substr(mark + row_mark.size())));
    row.result.status = status_named(known.at("status"));
    row.result.routes = known.at("routes").get<std::vector<std::string>>();
    std::string forced;
    if (has_forced && words >> forced && forced != "-1")
        row.forced = ForcedUlps{std::strtod(forced.c_str(), nullptr), known.value("forced", "") == "estimated"};
    return row;
}

} // namespace

Share share_named(std::string_view text)
{
    const auto slash = text.find('/');
    const auto index = natural(text.substr(0, slash)),
               count = slash == std::string_view::npos ? std::nullopt : natural(text.substr(slash + 1));
    if (!index || !count || *index < 1 || *count > Share::most || *index > *count)
        throw DomainError(fmt::format("--shard '{:.40}': must be I/N with 1 <= I <= N <= {}, such as 3/16", text, Share::most));
    return {*index, *count};
}

Deal::Deal(const Quantity& q, std::size_t count)
    : quantity_(q)
    , count_(count)
{
}

std::size_t Deal::next(const Inputs* in)
{
    const std::string surface = in == nullptr ? std::string() : surface_text(quantity_, *in);
    if (surface.empty()) return card();
    const auto [at, fresh] = share_of_.try_emplace(hash_of(surface), 0);
    if (fresh) at->second = card();
    return at->second;
}

bool Shard::same_as(const Shard& o) const
{
    return name == o.name && kind == o.kind && spec == o.spec && version == o.version && share == o.share && total == o.total &&
           about == o.about;
}

std::string Shard::file_name() const
{
    return fmt::format("{}.shard-{:0{}}-of-{}.txt", name, share.index, std::to_string(share.count).size(), share.count);
}

std::string format_shard(const Shard& s)
{
    std::string rows;
    for (const auto& r : s.rows) rows += fmt::format("{} {}\n", r.number, r.line);
    Json head = head_of(s);
    const std::string sealed = seal(head, rows);
    head["sha256"] = sealed;
    return fmt::format("{}\n# {}\n{}", first_line(s), head.dump(), rows);
}

Shard parse_shard(std::string_view text, std::string_view file)
{
    const auto fail = [&](std::string_view what) { return CorruptTable(fmt::format("{}: {}", file, what)); };
    if (!text.starts_with(shard_mark)) throw fail("is no shard");
    const auto first = text.find('\n'), second = first == std::string_view::npos ? first : text.find('\n', first + 1);
    if (second == std::string_view::npos || text.back() != '\n' || !text.substr(first + 1).starts_with("# {")) throw fail("is cut off");
    Json head = Json::parse(shallow(text.substr(first + 3, second - first - 3)), nullptr, false);
    std::string_view rows = text.substr(second + 1);
    Shard s;
    try {
        const std::string sealed = head.at("sha256");
        head.erase("sha256");
        if (seal(head, rows) != sealed) throw fail("is cut off or changed: it does not have the SHA-256 that it gives");
        s = {head.at("name"),
             head.at("kind"),
             head.at("spec"),
             head.at("version"),
             {head.at("shard"), head.at("of")},
             head.at("total"),
             head.at("about").dump(),
             {}};
        if (!names_a_file(s.name)) throw fail("has a name that is no table's: letters, digits, _ and - alone");
        const std::size_t count = head.at("rows");
        for (std::size_t end; !rows.empty(); rows.remove_prefix(end + 1)) {
            end = rows.find('\n');
            const auto blank = rows.find(' ');
            const auto number = blank < end ? natural(rows.substr(0, blank)) : std::nullopt;
            if (!number || *number < 1 || *number > s.total || (!s.rows.empty() && *number <= s.rows.back().number))
                throw fail("has a row without its number in the table");
            s.rows.push_back({*number, std::string(rows.substr(blank + 1, end - blank - 1))});
        }
        if (s.rows.size() != count || s.share.index < 1 || s.share.index > s.share.count || s.share.count > Share::most)
            throw fail("contradicts itself");
    }
    catch (const nlohmann::json::exception&) {
        throw fail("has no head that says of what it is a share");
    }
    return s;
}

std::string array_text(const std::vector<std::size_t>& ascending)
{
    std::string text;
    for (std::size_t i = 0; i < ascending.size();) {
        std::size_t j = i;
        while (j + 1 < ascending.size() && ascending[j + 1] == ascending[j] + 1) ++j;
        text += fmt::format("{}{}", text.empty() ? "" : ",", ascending[i]);
        if (j > i) text += fmt::format("{}{}", j == i + 1 ? "," : "-", ascending[j]);
        i = j + 1;
    }
    return text;
}

Shard shard_of(const TableSpec& t, long digits, Share share)
{
    const Quantity& q = *find_quantity(t.quantity);
    const auto grid = t.grid();
    const Json about{{"quantity", t.quantity}, {"inputs", q.inputs}, {"digits", digits}, {"forced", t.forced}};
    return {t.name, "table", spec_text(t.name, about.dump(), grid), std::string(version()), share, grid.size(), about.dump(), {}};
}

std::vector<std::size_t> rows_of_share(const TableSpec& t, Share share)
{
    const Quantity& q = *find_quantity(t.quantity);
    Deal deal(q, share.count);
    std::vector<std::size_t> mine;
    std::size_t number = 0;
    for (const auto& row : t.grid()) {
        std::map<std::string, Rational> values;
        for (std::size_t k = 0; k < row.size(); ++k) values[q.inputs[k]] = exact_rational(row[k]);
        const Inputs in(values);
        ++number;
        if (deal.next(&in) == share.index) mine.push_back(number);
    }
    return mine;
}

std::vector<Shard::Row> shard_rows(const Table& part, const std::vector<std::size_t>& numbers)
{
    std::vector<Shard::Row> rows;
    for (std::size_t i = 0; i < part.rows.size(); ++i) {
        const TableRow& r = part.rows[i];
        std::string line;
        for (const double x : r.inputs) line += shortest(x) + " ";
        line += r.result.value + " " + r.result.error_bound;
        if (part.forced) line += " " + (r.forced ? forced_text(r.forced->ulps) : std::string("-1"));
        Json known{{"status", std::string(to_string(r.result.status))}, {"routes", r.result.routes}};
        if (r.forced && r.forced->estimated) known["forced"] = "estimated";
        rows.push_back({numbers[i], line + std::string(row_mark) + known.dump()});
    }
    return rows;
}

Table table_of_shards(const std::vector<Shard>& shards)
{
    const Shard& any = shards.front();
    const Json about = Json::parse(any.about);
    Table t;
    try {
        t.name = any.name;
        t.quantity = find_quantity(about.at("quantity").get<std::string>());
        t.inputs = about.at("inputs").get<std::vector<std::string>>();
        t.digits = about.at("digits");
        t.forced = about.at("forced");
        if (t.quantity == nullptr || t.quantity->inputs != t.inputs)
            throw CorruptTable(fmt::format("{}: '{:.40}' is no quantity of this program", any.name, about.at("quantity").dump()));
        t.rows.resize(any.total);
        for (const Shard& s : shards)
            for (const auto& r : s.rows) t.rows.at(r.number - 1) = row_of(r.line, t.inputs, t.forced);
        std::vector<std::vector<double>> rows;
        for (const TableRow& r : t.rows) rows.push_back(r.inputs);
        if (spec_text(t.name, any.about, rows) != any.spec)
            throw CorruptTable(fmt::format("{}: the inputs of its rows are not those of the table that they are shares of", any.name));
    }
    catch (const nlohmann::json::exception&) {
        throw CorruptTable(fmt::format("{}: its shards do not say what table they are of", any.name));
    }
    return t;
}

} // namespace touchstone
