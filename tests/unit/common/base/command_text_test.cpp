#include "common/base/command_text.hpp"

#include <gtest/gtest.h>

namespace rockslope::command_text_test {
namespace {

TEST(CommandText, EscapesPathsForMake) {
    EXPECT_EQ(make_escaped("out/summary.json"), "out/summary.json");
    EXPECT_EQ(make_escaped("my slope/a#1$b"), "my\\ slope/a\\#1$$b");
}

TEST(CommandText, QuotesWordsForTheShell) {
    EXPECT_EQ(shell_quoted("stage/a.b=1,2:3"), "stage/a.b=1,2:3");
    EXPECT_EQ(shell_quoted(""), "''");
    EXPECT_EQ(shell_quoted("stage[1].step=1"), "'stage[1].step=1'");
    EXPECT_EQ(shell_quoted("it's $1"), "'it'\\''s $1'");
}

TEST(CommandText, DoublesDollarSignsInRecipes) {
    EXPECT_EQ(recipe_text("echo '$x'"), "echo '$$x'");
}

}  // namespace
}  // namespace rockslope::command_text_test
