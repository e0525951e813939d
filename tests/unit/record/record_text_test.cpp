#include "record/record_text.hpp"

#include <gtest/gtest.h>

namespace rockslope::record::record_text_test {
namespace {

TEST(RecordText, WritesAPeerFileInG) {
    const Accelerogram record{0.005, {0, 9.80665, -4.903325, 0, 0.0980665, 0}};
    EXPECT_EQ(at2_text(record, "A title"),
              "SYNTHETIC STRONG MOTION RECORD\n"
              "A title\n"
              "ACCELERATION TIME SERIES IN UNITS OF G\n"
              "NPTS=      6, DT= 0.005000 SEC,\n"
              "  0.0000000E+00  1.0000000E+00 -5.0000000E-01  0.0000000E+00  1.0000000E-02\n"
              "  0.0000000E+00\n");
}

TEST(RecordText, WritesTwoColumnsWithTheirUnits) {
    EXPECT_EQ(csv_text({0.1, {0, 1.25, -0.1}}, "A title"),
              "# A title\ntime (s),acceleration (m/s2)\n0,0\n0.1,1.25\n0.2,-0.1\n");
}

}  // namespace
}  // namespace rockslope::record::record_text_test
