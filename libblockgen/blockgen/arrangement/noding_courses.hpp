#pragma once

#include <span>
#include <vector>

#include "blockgen/noding/node_joints.hpp"

namespace rockslope::blockgen {

/// The bounds that noding claims, in cells.
struct NodingBounds {
    double course = 0;    ///< distance of a course from its segment
    double end = 0;       ///< distance of a segment's end from its node
    double rounding = 0;  ///< of the segments' ends to the fine grid of the first round, in x and y
};

/// @param extent of the model, m.
NodingBounds noding_bounds(const NodedEdges& noded, double extent);

/// The nodes of a network by place.
class NodesByPlace {
  public:
    /// @param nodes sorted.
    explicit NodesByPlace(const PerNode<GridPoint>& nodes) : nodes_(nodes) {}
    /// The nodes at most so far from a point in x and in y, cells.
    std::vector<NodeIndex> within(const Point& p, double reach) const;

  private:
    const PerNode<GridPoint>& nodes_;
};

/// A noded edge in the direction of a source.
struct CourseLink {
    SourceIndex source;
    NodeIndex from, to;
    friend auto operator<=>(const CourseLink&, const CourseLink&) = default;
};

/// All edges in the directions of all their sources, sorted.
std::vector<CourseLink> course_links(const NodedEdges& noded);

/// Finds the course of each segment. @return flags of the segments that have none because they are too short.
/// @throws std::logic_error when a longer segment has no course, or an edge is on none of its source.
std::vector<char> prove_courses(std::span<const SourceSegment> segments, const NodedEdges& noded,
                                const NodingBounds& bounds);

}  // namespace rockslope::blockgen
