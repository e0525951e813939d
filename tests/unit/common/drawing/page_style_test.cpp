#include "common/drawing/page_style.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "common/base/input_error.hpp"

namespace rockslope::page_style_test {
namespace {

using testing::HasSubstr;

std::string refusal(const PageRequest& request) {
    try {
        page_style(request, "blockgen");
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing is refused";
}

TEST(PageStyle, TakesLengthsWithTheirUnit) {
    for (const auto& [text, points] : {std::pair("85mm", 240.945), std::pair("8.5cm", 240.945),
                                       std::pair("3in", 216.0), std::pair("240.5pt", 240.5)})
        EXPECT_NEAR(page_style({.width = text}, "").width.value(), points, 1e-3) << text;
    for (const char* text : {"85", "mm", "85 furlongs", "52mm", "1.8m", "-85mm", "nanmm", ""})
        EXPECT_THAT(refusal({.width = text}), HasSubstr("blockgen: --width is '" + std::string(text) + "'"));
    EXPECT_THAT(refusal({.width = "80mm", .font_size = 18.0}), HasSubstr("from 106mm")) << "larger letters";
}

TEST(PageStyle, GivesLargerLettersLessRoom) {
    const PageStyle style = page_style({.width = "240pt", .font_size = 8.0}, "");
    EXPECT_DOUBLE_EQ(style.width_in_units(500), 270);
    EXPECT_DOUBLE_EQ(page_style({.font_size = 18.0}, "").width_in_units(500), 250) << "on the usual page";
    for (const double size : {0.0, -1.0, 73.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THAT(refusal({.font_size = size}), HasSubstr("up to 72 pt"));
}

TEST(PageStyle, NamesTheFontThatWouldBeDrawnForOneThatIsMissing) {
    EXPECT_EQ(page_style({.font = "dejavu serif"}, "").family, "dejavu serif") << "installed, in any case";
    EXPECT_EQ(page_style({.font = "serif"}, "").family, "serif") << "any of its kind";
    EXPECT_THAT(refusal({.font = "Font of Nowhere"}),
                testing::ContainsRegex("'Font of Nowhere', which is not installed; '.+' would be drawn"));
}

}  // namespace
}  // namespace rockslope::page_style_test
