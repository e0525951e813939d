#include "record/records.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "record_error.hpp"

namespace rockslope::record::records_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double g = 9.80665;

std::string peer(const std::string& kind, const std::string& sampling, const std::string& values) {
    return "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/1/2000, A\n" + kind + "\n" + sampling +
           "\n" + values;
}

const std::string in_g = "ACCELERATION TIME SERIES IN UNITS OF G";

TEST(Records, PeerHeadersInAllThreeSpellings) {
    for (const char* sampling :
         {"NPTS=   3, DT=   .0050 SEC,      ", "NPTS=  3, DT= .00500 SEC", "3    0.0050    NPTS, DT"}) {
        const Record record = parse_record(peer(in_g, sampling, "  .1000000E-02  -.2E+00\r\n 1.5\n"), "r");
        EXPECT_EQ(record.dt, 0.005) << sampling;
        EXPECT_EQ(record.quantity, Quantity::acceleration);
        ASSERT_EQ(record.values.size(), 3u);
        EXPECT_DOUBLE_EQ(record.values[0], 1e-3 * g);
        EXPECT_DOUBLE_EQ(record.values[1], -0.2 * g);
        EXPECT_DOUBLE_EQ(record.values[2], 1.5 * g);
    }
}

TEST(Records, ReadsFortranNumbers) {
    const Record record = parse_record(peer(in_g, "NPTS= 3, DT= .01 SEC", "-.2D-01 +.5d+00 1.D0"), "r");
    EXPECT_DOUBLE_EQ(record.values[0], -0.02 * g);
    EXPECT_DOUBLE_EQ(record.values[1], 0.5 * g);
    EXPECT_DOUBLE_EQ(record.values[2], g);
    const Record columns = parse_record("time (s),acceleration (m/s2)\n0,1D-1\n1D0,-2.5d0\n", "r");
    EXPECT_DOUBLE_EQ(columns.values[1], -2.5);
    for (const char* bad : {"D", "1D", "1D2D3", "1DE2", "+-1", "0x1D"})
        EXPECT_THAT(error_in(peer(in_g, "NPTS= 2, DT= .01 SEC", std::string("1 ") + bad)),
                    HasSubstr("not a finite number"))
            << bad;
}

TEST(Records, PeerVelocityAndDisplacement) {
    const std::string sampling = "NPTS= 2, DT= .01 SEC";
    const Record v = parse_record(peer("VELOCITY TIME SERIES IN UNITS OF CM/S", sampling, "1 2"), "r");
    EXPECT_EQ(v.quantity, Quantity::velocity);
    EXPECT_DOUBLE_EQ(v.values[1], 0.02);
    const Record d = parse_record(
        peer("DISPLACEMENT TIME HISTORY IN UNITS OF CM. FILTER POINTS: HP=0.2 Hz", sampling, "1 2"), "r");
    EXPECT_EQ(d.quantity, Quantity::displacement);
    EXPECT_DOUBLE_EQ(d.values[1], 0.02);
}

TEST(Records, PeerErrorsNameTheLine) {
    const std::string three = "NPTS= 3, DT= .01 SEC";
    EXPECT_EQ(error_in(peer(in_g, three, "1 2\n")),
              "r:5: the record ends after 2 values; expected NPTS = 3 values");
    EXPECT_EQ(error_in(peer(in_g, three, "1 2 3\n4\n")),
              "r:6: there are more values than the header says; expected NPTS = 3 values");
    EXPECT_EQ(error_in(peer(in_g, three, "1 x 3\n")),
              "r:5: 'x' is not a finite number; expected value 2 of NPTS = 3");
    EXPECT_EQ(error_in(peer(in_g, three, "1 nan 3\n")),
              "r:5: 'nan' is not a finite number; expected value 2 of NPTS = 3");
    EXPECT_EQ(error_in(peer(in_g, three, "1 2 3\nend of record\n")), "no error")
        << "text after the last value is ignored";
    EXPECT_THAT(error_in(peer(in_g, "NPTS= many, DT= .01", "1")),
                StartsWith("r:4: the number of points and the time step are missing"));
    EXPECT_THAT(error_in(peer(in_g, "NPTS= 3, DT= 0.0 SEC", "1 2 3")), StartsWith("r:4: the time step is 0"));
    EXPECT_THAT(error_in(peer(in_g, "NPTS= 1, DT= 0.1 SEC", "1")), StartsWith("r:4: NPTS is 1"));
    EXPECT_THAT(error_in(peer("ACCELERATION IN UNITS OF FURLONGS", three, "1 2 3")),
                HasSubstr("'FURLONGS' is not known"));
    EXPECT_THAT(error_in(peer(in_g, three, "1 2 3"), {Quantity::velocity, ""}),
                HasSubstr("the file holds acceleration; expected velocity"));
    EXPECT_THAT(error_in(peer(in_g, three, "1 2 3"), {std::nullopt, "m/s2"}),
                HasSubstr("the file's unit is G; expected m/s2"));
}

TEST(Records, TwoColumnsWithEverySeparator) {
    for (const char* text :
         {"0,1\n0.1,2\n0.2,3\n", "# c\n0 1\n\n0.1\t2\n 0.2  3", "time;acc\r\n0;1\r\n0.1;2\r\n0.2;3\r\n",
          "\xEF\xBB\xBF"
          "0,1\n.1,2\n.2,3"}) {
        const Record record = parse_record(text, "r", {Quantity::acceleration, "cm/s2"});
        EXPECT_DOUBLE_EQ(record.dt, 0.1) << text;
        ASSERT_EQ(record.values.size(), 3u) << text;
        EXPECT_DOUBLE_EQ(record.values[2], 0.03) << text;
    }
}

TEST(Records, AHeadingDeclaresQuantityAndUnit) {
    const Record record = parse_record("time (s), velocity (cm/s)\n0,1\n1,2\n", "r");
    EXPECT_EQ(record.quantity, Quantity::velocity);
    EXPECT_DOUBLE_EQ(record.values[1], 0.02);
}

TEST(Records, TwoColumnErrorsNameTheLine) {
    const RecordDeclaration acceleration{Quantity::acceleration, "g"};
    EXPECT_EQ(error_in("0,1\n0.1,2\n0.25,3\n0.3,4\n", acceleration).substr(0, 32),
              "r:3: the time step is uneven: 0.");
    EXPECT_EQ(error_in("0,1\n0.1,2\n0.1,3\n", acceleration),
              "r:3: the time does not increase; expected a time later than 0.1 s");
    EXPECT_EQ(error_in("0,1\n0.1,inf\n", acceleration),
              "r:2: '0.1,inf' is not a sample; expected two finite numbers, time and value");
    EXPECT_EQ(error_in("0,1\n0.1,2,3\n", acceleration),
              "r:2: '0.1,2,3' is not a sample; expected two finite numbers, time and value");
    EXPECT_THAT(error_in("0,1\n", acceleration), HasSubstr("fewer than two samples"));
    EXPECT_THAT(error_in("0,1\n0.1,2\n"), HasSubstr("the quantity of the values is not given"));
    EXPECT_THAT(error_in("0,1\n0.1,2\n", {Quantity::velocity, ""}),
                HasSubstr("the unit of the values is not given"));
    EXPECT_THAT(error_in("0,1\n0.1,2\n", {Quantity::velocity, "g"}),
                HasSubstr("the unit 'g' is not known; expected a unit of velocity"));
}

// If an invalid first sample were taken as a heading it would be lost.
TEST(Records, AnInvalidFirstSampleIsNotAHeading) {
    const RecordDeclaration acceleration{Quantity::acceleration, "g"};
    for (const char* first : {"0,nan", "0,1e999", "0,1,2", "nan,0", "1e999,0", "0", "0,x"})
        EXPECT_EQ(
            error_in(std::string(first) + "\n0.1,2\n0.2,3\n", acceleration),
            "r:1: '" + std::string(first) + "' is not a sample; expected two finite numbers, time and value");
}

TEST(Records, RejectsValuesAndTimesOutOfRange) {
    const RecordDeclaration acceleration{Quantity::acceleration, "g"};
    EXPECT_THAT(error_in("0,1e30\n0.1,2\n", acceleration), HasSubstr("too large"));
    EXPECT_THAT(error_in("0,1\n1e31,2\n", acceleration), StartsWith("r:2: '1e31,2' is not a sample"));
    EXPECT_THAT(error_in("0,1\n1e-300,2\n2e-300,3\n", acceleration), HasSubstr("steps of 1e-300 s"));
    EXPECT_THAT(error_in("0,1\n1e300,2\n", acceleration), StartsWith("r:2:"));
    EXPECT_THAT(error_in(peer(in_g, "NPTS= 3, DT= 1e-308 SEC", "1 2 3")),
                StartsWith("r:4: 3 samples at steps of"));
    EXPECT_THAT(error_in(peer(in_g, "NPTS= 3, DT= 1e30 SEC", "1 2 3")),
                StartsWith("r:4: 3 samples at steps of"));
    EXPECT_THAT(error_in(peer(in_g, "NPTS= 3, DT= 1 SEC", "1 2 1e308")), HasSubstr("too large"));
}

TEST(Records, AcceptsTimesRoundedToFewDigits) {
    std::string text;
    for (int i = 0; i < 1000; ++i) {
        char line[64];
        std::snprintf(line, sizeof line, "%.4f,%d\n", i * 0.0050, i % 7);
        text += line;
    }
    EXPECT_DOUBLE_EQ(parse_record(text, "r", {Quantity::acceleration, "g"}).dt, 0.005);
}

TEST(Records, RejectsUnknownContent) {
    for (const char* text : {"", "\n", "# only a comment\n", "hello\nworld\n", "{\"a\": 1}"})
        EXPECT_THAT(error_in(text), HasSubstr("no known record format")) << text;
    EXPECT_THAT(error_in(std::string("000001D \0\0", 10)), HasSubstr("binary file"));
    EXPECT_THAT(error_in(std::string("\x1f\x8b\x08\0\0", 5)), HasSubstr("expected the file that gunzip"));
    EXPECT_THAT(error_in(std::string("PK\x03\x04\0", 5)), HasSubstr("is compressed"));
}

TEST(Records, RejectsMiniSeedWithAdvice) {
    std::string header = "000001D ABCD 00HNENZ";
    header.resize(512);
    EXPECT_THAT(error_in(header), StartsWith("r: is miniSEED: raw counts"));
    EXPECT_THAT(error_in(header), HasSubstr("write two columns"));
    header.replace(0, 8, std::string("MS\x03\0\0\0\0\0", 8));
    EXPECT_THAT(error_in(header), StartsWith("r: is miniSEED: raw counts"));
}

TEST(Records, UsesTheDeclaredFormat) {
    const std::string text = peer(in_g, "NPTS= 2, DT= .01 SEC", "1 2\n");
    RecordDeclaration declaration;
    declaration.format = "peer";
    EXPECT_EQ(parse_record(text, "r", declaration).values.size(), 2u);
    declaration.format = "knet";
    EXPECT_EQ(error_in(text, declaration),
              "r:1: the header has no 'Sampling Freq'; expected a K-NET header of 17 lines");
    declaration.format = "at3";
    EXPECT_THAT(error_in(text, declaration),
                StartsWith("r: the format 'at3' is not known; expected peer, knet"));
    // Rows of numbers from the first line on are two columns of samples.
    declaration = {Quantity::acceleration, "g", "csv"};
    EXPECT_EQ(parse_record("0 1\n1 2\n", "r", declaration).values.size(), 2u);
}

TEST(Records, RejectsASecondChannelOfASingleChannelFormat) {
    RecordDeclaration declaration;
    declaration.channel = 2;
    EXPECT_THAT(error_in(peer(in_g, "NPTS= 2, DT= .01 SEC", "1 2\n"), declaration),
                StartsWith("r: there is no channel 2: a PEER (AT2, VT2, DT2) file holds one"));
}

}  // namespace
}  // namespace rockslope::record::records_test
