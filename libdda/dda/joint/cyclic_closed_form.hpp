#pragma once

#include <optional>

#include "dda/joint/cyclic_barton_bandis.hpp"

namespace rockslope::dda {

/// What `CyclicShearPath` comes to after a displacement, in closed form, where nothing bends or changes on
/// the way that the bounds at its end depend on: one stretch of the tables, no first slip, no slip that makes
/// a reversal, no bound that outruns the spring. Nothing where there is more to it. Nearly all displacements
/// of a step are such.
/// @param normal_force N per metre, positive; @param trial with a stiffness and a displacement.
std::optional<Strength> closed_form_strength(const CyclicBartonBandis& law,
                                             const CyclicBartonBandis::History& history, double normal_force,
                                             double length, const ShearTrial& trial);
/// Likewise what the joint has been through then. Nothing for joints that dilate.
std::optional<CyclicBartonBandis::History> closed_form_history(const CyclicBartonBandis& law,
                                                               const CyclicBartonBandis::History& history,
                                                               double normal_force, double length,
                                                               const ShearTrial& trial);

}  // namespace rockslope::dda
