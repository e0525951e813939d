// Random blocks thrown at each other. For all shapes, speeds and steps: no block penetrates another by more
// than its contacts account for, none passes through another, momentum is conserved, and energy does not
// grow.

#include <gtest/gtest.h>

#include <limits>

#include "support/flight_monitor.hpp"
#include "support/random_shapes.hpp"

namespace rockslope::impact_test {
namespace {

using namespace scene;

/// Two or three blocks; the second and third fly towards the first. Half of them have a corner aimed at a
/// corner, either exactly or with a small offset.
FlightSetup random_throw(unsigned seed) {
    RandomSource random(seed);
    FlightSetup result;
    Scene& s = result.scene;
    s.model.gravity.setZero();
    s.friction(random.index_below(2) == 0 ? 0 : random.between(10, 60));
    s.model.normal_penalty = s.model.shear_penalty = 1e10 * random.magnitude(1, 100);
    const double size = random.magnitude(.3, 3);
    const Ring target = random_ring_at(random, size, {0, 0});
    s.block({target});
    result.velocity.push_back(Vec6::Zero());
    const unsigned count = 1 + random.index_below(2);
    const double speed = random.magnitude(.1, 50);
    double longest_flight = 0;
    for (unsigned k = 0; k < count; ++k) {
        const double own_size = size * random.magnitude(.1, 1);
        const Ring shape = random_ring_at(random, own_size, {0, 0});
        // Starts outside the circumscribed circle of the target, each block on its own side.
        const Vec2 from = placed(Vec2(0, 1), std::numbers::pi * k + random.between(-.5, .5), Vec2(0, 0));
        const double away = (size + own_size) / std::sqrt(2) * random.between(1.05, 1.2);
        Vec2 aim = size * random.between(-.3, .3) * dda::perpendicular(from);
        if (random.index_below(2) == 0) {
            const double past = random.index_below(2) == 0 ? 0 : size * random.magnitude(1e-9, 1e-2);
            const Vec2 of_shape = shape[random.index_below(static_cast<unsigned>(shape.size()))];
            const Vec2 of_target = target[random.index_below(static_cast<unsigned>(target.size()))];
            aim = of_target - of_shape + past * dda::perpendicular(from);
            aim -= aim.dot(from) * from;
        }
        s.block({placed(shape, 0, aim + away * from)});
        Vec6 v = Vec6::Zero();
        v.head<2>() = -speed * random.between(.5, 1) * from;
        if (random.index_below(2) == 0) v[2] = speed / size * random.between(-2, 2);
        result.velocity.push_back(v);
        longest_flight = std::max(longest_flight, away / -v.head<2>().dot(from));
    }
    result.stage.duration = 1.5 * longest_flight;
    result.stage.control.step = random.magnitude(1e-5, 5e-3);
    result.stage.control.step = std::max(result.stage.control.step, result.stage.duration / 400);
    // Half of the throws have Shi's displacement limit, half have none.
    if (random.index_below(2) == 0) result.stage.control.displacement_ratio = 100;
    return result;
}

constexpr int least_hits = 40;  // of 50 throws; 49 and 50 were seen

class Impact : public testing::TestWithParam<unsigned> {};

TEST_P(Impact, NoBlockPenetratesAnotherUndetected) {
    int hits = 0;
    for (unsigned seed = 50 * GetParam() + 1; seed <= 50 * (GetParam() + 1); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        FlightMonitor monitor(random_throw(seed));
        monitor.run();
        if (HasFatalFailure()) return;
        hits += monitor.closed_contacts() > 0;
    }
    EXPECT_GE(hits, least_hits) << "of 50 throws";
}
INSTANTIATE_TEST_SUITE_P(Fifties, Impact, testing::Range(0U, 20U), testing::PrintToStringParamName());

class DampedImpact : public testing::TestWithParam<unsigned> {};

// The same with dashpots from a twentieth to twice the critical: energy does not grow, and dashpots take
// some.
TEST_P(DampedImpact, NoBlockPenetratesAnotherUndetected) {
    int damped = 0;
    for (unsigned seed = 50 * GetParam() + 1; seed <= 50 * (GetParam() + 1); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        FlightSetup thrown = random_throw(seed);
        thrown.scene.model.joint_materials[0].contact_damping = RandomSource(seed).magnitude(0.05, 2);
        FlightMonitor monitor(thrown);
        monitor.run();
        if (HasFatalFailure()) return;
        damped += monitor.simulation().state.energy.contact_damping_loss > 0;
    }
    EXPECT_GE(damped, least_hits) << "of 50 throws";
}
INSTANTIATE_TEST_SUITE_P(Fifties, DampedImpact, testing::Range(0U, 20U), testing::PrintToStringParamName());

/// Throws that once failed, named by the cause. The test of a cause requires that it occurs.
class KnownThrow : public testing::TestWithParam<unsigned> {
  protected:
    FlightMonitor monitor{random_throw(GetParam())};

    void fly() {
        monitor.run();
        EXPECT_GT(monitor.closed_contacts(), 0) << "the blocks must meet";
    }
    /// Twice the area of a block over its perimeter, m, of the thinnest: the thickness of a plate.
    double least_thickness() const {
        double least = std::numeric_limits<double>::infinity();
        const dda::Topology& topology = monitor.simulation().model.topology;
        const dda::BlockSystem& blocks = monitor.simulation().state.blocks;
        for (const dda::BlockIndex b : topology.blocks())
            least =
                std::min(least, 2 * blocks.moments[b].area / perimeter(topology, blocks.vertices, b.value()));
        return least;
    }
};

class BlockRotatedOntoAnotherCorner : public KnownThrow {};
TEST_P(BlockRotatedOntoAnotherCorner, NoBlockPenetratesAnotherUndetected) {
    fly();
    EXPECT_GT(monitor.largest_rotation_error(), 1e-3) << "an impact must turn a block";
}
INSTANTIATE_TEST_SUITE_P(Known, BlockRotatedOntoAnotherCorner, testing::Values(82U, 217U, 570U, 900U),
                         testing::PrintToStringParamName());

class TipPassedThroughAThinBlock : public KnownThrow {};
TEST_P(TipPassedThroughAThinBlock, NoBlockPenetratesAnotherUndetected) {
    fly();
    EXPECT_GT(monitor.largest_displacement(), least_thickness()) << "in one step";
}
INSTANTIATE_TEST_SUITE_P(Known, TipPassedThroughAThinBlock, testing::Values(78U, 193U, 424U, 438U),
                         testing::PrintToStringParamName());

class CornerBesideTheLoadedOne : public KnownThrow {};
TEST_P(CornerBesideTheLoadedOne, NoBlockPenetratesAnotherUndetected) {
    fly();
    EXPECT_GT(monitor.loaded_neighbours(), 0) << "a block must meet another with neighbouring corners";
}
INSTANTIATE_TEST_SUITE_P(Known, CornerBesideTheLoadedOne, testing::Values(108U, 508U, 583U, 643U),
                         testing::PrintToStringParamName());

class WrongPredictedRotationAddedEnergy : public KnownThrow {};
TEST_P(WrongPredictedRotationAddedEnergy, NoBlockPenetratesAnotherUndetected) {
    fly();
    EXPECT_GT(monitor.largest_rotation_error(), 1e-5) << "ten times what counts as wrong";
}
INSTANTIATE_TEST_SUITE_P(Known, WrongPredictedRotationAddedEnergy, testing::Values(521U, 564U, 616U),
                         testing::PrintToStringParamName());

class RearEntranceLineHadAForce : public KnownThrow {};
TEST_P(RearEntranceLineHadAForce, NoBlockPenetratesAnotherUndetected) {
    fly();
    EXPECT_GT(monitor.loaded_rear_lines(), 0) << "another line must have borne force, or be entered first";
}
INSTANTIATE_TEST_SUITE_P(Known, RearEntranceLineHadAForce, testing::Values(24U, 864U),
                         testing::PrintToStringParamName());

// A block hits a plate 1 cm thick at 50 m/s. It moves by up to ten times the thickness in a step.
TEST(ThinPlate, IsNotPassedThrough) {
    for (const double step_displacement : {.002, .01, .025, .1}) {
        for (const double turned : {0.0, .1, .5}) {
            Scene s;
            s.model.gravity.setZero();
            s.box({-1, 0}, 2, .01);
            const int bullet =
                s.block({placed(Ring{{-.05, -.05}, {.05, -.05}, {.05, .05}, {-.05, .05}}, turned, {.3, .1})});
            Simulation sim(s);
            sim.velocity(bullet)[1] = -50;
            sim.restart_ledger();
            dda::Stage stage;
            stage.duration = .01;
            stage.control.step = step_displacement / 50;
            stage.control.displacement_ratio = 10;
            ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
            const auto& vertices = sim.state.blocks.vertices;
            const Vec2 along = vertices[2] - vertices[3];
            for (int k = 4; k < 8; ++k) {
                EXPECT_GT(dda::cross(along, vertices[k] - vertices[3]) / along.norm(), -1e-3)
                    << "corner " << k << " must be above the plate; displacement of a step "
                    << step_displacement << " m, rotated by " << turned;
            }
        }
    }
}

}  // namespace
}  // namespace rockslope::impact_test
