#include "dda/contact/by_owner.hpp"

namespace dda {

ByOwner::ByOwner(int owners, std::span<const int> owner_of)
    : begin_(static_cast<std::size_t>(owners) + 2, 0), things_(owner_of.size()) {
    // Counted two places on, summed, and moved down by one while the things are put in their places.
    for (const int owner : owner_of) ++begin_[static_cast<std::size_t>(owner) + 2];
    for (std::size_t k = 2; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    for (std::size_t thing = 0; thing < owner_of.size(); ++thing) {
        int& place = begin_[static_cast<std::size_t>(owner_of[thing]) + 1];
        things_[static_cast<std::size_t>(place++)] = static_cast<int>(thing);
    }
    begin_.pop_back();
}

}  // namespace dda
