// SPDX-License-Identifier: MIT
/// \file
/// Certified reference tables in any C++17 test suite: copy this one header, nothing else is needed.
///
///     #include "touchstone_reference.hpp"
///     TEST_CASE("half-width")                      // doctest, Catch2; EXPECT_TRUE in GoogleTest
///     {
///         const auto table = touchstone_reference::load("westergaard_half_width.txt");
///         const auto wrong = table.failing([](const auto& x) { return my_half_width(x[0]); });
///         INFO(touchstone_reference::message(wrong)); // inputs as hexfloats, answer, true value, error
///         CHECK(wrong.empty());
///     }
///
/// A row passes within 4 ulps beyond what the rounding of its inputs forces (the table's last column), or within tolerances of your own:
/// `Tolerance t; t.rtol = 1e-9; table.failing(f, t, [](const auto& x) { return x[0] < 1; })`.
///
/// Decimals and doubles are compared as big integers, exactly; an error in ulps is right to a part in 10^12.
/// load() checks form and row count, and that no error bound is large, but not the SHA-256 in the
/// header (`touchstone judge` and the Python module do).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace touchstone_reference {

/// least <= error in ulps <= most.
struct Interval {
    double least; ///< certainly no less
    double most;  ///< certainly no more
};

namespace detail {

/// A natural number of any size, base 10^9, lowest limb first: enough to compare a decimal with a double exactly.
class Big {
public:
    explicit Big(std::uint64_t v = 0) ///< the number v
    {
        for (; v > 0; v /= base) limbs_.push_back(static_cast<std::uint32_t>(v % base));
    }
    void times(std::uint32_t factor, std::uint32_t plus = 0) ///< multiply, then add
    {
        std::uint64_t carry = plus;
        for (auto& limb : limbs_) {
            carry += static_cast<std::uint64_t>(limb) * factor;
            limb = static_cast<std::uint32_t>(carry % base);
            carry /= base;
        }
        for (; carry > 0; carry /= base) limbs_.push_back(static_cast<std::uint32_t>(carry % base));
    }
    void times_power(std::uint32_t factor, long exponent) ///< by factor^exponent; unchanged for exponent <= 0
    {
        while (exponent > 0) { // as many at once as a limb holds
            std::uint64_t together = factor;
            for (--exponent; exponent > 0 && together * factor < static_cast<std::uint64_t>(base); --exponent) together *= factor;
            times(static_cast<std::uint32_t>(together));
        }
    }
    int compare(const Big& o) const ///< -1, 0, 1: less, equal, more
    {
        if (limbs_.size() != o.limbs_.size()) return limbs_.size() < o.limbs_.size() ? -1 : 1;
        for (std::size_t i = limbs_.size(); i-- > 0;)
            if (limbs_[i] != o.limbs_[i]) return limbs_[i] < o.limbs_[i] ? -1 : 1;
        return 0;
    }
    /// this - o for this >= o
    Big minus(const Big& o) const
    {
        Big r = *this;
        std::int64_t borrow = 0;
        for (std::size_t i = 0; i < r.limbs_.size(); ++i) {
            std::int64_t d = static_cast<std::int64_t>(r.limbs_[i]) - borrow - (i < o.limbs_.size() ? o.limbs_[i] : 0);
            borrow = d < 0 ? 1 : 0;
            r.limbs_[i] = static_cast<std::uint32_t>(d + borrow * base);
        }
        while (!r.limbs_.empty() && r.limbs_.back() == 0) r.limbs_.pop_back();
        return r;
    }
    bool zero() const { return limbs_.empty(); } ///< it is 0
    /// this/o to double, with a relative error of some 10^-15
    double over(const Big& o) const
    {
        if (zero()) return 0;
        const auto leading = [](const Big& b) {
            double v = 0;
            const std::size_t n = b.limbs_.size();
            for (std::size_t i = 0; i < 4; ++i) v = v * base + (i < n ? b.limbs_[n - 1 - i] : 0);
            return v;
        };
        return leading(*this) / leading(o) *
               std::pow(static_cast<double>(base), static_cast<double>(limbs_.size()) - static_cast<double>(o.limbs_.size()));
    }

private:
    static constexpr std::int64_t base = 1000000000;
    std::vector<std::uint32_t> limbs_;
};

/// |decimal| and doubles as integers over one common power of two and ten, so that they compare exactly.
class Common {
public:
    explicit Common(const std::string& decimal) ///< the scale is chosen so that this decimal and every double are integers
    {
        bool point = false;
        std::size_t i = 0;
        for (; i < decimal.size() && decimal[i] != 'e' && decimal[i] != 'E'; ++i) {
            point = point || decimal[i] == '.';
            if (decimal[i] < '0' || decimal[i] > '9') continue;
            value.times(10, static_cast<std::uint32_t>(decimal[i] - '0'));
            ten_ -= point ? 1 : 0;
        }
        if (i < decimal.size()) ten_ += std::strtol(decimal.c_str() + i + 1, nullptr, 10);
        value.times_power(10, ten_);
        value.times_power(2, -lowest);
    }
    /// 2^exponent
    Big power_of_two(long exponent) const { return scaled(Big(1), exponent); }
    /// |x|
    Big of(double x) const
    {
        int exponent = 0;
        const double mantissa = std::frexp(std::fabs(x), &exponent);
        const auto digits = static_cast<std::uint64_t>(std::ldexp(mantissa, 53)); // an integer below 2^53
        return exponent - 53 >= lowest ? scaled(Big(digits), exponent - 53) : scaled(Big(digits >> (lowest - exponent + 53)), lowest);
    }
    Big value; ///< |decimal|

private:
    static constexpr long lowest = -1075; ///< of the powers of two: half the smallest ulp
    Big scaled(Big b, long exponent) const
    {
        b.times_power(2, exponent - lowest);
        b.times_power(10, -ten_);
        return b;
    }
    long ten_ = 0;
};

/// |answer - decimal| in ulps of the decimal; both finite, the decimal not 0.
inline double ulps_between(double answer, const std::string& decimal)
{
    const double nearest = std::strtod(decimal.c_str(), nullptr);
    const Common common(decimal);
    int exponent = 1024;
    if (!std::isinf(nearest)) std::frexp(nearest, &exponent);
    // rounding may have carried up to the power of two above the value
    if (common.value.compare(common.power_of_two(exponent - 1)) < 0) --exponent;
    const Big unit = common.power_of_two(exponent - 53 > -1074 ? exponent - 53 : -1074);
    const Big found = common.of(answer);
    const bool opposite = answer != 0 && (answer < 0) != (decimal[0] == '-');
    if (opposite) return found.over(unit) + common.value.over(unit);
    return (found.compare(common.value) < 0 ? common.value.minus(found) : found.minus(common.value)).over(unit);
}

/// Digits, a point or none, and an exponent of at most four digits: what a longer one stands for would be millions of digits.
inline bool is_decimal(const std::string& text)
{
    const char* const digits = "0123456789";
    const std::size_t mark = std::min(text.find_first_of("eE"), text.size()), first = text.find_first_not_of("+-");
    if (first > 1 || first >= mark || text.find_first_of(digits) >= mark) return false;
    const std::size_t point = text.find('.');
    for (std::size_t i = first; i < mark; ++i)
        if (i != point && (text[i] < '0' || text[i] > '9')) return false;
    if (mark == text.size()) return true;
    const std::size_t power = mark + 1 + (mark + 1 < text.size() && (text[mark + 1] == '-' || text[mark + 1] == '+') ? 1 : 0);
    return power < text.size() && text.size() - power <= 4 && text.find_first_not_of(digits, power) == std::string::npos;
}

} // namespace detail

/// The distance of doubles at x != 0.
inline double unit_at(double x)
{
    if (std::isinf(x)) return std::ldexp(1.0, 971);
    int exponent = 0;
    std::frexp(x, &exponent);
    return std::ldexp(1.0, std::max(exponent - 53, -1074));
}

/// |answer - true value| in ulps of the true value, where `value` +- `error` is a row of a table (error <= 10^-20 |value|).
/// Infinite for NaN, and where the true value is 0 and the answer is not: zero has no ulp.
inline Interval ulps(double answer, const std::string& value, const std::string& error)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (std::isnan(answer)) return {infinity, infinity};
    if (std::isinf(answer)) {
        const bool right = std::strtod(value.c_str(), nullptr) == answer;
        return {right ? 0 : infinity, right ? 0 : infinity};
    }
    const double nearest = std::strtod(value.c_str(), nullptr);
    if (nearest == 0 && std::strtod(error.c_str(), nullptr) == 0 && value.find_first_of("123456789") == std::string::npos)
        return {answer == 0 ? 0 : infinity, answer == 0 ? 0 : infinity};
    const double distance = detail::ulps_between(answer, value);
    // the table's own bound is far below an ulp; the quotient of the two integers is rounded
    const double slack = 1e-12 * (distance + 1);
    return {distance > slack ? distance - slack : 0, distance + slack};
}

/// One line of a table.
struct Row {
    std::vector<double> inputs; ///< in the order of the columns
    std::string value;          ///< decimal, as in the file
    std::string error;          ///< bound of |value - true value|, decimal, as in the file
    double nearest;             ///< the value rounded to double
    double forced =
        -1; ///< ulps (absolute where the value is 0) that rounding the inputs once can cost any code, four times the column where the
            ///< table's header calls that estimated; -1: not known
};
constexpr double estimated_margin = 4; ///< as in `touchstone judge`

/// A row passes if |answer - value| <= atol + rtol |value|, or <= `ulps` units in the last place, and what its rounded inputs force beyond
/// that.
struct Tolerance {
    double rtol = 0;            ///< relative
    double atol = 0;            ///< absolute
    double ulps = 4;            ///< units in the last place
    bool forgive_inputs = true; ///< false: what rounded inputs force is not allowed beyond that
};

/// The row on which a code is farthest off.
struct Worst {
    const Row* row = nullptr;   ///< of the table asked; null if it has none
    double answer = 0;          ///< the code's
    double ulps = 0;            ///< certainly no less
    std::string message() const ///< one line: inputs and answer as hexfloats, to be replayed
    {
        if (row == nullptr) return "no rows";
        char text[64];
        std::string m = "inputs";
        for (const double x : row->inputs) {
            std::snprintf(text, sizeof text, " %a", x);
            m += text;
        }
        std::snprintf(text, sizeof text, ", answer %a, error %.3g ulps, true value ", answer, ulps);
        return m + text + row->value;
    }
};

/// One line for each of the first rows, and how many there are.
inline std::string message(const std::vector<Worst>& rows, std::size_t most = 5)
{
    std::string text = std::to_string(rows.size()) + " rows fail\n";
    for (std::size_t i = 0; i < rows.size() && i < most; ++i) text += rows[i].message() + "\n";
    return text;
}

/// A table read from its file.
struct Table {
    std::string name;      ///< as its header gives it
    std::vector<Row> rows; ///< in the order of the file

    /// All rows that fail, in the table's order; of those that `where` chooses. f and where take the inputs as a std::vector<double>.
    template <class F, class Where>
    std::vector<Worst> failing(F&& f, const Tolerance& t, Where&& where) const
    {
        std::vector<Worst> wrong;
        for (const Row& row : rows) {
            if (!where(row.inputs)) continue;
            const double answer = f(row.inputs);
            const double off = ulps(answer, row.value, row.error).least, forced = t.forgive_inputs && row.forced > 0 ? row.forced : 0;
            bool right = false;
            if (row.nearest == 0) right = std::fabs(answer) <= t.atol + forced;
            else {
                const double unit = unit_at(row.nearest);
                right = off <= std::max(t.ulps, t.atol / unit + t.rtol * (std::fabs(row.nearest) / unit)) + forced;
            }
            if (!right) wrong.push_back({&row, answer, off}); // nan too
        }
        return wrong;
    }
    /// The same of all rows.
    template <class F>
    std::vector<Worst> failing(F&& f, const Tolerance& t = {}) const
    {
        return failing(std::forward<F>(f), t, [](const std::vector<double>&) { return true; });
    }

    /// f takes the inputs as a std::vector<double>.
    template <class F>
    Worst worst(F&& f) const
    {
        Worst w;
        for (const Row& row : rows) {
            const double answer = f(row.inputs);
            const double off = ulps(answer, row.value, row.error).least;
            if (w.row == nullptr || off > w.ulps) w = {&row, answer, off};
        }
        return w;
    }
};

/// \throws std::runtime_error with one line if the file cannot be read or is cut off
inline Table load(const std::string& file)
{
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": no such table");
    Table table;
    std::size_t announced = 0, columns = 0;
    bool with_forced = false;
    double margin = 1;
    for (std::string line; std::getline(in, line);) {
        if (line.compare(0, 3, "# {") == 0) {
            const auto name = line.find("\"name\":\""), rows = line.find("\"rows\":");
            if (name != std::string::npos) table.name = line.substr(name + 8, line.find('"', name + 8) - name - 8);
            if (rows != std::string::npos) announced = std::strtoul(line.c_str() + rows + 7, nullptr, 10);
            if (line.find("\"forced\":\"estimated\"") != std::string::npos) margin = estimated_margin;
        }
        if (!line.empty() && line[0] == '#') {
            columns = 0;
            with_forced = line.find(" value error forced") != std::string::npos;
            for (std::size_t i = 1; i < line.size(); ++i) columns += line[i - 1] == ' ' && line[i] != ' ';
            continue;
        }
        std::vector<std::string> words;
        for (std::size_t i = 0; (i = line.find_first_not_of(" \r", i)) != std::string::npos;) {
            const auto end = line.find_first_of(" \r", i);
            words.push_back(line.substr(i, end - i));
            if (end == std::string::npos) break;
            i = end;
        }
        if (words.size() != columns || columns < (with_forced ? 3u : 2u))
            throw std::runtime_error(file + ": a row has the wrong number of columns: " + line);
        Row row;
        const std::size_t inputs = columns - (with_forced ? 3 : 2);
        for (std::size_t i = 0; i < inputs; ++i) row.inputs.push_back(std::strtod(words[i].c_str(), nullptr));
        row.value = words[inputs];
        row.error = words[inputs + 1];
        if (!detail::is_decimal(row.value) || !detail::is_decimal(row.error))
            throw std::runtime_error(file + ": value and error are not decimal numbers: " + line);
        char* end = nullptr;
        if (with_forced) {
            row.forced = std::strtod(words.back().c_str(), &end);
            if (*end != 0 || !(row.forced >= 0 || row.forced == -1) || std::isinf(row.forced))
                throw std::runtime_error(file + ": what inputs force is no number: " + line);
            if (row.forced > 0) row.forced *= margin;
        }
        const double bound = std::strtod(row.error.c_str(), &end);
        if (end == row.error.c_str() || *end != 0 || !(bound >= 0) || std::isinf(bound))
            throw std::runtime_error(file + ": an error bound is no finite number >= 0: " + line);
        row.nearest = std::strtod(row.value.c_str(), &end);
        if (*end != 0 || std::isnan(row.nearest)) throw std::runtime_error(file + ": a value is no number: " + line);
        if (bound > 1e-20 * std::fabs(row.nearest))
            throw std::runtime_error(file + ": an error bound is too large to test a double by: " + line);
        table.rows.push_back(std::move(row));
    }
    if (table.rows.empty() || table.rows.size() != announced) throw std::runtime_error(file + ": cut off, or no canonical table");
    return table;
}

} // namespace touchstone_reference
