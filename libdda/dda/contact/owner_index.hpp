#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace rockslope::dda {

/// Looks items up by the number of what they belong to, a corner or a block, in constant time.
class OwnerIndex {
  public:
    /// @param owner_of per thing, in [0, owners).
    OwnerIndex(int owners, std::span<const int> owner_of);

    /// Indices of an owner's items, ascending.
    std::span<const int> of(int owner) const {
        const auto k = static_cast<std::size_t>(owner);
        return {items_.data() + offsets_[k], static_cast<std::size_t>(offsets_[k + 1] - offsets_[k])};
    }
    /// How many items belong to owners before this one.
    int offset(int owner) const { return offsets_[static_cast<std::size_t>(owner)]; }

  private:
    std::vector<int> offsets_;  ///< per owner, and the end
    std::vector<int> items_;    ///< by owner
};

}  // namespace rockslope::dda
