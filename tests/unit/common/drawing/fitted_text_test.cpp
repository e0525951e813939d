#include "common/drawing/fitted_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rockslope::fitted_text_test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Shortened, KeepsWhatFitsAndWholeLetters) {
    const Canvas canvas(100, 100);
    const std::string word = "Überhänge";
    EXPECT_EQ(shortened(canvas, word, {}, canvas.text_width(word)), word);
    EXPECT_EQ(shortened(canvas, word, {}, canvas.text_width("Überhä…")), "Überhä…");
    EXPECT_EQ(shortened(canvas, "crest of it", {}, canvas.text_width("crest …")), "crest…");
    EXPECT_EQ(shortened(canvas, word, {}, 0), "…");
}

TEST(Labels, DoNotLieOverEachOther) {
    Canvas canvas(100, 100);
    Labels labels({0, 0}, {100, 100});
    const TextStyle style{9, black, Anchor::start, Anchor::middle};
    EXPECT_TRUE(labels.try_at(canvas, {10, 50}, "one", style));
    EXPECT_FALSE(labels.try_at(canvas, {14, 52}, "two", style)) << "over the first";
    EXPECT_FALSE(labels.try_at(canvas, {95, 80}, "two", style)) << "out of the box";
    EXPECT_TRUE(labels.try_at(canvas, {10, 70}, "two", style));
    labels.reserve({0, 80}, {100, 100});
    EXPECT_FALSE(labels.try_at(canvas, {10, 90}, "three", style)) << "in the legend";
    TextStyle upright = style;
    upright.angle = M_PI / 2;
    EXPECT_FALSE(labels.try_at(canvas, {15, 60}, "three", upright)) << "up through the first";
    EXPECT_TRUE(labels.try_at(canvas, {60, 60}, "three", upright));
    EXPECT_THAT(canvas.bytes(PictureFormat::svg), Not(HasSubstr("NaN")));
}

TEST(Labels, AreMovedIntoTheBoxWhereNoPlaceIsFree) {
    Canvas canvas(100, 100);
    Labels labels({0, 0}, {60, 100});
    labels.put(canvas, {{{55, 50}, Anchor::start}, {{50, 50}, Anchor::end}}, "crest", {});
    EXPECT_THAT(canvas.bytes(PictureFormat::svg), HasSubstr("text-anchor=\"end\"")) << "the second place";
    Canvas crowded(100, 100);
    Labels others({0, 0}, {60, 100});
    others.put(crowded, {{{55, 50}, Anchor::start}}, "a", {});
    EXPECT_THAT(crowded.bytes(PictureFormat::svg), HasSubstr("translate(54.")) << "5.5 pt wide";
}

}  // namespace
}  // namespace rockslope::fitted_text_test
