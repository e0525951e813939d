#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/noding/node_joints.hpp"

namespace rockslope::blockgen {

/// The numbers of everything that makes edges: the outline, the holes, the regions, the excavations, the
/// tunnels, then the joints.
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

/// Every outline as segments, and every joint as far as the domain's bounding box.
std::vector<SourceSegment> source_segments(const SlopeModel& model, const std::vector<Trace>& traces,
                                           const SourceTable& table);

/// How many blocks joints of this length and these directions are likely to make: crossings of evenly spread
/// lines.
double estimated_blocks(const SlopeModel& model, const std::vector<SourceSegment>& segments,
                        const SourceTable& table);

}  // namespace rockslope::blockgen
