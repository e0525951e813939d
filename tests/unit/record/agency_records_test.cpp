// Records as agencies and programs write them today, with headers of their real length and order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "record/records.hpp"
#include "unit/record/record_error.hpp"
#include "unit/record/small_records.hpp"

namespace rockslope::record::agency_records_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::size_t samples = 1537;  // the last line has one value

/// A decaying sine of a quantity's usual digits.
std::vector<double> history(double amplitude) {
    std::vector<double> values;
    for (std::size_t k = 0; k < samples; ++k) {
        const double time = 0.01 * static_cast<double>(k);
        values.push_back(amplitude * std::exp(-0.3 * time) * std::sin(9 * time));
    }
    return values;
}

/// A channel of a V2 file of 2014: 25 lines of text, 100 integers, 100 reals, three time histories.
std::string csmip_of_2014(int channel, double amplitude) {
    char text[120];
    std::string file = "CORRECTED ACCELEROGRAM   (CSMIP)    CHAN  " + std::to_string(channel) +
                       ": 360 DEG\n"
                       "PROCESSED DATA, FILTERED AND INTEGRATED\n"
                       "EARTHQUAKE OF SUN AUG 24, 2014 03:20 PDT\n"
                       "ORIGIN TIME: 10:20:44.0 UTC (PRELIM.)\n"
                       "TRIGGER TIME: 10:20:46.2 08/24/14 UTC\n"
                       "SOMEWHERE - FIRE STATION NO. 3\n"
                       "SENSOR LOCATION: GROUND FLOOR\n";
    for (int line = 8; line <= 22; ++line) file += "(header line " + std::to_string(line) + ")\n";
    file +=
        "PEAK ACCELERATION =    90.000 CM/SEC/SEC AT   0.170 SEC\n"
        "PEAK VELOCITY     =     9.000 CM/SEC     AT   0.170 SEC\n"
        "PEAK DISPLACEMENT =     0.900 CM         AT   0.170 SEC\n";
    file += small_records::fields(std::vector<int>(100, 0), 16, "%5d") +
            small_records::fields(std::vector<double>(100, 0.0), 8, "%10.3f");
    const struct {
        const char* words;
        double scale;
    } blocks[] = {{"points of accel data equally spaced at  .010 sec, in cm/sec2. (8f10.6)", 1},
                  {"points of veloc data equally spaced at  .010 sec, in cm/sec.  (8f10.6)", 0.1},
                  {"points of displ data equally spaced at  .010 sec, in cm.      (8f10.6)", 0.01}};
    for (const auto& [words, scale] : blocks) {
        std::snprintf(text, sizeof text, "%6zu %s\n", samples, words);
        file += text + small_records::fields(history(amplitude * scale), 8, "%10.6f");
    }
    std::snprintf(text, sizeof text, "/&  ----------  End of data for channel %2d  ----------\n", channel);
    return file + text;
}

std::string with_line_ends(const std::string& text, const std::string& end) {
    std::string result;
    for (const char c : text) result += c == '\n' ? end : std::string(1, c);
    return result;
}

TEST(AgencyRecords, CsmipOf2014StatesItsUnitBehindIn) {
    const std::string file = csmip_of_2014(1, 90) + csmip_of_2014(2, -80);
    for (const char* end : {"\n", "\r\n", "\r\r\n"}) {
        const std::string text = with_line_ends(file, end);
        const Record first = parse_record(text, "r");
        EXPECT_EQ(first.quantity, Quantity::acceleration);
        EXPECT_EQ(first.dt, 0.01);
        ASSERT_EQ(first.values.size(), samples);
        for (const std::size_t k : {std::size_t{0}, std::size_t{17}, samples - 1})
            EXPECT_NEAR(first.values[k], history(0.9)[k], 1e-8) << k;
        RecordDeclaration second{Quantity::velocity};
        second.channel = 2;
        EXPECT_NEAR(parse_record(text, "r", second).values[17], history(-0.08)[17], 1e-8);
        second.quantity = Quantity::displacement;
        EXPECT_NEAR(parse_record(text, "r", second).values[17], history(-0.008)[17], 1e-8);
    }
}

TEST(AgencyRecords, CsmipWithoutAUnitAsksForIt) {
    std::string text = csmip_of_2014(1, 90);
    text.replace(text.find(", in cm/sec2."), 13, "");
    EXPECT_THAT(error_in(text),
                AllOf(StartsWith("r:46: "), HasSubstr("the unit of the values is not given")));
    EXPECT_NEAR(parse_record(text, "r", {Quantity::acceleration, "cm/s2"}).values[17], history(0.9)[17],
                1e-8);
}

/// The layout of the El Centro record that comes with OpenSees: text, a unit in brackets, NPTS and DT.
std::string el_centro(const std::string& unit_line, const std::string& more = {}) {
    char count[64];
    std::snprintf(count, sizeof count, "NPTS=  %zu, DT= .02000 SEC\n", samples);
    return "Data for a place in 1940 North South Component\n" + std::to_string(samples) +
           " points at equal spacing of 0.02 sec Points are listed in the format of 8F10.5, i.e., 8 points "
           "across "
           "in a row with 5 decimal places\n" +
           unit_line + more + count + small_records::fields(history(0.3), 8, "%10.5f");
}

TEST(AgencyRecords, ElCentroOfOpenSees) {
    for (const char* more : {"", "*** Begin data ***\n", "a line\nand another one\n"}) {
        const Record record = parse_record(el_centro("The units are (g)\n", more), "r");
        EXPECT_EQ(record.quantity, Quantity::acceleration);
        EXPECT_EQ(record.dt, 0.02);
        ASSERT_EQ(record.values.size(), samples);
        EXPECT_NEAR(record.values[17], 9.80665 * history(0.3)[17], 1e-4);  // five decimals of g
    }
    const Record slow = parse_record(el_centro("Velocity, units of CM/SEC\n"), "r", {Quantity::velocity});
    EXPECT_NEAR(slow.values[17], 0.01 * history(0.3)[17], 1e-7);
    EXPECT_THAT(error_in(el_centro("Units unknown\n")), HasSubstr("the quantity of the values is not given"));
    EXPECT_NEAR(parse_record(el_centro("Units unknown\n"), "r", {Quantity::acceleration, "g"}).values[17],
                9.80665 * history(0.3)[17], 1e-4);
    std::string longer = el_centro("The units are (g)\n") + "   0.00001\n";
    EXPECT_THAT(error_in(longer), HasSubstr("more values than the header says"));
}

/// A raw record of COSMOS: its samples are announced in other words than those of a corrected one.
TEST(AgencyRecords, RawCosmosIsRefusedBecauseItIsRaw) {
    std::string file = "Raw acceleration counts   (Format v01.20 with 13 text lines)\n";
    for (int line = 2; line <= 13; ++line) file += "(text line " + std::to_string(line) + ")\n";
    std::vector<int> integers(100, -999);
    integers[0] = 0;
    integers[1] = 1;
    file += " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" +
            small_records::fields(integers, 10, "%8d") +
            " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n" +
            small_records::fields(std::vector<double>(100, -999), 6, "%13.6f") +
            "   1 Comment line(s) follow, each starting with a \"|\":\n| a comment\n"
            "    1537 raw accel.    pts, approx   15 secs, units=counts (50),Format=(10I8)\n" +
            small_records::fields(std::vector<int>(samples, 12), 10, "%8d") + "End-of-data for Chan  1\n";
    EXPECT_THAT(error_in(file), AllOf(StartsWith("r:14: the record is raw: counts"), HasSubstr("V1 or V2")));
}

}  // namespace
}  // namespace rockslope::record::agency_records_test
