#include "dda/contact/by_corner.hpp"

namespace dda {

ByCorner::ByCorner(int corners, std::span<const int> corner_of)
    : begin_(static_cast<std::size_t>(corners) + 2, 0), things_(corner_of.size()) {
    // Counted two places on, summed, and moved down by one while the things are put in their places.
    for (const int corner : corner_of) ++begin_[static_cast<std::size_t>(corner) + 2];
    for (std::size_t k = 2; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    for (std::size_t thing = 0; thing < corner_of.size(); ++thing) {
        int& place = begin_[static_cast<std::size_t>(corner_of[thing]) + 1];
        things_[static_cast<std::size_t>(place++)] = static_cast<int>(thing);
    }
    begin_.pop_back();
}

}  // namespace dda
