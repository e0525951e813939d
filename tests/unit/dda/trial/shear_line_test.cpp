#include "dda/trial/shear_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/resting_block.hpp"

namespace rockslope::shear_line_test {
namespace {

using namespace scene;

const double tan30 = std::tan(radians(30));

dda::ShearLine line_at(const RestingContacts& block, double normal) {
    const std::vector<Vec6> d{RestingContacts::displacement(1e-4, 1e-5)};
    return block.bounds.line(0, normal, d);
}

// Mohr and Coulomb's line over 0.5 m, with strengths divided by 1.25; bonded, it goes on in tension.
TEST(ShearLine, IsTheLawsOwnLine) {
    Scene s = resting_block(dda::MohrCoulomb{radians(30), 2e4, 5e4, radians(20), 0});
    s.model.strength_reduction = 1.25;
    const RestingContacts bonded(s);
    const dda::ShearLine line = line_at(bonded, 1e4);
    EXPECT_DOUBLE_EQ(line.slope, tan30 / 1.25);
    EXPECT_DOUBLE_EQ(line.cohesion, 2e4 * 0.5 / 1.25);
    EXPECT_EQ(line.lowest_normal_force, -std::numeric_limits<double>::infinity());
    EXPECT_DOUBLE_EQ(line.at(-1e3), (1e4 - 1e3 * tan30) / 1.25);
}

TEST(ShearLine, HasNoCohesionForAContactThatWasOpen) {
    RestingContacts block(dda::MohrCoulomb{radians(30), 2e4, 0, radians(30), 2e4});
    for (dda::Contact& contact : block.step.found.set.contacts) contact.state = dda::ContactState::open;
    const dda::StepContacts contacts(block.problem, block.step.pool);
    const auto d = std::vector<Vec6>{RestingContacts::displacement(0, 0)};
    const dda::ShearLine line = contacts.bounds.line(0, 1e4, d);
    EXPECT_EQ(line.cohesion, 0);
    EXPECT_EQ(line.lowest_normal_force, 0);
    EXPECT_EQ(line.at(-1e3), 0) << "the line ends at no normal force";
}

// As the shear bounds have it: a step whose lines had more cohesion than its bounds would not converge.
TEST(ShearLine, OfALawWithoutALineHasNoCohesionEitherForAContactThatWasOpen) {
    RestingContacts block(dda::Weakening{radians(30), radians(20), 2e4, 1e4, 5e-3});
    const auto line_of = [&](const dda::StepContacts& contacts) {
        return contacts.bounds.line(0, 1e4, std::vector<Vec6>{RestingContacts::displacement(0, 0)});
    };
    EXPECT_NEAR(line_of(block.contacts).at(1e4), 2e4 * 0.5 + 1e4 * tan30, 1e-9) << "closed";
    for (dda::Contact& contact : block.step.found.set.contacts) contact.state = dda::ContactState::open;
    const dda::StepContacts contacts(block.problem, block.step.pool);
    EXPECT_NEAR(line_of(contacts).cohesion, 0, 1e-9);
    EXPECT_NEAR(line_of(contacts).at(1e4), 1e4 * tan30, 1e-9);
}

// Patton's bilinear law is steep up to 2e6 Pa, 1e6 N over 0.5 m, and flat beyond: the secant from N to N / 2
// is one of its branches where both ends are on it, and their chord where they are not.
TEST(ShearLine, IsTheSecantOfALawWithoutALine) {
    const RestingContacts block(dda::Bilinear{radians(50), radians(30), 2e6});
    const auto strength = [](double normal) {
        const double steep = std::tan(radians(50));
        return normal < 1e6 ? steep * normal : steep * 1e6 + tan30 * (normal - 1e6);
    };
    for (const double normal : {2e5, 1.5e6, 5e6}) {
        const dda::ShearLine line = line_at(block, normal);
        const double slope = (strength(normal) - strength(normal / 2)) / (normal / 2);
        EXPECT_NEAR(line.slope, slope, 1e-9) << normal;
        EXPECT_NEAR(line.at(normal), strength(normal), 1e-9 * strength(normal)) << normal;
        EXPECT_FALSE(line.is_missing);
    }
}

// Without a normal force the line goes from zero to the last evaluation, here to 1e6 N.
TEST(ShearLine, GoesThroughZeroWithoutANormalForce) {
    RestingContacts block(dda::Bilinear{radians(50), radians(30), 1e6});
    block.move(1, 1e-3);
    block.bounds.update();
    block.trials.force_change();
    block.trials.update_active_set();
    const dda::ShearLine line = line_at(block, -1);
    EXPECT_EQ(line.cohesion, 0);
    EXPECT_NEAR(line.slope, (5e5 * std::tan(radians(50)) + 5e5 * tan30) / 1e6, 1e-6);
}

// A joint segment computes its tangent on request: first its line is missing.
TEST(ShearLine, OfASegmentIsMissingUntilItHasBeenRequested) {
    RestingContacts block(dda::Plesha{{radians(30), radians(10), 0}});
    block.move(1e-4, 1e-5);
    block.bounds.update();
    block.trials.force_change();
    block.trials.update_active_set();
    EXPECT_TRUE(line_at(block, 1e4).is_missing);
    block.bounds.request_line(0);
    block.bounds.find_requested_lines();
    const dda::ShearLine line = line_at(block, 1e4);
    EXPECT_FALSE(line.is_missing);
    EXPECT_NEAR(line.slope, std::tan(radians(40)), 1e-6);
    EXPECT_NEAR(line.cohesion, 0, 1e-3);
}

}  // namespace
}  // namespace rockslope::shear_line_test
