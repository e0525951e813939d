#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// How near flat faces must be to parallel to count as an edge-edge contact, and how far a corner's edge may
/// dip below the line it rests on: sin(3 degrees), Shi's value [Shi 1993, sec. 2.3].
inline constexpr double parallel_tolerance = 0.0523;

/// How far past its edge's end a corner may be and still be on it, as a share of the edge: the ends of two
/// equal faces shift by elastic strains from step to step, and a contact that changed roles with each of them
/// would never come to rest.
inline constexpr double end_tolerance = 1e-6;

/// Where a corner stands against an edge line.
struct CornerEdgeGeometry {
    Vec2 tangent = Vec2::Zero();
    Vec2 normal = Vec2::Zero();
    double gap = 0;     ///< m, negative inside the edge's block
    double along = 0;   ///< m, projection of the corner on the edge, from its first corner
    double length = 0;  ///< m, of the edge

    /// How far the projection lies inside the edge's ends, m; negative beyond an end.
    double end_margin() const { return along < length - along ? along : length - along; }
};
inline CornerEdgeGeometry corner_edge_geometry(const Vec2& corner, const Vec2& first, const Vec2& second) {
    CornerEdgeGeometry geometry;
    const Vec2 edge = second - first;
    geometry.length = edge.norm();
    geometry.tangent = edge / geometry.length;
    geometry.normal = -perpendicular(geometry.tangent);
    geometry.gap = (corner - first).dot(geometry.normal);
    geometry.along = (corner - first).dot(geometry.tangent);
    return geometry;
}

/// Whether the rock at a corner lies on the outer side of a line with the given normal, Eq. (27): both its
/// edges, and the side they enclose, which decides for a straight corner.
bool passes_entrance_angle_test(const Topology& topology, std::span<const Vec2> vertices, int corner,
                                const Vec2& normal);

/// What contacts are detected from.
struct DetectionInput {
    std::span<const Vec2> vertices;           ///< per corner, m
    std::span<const Vec2> mid_step_vertices;  ///< where they are expected half-way through the step
    double search_radius = 0;                 ///< m, how far apart a corner and an edge may be and still meet
    double depth_tolerance = 0;               ///< m, depth behind a line that means nothing
    std::span<const Contact> previous = {};   ///< sorted, at the same instant
    /// Sorted pairs known to meet in this step though they could not touch at these positions: they become
    /// contacts of their own, in no group.
    std::span<const CornerEdge> forced = {};
};

/// The contacts among the candidates at the given positions: corners at most `search_radius` from an edge
/// that they can touch, that is, with both their edges on its outer side. Corners near an end of the edge are
/// vertex-vertex contacts, in groups: Shi's first-entrance rule lets the line that is crossed last carry the
/// contact. An edge-edge contact comes out as one contact at each end of the overlap. Contacts of `previous`
/// stay while they are candidates. States, forces and histories are the caller's (transfer_contacts).
std::vector<Contact> detect_contacts(const Model& model, const DetectionInput& at,
                                     std::span<const CornerEdge> candidates, const ThreadPool& pool);

}  // namespace rockslope::dda
