// The history of a run as a record: the motion of a point in the last stage.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "record/records.hpp"
#include "record_error.hpp"

namespace rockslope::record::run_history_test {
namespace {

using ::testing::HasSubstr;

const std::string heading =
    "time (s),stage,\"crest, left ux (m)\",\"crest, left vx (m/s)\",\"crest, left ax (m/s2)\",prescribed "
    "base ux "
    "(m),prescribed base vx (m/s),prescribed base ax (m/s2)\n";
const std::string text = heading +
                         "0,settle,9,9,9,9,9,9\n0.3,settle,9,9,9,9,9,9\n"
                         "0.3,shake,0,0,1,0,0,10\n0.4,shake,0,0.5,2,0,7,20\n0.52,shake,0,1,3.2,0,8,32\n"
                         "0.6,shake,0,0,4,0,9,40\n";

RecordDeclaration declared(const std::string& point, std::optional<Quantity> quantity = {}) {
    RecordDeclaration declaration;
    declaration.point = point;
    declaration.quantity = quantity;
    return declaration;
}

// One row is late by 0.02 s, so its value is interpolated.
TEST(RunHistory, IsTheMotionOfAPointInTheLastStage) {
    const Record record = parse_record(text, "history.csv", declared("crest, left x"));
    EXPECT_EQ(record.quantity, Quantity::acceleration);
    EXPECT_NEAR(record.dt, 0.1, 1e-12);
    ASSERT_EQ(record.values.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(record.values[k], 1 + static_cast<double>(k), 1e-12);
    EXPECT_EQ(parse_record(text, "history.csv", declared("base x")).values.back(), 40);
    EXPECT_EQ(parse_record(text, "history.csv", declared("prescribed base x")).values.back(), 40);
    const Record velocity = parse_record(text, "history.csv", declared("base x", Quantity::velocity));
    EXPECT_EQ(velocity.quantity, Quantity::velocity);
    EXPECT_NEAR(velocity.values[1], 7, 1e-12);
}

TEST(RunHistory, RejectsUnknownPointsAndInvalidRows) {
    EXPECT_THAT(error_in(text), HasSubstr("r:1: no point is given; expected "
                                          "point = one of 'crest, left x', 'prescribed base x'"));
    EXPECT_THAT(error_in(text, declared("toe x")), HasSubstr("there is no point 'toe x'"));
    EXPECT_THAT(error_in(text, declared("base y")), HasSubstr("there is no point 'base y'"));
    EXPECT_THAT(error_in(text + "0.7,shake,1\n", declared("base x")), HasSubstr("r:8: has 3 fields"));
    EXPECT_THAT(error_in(text + "0.7,shake,1,1,1,1,1,nan\n", declared("base x")),
                HasSubstr("'nan' is not a finite number"));
    EXPECT_THAT(error_in(text + "0.6,shake,1,1,1,1,1,1\n", declared("base x")),
                HasSubstr("does not increase"));
    EXPECT_THAT(error_in(heading, declared("base x")), HasSubstr("fewer than two rows"));
    EXPECT_THAT(error_in("0,1\n1,2\n2,3\n", declared("base x")), HasSubstr("file holds no points"));
}

}  // namespace
}  // namespace rockslope::record::run_history_test
