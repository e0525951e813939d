#include "dda/terms/row_contacts.hpp"

namespace rockslope::dda {

void RowContacts::find(std::size_t rows, ContactSpan<const ContactSprings> springs) {
    const auto for_rows = [&](const auto& visit) {
        for (const ContactIndex k : springs.indices()) {
            for (const RowIndex row : {springs[k].rows.first, springs[k].rows.second}) {
                if (row.exists()) visit(row, k);
            }
        }
    };
    // Counting sort. Counts are stored two places ahead and summed; filling moves each start down by one row.
    begin_.assign(rows + 2, 0);
    for_rows([&](RowIndex row, ContactIndex) { ++begin_[row + 2]; });
    for (std::size_t k = 2; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    contacts_.resize(begin_.back());
    for_rows([&](RowIndex row, ContactIndex contact) { contacts_[begin_[row + 1]++] = contact; });
}

}  // namespace rockslope::dda
