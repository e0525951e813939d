#include "dda/terms/row_contacts.hpp"

namespace rockslope::dda {

void RowContacts::find(int rows, std::span<const ContactSprings> springs) {
    const auto for_rows = [&](const auto& visit) {
        for (std::size_t k = 0; k < springs.size(); ++k) {
            for (const int row : {springs[k].rows.first, springs[k].rows.second}) {
                if (row >= 0) visit(static_cast<std::size_t>(row), static_cast<int>(k));
            }
        }
    };
    // Counted two places on, summed, and moved down by one while the contacts are put in their places.
    begin_.assign(static_cast<std::size_t>(rows) + 2, 0);
    for_rows([&](std::size_t row, int) { ++begin_[row + 2]; });
    for (std::size_t k = 2; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    contacts_.resize(static_cast<std::size_t>(begin_.back()));
    for_rows([&](std::size_t row, int contact) {
        contacts_[static_cast<std::size_t>(begin_[row + 1]++)] = contact;
    });
}

}  // namespace rockslope::dda
