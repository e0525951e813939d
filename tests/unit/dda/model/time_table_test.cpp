#include "dda/model/time_table.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace rockslope::time_table_test {
namespace {

using dda::TimeTable;

TEST(TimeTable, EmptyIsOne) {
    EXPECT_TRUE(TimeTable().empty());
    for (const double t : {-1e9, 0.0, 1e9}) EXPECT_EQ(TimeTable().at(t), 1);
}

TEST(TimeTable, IsLinearBetweenItsEntriesAndExactAtThem) {
    const TimeTable table({0, 1, 3}, {2, 4, -4});
    EXPECT_EQ(table.at(0), 2);
    EXPECT_EQ(table.at(1), 4);
    EXPECT_EQ(table.at(3), -4);
    EXPECT_DOUBLE_EQ(table.at(.25), 2.5);
    EXPECT_DOUBLE_EQ(table.at(2), 0);
    EXPECT_DOUBLE_EQ(table.at(2.5), -2);
}

TEST(TimeTable, IsConstantOutside) {
    const TimeTable table({0, 1}, {2, 4});
    EXPECT_EQ(table.at(-1), 2);
    EXPECT_EQ(table.at(-std::numeric_limits<double>::infinity()), 2);
    EXPECT_EQ(table.at(1 + 1e-12), 4);
    EXPECT_EQ(table.at(1e300), 4);
}

TEST(TimeTable, OneEntryIsAConstant) {
    const TimeTable table({5}, {7});
    for (const double t : {0.0, 5.0, 10.0}) EXPECT_EQ(table.at(t), 7);
}

TEST(TimeTable, RejectsTimesThatDoNotIncreaseAndMissingValues) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(TimeTable({0, 1}, {1}), std::invalid_argument);
    EXPECT_THROW(TimeTable({0, 0}, {1, 2}), std::invalid_argument);
    EXPECT_THROW(TimeTable({1, 0}, {1, 2}), std::invalid_argument);
    EXPECT_THROW(TimeTable({0, nan}, {1, 2}), std::invalid_argument);
    EXPECT_THROW(TimeTable({nan, 1}, {1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace rockslope::time_table_test
