// Which pairs of rough faces are asked for their friction again, against what their laws say each time.

#include "dda/analysis/faces_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
    auto of_index() const {
        return [this](std::size_t k) { return pressed[k]; };
    }
    void find(double enough) { find_in(friction, enough); }
    void find_in(dda::FacesFriction& of, double enough) const {
        of.find(enough, of_index(), [](std::size_t, const Strength&) {});
    }
    /// What each contact bears over its normal force: lines that nobody has wanted go through nothing.
    std::vector<double> ratios_of(const dda::FacesFriction& of) const {
        std::vector<double> found;
        for (std::size_t k = 0; k < pressed.size(); ++k) {
            found.insert(found.end(), {of.line(k, true, 1).slope, of.line(k, false, 1).slope});
        }
        return found;
    }
    std::vector<double> ratios() const { return ratios_of(friction); }
    std::vector<double> asked_anew() const {
        dda::FacesFriction other(problem, crew);
        find_in(other, 0);
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

TEST_F(FacesFriction, GivesEachContactItsShare) {
    std::vector<int> times(pressed.size(), 0);
    friction.find(1e9, of_index(), [&](std::size_t k, const Strength& bounds) {
        ++times[k];
        EXPECT_EQ(bounds.forward, pressed[k].normal * friction.line(k, true, 1).slope);
        EXPECT_EQ(bounds.backward, pressed[k].normal * friction.line(k, false, 1).slope);
    });
    EXPECT_EQ(times, std::vector<int>(pressed.size(), 1));
}

/// The roughness angle shrinks as the force grows, so the line is not the one through nothing. A power
/// through the strengths at a force and at half of it gives most of the difference: 0.2 is what the curvature
/// of the tangent leaves.
TEST_F(FacesFriction, AWantedLineTouchesTheStrength) {
    const double aside = 0.01;
    dda::FacesFriction more(problem, crew), less(problem, crew), lines(problem, crew);
    for (std::size_t k = 0; k < pressed.size(); ++k) lines.want_line(k);
    lines.find_lines(of_index());  // of pairs that nobody has asked for
    const std::vector<Pressed> here = pressed;
    for (Pressed& one : pressed) one.normal = one.normal * (1 + aside);
    find_in(more, 0);
    pressed = here;
    for (Pressed& one : pressed) one.normal = one.normal * (1 - aside);
    find_in(less, 0);
    for (std::size_t k = 0; k < here.size(); ++k) {
        const double normal = here[k].normal;
        const dda::BoundLine line = lines.line(k, true, normal);
        const double ratio = friction.line(k, true, normal).slope;
        EXPECT_NEAR(line.slope * normal + line.cohesion, ratio * normal, 1e-12 * ratio * normal) << k;
        const double slope = ((1 + aside) * more.line(k, true, normal).slope -
                              (1 - aside) * less.line(k, true, normal).slope) /
                             (2 * aside);
        EXPECT_NEAR(line.slope, slope, 0.2 * std::abs(ratio - slope)) << k;
    }
}

}  // namespace
