#include "dda/terms/system.hpp"

namespace rockslope::dda {

RowMap::RowMap(const std::vector<Motion>& motion) : row_of(motion.size(), -1) {
    for (std::size_t b = 0; b < motion.size(); ++b) {
        if (motion[b] != Motion::free) continue;
        row_of[b] = count();
        block_of.push_back(static_cast<int>(b));
    }
}

}  // namespace rockslope::dda
