#include "blockgen/fit/fit_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "blockgen/fit/read_joint_map.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::fit_text_test {
namespace {

using testing::HasSubstr;

/// Two sets, one with ends and one through the map, in a window with a hole.
JointMap map_of(double density) {
    const SlopeModel model = slope(
        "seed = 3\n[domain]\noutline = [[0, 0], [30, 0], [30, 30], [0, 30]]\n"
        "holes = [[[10, 10], [12, 10], [11, 12]]]\nblock_material = \"rock\"\n"
        "[[joint_set]]\nname = \"a\"\nkind = \"baecher\"\nangle = { law = \"normal\", mean = \"40 deg\", sd "
        "= \"5 deg\" }\n"
        "trace_length = { law = \"lognormal\", mean = 4, sd = 2 }\np21 = " +
        std::to_string(density) +
        "\n[[joint_set]]\nname = \"b\"\nangle = \"-50 deg\"\nspacing = { law = \"exponential\", mean = 1 "
        "}\n");
    return {all_traces(model), {{model.outline}, model.holes}};
}

// The sets of a map, read back, sampled and fitted again, have the statistics of the map.
TEST(FittedModel, IsASlopeModelOfTheSameStatistics) {
    const JointMap map = map_of(1);
    const MapFit fit = fit_map(map, {});
    ASSERT_EQ(fit.sets.size(), 2u);
    const SlopeModel model = slope(fitted_model_text(fit, map, "map.geojson"));
    EXPECT_EQ(model.outline, map.window.outer[0]);
    EXPECT_EQ(model.holes.size(), 1u);
    ASSERT_EQ(model.joint_sets.size(), 2u);
    EXPECT_GT(cut(model).mesh.block_count(), 100u);
    const MapFit again = fit_map({all_traces(model), map.window}, {});
    ASSERT_EQ(again.sets.size(), 2u);
    for (const FittedSet& set : fit.sets)
        for (const FittedSet& other : again.sets) {
            if (set.pattern != other.pattern) continue;
            EXPECT_NEAR(other.direction.value, set.direction.value, 0.02);
            EXPECT_NEAR(other.p21.value / set.p21.value, 1, 0.2);
            EXPECT_NEAR(other.spacing.value / set.spacing.value, 1, 0.2);
            EXPECT_EQ(other.length.has_value(), set.length.has_value());
        }
    EXPECT_THAT(fit_table(fit), HasSubstr("trace_length_sd"));
    EXPECT_THAT(fit_json(fit), HasSubstr("\"through the map\""));
}

/// A file in the folder of the test, removed at the end.
class MapFile {
  public:
    MapFile(const std::string& name, const std::string& text)
        : path(std::filesystem::path(testing::TempDir()) / name) {
        std::ofstream(path) << text;
    }
    ~MapFile() { std::filesystem::remove(path); }
    MapFile(const MapFile&) = delete;
    MapFile& operator=(const MapFile&) = delete;
    std::filesystem::path path;
};

TEST(ReadJointMap, TakesTheOutlineFromTheMapAFileOrTheTraces) {
    const std::string lines = R"({"type": "LineString", "coordinates": [[1, 1], [3, 1]]},
        {"type": "LineString", "coordinates": [[1, 2], [1, 4]]})";
    const MapFile bare("fit_bare.geojson",
                       R"({"type": "GeometryCollection", "geometries": [)" + lines + "]}");
    const MapFile full("fit_full.geojson",
                       R"({"type": "GeometryCollection", "geometries": [{"type": "Polygon", "coordinates":
                       [[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]], [[5, 5], [6, 5], [6, 6], [5, 5]]]},)" +
                           lines + "]}");
    const MapFile outline("fit_outline.csv", "x,y\n0,0\n5,0\n5,5\n0,5\n");
    const JointMapFile box = read_joint_map({bare.path, {}, {}, {}, {}});
    EXPECT_EQ(box.map.window.area(), 6);
    ASSERT_EQ(box.notes.size(), 1u);
    EXPECT_THAT(box.notes[0], HasSubstr("--outline"));
    EXPECT_EQ(read_joint_map({full.path, {}, {}, {}, {}}).map.window.area(), 99.5);
    EXPECT_EQ(read_joint_map({bare.path, outline.path, {}, {}, {}}).map.window.area(), 25);
}

TEST(ReadJointMap, RefusesDegreesUnlessTheyAreConverted) {
    const MapFile degrees("fit_degrees.geojson",
                          R"({"type": "GeometryCollection", "geometries": [{"type": "LineString",
                          "coordinates": [[21.5, 60.3], [21.5002, 60.3001]]}]})");
    EXPECT_THAT(error_of([&] { read_joint_map({degrees.path, {}, {}, {}, {}}); }), HasSubstr("degrees"));
    const JointMapFile placed = read_joint_map({degrees.path, {}, {}, {}, "EPSG:32634"});
    EXPECT_NEAR(placed.map.window.area(), 11 * 11, 25);
}

}  // namespace
}  // namespace rockslope::blockgen::fit_text_test
