#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dda/terms/springs.hpp"

namespace rockslope::dda {

/// For each matrix row, the contacts with a spring on its block. Assembly by rows needs no locks.
class RowContacts {
  public:
    /// Finds the contacts of all rows. Allocates only if there are more contacts or rows than ever before.
    void find(std::size_t rows, ContactSpan<const ContactSprings> springs);

    /// Indices of a row's contacts, ascending.
    std::span<const ContactIndex> of(RowIndex row) const {
        return std::span(contacts_).subspan(begin_[row], begin_[row + 1] - begin_[row]);
    }

  private:
    PerRow<std::uint32_t> begin_;  ///< index of the first contact of each row in contacts_, then the end
    std::vector<ContactIndex> contacts_;
};

}  // namespace rockslope::dda
