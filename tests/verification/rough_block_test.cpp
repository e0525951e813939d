// A block on a rough joint under base motion, against a rigid block on the same law.

#include <gtest/gtest.h>

#include <string>

#include "support/cyclic_joints.hpp"
#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/rigid_block.hpp"

namespace rockslope::rough_block_test {
namespace {

using namespace scene;
using namespace verification;

BlockTrack engine_motion(const std::string& set_up, const Shaken& block) {
    Simulation sim(block.scene());
    EXPECT_EQ(sim.settle().status, dda::RunStatus::completed);
    const double angle = radians(block.psi);
    const Vec2 downhill(std::cos(angle), -std::sin(angle));
    const Vec2 settled = sim.moved(1) - sim.moved(0);
    BlockTrack track{{0}, {0}, {0}};
    sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
        const Vec2 moved = sim.moved(1) - sim.moved(0) - settled;
        track.time.push_back(state.stage_time);
        track.slip.push_back(moved.dot(downhill));
        track.rise.push_back(moved.dot(dda::perpendicular(downhill)));
    };
    EXPECT_EQ(sim.run(block.shaking()).status, dda::RunStatus::completed);
    expect_energy_balance("V56", set_up, sim);
    return track;
}

/// V56: the engine's slip and rise at the instants expected, within 2 % of the published ones, which the
/// rigid block of the tests reproduces; both motions in a picture.
/// @param rigid_error largest error of the rigid block, a fraction.
void expect_motion(const std::string& set_up, const std::string& slug, const Shaken& block,
                   double rigid_error = 0.01) {
    const BlockTrack engine = engine_motion(set_up, block), rigid = rigid_motion(block);
    Case row("V56", set_up, "required");
    for (const Expected& here : block.expected) {
        const std::string at = "(" + to_text(here.time) + " s)";
        row.expect("slip" + at, "m", engine.at(here.time).slip, here.slip, relative(0.02));
        row.expect("rise" + at, "m", engine.at(here.time).rise, here.rise, relative(0.02));
        EXPECT_NEAR(rigid.at(here.time).slip, here.slip, rigid_error * here.slip)
            << set_up << ' ' << here.time;
        EXPECT_NEAR(rigid.at(here.time).rise, here.rise, rigid_error * here.rise)
            << set_up << ' ' << here.time;
    }
    record_picture("V56", slug + "-slip", "V56: " + set_up, "time, s", "slip, m",
                   {{"rigid block", rigid.time, rigid.slip}, {"engine", engine.time, engine.slip}});
    record_picture("V56", slug + "-rise", "V56: " + set_up, "time, s", "rise, m",
                   {{"rigid block", rigid.time, rigid.rise}, {"engine", engine.time, engine.rise}});
}

Shaken under(double psi, const dda::JointLaw& law, const std::function<double(double)>& acceleration,
             double step, const std::vector<Expected>& expected) {
    return {.psi = psi,
            .law = law,
            .width = 2,
            .height = 1,
            .density = 2500,
            .acceleration = acceleration,
            .step = step,
            .expected = expected};
}
double harmonic(double t, double peak) {
    return t < 2.5 ? -peak * std::sin(4 * std::numbers::pi * t) : 0;
}

TEST(RoughBlock, FlatUnderAPulse) {
    expect_motion("flat joint, pulse of 0.6 g", "flat",
                  under(0, even(2, 18), [](double t) { return pulse(t, -0.6 * g, 0.6); }, 5e-4,
                        {{0.3, 9.57e-3, 1.08e-3}, {0.4, 28.78e-3, 3.31e-3}, {0.6, 61.12e-3, 7.06e-3}}));
}

TEST(RoughBlock, OnASlopeUnderHarmonicMotion) {
    expect_motion("10°, 0.5 g at 2 Hz", "slope",
                  under(10, even(3, 20), [](double t) { return harmonic(t, 0.5 * g); }, 1e-3,
                        {{1, 37.9e-3, 6.65e-3}, {3, 92.0e-3, 16.14e-3}}));
}

TEST(RoughBlock, OnASlopeThatYieldsJust) {
    expect_motion("10°, 0.3 g at 2 Hz", "yields-just",
                  under(10, even(2, 18), [](double t) { return harmonic(t, 0.3 * g); }, 1.25e-4,
                        {{3, 29.44e-3, 3.42e-3}}));
}

TEST(RoughBlock, MarbleAt45Degrees) {
    Shaken block = under(45, joint_tests::marble(), [](double t) { return pulse(t, -0.5 * g, 0.2); }, 1e-4,
                         {{0.2, 11.74e-3, 2.51e-3}, {0.8, 393.0e-3, 3.208e-3}});
    block.width = 100;
    block.height = 26.697;
    block.density = 2700;
    expect_motion("marble at 45°, pulse of 0.5 g", "marble", block);
}

// The landing is damped critically in all. A wide block does not rock, which a rigid block of two degrees of
// freedom cannot. The published block lands on the spring that it had; the law finds it anew.
TEST(RoughBlock, ThrownByAKick) {
    Shaken block = under(0, even(2, 18), [](double t) { return pulse(t, -0.6 * g, 0.6); }, 2.5e-4,
                         {{0.4, 38.09e-3, 4.39e-3}, {0.5, 76.37e-3, 8.83e-3}, {0.6, 99.25e-3, 11.49e-3}});
    block.width = 8;
    block.vertical = kick;
    block.contact_damping = 1;
    expect_motion("flat joint, pulse of 0.6 g and a kick of 2 g", "kick", block, 0.04);
}

// The curve of Barton (1985) has no published motion; the rigid block is the reference. On the law's own soft
// spring, 4.6 MPa/m, the joint does not follow a normal force that swings: each fall of it takes from the
// shear force what the spring regains only 2 mm later. There the slip depends on how far the normal contact
// swings, which its damping and the step decide, by 6 % either way; the row is for comparison.
TEST(RoughBlock, OnTheCurveOfBarton1985) {
    Shaken block =
        under(0, mobilised(), [](double t) { return pulse(t, -0.6 * g, 0.6); }, 1e-4, {{0.6, 0, 0}});
    for (const double stiffness : {0., 458e6}) {
        block.shear_stiffness = stiffness;
        const bool stiff = stiffness > 0;
        const std::string set_up =
            std::string("Barton (1985), ") + (stiff ? "a spring of 458 MPa/m" : "the law's spring");
        const BlockTrack engine = engine_motion(set_up, block), rigid = rigid_motion(block);
        const Case row("V56", set_up, stiff ? "required" : "for comparison");
        for (const double t : {0.3, 0.4, 0.5, 0.6}) {
            const std::string at = "(" + to_text(t) + " s)";
            const Expected ours = engine.at(t), its = rigid.at(t);
            if (!stiff) {
                row.inform("slip" + at, "m", ours.slip, its.slip);
                continue;
            }
            row.expect("slip" + at, "m", ours.slip, its.slip, relative(0.02));
            row.expect("rise" + at, "m", ours.rise, its.rise, relative(0.02));
        }
        record_picture("V56", stiff ? "barton-stiff" : "barton", "V56: curve of Barton (1985)", "time, s",
                       "slip, m",
                       {{"rigid block", rigid.time, rigid.slip}, {"engine", engine.time, engine.slip}});
    }
}

}  // namespace
}  // namespace rockslope::rough_block_test
