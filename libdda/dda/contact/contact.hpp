#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "dda/base/indices.hpp"
#include "dda/base/types.hpp"
#include "dda/contact/shared_history.hpp"

namespace rockslope::dda {

/// The three states of a contact, Shi (1988).
enum class ContactState : std::uint8_t { open, sliding, locked };

enum class ContactKind : std::uint8_t { vertex_vertex, vertex_edge, edge_edge };

/// A corner (vertex) of one block against an edge of another block. Two edges that lie on each other have two
/// such contacts, one at each end of the overlap, each with half the overlap as its length. Forces are N per
/// metre of thickness.
struct Contact {
    Vec2 point = Vec2::Zero();    ///< m, position of the corner at the time of the state
    Vec2 normal = Vec2::Zero();   ///< unit, points out of the edge's block
    Vec2 tangent = Vec2::Zero();  ///< unit, along the edge; the rock of the edge's block is on its left

    CornerIndex corner;
    EdgeIndex edge;
    BlockIndex corner_block;
    BlockIndex edge_block;
    JointMaterialIndex joint_material;
    JointIndex joint = JointIndex::none();  ///< none between free faces
    int group = -1;  ///< the contacts of one group are at one pair of corners, and at most one entrance line
                     ///< of a group closes; -1: no group
    int line = 0;    ///< entrance line within the group; both ends of a short overlap have the same
    ContactKind kind = ContactKind::vertex_edge;
    ContactState state = ContactState::open;
    bool inhibited = false;  ///< cannot close in this step, e.g. since another line of its group bears force
    bool bonded = false;     ///< the joint is unbroken here and bears tension

    double inherited_penetration = 0;  ///< m, depth of the corner or of the edge's nearer end along this
                                       ///< line at the step's start, where contacts account for it
    double length = 0;                 ///< m, contact length for cohesion and stress; 0 for a bare vertex
    /// Distance of the corner from the edge's line less the dilation, m; negative: penetration.
    double gap = 0;
    double dilation = 0;         ///< m, opening of the joint by shear, from the history
    double stress_free_gap = 0;  ///< m, gap at which the normal spring is stress-free: above 0 if augmented,
                                 ///< below 0 if the corner was inside before it had a contact, of either sign
                                 ///< if the contact continues another at another gap
    double normal_force = 0;     ///< N per metre, compression positive: pushes corner_block along `normal`
    double normal_spring_force = 0;  ///< N per metre, the part of it that the normal spring bears; the rest
                                     ///< is that of the dashpot, Eq. (86)
    double shear_force = 0;          ///< N per metre, resists motion of the corner along `tangent`; positive
                                     ///< pushes corner_block along -tangent
    double slip = 0;                 ///< m, accumulated plastic slip of the corner along `tangent`
    double bond_strain = 0;          ///< of a bond that a static stage holds: the largest measure of Eq. (96)
    double joint_share = 1;          ///< its part in the normal force of its joint segment, Eq. (81)
    double spring_share =
        1;  ///< its shear spring over that of the joint, or over its own if the model gives it
    SharedHistory history;

    /// Distance of the corner from the rock of the edge, m. It differs from `gap` by a positive dilation: a
    /// corner with a negative gap outside the rock compresses the asperities, not the rock.
    double gap_to_rock() const { return gap + (dilation > 0 ? dilation : 0); }

    /// The two blocks in contact, the lower index first.
    std::pair<BlockIndex, BlockIndex> blocks() const { return std::minmax(corner_block, edge_block); }
    /// Replaces history and dilation by those of the joint, and corrects the gap for the change of dilation.
    void inherit_history(const SharedHistory& joint_history, double joint_dilation) {
        history = joint_history;
        gap += dilation - joint_dilation;
        dilation = joint_dilation;
    }
};

/// The order of contacts in a ContactSet: by the pair of blocks, then by corner, then by edge.
inline bool comes_before(const Contact& a, const Contact& b) {
    const auto key = [](const Contact& c) { return std::tuple(c.blocks(), c.corner, c.edge); };
    return key(a) < key(b);
}

/// A corner and an edge of another block: a contact candidate.
struct CornerEdge {
    CornerIndex corner;
    EdgeIndex edge;
    friend auto operator<=>(const CornerEdge&, const CornerEdge&) = default;
};

/// The contacts of a state and the list of candidates from which they were detected.
struct ContactSet {
    PerContact<Contact> contacts;        ///< in the order of comes_before
    std::vector<CornerEdge> candidates;  ///< sorted
    double candidate_distance = 0;       ///< m, the list holds all pairs nearer than this, Eq. (25)
    PerCorner<Vec2> reference;           ///< m, vertices when the candidates were found
};

}  // namespace rockslope::dda
