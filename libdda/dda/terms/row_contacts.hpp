#pragma once

#include <span>
#include <vector>

#include "dda/terms/springs.hpp"

namespace rockslope::dda {

/// The contacts that each row has springs of: what a row's equations are put together from, each row by
/// itself.
class RowContacts {
  public:
    /// Takes no new memory where the contacts found before were as many.
    void find(int rows, std::span<const ContactSprings> springs);

    /// Indices of a row's contacts, ascending.
    std::span<const int> of(std::size_t row) const {
        return {contacts_.data() + begin_[row], static_cast<std::size_t>(begin_[row + 1] - begin_[row])};
    }

  private:
    std::vector<int> begin_;  ///< per row, and the end
    std::vector<int> contacts_;
};

}  // namespace rockslope::dda
