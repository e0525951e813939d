#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/contact/contact.hpp"
#include "dda/contact/search_radius.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Sine of the angle up to which two edges are parallel and form an edge-edge contact, and by which an edge
/// of a corner may dip below the line on which the corner rests: sin 3 degrees, Shi's value [Shi 1993, sec.
/// 2.3].
inline constexpr double parallel_tolerance = 0.0523;

/// A corner is on an edge up to this distance beyond its end, relative to the edge's length. The ends of two
/// equal faces shift by elastic strains from step to step; without the tolerance their contacts would
/// exchange corner and edge at every shift and never come to rest.
inline constexpr double end_tolerance = 1e-6;
/// Smallest overlap of two faces, over the edge's length, that gets a second contact at its other end. With a
/// smaller limit, slip to and fro would create and delete the contact repeatedly.
inline constexpr double min_overlap_ratio = 1e-3;

/// Position of a corner relative to an edge.
struct CornerEdgeGeometry {
    Vec2 tangent = Vec2::Zero();  ///< unit, along the edge
    Vec2 normal = Vec2::Zero();   ///< unit, out of the edge's block
    double gap = 0;               ///< m, distance from the edge's line, negative inside the edge's block
    double along = 0;             ///< m, projection of the corner on the edge, from its first corner
    double length = 0;            ///< m, of the edge

    /// Distance of the projection from the nearer end of the edge, m; negative beyond an end.
    double end_margin() const { return along < length - along ? along : length - along; }
};
/// @param first start of the edge, m. @param tangent unit, along the edge. @param length m, of the edge.
inline CornerEdgeGeometry corner_edge_geometry(const Vec2& corner, const Vec2& first, const Vec2& tangent,
                                               double length) {
    CornerEdgeGeometry geometry;
    geometry.length = length;
    geometry.tangent = tangent;
    geometry.normal = -perpendicular(geometry.tangent);
    geometry.gap = (corner - first).dot(geometry.normal);
    geometry.along = (corner - first).dot(geometry.tangent);
    return geometry;
}
inline CornerEdgeGeometry corner_edge_geometry(const Vec2& corner, const Vec2& first, const Vec2& second) {
    const Vec2 edge = second - first;
    const double length = edge.norm();
    return corner_edge_geometry(corner, first, edge / length, length);
}

/// Entrance-angle test, Eq. (27): whether both edges of a corner, and the rock between them, lie on the outer
/// side of a line with the given normal. At a straight corner both edges lie along the line, and the side of
/// the rock decides.
bool passes_entrance_angle_test(const Topology& topology, CornerSpan<const Vec2> vertices, CornerIndex corner,
                                const Vec2& normal);
/// The same. @param leaving, arriving unit, from the corner along its next and its previous edge.
bool passes_entrance_angle_test(const Vec2& leaving, const Vec2& arriving, const Vec2& normal);

/// Input of contact detection.
struct DetectionInput {
    CornerSpan<const Vec2> vertices;           ///< per corner, at the start of the step, m
    CornerSpan<const Vec2> mid_step_vertices;  ///< per corner, predicted at mid-step, m
    SearchRadius search_radius;                ///< within which a pair may meet in the step
    double depth_tolerance = 0;                ///< m, depth behind a line up to which a corner is on the line
    ContactSpan<const Contact> previous = {};  ///< contacts at the start of the step, sorted
    /// Forced candidates, sorted: pairs whose contact an earlier attempt at this step missed. They become
    /// contacts without an entrance-angle test, in no group.
    std::span<const CornerEdge> forced = {};
};

/// The contacts among the candidates, in the order of comes_before. A candidate becomes a contact if its
/// corner is within its search radius of the edge and passes the entrance-angle test. A contact of
/// `previous` may be farther away, and its angle is not tested while it bears force on its edge. A corner
/// near an end of the edge forms vertex-vertex contacts, in a group with one contact per entrance line; by
/// Shi's first-entrance rule, Eq. (28), at most one line of a group closes. Two edges that lie on each other
/// get one contact at each end of the overlap. States, forces and histories are not set; see
/// transfer_contacts.
std::vector<Contact> detect_contacts(const Model& model, const DetectionInput& at,
                                     std::span<const CornerEdge> candidates, const ThreadPool& pool);

}  // namespace rockslope::dda
