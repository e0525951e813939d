#include "dda/analysis/energy_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/scene.hpp"

namespace rockslope::energy_watch_test {
namespace {

using namespace scene;

TEST(EnergyWatch, CountsWhatMovesAndWhatWasLost) {
    dda::Energy energy;
    energy.kinetic = 100;
    energy.friction_loss = 300;
    energy.damping_loss = 50;
    EXPECT_EQ(dda::turned_over(energy), 450);
    energy.friction_returned = 20;
    EXPECT_EQ(dda::turned_over(energy), 470) << "friction took 320";
    energy.released = 7;
    energy.numerical_loss = 3;
    EXPECT_EQ(dda::turned_over(energy), 480);
    energy.released = -7;
    energy.numerical_loss = -3;
    EXPECT_EQ(dda::turned_over(energy), 470);
}

// Other energies of the run do not hide what friction returned.
TEST(EnergyWatch, TellsBeyondAThousandthOfWhatFrictionTook) {
    dda::Energy energy;
    energy.kinetic = 1e9;
    energy.friction_loss = 1000;
    energy.friction_returned = 0.9;
    EXPECT_FALSE(dda::returns_friction(energy));
    energy.friction_returned = 1.1;
    EXPECT_TRUE(dda::returns_friction(energy));
    EXPECT_FALSE(dda::returns_friction({})) << "at the start of a run";
}

TEST(EnergyWatch, EndsBeyondATenthOfWhatIsTurnedOverOrStored) {
    dda::Energy energy;
    energy.kinetic = 10;
    energy.friction_loss = -1;
    energy.friction_returned = 1;
    EXPECT_FALSE(dda::creates_energy(energy));
    energy.friction_loss = -1.1;
    energy.friction_returned = 1.1;
    EXPECT_TRUE(dda::creates_energy(energy));
    energy.contact = 20;
    EXPECT_FALSE(dda::creates_energy(energy)) << "little of what the springs store";
    EXPECT_FALSE(dda::creates_energy({})) << "at the start of a run";
}

TEST(EnergyWatch, NamesTheContactThatGaveMost) {
    Scene s;
    s.model.joint_materials[0].name = "bedding";
    dda::Energy energy;
    energy.friction_loss = 80;
    energy.friction_returned = 20;
    energy.largest_gain = {12, 3.25, 7, 4, 0};
    EXPECT_EQ(
        dda::describe_returned(s.model, energy),
        "friction returned 20 J/m of 100 J/m turned over, which it cannot; most in one step, 12 J/m, at t = "
        "3.25 s by block 7 on block 4, joint material 'bedding'");
    energy.largest_gain = {};
    EXPECT_EQ(dda::describe_returned(s.model, energy),
              "friction returned 20 J/m of 100 J/m turned over, which it cannot");
}

TEST(EnergyWatch, TellsOfEveryAccountThatGaveMoreThanAThousandth) {
    Scene s;
    s.model.joint_materials[0].name = "bedding";
    dda::Energy energy;
    energy.kinetic = 1000;
    energy.released = -0.9;
    energy.numerical_loss = -0.9;
    EXPECT_TRUE(dda::energy_from_nowhere(s.model, energy).empty());
    energy.released = -1.1;
    energy.largest_spring_gain = {0.5, 3.25, 7, 4, 0};
    energy.numerical_loss = -1.2;
    EXPECT_EQ(
        dda::energy_from_nowhere(s.model, energy),
        (std::vector<std::string>{
            "contacts whose springs were replaced gained 1.1 J/m of 1e+03 J/m turned over, for their "
            "lengths or joints changed; most in one step, 0.5 J/m, at t = 3.25 s by block 7 on block 4, "
            "joint material 'bedding'",
            "the time integration gave 1.2 J/m of 1e+03 J/m turned over, which gamma = 1 would not"}));
}

// Energy that friction did not give is put into the account of a block that slides.
TEST(EnergyWatch, EndsADynamicStageAndSaysWhy) {
    Scene s;
    s.box({-1, -1}, 20, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    s.friction(20);
    Simulation run(s);
    run.velocity(1)[0] = 3;
    run.state.energy.friction_returned = 1e9;
    const dda::RunOutcome outcome = run.shake(1, 1e-3);
    EXPECT_EQ(outcome.status, dda::RunStatus::energy_created);
    EXPECT_LT(run.state.time, 2e-3) << "in its first step";
    EXPECT_THAT(outcome.message, testing::HasSubstr("t = 0.001 s: friction returned 1e+09 J/m of"));
}

// A block thrown along a smooth floor, and one that is dropped: friction returns nothing.
TEST(EnergyWatch, FindsNothingInABlockThatSlidesAndOneThatFalls) {
    Scene s;
    s.box({-1, -1}, 20, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    s.box({5, 0.2}, 1, 1);
    s.friction(20);
    Simulation run(s);
    run.velocity(1)[0] = 3;
    ASSERT_EQ(run.shake(1, 1e-3).status, dda::RunStatus::completed);
    EXPECT_EQ(run.state.energy.friction_returned, 0);
    EXPECT_GT(dda::turned_over(run.state.energy), 0);
}

}  // namespace
}  // namespace rockslope::energy_watch_test
