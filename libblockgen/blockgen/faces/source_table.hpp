#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/noding/node_joints.hpp"

namespace rockslope::blockgen {

/// The source numbers of everything that makes edges: the outline (0), then the holes, regions, excavations,
/// tunnels and joints.
struct SourceTable {
    explicit SourceTable(const SlopeModel& model);

    std::int32_t first_hole = 1;
    std::int32_t first_region = 1;
    std::int32_t first_excavation = 1;
    std::int32_t first_tunnel = 1;
    std::int32_t first_joint = 1;

    bool is_joint(std::int32_t source) const { return source >= first_joint; }
    bool is_region(std::int32_t source) const { return source >= first_region && source < first_excavation; }
    bool is_excavation(std::int32_t source) const {
        return source >= first_excavation && source < first_tunnel;
    }
};

/// The segments of all outlines, and of all joints clipped to the widened bounding box of the domain.
std::vector<SourceSegment> source_segments(const SlopeModel& model, const std::vector<Trace>& traces,
                                           const SourceTable& table);

/// Estimated number of blocks: the expected number of crossings of evenly spread lines with the lengths and
/// directions of the joints.
double estimated_blocks(const SlopeModel& model, const std::vector<SourceSegment>& segments,
                        const SourceTable& table);

}  // namespace rockslope::blockgen
