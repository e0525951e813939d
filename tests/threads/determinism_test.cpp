// Bitwise the same results on one thread and on two. The thread sanitizer runs these tests.

#include <gtest/gtest.h>

#include <cstring>

#include "dda/contact/joint_segments.hpp"
#include "support/walls.hpp"

namespace rockslope::determinism_test {
namespace {

using namespace scene;

/// Whether two vectors are bitwise equal.
template <class Vector>
bool same_bits(const std::vector<Vector>& a, const std::vector<Vector>& b) {
    return a.size() == b.size() &&
           std::memcmp(static_cast<const void*>(a.data()), static_cast<const void*>(b.data()),
                       a.size() * sizeof(Vector)) == 0;
}

/// A wall under sudden gravity: contacts close, slide and open. It has more than 512 contacts, so that loops
/// run on several threads.
Simulation dropped_wall(int threads) {
    Simulation sim(running_bond_wall(12, 12, 10), threads);
    EXPECT_EQ(sim.shake(0.05, 0.005).status, dda::RunStatus::completed);
    EXPECT_GT(sim.state.contacts.contacts.size(), 512U);
    return sim;
}

/// The same for rough joints with wear, with more than 512 joint segments.
Simulation dropped_rough_wall(int threads) {
    dda::CyclicBartonBandis law;
    law.barton = {8, 100e6, .5};
    law.peak_displacement = 1e-3;
    const dda::RoughnessTable wear = {{{0, 1}, {2, .8}, {8, .4}}};
    law.cycles = {{wear, wear, wear, wear}};
    Scene wall = running_bond_wall(16, 16, 10);
    for (dda::JointMaterial& material : wall.model.joint_materials) material.law = law;
    Simulation sim(wall, threads);
    EXPECT_EQ(sim.shake(0.03, 0.005).status, dda::RunStatus::completed);
    EXPECT_GT(dda::JointSegments(wall.model, sim.state.contacts.contacts).count(), 512U);
    return sim;
}

void expect_same_bits(Simulation (&make)(int threads)) {
    const Simulation one = make(1);
    const Simulation two = make(2);
    const Simulation again = make(2);
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
            EXPECT_EQ(one.state.contacts.contacts[k].history, other->state.contacts.contacts[k].history);
        }
        EXPECT_EQ(one.state.energy.residual(), other->state.energy.residual());
        EXPECT_EQ(one.state.energy.friction_loss, other->state.energy.friction_loss);
        EXPECT_EQ(one.state.energy.released, other->state.energy.released);
    }
}

TEST(Determinism, OneAndTwoThreadsGiveTheSameBits) {
    expect_same_bits(dropped_wall);
}

TEST(Determinism, OneAndTwoThreadsGiveTheSameBitsForRoughJoints) {
    expect_same_bits(dropped_rough_wall);
}

}  // namespace
}  // namespace rockslope::determinism_test
