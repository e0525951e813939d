#include "dda/terms/row_contacts.hpp"

#include <gtest/gtest.h>

using namespace rockslope;

namespace {

dda::ContactSprings between(int first, int second) {
    dda::ContactSprings springs;
    springs.rows.first = first;
    springs.rows.second = second;
    return springs;
}

std::vector<int> of(const dda::RowContacts& contacts, std::size_t row) {
    return {contacts.of(row).begin(), contacts.of(row).end()};
}

TEST(RowContacts, AreThoseOfBothBlocksInOrder) {
    dda::RowContacts contacts;
    for (int again = 0; again < 2; ++again) {
        contacts.find(4, std::vector{between(0, 2), between(2, 0), between(-1, 2), between(3, -1)});
        EXPECT_EQ(of(contacts, 0), (std::vector{0, 1}));
        EXPECT_EQ(of(contacts, 1), std::vector<int>());
        EXPECT_EQ(of(contacts, 2), (std::vector{0, 1, 2}));
        EXPECT_EQ(of(contacts, 3), std::vector{3});
    }
    contacts.find(2, {});
    EXPECT_EQ(of(contacts, 1), std::vector<int>());
}

}  // namespace
