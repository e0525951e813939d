#include "blockgen/mesh/block_mesh.hpp"

#include <utility>

namespace rockslope::blockgen {

namespace {

template <class T>
std::span<const T> ring_part(const BlockMesh& mesh, const PerCorner<T>& values, BlockIndex block,
                             std::size_t ring) {
    const RingIndex r = mesh.block_rings[block] + ring;
    const CornerIndex first = mesh.ring_corners[r];
    return std::span<const T>(values).subspan(first, mesh.ring_corners[r + 1] - first);
}

}  // namespace

std::span<const VertexIndex> BlockMesh::ring(BlockIndex block, std::size_t ring) const {
    return ring_part(*this, corners, block, ring);
}

std::span<const EdgeMark> BlockMesh::ring_marks(BlockIndex block, std::size_t ring) const {
    return ring_part(*this, edge_marks, block, ring);
}

void BlockMesh::begin_block(BlockMaterialIndex material, BlockMotion block_motion, std::string name) {
    block_rings.push_back(block_rings.back());
    block_material.push_back(material);
    motion.push_back(block_motion);
    motion_name.push_back(std::move(name));
}

void BlockMesh::add_ring(std::span<const VertexIndex> ring_vertices, std::span<const EdgeMark> marks) {
    corners.insert(corners.end(), ring_vertices.begin(), ring_vertices.end());
    edge_marks.insert(edge_marks.end(), marks.begin(), marks.end());
    ring_corners.push_back(corners.size());
    ++block_rings.back();
}

}  // namespace rockslope::blockgen
