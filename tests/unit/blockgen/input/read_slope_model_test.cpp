#include "blockgen/input/read_slope_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "blockgen/input/geometry_file.hpp"
#include "support/case_name.hpp"
#include "support/error_of.hpp"
#include "support/replaced.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::read_slope_model_test {
namespace {

using testing::HasSubstr;

const std::string valid = R"(seed = 42
[domain]
outline = [[0, 0], [10, 0], [10, 5], [0, 5]]
block_material = "rock"
grid = 9.5367431640625e-7
[[region]]
name = "top"
block_material = "soil"
polygon = [[0, 4], [10, 4], [10, 5], [0, 5]]
[[tunnel]]
shape = "circle"
centre = [4, 2]
radius = "50 cm"
[[joint_set]]
name = "bedding"
kind = "parallel"
angle = "-25 deg"
spacing = { law = "lognormal", mean = 3.0, sd = 0.6, min = 1.0, max = 8.0 }
trace_length = { law = "exponential", mean = 20 }
gap = 2.0
[[traces]]
joint_material = "fault"
points = [[1, 0], [2, 5]]
[[fixed_block]]
side = "bottom"
[[measured_point]]
name = "crest"
at = [5, 4.5]
)";

std::string error_of(const std::string& text) {
    const std::string error = rockslope::error_of([&] { slope(text); });
    EXPECT_EQ(error.find('\n'), std::string::npos);
    return error;
}

TEST(ReadSlopeModel, ReadsEveryTable) {
    const SlopeModel model = slope(valid);
    EXPECT_EQ(model.seed, 42u);
    EXPECT_EQ(model.grid, 0x1p-20);
    EXPECT_EQ(model.regions[0].block_material, "soil");
    EXPECT_EQ(model.tunnels[0].outline.size(), 32u);
    EXPECT_NEAR(model.joint_sets[0].orientation.angle.mean, -25 * std::numbers::pi / 180, 1e-15);
    EXPECT_EQ(model.joint_sets[0].spacing, (Distribution{Law::lognormal, 3, 0.6, 1, 8}));
    EXPECT_EQ(model.joint_sets[0].joint_material, "bedding");
    EXPECT_EQ(model.traces[0].points[1], (Point{2, 5}));
    EXPECT_EQ(model.selectors[0].side, "bottom");
    EXPECT_EQ(model.measured_points[0].name, "crest");
}

TEST(ReadSlopeModel, TheTemplateIsAValidModel) {
    EXPECT_GT(cut(slope(slope_model_template())).mesh.block_count(), 100u);
}

TEST(ReadSlopeModel, OutlinesMayTurnEitherWayAndBeClosed) {
    const SlopeModel model = slope(
        replaced(valid, "[[0, 0], [10, 0], [10, 5], [0, 5]]", "[[0, 5], [10, 5], [10, 0], [0, 0], [0, 5]]"));
    EXPECT_EQ(model.outline.size(), 4u);
    EXPECT_EQ(twice_signed_area(model.outline), 100);
}

struct Fault {
    const char* from;
    const char* to;
    const char* place;
    const char* message;
};

class FaultySlope : public testing::TestWithParam<Fault> {};

TEST_P(FaultySlope, IsRefusedWithItsPlace) {
    const auto& [from, to, place, message] = GetParam();
    const std::string error = error_of(replaced(valid, from, to));
    EXPECT_THAT(error, HasSubstr(std::string("slope.toml:") + place));
    EXPECT_THAT(error, HasSubstr(message));
}

INSTANTIATE_TEST_SUITE_P(
    All, FaultySlope,
    testing::Values(
        Fault{"gap = 2.0", "gapp = 2.0", "", "gap"}, Fault{"spacing = {", "spacng = {", "", "spacing"},
        Fault{"seed = 42", "seed = -1", "1", "negative seed"},
        Fault{"seed = 42", "seed = \"a\"", "1", "seed"}, Fault{"seed = 42", "seeed = 42", "1", "seed"},
        Fault{"[[0, 0], [10, 0], [10, 5], [0, 5]]", "[]", "3", "enclose no area"},
        Fault{"[[0, 0], [10, 0], [10, 5], [0, 5]]", "[[0, 0], [1, 0]]", "3", "enclose no area"},
        Fault{"[[0, 0], [10, 0], [10, 5], [0, 5]]", "[[0, 0], [5, 0], [10, 0]]", "3", "meet"},
        Fault{"[[0, 0], [10, 0], [10, 5], [0, 5]]", "[[0, 0], [10, 5], [10, 0], [0, 5]]", "3",
              "edge 1 from (0, 0) to (10, 5) and edge 3 from (10, 0) to (0, 5) meet at (5, 2.5)"},
        Fault{"[10, 5], [0, 5]]", "[10, nan], [0, 5]]", "3", "finite"},
        Fault{"[10, 5], [0, 5]]", "[10, 5, 1], [0, 5]]", "3", "outline"},
        Fault{"[10, 5], [0, 5]]", "[10, 1e31], [0, 5]]", "3", "too large"},
        Fault{"[10, 5], [0, 5]]", "[10, 1e17], [0, 5]]", "5", "too fine"},
        Fault{"block_material = \"rock\"", "block_material = \"\"", "4", "is empty"},
        Fault{"polygon = [[0, 4], [10, 4]", "polygon = [[0, 4], [1e12, 4]", "9", "too fine"},
        Fault{"centre = [4, 2]", "centre = [4, 1e12]", "11", "too fine"},
        Fault{"points = [[1, 0], [2, 5]]", "points = [[1, 0], [2e12, 5]]", "23", "too fine"},
        Fault{"[[fixed_block]]", "[[bolt]]\nmaterial = \"m\"\nfrom = [1, 1]\nto = [1, 1]\n[[fixed_block]]",
              "27", "same point"},
        Fault{"block_material = \"rock\"", "block_material = 3", "4", "block_material"},
        Fault{"block_material = \"rock\"\n", "", "2", "block_material"},
        Fault{"grid = 9.5367431640625e-7", "grid = 1e-6", "5", "power of two"},
        Fault{"grid = 9.5367431640625e-7", "grid = 0", "5", "power of two"},
        Fault{"grid = 9.5367431640625e-7", "grid = 3.552713678800501e-15", "5", "too fine"},
        Fault{"[10, 4], [10, 5], [0, 5]]", "[10, 5], [10, 4], [0, 5]]", "9", "meet"},
        Fault{"\"circle\"", "\"cirkle\"", "11", "circle"}, Fault{"\"50 cm\"", "\"50 kg\"", "13", "radius"},
        Fault{"\"50 cm\"", "-1", "13", "positive"}, Fault{"\"-25 deg\"", "-25", "17", "deg"},
        Fault{"\"parallel\"", "\"voronoy\"", "16", "parallel"},
        Fault{"{ law = \"lognormal\", mean = 3.0, sd = 0.6, min = 1.0, max = 8.0 }", "-3", "18", "too small"},
        Fault{"{ law = \"lognormal\", mean = 3.0, sd = 0.6, min = 1.0, max = 8.0 }", "0", "18", "too small"},
        Fault{"{ law = \"lognormal\", mean = 3.0, sd = 0.6, min = 1.0, max = 8.0 }", "1e-7", "18",
              "below the grid"},
        Fault{"law = \"lognormal\", mean = 3.0, sd = 0.6, min = 1.0",
              "law = \"normal\", mean = 3.0, sd = 0.6, min = -1.0", "18", "negative"},
        Fault{"min = 1.0, max = 8.0", "min = 8.0, max = 1.0", "18", "max"},
        Fault{"min = 1.0, max = 8.0", "min = 1e6, max = 2e6", "18", "no probability"},
        Fault{"sd = 0.6", "sd = -0.6", "18", "standard deviation"},
        Fault{"sd = 0.6", "sdd = 0.6", "18", "sd"}, Fault{"gap = 2.0", "gap = -2.0", "20", "too small"},
        Fault{"gap = 2.0", "", "19", "gap and persistence"},
        Fault{"gap = 2.0", "gap = 2.0\nregion = \"tip\"", "21", "no region 'tip'"},
        Fault{"points = [[1, 0], [2, 5]]", "points = [[1, 0]]", "23", "fewer than two"},
        Fault{"side = \"bottom\"", "side = \"base\"", "25", "bottom"},
        Fault{"side = \"bottom\"", "side = \"bottom\"\nat = [1, 1]", "", "exactly one"},
        Fault{"at = [5, 4.5]", "at = [5]", "28", "at"}),
    [](const auto& tested) { return case_name(std::to_string(tested.index) + " " + tested.param.message); });

TEST(ReadSlopeModel, NamesTheSpelling) {
    EXPECT_THAT(error_of(replaced(valid, "gap = 2.0", "gapp = 2.0\ngap = 2.0")), HasSubstr("gap"));
}

class GeometryFile : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& text) {
        const std::filesystem::path path =
            std::filesystem::path(testing::TempDir()) / ("geometry_file_" + name);
        std::ofstream(path) << text;
        return path;
    }
    std::string error_of(const std::filesystem::path& path) {
        return rockslope::error_of([&] { read_trace_file(path, "t", ""); });
    }
};

TEST_F(GeometryFile, TracesFromCsv) {
    const auto path = write(
        "a.csv", "x1, y1,x2,y2,joint_material # header\n0,0,1,1,\n\n466000.282228214303632,2,3,-4e0,fault\n");
    const auto traces = read_trace_file(path, "t", "joint");
    ASSERT_EQ(traces.size(), 2u);
    EXPECT_EQ(traces[0].joint_material, "joint");
    EXPECT_EQ(traces[1].joint_material, "fault");
    EXPECT_EQ(traces[1].points[0].x, 466000.282228214303632);
    EXPECT_THAT(error_of(path), HasSubstr("no joint material"));
}

TEST_F(GeometryFile, CommasAndHashesInQuotesAreText) {
    const auto traces = read_trace_file(write("q.csv",
                                              "x1,y1,x2,y2,\"note, of the day\",joint_material # header\n"
                                              "0,0,1,1,\"wet, # 3\",\"fault, \"\"old\"\"\"\n"),
                                        "t", "joint");
    ASSERT_EQ(traces.size(), 1u);
    EXPECT_EQ(traces[0].joint_material, "fault, \"old\"");
}

TEST_F(GeometryFile, CsvFaultsAreNamedWithTheirPlace) {
    EXPECT_THAT(error_of(write("b.csv", "x1,y1,x2\n0,0,1\n")), HasSubstr("no column 'y2'"));
    EXPECT_THAT(error_of(write("c.csv", "x1,y1,x2,y2\n0,0,1,nan\n")), HasSubstr("c.csv:2:7"));
    EXPECT_THAT(error_of(write("c.csv", "x1,y1,x2,y2\n0,0,1,1e31\n")),
                HasSubstr("c.csv:2:7: '1e31' is too large"));
    EXPECT_THAT(error_of(write("c.csv",
                               "x1,y1,x2,y2,joint_material\n0,0,1,1,r\xf6"
                               "ck\n")),
                HasSubstr("c.csv:2:9: a name is not UTF-8"));
    EXPECT_THAT(error_of(write("d.csv", "x1,y1,x2,y2\n0,0,1\n")), HasSubstr("d.csv:2"));
    EXPECT_THAT(error_of(write("e.csv", "x1,y1,x2,y2\n")), HasSubstr("no trace"));
    EXPECT_THAT(error_of(write("f.xyz", "0")), HasSubstr("geometry format"));
    EXPECT_THAT(error_of("no-such.csv"), HasSubstr("no-such.csv: cannot be read"));
}

TEST_F(GeometryFile, TracesAndOutlineFromGeoJson) {
    const auto traces = read_trace_file(write("g.geojson", R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"joint_material": "fault"}, "geometry": {"type": "LineString", "coordinates": [[0, 0, 9], [1, 1]]}},
        {"type": "Feature", "properties": null, "geometry": {"type": "MultiLineString", "coordinates": [[[0, 0], [2, 1]], [[3, 3], [4, 4], [5, 4]]]}},
        {"type": "Feature", "properties": {}, "geometry": null}]})"),
                                        "t", "joint");
    ASSERT_EQ(traces.size(), 3u);
    EXPECT_EQ(traces[0].joint_material, "fault");
    EXPECT_EQ(traces[2].points.size(), 3u);
    const auto parts = read_outline_file(write(
        "h.geojson",
        R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 0]], [[2, 1], [3, 1], [3, 2], [2, 1]]]})"));
    ASSERT_EQ(parts.size(), 1u);
    ASSERT_EQ(parts[0].size(), 2u);
    EXPECT_EQ(parts[0][0].size(), 3u);
}

TEST_F(GeometryFile, PartsOfADomainFromGeoJson) {
    const auto parts = read_outline_file(write("m.geojson", R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "geometry": {"type": "MultiPolygon", "coordinates": [
            [[[0, 0], [4, 0], [4, 4], [0, 0]]],
            [[[6, 0], [9, 0], [9, 9], [6, 0]], [[8, 2], [8.5, 2], [8.5, 4], [8, 2]]]]}},
        {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[20, 0], [24, 0], [24, 4], [20, 0]]]}}]})"));
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[0].size(), 1u);
    EXPECT_EQ(parts[1].size(), 2u);
    EXPECT_THROW(read_outline_file(write("m.geojson", R"({"type": "MultiPolygon", "coordinates": []})")),
                 InputError);
    EXPECT_THROW(read_outline_file(write("m.geojson", R"({"type": "MultiPolygon", "coordinates": [[]]})")),
                 InputError);
}

TEST_F(GeometryFile, GeoJsonFaultsAreNamed) {
    EXPECT_THAT(error_of(write("i.geojson", "{\n\n\"type\": oops}")), HasSubstr("i.geojson:3"));
    EXPECT_THAT(error_of(write("j.geojson", "[]")), HasSubstr("no type"));
    EXPECT_THAT(error_of(write("k.geojson", R"({"type": "Point", "coordinates": [0, 0]})")),
                HasSubstr("'Point'"));
    EXPECT_THAT(error_of(write("l.geojson", R"({"type": "LineString", "coordinates": [[0, 0]]})")),
                HasSubstr("two points"));
    const auto line = [](const std::string& points) {
        return R"({"type": "MultiLineString", "coordinates": [)" + points + "]}";
    };
    EXPECT_THAT(error_of(write("n.geojson", line(""))), HasSubstr("no trace"));
    EXPECT_THAT(error_of(write("n.geojson", line("[[0, 0]], [[0, 0], [1, 1]]"))), HasSubstr("two points"));
    EXPECT_THAT(error_of(write("n.geojson", line("[[0, 0], [1, 1e31]]"))), HasSubstr("too large"));
    EXPECT_THAT(error_of(write("n.geojson", line("[[0, 0], [1, 1e999]]"))), HasSubstr("too large"));
    std::string nested, closing;
    for (int i = 0; i < 100000; ++i) {
        nested += R"({"type": "GeometryCollection", "geometries": [)";
        closing += "]}";
    }
    EXPECT_THAT(error_of(write("n.geojson", nested + closing)), HasSubstr("nested too deeply"));
    EXPECT_THAT(error_of(write("m.geojson", R"({"type": "LineString", "coordinates": [[0, "x"], [1, 1]]})")),
                HasSubstr("pair of numbers"));
}

}  // namespace
}  // namespace rockslope::blockgen::read_slope_model_test
