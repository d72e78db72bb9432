// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The fields of a ledger of one's own as JSON has them: each of its type, or one line that says where it is not.
#pragma once

#include "proofs/own/own_ledger.hpp"

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <string>
#include <utility>

namespace touchstone::proofs {

/// Says "FILE: entry 'ID': ..." whatever goes wrong inside.
class Place {
public:
    explicit Place(std::string where) : where_(std::move(where)) {}
    [[noreturn]] void fail(const std::string& what) const { throw OwnLedgerError(where_ + ": " + what); }
    Place in(const std::string& more) const { return Place(where_ + ": " + more); }

private:
    std::string where_;
};

/// Of two keys of one name the last would be taken, and the other one not be seen.
nlohmann::json::parser_callback_t no_key_twice(const Place& at);

/// An object of which every key must be known.
void only(const nlohmann::json& object, std::initializer_list<const char*> keys, const Place& at);

/// Regular expressions and the parser of formulas go deeper with the length of a text, and a stack has an end.
const std::string& of_some_length(const std::string& text, const Place& at);
std::string text(const nlohmann::json& object, const char* key, const Place& at, const std::string& otherwise = {});

/// A list, or an empty one where there is none.
nlohmann::json list(const nlohmann::json& object, const char* key, const Place& at);

/// A number as it stands there. JSON's numbers with a point, and very long ones, become doubles, which are other numbers.
std::string digits(const nlohmann::json& value, const Place& at);
Rational number(const nlohmann::json& value, const Place& at);
std::pair<Rational, Rational> range(const nlohmann::json& value, const Place& at);

} // namespace touchstone::proofs
