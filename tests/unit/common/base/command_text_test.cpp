#include "common/base/command_text.hpp"

#include <gtest/gtest.h>

namespace rockslope::command_text_test {
namespace {

TEST(CommandText, EscapesPathsForMake) {
    EXPECT_EQ(make_escaped("out/summary.json"), "out/summary.json");
    EXPECT_EQ(make_escaped("my slope/a#1$b"), "my\\ slope/a\\#1$$b");
}

}  // namespace
}  // namespace rockslope::command_text_test
