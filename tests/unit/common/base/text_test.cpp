#include "common/base/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace rockslope::text_test {
namespace {

TEST(Text, ShortestTextReadsBackToTheSameDouble) {
    const double values[] = {0.0,
                             -0.0,
                             1.0,
                             -1e-12,
                             0.1,
                             1.0 / 3,
                             5e9,
                             1e300,
                             std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::max()};
    for (const double value : values) {
        const auto read = parse_number(shortest_text(value));
        ASSERT_TRUE(read) << value;
        EXPECT_EQ(std::signbit(*read), std::signbit(value));
        EXPECT_EQ(*read, value);
    }
    EXPECT_EQ(shortest_text(0.1), "0.1");
}

TEST(Text, ParsesOnlyCompleteFiniteNumbers) {
    for (const char* good : {"1", "-1", "+1", ".5", "5.", "-.1234E-02", "1e3"})
        EXPECT_TRUE(parse_number(good)) << good;
    for (const char* bad : {"", " 1", "1 ", "1x", "+-1", "++1", "nan", "inf", "-inf", "1e999", "0x10", "1,5"})
        EXPECT_FALSE(parse_number(bad)) << bad;
}

TEST(Text, NearestWordAcceptsTyposOnly) {
    const std::vector<std::string> words = {"friction_angle", "cohesion", "law", "x"};
    EXPECT_EQ(nearest_word("frcition_angle", words), "friction_angle");
    EXPECT_EQ(nearest_word("cohesoin", words), "cohesion");
    EXPECT_EQ(nearest_word("lwa", words), "law");
    EXPECT_FALSE(nearest_word("density", words));
    EXPECT_FALSE(nearest_word("y", words)) << "one letter is not a misspelling of another";
    EXPECT_FALSE(nearest_word("law", {}));
}

TEST(Text, EscapesWhatXmlTakesForItsOwn) {
    EXPECT_EQ(xml_escaped("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; > d");
    EXPECT_EQ(xml_escaped("σxx"), "σxx");
}

}  // namespace
}  // namespace rockslope::text_test
