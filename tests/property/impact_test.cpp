// Blocks thrown at each other at random: whatever the shapes, speeds and steps, no block gets into another
// farther than its contacts say, none comes out on another's far side, momentum stays, energy does not grow.

#include <gtest/gtest.h>

#include "support/flight_monitor.hpp"
#include "support/random_shapes.hpp"

using namespace rockslope;

namespace {

using namespace scene;

/// Two or three blocks, the second and third on their way to the first: half of them with a corner aimed at
/// a corner, as exactly as rounding allows or past it by a little.
FlightSetup random_throw(unsigned seed) {
    RandomSource random(seed);
    FlightSetup result;
    Scene& s = result.scene;
    s.model.gravity.setZero();
    s.friction(random.index_below(2) == 0 ? 0 : random.between(10, 60));
    s.model.normal_penalty = s.model.shear_penalty = 1e10 * random.magnitude(1, 100);
    const double size = random.magnitude(.3, 3);
    const Ring target = placed(random_ring(random, size), random.between(0, 6), Vec2(0, 0));
    s.block({target});
    result.velocity.push_back(Vec6::Zero());
    const unsigned count = 1 + random.index_below(2);
    const double speed = random.magnitude(.1, 50);
    double slowest_way = 0;
    for (unsigned k = 0; k < count; ++k) {
        const double own_size = size * random.magnitude(.1, 1);
        const Ring shape = placed(random_ring(random, own_size), random.between(0, 6), Vec2(0, 0));
        // Thrown from outside of the target's circle, on its own side of it.
        const Vec2 from = placed(Vec2(0, 1), std::numbers::pi * k + random.between(-.5, .5), Vec2(0, 0));
        const double away = (size + own_size) / std::sqrt(2) * random.between(1.05, 1.2);
        Vec2 aim = size * random.between(-.3, .3) * dda::perpendicular(from);
        if (random.index_below(2) == 0) {
            const double past = random.index_below(2) == 0 ? 0 : size * random.magnitude(1e-9, 1e-2);
            aim = target[random.index_below(static_cast<unsigned>(target.size()))] -
                  shape[random.index_below(static_cast<unsigned>(shape.size()))] +
                  past * dda::perpendicular(from);
            aim -= aim.dot(from) * from;
        }
        s.block({placed(shape, 0, aim + away * from)});
        Vec6 v = Vec6::Zero();
        v.head<2>() = -speed * random.between(.5, 1) * from;
        if (random.index_below(2) == 0) v[2] = speed / size * random.between(-2, 2);
        result.velocity.push_back(v);
        slowest_way = std::max(slowest_way, away / -v.head<2>().dot(from));
    }
    result.stage.duration = 1.5 * slowest_way;
    result.stage.control.step = random.magnitude(1e-5, 5e-3);
    result.stage.control.step = std::max(result.stage.control.step, result.stage.duration / 400);
    // Half of the throws at Shi's limit, half with as long a way as the step makes it.
    if (random.index_below(2) == 0) result.stage.control.displacement_ratio = 100;
    return result;
}

class Impact : public testing::TestWithParam<unsigned> {};

TEST_P(Impact, NoBlockPenetratesAnotherUndetected) {
    for (unsigned seed = 50 * GetParam() + 1; seed <= 50 * (GetParam() + 1); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        FlightMonitor(random_throw(seed)).run();
        if (HasFatalFailure()) return;
    }
}
INSTANTIATE_TEST_SUITE_P(Fifties, Impact, testing::Range(0U, 20U), testing::PrintToStringParamName());

/// Throws that went wrong once, by what was wrong.
class KnownThrow : public testing::TestWithParam<unsigned> {};

TEST_P(KnownThrow, NoBlockPenetratesAnotherUndetected) {
    FlightMonitor(random_throw(GetParam())).run();
}
INSTANTIATE_TEST_SUITE_P(BlockTurnedOntoAnotherCorner, KnownThrow, testing::Values(82U, 217U, 570U, 900U),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(TipWentThroughAThinBlock, KnownThrow, testing::Values(78U, 193U, 424U, 438U),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(CornerBesideTheOneThatBears, KnownThrow, testing::Values(108U, 508U, 583U, 643U),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(ArmsFromAMistakenRotationGaveEnergy, KnownThrow, testing::Values(521U, 564U, 616U),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(LineBehindWasGivenAForce, KnownThrow, testing::Values(24U, 864U),
                         testing::PrintToStringParamName());

// A plate 1 cm thick, hit by a block at 50 m/s with steps that take the block up to ten thicknesses far.
TEST(ThinPlate, IsNotPassedThrough) {
    for (const double way : {.002, .01, .025, .1}) {
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
            stage.control.step = way / 50;
            stage.control.displacement_ratio = 10;
            ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
            const auto& vertices = sim.state.blocks.vertices;
            const Vec2 along = vertices[2] - vertices[3];
            for (int k = 4; k < 8; ++k) {
                EXPECT_GT(
                    dda::cross(along, vertices[static_cast<std::size_t>(k)] - vertices[3]) / along.norm(),
                    -1e-3)
                    << "corner " << k << " is above the plate; way of a step " << way << ", turned "
                    << turned;
            }
        }
    }
}

}  // namespace
