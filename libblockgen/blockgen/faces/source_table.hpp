#pragma once

#include <vector>

#include "blockgen/faces/indices.hpp"
#include "blockgen/input/slope_model.hpp"
#include "blockgen/noding/node_joints.hpp"

namespace rockslope::blockgen {

/// The source numbers of everything that makes edges: the outline (0), then the holes, regions, excavations,
/// tunnels and joints.
struct SourceTable {
    explicit SourceTable(const SlopeModel& model);

    SourceIndex first_hole = 1;
    SourceIndex first_region = 1;
    SourceIndex first_excavation = 1;
    SourceIndex first_tunnel = 1;
    SourceIndex first_joint = 1;

    bool is_joint(SourceIndex source) const { return source >= first_joint; }
    bool is_region(SourceIndex source) const { return source >= first_region && source < first_excavation; }
    bool is_excavation(SourceIndex source) const {
        return source >= first_excavation && source < first_tunnel;
    }
    /// The trace of a source that is a joint.
    JointTraceIndex trace_of(SourceIndex joint) const { return joint - first_joint; }
    SourceIndex source_of(JointTraceIndex trace) const { return first_joint + trace.value(); }
};

/// The segments of all outlines, and of all joints clipped to the widened bounding box of the domain.
std::vector<SourceSegment> source_segments(const SlopeModel& model, const std::vector<Trace>& traces,
                                           const SourceTable& table);

/// Estimated number of blocks: the expected number of crossings of evenly spread lines with the lengths and
/// directions of the joints.
double estimated_blocks(const SlopeModel& model, const std::vector<SourceSegment>& segments,
                        const SourceTable& table);

}  // namespace rockslope::blockgen
