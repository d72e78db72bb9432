// SPDX-License-Identifier: MIT
#include "touchstone/table/rows.hpp"

#include "touchstone/scalar/rational_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>

namespace touchstone {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t shown_characters = 40; ///< of a word in a message

std::string_view trimmed(std::string_view s)
{
    constexpr std::string_view blanks = " \t";
    const auto first = s.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view{} : s.substr(first, s.find_last_not_of(blanks) - first + 1);
}

/// Words between commas if there is one (then a field may be empty), else between blanks; quotes around a word are CSV's.
std::vector<std::string> words_of(std::string_view line)
{
    std::vector<std::string> words;
    const auto add = [&words](std::string_view word) {
        word = trimmed(word);
        if (word.size() >= 2 && word.front() == '"' && word.back() == '"') word = word.substr(1, word.size() - 2);
        words.emplace_back(word);
    };
    const bool commas = line.find(',') != std::string_view::npos;
    for (line = trimmed(line); !line.empty() || (commas && !words.empty());) {
        const auto end = line.find_first_of(commas ? "," : " \t");
        add(line.substr(0, end));
        if (end == std::string_view::npos) break;
        line.remove_prefix(end + 1);
        if (!commas) line = trimmed(line);
    }
    return words;
}

std::string quoted(std::string_view word)
{
    std::string shown;
    for (const char c : word.substr(0, shown_characters)) {
        const auto u = static_cast<unsigned char>(c);
        shown += u >= 0x20 && u < 0x7f ? std::string(1, c) : fmt::format("\\x{:02x}", u);
    }
    return "'" + shown + (word.size() > shown_characters ? "'..." : "'");
}

bool is_comment(std::string_view line) { return !line.empty() && (line.front() == '#' || line.front() == '%'); }

bool among(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// A name begins with a letter; nan and inf are numbers that went wrong, not names.
bool is_name(const std::string& word)
{
    if (word.empty() || std::isalpha(static_cast<unsigned char>(word.front())) == 0) return false;
    std::string lower;
    for (const char c : word) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower != "nan" && lower != "inf" && lower != "infinity";
}

} // namespace

RowsReader::RowsReader(std::istream& in, std::string file, Format format) : in_(in), file_(std::move(file)), format_(std::move(format))
{
    find_columns();
}

/// One line into text_, without its end, however lines end; false at the end of the file.
bool RowsReader::read_line()
{
    constexpr int end_of_file = std::char_traits<char>::eof();
    std::streambuf& bytes = *in_.rdbuf();
    text_.clear();
    ++line_;
    errno = 0;
    for (;;) {
        int c = end_of_file;
        try {
            c = bytes.sbumpc();
        }
        catch (const std::exception&) { // how libstdc++ reports a failed read(2)
            throw bad(fmt::format("cannot be read: {}", std::strerror(errno != 0 ? errno : EIO)));
        }
        if (c == end_of_file) {
            if (errno == EISDIR || errno == EIO)
                throw bad(fmt::format("cannot be read: {}", std::strerror(errno))); // standard input does not throw
            return !text_.empty();
        }
        const bool second_of_pair = c == '\n' && after_return_;
        after_return_ = c == '\r';
        if (second_of_pair) continue;
        if (c == '\n' || c == '\r') return true;
        text_ += static_cast<char>(c);
        if (text_.size() > format_.longest_line) throw bad(fmt::format("no line end within {} bytes", format_.longest_line));
    }
}

/// The columns are named by the last comment before the first row that holds nothing but column names, else by the last
/// that holds one at all (so that its mistake is named), else by a first line of bare names.
void RowsReader::find_columns()
{
    struct Candidate {
        std::string names;
        std::size_t line = 0;
    } complete, partial;
    const auto is_known = [this](const std::string& word) { return among(format_.known, word) || among(format_.ignored, word); };
    while (read_line()) {
        std::string_view line = text_;
        if (line_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
        if (line_ == 1 && (line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF"))) throw bad("is UTF-16 text; save it as UTF-8");
        line = trimmed(line);
        if (line.empty()) continue;
        if (is_comment(line)) {
            const auto words = words_of(line.substr(1));
            if (words.empty() || !std::any_of(words.begin(), words.end(), is_known)) continue;
            const auto named = format_.free_last && words.size() > 1 ? words.end() - 1 : words.end();
            Candidate& seen = std::all_of(words.begin(), named, is_known) ? complete : partial;
            seen = {std::string(line.substr(1)), line_};
            continue;
        }
        const auto words = words_of(line);
        if (complete.line == 0 && partial.line == 0) {
            if (!std::all_of(words.begin(), words.end(), is_name))
                throw bad(fmt::format("no line before the rows names the columns; right is '# {}' or some of these",
                                      fmt::join(format_.known, " ")));
            name_columns(line, line_);
            return;
        }
        text_ = std::string(line); // without a byte-order mark
        waiting_ = true;
        break;
    }
    const Candidate& names = complete.line > 0 ? complete : partial;
    if (names.line == 0) throw BadRows(fmt::format("{}: no rows", file_));
    name_columns(names.names, names.line);
}

void RowsReader::name_columns(std::string_view line, std::size_t at)
{
    columns_ = words_of(line);
    const auto wrong = [&](const std::string& what) { return BadRows(fmt::format("{}:{}: {}", file_, at, what)); };
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const std::string& name = columns_[k];
        const bool any_name = format_.free_last && k > 0 && k + 1 == columns_.size();
        if (!any_name && !among(format_.known, name) && !among(format_.ignored, name))
            throw wrong(fmt::format("unknown column {}; columns may be {}{}", quoted(name), fmt::join(format_.known, ", "),
                                    name.find(';') == std::string::npos ? "" : ", separated by blanks or commas and not by ';'"));
        if (std::find(columns_.begin(), columns_.begin() + static_cast<long>(k), name) != columns_.begin() + static_cast<long>(k))
            throw wrong(fmt::format("column '{}' is there twice", name));
    }
}

std::optional<std::size_t> RowsReader::column(std::string_view name) const
{
    const auto it = std::find(columns_.begin(), columns_.end(), name);
    return it == columns_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(it - columns_.begin()));
}

bool RowsReader::next(Row& row)
{
    for (; waiting_ || read_line(); waiting_ = false) {
        const std::string_view whole = trimmed(text_);
        if (whole.empty() || is_comment(whole)) continue;
        const std::string_view line = trimmed(whole.substr(0, whole.find('#')));
        waiting_ = false;
        row.number = ++rows_;
        row.line = line_;
        row.words = words_of(line);
        if (row.words.size() != columns_.size())
            throw fault(row,
                        fmt::format("{} columns where {} are named ({})", row.words.size(), columns_.size(), fmt::join(columns_, " ")));
        for (std::size_t k = 0; k < row.words.size(); ++k)
            if (row.words[k].empty()) throw fault(row, fmt::format("column '{}' is empty", columns_[k]));
        return true;
    }
    if (rows_ == 0) throw BadRows(fmt::format("{}: no rows", file_));
    return false;
}

std::optional<Rational> RowsReader::number(std::string_view word)
{
    if (word.find_first_of("xX") != std::string_view::npos || word.find_first_of("dD") == std::string_view::npos)
        return parse_rational(word);
    std::string text(word);
    std::replace_if(text.begin(), text.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
    return parse_rational(text);
}

Rational RowsReader::exact(const Row& row, std::size_t column) const
{
    const auto value = number(row.words.at(column));
    if (!value)
        throw fault(row, fmt::format("{} = {} {}", columns_.at(column), quoted(row.words[column]), why_not_rational(row.words[column])));
    return *value;
}

BadRows RowsReader::fault(const Row& row, std::string_view reason) const
{
    return BadRows(fmt::format("{}:{}: row {}: {}", file_, row.line, row.number, reason));
}

BadRows RowsReader::bad(std::string_view reason) const { return BadRows(fmt::format("{}:{}: {}", file_, line_, reason)); }

} // namespace touchstone
