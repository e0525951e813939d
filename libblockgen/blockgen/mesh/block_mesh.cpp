#include "blockgen/mesh/block_mesh.hpp"

#include <utility>

namespace rockslope::blockgen {

namespace {

template <class T>
std::span<const T> ring_part(const BlockMesh& mesh, const std::vector<T>& values, std::size_t block,
                             std::size_t ring) {
    const std::size_t r = mesh.block_rings[block] + ring;
    const std::size_t first = mesh.ring_corners[r];
    const std::size_t last = mesh.ring_corners[r + 1];
    return std::span<const T>(values).subspan(first, last - first);
}

}  // namespace

std::span<const std::int32_t> BlockMesh::ring(std::size_t block, std::size_t ring) const {
    return ring_part(*this, corners, block, ring);
}

std::span<const EdgeMark> BlockMesh::ring_marks(std::size_t block, std::size_t ring) const {
    return ring_part(*this, edge_marks, block, ring);
}

void BlockMesh::begin_block(std::int32_t material, BlockMotion block_motion, std::string name) {
    block_rings.push_back(block_rings.back());
    block_material.push_back(material);
    motion.push_back(block_motion);
    motion_name.push_back(std::move(name));
}

void BlockMesh::add_ring(std::span<const std::int32_t> ring_vertices, std::span<const EdgeMark> marks) {
    corners.insert(corners.end(), ring_vertices.begin(), ring_vertices.end());
    edge_marks.insert(edge_marks.end(), marks.begin(), marks.end());
    ring_corners.push_back(corners.size());
    ++block_rings.back();
}

}  // namespace rockslope::blockgen
