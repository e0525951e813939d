#include "dda/model/model.hpp"

namespace rockslope::dda {

void Topology::add_block(const std::vector<int>& ring_sizes) {
    const int block = block_count();
    for (const int size : ring_sizes) {
        const int first = corner_count();
        for (int k = 0; k < size; ++k) {
            next.push_back(first + (k + 1) % size);
            previous.push_back(first + (k + size - 1) % size);
            block_of.push_back(block);
            joint_material.push_back(-1);
            joint.push_back(-1);
        }
        ring_corners.push_back(corner_count());
    }
    block_corners.push_back(corner_count());
    block_rings.push_back(static_cast<int>(ring_corners.size()) - 1);
}

}  // namespace rockslope::dda
