#include "dda/solve/methods/balance_progress.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace rockslope::balance_progress_test {
namespace {

/// Whether progress has stalled after each of the unbalanced forces, N per metre: one character for each.
std::string stalls(std::initializer_list<double> forces) {
    dda::BalanceProgress progress;
    std::string told;
    for (const double force : forces) {
        progress.note(force);
        told += progress.has_stalled() ? 's' : '.';
    }
    return told;
}

TEST(BalanceProgress, GoesOnWhileTheForceHalves) {
    EXPECT_EQ(stalls({1000, 500, 250, 125, 1}), ".....");
    EXPECT_EQ(stalls({1000, 900, 400, 390, 150}), ".....") << "one iteration without progress is none";
}

// The forces of rough joints whose patches returned to the same state for nine iterations.
TEST(BalanceProgress, StallsWhereAForceComesBack) {
    EXPECT_EQ(stalls({1.4e5, 2.3e4, 63.7, 36.1, 36.1, 36.1, 36.1}), "....sss");
    EXPECT_EQ(stalls({76.5, 45.7, 42.1, 76.6, 76.5}), "..sss") << "in turns of three";
}

TEST(BalanceProgress, RestartsAfterAWidePatch) {
    dda::BalanceProgress progress;
    for (int k = 0; k < 5; ++k) progress.note(36.1);
    EXPECT_TRUE(progress.has_stalled());
    progress.restart();
    for (const double force : {50.0, 40.0}) {
        progress.note(force);
        EXPECT_FALSE(progress.has_stalled());
    }
    progress.note(30);
    EXPECT_TRUE(progress.has_stalled());
}

}  // namespace
}  // namespace rockslope::balance_progress_test
