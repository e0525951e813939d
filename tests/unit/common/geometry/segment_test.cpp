#include "common/geometry/segment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/point_text.hpp"

namespace rockslope::segment_test {
namespace {

TEST(Segment, IsAsFarAsItsLineBetweenItsEndsAndAsItsNearestEndBeyond) {
    const Point a{1, 2}, b{4, 6};  // 5 m long
    EXPECT_DOUBLE_EQ(distance_to_segment({1 - 4 + 1.5, 2 + 3 + 2}, a, b), 5) << "beside the middle";
    EXPECT_DOUBLE_EQ(distance_to_segment({4 + 3, 6 + 4}, a, b), 5) << "beyond an end, along the line";
    EXPECT_DOUBLE_EQ(distance_to_segment({1, 0}, a, b), 2) << "behind the other end";
    EXPECT_EQ(distance_to_segment(a, a, b), 0);
    EXPECT_DOUBLE_EQ(distance_to_segment({4, 6}, a, a), 5) << "a segment of no length";
}

TEST(Segment, IsAsFarFromItsOtherEndFirst) {
    constexpr double rounding = 1e-15;  // of lengths of up to 4 m
    for (int k = 0; k < 8; ++k) {
        const Point p{3 * std::cos(k), 2 * std::sin(k)};
        EXPECT_NEAR(distance_to_segment(p, {-1, 0.5}, {2, 1}), distance_to_segment(p, {2, 1}, {-1, 0.5}),
                    rounding);
    }
}

TEST(PointText, HasTheFewestDigits) {
    EXPECT_EQ(text_of({0.1, -2}), "(0.1, -2)");
}

}  // namespace
}  // namespace rockslope::segment_test
