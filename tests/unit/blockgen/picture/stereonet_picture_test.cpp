#include "blockgen/picture/stereonet_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace rockslope::blockgen::stereonet_picture_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double degree = std::numbers::pi / 180;

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

Stereonet net() {
    Stereonet net;
    net.section_azimuth = 359.7 * degree;
    net.sets.push_back({"bedding", {{60 * degree, 120 * degree}}, {60 * degree, 120 * degree}, {}});
    net.sets.push_back({"J1",
                        {{80 * degree, 7 * degree}, {84 * degree, 9 * degree}},
                        {4.6 * degree, 359.8 * degree},
                        214.4});
    net.without_planes = {"fault", "dike"};
    return net;
}

TEST(Stereonet, SaysWhatItDraws) {
    const std::string picture = draw_stereonet(net()).bytes(PictureFormat::svg);
    EXPECT_EQ(picture, draw_stereonet(net()).bytes(PictureFormat::svg));
    for (const char* text :
         {"60/120, n 1  bedding<", "05/000, n 2, K 214  J1<", "section, x towards 000\u00b0", "x 000\u00b0",
          "not drawn: fault, dike", ">N<", ">E<"})
        EXPECT_THAT(picture, HasSubstr(text));
    Stereonet known = net();
    known.without_planes.clear();
    EXPECT_THAT(draw_stereonet(known).bytes(PictureFormat::svg), Not(HasSubstr("not drawn")));
}

TEST(Stereonet, SaysWhatItsContoursAre) {
    Stereonet dense = net();
    dense.sets[0].planes.resize(60, dense.sets[0].planes[0]);
    // 60 of 62 poles in one direction: 60 / 62 of the kernel's largest value, 2 (1 + 62 / 9).
    EXPECT_THAT(draw_stereonet(dense).bytes(PictureFormat::svg),
                AllOf(HasSubstr(">contours 2, 4, 6, 8, 10, 12, 14<"),
                      HasSubstr(">% of poles per 1 % of area, max. 15.3<"),
                      HasSubstr(">exponential Kamb, uniform 1 \u00b1 0.33<")));
    EXPECT_THAT(draw_stereonet(net()).bytes(PictureFormat::svg), HasSubstr(">no contours<"));
    Stereonet empty = net();
    empty.sets.clear();
    EXPECT_THAT(draw_stereonet(empty).bytes(PictureFormat::svg), Not(HasSubstr("contours")));
}

TEST(Stereonet, SaysThatPlanesAreParallel) {
    Stereonet one = net();
    one.sets[0].planes.resize(3, one.sets[0].planes[0]);
    EXPECT_THAT(draw_stereonet(one).bytes(PictureFormat::svg), HasSubstr("n 3, all parallel  bedding"));
}

TEST(Stereonet, DrawsPolesThatCoverEachOtherOnce) {
    Stereonet many = net();
    const std::string few = draw_stereonet(many).bytes(PictureFormat::svg);
    many.sets[0].planes.resize(10'000, many.sets[0].planes[0]);
    const std::string picture = draw_stereonet(many).bytes(PictureFormat::svg);
    const auto poles = [](const std::string& text) { return count_of(text, "stroke-width:0.3;"); };
    EXPECT_EQ(poles(few), 3u);
    EXPECT_EQ(poles(picture), 3u);
    many.sets[0].planes.back() = {10 * degree, 300 * degree};
    EXPECT_EQ(poles(draw_stereonet(many).bytes(PictureFormat::svg)), 4u);
}

}  // namespace
}  // namespace rockslope::blockgen::stereonet_picture_test
