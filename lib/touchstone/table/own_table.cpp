// SPDX-License-Identifier: MIT
#include "touchstone/table/own_table.hpp"

#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/table/json_text.hpp"
#include "touchstone/table/ranges.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace touchstone {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<double>>;

constexpr std::size_t most_rows = 1'000'000;
constexpr std::size_t longest_name = 100;

class Reader {
public:
    Reader(std::string_view json, std::string_view file) : file_(file), json_(Json::parse(shallow(json), nullptr, false))
    {
        if (!json_.is_object()) throw wrong("is not a JSON object such as {\"name\": ..., \"quantity\": ..., \"inputs\": {...}}");
        for (const auto& [key, unused] : json_.items())
            if (key != "name" && key != "quantity" && key != "digits" && key != "inputs" && key != "columns" && key != "rows")
                throw wrong(fmt::format("unknown key '{:.40}'; known are name, quantity, digits, inputs, columns, rows", key));
        if (json_.contains("inputs") == json_.contains("rows")) throw wrong("needs either inputs (all combinations) or columns and rows");
    }

    TableSpec spec()
    {
        TableSpec t;
        t.name = text_of("name");
        const auto allowed = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; };
        if (t.name.empty() || t.name.size() > longest_name || !std::all_of(t.name.begin(), t.name.end(), allowed))
            throw wrong("name: must be made of letters, digits, _ and -: it names the table's file");
        if (find_table(t.name) != nullptr) throw wrong(fmt::format("name: '{}' is a table that comes with the program", t.name));
        t.quantity = text_of("quantity");
        quantity_ = find_quantity(t.quantity);
        if (quantity_ == nullptr)
            throw wrong(fmt::format("unknown quantity '{:.40}'; nearest is '{}'", t.quantity, nearest_name(t.quantity, quantity_names())));
        if (json_.contains("digits")) {
            if (!json_["digits"].is_number_integer() || json_["digits"] < 1 || json_["digits"] > 10'000)
                throw wrong("digits: must be an integer from 1 to 10000");
            t.digits = json_["digits"].get<long>();
        }
        else t.digits = EvaluationOptions{}.digits;
        Rows rows = json_.contains("inputs") ? combinations() : written();
        if (rows.empty()) throw wrong("no rows");
        if (std::set<std::vector<double>>(rows.begin(), rows.end()).size() != rows.size()) throw wrong("a row comes out twice");
        t.grid = [rows = std::move(rows)] { return rows; };
        return t;
    }

private:
    DomainError wrong(const std::string& what) const { return DomainError(fmt::format("{}: {}", file_, what)); }

    std::string text_of(const char* key) const
    {
        if (!json_.contains(key) || !json_[key].is_string()) throw wrong(fmt::format("{}: a text is missing", key));
        return json_[key].get<std::string>();
    }

    /// A number or a text as a text.
    std::string word(const Json& j, const std::string& key) const
    {
        if (j.is_string()) return j.get<std::string>();
        if (j.is_number_integer()) return j.dump();
        if (j.is_number()) return fmt::format("{}", j.get<double>());
        throw wrong(fmt::format("{}: '{:.40}' is neither a number nor a text", key, j.dump()));
    }

    std::vector<double> row(const std::vector<std::string>& words) const
    {
        std::vector<double> doubles;
        NamedTexts named;
        for (std::size_t k = 0; k < words.size(); ++k) named.emplace_back(quantity_->inputs[k], words[k]);
        try {
            const Inputs in = read_inputs(*quantity_, named);
            std::map<std::string, Rational> values;
            for (const auto& name : quantity_->inputs) {
                const WorkingPrecision precision(256);
                const auto x = in.has(name) ? nearest_double(in.real(name)) : nearest_double(in.G_ball()).value_or(NAN);
                if (!std::isfinite(x)) throw DomainError(fmt::format("{}: no binary64 number is nearest", name));
                doubles.push_back(x);
                values[name] = exact_rational(x);
            }
            quantity_->check(Inputs(values));
        }
        catch (const DomainError& e) {
            throw wrong(e.what());
        }
        return doubles;
    }

    Rows combinations() const
    {
        const Json& inputs = json_["inputs"];
        if (!inputs.is_object()) throw wrong("inputs: must be an object of names and values");
        std::vector<std::string> keys;
        for (const auto& [key, unused] : inputs.items()) keys.push_back(key);
        expect_keys(keys);
        std::vector<std::vector<std::string>> axes;
        std::size_t total = 1;
        for (const auto& name : quantity_->inputs) {
            std::vector<std::string> axis;
            const Json& given = inputs[name];
            for (const Json& j : given.is_array() ? given : Json::array({given})) add(axis, word(j, name));
            total = axis.empty() ? 0 : total > most_rows / axis.size() ? most_rows + 1 : total * axis.size();
            axes.push_back(std::move(axis));
        }
        if (total > most_rows) throw wrong(fmt::format("more than {} rows", most_rows));
        Rows rows;
        for (std::size_t i = 0; i < total; ++i) {
            std::vector<std::string> words(axes.size());
            std::size_t rest = i;
            for (std::size_t k = axes.size(); k-- > 0; rest /= axes[k].size()) words[k] = axes[k][rest % axes[k].size()];
            rows.push_back(row(words));
        }
        return rows;
    }

    void add(std::vector<std::string>& axis, const std::string& text) const
    {
        try {
            const Range range(text);
            if (range.size() > most_rows) throw wrong(fmt::format("more than {} rows", most_rows));
            for (std::size_t i = 0; i < range.size(); ++i) axis.push_back(range.at(i));
        }
        catch (const DomainError& e) {
            throw wrong(e.what());
        }
    }

    Rows written() const
    {
        if (!json_.contains("columns") || !json_["columns"].is_array() || !json_["rows"].is_array())
            throw wrong("rows: needs columns, and both must be arrays");
        std::vector<std::string> columns;
        for (const Json& j : json_["columns"]) columns.push_back(word(j, "columns"));
        expect_keys(columns);
        Rows rows;
        for (const Json& j : json_["rows"]) {
            if (!j.is_array() || j.size() != columns.size())
                throw wrong(fmt::format("row {}: must have {} numbers", rows.size() + 1, columns.size()));
            std::vector<std::string> words;
            for (const auto& name : quantity_->inputs) {
                const auto place = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin());
                words.push_back(word(j[place], name));
            }
            rows.push_back(row(words));
        }
        return rows;
    }

    /// In a table the inputs are the quantity's own, G too.
    void expect_keys(const std::vector<std::string>& keys) const
    {
        try {
            check_keys(*quantity_, keys);
        }
        catch (const WrongKeys& e) {
            throw WrongKeys(fmt::format("{}: {}", file_, e.what()));
        }
        for (const auto& name : quantity_->inputs)
            if (std::find(keys.begin(), keys.end(), name) == keys.end())
                throw WrongKeys(fmt::format("{}: a table takes {}", file_, fmt::join(quantity_->inputs, ", ")));
    }

    std::string file_;
    Json json_;
    const Quantity* quantity_ = nullptr;
};

} // namespace

TableSpec own_table(std::string_view json, std::string_view file) { return Reader(json, file).spec(); }

} // namespace touchstone
