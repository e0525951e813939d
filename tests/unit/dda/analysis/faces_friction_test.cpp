// Which pairs of rough faces are asked for their friction again, against what their laws say each time.

#include "dda/analysis/faces_friction.hpp"

#include <gtest/gtest.h>

#include "support/rough_faces.hpp"

namespace {

using dda::Pressed;
using dda::Strength;

struct FacesFriction : testing::Test {
    scene::Dice dice{23};
    scene::RoughFaces step{dice, {2, 2, 1, 3, 2, 1}};
    dda::StepProblem problem = step.problem();
    dda::Crew crew;
    dda::FacesFriction friction{problem, crew};
    std::vector<Pressed> pressed;

    void SetUp() override {
        for (std::size_t k = 0; k < step.contacts.size(); ++k)
            pressed.push_back({dice.between(1e5, 1e6), dice.between(-1e-3, 1e-3)});
        find(0);
    }
    void find(double enough) {
        friction.find(enough, [&](std::size_t k) { return pressed[k]; });
    }
    /// What each contact bears under a newton.
    std::vector<double> ratios_of(const dda::FacesFriction& of) const {
        std::vector<double> found;
        for (std::size_t k = 0; k < pressed.size(); ++k) {
            const Strength bounds = of.bounds(k, 1);
            found.insert(found.end(), {bounds.forward, bounds.backward});
        }
        return found;
    }
    std::vector<double> ratios() const { return ratios_of(friction); }
    std::vector<double> asked_anew() const {
        dda::FacesFriction other(problem, crew);
        other.find(0, [&](std::size_t k) { return pressed[k]; });
        return ratios_of(other);
    }
};

TEST_F(FacesFriction, StaysWhereLittleHasMoved) {
    const std::vector<double> before = ratios();
    for (Pressed& one : pressed) one.normal += 10;
    find(31);  // three contacts at most
    EXPECT_EQ(ratios(), before);
    find(0);
    EXPECT_NE(ratios(), before);
    EXPECT_EQ(ratios(), asked_anew());
}

TEST_F(FacesFriction, LittleMovementsAddUp) {
    const std::vector<double> before = ratios();
    for (int k = 0; k < 4; ++k) {
        for (Pressed& one : pressed) one.normal += 10;
        find(31);
    }
    EXPECT_NE(ratios(), before);
}

TEST_F(FacesFriction, FollowsADisplacementByItsSpring) {
    const std::vector<double> before = ratios();
    for (Pressed& one : pressed) one.shearing -= 1e-3;  // 1e5 N and more
    find(1e4);
    EXPECT_NE(ratios(), before);
    EXPECT_EQ(ratios(), asked_anew());
}

TEST_F(FacesFriction, OfFacesThatWereOpenIsAskedFor) {
    const std::vector<Pressed> closed = pressed;
    for (Pressed& one : pressed) one.normal = -1;
    find(1e9);
    find(0);
    EXPECT_EQ(ratios(), std::vector<double>(ratios().size(), 0));
    pressed = closed;
    find(1e9);
    EXPECT_EQ(ratios(), asked_anew());
}

}  // namespace
