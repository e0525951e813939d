#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace rockslope {

/// Union-find with path halving, of fewer than 2^32 members. The root of a set is its smallest member.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }

    /// The member that represents the set of `k`.
    std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// Unites the sets of i and j. @return true if they were different sets.
    bool unite(std::size_t i, std::size_t j) {
        i = root(i);
        j = root(j);
        if (i == j) return false;
        if (j < i) std::swap(i, j);
        parent_[j] = static_cast<std::uint32_t>(i);
        return true;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace rockslope
