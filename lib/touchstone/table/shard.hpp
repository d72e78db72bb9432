// SPDX-License-Identifier: MIT
/// \file
/// A table made on several machines: who computes which rows, and the files in which the shares travel.
#pragma once

#include "touchstone/table/table.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone {

/// Share `index` of `count`, from 1.
struct Share {
    std::size_t index = 1, count = 1;
    auto operator<=>(const Share&) const = default;
    static constexpr std::size_t most = 1'000'000;
};

/// Reads "3/16". \throws DomainError
Share share_named(std::string_view text);

/// Deals rows out like cards, one after another, in the order in which they stand. All rows of one surface (G, or D and gamma) go where
/// its first row went, because they share their meshes; of a quantity without a surface every row is a card of its own. The same
/// rows are dealt the same way on every machine. Needs memory for the surfaces, not for the rows.
class Deal {
public:
    Deal(const Quantity&, std::size_t count);
    /// Which share the next row belongs to, from 1. \param in nullptr: a row that has no value
    std::size_t next(const Inputs* in);

private:
    std::size_t card() { return cards_++ % count_ + 1; }
    const Quantity& quantity_;
    std::size_t count_, cards_ = 0;
    std::map<std::uint64_t, std::size_t> share_of_; ///< by a hash: two surfaces that collide merely stay together
};

/// One share as a file: a line for people, a line of JSON, then each row after its number in the whole table.
struct Shard {
    std::string name;    ///< of the table that the shares make
    std::string kind;    ///< "table" or "rows": how the rows are made into one
    std::string spec;    ///< SHA-256 of all that the table is: quantity, digits, and the inputs of all its rows
    std::string version; ///< of the program that made it
    Share share;
    std::size_t total = 0; ///< rows of the whole table
    std::string about;     ///< JSON: what the first page of the table needs to know
    struct Row {
        std::size_t number; ///< from 1
        std::string line;   ///< without its end
    };
    std::vector<Row> rows{}; ///< ascending

    /// The same share of the same table by the same program.
    bool same_as(const Shard& other) const;
    std::string file_name() const; ///< contact_area.shard-03-of-16.txt
};

/// How every such file begins.
inline constexpr std::string_view shard_mark = "# Touchstone shard ";

std::string format_shard(const Shard&);
/// \throws CorruptTable: one line, what is wrong with the file
Shard parse_shard(std::string_view text, std::string_view file);

/// Numbers as a job array takes them: {3, 7, 8, 9} is "3,7-9".
std::string array_text(const std::vector<std::size_t>& ascending);

/// The table that these shares make, as compute() would have made it. \pre all shares of one table of this program's quantities, rows
/// complete \throws CorruptTable: where it is not the table that they say
Table table_of_shards(const std::vector<Shard>&);
/// The share of a table that is there to be computed: without rows, but with all that identifies it.
Shard shard_of(const TableSpec&, long digits, Share);
/// The numbers of its rows, from 1.
std::vector<std::size_t> rows_of_share(const TableSpec&, Share);
/// Rows as they stand in a shard. \param numbers of the rows of `part`
std::vector<Shard::Row> shard_rows(const Table& part, const std::vector<std::size_t>& numbers);

} // namespace touchstone
