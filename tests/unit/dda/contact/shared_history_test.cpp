#include "dda/contact/shared_history.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace rockslope::shared_history_test {
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

TEST(SharedHistory, OfABatchOutlivesTheBatch) {
    std::vector<SharedHistory> kept;
    {
        SharedHistory::Batch batch(3);
        for (int k = 0; k < 4; ++k) {  // one more than there is room for
            dda::CyclicBartonBandis::History history;
            history.position = k;
            kept.push_back(batch.add(history));
        }
        kept.push_back(batch.add(dda::MohrCoulomb::History{true}));
    }
    kept.erase(kept.begin());
    for (int k = 1; k < 4; ++k)
        EXPECT_EQ(std::get<dda::CyclicBartonBandis::History>(*kept[k - 1]).position, k);
    EXPECT_TRUE(std::get<dda::MohrCoulomb::History>(*kept[3]).broken);
    EXPECT_EQ(reinterpret_cast<const char*>(&*kept[1]) - reinterpret_cast<const char*>(&*kept[0]),
              static_cast<std::ptrdiff_t>(sizeof(JointHistory) + sizeof(void*)))
        << "they lie one after the other";
}

}  // namespace
}  // namespace rockslope::shared_history_test
