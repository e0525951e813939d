// Blocks on shaking tables: a plane as in an experiment, a base that shakes in both directions, a stack that
// slips at every level.

#include <gtest/gtest.h>

#include <array>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"
#include "support/sliding_block.hpp"

namespace rockslope::shaking_table_test {
namespace {

using namespace scene;
using namespace verification;

constexpr double pi = std::numbers::pi;

struct TableRun {
    double amplitude;   ///< over g
    double horizontal;  ///< m, slip after 5 s if the table accelerates horizontally
    double along;       ///< m, the same if it accelerates along the plane
    friend std::ostream& operator<<(std::ostream& out, const TableRun& run) { return out << run.amplitude; }
};
class InclinedTable : public testing::TestWithParam<TableRun> {};

// P06. A block on 11.37 degrees with a friction of 16, on a table that shakes at 2.66 Hz and starts uphill.
// The published slips belong to a horizontal acceleration; one along the plane leaves the normal force as it
// is and less slip. Both are integrated here.
TEST_P(InclinedTable, SlipsAsTheSlidingBlock) {
    const TableRun& c = GetParam();
    const double psi = radians(11.37);
    const Acceleration table = [&](double t) { return -c.amplitude * g * std::sin(2 * pi * 2.66 * t); };
    for (const bool along : {false, true}) {
        SlidingBlock block{11.37, 16, table};
        if (along) {
            block.base = [&](double t) { return table(t) * std::cos(psi); };
            block.vertical = [&](double t) { return -table(t) * std::sin(psi); };
        }
        const double expected = sliding_reference(11.37, 16, block.base, 5, block.vertical).slip.back();
        EXPECT_NEAR(expected, along ? c.along : c.horizontal, 2e-5);
        const std::string set_up = to_text(c.amplitude) + (along ? " g along the plane" : " g, horizontal");
        block.run("P06", set_up, 5, 2e-4);
        Case slip("P06", set_up, "required");
        slip.contact_frequency_step(block.frequency_step);
        slip.expect("s(5 s)", "m", block.track.slip.back(), expected, relative(.03));
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, InclinedTable,
                         testing::Values(TableRun{.1, .00821, .00560}, TableRun{.15, .07652, .06720},
                                         TableRun{.2, .17725, .16174}, TableRun{.25, .29345, .27200}));

// P14. The base shakes horizontally at 2 Hz and vertically at 3 Hz, out of phase. The order is that of the
// changes from step to step, each half of the one before; below them is the difference to the rigid block,
// whose friction needs no displacement.
TEST(ShakenBothWays, SlipsAsTheSlidingBlockToFirstOrder) {
    std::vector<double> slips;
    for (const double step : {2e-3, 1e-3, 5e-4, 2.5e-4}) {
        SlidingBlock block{10, 20, [](double t) { return .4 * g * std::sin(4 * pi * t); }};
        block.vertical = [](double t) { return .3 * g * std::sin(6 * pi * t + 1); };
        const double expected = sliding_reference(10, 20, block.base, 3, block.vertical).slip.back();
        const std::string set_up = "0.4 g at 2 Hz and vertically 0.3 g at 3 Hz, Δt = " + to_text(step) + " s";
        block.run("P14", set_up, 3, step);
        slips.push_back(block.track.slip.back());
        if (step > 1e-3) continue;
        Case slip("P14", set_up, "required at 1 ms");
        slip.contact_frequency_step(block.frequency_step);
        slip.expect("s(3 s)", "m", slips.back(), expected, relative(.03));
    }
    const double order = std::log2((slips[0] - slips[1]) / (slips[2] - slips[3])) / 2;
    Case("P14", "0.4 g at 2 Hz and vertically 0.3 g at 3 Hz",
         "a step of 2 ms resolves the motion, a fortieth of a cycle")
        .expect("order in Δt", "", order, 1, absolute(.1));
}

/// Three blocks of 4 m x 1 m, one on the other on a base, with less friction at each level.
struct Stack {
    static constexpr std::array<double, 3> friction = {.3, .2, .1};  ///< coefficients, from below
    double stiffness = 1;  ///< of rock and springs over the catalogue's

    /// Displacement of each block relative to what is below it after `duration`, s. In steps of 1e-5 s every
    /// interface exerts the impulse that stops its slip, within its friction times the weight above; the
    /// three impulses are found by successive projection. With steps of 2e-6 s the results change by 2e-6 m.
    static std::array<double, 3> reference(const Acceleration& base, double duration) {
        const double dt = 1e-5;
        std::array<double, 4> v{};  // of the base and of the blocks
        std::array<double, 3> slip{};
        std::array<double, 3> impulse{};  // over the mass of a block
        const int steps = static_cast<int>(std::lround(duration / dt));
        for (int k = 0; k < steps; ++k) {
            for (std::size_t i = 0; i < 3; ++i) slip[i] += dt / 2 * (v[i + 1] - v[i]);
            v[0] += dt * base((k + .5) * dt);
            for (std::size_t i = 0; i < 3; ++i) apply(v, i, impulse[i]);
            for (int sweep = 0; sweep < 30; ++sweep) {
                for (std::size_t i = 0; i < 3; ++i) {
                    const double limit = friction[i] * (3. - static_cast<double>(i)) * g * dt;
                    const double stops = impulse[i] - (i == 0 ? 1 : .5) * (v[i + 1] - v[i]);
                    const double next = std::clamp(stops, -limit, limit);
                    apply(v, i, next - impulse[i]);
                    impulse[i] = next;
                }
            }
            for (std::size_t i = 0; i < 3; ++i) slip[i] += dt / 2 * (v[i + 1] - v[i]);
        }
        return slip;
    }
    void run(const std::string& set_up, const Acceleration& base, double duration, double step) const;

  private:
    static void apply(std::array<double, 4>& v, std::size_t interface, double impulse) {
        v[interface + 1] += impulse;
        if (interface > 0) v[interface] -= impulse;
    }
    Scene scene(bool glued) const {
        Scene s;
        s.model.block_materials[0].youngs_modulus *= stiffness;
        s.model.normal_penalty = s.model.shear_penalty *= stiffness;
        s.model.joint_materials.clear();
        s.box({-10, -1}, 24, 1, dda::Motion::prescribed, 0, "base");
        for (int i = 0; i < 3; ++i) {
            const double phi = std::atan(friction[static_cast<std::size_t>(i)]) * 180 / pi;
            s.model.joint_materials.push_back({"level", Scene::mohr_coulomb(glued ? 60 : phi), 0, 0});
            s.box({0, static_cast<double>(i)}, 4, 1);
            for (const int edge : {4 * i + 2, 4 * i + 4}) s.model.topology.joint_material[edge] = i;
        }
        return s;
    }
};

void Stack::run(const std::string& set_up, const Acceleration& base, double duration, double step) const {
    Simulation settled(scene(true));
    ASSERT_EQ(settled.settle().status, dda::RunStatus::completed);
    Simulation sim(scene(false));
    sim.state = settled.state;
    sim.restart_ledger();
    dda::Stage stage;
    stage.name = "shaking";
    stage.duration = duration;
    stage.control.step = step;
    stage.base_motions.push_back({"base", sampled(base, duration), {}});
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    expect_energy_balance("P14", set_up, sim);
    Case slips("P14", set_up, "required at 1 ms");
    slips.contact_frequency_step(sim.contact_frequency_step());
    const std::array<double, 3> expected = reference(base, duration);
    for (int i = 0; i < 3; ++i)
        slips.expect("slip of level " + to_text(i + 1), "m", (sim.moved(i + 1) - sim.moved(i)).x(),
                     expected[static_cast<std::size_t>(i)], relative(.03));
}

// P14. The upper blocks need 0.1 g and 2 x 0.2 g - 0.1 g to follow, the lowest 3 x 0.3 g - 2 x 0.2 g. The
// motion of 3 s goes to and fro by more than is left of it at the end, so it needs a rock thirty times
// stiffer and finer steps.
TEST(ShakenStack, SlipsAtEveryLevel) {
    Stack().run(
        "stack of three, half a sine of 0.9 g at 2 Hz, Δt = 0.001 s",
        [](double t) { return t < .25 ? .9 * g * std::sin(4 * pi * t) : 0; }, 2, 1e-3);
    Stack{30}.run(
        "stack of three, 0.8 g at 2 Hz for 3 s, Δt = 0.00025 s",
        [](double t) { return .8 * g * std::sin(4 * pi * t); }, 3, 2.5e-4);
}

}  // namespace
}  // namespace rockslope::shaking_table_test
