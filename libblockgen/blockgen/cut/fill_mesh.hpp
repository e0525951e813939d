#pragma once

#include "blockgen/faces/block_rings.hpp"
#include "blockgen/faces/cut_context.hpp"
#include "blockgen/faces/mark_edges.hpp"
#include "blockgen/mesh/block_mesh.hpp"

namespace rockslope::blockgen {

/// A mesh, and twice the area of its blocks in cells, which is exact.
struct FilledMesh {
    BlockMesh mesh;
    Int128 twice_area = 0;
};

/// The material of each kind of rock, as an index into the names of the materials that blocks have, which are
/// in the order of the blocks.
struct RockMaterials {
    /// Finds the materials of all blocks.
    RockMaterials(const CutContext& cut, const BlockRings& rings);

    PerBlock<BlockMaterialIndex> of_block;
    PerBlockMaterial<std::string> names;
};

/// Fills a mesh with the blocks. Vertices, joints and joint materials are numbered in the order in which the
/// blocks use them, which does not depend on the order of the joints. Consumes nothing of the subdivision, so
/// that it may be freed before. @param removed flag per vertex of the network: left out.
FilledMesh fill_mesh(const NodedEdges& noded, const BlockRings& rings, const EdgeMarks& edges,
                     const PerNode<char>& removed, RockMaterials materials, const ThreadPool& pool);

}  // namespace rockslope::blockgen
