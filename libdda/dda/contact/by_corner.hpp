#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace dda {

/// Looks things up by the corner that they belong to, in constant time.
class ByCorner {
  public:
    /// @param corner_of per thing, in [0, corners).
    ByCorner(int corners, std::span<const int> corner_of);

    /// Indices of a corner's things, ascending.
    std::span<const int> of(int corner) const {
        const auto k = static_cast<std::size_t>(corner);
        return {things_.data() + begin_[k], static_cast<std::size_t>(begin_[k + 1] - begin_[k])};
    }

  private:
    std::vector<int> begin_;   ///< per corner, and the end
    std::vector<int> things_;  ///< by corner
};

}  // namespace dda
