// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The elastic half-plane under a sinusoidal pressure: the one fact of elasticity on which the
/// paper rests, checked field by field.
#pragma once

#include "proofs/ledger.hpp"

namespace touchstone::proofs {

/// Lemma: in plane strain the half-plane y > 0 under the pressure c cos(kx) and no shear, with
/// stresses that vanish at depth, has the surface displacement (into the body)
/// 2(1 - nu^2) c cos(kx)/(E k). The fields are written down and checked: they come from an Airy
/// function (so they are in equilibrium), satisfy Hooke's law, and have the surface tractions said.
Check half_plane_mode();

/// What the lemma gives for a pressure of wave number k, and its inverse for the amplitude.
ex displacement_of_pressure(const ex& pressure, const ex& k);
ex amplitude_of_pressure(const ex& displacement_amplitude, const ex& k);

} // namespace touchstone::proofs
