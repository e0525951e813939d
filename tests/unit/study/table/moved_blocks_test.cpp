#include "study/table/moved_blocks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "support/error_of.hpp"

namespace rockslope::moved_blocks_test {
namespace {

using namespace study;
namespace fs = std::filesystem;

const char* const heading =
    "block,relative displacement x (m),relative displacement y (m),area (m2),leftmost x (m),leftmost y "
    "(m),rightmost x "
    "(m),rightmost y (m),highest x at the start (m),highest y at the start (m)\n";

MovedBlocks moved(const std::string& rows, double limit, const std::string& first = heading) {
    const fs::path file = fs::path(::testing::TempDir()) / ("moved_" + std::to_string(::getpid()));
    std::ofstream(file) << first << rows;
    const MovedBlocks result = moved_blocks(file, limit);
    fs::remove(file);
    return result;
}

TEST(MovedBlocks, MeasuresWhatMovedFartherThanTheLimit) {
    const std::string rows =
        "1,3,-4,10,5,1,8,0.5,2,11\n"
        "2,0.6,-0.8,20,3,2,4,2,1,12\n"
        "3,0,0,30,0,0,99,0,0,50\n";
    const MovedBlocks all = moved(rows, 0.9);
    EXPECT_EQ(all.volume, 30);
    EXPECT_EQ(*all.front, 8);
    EXPECT_EQ(*all.run_out, 8 - 1);
    EXPECT_NEAR(*all.travel_angle, std::atan2(12 - 0.5, 7), 1e-12);
    EXPECT_EQ(moved(rows, 1.1).volume, 10);
    const MovedBlocks none = moved(rows, 9);
    EXPECT_EQ(none.volume, 0);
    EXPECT_FALSE(none.front);
}

TEST(MovedBlocks, MeasuresASlopeThatFacesLeftAsWell) {
    const MovedBlocks left = moved("1,-3,-4,10,-8,0.5,-5,1,-2,11\n", 1);
    EXPECT_EQ(*left.front, -8);
    EXPECT_EQ(*left.run_out, 6);
}

TEST(MovedBlocks, RefusesOtherTables) {
    EXPECT_THAT(error_of([] { moved("1\n", 1, "block\n"); }),
                ::testing::HasSubstr("has no column 'relative displacement x'"));
    EXPECT_THAT(error_of([] { moved("1,x,0,0,0,0,0,0,0,0\n", 1); }),
                ::testing::HasSubstr(":2: 'x' is no number"));
}

}  // namespace
}  // namespace rockslope::moved_blocks_test
