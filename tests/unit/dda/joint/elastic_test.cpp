#include "dda/joint/elastic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dda/joint/joint_law.hpp"

namespace rockslope::elastic_test {
namespace {

using dda::Elastic;
using dda::JointMaterial;

TEST(Elastic, NeverSlipsInCompressionOrTension) {
    const Elastic law;
    for (const double normal : {-1e12, -1.0, -1e-12, 0.0, 1e-12, 1.0, 1e12}) {
        const dda::Strength s = law.strength(law.fresh(true), normal, 0.5);
        EXPECT_TRUE(std::isinf(s.forward) && s.forward > 0) << normal;
        EXPECT_EQ(s.backward, s.forward) << normal;
        EXPECT_EQ(s.tensile, s.forward) << normal;
    }
}

// An infinite strength would jump to zero where such faces part.
TEST(Elastic, FacesThatMeetLaterHaveFrictionOf87Degrees) {
    const Elastic law;
    for (const double normal : {-1e12, -1.0, 0.0, 1.0, 1e12}) {
        const dda::Strength s = law.strength(law.fresh(false), normal, 0.5);
        EXPECT_EQ(s.forward, 20 * std::max(normal, 0.0));
        EXPECT_EQ(s.backward, s.forward);
        EXPECT_EQ(s.tensile, 0);
    }
}

TEST(Elastic, NothingWears) {
    const Elastic law;
    EXPECT_TRUE(law.advance(law.fresh(true), {1e-3, 1e-3, -1e9, 1, false}).bonded);
    EXPECT_FALSE(law.advance(law.fresh(false), {1e-3, 1e-3, 1e9, 1, false}).bonded);
}

TEST(JointStiffness, IsTimesTheLengthAndTakesThePlaceOfThePenalty) {
    const JointMaterial joint = {"joint", Elastic{}, 0, 0, 2e10, 5e9, 0.1};
    EXPECT_DOUBLE_EQ(joint.normal_spring(5e10, 3).stiffness, 6e10);
    EXPECT_DOUBLE_EQ(joint.shear_spring(5e10, 3), 1.5e10);
}

// A face that slides off a ledge ends as a corner on an edge: its spring must not jump on the way.
TEST(JointStiffness, HasNoJumpWhereTheSharedLengthVanishes) {
    const JointMaterial joint = {"joint", Elastic{}, 0, 0, 2e10, 5e9, 0.1};
    for (const double length : {0.0, 1e-12, 0.05, 0.1}) {
        EXPECT_DOUBLE_EQ(joint.normal_spring(5e10, length).stiffness, 2e9) << length;
        EXPECT_DOUBLE_EQ(joint.shear_spring(5e10, length), 5e8) << length;
    }
}

}  // namespace
}  // namespace rockslope::elastic_test
