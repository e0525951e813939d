#include "dda/analysis/rotation_prediction.hpp"

#include <gtest/gtest.h>

namespace rockslope::rotation_prediction_test {
namespace {

using dda::Vec2;
using dda::Vec6;

/// One contact of a block that rotates by 0.01 rad; `opening` is the linear measure of its opening, and the
/// gap goes from 1 mm to -1 mm.
struct RotatedBlock {
    std::vector<Vec6> predicted = {Vec6::Zero()}, displacement = {Vec6::Zero()};
    std::vector<dda::Contact> before{1};
    std::vector<dda::ContactSprings> springs{1};
    dda::OpenCloseResult result;

    explicit RotatedBlock(double opening) {
        displacement[0] << 0, opening, 0.01, 0, 0, 0;
        before[0].gap = 1e-3;
        springs[0].rows.first = 0;
        springs[0].normal.direction = {0, 1};
        result.displacement = dda::PerRow<Vec6>(displacement);
        dda::EvaluatedContact& contact = result.contacts.emplace_back();
        contact.normal_force = 1e5;
        contact.gap = -1e-3;
    }
    bool failed(double kinetic) const {
        return dda::rotation_prediction_failed(predicted, displacement, springs, before, result, kinetic);
    }
};

// The linear measure is wrong by 1e-6 m, so the force of 1e5 N does 0.1 J too much.
TEST(RotationPrediction, FailsWhereTheWorkErrorExceedsAMillionthOfTheKineticEnergy) {
    const RotatedBlock block(-2e-3 + 1e-6);
    EXPECT_TRUE(block.failed(0.99e5));
    EXPECT_FALSE(block.failed(1.01e5));
}

TEST(RotationPrediction, CountsTheDilationAsOpening) {
    RotatedBlock block(-2e-3);
    EXPECT_FALSE(block.failed(1)) << "the linear measure is exact";
    block.result.contacts[0].dilation_increment = 1e-6;
    EXPECT_TRUE(block.failed(0.99e5));
    EXPECT_FALSE(block.failed(1.01e5));
}

TEST(RotationPrediction, AddsTheErrorsOfContactsOfBothSigns) {
    RotatedBlock block(-2e-3 + 1e-6);
    block.before.push_back(block.before[0]);
    block.springs.push_back(block.springs[0]);
    block.result.contacts.push_back(block.result.contacts[0]);
    block.result.contacts[1].gap += 2e-6;
    EXPECT_TRUE(block.failed(1.99e5)) << "0.1 J too much and 0.1 J too little are 0.2 J of error";
    EXPECT_FALSE(block.failed(2.01e5));
}

// An error e of the rotation r counts only where r e is above 1e-6 rad2, here from e = 1e-4 rad on.
TEST(RotationPrediction, IsRightWhereTheRotationWasForeseen) {
    RotatedBlock block(0);
    EXPECT_TRUE(block.failed(1));
    block.predicted[0][2] = 0.01 - 0.99e-4;
    EXPECT_FALSE(block.failed(1));
    block.predicted[0][2] = 0.01 + 1.01e-4;
    EXPECT_TRUE(block.failed(1));
}

TEST(RotationPrediction, FindsTheBlockThatTurnsMostOtherwiseThanPredicted) {
    dda::PerBlock<Vec6> predicted(3, Vec6::Zero()), displacement(3, Vec6::Zero());
    for (const int b : {0, 1, 2}) displacement[dda::BlockIndex(b)][2] = 0.1;
    predicted[dda::BlockIndex(0)][2] = 0.1;
    predicted[dda::BlockIndex(1)][2] = -0.05;
    predicted[dda::BlockIndex(2)][2] = 0.2;
    EXPECT_EQ(dda::worst_predicted(predicted, displacement), 1);
}

}  // namespace
}  // namespace rockslope::rotation_prediction_test
