#pragma once

#include <span>
#include <vector>

#include "dda/base/parallel.hpp"
#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace dda {

/// A corner that got into another block in a step without a contact that tells of it.
struct Intrusion {
    CornerEdge pair;       ///< the corner, and the edge that it came in through
    double depth = 0;      ///< m, of the corner below the other block's surface
    bool through = false;  ///< it came out again on another side within the step
};

/// Looks for corners that got into another block in a step and that the step's contacts do not account for:
/// deeper than twice the penetration of closed contacts of that corner or of one on it, plus `slack`.
/// Contacts are chosen from where blocks are at the step's start; a block that turns by more than the slack
/// of theory Eq. (27) in a step may come down on another corner than those, or pass its corner through a thin
/// block.
///
/// All points are taken to move straight. Where the corner crosses several edges inwards it came in through
/// the last that it could touch at the step's end. A corner that was inside before the step came in through
/// none; if it is deeper now, it is told with the nearest edge. One that is outside again counts if it came
/// out by another edge, from `clipped` on: ways that are really arcs cut corners off. By the same edge it has
/// passed nothing.
/// @param candidates sorted, and complete up to the distance `reach`; deeper corners are not looked at.
/// @param contacts of the step, with gaps and states at its end.
/// @return sorted by pair, one for each corner and block that it got into.
std::vector<Intrusion> find_intrusions(const Model& model, std::span<const Vec2> before,
                                       std::span<const Vec2> after, std::span<const CornerEdge> candidates,
                                       std::span<const Contact> contacts, double reach, double slack,
                                       double clipped, const Crew& crew);

/// The deepest intrusion, told as a contact: blocks, point and gap.
Contact deepest_as_contact(const Model& model, std::span<const Vec2> vertices,
                           std::span<const Intrusion> intrusions);

/// Whether another look at the step with these pairs as contacts may do; a corner that is out again has no
/// contact that would stop it, but a smaller step.
bool may_be_stopped(std::span<const Intrusion> intrusions);

/// Adds the intrusions' pairs to a sorted list. @return whether there was one not yet in it.
bool add_pairs(std::span<const Intrusion> intrusions, std::vector<CornerEdge>& pairs);

}  // namespace dda
