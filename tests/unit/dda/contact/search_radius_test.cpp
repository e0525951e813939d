#include "dda/contact/search_radius.hpp"

#include <gtest/gtest.h>

namespace rockslope::search_radius_test {
namespace {

TEST(SearchRadius, IsLimitedAndWidensForAllPairs) {
    dda::SearchRadius radius(.01, .05, .1);
    EXPECT_DOUBLE_EQ(radius.largest(), .1);
    EXPECT_DOUBLE_EQ(radius.of(0), .01);
    EXPECT_DOUBLE_EQ(radius.of(.02), .07);
    EXPECT_DOUBLE_EQ(radius.of(.05), .1);
    radius.widen(.05);
    EXPECT_DOUBLE_EQ(radius.largest(), .1) << "it is as wide already";
    radius.widen(.15);
    EXPECT_DOUBLE_EQ(radius.largest(), .15);
    EXPECT_DOUBLE_EQ(radius.of(0), .06);
}

dda::Contact contact(dda::ContactState state, double gap, double dilation) {
    dda::Contact result;
    result.state = state;
    result.gap = gap;
    result.dilation = dilation;
    return result;
}

// Four times the deepest closed contact, twice the largest dilation, whatever its sign, and what the step
// adds.
TEST(SearchRadius, BeginsBeyondPenetrationsAndDilations) {
    const dda::PerContact<dda::Contact> contacts{{contact(dda::ContactState::locked, -1e-3, 0),
                                                  contact(dda::ContactState::sliding, -2e-3, -3e-3),
                                                  contact(dda::ContactState::open, -9e-3, 1e-3)}};
    const double touching = 4 * 2e-3 + 2 * 3e-3 + 1e-4;
    const dda::ExpectedMotion expected{.motion = .01, .change = 5e-4, .limit = .1, .rounding = 1e-4};
    const dda::SearchRadius radius = initial_search_radius(contacts, expected);
    EXPECT_DOUBLE_EQ(radius.of(0), touching + 5e-4);
    EXPECT_DOUBLE_EQ(radius.largest(), touching + 5e-4 + 3 * .01);
    // A step that moves a corner farther than the limit is rejected, so two corners approach by twice that.
    EXPECT_DOUBLE_EQ(
        initial_search_radius(contacts, {.motion = 7, .change = 5e-4, .limit = .1, .rounding = 1e-4})
            .largest(),
        touching + .2);
}

}  // namespace
}  // namespace rockslope::search_radius_test
