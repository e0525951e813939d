// The closed form of a displacement against CyclicShearPath.

#include "dda/joint/cyclic_closed_form.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "dda/joint/cyclic_shear_path.hpp"
#include "support/cyclic_joints.hpp"
#include "support/random_shapes.hpp"

namespace rockslope::cyclic_closed_form_test {
namespace {

using dda::CyclicBartonBandis;
using dda::CyclicShearPath;
using dda::Strength;

constexpr double length = 0.1;

Strength walked(const CyclicBartonBandis& law, const CyclicBartonBandis::History& history, double normal,
                const dda::ShearTrial& trial) {
    CyclicShearPath path(law, history, normal, length,
                         {.stiffness = trial.stiffness, .force = trial.shear_force},
                         CyclicShearPath::Purpose::strength);
    path.displace(trial.displacement);
    Strength s = path.bounds_at_end();
    double& ahead = trial.displacement > 0 ? s.forward : s.backward;
    const double arriving = trial.displacement > 0 ? path.shear_force() : -path.shear_force();
    if (path.slipped() && arriving >= 0) ahead = std::min(ahead, arriving);
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

/// The state of a joint on a path, and its next displacement.
struct Case {
    CyclicBartonBandis law;
    CyclicBartonBandis::History history;
    double normal;
    dda::ShearTrial trial;
};

/// Calls `check(case)`, which returns whether there was a closed form, for displacements of many sizes from
/// many states of each law.
template <class Check>
void for_many_cases(const std::vector<CyclicBartonBandis>& laws, Check check) {
    scene::RandomSource random(29);
    int trials = 0, found = 0;
    for (const CyclicBartonBandis& law : laws) {
        for (int way = 0; way < 400; ++way) {
            CyclicBartonBandis::History history = law.fresh(true);
            const double stiffness = std::pow(10, random.between(7, 9.5));
            double force = 0;
            for (int k = random.index_below(6); k > 0; --k) {
                CyclicShearPath path(law, history, random.between(2e4, 2e5), length,
                                     {.stiffness = stiffness, .force = force},
                                     CyclicShearPath::Purpose::history);
                path.displace(law.peak_displacement * random.between(-6, 6));
                history = path.history();
                force = path.shear_force();
            }
            for (int k = 0; k < 50; ++k) {
                const double normal = std::pow(10, random.between(2, 6.5));
                const double size = law.peak_displacement * std::pow(10, random.between(-5, 0.5));
                const dda::ShearTrial trial{random.index_below(2) == 0 ? size : -size,
                                            force * random.between(0.5, 1.5), stiffness};
                SCOPED_TRACE(std::to_string(way) + ' ' + std::to_string(k));
                ++trials;
                if (check(Case{law, history, normal, trial})) ++found;
            }
        }
    }
    EXPECT_GT(found, trials / 3);
}

TEST(CyclicClosedForm, EqualsTheIntegratedPath) {
    for_many_cases(laws(), [](const Case& c) {
        const auto closed = dda::closed_form_strength(c.law, c.history, c.normal, length, c.trial);
        if (!closed) return false;
        const Strength expected = walked(c.law, c.history, c.normal, c.trial);
        EXPECT_NEAR(closed->forward, expected.forward, 1e-14 * c.normal);
        EXPECT_NEAR(closed->backward, expected.backward, 1e-14 * c.normal);
        return true;
    });
}

TEST(CyclicClosedForm, GivesTheHistoryOfTheIntegratedPath) {
    std::vector<CyclicBartonBandis> stiff = laws();
    for (CyclicBartonBandis& law : stiff) law.damage = 0;
    for_many_cases(stiff, [](const Case& c) {
        const auto closed = dda::closed_form_history(c.law, c.history, c.normal, length, c.trial);
        if (!closed) return false;
        CyclicShearPath path(c.law, c.history, c.normal, length,
                             {.stiffness = c.trial.stiffness, .force = c.trial.shear_force},
                             CyclicShearPath::Purpose::history);
        path.displace(c.trial.displacement);
        CyclicBartonBandis::History expected = path.history();
        // The two sum the same terms in another order; the slip contains differences of forces up to 1e7 N/m
        // over a stiffness of at least 1e7.
        EXPECT_NEAR(closed->reverse_slip, expected.reverse_slip, 1e-14);
        EXPECT_NEAR(closed->reversal_slip, expected.reversal_slip, 1e-14);
        EXPECT_NEAR(closed->position, expected.position, 1e-15 * std::abs(c.trial.displacement));
        EXPECT_NEAR(closed->furthest_forward, expected.furthest_forward, 1e-17);
        EXPECT_NEAR(closed->furthest_backward, expected.furthest_backward, 1e-17);
        EXPECT_NEAR(closed->unloading_ratio, expected.unloading_ratio, 1e-14);
        EXPECT_NEAR(closed->mobilised_ratio, expected.mobilised_ratio, 1e-14);
        expected.reverse_slip = closed->reverse_slip;
        expected.reversal_slip = closed->reversal_slip;
        expected.position = closed->position;
        expected.furthest_forward = closed->furthest_forward;
        expected.furthest_backward = closed->furthest_backward;
        expected.unloading_ratio = closed->unloading_ratio;
        expected.mobilised_ratio = closed->mobilised_ratio;
        EXPECT_TRUE(*closed == expected);  // and in all else to the bit
        return true;
    });
}

TEST(CyclicClosedForm, SkipsDilatingJoints) {
    const CyclicBartonBandis law = joint_tests::granite();
    ASSERT_GT(law.damage, 0);
    EXPECT_FALSE(dda::closed_form_history(law, law.fresh(true), 1e5, length, {1e-6, 0, 1e9}));
}

}  // namespace
}  // namespace rockslope::cyclic_closed_form_test
