#pragma once

#include <string>
#include <vector>

#include "blockgen/faces/block_rings.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// The joints and joint materials between blocks, and the mark of each edge.
struct EdgeMarks {
    std::vector<EdgeMark> marks;  ///< per edge; `no_joint` unless it lies between two blocks
    std::vector<std::string> joint_materials;
    std::vector<Joint> joints;
};

/// Marks each edge between two blocks. An edge with several joints gets the mark of the first in `traces`. An
/// edge without a joint, on the outline of a region or an excavation, gets the joint_material of the last of
/// these that has one, excavations after regions. @throws InputError naming the region or excavation when
/// none has one.
EdgeMarks mark_edges(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                     const BlockBoundary& boundary, const SlopeModel& model, const std::vector<Trace>& traces,
                     const SourceTable& table);

}  // namespace rockslope::blockgen
