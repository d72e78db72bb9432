// SPDX-License-Identifier: MIT
/// \file
/// T V in binary64, for the corrections of a search: a tenth of what it costs in 106 bits. Nothing here is trusted. Internal to limit/.
#pragma once

#include "touchstone/limit/krylov.hpp"
#include "touchstone/transfer/collocation.hpp"

namespace touchstone::limit {

class RoughWave {
public:
    /// \param nodes of the mesh, as ratios: Chebyshev points of each panel, as in `rules`
    RoughWave(const transfer::levels::Rules&, const transfer::levels::Layer& mesh, const transfer::Wide& nodes);

    /// T V at the nodes, V the polynomials through these values there.
    Vector at_nodes(const Vector& values);

private:
    struct Panel {
        double z0, z1, centre, half;
    };
    struct Cluster {
        int panel, left, right; ///< panel: of a leaf
        double a, b, middle, half;
    };
    void read(const Vector& values);
    double at(std::size_t node) const;

    const int terms;
    const double G, admissible; ///< least distance of a cluster from the ends of a wave, in half widths of its own
    std::vector<Panel> panels;
    std::vector<Cluster> clusters;
    std::vector<std::pair<int, int>> spans; ///< of panels, first and last of a cluster
    Vector x, rest;                         ///< of the nodes: the ratio and what is left to 1
    Vector chebyshev, gauss_at, gauss_weight, exact_at, exact_weight, cosines; ///< cosines[k terms + i] = T_k there
    Vector coefficients, weights;           ///< of V on panels; against the Lagrange polynomials of clusters
};

} // namespace touchstone::limit
