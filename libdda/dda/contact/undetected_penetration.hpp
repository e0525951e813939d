#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// A corner that penetrated another block in a step, at an edge with which it has no contact.
struct UndetectedPenetration {
    CornerEdge pair;              ///< the corner, and the edge through which it entered
    double depth = 0;             ///< m, of the corner below the other block's surface
    bool passed_through = false;  ///< it left through another edge within the step
};

/// The step that is tested for undetected penetrations.
struct PenetrationTest {
    CornerSpan<const Vec2> before;           ///< m, at the start of the step
    CornerSpan<const Vec2> after;            ///< m, at its end
    std::span<const CornerEdge> candidates;  ///< sorted; all pairs within `search_radius`
    ContactSpan<const Contact> contacts;     ///< of the step, with gaps and states at its end
    double search_radius = 0;                ///< m; deeper corners are not found
    double tolerance = 0;                    ///< m, depth allowed where no contact accounts for any
    double clip_depth = 0;                   ///< m, depth allowed to a corner that is outside again
};

/// Corners that penetrated another block in a step deeper than contacts account for. The allowed depth is
/// twice the penetration for which contacts of the corner, or of a corner that meets it, account, plus
/// `tolerance`. Contacts are detected from the positions at the start of the step; a block that turns by more
/// than the slack of Eq. (27) may come down on another corner than predicted, or pass its corner through a
/// thin block.
///
/// All points are taken to move on straight lines. A corner entered through the last edge that it crossed
/// inwards, among those that pass the entrance-angle test at the step's end. A corner that was inside before
/// the step counts, with the nearest edge, if it is deeper now by more than the allowed depth. A corner that
/// is outside again counts if it left by another edge than it entered and its depth half-way exceeded both
/// the allowed depth and `clip_depth`: straight lines in place of arcs clip corners. A corner that entered
/// and left by one edge does not count.
/// @return sorted by pair, one for each corner and block that it penetrated.
std::vector<UndetectedPenetration> find_undetected_penetrations(const Model& model,
                                                                const PenetrationTest& test,
                                                                const ThreadPool& pool);

/// The deepest undetected penetration as a contact with corner, edge, blocks, point and gap, for the report
/// of the worst contact. The list must not be empty.
Contact deepest_penetration_as_contact(const Model& model, CornerSpan<const Vec2> vertices,
                                       std::span<const UndetectedPenetration> undetected_penetrations);

/// Whether the step can be repeated with these pairs as forced candidates. A corner that passed through is
/// outside again, so that no contact would stop it: it needs a smaller step.
bool can_be_prevented(std::span<const UndetectedPenetration> undetected_penetrations);

/// Merges the pairs of the penetrations into a sorted list. @return whether one of them was new to it.
bool merge_pairs(std::span<const UndetectedPenetration> undetected_penetrations,
                 std::vector<CornerEdge>& pairs);

}  // namespace rockslope::dda
