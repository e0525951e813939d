#include "common/drawing/canvas.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/base/input_error.hpp"
#include "common/drawing/axes.hpp"

namespace rockslope::canvas_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Canvas drawing() {
    Canvas canvas(300, 200);
    const Axes axes = Axes::of_equal_scale({50, 20}, {280, 160}, {0, 10}, {0, 5});
    const Ring square = {{1, 1}, {4, 1}, {4, 4}, {1, 4}};
    const Ring hole = {{2, 2}, {2, 3}, {3, 3}, {3, 2}};
    const std::vector<Ring> rings = {axes.to_page(square), axes.to_page(hole)};
    canvas.polygon(rings, rock_colour(0), Stroke{});
    canvas.hatch(rings, {grey, 0.5}, 4, 0.8);
    canvas.polyline(std::vector<Point>{axes.to_page({5, 1}), axes.to_page({8, 3})}, {line_colour(1), 1});
    canvas.text(axes.to_page({6, 4}), "Überhang", {9, black, Anchor::middle});
    axes.draw(canvas, "x (m)", "y (m)", true);
    draw_scale_bar(canvas, {60, 190}, axes.scale(), 80);
    draw_legend(canvas, {200, 20}, "Joints", {{"bedding", {}, Stroke{line_colour(0)}, true}});
    return canvas;
}

TEST(Canvas, WritesEachFormatReproducibly) {
    for (const auto& [format, start] :
         {std::pair(PictureFormat::svg, "<?xml"), std::pair(PictureFormat::png, "\x89PNG"),
          std::pair(PictureFormat::pdf, "%PDF")}) {
        const std::string bytes = drawing().bytes(format);
        EXPECT_THAT(bytes, StartsWith(start));
        EXPECT_GT(bytes.size(), 1000u);
        EXPECT_EQ(bytes, drawing().bytes(format));
    }
}

TEST(Canvas, KeepsTextAsTextInSvg) {
    Canvas canvas(100, 50, {.family = "Liberation Serif", .unit = 2});
    canvas.text({10, 20}, "a < b & c", {8, black, Anchor::end, Anchor::start, true, 0.5 * M_PI, white});
    const std::string svg = canvas.bytes(PictureFormat::svg);
    EXPECT_THAT(svg, HasSubstr(">a &lt; b &amp; c</text>"));
    EXPECT_THAT(svg, HasSubstr("font-family=\"Liberation Serif, sans-serif\""));
    EXPECT_THAT(svg, HasSubstr("font-size=\"16.00\" text-anchor=\"end\""));
    EXPECT_THAT(svg, HasSubstr("translate(20.00 40.00) rotate(-90.00)"));
    EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
}

TEST(Canvas, IsDrawnInUnitsOfItsStyle) {
    Canvas canvas(20, 10, {.unit = 1.5});
    EXPECT_EQ(canvas.width(), 30) << "pt";
    EXPECT_EQ(canvas.text_width("joint"), Canvas(1, 1).text_width("joint")) << "units";
    const Ring left_half = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    canvas.polygon(std::span(&left_half, 1), Colour{1, 0, 0}, std::nullopt);
    const Pixels image = canvas.pixels(1);
    ASSERT_EQ(image.width, 30);
    EXPECT_EQ(image.bytes.substr(4 * 14, 3), std::string("\0\0\xff", 3)) << "red up to the middle";
    EXPECT_EQ(image.bytes.substr(4 * 16, 3), "\xff\xff\xff");
}

TEST(Canvas, GivesPixelsOfEvenSize) {
    Canvas canvas(10.4, 5);
    const Ring left_half = {{0, 0}, {5, 0}, {5, 5}, {0, 5}};
    canvas.polygon(std::span(&left_half, 1), Colour{1, 0, 0}, std::nullopt);
    const Pixels image = canvas.pixels(1);
    EXPECT_EQ(image.width, 12);
    EXPECT_EQ(image.height, 6);
    ASSERT_EQ(image.bytes.size(), 4U * 12 * 6);
    EXPECT_EQ(image.bytes.substr(0, 3), std::string("\0\0\xff", 3)) << "red at the left";
    EXPECT_EQ(image.bytes.substr(4 * 11, 3), "\xff\xff\xff") << "white at the right";
}

TEST(Canvas, ChoosesTheFormatByExtension) {
    EXPECT_EQ(picture_format("a/b.PNG"), PictureFormat::png);
    EXPECT_EQ(picture_format("b.svg"), PictureFormat::svg);
    EXPECT_EQ(picture_format("b.pdf"), PictureFormat::pdf);
    EXPECT_EQ(picture_format("b.jpg"), std::nullopt);
    EXPECT_THROW(Canvas(10, 10).write("b.jpg"), InputError);
}

TEST(Axes, KeepOneScaleAndTheModelInTheBox) {
    const Axes axes = Axes::of_equal_scale({0, 0}, {200, 300}, {0, 100}, {0, 50});
    EXPECT_DOUBLE_EQ(axes.scale(), 2);
    EXPECT_EQ(axes.to_page({0, 50}), (Point{0, 100}));
    EXPECT_EQ(axes.to_page({100, 0}), (Point{200, 200}));
}

TEST(Axes, TicksAreRound) {
    EXPECT_THAT(round_ticks({0, 1}, 5),
                ElementsAre(0, 0.2, testing::DoubleEq(0.4), testing::DoubleEq(0.6), 0.8, 1));
    EXPECT_THAT(round_ticks({-30, 120}, 4), ElementsAre(0, 50, 100));
    EXPECT_THAT(round_ticks({1, 1}, 4), ElementsAre());
    EXPECT_EQ(tick_text(0.25, 0.05), "0.25");
    EXPECT_EQ(tick_text(-20, 10), "\u221220");
    EXPECT_EQ(tick_text(466000, 20), "466000");
}

TEST(Axes, LabelsFarFromTheOriginStayShortAndDistinct) {
    const TickLabels near = tick_labels({0, 140}, 3);
    EXPECT_EQ(near.offset, 0);
    EXPECT_THAT(near.texts, ElementsAre("0", "50", "100"));
    EXPECT_EQ(near.title("x (m)"), "x (m)");

    const TickLabels map = tick_labels({6690000, 6690040}, 5);
    EXPECT_THAT(map.texts, ElementsAre("6690000", "6690010", "6690020", "6690030", "6690040"));

    const TickLabels fine = tick_labels({6690012.3, 6690013.9}, 4);
    EXPECT_EQ(fine.offset, 6690010);
    EXPECT_THAT(fine.texts, ElementsAre("2.5", "3.0", "3.5"));
    EXPECT_EQ(fine.title("y (m)"), "y \u2212 6690010 (m)");

    const TickLabels south = tick_labels({-3e9 - 25, -3e9 + 25}, 5);
    EXPECT_EQ(south.offset, -3000000100);
    EXPECT_THAT(south.texts, ElementsAre("80", "90", "100", "110", "120"));
    EXPECT_EQ(south.title("y (m)"), "y + 3000000100 (m)");

    const TickLabels wide = tick_labels({-2e9, 6e9}, 4);
    EXPECT_EQ(wide.offset, 0) << "a range that contains zero has no common offset";
}

TEST(Colour, ShadesOfNeighboursDiffer) {
    for (std::size_t i = 0; i < shade_count; ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(shaded(rock_colour(0), i), shaded(rock_colour(0), j));
}

}  // namespace
}  // namespace rockslope::canvas_test
