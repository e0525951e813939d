#include "dda/contact/shared_history.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace {

using dda::JointHistory;
using dda::SharedHistory;

const JointHistory worn = dda::CyclicBartonBandis::History{};

TEST(SharedHistory, IsTheValueThatItWasGiven) {
    EXPECT_EQ(*SharedHistory(), JointHistory());
    for (const JointHistory& history : {worn, JointHistory(dda::MohrCoulomb::History{true}),
                                        JointHistory(dda::MohrCoulomb::History{false})})
        EXPECT_EQ(*SharedHistory(history), history);
}

TEST(SharedHistory, IsEqualWhereTheValuesAre) {
    EXPECT_EQ(SharedHistory(worn), SharedHistory(worn));
    EXPECT_FALSE(SharedHistory(worn) == SharedHistory());
}

TEST(SharedHistory, OutlivesTheOneThatItWasCopiedFrom) {
    auto first = std::make_unique<SharedHistory>(worn);
    const SharedHistory second = *first;
    EXPECT_EQ(&**first, &*second) << "a copy keeps no bytes of its own";
    first.reset();
    EXPECT_EQ(*second, worn);
}

TEST(SharedHistory, StaysAsItWasWhenACopyIsGivenAnother) {
    const SharedHistory kept(worn);
    SharedHistory changed = kept;
    changed = JointHistory(dda::MohrCoulomb::History{true});
    EXPECT_EQ(*kept, worn);
    changed = std::move(changed);
    EXPECT_EQ(*changed, JointHistory(dda::MohrCoulomb::History{true}));
}

}  // namespace
