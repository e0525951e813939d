#pragma once

#include <cstdint>
#include <vector>

#include "dda/base/types.hpp"
#include "dda/joint/joint_law.hpp"

namespace dda {

/// The three states of a contact, Shi (1988).
enum class ContactState : std::uint8_t { open, sliding, locked };

enum class ContactKind : std::uint8_t { vertex_vertex, vertex_edge, edge_edge };

/// A corner of one block against an edge of another. An edge-edge contact is two of these, one at each end of the
/// overlap, each with half its length. Directions: `normal` points out of the edge's block, `tangent` along its edge (the rock of
/// the edge's block on the left). Forces act on the corner's block: normal force along `normal` (compression positive),
/// shear force along `tangent`. Forces are N per metre of thickness.
struct Contact {
    int corner = 0;        ///< corner index of the vertex
    int edge = 0;          ///< first corner of the edge
    int corner_block = 0;
    int edge_block = 0;
    ContactKind kind = ContactKind::vertex_edge;
    int joint_material = 0;
    int joint = -1;
    double length = 0;     ///< m, share of the joint for cohesion and stress; 0 for a bare vertex

    Vec2 point = Vec2::Zero();    ///< the corner's position at the start of the step, m
    Vec2 normal = Vec2::Zero();
    Vec2 tangent = Vec2::Zero();
    double gap = 0;               ///< distance of the corner from the edge line, m, negative: penetration

    ContactState state = ContactState::open;
    double normal_force = 0;
    double shear_force = 0;
    double slip = 0;       ///< accumulated plastic slip with its sign, m
    bool bonded = false;   ///< the joint bears tension here
    JointHistory history;
};

/// All contact candidates of a state, sorted by (corner_block, edge_block, corner, edge), and the block pairs near
/// enough to come into contact before anything has moved half the skin.
struct ContactSet {
    std::vector<Contact> contacts;
    std::vector<std::pair<int, int>> pairs;      ///< sorted, first < second
    std::vector<Vec2> pair_reference;            ///< vertices when the pairs were made
};

}  // namespace dda
