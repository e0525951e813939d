#pragma once

#include <optional>

#include "dda/joint/cyclic_barton_bandis.hpp"

namespace rockslope::dda {

/// Strength that `CyclicShearPath` finds after a displacement, in closed form. It exists for a displacement
/// on one linear stretch of the tables, without a first slip, without a reversal, and with a bound that grows
/// more slowly than the spring's force; otherwise the result is nothing. Nearly all displacements of a step
/// are of this kind.
/// @param normal_force N per metre, positive; @param trial with a stiffness and a displacement.
std::optional<Strength> closed_form_strength(const CyclicBartonBandis& law,
                                             const CyclicBartonBandis::History& history, double normal_force,
                                             double length, const ShearTrial& trial);
/// History after the displacement, under the same conditions. Nothing for joints that dilate.
std::optional<CyclicBartonBandis::History> closed_form_history(const CyclicBartonBandis& law,
                                                               const CyclicBartonBandis::History& history,
                                                               double normal_force, double length,
                                                               const ShearTrial& trial);

}  // namespace rockslope::dda
