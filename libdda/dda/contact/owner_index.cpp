#include "dda/contact/owner_index.hpp"

namespace rockslope::dda {

OwnerIndex::OwnerIndex(int owners, std::span<const int> owner_of)
    : offsets_(static_cast<std::size_t>(owners) + 2, 0), items_(owner_of.size()) {
    // Counted two places on, summed, and moved down by one while the items are put in their places.
    for (const int owner : owner_of) ++offsets_[static_cast<std::size_t>(owner) + 2];
    for (std::size_t k = 2; k < offsets_.size(); ++k) offsets_[k] += offsets_[k - 1];
    for (std::size_t item = 0; item < owner_of.size(); ++item) {
        int& place = offsets_[static_cast<std::size_t>(owner_of[item]) + 1];
        items_[static_cast<std::size_t>(place++)] = static_cast<int>(item);
    }
    offsets_.pop_back();
}

}  // namespace rockslope::dda
