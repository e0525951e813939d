#include "common/drawing/panel_page.hpp"

#include <gtest/gtest.h>

namespace rockslope::panel_page_test {
namespace {

PanelPage page_of(double width, const std::vector<std::string>& names) {
    return {{.title = "Displacement", .panels = 2, .legends = {names}}, {.width = width}};
}

double end_of_panels(const PanelPage& page) {
    return page.axes(0, {0, 1}, {0, 1}).lower_right().x;
}

TEST(PanelPage, PutsLegendsBesideThePanelsOrBelowThem) {
    const std::vector<std::string> names = {"crest", "toe"};
    EXPECT_LT(end_of_panels(page_of(640, names)), 580) << "beside";
    EXPECT_EQ(end_of_panels(page_of(300, names)), 284) << "below, on a narrow page";
    const std::string long_name(80, 'n');
    EXPECT_EQ(end_of_panels(page_of(640, {long_name})), 624) << "below, for a long name";
    EXPECT_EQ(end_of_panels(page_of(640, {})), 624) << "no legend";
}

TEST(PanelPage, StacksItsPanels) {
    const PanelPage page = page_of(640, {"crest"});
    const Axes first = page.axes(0, {0, 1}, {0, 1}), second = page.axes(1, {0, 1}, {0, 1});
    EXPECT_EQ(first.lower_right().y - first.upper_left().y, 150);
    EXPECT_EQ(second.upper_left().y - first.lower_right().y, 22);
    EXPECT_EQ(page.canvas.width(), 640);
    const Axes narrow = page_of(200, {"crest"}).axes(0, {0, 1}, {0, 1});
    EXPECT_EQ(narrow.lower_right().y - narrow.upper_left().y, 0.75 * (200 - 64 - 16)) << "less high";
}

}  // namespace
}  // namespace rockslope::panel_page_test
