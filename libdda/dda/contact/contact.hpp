#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "dda/base/types.hpp"
#include "dda/contact/shared_history.hpp"

namespace rockslope::dda {

/// The three states of a contact, Shi (1988).
enum class ContactState : std::uint8_t { open, sliding, locked };

enum class ContactKind : std::uint8_t { vertex_vertex, vertex_edge, edge_edge };

/// A corner of one block against an edge of another. An edge-edge contact is two of these, one at each end of
/// the overlap, each with half its length. `normal` points out of the edge's block, `tangent` along its edge
/// (the rock of the edge's block is on the left of it). Forces are N per metre of thickness.
struct Contact {
    Vec2 point = Vec2::Zero();  ///< the corner's position at the state's time, m
    Vec2 normal = Vec2::Zero();
    Vec2 tangent = Vec2::Zero();

    int corner = 0;  ///< corner index of the vertex
    int edge = 0;    ///< first corner of the edge
    int corner_block = 0;
    int edge_block = 0;
    int joint_material = 0;
    int joint = -1;  ///< the joint's id, or -1 between faces that are no joint's
    int group = -1;  ///< vertex-vertex: contacts of one group share a pair of corners, and at most one line
                     ///< of them closes
    int line = 0;    ///< in the group: both ends of a short overlap have the same
    ContactKind kind = ContactKind::vertex_edge;
    ContactState state = ContactState::open;
    bool inhibited = false;  ///< another line of its group carries force: this one cannot close in this step
    bool bonded = false;     ///< the joint bears tension here

    double inherited_penetration =
        0;              ///< m, of its corners in faces along its line, borne by contacts when it was found
    double length = 0;  ///< m, share of the joint for cohesion and stress; 0 for a bare vertex
    /// Distance of the corner from the edge line less the dilation, m; negative: penetration.
    double gap = 0;
    double dilation = 0;         ///< m, by which shearing has moved the faces apart, as the history has it
    double stress_free_gap = 0;  ///< m, at which the normal spring bears nothing: above 0 where it is
                                 ///< augmented, below where the corner was inside before it had a contact
    double normal_force = 0;  ///< compression positive: pushes the corner's block along `normal`
    double shear_force = 0;   ///< resists the corner's motion along `tangent`: positive pushes the corner's
                              ///< block along -tangent
    double slip = 0;          ///< accumulated plastic slip of the corner along `tangent`, m
    SharedHistory history;

    /// Distance of the corner from the rock of the edge, or from where contraction lets it come, m. Between
    /// the rock and where shearing has moved the faces apart a corner is in nothing.
    double gap_to_rock() const { return gap + (dilation > 0 ? dilation : 0); }

    /// The blocks that it is between, the lower one first.
    std::pair<int, int> blocks() const { return std::minmax(corner_block, edge_block); }
    /// Takes over what a joint has been through.
    void inherit_history(const SharedHistory& of_joint, double its_dilation) {
        history = of_joint;
        gap += dilation - its_dilation;
        dilation = its_dilation;
    }
};

/// The order of a list of contacts: those between the same two blocks follow each other, by corner and edge.
inline bool comes_before(const Contact& a, const Contact& b) {
    const auto place = [](const Contact& c) { return std::tuple(c.blocks(), c.corner, c.edge); };
    return place(a) < place(b);
}

/// A corner and an edge of another block that may meet before anything has moved half the skin.
struct CornerEdge {
    int corner = 0;
    int edge = 0;
    friend auto operator<=>(const CornerEdge&, const CornerEdge&) = default;
};

/// The contacts of a state, in the order of comes_before, and the candidates that they were found among.
struct ContactSet {
    std::vector<Contact> contacts;
    std::vector<CornerEdge> candidates;  ///< sorted
    double candidate_distance = 0;       ///< m, within which they were all found
    std::vector<Vec2> reference;         ///< vertices when the candidates were found
};

}  // namespace rockslope::dda
