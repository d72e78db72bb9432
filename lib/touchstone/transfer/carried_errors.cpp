// SPDX-License-Identifier: MIT
#include "touchstone/transfer/carried_errors.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::transfer {
namespace {

constexpr std::size_t most_powers = 7; // |B|, |B^2|, ... |B^64|
constexpr double up = 1 + 1e-9;        // covers the roundings of any of the sums below
constexpr double least_entry = 0x1p-400, least_error = 0x1p-900;

double largest(const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); }

} // namespace

std::vector<double> moduli(const std::vector<double>& near, double off)
{
    std::vector<double> all;
    for (const double w : near) all.push_back(std::max((std::fabs(w) + off) * up, least_entry));
    return all;
}

void CarriedErrors::add_row(const std::vector<double>& near, double off)
{
    near_.insert(near_.end(), near.begin(), near.end());
    const std::vector<double> most = moduli(near, off / off_); // so that off_ covers what is beyond 2^-52, too
    majorant_.insert(majorant_.end(), most.begin(), most.end());
}

void CarriedErrors::begin(std::vector<double> alpha)
{
    powers_.push_back(majorant_);
    for (double& a : alpha) a = std::max(a, least_error);
    errors_.push_back(std::move(alpha));
}

/// near_ = B^p + D with |D| <= off_ majorant_, majorant_ >= |B|^p: the product of two such is off by (2 off_ + off_^2) majorant_^2 and
/// its own rounding.
void CarriedErrors::square()
{
    const std::size_t N = errors_.front().size();
    std::vector<double> near(N * N), majorant(N * N);
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k < N; ++k) {
            const double a = near_[i * N + k], b = majorant_[i * N + k];
            for (std::size_t j = 0; j < N; ++j) near[i * N + j] += a * near_[k * N + j];
            for (std::size_t j = 0; j < N; ++j) majorant[i * N + j] += b * majorant_[k * N + j];
        }
    off_ = 2.1 * off_ + static_cast<double>(N + 4) * 0x1p-52;
    std::vector<double> modulus(N * N);
    for (std::size_t k = 0; k < modulus.size(); ++k) {
        majorant[k] = std::max(majorant[k] * up, least_entry);
        modulus[k] = (std::fabs(near[k]) + off_ * majorant[k]) * up;
    }
    near_ = std::move(near);
    majorant_ = std::move(majorant);
    powers_.push_back(std::move(modulus));
}

const std::vector<double>& CarriedErrors::at(std::size_t level)
{
    while (errors_.size() <= level) {
        const std::size_t terms = errors_.size() + 1;
        // A further power is worth its cost once the bounds have grown by three digits, four, ...; it takes twice as many terms.
        const double growth = largest(errors_.back()) / largest(errors_.front());
        if (powers_.size() < most_powers && growth > std::pow(10.0, static_cast<double>(powers_.size() + 2))
            && terms >= (std::size_t{2} << powers_.size()))
            square();
        const std::vector<double>& power = powers_.back();
        const std::size_t p = std::size_t{1} << (powers_.size() - 1), N = errors_.front().size();
        const std::vector<double>& rest = errors_.at(terms - p - 1); // W(terms - p)
        const std::vector<double>& sum = errors_.at(p - 1);          // W(p)
        std::vector<double> e(N);
        for (std::size_t i = 0; i < N; ++i) {
            double total = sum[i];
            for (std::size_t j = 0; j < N; ++j) total += power[i * N + j] * rest[j];
            e[i] = total * up;
        }
        errors_.push_back(std::move(e));
    }
    return errors_[level];
}

double CarriedErrors::into(const std::vector<double>& row, std::size_t level)
{
    const std::vector<double>& errors = at(level);
    double carried = least_error;
    for (std::size_t j = 0; j < row.size(); ++j) carried += row[j] * errors[j];
    return carried * up;
}

std::size_t CarriedErrors::memory() const
{
    return 8 * ((powers_.size() + 2) * near_.size() + errors_.size() * errors_.front().size());
}

} // namespace touchstone::transfer
