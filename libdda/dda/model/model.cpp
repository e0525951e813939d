#include "dda/model/model.hpp"

namespace rockslope::dda {

void Topology::add_block(const std::vector<int>& ring_sizes) {
    const BlockIndex block = block_count();
    for (const int size : ring_sizes) {
        const CornerIndex first = corner_count();
        for (int k = 0; k < size; ++k) {
            next.push_back(first + (k + 1) % size);
            previous.push_back(first + (k + size - 1) % size);
            block_of.push_back(block);
            joint_material.push_back(JointMaterialIndex::none());
            joint.push_back(JointIndex::none());
        }
        ring_corners.push_back(corner_count());
    }
    block_corners.push_back(corner_count());
    block_rings.push_back(ring_corners.size() - 1);
}

}  // namespace rockslope::dda
