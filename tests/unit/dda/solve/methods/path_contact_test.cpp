#include "dda/solve/methods/path_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockslope::path_contact_test {
namespace {

using dda::PathContact;

/// A contact with friction, some cohesion and a tilt; forces in N per metre.
PathContact sliding_contact(double spring_normal, double spring_shear) {
    PathContact c;
    c.shear = PathContact::Shear::bounded;
    c.cohesion = 20;
    c.forward = .6 - .1;
    c.backward = .6 + .1;
    c.normal_stiffness = 3e9;
    c.shear_stiffness = 2e9;
    c.spring_normal = spring_normal;
    c.spring_shear = spring_shear;
    return c;
}

// The equations (90) and (91) at the start, for contacts that press, slide and are apart.
TEST(PathContact, BeginsOnTheCentralPath) {
    const double product = 50 * 50;
    for (const double normal : {-400.0, 0.0, 30.0, 800.0}) {
        for (const double shear : {-5000.0, -10.0, 0.0, 200.0, 9000.0}) {
            PathContact c = sliding_contact(normal, shear);
            c.place_on_path(product);
            const auto [of_normal, of_forward, of_backward] = c.products(0);
            EXPECT_NEAR(of_normal, product, 1e-9 * product);
            EXPECT_NEAR(of_forward, product, 1e-9 * product);
            EXPECT_NEAR(of_backward, product, 1e-9 * product);
            EXPECT_NEAR(c.at.normal, normal + c.at.distance, 1e-9);
            EXPECT_NEAR(c.at.shear, shear - c.at.forward_multiplier + c.at.backward_multiplier, 1e-6);
            EXPECT_GT(c.at.forward_room, 0);
            EXPECT_GT(c.at.backward_room, 0);
        }
    }
}

// A contact that is 1 mm apart with a tiny product: the small values must not be rounded to zero.
TEST(PathContact, KeepsSmallValues) {
    PathContact c = sliding_contact(-3e6, 5e7);
    c.cohesion = 1e6;
    c.place_on_path(1e-8);
    EXPECT_NEAR(c.at.normal, 1e-8 / 3e6, 1e-20);
    EXPECT_NEAR(c.at.forward_room, 1e-8 / (5e7 - 1e6), 1e-20);
}

// Eq. (91) with ever smaller products: the difference from the laws falls with the root of the product at
// least, for a contact at the border of all its states, too.
TEST(PathContact, ApproachesTheLaws) {
    for (const double normal : {-400.0, 0.0, 800.0}) {
        for (const double shear : {-5000.0, 0.0, 10.0, 9000.0}) {
            for (const double root : {1.0, 1e-2, 1e-4}) {
                PathContact c = sliding_contact(normal, shear);
                c.place_on_path(root * root);
                EXPECT_LE(c.law_error(), 3 * root);
            }
        }
    }
}

// The change must solve the linearised equations (90) and (91) for any change of the displacements: these
// are the identities that the elimination of Eq. (94) stands for.
TEST(PathContact, ChangesByTheLinearisedEquations) {
    PathContact c = sliding_contact(120, 400);
    c.place_on_path(30 * 30);
    c.spring_normal = 90;  // the forces have left the path
    c.spring_shear = 310;
    c.target = {700, 500, 900};
    c.set_fractions();
    c.set_constants();
    const double opening = 2e-8;
    const double shearing = -5e-8;
    c.set_change(opening, shearing);
    const PathContact::Unknowns& at = c.at;
    const PathContact::Unknowns& by = c.change;
    const double spring_normal = c.spring_normal - c.normal_stiffness * opening;
    const double spring_shear = c.spring_shear + c.shear_stiffness * shearing;
    EXPECT_NEAR(at.normal + by.normal, spring_normal + at.distance + by.distance, 1e-9);
    EXPECT_NEAR(at.shear + by.shear,
                spring_shear - at.forward_multiplier - by.forward_multiplier + at.backward_multiplier +
                    by.backward_multiplier,
                1e-9);
    EXPECT_NEAR(at.normal * (at.distance + by.distance) + at.distance * by.normal, 700, 1e-9);
    EXPECT_NEAR(at.forward_room * (at.forward_multiplier + by.forward_multiplier) +
                    at.forward_multiplier * by.forward_room,
                500, 1e-9);
    EXPECT_NEAR(at.backward_room * (at.backward_multiplier + by.backward_multiplier) +
                    at.backward_multiplier * by.backward_room,
                900, 1e-9);
    EXPECT_NEAR(by.forward_room, .5 * by.normal - by.shear, 1e-9);
    EXPECT_NEAR(by.backward_room, .7 * by.normal + by.shear, 1e-9);
}

TEST(PathContact, HeldBoundsStayWhereTheyAre) {
    PathContact c = sliding_contact(120, 400);
    c.place_on_path(30 * 30);
    const PathContact::Unknowns before = c.at;
    c.hold_bounds();
    EXPECT_NEAR(c.cohesion + c.forward * c.at.normal - c.at.shear, before.forward_room, 1e-9);
    EXPECT_NEAR(c.cohesion + c.backward * c.at.normal + c.at.shear, before.backward_room, 1e-9);
    EXPECT_DOUBLE_EQ(c.forward + c.backward, 0) << "the bounds follow the normal force no longer";
}

TEST(PathContact, LargestStepEndsWhereAnUnknownVanishes) {
    PathContact c = sliding_contact(120, 0);
    c.place_on_path(30 * 30);
    c.change.normal = -2 * c.at.normal;
    EXPECT_DOUBLE_EQ(c.largest_step(), .5);
    c.bonded = true;  // bears tension
    EXPECT_TRUE(std::isinf(c.largest_step()));
}

// A bond with more tension than leaves it a shear strength has no room for a shear force.
TEST(PathContact, BondBeyondItsShearStrengthBearsNoShear) {
    PathContact c = sliding_contact(-500, 100);
    c.bonded = true;
    c.place_on_path(1);
    EXPECT_EQ(c.shear, PathContact::Shear::none);
    EXPECT_EQ(c.at.normal, -500);
    EXPECT_EQ(c.at.shear, 0);
}

}  // namespace
}  // namespace rockslope::path_contact_test
