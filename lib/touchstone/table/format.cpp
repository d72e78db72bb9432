// SPDX-License-Identifier: MIT
#include "touchstone/table/format.hpp"

#include "touchstone/table/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace touchstone {
namespace {

using Json = nlohmann::ordered_json;

/// The exact decimal expansion of a binary64 number (Boost's SC_ pastes it into literals of any type).
std::string exact_decimal(double x)
{
    const Rational r = exact_rational(x);
    return round_to_digits(r, *terminating_digits(r)).text();
}

std::string joined_inputs(const TableRow& row, std::string_view separator, std::string (*show)(double))
{
    std::string text;
    for (const double x : row.inputs) text += show(x) + std::string(separator);
    return text;
}

/// Readable by whatever reads numbers: -1 says that it is not known.
std::string forced_column(const std::optional<ForcedUlps>& f) { return f ? forced_text(f->ulps) : "-1"; }

/// How the forced column was made, in a word.
std::string forced_kind(bool estimated) { return estimated ? "estimated" : "first order"; }
bool has_estimates(const Table& t)
{
    return std::any_of(t.rows.begin(), t.rows.end(), [](const TableRow& r) { return r.forced && r.forced->estimated; });
}

std::string canonical_rows(const Table& t)
{
    std::string rows;
    for (const auto& r : t.rows)
        rows += joined_inputs(r, " ", shortest) + r.result.value + " " + r.result.error_bound +
                (t.forced ? " " + forced_column(r.forced) : "") + "\n";
    return rows;
}

Json header(const Table& t, std::string_view rows)
{
    Json h;
    h["name"] = t.name;
    h["quantity"] = t.quantity->name;
    h["equation"] = t.quantity->equation;
    h["unit"] = t.quantity->unit;
    h["description"] = t.quantity->description;
    h["inputs"] = t.inputs;
    h["input_format"] = "binary64";
    h["digits"] = t.digits;
    h["rows"] = t.rows.size();
    h["status"] = std::string(to_string(t.status()));
    std::vector<std::string> routes;
    const auto add = [&routes](const std::string& name) {
        if (name != "exact-arithmetic" && std::find(routes.begin(), routes.end(), name) == routes.end()) routes.push_back(name);
    };
    if (t.quantity->plan || t.status() == Status::estimated) // they differ from row to row: eval says which
        for (const auto& row : t.rows)
            for (const auto& name : row.result.routes) add(name);
    else
        for (const auto& r : t.quantity->routes) add(r.name);
    h["routes"] = routes;
    if (t.forced) h["forced"] = forced_kind(has_estimates(t));
    h["version"] = std::string(version());
    h["command"] = fmt::format("touchstone table {} --digits {}", t.name, t.digits);
    h["sha256"] = sha256(rows);
    return h;
}

std::string forced_banner(bool estimated)
{
    return fmt::format(
        "# forced: ulps of the value (absolute where it is 0) that rounding each real input once can cost a perfect code, to first order{}.\n",
        estimated ? ", in some rows by an estimated condition number" : "");
}

std::string as_txt(const Table& t)
{
    const std::string rows = canonical_rows(t);
    const bool estimated = t.status() == Status::estimated;
    std::string text = fmt::format(
        "# Touchstone {} reference table {}\n"
        "# {}; equation {}; unit {}\n"
        "# Inputs are binary64 numbers in shortest round-trip decimal: each stands for the binary64 number it rounds to.\n"
        "# value: the true value rounded to nearest, {} significant digits (fewer if exact). error: {} of |value - true value|.\n"
        "{}# {}\n#",
        estimated ? "estimated" : "certified", t.name, t.quantity->description, t.quantity->equation, t.quantity->unit, t.digits,
        estimated ? "estimate (from how far the numerical methods named under routes part, no proof; 0: exact)" : "proven bound",
        t.forced ? forced_banner(has_estimates(t)) : "", header(t, rows).dump());
    for (const auto& name : t.inputs) text += " " + name;
    return text + " value error" + (t.forced ? " forced" : "") + "\n" + rows;
}

std::string binary64_of(const TableRow& r) { return r.result.binary64 ? hexfloat(*r.result.binary64) : "undecided"; }

std::string as_csv(const Table& t)
{
    std::string text;
    for (const auto& name : t.inputs) text += name + "," + name + "_hex,";
    text += std::string("value,error,binary64,status") + (t.forced ? ",forced\n" : "\n");
    for (const auto& r : t.rows) {
        for (const double x : r.inputs) text += shortest(x) + "," + hexfloat(x) + ",";
        text += fmt::format("{},{},{},{}{}\n", r.result.value, r.result.error_bound, binary64_of(r), to_string(r.result.status),
                            t.forced ? "," + forced_column(r.forced) : "");
    }
    return text;
}

std::string as_json(const Table& t)
{
    Json rows = Json::array();
    for (const auto& r : t.rows) {
        Json row;
        std::vector<std::string> decimal, hex;
        for (const double x : r.inputs) {
            decimal.push_back(shortest(x));
            hex.push_back(hexfloat(x));
        }
        row["inputs"] = decimal;
        row["inputs_hex"] = hex;
        row["value"] = r.result.value;
        row["ball"] = {{"mid", r.result.value}, {"rad", r.result.error_bound}};
        row["binary64"] = binary64_of(r);
        row["status"] = std::string(to_string(r.result.status));
        if (t.forced) row["forced"] = r.forced ? Json(std::strtod(forced_text(r.forced->ulps).c_str(), nullptr)) : Json(nullptr);
        rows.push_back(std::move(row));
    }
    // one row a line: diffs stay readable
    std::string text = "{\"header\":" + header(t, canonical_rows(t)).dump() + ",\n\"rows\":[\n";
    for (std::size_t i = 0; i < rows.size(); ++i) text += rows[i].dump() + (i + 1 < rows.size() ? ",\n" : "\n");
    return text + "]}\n";
}

std::string as_hpp(const Table& t)
{
    std::string fields;
    for (const auto& name : t.inputs) fields += fmt::format("double {}; ", name);
    std::string text =
        fmt::format("// Touchstone {} reference table, generated by `{}`.\n"
                    "// {}; equation {}; unit {}. `value` is the binary64 number nearest to the true value.\n"
                    "#pragma once\n\nnamespace touchstone_reference {{\n\n"
                    "struct {}_row {{ {}double value; const char* decimal;{} }};\n\n"
                    "inline constexpr {}_row {}[] = {{\n",
                    t.status() == Status::estimated ? "estimated" : "certified",
                    header(t, canonical_rows(t))["command"].get<std::string>() + " --format hpp", t.quantity->description,
                    t.quantity->equation, t.quantity->unit, t.name, fields, t.forced ? " double forced;" : "", t.name, t.name);
    for (const auto& r : t.rows)
        text += "    {" + joined_inputs(r, ", ", hexfloat) + binary64_of(r) + ", \"" + r.result.value + "\"" +
                (t.forced ? ", " + forced_column(r.forced) : "") + "},\n";
    return text + "};\n\n} // namespace touchstone_reference\n";
}

std::string as_ipp(const Table& t)
{
    std::string text =
        fmt::format("// Touchstone {} reference table, generated by `touchstone table {} --digits {} --format ipp`.\n"
                    "// {}; equation {}; unit {}. Inputs are exact binary64 numbers; define SC_ and T as in Boost.Math's tests.\n"
                    "static const std::array<std::array<T, {}>, {}> {} = {{{{\n",
                    t.status() == Status::estimated ? "estimated" : "certified", t.name, t.digits, t.quantity->description,
                    t.quantity->equation, t.quantity->unit, t.inputs.size() + 1, t.rows.size(), t.name);
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
        text += "   {{ ";
        for (const double x : t.rows[i].inputs) text += "SC_(" + exact_decimal(x) + "), ";
        text += "SC_(" + t.rows[i].result.value + ") }}" + (i + 1 < t.rows.size() ? ",\n" : "\n");
    }
    return text + "}};\n";
}

/// Half a unit of the last digit of a decimal number, and how many significant digits it has.
struct LastDigit {
    Rational half_unit;
    long significant = 0;
};

LastDigit last_digit(const std::string& number)
{
    const std::size_t mantissa_end = std::min(number.find_first_of("eE"), number.size());
    const std::string mantissa = number.substr(0, mantissa_end);
    const std::size_t point = mantissa.find('.');
    const long after_point = point == std::string::npos ? 0 : static_cast<long>(mantissa.size() - point - 1);
    const long exponent = mantissa_end < number.size() ? std::stol(number.substr(mantissa_end + 1)) : 0;
    LastDigit last{power(Rational(10), exponent - after_point) / 2, 0};
    for (const char c : mantissa)
        if (c >= '0' && c <= '9' && (last.significant > 0 || c != '0')) ++last.significant;
    return last;
}

/// Whether the header has this text under this key.
bool says(const Json& head, const char* key, const char* text) { return head.contains(key) && head.at(key) == text; }

/// \returns nothing for -1
template <class Fail>
std::optional<double> forced_of(const std::string& word, const Fail& fail)
{
    double x = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), x);
    if (error != std::errc() || rest != word.data() + word.size() || !std::isfinite(x) || (x < 0 && x != -1))
        throw fail(fmt::format("what inputs force, '{}', is neither a number >= 0 nor -1", word));
    return x < 0 ? std::nullopt : std::optional(x);
}

bool is_number(const std::string& s)
{
    return !s.empty() && parse_rational(s).has_value() && s.find('/') == std::string::npos && s.find('x') == std::string::npos;
}

} // namespace

std::string_view version() { return TOUCHSTONE_VERSION; }

std::string sha256(std::string_view bytes)
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
    std::string hex;
    for (unsigned i = 0; i < size; ++i) hex += fmt::format("{:02x}", digest[i]);
    return hex;
}

std::string format(const Table& t, std::string_view format)
{
    if (format == "txt") return as_txt(t);
    if (format == "csv") return as_csv(t);
    if (format == "json") return as_json(t);
    if (format == "hpp") return as_hpp(t);
    if (format == "ipp") return as_ipp(t);
    throw std::invalid_argument(fmt::format("unknown table format '{}'", format));
}

std::string with_forced(const StoredTable& t, std::string_view text)
{
    const Quantity* q = find_quantity(t.quantity);
    if (q == nullptr || q->inputs != t.inputs)
        throw CorruptTable(fmt::format("{}: quantity '{}' is none of this program's", t.name, t.quantity));
    std::string rows;
    bool estimated = false;
    for (const auto& r : t.rows) {
        const auto f = forced_ulps(*q, r.inputs, *parse_rational(r.value));
        estimated = estimated || (f && f->estimated);
        rows += joined_inputs(TableRow{r.inputs, {}, {}}, " ", shortest) + r.value + " " + r.error + " " + forced_column(f) + "\n";
    }
    Json head, stored = Json::parse(t.header_json);
    for (const auto& [key, value] : stored.items()) {
        if (key == "forced") continue;
        if (key == "version") head["forced"] = forced_kind(estimated);
        head[key] = value;
    }
    head["sha256"] = sha256(rows);
    std::string out;
    for (std::size_t at = 0; at < text.size() && text[at] == '#'; at = text.find('\n', at) + 1) {
        const std::string_view line = text.substr(at, text.find('\n', at) - at);
        if (line.starts_with("# forced: ")) continue;
        if (line.starts_with("# {")) out += forced_banner(estimated) + "# " + head.dump() + "\n";
        else if (line.ends_with(" value error")) out += std::string(line) + " forced\n";
        else out += std::string(line) + "\n";
    }
    return out + rows;
}

StoredTable parse_table(std::string_view text, std::string_view file)
{
    std::size_t line_number = 0;
    const auto fail = [&](std::string_view what) {
        return CorruptTable(fmt::format("{}:{}: not a canonical table: {}", file, line_number, what));
    };
    StoredTable t;
    Json head;
    std::string columns;
    std::size_t rows_begin = 0, position = 0;
    bool in_rows = false;
    if (text.empty() || text.back() != '\n') throw fail("does not end with a complete line");
    while (position < text.size()) {
        const std::size_t end = text.find('\n', position);
        const std::string line(text.substr(position, end - position));
        ++line_number;
        if (line.ends_with('\r')) throw fail("the line ends in CR LF where LF is right (git's core.autocrlf?)");
        if (line.starts_with("#") && !in_rows) {
            if (line.starts_with("# {")) {
                head = Json::parse(shallow(std::string_view(line).substr(2)), nullptr, false);
                if (head.is_discarded()) throw fail("the JSON header cannot be read");
            }
            columns = line;
            rows_begin = end + 1;
            position = end + 1;
            continue;
        }
        if (!in_rows) {
            in_rows = true;
            try {
                t.header_json = head.dump();
                t.name = head.at("name").get<std::string>();
                t.quantity = head.at("quantity").get<std::string>();
                t.inputs = head.at("inputs").get<std::vector<std::string>>();
                t.digits = head.at("digits").get<long>();
            }
            catch (const nlohmann::json::exception&) {
                throw fail("no JSON header with name, quantity, inputs and digits");
            }
            std::string right = "#";
            for (const auto& name : t.inputs) right += " " + name;
            right += " value error";
            t.has_forced = columns == right + " forced";
            t.forced_estimated = says(head, "forced", "estimated");
            if (columns != right && !t.has_forced)
                throw fail(fmt::format("the columns are named '{}' where '{}' is right", columns, right));
        }
        std::istringstream words(line);
        std::vector<std::string> word;
        for (std::string w; words >> w;) word.push_back(w);
        const std::size_t wanted = t.inputs.size() + (t.has_forced ? 3 : 2);
        if (word.size() != wanted) throw fail(fmt::format("{} columns where {} are right", word.size(), wanted));
        StoredTable::Row row;
        for (std::size_t i = 0; i < t.inputs.size(); ++i) {
            double x = 0;
            const auto [rest, error] = std::from_chars(word[i].data(), word[i].data() + word[i].size(), x);
            if (error != std::errc() || rest != word[i].data() + word[i].size() || !std::isfinite(x))
                throw fail(fmt::format("input '{}' is not a finite number", word[i]));
            row.inputs.push_back(x);
        }
        row.value = word[t.inputs.size()];
        row.error = word[t.inputs.size() + 1];
        if (t.has_forced) row.forced = forced_of(word.back(), fail);
        if (!is_number(row.value)) throw fail(fmt::format("value '{}' is not a number", row.value));
        if (!is_number(row.error) || row.error.front() == '-') throw fail(fmt::format("error bound '{}' is not a number >= 0", row.error));
        // rounding to nearest proves half a unit of the last digit and no less; a bound of 0 says that the value is exact
        const LastDigit last = last_digit(row.value);
        const Rational bound = *parse_rational(row.error);
        if (bound != 0 && bound < last.half_unit)
            throw fail(fmt::format("error bound {} is below half a unit of the last digit of {}", row.error, row.value));
        const bool one_less = last.significant == t.digits - 1 && says(head, "status", "estimated"); // next to a tie
        if (bound != 0 && last.significant != t.digits && !one_less)
            throw fail(fmt::format("value {} has {} digits where the header says {}", row.value, last.significant, t.digits));
        if (bound > abs(*parse_rational(row.value)))
            throw fail(fmt::format("error bound {} is larger than the value {}", row.error, row.value));
        t.rows.push_back(std::move(row));
        position = end + 1;
    }
    if (t.rows.empty()) throw fail("no rows");
    auto inputs = t.rows;
    std::sort(inputs.begin(), inputs.end(), [](const auto& a, const auto& b) { return a.inputs < b.inputs; });
    if (std::adjacent_find(inputs.begin(), inputs.end(), [](const auto& a, const auto& b) { return a.inputs == b.inputs; }) != inputs.end())
        throw fail("two rows have the same inputs");
    try {
        if (head.at("rows").get<std::size_t>() != t.rows.size())
            throw fail(fmt::format("{} rows where the header says {}", t.rows.size(), head.at("rows").dump()));
        t.sha256 = head.at("sha256").get<std::string>();
        if (t.sha256 != sha256(text.substr(rows_begin)))
            throw fail("the rows do not have the SHA-256 that the header gives");
    }
    catch (const nlohmann::json::exception&) {
        throw fail("the header lacks rows or sha256");
    }
    return t;
}

} // namespace touchstone
