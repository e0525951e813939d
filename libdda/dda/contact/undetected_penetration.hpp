#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// A corner that got into another block in a step without a contact that tells of it.
struct UndetectedPenetration {
    CornerEdge pair;              ///< the corner, and the edge that it came in through
    double depth = 0;             ///< m, of the corner below the other block's surface
    bool passed_through = false;  ///< it came out again on another side within the step
};

/// Looks for corners that got into another block in a step and that the step's contacts do not account for:
/// deeper than twice the penetration of closed contacts of that corner or of one on it, plus `tolerance`.
/// Contacts are chosen from where blocks are at the step's start; a block that turns by more than the
/// tolerance of theory Eq. (27) in a step may come down on another corner than those, or pass its corner
/// through a thin block.
///
/// All points are taken to move straight. Where the corner crosses several edges inwards it came in through
/// the last that it could touch at the step's end. A corner that was inside before the step came in through
/// none; if it is deeper now, it is told with the nearest edge. One that is outside again counts if it came
/// out by another edge, from `clip_depth` on: ways that are really arcs cut corners off. By the same edge it
/// has passed nothing.
/// @param candidates sorted, and complete up to the distance `search_radius`; deeper corners are not looked
/// at.
/// @param contacts of the step, with gaps and states at its end.
/// @return sorted by pair, one for each corner and block that it got into.
std::vector<UndetectedPenetration> find_undetected_penetrations(
    const Model& model, std::span<const Vec2> before, std::span<const Vec2> after,
    std::span<const CornerEdge> candidates, std::span<const Contact> contacts, double search_radius,
    double tolerance, double clip_depth, const ThreadPool& pool);

/// The deepest intrusion, told as a contact: blocks, point and gap.
Contact deepest_penetration_as_contact(const Model& model, std::span<const Vec2> vertices,
                                       std::span<const UndetectedPenetration> undetected_penetrations);

/// Whether another look at the step with these pairs as contacts may do; a corner that is out again has no
/// contact that would stop it, but a smaller step.
bool can_be_prevented(std::span<const UndetectedPenetration> undetected_penetrations);

/// Adds the undetected_penetrations' pairs to a sorted list. @return whether there was one not yet in it.
bool merge_pairs(std::span<const UndetectedPenetration> undetected_penetrations,
                 std::vector<CornerEdge>& pairs);

}  // namespace rockslope::dda
