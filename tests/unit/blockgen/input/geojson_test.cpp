#include "blockgen/input/geojson.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "common/base/input_error.hpp"
#include "unit/blockgen/file_folder.hpp"

namespace rockslope::blockgen::geojson_test {
namespace {

using testing::HasSubstr;

class GeoJson : public FileFolder {
  protected:
    std::filesystem::path write(const std::string& text) const {
        file("map.geojson", text);
        return folder_ / "map.geojson";
    }

    std::string error_of(const std::string& text) const {
        try {
            read_geojson_lines(write(text));
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    }
};

std::string feature(const std::string& coordinates, const std::string& properties = "{}") {
    return R"({"type": "Feature", "properties": )" + properties +
           R"(, "geometry": {"type": "LineString", "coordinates": )" + coordinates + "}}";
}

std::string collection(const std::string& features, const std::string& more = {}) {
    return R"({"type": "FeatureCollection", )" + more + R"("features": [)" + features + "]}";
}

std::string shortest(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", number);
    return text;
}

// Numbers of any exponent within the range of coordinates have the bits that strtod gives them.
TEST_F(GeoJson, NumbersAreTheNearestOnes) {
    std::mt19937_64 random(7);
    std::string points;
    std::vector<double> written;
    while (written.size() < 20000) {
        const double number = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
        if (!(std::abs(number) < 1e30)) continue;
        points +=
            (points.empty() ? "[" : ", [") + shortest(number) + ", " + std::to_string(written.size()) + "]";
        written.push_back(number);
    }
    const MapLines map = read_geojson_lines(write(feature("[" + points + "]")));
    ASSERT_EQ(map.lines.size(), 1u);
    ASSERT_EQ(map.lines[0].points.size(), written.size());
    for (std::size_t k = 0; k < written.size(); ++k) EXPECT_EQ(map.lines[0].points[k].x, written[k]);
}

TEST_F(GeoJson, MembersComeInAnyOrder) {
    const std::string text = collection(
        R"({"geometry": {"coordinates": [[0, 0], [1, 2, 3]], "bbox": [0, 0, 1, 1], "type": "LineString"},)"
        R"( "properties": {"dip": "60", "list": [1, {"dip": 5}], "joint_material": "clay",)"
        R"( "dip_direction": 120}, "id": 7, "type": "Feature"})",
        R"("crs": {"type": "name", "properties": {"name": "EPSG:32633"}}, "none": null, "yes": true,)");
    const MapLines map = read_geojson_lines(write(text));
    ASSERT_EQ(map.lines.size(), 1u);
    EXPECT_EQ(map.lines[0].joint_material, "clay");
    EXPECT_EQ(map.lines[0].plane.dip, 60);
    EXPECT_EQ(map.lines[0].plane.dip_direction, 120);
    EXPECT_EQ(map.notes.system, "EPSG:32633");
    EXPECT_EQ(map.notes.with_heights, 1u);
}

// As Windows' programs write it.
TEST_F(GeoJson, ByteOrderMarkIsSkipped) {
    EXPECT_EQ(read_geojson_lines(write("\xEF\xBB\xBF" + feature("[[0, 0], [1, 1]]"))).lines.size(), 1u);
}

TEST_F(GeoJson, EscapedNamesAreTheNames) {
    const std::string text = feature("[[0, 0], [1, 1]]", R"({"joint\u005fmaterial": "Kluft \u00e4"})");
    EXPECT_EQ(read_geojson_lines(write(text)).lines[0].joint_material, "Kluft \xC3\xA4");
}

TEST_F(GeoJson, FaultsAreFoundInMembersThatAreNotUsed) {
    const std::string line = feature("[[0, 0], [1, 1]]");
    for (const std::string fault :
         {"[1,, 2]", "{\"a\" 1}", "tru", "nul", "01", "1.", "\"\\q\"", "[1, 2}", "-", "\"\x01\"", "\"\xC3\""})
        EXPECT_THAT(error_of(collection(line, "\n\"other\": " + fault + ", ")),
                    HasSubstr("map.geojson:2: this is not JSON"))
            << fault;
    EXPECT_THAT(error_of(collection(line, R"("other": 1e999, )")), HasSubstr("a number is too large"));
}

TEST_F(GeoJson, TextAfterTheObjectIsRefused) {
    const std::string line = feature("[[0, 0], [1, 1]]");
    for (const std::string rest : {"{}", "x", "]", ","})
        EXPECT_THAT(error_of(line + "\n" + rest), HasSubstr("map.geojson:2: this is not JSON")) << rest;
    EXPECT_EQ(error_of(line + "\n \n"), "no error");
}

TEST_F(GeoJson, TextThatEndsEarlyIsRefused) {
    const std::string text = collection(feature("[[0, 0], [1, 1]]") + "," + feature("[[0, 0], [1, 1]]"));
    for (std::size_t length = 0; length < text.size(); ++length)
        EXPECT_THAT(error_of(text.substr(0, length)), HasSubstr("this is not JSON")) << length;
}

TEST_F(GeoJson, ErrorsNameTheFeature) {
    const std::string line = feature("[[0, 0], [1, 1]]");
    EXPECT_THAT(error_of(collection(line + "," + feature("[[0, 0]]"))),
                HasSubstr("feature 1: a line of fewer"));
    EXPECT_THAT(error_of(collection(line + "," + line + "," + feature("[[0, 0], 1]"))),
                HasSubstr("feature 2: a position"));
    EXPECT_THAT(error_of(collection(line + ", {}")), HasSubstr("feature 1: an object has no type"));
}

}  // namespace
}  // namespace rockslope::blockgen::geojson_test
