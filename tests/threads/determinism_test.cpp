// The same bytes on one thread and on two. These are the tests that the thread sanitizer watches.

#include <gtest/gtest.h>

#include <cstring>

#include "support/walls.hpp"

namespace {

using namespace scene;

/// Whether two vectors of plain numbers agree to the last bit.
template <class Vector>
bool same_bits(const std::vector<Vector>& a, const std::vector<Vector>& b) {
    return a.size() == b.size() &&
           std::memcmp(static_cast<const void*>(a.data()), static_cast<const void*>(b.data()),
                       a.size() * sizeof(Vector)) == 0;
}

/// A wall that gravity sets upon in mid-air, so that contacts close, slide and open; more than 512 contacts,
/// so that loops are shared.
Simulation dropped_wall(int threads) {
    Simulation sim(running_bond_wall(12, 12, 10), threads);
    EXPECT_EQ(sim.shake(0.05, 0.005).status, dda::RunStatus::completed);
    EXPECT_GT(sim.state.contacts.contacts.size(), 512U);
    return sim;
}

TEST(Determinism, OneThreadAndTwoGiveTheSameBits) {
    const Simulation one = dropped_wall(1);
    const Simulation two = dropped_wall(2);
    const Simulation again = dropped_wall(2);
    for (const Simulation* other : {&two, &again}) {
        EXPECT_TRUE(same_bits(one.state.blocks.vertices, other->state.blocks.vertices));
        EXPECT_TRUE(same_bits(one.state.blocks.velocity, other->state.blocks.velocity));
        EXPECT_TRUE(same_bits(one.state.blocks.stress, other->state.blocks.stress));
        ASSERT_EQ(one.state.contacts.contacts.size(), other->state.contacts.contacts.size());
        for (std::size_t k = 0; k < one.state.contacts.contacts.size(); ++k) {
            EXPECT_EQ(one.state.contacts.contacts[k].normal_force,
                      other->state.contacts.contacts[k].normal_force);
            EXPECT_EQ(one.state.contacts.contacts[k].shear_force,
                      other->state.contacts.contacts[k].shear_force);
        }
        EXPECT_EQ(one.state.energy.residual(), other->state.energy.residual());
    }
}

}  // namespace
