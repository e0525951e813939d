#pragma once

#include <string>
#include <vector>

#include "blockgen/faces/block_rings.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// The joints and joint materials that part blocks, and the mark of each edge.
struct EdgeMarks {
    std::vector<EdgeMark> marks;  ///< per edge; `no_joint` where no two blocks meet
    std::vector<std::string> joint_materials;
    std::vector<Joint> joints;
};

/// Along an edge with several joints the first of `traces` gives the mark. Where only a change of material or
/// an excavation's outline parts two blocks, the last of these with a joint_material gives it. @throws
/// InputError naming the region or excavation when there is none.
EdgeMarks mark_edges(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                     const BlockBoundary& boundary, const SlopeModel& model, const std::vector<Trace>& traces,
                     const SourceTable& table);

}  // namespace rockslope::blockgen
