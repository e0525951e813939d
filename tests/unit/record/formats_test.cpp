// Every format: the values are in SI units, and a truncated file is rejected with the location.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string_view>

#include "record/record_format.hpp"
#include "record_error.hpp"
#include "small_records.hpp"
#include "support/replaced.hpp"

namespace rockslope::record::formats_test {
namespace {

using small_records::ten;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The SAC format needs a declaration of quantity and unit; the others state them.
RecordDeclaration declaration_for(const std::string& format) {
    RecordDeclaration declaration;
    if (format == "sac") declaration = {Quantity::acceleration, "cm/s2"};
    return declaration;
}

// A new format has a specimen here, or a test file of its own.
TEST(RecordFormats, EachHasASpecimen) {
    std::set<std::string> without;
    for (const RecordFormat* format : record_formats()) without.insert(format->key);
    for (const auto& [key, text] : small_records::all()) EXPECT_EQ(without.erase(key), 1u) << key;
    EXPECT_THAT(without, testing::ElementsAre("miniseed", "run"));
}

// A title that begins with a number also looks like a sample, so two columns are tried last.
TEST(RecordFormats, EachIsRecognisedFirst) {
    for (const auto& [key, text] : small_records::all()) {
        const RecordLines lines(text, "r");
        const auto formats = record_formats();
        const auto first = std::find_if(formats.begin(), formats.end(), [&](const RecordFormat* format) {
            return format->recognises(lines);
        });
        ASSERT_NE(first, formats.end()) << key;
        EXPECT_STREQ((*first)->key, key);
    }
}

TEST(RecordFormats, ConvertValuesToSi) {
    for (const auto& [key, text] : small_records::all()) {
        if (key == std::string("knet")) continue;
        const double unit = key == std::string("peer") ? 9.80665 : key == std::string("geonet") ? 1e-3 : 1e-2;
        for (const std::string& form : {text, key == std::string("sac") ? text : [&text = text] {
                                            std::string dos;
                                            for (const char c : text)
                                                dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
                                            return dos;
                                        }()}) {
            const Record record = parse_record(form, "r", declaration_for(key));
            EXPECT_DOUBLE_EQ(record.dt, 0.02) << key;
            ASSERT_EQ(record.values.size(), ten.size()) << key;
            for (std::size_t k = 0; k < ten.size(); ++k)
                EXPECT_NEAR(record.values[k], ten[k] * unit, 1e-7 * unit * 6)
                    << key;  // eight digits or a float
        }
    }
}

TEST(RecordFormats, KnetMeanIsRemoved) {
    const Record record = parse_record(small_records::knet(), "r");
    EXPECT_DOUBLE_EQ(record.dt, 0.01);
    ASSERT_EQ(record.values.size(), 10u);
    EXPECT_DOUBLE_EQ(record.values[1], 3.92);
    EXPECT_DOUBLE_EQ(record.values[2], -3.92);
    EXPECT_NEAR(record.values[9], -0.0392, 1e-15);
}

TEST(RecordFormats, StackedFilesSelectChannelAndQuantity) {
    RecordDeclaration wanted;
    wanted.channel = 2;
    EXPECT_NEAR(parse_record(small_records::csmip(), "r", wanted).values[0], 0.03038, 1e-12);
    EXPECT_NEAR(parse_record(small_records::cosmos(), "r", wanted).values[0], -3.038 * 9.80665, 1e-12);
    EXPECT_NEAR(parse_record(small_records::geonet(), "r", wanted).values[0], -3.038e-3, 1e-12);
    wanted.channel = 4;
    EXPECT_THAT(error_in(small_records::geonet(), wanted),
                HasSubstr("no channel 4 in the file; expected channel = 1 to 3"));
    wanted = {Quantity::velocity};
    EXPECT_EQ(parse_record(small_records::cosmos(), "r", wanted).quantity, Quantity::velocity);
    EXPECT_NEAR(parse_record(small_records::csmip(), "r", wanted).values[0], -0.03038, 1e-12);
    wanted = {Quantity::displacement};
    EXPECT_NEAR(parse_record(small_records::geonet(), "r", wanted).values[0], -3.038e-3, 1e-12);
    EXPECT_THAT(error_in(small_records::cosmos(), wanted), HasSubstr("the file holds no displacement"));
}

TEST(RecordFormats, GeonetRawRecordsHaveOneTimeHistory) {
    const std::string text = small_records::geonet_component(true) + small_records::geonet_component(true);
    const Record record = parse_record(text, "r");
    EXPECT_DOUBLE_EQ(record.dt, 0.02);
    EXPECT_NEAR(record.values[9], -5.659e-3, 1e-12);
    EXPECT_THAT(error_in(text, {Quantity::velocity}), HasSubstr("the file holds no velocity"));
}

TEST(RecordFormats, SacInBothByteOrdersAndVersions) {
    const RecordDeclaration declaration{Quantity::velocity, "cm/s"};
    for (const bool big : {false, true})
        for (const unsigned version : {6u, 7u}) {
            const Record record = parse_record(small_records::sac(big, version), "r", declaration);
            EXPECT_EQ(record.dt, 0.02);
            EXPECT_NEAR(record.values[0], -0.03038, 1e-8);
        }
    EXPECT_THAT(error_in(small_records::sac()), HasSubstr("the quantity of the values is not given"));
    EXPECT_THAT(error_in(small_records::sac().substr(0, 660), declaration),
                HasSubstr("660 bytes: it is cut off"));
    EXPECT_THAT(error_in(small_records::sac() + "more", declaration), HasSubstr("more than the header says"));
    std::string uneven = small_records::sac();
    uneven[std::size_t{4} * 105] = 0;
    EXPECT_THAT(error_in(uneven, declaration), HasSubstr("the time step is uneven"));
}

// The last 30 bytes of the selected time history are missing.
TEST(RecordFormats, RejectATruncatedRecord) {
    for (const auto& [key, text] : small_records::all()) {
        const std::string_view format = key;
        if (format == "csv") continue;  // states no count
        RecordDeclaration declaration = declaration_for(key);
        if (format == "csmip") declaration = {Quantity::displacement, "", "", 2};
        if (format == "geonet") declaration = {Quantity::displacement, "", "", 3};
        if (format == "cosmos") declaration.channel = 2;
        const std::size_t end = std::min(text.rfind("/&"), text.size());
        EXPECT_THAT(
            error_in(text.substr(0, end - 30), declaration),
            AnyOf(HasSubstr("the text ends within"), HasSubstr("a number is missing"),
                  HasSubstr("is not a number"), HasSubstr("cut off"), HasSubstr("the record ends after")))
            << key;
    }
}

TEST(RecordFormats, RejectAWrongCountWithTheLine) {
    EXPECT_EQ(error_in(replaced(small_records::esm(), "NDATA: 10", "NDATA: 9")),
              "r:74: there are more values than the header says; expected 9 values");
    EXPECT_EQ(error_in(replaced(small_records::esm(), "NDATA: 10", "NDATA: 11")),
              "r:74: the text ends within the record, before value 11; expected 11 values");
    EXPECT_EQ(error_in(replaced(small_records::knet(), "Duration Time(s)  0.1", "Duration Time(s)  0.09")),
              "r:19:10: there is text after the last number; expected the end of the record, 9 values");
    EXPECT_EQ(error_in(replaced(small_records::csmip(), "   10 points", "   11 points")),
              "r:48:21: a number is missing; expected value 11 of 11 of the acceleration");
    EXPECT_THAT(error_in(replaced(small_records::geonet(), "points    10", "points    11")),
                StartsWith("r:10: the text states 11 points"));
}

TEST(RecordFormats, RejectInvalidHeaders) {
    EXPECT_THAT(error_in(replaced(small_records::knet(), "3920(gal)/1000", "3920(gal)/0")),
                StartsWith("r:14:19: '3920(gal)/0' is not a scale factor"));
    EXPECT_THAT(error_in(replaced(small_records::knet(), "100Hz", "0Hz")),
                StartsWith("r:11:19: '0Hz' is not a valid"));
    EXPECT_THAT(error_in(replaced(small_records::esm(), "TYPE: ACCELERATION", "TYPE: RESPONSE SPECTRUM")),
                StartsWith("r:64: 'RESPONSE SPECTRUM' is not a time history"));
    EXPECT_THAT(error_in(replaced(small_records::esm(), "0.020000", "0")), HasSubstr("steps of 0 s"));
    EXPECT_THAT(error_in(replaced(small_records::cosmos(), "       2       1", "       0       1")),
                HasSubstr("the record is raw"));
    EXPECT_THAT(error_in(replaced(small_records::cosmos(), "       2       1", "       2       3")),
                HasSubstr("give different quantities"));
    EXPECT_THAT(error_in(replaced(small_records::smc(), "5.0000000E+01", "1.7000000E+38")),
                StartsWith("r:18:16: the sampling rate is 1.7e+38 Hz"));
    EXPECT_THAT(error_in(replaced(small_records::smc(), "|a comment", "a comment")),
                StartsWith("r:29: there are fewer comment lines"));
}

// Files with changed bytes and removed or repeated pieces are read or rejected by InputError, also with a
// declared format.
TEST(RecordFormats, ReadOrRejectDamagedFiles) {
    std::mt19937 random(1);
    const auto pick = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
    int rejected = 0;
    for (const auto& [key, text] : small_records::all())
        for (int trial = 0; trial < 300; ++trial) {
            std::string damaged = text;
            for (std::size_t k = 1 + pick(4); k > 0 && !damaged.empty(); --k) {
                const std::size_t at = pick(damaged.size()), length = pick(60);
                const char* words[] = {"-1", "1e308", "nan", "999999999", "\n", "", "|"};
                switch (pick(4)) {
                    case 0:
                        damaged[at] = static_cast<char>(pick(256));
                        break;
                    case 1:
                        damaged.erase(at, length);
                        break;
                    case 2:
                        damaged.insert(pick(damaged.size()), damaged.substr(at, length));
                        break;
                    default:
                        damaged.replace(at, pick(9), words[pick(std::size(words))]);
                }
            }
            if (trial % 10 == 0) damaged.resize(pick(damaged.size()));
            for (const RecordFormat* format : record_formats()) {
                RecordDeclaration declaration{Quantity::acceleration, "", format->key};
                rejected += error_in(damaged, declaration) != "no error";
            }
            error_in(damaged, declaration_for(key));
        }
    EXPECT_GT(rejected, 1000);
}

}  // namespace
}  // namespace rockslope::record::formats_test
