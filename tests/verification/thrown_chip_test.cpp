// Chips of rock in the notches between four blocks of 1 m that stand in a row. The outer blocks run against
// the inner ones, and squeeze the chips out like wedges, at a speed of v h / e at most: v of the walls, h the
// depth and e the half width of the notch. A chip of 0.4 or 1.2 cm2 has one or two contacts that slide, and
// the linear solution of a step throws it far (decision 2026-11-28-thrown-blocks). Where DampedStep holds no
// thrown blocks, the first case takes 107 iterations in a step and cuts two, and the second 27.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/scene.hpp"

namespace rockslope::thrown_chip_test {
namespace {

using namespace scene;

constexpr int blocks = 4;
constexpr double depth = 0.02;  ///< m, of a notch

/// @param half_width m, of a notch at the top.
Scene row_with_chips(double half_width) {
    Scene s;
    s.friction(20);
    s.model.normal_penalty = s.model.shear_penalty = 5e9;
    s.box({-3, -1}, blocks + 6, 1, dda::Motion::fixed);
    for (int i = 0; i < blocks; ++i) {
        const double x = i;
        std::vector<Vec2> ring = {{x, 0}, {x + 1, 0}};
        if (i + 1 < blocks) ring.insert(ring.end(), {{x + 1, 1 - depth}, {x + 1 - half_width, 1}});
        if (i + 1 == blocks) ring.emplace_back(x + 1, 1);
        if (i > 0) ring.insert(ring.end(), {{x + half_width, 1}, {x, 1 - depth}});
        if (i == 0) ring.emplace_back(x, 1);
        s.block({ring});
    }
    for (int i = 1; i < blocks; ++i) {
        const double x = i;
        s.block({{{x, 1 - depth}, {x + half_width, 1}, {x - half_width, 1}}});
    }
    return s;
}

class ThrownChip {
  public:
    ThrownChip(double half_width, double speed) : sim_(row_with_chips(half_width)), speed_(speed) {
        EXPECT_EQ(sim_.settle(0.005, 1e-5).status, dda::RunStatus::completed);
        settled_ = sim_.reports.size();
        sim_.velocity(1)[0] = speed;
        sim_.velocity(blocks)[0] = -speed;
        sim_.restart_ledger();
        const double kinetic =
            sim_.model.block_materials[0].density * speed * speed;  // of two blocks of 1 m2
        sim_.on_step = [this, kinetic](const dda::State& state, const dda::StepReport&) {
            for (int chip = blocks + 1; chip < 2 * blocks; ++chip)
                fastest_ = std::max(fastest_, state.blocks.velocity[chip].head<2>().norm());
            EXPECT_LT(state.energy.kinetic, 1.01 * kinetic);
            largest_residual_ = std::max(largest_residual_, std::abs(state.energy.residual()) / kinetic);
        };
        EXPECT_EQ(sim_.shake(0.3, 2e-3).status, dda::RunStatus::completed);
    }
    /// m/s, the largest speed of a chip.
    double fastest() const { return fastest_; }
    /// The largest residual of the energy balance over the energy of the blocks at the beginning.
    double largest_residual() const { return largest_residual_; }
    /// m, how far the chip that went farthest has moved.
    double moved() const {
        double largest = 0;
        for (int chip = blocks + 1; chip < 2 * blocks; ++chip)
            largest = std::max(largest, sim_.moved(chip).norm());
        return largest;
    }
    void expect_blocks_at_rest() const {
        for (int block = 1; block <= blocks; ++block)
            EXPECT_LT(sim_.velocity(block).head<2>().norm(), 0.02 * speed_) << block;
    }
    int cuts() const {
        int sum = 0;
        for (std::size_t k = settled_; k < sim_.reports.size(); ++k) sum += sim_.reports[k].cuts;
        return sum;
    }
    int most_iterations() const {
        int most = 0;
        for (std::size_t k = settled_; k < sim_.reports.size(); ++k)
            most = std::max(most, sim_.reports[k].iterations);
        return most;
    }

  private:
    Simulation sim_;
    double speed_;
    std::size_t settled_ = 0;
    double fastest_ = 0;
    double largest_residual_ = 0;
};

TEST(ThrownChip, StaysInItsNotchUnderALightBlow) {
    constexpr double half_width = 6e-3, speed = 0.3;
    const ThrownChip chip(half_width, speed);
    EXPECT_EQ(chip.cuts(), 0);
    EXPECT_LE(chip.most_iterations(), 15);
    EXPECT_LT(chip.moved(), depth);
    EXPECT_LT(chip.fastest(), speed * depth / half_width);
    EXPECT_LT(chip.largest_residual(), 1e-2);
    chip.expect_blocks_at_rest();
}

TEST(ThrownChip, LeavesItsNotchUnderAHardBlow) {
    constexpr double half_width = 2e-3, speed = 1;
    const ThrownChip chip(half_width, speed);
    EXPECT_EQ(chip.cuts(), 0);
    EXPECT_LE(chip.most_iterations(), 15);
    EXPECT_GT(chip.moved(), 5 * depth);
    EXPECT_LT(chip.fastest(), speed * depth / half_width);
    EXPECT_LT(chip.largest_residual(), 1e-2);
    chip.expect_blocks_at_rest();
}

}  // namespace
}  // namespace rockslope::thrown_chip_test
