// SPDX-License-Identifier: MIT
#include "touchstone/table/table.hpp"

#include "touchstone/scalar/thread_caches.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace touchstone {

Status Table::status() const
{
    Status weakest = Status::exact;
    for (const auto& r : rows) weakest = std::max(weakest, r.result.status);
    return weakest;
}

Table compute(const TableSpec& spec, long digits, unsigned jobs,
              const std::function<void(std::size_t, std::size_t)>& progress)
{
    Table table;
    table.name = spec.name;
    table.quantity = find_quantity(spec.quantity);
    table.inputs = table.quantity->inputs;
    table.digits = digits;
    table.forced = spec.forced;
    const auto grid = spec.grid();
    table.rows.resize(grid.size());

    std::atomic<std::size_t> next{0};
    std::size_t done = 0;
    std::exception_ptr failure;
    std::mutex mutex;
    const auto work = [&] {
        release_caches_with_thread();
        for (std::size_t i; (i = next++) < grid.size();) {
            try {
                std::map<std::string, Rational> values;
                for (std::size_t k = 0; k < grid[i].size(); ++k) values[table.inputs[k]] = exact_rational(grid[i][k]);
                EvaluationOptions options;
                options.digits = digits;
                TableRow& row = table.rows[i];
                row = {grid[i], evaluate(*table.quantity, Inputs(values), options), {}};
                if (table.forced) row.forced = forced_ulps(*table.quantity, grid[i], *parse_rational(row.result.value));
            }
            catch (...) {
                const std::scoped_lock lock(mutex);
                if (!failure) failure = std::current_exception();
                next = grid.size();
            }
            const std::scoped_lock lock(mutex);
            ++done;
            if (progress) progress(done, grid.size());
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned j = 0; j < std::max(1u, jobs); ++j) threads.emplace_back(work);
    }
    if (failure) std::rethrow_exception(failure);
    return table;
}

const TableSpec* find_table(std::string_view name)
{
    const auto& all = table_specs();
    const auto it = std::find_if(all.begin(), all.end(), [name](const TableSpec& t) { return t.name == name; });
    return it == all.end() ? nullptr : &*it;
}

std::vector<std::string> table_names()
{
    std::vector<std::string> names;
    for (const auto& t : table_specs()) names.push_back(t.name);
    return names;
}

} // namespace touchstone
