// Unusual shapes: a block in the hole of another, and blocks that hit one a hundred times their size.

#include <gtest/gtest.h>

#include "support/flight_monitor.hpp"
#include "support/random_shapes.hpp"

namespace rockslope::odd_shapes_test {
namespace {

using namespace scene;

Ring regular(unsigned corners, double radius, double turned) {
    Ring ring;
    for (unsigned k = 0; k < corners; ++k) {
        const double angle = turned + 2 * std::numbers::pi * k / corners;
        ring.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return ring;
}

Vec6 thrown(RandomSource& random, double speed, double size) {
    Vec6 v = Vec6::Zero();
    v.head<2>() = speed * random.direction();
    if (random.index_below(2) == 0) v[2] = speed / size * random.between(-2, 2);
    return v;
}

dda::Stage flight(RandomSource& random, double duration) {
    dda::Stage stage;
    stage.duration = duration;
    stage.control.step = duration / random.magnitude(100, 400);
    if (random.index_below(2) == 0) stage.control.displacement_ratio = 100;
    return stage;
}

FlightSetup empty_space(RandomSource& random) {
    FlightSetup result;
    Scene& s = result.scene;
    s.model.gravity.setZero();
    s.friction(random.index_below(2) == 0 ? 0 : random.between(10, 60));
    s.model.normal_penalty = s.model.shear_penalty = 1e10 * random.magnitude(1, 100);
    return result;
}

/// A frame with a hole of three to eight corners, and a block in the hole that moves towards the frame.
FlightSetup in_a_hole(unsigned seed) {
    RandomSource random(seed);
    FlightSetup result = empty_space(random);
    const double size = random.magnitude(.3, 3);
    const unsigned corners = 3 + random.index_below(6);
    Ring hole = regular(corners, size, random.between(0, 6));
    std::reverse(hole.begin(), hole.end());
    const double outside = size * random.between(1.2, 3);
    result.scene.block(
        {{{-outside, -outside}, {outside, -outside}, {outside, outside}, {-outside, outside}}, hole});
    result.velocity.push_back(Vec6::Zero());
    const double room = size * std::cos(std::numbers::pi / corners);
    const double own = room * random.between(.1, .9) * std::sqrt(2);
    result.scene.block({random_ring_at(random, own, {0, 0})});
    const double speed = random.magnitude(.1, 20);
    result.velocity.push_back(thrown(random, speed, own));
    result.stage = flight(random, 4 * size / speed);
    return result;
}

/// One or two pebbles that fly towards a block a hundred times their size.
FlightSetup pebbles(unsigned seed) {
    RandomSource random(seed);
    FlightSetup result = empty_space(random);
    const double size = random.magnitude(.3, 3);
    const Ring target = random_ring_at(random, size, {0, 0});
    result.scene.block({target});
    result.velocity.push_back(Vec6::Zero());
    const double own = size / 100;
    const double speed = random.magnitude(.1, 10);
    const unsigned count = 1 + random.index_below(2);
    // Aimed at a corner of the target, and at the corner farthest from it.
    const Vec2 farthest = *std::max_element(target.begin(), target.end(), [&](const Vec2& a, const Vec2& b) {
        return (a - target[0]).norm() < (b - target[0]).norm();
    });
    for (unsigned k = 0; k < count; ++k) {
        // Starts outside the circumscribed circle of the target and misses the corner by at most a pebble's
        // size.
        const Vec2 corner = k == 0 ? target[0] : farthest;
        const Vec2 outwards = corner.normalized();
        const Vec2 from = placed(outwards, random.between(-.5, .5), Vec2(0, 0));
        const double away = random.between(1, 3);
        const double aside = random.between(-1, 1);
        const Vec2 start = corner + own * away * from + own * aside * dda::perpendicular(from) +
                           (size / std::sqrt(2) - corner.norm()) * outwards;
        result.scene.block({random_ring_at(random, own, start)});
        Vec6 v = Vec6::Zero();
        v.head<2>() = -speed * from;
        if (random.index_below(2) == 0) v[2] = speed / own * random.between(-1, 1);
        result.velocity.push_back(v);
    }
    result.stage = flight(random, (10 * own + size / 2) / speed);
    return result;
}

class InAHole : public testing::TestWithParam<unsigned> {};

TEST_P(InAHole, ABlockDoesNotLeaveTheHole) {
    int hits = 0;
    for (unsigned seed = 50 * GetParam() + 1; seed <= 50 * (GetParam() + 1); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        FlightMonitor thrown(in_a_hole(seed));
        thrown.run();
        if (HasFatalFailure()) return;
        hits += thrown.closed_contacts() > 0;
    }
    EXPECT_EQ(hits, 50) << "each block must hit the frame";
}
INSTANTIATE_TEST_SUITE_P(Fifties, InAHole, testing::Range(0U, 4U), testing::PrintToStringParamName());

class Pebbles : public testing::TestWithParam<unsigned> {};

TEST_P(Pebbles, DoNotPenetrateABlockAHundredTimesTheirSize) {
    int hits = 0;
    for (unsigned seed = 50 * GetParam() + 1; seed <= 50 * (GetParam() + 1); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        FlightMonitor thrown(pebbles(seed));
        thrown.run();
        if (HasFatalFailure()) return;
        hits += thrown.closed_contacts() > 0;
    }
    EXPECT_GT(hits, 25) << "most pebbles must hit the block";
}
INSTANTIATE_TEST_SUITE_P(Fifties, Pebbles, testing::Range(0U, 4U), testing::PrintToStringParamName());

// A block of 1 m on two pebbles of 1 cm, on the ground.
TEST(Pebbles, CarryABlockAHundredTimesTheirSize) {
    Scene s;
    s.friction(30);
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    const int left = s.box({.1, 0}, .01, .01);
    const int right = s.box({.79, 0}, .01, .01);
    const int block = s.box({0, .01}, 1, 1);
    Simulation sim(s);
    const dda::RunOutcome outcome = sim.settle();
    ASSERT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
    const double weight = sim.state.blocks.mass[block] * s.model.gravity.norm();
    const double pebble = sim.state.blocks.mass[left] * s.model.gravity.norm();
    const auto under = [&](dda::BlockIndex upper, dda::BlockIndex lower) {
        double sum = 0;
        for (const dda::Contact& c : sim.state.contacts.contacts)
            if (std::minmax(c.corner_block, c.edge_block) == std::minmax(upper, lower)) sum += c.normal_force;
        return sum;
    };
    // The middle of the block is 0.395 m from that of the left pebble and 0.295 m from that of the right one.
    // The point of contact on a pebble is statically indeterminate, within half its width, of 0.69 m.
    const double indeterminacy = weight * .005 / .69;
    EXPECT_NEAR(under(block, left), weight * .295 / .69, indeterminacy);
    EXPECT_NEAR(under(block, right), weight * .395 / .69, indeterminacy);
    EXPECT_NEAR(under(block, left) + under(block, right), weight, 1e-6 * weight);
    EXPECT_NEAR(under(left, 0), under(block, left) + pebble, 1e-6 * weight);
    EXPECT_NEAR(under(right, 0), under(block, right) + pebble, 1e-6 * weight);
}

}  // namespace
}  // namespace rockslope::odd_shapes_test
