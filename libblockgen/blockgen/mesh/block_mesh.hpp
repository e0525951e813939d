#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "blockgen/mesh/indices.hpp"
#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// Joint and joint material along one edge of a block. `no_joint` marks an edge on the free surface or on the
/// outline of the domain.
struct EdgeMark {
    static constexpr std::int32_t no_joint = -1;
    JointMaterialIndex joint_material = no_joint;
    JointIndex joint = no_joint;
    friend bool operator==(const EdgeMark&, const EdgeMark&) = default;
};

/// How a block may move: by the equations of motion, not at all, or as a record prescribes.
enum class BlockMotion : std::uint8_t { free, fixed, prescribed };

struct Joint {
    std::string set;  ///< name of the joint set or trace it belongs to
    friend bool operator==(const Joint&, const Joint&) = default;
};

/// A material point whose motion is recorded.
struct MeasuredPoint {
    std::string name;
    BlockIndex block = 0;
    Point position;
    friend bool operator==(const MeasuredPoint&, const MeasuredPoint&) = default;
};

/// A bar between a point of one block and a point of another block, or of the same block. A bolt material
/// gives its properties.
struct Bolt {
    std::string name;
    std::string material;
    BlockIndex first_block = 0;
    BlockIndex second_block = 0;
    Point first;
    Point second;
    friend bool operator==(const Bolt&, const Bolt&) = default;
};

/// Blocks that the simulation removes at the start of a stage.
struct ExcavatedBlocks {
    std::string name;
    std::int32_t stage = 1;          ///< stage of the simulation, counted from 1
    std::vector<BlockIndex> blocks;  ///< ascending; in no other excavation
    friend bool operator==(const ExcavatedBlocks&, const ExcavatedBlocks&) = default;
};

/// A rock section cut into blocks: plain data, as stored in the block file. Lengths in m.
///
/// Blocks share vertices by index, so the coordinates of neighbours are identical to the last bit.
/// Block b owns the rings [block_rings[b], block_rings[b + 1]): the outer ring, counter-clockwise, then the
/// holes, clockwise. The block lies on the left of each of its edges.
/// Ring r owns the range [ring_corners[r], ring_corners[r + 1]) of `corners` and of `edge_marks`. Edge k runs
/// from corner k to the next corner of the same ring.
struct BlockMesh {
    PerVertex<Point> vertices;
    PerCorner<VertexIndex> corners;
    PerCorner<EdgeMark> edge_marks;
    PerRing<CornerIndex> ring_corners = {0};
    PerBlock<RingIndex> block_rings = {0};

    PerBlock<BlockMaterialIndex> block_material;
    PerBlock<BlockMotion> motion;
    PerBlock<std::string> motion_name;  ///< name of a prescribed block, otherwise empty

    PerBlockMaterial<std::string> block_materials;
    PerJointMaterial<std::string> joint_materials;
    PerJoint<Joint> joints;
    std::vector<MeasuredPoint> measured_points;
    std::vector<Bolt> bolts;
    std::vector<ExcavatedBlocks> excavations;
    std::vector<Point> water_table;  ///< x growing; straight between points, level beyond; empty: none

    std::vector<std::string> provenance;  ///< free text lines: program version, seed, hash of the input

    /// Number of blocks.
    std::size_t block_count() const { return block_rings.size() - 1; }
    /// The indices of all blocks.
    IndexRange<BlockIndex> blocks() const { return indices<BlockIndex>(block_count()); }
    /// Number of rings of all blocks.
    std::size_t ring_count(BlockIndex block) const { return block_rings[block + 1] - block_rings[block]; }
    /// The vertices of a block's ring; ring 0 of a block is the outer one.
    std::span<const VertexIndex> ring(BlockIndex block, std::size_t ring) const;
    /// The marks of the edges of a block's ring.
    std::span<const EdgeMark> ring_marks(BlockIndex block, std::size_t ring) const;

    /// Appends a block's ring; the first ring appended after begin_block is the outer one.
    void begin_block(BlockMaterialIndex material, BlockMotion block_motion = BlockMotion::free,
                     std::string name = {});
    void add_ring(std::span<const VertexIndex> ring_vertices, std::span<const EdgeMark> marks);

    friend bool operator==(const BlockMesh&, const BlockMesh&) = default;
};

}  // namespace rockslope::blockgen
