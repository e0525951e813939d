#include "dda/analysis/prediction.hpp"

#include <gtest/gtest.h>

namespace rockslope::prediction_test {
namespace {

dda::Contact contact(int first, int second, int corner, int edge) {
    dda::Contact result;
    result.corner_block = first;
    result.edge_block = second;
    result.corner = corner;
    result.edge = edge;
    return result;
}

TEST(InitialGuess, BelongsToTheContactsOfTheSameCornerAndEdge) {
    dda::InitialGuess guess;
    for (const dda::Contact& c : {contact(0, 1, 2, 5), contact(0, 1, 3, 5), contact(2, 1, 9, 6)}) {
        guess.contacts.push_back(c);
        guess.evaluated.emplace_back().normal_force = c.corner.value();
    }
    // One before all of the guess, two that it has, one between, one after all.
    const dda::PerContact<dda::Contact> found{{contact(0, 1, 1, 5), contact(0, 1, 3, 5), contact(0, 1, 3, 6),
                                               contact(1, 2, 9, 6), contact(3, 1, 12, 6)}};
    const auto matched = guess.match(found);
    ASSERT_EQ(matched.size(), 5u);
    EXPECT_EQ(matched[0], nullptr);
    EXPECT_EQ(matched[1], &guess.evaluated[1]);
    EXPECT_EQ(matched[2], nullptr) << "the same corner at another edge";
    EXPECT_EQ(matched[3], &guess.evaluated[2]) << "whichever block has the corner";
    EXPECT_EQ(matched[4], nullptr);
}

TEST(InitialGuess, OfAFirstAttemptIsNone) {
    const dda::PerContact<dda::Contact> found{{contact(0, 1, 1, 5)}};
    EXPECT_EQ(dda::InitialGuess().match(found)[0], nullptr);
}

TEST(Prediction, IsOutrunByTwoVerticesThatApproachByMoreThanItsRadius) {
    dda::Prediction prediction;
    prediction.search_radius = dda::SearchRadius(0.02);
    EXPECT_FALSE(prediction.is_outrun_by(0.01));
    EXPECT_TRUE(prediction.is_outrun_by(0.0101));
    prediction.widen_for(0.0101);
    EXPECT_DOUBLE_EQ(prediction.search_radius.largest(), 2.5 * 0.0101);
    EXPECT_FALSE(prediction.is_outrun_by(0.0101));
}

TEST(Prediction, IsTriedAgainFromWhatWasFound) {
    dda::Prediction prediction;
    prediction.needs_retry = false;
    dda::InitialGuess found;
    found.contacts.push_back(contact(0, 1, 2, 5));
    found.evaluated.emplace_back().normal_force = 7;
    const dda::Vec6 moved = dda::Vec6::Constant(0.25);
    prediction.retry_from({{moved}}, found);
    EXPECT_TRUE(prediction.needs_retry);
    EXPECT_EQ(prediction.predicted[0], moved);
    EXPECT_EQ(prediction.guess.match(found.contacts)[0]->normal_force, 7);
}

}  // namespace
}  // namespace rockslope::prediction_test
