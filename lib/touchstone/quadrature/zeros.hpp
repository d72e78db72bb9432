// SPDX-License-Identifier: MIT
/// \file
/// Zeros that a compiled formula has at the ends of the range and that its sums do not show (internal; see compiled.hpp).
#pragma once

#include "touchstone/quadrature/compiled.hpp"
#include "touchstone/quadrature/exact_series.hpp"

#include <functional>
#include <optional>
#include <utility>

namespace touchstone::quadrature::compiled {

class Zeros {
public:
    explicit Zeros(const Place& place)
        : place_(place)
    {
    }
    /// The zero that the exact expansion about the end shows and the sum of terms does not. \param expand is asked only where it is needed
    using Expand = std::function<std::optional<ExactSeries>()>;
    /// \param beyond_the_range whether the disc may be larger than a small range, and have the other end in it
    std::optional<Zero> at(const Node&, Side, const Expand& expand, bool beyond_the_range) const;
    /// Of h(s) - h(-s) at the left end, which is 0. \param h as it stands, compiled for no range
    std::optional<Zero> of_odd_difference(const Node&, const Node& h) const;

private:
    std::optional<Exponent> order_beside(const Node&, Side, const Ball& distance) const;
    bool shows_its_order(const Node&, Side, const Ball& radius) const;
    std::optional<std::pair<Exponent, Ball>> bound_on_disc(const Node&, Side, const Ball& radius) const;
    static bool is_analytic_about_circle(const Node& plain, const Ball& radius);

    const Place& place_;
};

} // namespace touchstone::quadrature::compiled
