#pragma once

#include <string>
#include <vector>

#include "dda/base/indices.hpp"
#include "dda/base/types.hpp"
#include "dda/joint/joint_law.hpp"
#include "dda/linear/solver_kind.hpp"
#include "dda/model/block_material.hpp"
#include "dda/model/load.hpp"
#include "dda/model/viscous_boundary.hpp"

namespace rockslope::dda {

/// A block that has been excavated is `removed`: its index stays, and it has no contacts.
enum class Motion : std::uint8_t { free, fixed, prescribed, removed };

/// The corners of all blocks, block after block and ring after ring. Neighbouring blocks share no corners.
/// Outer rings run counter-clockwise and holes clockwise: the rock is on the left of every edge.
/// Edge k runs from corner k to next[k]. Constant during a run.
struct Topology {
    PerBlock<CornerIndex> block_corners = {0};  ///< block b owns [block_corners[b], block_corners[b + 1])
    IndexedVector<RingIndex, CornerIndex> ring_corners = {0};  ///< of ring r: from [r] to [r + 1]
    PerBlock<RingIndex> block_rings = {0};  ///< block b owns the rings [block_rings[b], block_rings[b + 1])
    PerCorner<CornerIndex> next;
    PerCorner<CornerIndex> previous;
    PerCorner<BlockIndex> block_of;
    PerEdge<JointMaterialIndex> joint_material;  ///< none on a free face
    PerEdge<JointIndex> joint;                   ///< the joint's id in the block file; none on a free face

    /// Number of blocks.
    int block_count() const { return static_cast<int>(block_corners.size()) - 1; }
    /// Number of corners of all blocks, which is that of the edges.
    int corner_count() const { return static_cast<int>(next.size()); }
    /// The indices of all blocks.
    IndexRange<BlockIndex> blocks() const { return {0, block_count()}; }
    /// The indices of all corners.
    IndexRange<CornerIndex> corners() const { return next.indices(); }
    /// The indices of all edges.
    IndexRange<EdgeIndex> edges() const { return joint.indices(); }
    /// The corners of a block.
    IndexRange<CornerIndex> corners_of(BlockIndex block) const {
        return {block_corners[block], block_corners[block + 1]};
    }
    /// The corner at which an edge ends; it starts at start_of().
    CornerIndex end_of(EdgeIndex edge) const { return next[start_of(edge)]; }
    /// The block that an edge bounds.
    BlockIndex block_of_edge(EdgeIndex edge) const { return block_of[start_of(edge)]; }

    /// Appends a block with rings of the given sizes and free faces.
    void add_block(const std::vector<int>& ring_sizes);
};

/// A material point whose motion is recorded.
struct MeasuredPointSpec {
    std::string name;
    PointIndex point;
};

/// Blocks whose displacements are recorded together.
struct MeasuredRegion {
    std::string name;
    std::vector<BlockIndex> blocks;  ///< free ones
};

/// A point of a joint at which relative displacement and stresses are recorded.
struct MeasuredJoint {
    std::string name;
    EdgeIndex edge;          ///< the face of one block
    PointIndex point;        ///< the point in that block
    PointIndex other_point;  ///< the point in the block on the other side
};

/// Blocks that are removed at the start of a stage.
struct Excavation {
    std::string name;
    int stage = 1;  ///< of the run, counted from 1
    std::vector<BlockIndex> blocks;
};

/// The user's input. It does not change during a run. SI units, per metre of thickness.
struct Model {
    /// Origin of the model's coordinates in the user's coordinates, m. Input coordinates are reduced by it
    /// and output coordinates increased. With large coordinates, as on a national grid, a contact's
    /// penetration would be lost in rounding.
    Vec2 origin = Vec2::Zero();
    Topology topology;
    PerCorner<Vec2> vertices;  ///< the initial configuration, m
    PerBlock<BlockMaterialIndex> block_material;
    PerBlock<Motion> motion;
    PerBlock<std::string> block_name;  ///< empty unless prescribed

    IndexedVector<BlockMaterialIndex, BlockMaterial> block_materials;
    IndexedVector<JointMaterialIndex, JointMaterial> joint_materials;
    IndexedVector<JointIndex, std::string> joint_sets;  ///< the name of a joint's set or trace
    JointMaterialIndex default_joint_material;          ///< for contacts of free faces

    Plane plane = Plane::strain;
    Vec2 gravity = {0, -9.81};      ///< m/s2
    double strength_reduction = 1;  ///< divides the shear and tensile strengths of the joints
    double normal_penalty = 0;      ///< N/m per metre of thickness per contact
    double shear_penalty = 0;       ///< N/m per metre of thickness per contact
    /// m; positive: contact forces are augmented until the penetration of every contact, and the shear
    /// displacement of every locked one, is at most this. 0: pure penalty forces.
    double penetration_tolerance = 0;
    double fixed_point_penalty = 0;  ///< N/m per metre of thickness
    SolverKind solver = SolverKind::multifrontal;

    PerPoint<MaterialPoint> material_points;  ///< used by loads, fixed points, bolts and measured points
    std::vector<Load> loads;
    std::vector<FixedPoint> fixed_points;
    std::vector<ViscousBoundary> viscous_boundaries;
    std::vector<BoltSpec> bolts;
    std::vector<MeasuredPointSpec> measured_points;
    std::vector<MeasuredJoint> measured_joints;
    std::vector<MeasuredRegion> measured_regions;
    std::vector<Excavation> excavations;
    PerBlock<Vec6> initial_velocity;  ///< or empty

    /// Number of blocks.
    int block_count() const { return topology.block_count(); }
    /// The indices of all blocks.
    IndexRange<BlockIndex> blocks() const { return topology.blocks(); }
    /// The joint material of an index.
    const JointMaterial& joint_material_at(JointMaterialIndex index) const { return joint_materials[index]; }
    /// Whether the contacts of a joint material are augmented: their springs are penalties, not a stiffness
    /// of the joint.
    bool is_augmented(JointMaterialIndex material) const {
        return penetration_tolerance > 0 && joint_material_at(material).normal_stiffness == 0;
    }
    /// The material of a block.
    const BlockMaterial& material_of(BlockIndex block) const {
        return block_materials[block_material[block]];
    }
};

}  // namespace rockslope::dda
