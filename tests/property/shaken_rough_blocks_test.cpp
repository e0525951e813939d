// Random blocks on random rough joints, shaken in both directions: they slide, rock, leave their joint and
// land on it. Whatever they do, no account of their energy gives any back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "support/cyclic_joints.hpp"
#include "support/scene.hpp"

namespace rockslope::shaken_rough_blocks_test {
namespace {

using namespace scene;

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(engine_);
    }
    /// Even on the logarithm.
    double power_between(double least, double most) {
        return std::exp(between(std::log(least), std::log(most)));
    }
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

  private:
    std::mt19937 engine_;
};

dda::JointLaw rough_law(int kind, const dda::BartonStrength& strength, double peak_displacement) {
    if (kind == 0) return dda::BartonBandis{strength, peak_displacement, dda::barton_1985(), true, 1};
    dda::CyclicBartonBandis law = kind == 1 ? joint_tests::granite() : joint_tests::marble();
    law.barton = strength;
    law.peak_displacement = peak_displacement;
    return law;
}

/// Sines of random frequencies and phases, m/s2. They begin and end at zero.
dda::TimeTable shaking(Random& random, double peak, double duration) {
    struct Sine {
        double frequency, phase;
    };
    std::vector<Sine> sines(5);
    for (Sine& sine : sines) sine = {random.power_between(0.5, 10), random.between(0, 2 * std::numbers::pi)};
    std::vector<double> times, values;
    for (double t = 0; t <= duration; t += 2e-3) {
        double sum = 0;
        for (const Sine& sine : sines)
            sum += std::sin(2 * std::numbers::pi * sine.frequency * t + sine.phase);
        times.push_back(t);
        values.push_back(peak * sum / 3 * std::sin(std::numbers::pi * t / duration));
    }
    return {times, values};
}

class ShakenRoughBlocks : public testing::TestWithParam<int> {};

// A run tells of a thousandth of the energy turned over. Where the dilation does not converge in a step and
// is left to the next one, it may do more work than friction takes: in 98 of 100 blocks friction returns less
// than 1e-5 of the energy, in the worst 4.3e-5. With the slope of a step's dilation changed after its
// solution, forces did not balance in some steps, and the residual was 5e-2.
TEST_P(ShakenRoughBlocks, CreateNoEnergy) {
    for (int k = 0; k < 5; ++k) {
        const int seed = 5 * GetParam() + k;
        SCOPED_TRACE(seed);
        Random random(static_cast<unsigned>(seed));
        const double friction = random.between(20, 38), dip = random.between(0, friction - 3);
        const double angle = -radians(dip);
        const double width = random.power_between(0.5, 10), height = width * random.between(0.25, 1.2);
        const Vec2 along(std::cos(angle), std::sin(angle));
        Scene s;
        const double peak_displacement = random.power_between(5e-4, 1e-2);
        const dda::BartonStrength strength{random.between(2, 16), random.power_between(2e7, 2e8),
                                           radians(friction)};
        s.model.joint_materials[0].law = rough_law(random.below(3), strength, peak_displacement);
        s.model.block_materials[0].youngs_modulus = random.power_between(2e9, 5e10);
        s.model.normal_penalty = s.model.shear_penalty = random.power_between(2e9, 5e10);
        s.box(-height * dda::perpendicular(along) - width * along, 5 * width, height, dda::Motion::prescribed,
              angle, "base");
        s.box({0, 0}, width, height, dda::Motion::free, angle);
        Simulation sim(s);
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        dda::Stage stage;
        stage.name = "shaking";
        stage.duration = 2;
        stage.control.step = random.power_between(2.5e-4, 5e-3);
        const double peak = g * random.between(0.2, 1);
        stage.base_motions.push_back(
            {"base", shaking(random, peak, 2), shaking(random, peak * random.between(0, 1), 2)});
        EXPECT_EQ(sim.run(stage).status, dda::RunStatus::completed);
        const dda::Energy& energy = sim.state.energy;
        const double turned_over =
            std::abs(energy.external_work) + std::abs(energy.gravity) + energy.friction_loss;
        EXPECT_LT(energy.friction_returned, 1e-4 * turned_over);
        EXPECT_GT(energy.released, -1e-3 * turned_over);
        EXPECT_GT(energy.numerical_loss, -1e-3 * turned_over);
        EXPECT_LT(std::abs(energy.residual()), 1e-5 * turned_over) << "forces do not balance";
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ShakenRoughBlocks, testing::Range(0, 4), testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(LongSeeds, ShakenRoughBlocks, testing::Range(4, 20),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace rockslope::shaken_rough_blocks_test
