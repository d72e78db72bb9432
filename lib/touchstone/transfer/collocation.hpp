// SPDX-License-Identifier: MIT
/// \file
/// V_0, V_1, ...: piecewise polynomials near B_0, B_1 = T B_0, ... by collocation, on a mesh that is halved where needed. A search: nothing
/// here is trusted (defects.hpp proves how far V_m are from B_m). Internal to transfer/.
#pragma once

#include "touchstone/transfer/layer.hpp"
#include "touchstone/transfer/level_zero.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace touchstone::transfer::levels {

constexpr double lowest_of_densities = 1e-35; ///< first panel

/// mu_x(J) = (T 1_J)(x) for any x and |J| = width: proven_levels.md (2)
double largest_share(double G, double width);
/// T^2 1_J: proven_levels.md, 5
double largest_second_share(double G, double width);

/// Points and weights for a tolerance.
struct Rules {
    Orders orders;
    Gauss gauss, exact;
    ChebyshevPoints own, kernel_points;
    explicit Rules(double tolerance)
        : orders(tolerance)
        , gauss(orders.gauss)
        , exact(orders.terms)
        , own(orders.terms)
        , kernel_points(orders.kernel)
    {
    }
};

/// Columns of a layer of so many levels: a multiple of four for the sums in wave_kernel.hpp, or 1.
constexpr int columns_for(int levels) { return levels == 1 ? 1 : (levels + 3) / 4 * 4; }

Layer layer_on(const Rules&, const Real& G, double tolerance, std::vector<Panel>, int columns);

/// The Chebyshev series of the polynomials through f, a function of z, at the nodes of the panels: [panel * terms + k].
Wide series_through(const Rules&, const std::vector<Panel>&, const std::function<Real(const Real& z)>& f);
/// The same from the values at the nodes, [panel * terms + i].
Wide series_of(const Rules&, const Wide& nodal);

/// What V_m is made worse by on the panel y0 <= y <= y1, for tests.
using Spoiled = std::function<double(int m, double y0, double y1)>;

/// V_0 ... V_(levels-1) up to `highest`, on one mesh. \throws BeyondReach where that would be too large
std::unique_ptr<Layer> collocate(const Rules&, const First&, const Real& G, double highest, double tolerance, int levels,
                                 const Spoiled& = {});

} // namespace touchstone::transfer::levels
