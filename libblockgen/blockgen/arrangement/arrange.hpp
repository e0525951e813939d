#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/arrangement/indices.hpp"
#include "blockgen/noding/node_joints.hpp"

namespace rockslope::blockgen {

/// A planar subdivision as a DCEL of half-edges, in plain arrays. Edge e has the half-edges 2e, from its
/// first to its second vertex, and 2e + 1, its twin. The face of a half-edge lies on its left.
struct Subdivision {
    PerHalfEdge<HalfEdgeIndex> next;  ///< the next half-edge along its face
    PerHalfEdge<FaceIndex> face;      ///< face 0 is the unbounded face
    std::int32_t face_count = 0;
};

/// The arrangement of noded edges, by a plane sweep (CGAL). The edges are interior-disjoint and their ends
/// are exact doubles. The sweep therefore constructs no point, and an inexact-construction kernel suffices.
/// @throws std::logic_error when the edges are not properly noded.
Subdivision arrange(const NodedEdges& noded);

/// The subdivision of arrange() except for the numbering of the faces, built without a sweep. The half-edges
/// around each vertex are sorted by angle and linked, the cycles of half-edges are traced, and a vertical ray
/// down from the leftmost vertex of each connected component finds the face that contains the component. All
/// predicates are exact. It is about ten times faster than the sweep, but does not detect edges that are not
/// properly noded.
Subdivision walk_faces(const NodedEdges& noded, const ThreadPool& pool = ThreadPool());

/// Numbers of features, face areas and face adjacency of an arrangement, to compare two arrangements.
struct ArrangementSummary {
    std::size_t vertices = 0;
    std::size_t edges = 0;
    /// Twice the area of each bounded face without its holes, in cells, ascending.
    std::vector<Int128> twice_areas;
    /// The two faces of each edge, sorted. A face is identified by the rank of its area (equal areas have
    /// equal ranks); the unbounded face is -1.
    std::vector<std::pair<std::int32_t, std::int32_t>> adjacency;
};

/// Summary of the arrangement of the edges by exact predicates and exact construction. The edges need not be
/// noded.
ArrangementSummary arrange_exactly(const NodedEdges& noded);

/// Summary of a subdivision of properly noded edges.
ArrangementSummary summarize(const NodedEdges& noded, const Subdivision& subdivision);

}  // namespace rockslope::blockgen
