#pragma once

#include <string>

#include "blockgen/faces/block_rings.hpp"
#include "blockgen/faces/cut_context.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// The joints and joint materials between blocks, and the mark of each edge.
struct EdgeMarks {
    PerEdge<EdgeMark> marks;  ///< `no_joint` unless it lies between two blocks
    PerJointMaterial<std::string> joint_materials;
    PerJoint<Joint> joints;
};

/// Marks each edge between two blocks. An edge with several joints gets the mark of the first in `traces`. An
/// edge without a joint, on the outline of a region or an excavation, gets the joint_material of the last of
/// these that has one, excavations after regions. @throws InputError naming the region or excavation when
/// none has one.
EdgeMarks mark_edges(const CutContext& cut, const BlockBoundary& boundary);

}  // namespace rockslope::blockgen
