// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/figures/tables.hpp"

#include "touchstone/paper/segments.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace touchstone::data { // compiled in, see CMakeLists.txt
std::string_view contact_area_text();
std::string_view contact_area_full_text();
std::string_view contact_area_heavy_text();
std::string_view contact_density_text();
std::string_view limit_constant_text();
std::string_view limit_constant_full_text();
std::string_view segments_density_text();
std::string_view figure5_density_text();
std::string_view figure5_segments_text();
std::string_view hertzian_share_text();
} // namespace touchstone::data

namespace touchstone::figures {
namespace {

using Rows = std::vector<std::vector<double>>;

constexpr double sqrt_5 = 2.2360679774997896;  ///< G at D = 1.5, gamma = 5
constexpr double sqrt_10 = 3.1622776601683795; ///< G at D = 1.5, gamma = 10
constexpr double figure_5_load = 0.001;

/// C libraries may differ in the last bits: 40 bits are kept, so that the rows cannot.
double rounded(double x)
{
    int e = 0;
    const double m = std::frexp(x, &e);
    return std::ldexp(std::nearbyint(std::ldexp(m, 40)), e - 40);
}

/// Across the support, denser at both ends, where the curves bend.
std::vector<double> shares()
{
    std::vector<double> all{0.002, 0.005, 0.01, 0.02, 0.03};
    for (int k = 1; k < 15; ++k) all.push_back(0.04 * k);
    for (int k = 30; k < 49; ++k) all.push_back(0.02 * k);
    for (const double s : {0.97, 0.98, 0.985, 0.99, 0.995, 0.999}) all.push_back(s);
    return all;
}

/// The scales drawn as lines; scale 20 is in data/reference.
constexpr std::array dense_scales{0L, 1L, 2L, 3L, 5L, 10L};

Rows density_rows()
{
    Rows rows;
    for (const long n : dense_scales) {
        const double top = std::pow(sqrt_10, static_cast<double>(n + 1)) * peaks::iterate(n, figure_5_load, sqrt_10);
        for (const double s : shares()) rows.push_back({static_cast<double>(n), rounded(s * top), figure_5_load, sqrt_10});
    }
    return rows;
}

Rows segments_rows()
{
    Rows rows;
    for (const long n : dense_scales) {
        if (n == 0) continue;
        const double widest = segments::max_half_width(n, figure_5_load, sqrt_10);
        for (const double s : shares()) rows.push_back({static_cast<double>(n), rounded(s * widest), figure_5_load, sqrt_10});
    }
    return rows;
}

/// Q_{n-1} at a fifth of p*_n: what exceeds it lies under contacts that (2.8) does not call Hertzian.
Rows hertzian_rows()
{
    Rows rows;
    for (const double G : {sqrt_5, sqrt_10})
        for (const double load : {0.001, 0.1})
            for (int n = 1; n <= 4; ++n) rows.push_back({static_cast<double>(n - 1), rounded(std::pow(G, n) / 5), load, G});
    return rows;
}

std::string_view text_of(const std::string& table)
{
    static const std::map<std::string, std::string_view (*)()> texts{{"contact_area", data::contact_area_text},
                                                                     {"contact_area_full", data::contact_area_full_text},
                                                                     {"contact_area_heavy", data::contact_area_heavy_text},
                                                                     {"contact_density", data::contact_density_text},
                                                                     {"limit_constant", data::limit_constant_text},
                                                                     {"limit_constant_full", data::limit_constant_full_text},
                                                                     {"segments_density", data::segments_density_text},
                                                                     {"figure5_density", data::figure5_density_text},
                                                                     {"figure5_segments", data::figure5_segments_text},
                                                                     {"hertzian_share", data::hertzian_share_text}};
    return texts.at(table)();
}

} // namespace

const std::vector<TableSpec>& figure_tables()
{
    static const std::vector<TableSpec> all{
        {"figure5_density", "contact.density", 8, density_rows, true},
        {"figure5_segments", "segments.density", 8, segments_rows, true},
        {"hertzian_share", "contact.exceedance", 8, hertzian_rows, true},
    };
    return all;
}

std::string_view compiled_in(const std::string& table) { return text_of(table); }

std::string stored_form(const Table& t)
{
    std::string text = format(t, "txt");
    const std::string said = fmt::format("touchstone table {} --digits {}", t.name, t.digits);
    if (const auto at = text.find(said); at != std::string::npos) text.replace(at, said.size(), recompute_command);
    return text;
}

Data::Data(const std::string& table)
    : table_(parse_table(text_of(table), table + ".txt"))
    , status_(nlohmann::json::parse(table_.header_json).at("status").get<std::string>())
{
    const WorkingPrecision precision(192);
    for (const auto& row : table_.rows) values_.emplace(row.inputs, ball(row));
}

Ball Data::ball(const StoredTable::Row& row) const
{
    const Rational value = *parse_rational(row.value), error = *parse_rational(row.error);
    return hull(Ball(Rational(value - error)), Ball(Rational(value + error)));
}

const Ball& Data::at(const std::vector<double>& inputs) const { return values_.at(inputs); }

} // namespace touchstone::figures
