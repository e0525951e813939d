#pragma once

#include <string>
#include <vector>

#include "dda/base/types.hpp"
#include "dda/joint/joint_law.hpp"
#include "dda/linear/solver_kind.hpp"
#include "dda/model/block_material.hpp"
#include "dda/model/load.hpp"
#include "dda/model/viscous_boundary.hpp"

namespace rockslope::dda {

/// A block that an excavation has taken out is `removed`: its number stays, and nothing meets it.
enum class Motion : std::uint8_t { free, fixed, prescribed, removed };

/// The corners of all blocks, block after block and ring after ring; every block owns its corners, neighbours
/// share none. Outer rings run counter-clockwise and holes clockwise: the rock is on the left of every edge.
/// Edge k runs from corner k to next[k]. Constant during a run.
struct Topology {
    std::vector<int> block_corners = {
        0};  ///< block b owns the corners [block_corners[b], block_corners[b + 1])
    std::vector<int> ring_corners = {0};  ///< ring r owns the corners [ring_corners[r], ring_corners[r + 1])
    std::vector<int> block_rings = {0};   ///< block b owns the rings [block_rings[b], block_rings[b + 1])
    std::vector<int> next;                ///< per corner
    std::vector<int> previous;            ///< per corner
    std::vector<int> block_of;            ///< per corner
    std::vector<int> joint_material;      ///< per edge, index into Model::joint_materials; -1 on a free face
    std::vector<int> joint;               ///< per edge, the joint's id in the block file; -1 on a free face

    int block_count() const { return static_cast<int>(block_corners.size()) - 1; }
    int corner_count() const { return static_cast<int>(next.size()); }

    /// Appends a block of rings of the given sizes, with free faces.
    void add_block(const std::vector<int>& ring_sizes);
};

/// A material point whose motion is recorded.
struct MeasuredPointSpec {
    std::string name;
    int point = 0;  ///< index into Model::material_points
};

/// A place on a joint where it is recorded how its two faces pass each other and what they bear.
struct MeasuredJoint {
    std::string name;
    int edge = 0;         ///< the face of one block, by its first corner
    int point = 0;        ///< index into Model::material_points: the place in that block
    int other_point = 0;  ///< and in the block on the other side
};

/// Blocks that are taken out when a stage begins.
struct Excavation {
    std::string name;
    int stage = 1;  ///< of the run, counted from 1
    std::vector<int> blocks;
};

/// What the user described, and nothing that changes during a run. SI units, per metre of thickness.
struct Model {
    /// Where the user's coordinates have this model's zero, m. Far from zero, as on a national grid,
    /// coordinates are read less this point and written plus it: a contact's force would drown in their
    /// rounding.
    Vec2 origin = Vec2::Zero();
    Topology topology;
    std::vector<Vec2> vertices;           ///< per corner, the initial configuration, m
    std::vector<int> block_material;      ///< per block, index into block_materials
    std::vector<Motion> motion;           ///< per block
    std::vector<std::string> block_name;  ///< per block; empty unless prescribed

    std::vector<BlockMaterial> block_materials;
    std::vector<JointMaterial> joint_materials;
    std::vector<std::string> joint_sets;  ///< per joint id of the block file, the name of its set or trace
    int default_joint_material = 0;       ///< for contacts of free faces

    Plane plane = Plane::strain;
    Vec2 gravity = {0, -9.81};      ///< m/s2
    double strength_reduction = 1;  ///< joints' shear and tensile strengths are divided by this
    double normal_penalty = 0;      ///< N/m per metre of thickness per contact
    double shear_penalty = 0;       ///< likewise
    /// m; positive: contact forces are augmented until corners are no deeper in an edge, and stuck ones no
    /// farther along it, than this. 0: forces are the penalties' alone.
    double penetration_tolerance = 0;
    double fixed_point_penalty = 0;  ///< N/m per metre of thickness
    SolverKind solver = SolverKind::multifrontal;

    std::vector<MaterialPoint> material_points;  ///< of loads, fixed points, bolts and measured points
    std::vector<Load> loads;
    std::vector<FixedPoint> fixed_points;
    std::vector<ViscousBoundary> viscous_boundaries;
    std::vector<BoltSpec> bolts;
    std::vector<MeasuredPointSpec> measured_points;
    std::vector<MeasuredJoint> measured_joints;
    std::vector<Excavation> excavations;
    std::vector<Vec6> initial_velocity;  ///< per block, or empty

    int block_count() const { return topology.block_count(); }
    const JointMaterial& joint_material_at(int index) const {
        return joint_materials[static_cast<std::size_t>(index)];
    }
    /// Whether the contacts of a joint material are augmented: where their springs are penalties and not a
    /// stiffness of the joint itself.
    bool is_augmented(int material) const {
        return penetration_tolerance > 0 && joint_material_at(material).normal_stiffness == 0;
    }
    const BlockMaterial& material_of(int block) const {
        return block_materials[static_cast<std::size_t>(block_material[static_cast<std::size_t>(block)])];
    }
};

}  // namespace rockslope::dda
