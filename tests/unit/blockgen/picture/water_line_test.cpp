#include "blockgen/picture/water_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blockgen/picture/block_picture.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::water_line_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string svg_of(const std::vector<Point>& line) {
    Canvas canvas(300, 200);
    draw_water_line(canvas, Axes({100, 50}, {300, 150}, {0, 20}, {0, 10}), line);
    return canvas.bytes(PictureFormat::svg);
}

// The box has ten units for 1 m, and y = 10 m at its top.
TEST(WaterLine, IsDashedFromSideToSideWithItsMarkAtTheHigherOne) {
    const std::string right = svg_of({{5, 2}, {15, 6}});
    EXPECT_THAT(right, HasSubstr("stroke-dasharray"));
    EXPECT_THAT(right, HasSubstr("M 100 130 L 150 130 L 250 90 L 300 90 "));
    EXPECT_THAT(right, HasSubstr("M 276 90 L")) << "the tip, at 88 % of the width";
    EXPECT_THAT(svg_of({{5, 6}, {15, 2}}), HasSubstr("M 124 90 L"));
    EXPECT_THAT(svg_of({{5, 4}}), AllOf(HasSubstr("M 100 110 L 300 110 "), HasSubstr("M 124 110 L")));
}

TEST(WaterLine, IsDrawnWithTheSectionThatHasOne) {
    SlopeModel model = rectangle(20, 10);
    EXPECT_THAT(draw_blocks(cut(model).mesh).bytes(PictureFormat::svg),
                AllOf(Not(HasSubstr("water table")), Not(HasSubstr("stroke-dasharray"))));
    model.water_table = {{0, 6}, {20, 4}};
    EXPECT_THAT(draw_blocks(cut(model).mesh).bytes(PictureFormat::svg),
                AllOf(HasSubstr("water table"), HasSubstr("stroke-dasharray")));
}

}  // namespace
}  // namespace rockslope::blockgen::water_line_test
