// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A table that grows row by row: written as it comes, valid whenever it ends, taken up again where it ended.
#pragma once

#include "touchstone/catalogue/directed.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::program {

inline constexpr std::string_view status_mark = " # "; ///< what stands after it is no number of the row
inline const std::vector<std::string> statuses{"exact", "certified", "estimated", "undecided", "refused"}; ///< the weakest last

struct RowTableKind {
    const Quantity* quantity = nullptr;
    std::vector<std::string> columns;
    long digits = 20;
    Rounding rounding = Rounding::nearest;
    bool binary64 = false;
    bool json = false; ///< one object a line, no banner
};

/// What a row came to.
struct RowOutcome {
    Evaluation result;
    std::string refusal; ///< not empty: the row has no value, for this reason
};

/// One line of the table, with its end.
std::string row_line(const RowTableKind&, std::size_t number, const std::vector<std::string>& words, const RowOutcome&);

/// What kind of table it is, in JSON, as its first page has it; and a kind from that. \throws CorruptTable
std::string kind_text(const RowTableKind&);
RowTableKind kind_from(const std::string& json);
/// Whether the JSON of a first page describes this kind of table.
bool same_kind(const nlohmann::ordered_json&, const RowTableKind&);

/// SHA-256 of rows, as they come.
class RowsHash {
public:
    RowsHash();
    ~RowsHash();
    RowsHash(const RowsHash&) = delete;
    RowsHash& operator=(const RowsHash&) = delete;
    void add(std::string_view bytes);
    std::string text() const;

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

/// How many rows have which status.
using StatusCounts = std::map<std::string, std::size_t>;

/// Where rows go, one after another.
class RowSink {
public:
    virtual ~RowSink() = default;
    struct Kept {
        std::string line, status;
    };
    /// The row, if it is there already.
    virtual std::optional<Kept> kept(const std::vector<std::string>&) { return std::nullopt; }
    /// \param number of the row, from 1
    void write(std::size_t number, const std::string& line, const std::string& status)
    {
        add(number, line);
        ++counts_[status];
        ++rows_;
    }
    virtual void flush() {}
    /// All rows are there, or as many as there will be. \throws Failure
    virtual void finish(bool complete) = 0;
    const StatusCounts& counts() const { return counts_; }
    std::size_t rows() const { return rows_; }

protected:
    virtual void add(std::size_t number, const std::string& line) = 0;

    StatusCounts counts_;
    std::size_t rows_ = 0;
};

class KeptRows;

/// The table on standard output, whose last line says how many rows and which hash, or in a file: there it grows in FILE.part and becomes
/// FILE, with the same in its first lines, once it is finished or broken off. A second run for the same FILE is refused meanwhile.
class RowTable : public RowSink {
public:
    /// \param out empty: standard output \throws Failure (cannot_write)
    RowTable(RowTableKind, std::string out, bool resume);
    ~RowTable() override;

    std::optional<Kept> kept(const std::vector<std::string>& words) override; ///< \throws Failure where the table taken up again is damaged
    void flush() override;
    void finish(bool complete) override;

protected:
    void add(std::size_t number, const std::string& line) override;

private:
    void open_before(const std::string& path);
    void next_kept();
    std::string place() const { return !part_.empty() ? part_ : !out_.empty() ? out_ : "standard output"; }
    std::string header(const std::string& summary) const;
    std::string summary(bool complete) const;
    void put(const std::string& bytes);

    RowTableKind kind_;
    std::string out_, part_;
    bool stream_ = false;                      ///< standard output, a device or a pipe: written through
    std::FILE* file_ = nullptr;
    int held_ = -1;                            ///< FILE.part, locked: two runs that write one table would mix their rows
    std::unique_ptr<KeptRows> before_; ///< the table taken up again
    std::string kept_line_, kept_status_; ///< its next row
    std::vector<std::string> kept_words_;
    RowsHash hash_;
};

} // namespace touchstone::program
