#pragma once

#include <cstddef>
#include <span>

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/noding/node_joints.hpp"

namespace rockslope::blockgen {

/// Largest number of segments whose noding is proved: the exact arrangement takes minutes for more.
inline constexpr std::size_t most_proved_segments = 100'000;

/// What the proof of a noding found.
struct NodingProof {
    std::size_t segments = 0;       ///< of some length, before noding
    std::size_t collapsed = 0;      ///< of them, shorter than a few cells and without an edge
    std::size_t faces_before = 0;   ///< bounded faces of the exact arrangement of the segments
    std::size_t faces_after = 0;    ///< bounded faces of the noded edges
    std::size_t equal_faces = 0;    ///< bounded faces with the same nodes in the same order
    std::size_t changed_nodes = 0;  ///< at which ends were joined, points merged or segments bent
    Point first_change;             ///< m, the leftmost of these nodes
};

/// Proves, against the exact arrangement of the segments as they were given, that
///  - each segment has a course: edges with its source in its direction from a node at its one end to a node
///    at its other end, within `largest_snap` of the segment; and every source of an edge is that of such a
///    course;
///  - each end and crossing has a node in its own cell, or in one that touches it and into which it was
///    merged, and the courses of all its segments pass through that node; other nodes are crossings of bent
///    segments;
///  - round each face of whose nodes none was changed the same edges follow each other before and after, with
///    the same holes in it, so that nothing came to lie on the other side of a segment. A node is changed
///    where more or fewer segments pass through it than through the one point in its cell. Every other face
///    has a changed node.
/// Two segments at the angle t may cross 1 / sin(t) times as far from their node as the ends are rounded.
/// @param subdivision that of the noded edges, which are known not to cross each other.
/// @throws std::logic_error when one of these is not so, with the place.
NodingProof prove_noding(std::span<const SourceSegment> segments, const NodedEdges& noded,
                         const Subdivision& subdivision);

}  // namespace rockslope::blockgen
