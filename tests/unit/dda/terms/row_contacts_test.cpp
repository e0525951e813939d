#include "dda/terms/row_contacts.hpp"

#include <gtest/gtest.h>

namespace rockslope::row_contacts_test {
namespace {

dda::ContactSprings between(int first, int second) {
    dda::ContactSprings springs;
    springs.rows.first = first;
    springs.rows.second = second;
    return springs;
}

using Contacts = std::vector<dda::ContactIndex>;

Contacts of(const dda::RowContacts& contacts, dda::RowIndex row) {
    return {contacts.of(row).begin(), contacts.of(row).end()};
}

TEST(RowContacts, AreOnBothBlocksInAscendingOrder) {
    dda::RowContacts contacts;
    for (int again = 0; again < 2; ++again) {
        contacts.find(4, std::vector{between(0, 2), between(2, 0), between(-1, 2), between(3, -1)});
        EXPECT_EQ(of(contacts, 0), (Contacts{0, 1}));
        EXPECT_EQ(of(contacts, 1), Contacts());
        EXPECT_EQ(of(contacts, 2), (Contacts{0, 1, 2}));
        EXPECT_EQ(of(contacts, 3), Contacts{3});
    }
    contacts.find(2, {});
    EXPECT_EQ(of(contacts, 1), Contacts());
}

}  // namespace
}  // namespace rockslope::row_contacts_test
