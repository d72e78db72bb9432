// SPDX-License-Identifier: MIT
#include "touchstone/binding/touchstone.h"

#include "touchstone/catalogue/directed.hpp"
#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/scalar/thread_caches.hpp"
#include "touchstone/table/format.hpp"
#include "touchstone/table/working_order.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <sstream>

struct touchstone_value {
    touchstone::Evaluation result;
};

namespace {

using namespace touchstone;

static_assert(static_cast<int>(Status::exact) == TOUCHSTONE_EXACT && static_cast<int>(Status::certified) == TOUCHSTONE_CERTIFIED);
static_assert(static_cast<int>(Status::estimated) == TOUCHSTONE_ESTIMATED &&
              static_cast<int>(Status::undecided) == TOUCHSTONE_STATUS_UNDECIDED);

/// Enough that a binary64 number is decided, but next to a tie of two.
constexpr long digits_for_doubles = 20;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

int say(touchstone_code code, std::string_view text, char* message, std::size_t size)
{
    if (message != nullptr && size > 0) {
        const std::size_t length = std::min(text.size(), size - 1);
        std::memcpy(message, text.data(), length);
        message[length] = '\0';
    }
    return code;
}

/// Whatever is thrown inside becomes a code and a line. `run` says its own for what is no error.
template <class Run>
int guarded(char* message, std::size_t size, Run&& run) noexcept
{
    try {
        release_caches_with_thread(); // threads are the caller's, and what we had FLINT keep for them is ours
        return run();
    }
    catch (const WrongKeys& e) {
        return say(TOUCHSTONE_USAGE, e.what(), message, size);
    }
    catch (const DomainError& e) {
        return say(TOUCHSTONE_BAD_INPUT, e.what(), message, size);
    }
    catch (const std::bad_alloc&) {
        return say(TOUCHSTONE_INTERNAL, "out of memory", message, size);
    }
    catch (const std::exception& e) {
        return say(TOUCHSTONE_INTERNAL, e.what(), message, size);
    }
    catch (...) {
        return say(TOUCHSTONE_INTERNAL, "unknown error", message, size);
    }
}

const Quantity& quantity_called(const char* name)
{
    if (name == nullptr) throw WrongKeys("the quantity is a null pointer");
    if (const Quantity* q = find_quantity(name)) return *q;
    throw WrongKeys(fmt::format("unknown quantity '{:.60}'; nearest is '{}'", name,
                                nearest_name(std::string_view(name).substr(0, 60), quantity_names())));
}

NamedTexts named_texts(const char* inputs)
{
    NamedTexts named;
    std::istringstream words(inputs == nullptr ? "" : inputs);
    for (std::string word; words >> word;) {
        const auto equals = word.find('=');
        if (equals == std::string::npos || equals == 0) throw WrongKeys(fmt::format("'{:.60}' is not KEY=VALUE", word));
        named.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    }
    return named;
}

Inputs inputs_of_row(const Quantity& q, const double* row)
{
    std::map<std::string, Rational> values;
    for (std::size_t k = 0; k < q.inputs.size(); ++k) {
        if (!std::isfinite(row[k])) throw DomainError(fmt::format("{} = {}: must be finite", q.inputs[k], row[k]));
        values[q.inputs[k]] = exact_rational(row[k]);
    }
    Inputs in(values);
    q.check(in);
    return in;
}

/// What the rows came to: the worst code and the first row with it.
class Outcome {
public:
    void add(touchstone_code code, std::size_t row, const std::string& why)
    {
        if (code < worst_ || (code == worst_ && row >= row_)) return;
        worst_ = code;
        row_ = row;
        text_ = fmt::format("row {}: {}", row + 1, why);
    }
    int say(char* message, std::size_t size) const { return ::say(worst_, text_, message, size); }

private:
    touchstone_code worst_ = TOUCHSTONE_OK;
    std::size_t row_ = 0;
    std::string text_;
};

int evaluate_rows(const Quantity& q, const double* inputs, std::size_t rows, double* values, int* how, char* message, std::size_t size)
{
    std::vector<std::size_t> rest; // rows that take an evaluation
    std::vector<Inputs> exact;     // of those
    Outcome outcome;
    for (std::size_t i = 0; i < rows; ++i) {
        const double* const row = inputs + i * q.inputs.size();
        const auto nearest = q.nearest ? q.nearest(row) : std::nullopt;
        values[i] = nearest.value_or(not_a_number);
        if (how != nullptr) how[i] = !nearest ? TOUCHSTONE_REFUSED : *nearest == 0 ? TOUCHSTONE_EXACT : TOUCHSTONE_CERTIFIED;
        if (nearest) continue;
        try {
            exact.push_back(inputs_of_row(q, row));
            rest.push_back(i);
        }
        catch (const DomainError& e) {
            outcome.add(TOUCHSTONE_BAD_INPUT, i, e.what());
        }
    }
    std::vector<const Inputs*> wanted;
    for (const Inputs& in : exact) wanted.push_back(&in);
    for (const std::size_t k : working_order(q, wanted)) {
        const std::size_t i = rest[k];
        const Evaluation e = evaluate(q, exact[k], {.digits = digits_for_doubles});
        if (how != nullptr) how[i] = static_cast<int>(e.status);
        if (e.binary64) values[i] = *e.binary64;
        else outcome.add(TOUCHSTONE_UNDECIDED, i, e.note.empty() ? "the nearest binary64 number is not decided" : e.note);
    }
    return outcome.say(message, size);
}

} // namespace

extern "C" {

int touchstone_abi(void) { return 1; }

const char* touchstone_version(void)
{
    static const std::string text(version());
    return text.c_str();
}

int touchstone_eval(const char* quantity, const char* inputs, long digits, const char* rounding, touchstone_value** value, char* message,
                    size_t size)
{
    if (value != nullptr) *value = nullptr;
    return guarded(message, size, [&] {
        if (value == nullptr) throw WrongKeys("there is nowhere to put the value: a null pointer");
        const Quantity& q = quantity_called(quantity);
        const auto how = rounding_named(rounding == nullptr ? "nearest" : rounding);
        if (!how) throw WrongKeys(fmt::format("rounding '{:.60}' is none of nearest, up, down, zero, away", rounding));
        auto v = std::make_unique<touchstone_value>();
        v->result = evaluate(q, read_inputs(q, named_texts(inputs)), {.digits = digits}, *how);
        *value = v.release();
        const Evaluation& e = (*value)->result;
        return say(e.status == Status::undecided ? TOUCHSTONE_UNDECIDED : TOUCHSTONE_OK, e.note, message, size);
    });
}

int touchstone_eval_rows(const char* quantity, const double* inputs, size_t rows, size_t columns, double* values, int* how, char* message,
                         size_t size)
{
    return guarded(message, size, [&] {
        const Quantity& q = quantity_called(quantity);
        if (columns != q.inputs.size()) throw WrongKeys(fmt::format("{} has {} inputs, not {}", q.name, q.inputs.size(), columns));
        if (rows > 0 && (values == nullptr || (inputs == nullptr && columns > 0))) throw WrongKeys("inputs or values are a null pointer");
        return evaluate_rows(q, inputs, rows, values, how, message, size);
    });
}

void touchstone_free(touchstone_value* v) { delete v; }

const char* touchstone_decimal(const touchstone_value* v) { return v == nullptr ? "nan" : v->result.value.c_str(); }
const char* touchstone_error(const touchstone_value* v) { return v == nullptr ? "inf" : v->result.error_bound.c_str(); }
int touchstone_status(const touchstone_value* v)
{
    return v == nullptr ? static_cast<int>(TOUCHSTONE_STATUS_UNDECIDED) : static_cast<int>(v->result.status);
}
const char* touchstone_note(const touchstone_value* v) { return v == nullptr ? "" : v->result.note.c_str(); }
double touchstone_double(const touchstone_value* v) { return v == nullptr ? not_a_number : v->result.binary64.value_or(not_a_number); }
long touchstone_digits(const touchstone_value* v) { return v == nullptr ? 0 : v->result.digits; }

const char* touchstone_quantity(size_t index)
{
    const char* name = nullptr;
    guarded(nullptr, 0, [&] {
        if (index < catalogue().size()) name = catalogue()[index].name.c_str();
        return 0;
    });
    return name;
}

const char* touchstone_quantity_text(const char* quantity, const char* what)
{
    const char* text = nullptr;
    guarded(nullptr, 0, [&] {
        const Quantity& q = quantity_called(quantity);
        const std::string_view field = what == nullptr ? "" : what;
        if (field == "equation") text = q.equation.c_str();
        if (field == "unit") text = q.unit.c_str();
        if (field == "domain") text = q.domain.c_str();
        if (field == "description") text = q.description.c_str();
        return 0;
    });
    return text;
}

const char* touchstone_quantity_input(const char* quantity, size_t index)
{
    const char* name = nullptr;
    guarded(nullptr, 0, [&] {
        const Quantity& q = quantity_called(quantity);
        if (index < q.inputs.size()) name = q.inputs[index].c_str();
        return 0;
    });
    return name;
}

} // extern "C"
