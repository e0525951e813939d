#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/index.hpp"

namespace rockslope::dda {

/// Items grouped by their owner, a corner or a block, in compressed rows. Lookup takes constant time.
template <class Owner, class Item>
class OwnerIndex {
  public:
    /// @param owners number of owners. @param owner_of owner of each item, in [0, owners).
    OwnerIndex(std::size_t owners, std::span<const Owner> owner_of)
        : offsets_(owners + 2, 0), items_(owner_of.size()) {
        // Counting sort. The counts are stored two places ahead, so that after the sum offsets_[owner + 1] is
        // the owner's first free place. Placing the items advances it to the owner's end.
        for (const Owner owner : owner_of) ++offsets_[owner + 2];
        for (std::size_t k = 2; k < offsets_.size(); ++k) offsets_[k] += offsets_[k - 1];
        for (std::size_t item = 0; item < owner_of.size(); ++item)
            items_[offsets_[owner_of[item] + 1]++] = static_cast<Item>(item);
        offsets_.pop_back();
    }

    /// Indices of the items of an owner, ascending.
    std::span<const Item> of(Owner owner) const {
        return std::span(items_).subspan(offsets_[owner], offsets_[owner + 1] - offsets_[owner]);
    }
    /// Number of items of all owners before this one.
    std::size_t offset(Owner owner) const { return offsets_[owner]; }

  private:
    IndexedVector<Owner, std::uint32_t> offsets_;  ///< first item of each owner, then the number of items
    std::vector<Item> items_;                      ///< sorted by owner
};

}  // namespace rockslope::dda
