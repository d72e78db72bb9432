// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/own_rows.hpp"

#include "touchstone/rounding/decimal.hpp"
#include "touchstone/scalar/exact_text.hpp"
#include "touchstone/table/ranges.hpp"
#include "touchstone/table/rows.hpp"
#include "verify/exit_codes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace touchstone::program {
namespace {

bool among(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The quantity's inputs, with D and gamma for G if they are given.
std::vector<std::string> columns_for(const Quantity& q, const std::vector<std::string>& keys)
{
    check_keys(q, keys);
    std::vector<std::string> columns;
    for (const auto& name : q.inputs) {
        if (name == "G" && !among(keys, "G")) columns.insert(columns.end(), {"D", "gamma"});
        else columns.push_back(name);
    }
    return columns;
}

/// As it goes into a table: no blanks, nothing a terminal or a reader of tables would stumble over.
std::string printable(const std::string& word)
{
    std::string clean;
    for (const char c : word)
        if (c != ' ') clean += static_cast<unsigned char>(c) > 0x20 && static_cast<unsigned char>(c) < 0x7f && c != '#' ? c : '?';
    return clean;
}

double binary64_of(const Inputs& in, const std::string& column)
{
    double x = 0;
    if (in.has(column)) x = nearest_double(in.real(column));
    else { // G = b^(1/m) is never on a tie
        std::optional<double> nearest;
        for (slong bits = 128; !nearest; bits *= 2) {
            const WorkingPrecision precision(bits);
            nearest = nearest_double(in.G_ball());
        }
        x = *nearest;
    }
    if (!std::isfinite(x)) throw DomainError(fmt::format("{}: no binary64 number is so large", column));
    return x;
}

/// The row's numbers from its words.
void fill(OwnRow& row, const Quantity& q, const std::vector<std::string>& columns, bool binary64)
{
    NamedTexts named;
    for (std::size_t k = 0; k < columns.size(); ++k) named.emplace_back(columns[k], row.words[k]);
    Inputs in = read_inputs(q, named);
    if (binary64) {
        std::map<std::string, Rational> values;
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const double x = binary64_of(in, columns[k]);
            values[columns[k]] = exact_rational(x);
            row.words[k] = shortest(x);
        }
        in = Inputs(values);
    }
    q.check(in);
    row.inputs = in;
}

/// Lines of a plain file that are no comment; 0 for a stream.
std::size_t lines_in(const std::string& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return 0;
    std::ifstream in(path);
    std::size_t lines = 0;
    for (std::string line; std::getline(in, line);) lines += !line.empty() && line.front() != '#' ? 1U : 0U;
    return lines;
}

class RowsOfFile : public OwnRows {
public:
    RowsOfFile(const Quantity& q, const std::string& path, const NamedTexts& constants, OwnRowsOptions options)
        : q_(q)
        , options_(options)
        , lines_(lines_in(path))
        , name_(path == "-" ? "standard input" : path)
        , file_(opened(path))
        , reader_(file_ ? *file_ : std::cin, name_,
                  {.known = known(q),
                   .ignored = options.printed ? std::vector<std::string>{} : std::vector<std::string>{"value", "error", "answer", "forced"},
                   .free_last = options.printed})
    {
        std::vector<std::string> keys;
        const auto& names = reader_.columns();
        for (std::size_t k = 0; k + (options_.printed ? 1 : 0) < names.size(); ++k)
            if (among(known(q), names[k])) keys.push_back(names[k]);
        for (const auto& [key, text] : constants) {
            if (among(keys, key)) throw WrongKeys(fmt::format("'{}' is a column of {} and given as {}={} too", key, name_, key, text));
            keys.push_back(key);
        }
        try {
            columns_ = columns_for(q, keys);
        }
        catch (const WrongKeys& e) {
            throw WrongKeys(fmt::format("{}: {}", name_, e.what()));
        }
        for (const auto& column : columns_) {
            places_.push_back(reader_.column(column));
            const auto constant = std::find_if(constants.begin(), constants.end(), [&](const auto& c) { return c.first == column; });
            constants_.push_back(constant == constants.end() ? "" : printable(constant->second));
        }
    }

    const std::vector<std::string>& columns() const override { return columns_; }
    std::size_t count() const override { return lines_; }

    bool next(OwnRow& row) override
    {
        if (!reader_.next(read_)) return false;
        row = OwnRow{read_.number,
                     constants_,
                     std::nullopt,
                     fmt::format("{}:{}: row {}", name_, read_.line, read_.number),
                     options_.printed ? read_.words.back() : "",
                     {}};
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            if (!places_[k]) continue;
            const std::string& word = read_.words[*places_[k]];
            const auto fortran = parse_exact(word) ? std::nullopt : RowsReader::number(word); // 1D-3
            row.words[k] = fortran ? exact_text(*fortran) : printable(word);
        }
        try {
            fill(row, q_, columns_, options_.binary64);
        }
        catch (const DomainError& e) {
            row.refusal = fmt::format("{}: {}", row.place, e.what());
        }
        return true;
    }

private:
    static std::vector<std::string> known(const Quantity& q)
    {
        std::vector<std::string> names = q.inputs;
        if (among(names, "G")) names.insert(names.end(), {"D", "gamma"});
        return names;
    }
    static std::unique_ptr<std::ifstream> opened(const std::string& path)
    {
        if (path == "-") return nullptr;
        std::error_code ignored;
        if (std::filesystem::is_directory(path, ignored))
            throw Failure(bad_input, fmt::format("{} is a directory; --rows takes a file of rows", path));
        errno = 0;
        auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
        if (!*file) throw Failure(no_input_file, fmt::format("cannot read {}: {}", path, std::strerror(errno)));
        return file;
    }

    const Quantity& q_;
    OwnRowsOptions options_;
    std::size_t lines_;
    std::string name_;
    std::unique_ptr<std::ifstream> file_;
    RowsReader reader_;
    RowsReader::Row read_;
    std::vector<std::string> columns_, constants_;
    std::vector<std::optional<std::size_t>> places_;
};

/// The last range that was typed changes fastest.
class RowsOfRanges : public OwnRows {
public:
    RowsOfRanges(const Quantity& q, const NamedTexts& given, OwnRowsOptions options) : q_(q), options_(options)
    {
        std::vector<std::string> keys;
        for (const auto& [key, text] : given) keys.push_back(key);
        columns_ = columns_for(q, keys);
        for (const auto& [key, text] : given) {
            ranges_.emplace_back(text);
            places_.push_back(static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), key) - columns_.begin()));
            total_ = ranges_.back().size() > Range::most / total_ ? Range::most + 1 : total_ * ranges_.back().size();
        }
        if (total_ > Range::most) throw DomainError(fmt::format("the ranges have more than {} combinations", Range::most));
    }

    const std::vector<std::string>& columns() const override { return columns_; }
    std::size_t count() const override { return total_; }

    bool next(OwnRow& row) override
    {
        if (done_ == total_) return false;
        row = OwnRow{done_ + 1, std::vector<std::string>(columns_.size()), std::nullopt, fmt::format("row {}", done_ + 1), {}, {}};
        std::size_t rest = done_++;
        for (std::size_t k = ranges_.size(); k-- > 0; rest /= ranges_[k].size())
            row.words[places_[k]] = printable(ranges_[k].at(rest % ranges_[k].size()));
        try {
            fill(row, q_, columns_, options_.binary64);
        }
        catch (const DomainError& e) {
            row.refusal = fmt::format("{}: {}", row.place, e.what());
        }
        return true;
    }

private:
    const Quantity& q_;
    OwnRowsOptions options_;
    std::vector<std::string> columns_;
    std::vector<Range> ranges_;
    std::vector<std::size_t> places_;
    std::size_t done_ = 0, total_ = 1;
};

} // namespace

const Quantity& quantity_named(const std::string& name)
{
    if (const Quantity* q = find_quantity(name)) return *q;
    throw Failure(usage_error, fmt::format("unknown quantity '{}'; nearest is '{}' (all: touchstone list)", name,
                                           nearest_name(name, quantity_names())));
}

NamedTexts key_values(const Quantity& q, const std::vector<std::string>& words)
{
    NamedTexts named;
    for (const auto& word : words) {
        const auto equals = word.find('=');
        if (equals == std::string::npos || equals == 0)
            throw Failure(usage_error, fmt::format("'{}' is not KEY=VALUE; {} takes {}", word, q.name,
                                                   q.inputs.empty() ? "no inputs" : fmt::format("{}", fmt::join(q.inputs, ", "))));
        named.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    }
    return named;
}

bool is_range(const std::string& word) { return word.find(':') != std::string::npos || word.find(',') != std::string::npos; }

std::unique_ptr<OwnRows> rows_of_file(const Quantity& q, const std::string& path, const NamedTexts& constants, OwnRowsOptions options)
{
    for (const auto& [key, text] : constants)
        if (is_range(text)) throw Failure(usage_error, fmt::format("{}={}: with --rows an input is a column or one value", key, text));
    return std::make_unique<RowsOfFile>(q, path, constants, options);
}

std::unique_ptr<OwnRows> rows_of_ranges(const Quantity& q, const NamedTexts& given, OwnRowsOptions options)
{
    return std::make_unique<RowsOfRanges>(q, given, options);
}

} // namespace touchstone::program
