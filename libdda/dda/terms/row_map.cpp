#include "dda/terms/system.hpp"

namespace rockslope::dda {

RowMap::RowMap(const PerBlock<Motion>& motion) : row_of(motion.size(), RowIndex::none()) {
    for (const BlockIndex b : motion.indices()) {
        if (motion[b] != Motion::free) continue;
        row_of[b] = count();
        block_of.push_back(b);
    }
}

}  // namespace rockslope::dda
