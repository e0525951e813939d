#pragma once

#include "dda/joint/cyclic_roughness.hpp"

namespace rockslope::dda {

// Changes of a cyclic joint's history in a displacement. CyclicShearPath and its closed form use the same
// ones.

/// Sets the position at the end of a motion in the direction +1 or -1, and with it the largest distance, and
/// the cycle when the joint comes back to the origin. @param place where the motion started; @param distance
/// m, from the origin where it ends, on the same side.
void move_to(const CyclicBartonBandis& law, const CyclicRoughness::Place& place, int direction,
             double distance, CyclicBartonBandis::History& history);

/// Adds a slip in a direction, m. @return whether it counts as a reversal.
bool count_slip(const CyclicBartonBandis& law, int direction, double amount,
                CyclicBartonBandis::History& history);

/// Adds a reversal of the slip direction, and its wear.
void count_reversal(const CyclicBartonBandis& law, CyclicBartonBandis::History& history);

/// Sets the stage of a motion at a place.
void set_stage(const CyclicRoughness::Place& place, bool sliding, CyclicBartonBandis::History& history);

/// Sets the unloading and the mobilised ratio at the place where a motion ends. @param roughness of
/// `history`.
void set_ratios(const CyclicRoughness& roughness, const CyclicRoughness::Place& place,
                CyclicBartonBandis::History& history);

}  // namespace rockslope::dda
