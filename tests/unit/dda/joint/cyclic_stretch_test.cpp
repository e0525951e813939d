// The closed form of a stretch against the walk that it stands for.

#include "dda/joint/cyclic_stretch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dda/joint/cyclic_walk.hpp"
#include "support/cyclic_joints.hpp"
#include "support/random_shapes.hpp"

namespace {

using dda::CyclicBartonBandis;
using dda::CyclicWalk;
using dda::Strength;

constexpr double length = 0.1;

Strength walked(const CyclicBartonBandis& law, const CyclicBartonBandis::History& history, double normal,
                const dda::ShearTrial& trial) {
    CyclicWalk walk(law, history, normal, length, trial.stiffness, trial.shear_force,
                    CyclicWalk::Purpose::strength);
    walk.go(trial.displacement);
    Strength s = walk.bounds_at_end();
    double& ahead = trial.displacement > 0 ? s.forward : s.backward;
    const double arriving = trial.displacement > 0 ? walk.shear_force() : -walk.shear_force();
    if (walk.slipped() && arriving >= 0) ahead = std::min(ahead, arriving);
    return s;
}

std::vector<CyclicBartonBandis> laws() {
    CyclicBartonBandis healing = joint_tests::granite(), wearing = joint_tests::marble(),
                       skew = joint_tests::sliding_plane();
    healing.heal = true;
    wearing.reversal_factor = wearing.further_cycle_factor = 0.9;
    wearing.min_slip = 5e-6;
    skew.asymmetric = true;
    return {
        joint_tests::granite(), joint_tests::marble(), joint_tests::sliding_plane(), healing, wearing, skew};
}

TEST(CyclicStretch, IsWhatTheWalkComesTo) {
    scene::Dice dice(29);
    int trials = 0, found = 0;
    for (const CyclicBartonBandis& law : laws()) {
        for (int way = 0; way < 400; ++way) {
            CyclicBartonBandis::History history = law.fresh(true);
            const double stiffness = std::pow(10, dice.between(7, 9.5));
            double force = 0;
            for (int k = dice.one_of(6); k > 0; --k) {
                CyclicWalk walk(law, history, dice.between(2e4, 2e5), length, stiffness, force,
                                CyclicWalk::Purpose::history);
                walk.go(law.peak_displacement * dice.between(-6, 6));
                history = walk.history();
                force = walk.shear_force();
            }
            for (int k = 0; k < 50; ++k) {
                const double normal = std::pow(10, dice.between(2, 6.5));
                const double size = law.peak_displacement * std::pow(10, dice.between(-5, 0.5));
                const dda::ShearTrial trial{dice.one_of(2) == 0 ? size : -size,
                                            force * dice.between(0.5, 1.5), stiffness};
                const auto closed = dda::strength_on_stretch(law, history, normal, length, trial);
                ++trials;
                if (!closed) continue;
                ++found;
                const Strength expected = walked(law, history, normal, trial);
                EXPECT_NEAR(closed->forward, expected.forward, 1e-14 * normal) << way << ' ' << k;
                EXPECT_NEAR(closed->backward, expected.backward, 1e-14 * normal) << way << ' ' << k;
            }
        }
    }
    EXPECT_GT(found, trials / 3);
}

}  // namespace
