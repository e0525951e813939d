#include <gtest/gtest.h>

#include <algorithm>

#include "support/walls.hpp"

namespace rockslope::augmentation_test {
namespace {

using namespace scene;

constexpr double tolerance = 1e-9;  // m

double largest_penetration(const dda::State& state) {
    double largest = 0;
    for (const dda::Contact& c : state.contacts.contacts)
        if (c.state != dda::ContactState::open) largest = std::max(largest, -c.gap);
    return largest;
}

double normal_force_on(const dda::State& state, int block) {
    double sum = 0;
    for (const dda::Contact& c : state.contacts.contacts)
        if (c.corner_block == block) sum += c.normal_force;
    return sum;
}

struct Settled {
    std::vector<dda::Vec3> stress;
    std::vector<Vec2> moved;
    std::size_t steps = 0;
};

/// A wall under a horizontal body force. Friction is so high that no contact slips; otherwise the forces at
/// rest would depend on the order of slipping. @param penalty_over_e penalty in multiples of E
Settled settled(double penalty_over_e, double penetration_tolerance) {
    Scene s = running_bond_wall(4, 4, penalty_over_e);
    s.model.penetration_tolerance = penetration_tolerance;
    s.model.gravity = {2, -9.81};
    s.friction(80);
    Simulation sim(s);
    EXPECT_EQ(sim.settle(.005, 1e-7).status, dda::RunStatus::completed);
    Settled result;
    result.steps = sim.reports.size();
    for (int b = 1; b < sim.model.block_count(); ++b) {
        result.stress.push_back(sim.stress(b));
        result.moved.push_back(sim.moved(b));
    }
    if (penetration_tolerance > 0) {
        EXPECT_LE(largest_penetration(sim.state), penetration_tolerance);
    }
    return result;
}

// Compares penalties of 1 E and 100 E.
TEST(AugmentedContact, DisplacementsDoNotDependOnThePenalty) {
    const Settled soft = settled(1, tolerance);
    const Settled stiff = settled(100, tolerance);
    double moved = 0;
    double difference = 0;
    for (std::size_t b = 0; b < soft.moved.size(); ++b) {
        moved = std::max(moved, soft.moved[b].norm());
        difference = std::max(difference, (soft.moved[b] - stiff.moved[b]).norm());
    }
    const double drift = 4 * tolerance * static_cast<double>(soft.steps + stiff.steps);
    EXPECT_LT(difference, drift)
        << "m; the locked contacts of four rows may each move by the tolerance per step";
    EXPECT_LT(drift, .02 * moved) << "m";
    EXPECT_GT(moved, 1e-6) << "m, by deformation of the blocks";
    const Settled plain = settled(1, 0);
    double plain_difference = 0;
    for (std::size_t b = 0; b < plain.moved.size(); ++b)
        plain_difference = std::max(plain_difference, (plain.moved[b] - stiff.moved[b]).norm());
    EXPECT_GT(plain_difference, 1e-6)
        << "m, without augmentation springs of 1 E deform as much as the blocks";
}

TEST(AugmentedContact, CarriesTheWeightWithoutPenetration) {
    for (const double penalty : {1e10, 1e12}) {
        Scene s;
        s.model.normal_penalty = s.model.shear_penalty = penalty;
        s.model.penetration_tolerance = tolerance;
        s.box({-1, -1}, 3, 1, dda::Motion::fixed);
        s.box({0, 0}, 1, 1);
        Simulation sim(s);
        ASSERT_EQ(sim.settle(.005, 1e-9).status, dda::RunStatus::completed);
        EXPECT_LE(largest_penetration(sim.state), tolerance);
        EXPECT_NEAR(normal_force_on(sim.state, 1), 2500 * g, 1e-5 * 2500 * g) << "to the force tolerance";
        ASSERT_EQ(sim.shake(2, .002).status, dda::RunStatus::completed);
        EXPECT_LT(sim.moved(1).norm(), 1e-8) << "m, at rest";
        EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-6);
    }
}

TEST(AugmentedContact, SlidesByTheClosedForm) {
    Scene s;
    s.friction(20);
    s.model.penetration_tolerance = tolerance;
    const double psi = radians(30);
    const Vec2 along(std::cos(psi), std::sin(psi));
    s.box({0, 0}, 20, 1, dda::Motion::fixed, psi);
    const int block = s.box(15 * along + dda::perpendicular(along), 2, 1, dda::Motion::free, psi);
    Simulation sim(s);
    ASSERT_EQ(sim.shake(1, .002).status, dda::RunStatus::completed);
    const double a = g * (std::sin(psi) - std::cos(psi) * std::tan(radians(20)));
    EXPECT_NEAR(sim.moved(block).norm(), a / 2, 1e-3 * a / 2) << "m; as the plain contact in V08";
    EXPECT_LT(largest_penetration(sim.state), 1e-7);
    const dda::Energy& e = sim.state.energy;
    const double drop = 2500 * 2 * a / 2 * g * std::sin(psi);
    EXPECT_NEAR(e.friction_loss, 2500 * 2 * g * std::cos(psi) * std::tan(radians(20)) * a / 2, 2e-3 * drop);
    EXPECT_LT(std::abs(e.residual()), 1e-6 * drop);
}

/// A block of 10 m x 5 m on a plane of 40 degrees whose friction angle drops suddenly from 80 to 20 degrees.
struct Released {
    double slid = 0;           ///< m, in half a second
    double turned = 0;         ///< rad, largest rotation
    double farthest = 0;       ///< m, largest gap or penetration of a contact that bears a force
    double least_loss = 0;     ///< J, smallest numerical loss of a step
    double friction_loss = 0;  ///< J
    explicit Released(double penalty) {
        const double psi = radians(40);
        const Vec2 along(std::cos(psi), -std::sin(psi));
        Scene s;
        s.model.normal_penalty = s.model.shear_penalty = penalty;
        s.model.penetration_tolerance = 1e-8;
        s.box(-dda::perpendicular(along) - 10 * along, 40, 1, dda::Motion::fixed, -psi);
        const int block = s.box({0, 0}, 10, 5, dda::Motion::free, -psi);
        s.friction(80);
        Simulation settled(s);
        EXPECT_EQ(settled.settle().status, dda::RunStatus::completed);
        s.friction(20);
        Simulation sim(s);
        sim.state = settled.state;
        sim.restart_ledger();
        double before = 0;
        sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
            turned = std::max(turned, std::abs(state.blocks.rotation[block]));
            for (const dda::Contact& c : state.contacts.contacts)
                if (c.normal_force > 0) farthest = std::max(farthest, std::abs(c.gap));
            least_loss = std::min(least_loss, state.energy.numerical_loss - before);
            before = state.energy.numerical_loss;
        };
        EXPECT_EQ(sim.shake(.5, 2e-4).status, dda::RunStatus::completed);
        slid = sim.moved(block).norm();
        friction_loss = sim.state.energy.friction_loss;
    }
};

// A contact whose spring was shifted by augmentation must open when the edge moves away. If it stayed closed
// up to the zero of the shifted spring, N*/k, it would push without touching: at 1 E this block then lifted
// off the plane, rotated by 0.1 rad and gained a million joules.
TEST(AugmentedContact, PushesOnlyWhereItTouches) {
    const double psi = radians(40);
    const double expected = g * (std::sin(psi) - std::cos(psi) * std::tan(radians(20))) / 8;
    for (const double penalty : {1e10, 1e12}) {
        const Released block(penalty);
        EXPECT_LE(block.farthest, 1e-8);
        EXPECT_LT(block.turned, 1e-5);
        EXPECT_NEAR(block.slid, expected, 1e-3 * expected) << "m; the start is elastic";
        // A gap error of the tolerance, in both directions, times the weight.
        EXPECT_GT(block.least_loss, -2e-8 * 50 * 2500 * g) << "J";
    }
}

}  // namespace
}  // namespace rockslope::augmentation_test
