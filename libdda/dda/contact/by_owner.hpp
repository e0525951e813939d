#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace dda {

/// Looks things up by the number of what they belong to, a corner or a block, in constant time.
class ByOwner {
  public:
    /// @param owner_of per thing, in [0, owners).
    ByOwner(int owners, std::span<const int> owner_of);

    /// Indices of an owner's things, ascending.
    std::span<const int> of(int owner) const {
        const auto k = static_cast<std::size_t>(owner);
        return {things_.data() + begin_[k], static_cast<std::size_t>(begin_[k + 1] - begin_[k])};
    }
    /// How many things belong to owners before this one.
    int before(int owner) const { return begin_[static_cast<std::size_t>(owner)]; }

  private:
    std::vector<int> begin_;   ///< per owner, and the end
    std::vector<int> things_;  ///< by owner
};

}  // namespace dda
