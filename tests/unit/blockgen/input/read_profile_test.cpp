#include "blockgen/input/read_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_of.hpp"
#include "unit/blockgen/file_folder.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::read_profile_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ReadProfile : public FileFolder {
  protected:
    /// The domain of a profile in a new file.
    std::string with(const std::string& name, const std::string& text, const std::string& keys) {
        return "[domain]\nblock_material = \"rock\"\nprofile_file = " + file(name, text) + "\n" + keys + "\n";
    }
    std::string error_with(const std::string& name, const std::string& text,
                           const std::string& keys = "depth = 5") {
        const std::string model = with(name, text, keys);
        return error_of([&] { slope(model); });
    }
};

std::string geojson(const std::string& coordinates, const std::string& crs = {}) {
    const std::string member =
        crs.empty() ? "" : R"("crs": {"type": "name", "properties": {"name": ")" + crs + R"("}}, )";
    return R"({"type": "FeatureCollection", )" + member +
           R"("features": [{"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": )" +
           coordinates + "}}]}";
}

const std::string table = "distance,elevation\n0,60\n30,60\n50,20\n80,20\n";
const std::vector<Point> ground = {{0, 60}, {30, 60}, {50, 20}, {80, 20}};

TEST_F(ReadProfile, ClosedAtADepthOrAnElevation) {
    const SlopeModel model = slope(with("a.csv", table, "depth = 8"));
    EXPECT_THAT(model.outline, ElementsAre(Point{0, 12}, Point{80, 12}, Point{80, 20}, Point{50, 20},
                                           Point{30, 60}, Point{0, 60}));
    EXPECT_EQ(model.files.size(), 1u);
    EXPECT_THAT(model.notes, IsEmpty());
    // 30 m by 48 m, a trapezium of 20 m, 30 m by 8 m.
    EXPECT_EQ(cut(model).report.domain_area, 30 * 48 + 20 * 28 + 30 * 8);
    EXPECT_EQ(slope(with("a.csv", table, "bottom = 12")).outline, model.outline);
    EXPECT_THAT(error_with("a.csv", table, ""), HasSubstr("exactly one of bottom and depth"));
    EXPECT_THAT(error_with("a.csv", table, "bottom = 1\ndepth = 3"), HasSubstr("exactly one"));
    EXPECT_THAT(error_with("a.csv", table, "bottom = 20"),
                AllOf(HasSubstr("slope.toml:4:10: "), HasSubstr("an elevation below 20 m")));
    EXPECT_THAT(error_with("a.csv", table, "depth = 0"), HasSubstr("a positive distance"));
}

TEST_F(ReadProfile, TheSameFromAllFormatsOfTheSection) {
    const Ring outline = slope(with("a.csv", table, "depth = 8")).outline;
    const std::string line = "[[0, 60], [30, 60], [50, 20], [80, 20]]";
    const std::string dxf =
        "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nground\n90\n4\n70\n0\n10\n0\n20\n60\n10\n30\n20\n60\n"
        "10\n50\n20\n20\n10\n80\n20\n20\n0\nENDSEC\n0\nEOF\n";
    EXPECT_EQ(slope(with("b.csv", "0,60\n30,60\n50,20\n80,20\n", "depth = 8")).outline, outline);
    EXPECT_EQ(slope(with("c.csv", "name,y,x\na,60,0\nb,60,30\nc,20,50\nd,20,80\n", "depth = 8")).outline,
              outline);
    EXPECT_EQ(slope(with("d.geojson", geojson(line), "depth = 8")).outline, outline);
    EXPECT_EQ(slope(with("e.dxf", dxf, "depth = 8")).outline, outline);
    // A unit of the model file scales both coordinates.
    const Ring feet = slope(with("f.csv", "0,100\n200,50\n", "depth = 1\nunit = \"ft\"")).outline;
    EXPECT_NEAR(feet[1].x, 200 * 0.3048, 1e-12);
    EXPECT_NEAR(feet[2].y, 50 * 0.3048, 1e-12);
}

TEST_F(ReadProfile, FaultsAreNamedWithTheLineOfTheFile) {
    EXPECT_THAT(error_with("a.csv", "distance,elevation\n# crest\n0,60\n30,60\n20,20\n"),
                AllOf(HasSubstr("a.csv:5: "), HasSubstr("point 3: the profile runs backwards"),
                      HasSubstr("from left to right")));
    EXPECT_THAT(error_with("a.csv", "distance,elevation\n0,60\n0,60\n20,20\n"),
                AllOf(HasSubstr("a.csv:3: "), HasSubstr("repeats the point at x = 0")));
    EXPECT_THAT(error_with("a.csv", "distance,elevation\n0,60\n"), HasSubstr("1 point is no profile"));
    EXPECT_THAT(error_with("a.csv", "distance,elevation\n"), HasSubstr("0 points are no profile"));
    EXPECT_THAT(error_with("a.csv", ""), HasSubstr("0 points are no profile"));
    EXPECT_THAT(error_with("a.csv", "distance,elevation\n0,60\n5,nan\n"), HasSubstr("a.csv:3:3: 'nan'"));
    EXPECT_THAT(error_with("a.csv", "chainage,elevation\n0,60\n5,3\n"), HasSubstr("no column 'distance'"));
    EXPECT_THAT(error_with("a.geojson", R"({"type": "FeatureCollection", "features": []})"),
                HasSubstr("the file has 0 lines"));
    EXPECT_THAT(error_with("a.csv", table, "depth = 5\noutline = [[0, 0], [1, 0], [1, 1]]"),
                HasSubstr("both given"));
    EXPECT_THAT(error_with("a.csv", table, "depth = 5\nsimplify = -1"),
                HasSubstr("a distance of zero or more"));
    EXPECT_THAT(error_of([] {
                    slope("[domain]\nblock_material = \"rock\"\nprofile_file = \"no-such.csv\"\ndepth = 1\n");
                }),
                HasSubstr("no-such.csv"));
}

TEST_F(ReadProfile, SimplifiedByADistance) {
    const std::string text = "distance,elevation\n0,60\n15,60.1\n30,60\n40,39.9\n50,20\n80,20\n";
    EXPECT_EQ(slope(with("a.csv", text, "depth = 8\nsimplify = 0.2")).outline,
              slope(with("b.csv", table, "depth = 8")).outline);
    EXPECT_EQ(slope(with("a.csv", text, "depth = 8\nsimplify = \"5 cm\"")).outline.size(), 7u);
}

/// A survey along a line of azimuth 36.87 deg: the direction (3, 4) / 5.
const std::string section = "[section]\nfrom = [466000, 6691500]\nto = [466048, 6691564]\n";

TEST_F(ReadProfile, ALineOfTheMapIsProjectedToTheSectionLine) {
    // At 0, 30, 50 and 80 m along the line, 0, 1, -2 and 0 m to its left.
    const std::string line =
        "[[466000, 6691500, 60], [466017.2, 6691524.6, 60], [466031.6, 6691538.8, 20], [466048, 6691564, "
        "20]]";
    const SlopeModel model = slope(with("a.geojson", geojson(line, "EPSG:3067"), "depth = 8") + section);
    ASSERT_EQ(model.outline.size(), 6u);
    for (std::size_t k = 0; k < ground.size(); ++k) {
        // Coordinates of 6.7e6 m are rounded to 1e-9 m.
        EXPECT_NEAR(model.outline[5 - k].x, ground[k].x, 4e-9) << k;
        EXPECT_EQ(model.outline[5 - k].y, ground[k].y) << k;
    }
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_THAT(model.notes[0], HasSubstr("from 2 m beside it"));
    EXPECT_THAT(model.system.name(), HasSubstr("EPSG:3067"));

    // The other direction of the same line, and a table of it.
    const std::string reversed =
        "x,y,elevation\n466048,6691564,20\n466031.6,6691538.8,20\n466017.2,6691524.6,60\n466000,6691500,60\n";
    EXPECT_EQ(slope(with("b.csv", reversed, "depth = 8") + section).outline, model.outline);
}

TEST_F(ReadProfile, ALineOfTheMapEndsWithTheSectionLine) {
    // From 10 m before the line's start to 20 m beyond its end, falling by 1 m in 2.
    const std::string line = "x,y,z\n465994,6691492,100\n466060,6691580,45\n";
    const Ring outline = slope(with("a.csv", line, "bottom = 0") + section).outline;
    ASSERT_EQ(outline.size(), 4u);
    EXPECT_EQ(outline[3].x, 0);
    EXPECT_NEAR(outline[3].y, 95, 4e-9);
    EXPECT_EQ(outline[2].x, 80);
    EXPECT_NEAR(outline[2].y, 55, 4e-9);
    EXPECT_THAT(
        error_of([&] {
            slope(with("b.csv", "x,y,z\n466060,6691580,10\n466066,6691588,9\n", "bottom = 0") + section);
        }),
        HasSubstr("beyond the ends of the section line"));
}

TEST_F(ReadProfile, OtherLinesOfTheMapAreRefused) {
    const auto error_of_line = [&](const std::string& line, const std::string& crs, const std::string& more) {
        return error_of([&] { slope(with("a.geojson", geojson(line, crs), "depth = 8") + more); });
    };
    const std::string across = "[[466000, 6691500, 60], [466040, 6691470, 50]]";
    EXPECT_THAT(error_of_line(across, "EPSG:3067", section),
                AllOf(HasSubstr("point 2 of the profile at (466040, 6691470) is 50 m from the section line"),
                      HasSubstr("within a tenth")));
    // Elevations without a section line, and a line of a map without elevations.
    EXPECT_THAT(error_of_line(across, "EPSG:3067", ""), HasSubstr("distance and elevation"));
    EXPECT_THAT(error_of_line("[[466000, 6691500], [466040, 6691570]]", "EPSG:3067", section),
                AllOf(HasSubstr("distance and elevation"), HasSubstr("crs = \"local\"")));
    EXPECT_THAT(error_of([&] { slope(with("b.csv", "x,y,z\n0,0,1\n9,0,2\n", "depth = 1")); }),
                HasSubstr("no section line"));
    // Degrees are held to the rules of all files.
    EXPECT_THAT(error_of_line("[[22.2, 60.4, 5], [22.2001, 60.4001, 6]]", "OGC:CRS84", section),
                HasSubstr("in degrees"));
    EXPECT_THAT(error_of_line("[[22.2, 60.4, 5], [22.2001, 60.4001, 6]]", "", section),
                HasSubstr("look like degrees"));
    // A survey whose projection runs backwards.
    EXPECT_THAT(
        error_of_line(
            "[[466000, 6691500, 60], [466012, 6691516, 55], [466006, 6691508, 52], [466048, 6691564, 50]]",
            "EPSG:3067", section),
        HasSubstr("point 3: the profile runs backwards"));
}

/// A slope made from a table and cut by a joint through its face.
TEST_F(ReadProfile, ASlopeOfAProfileIsCut) {
    const std::string joint = "[[traces]]\njoint_material = \"fault\"\npoints = [[-1, 30], [81, 30]]\n";
    const CutResult result = cut(slope(with("a.csv", table, "depth = 8") + joint));
    EXPECT_EQ(result.report.blocks, 2u);
    // The face is at x = 45 where the joint meets it.
    EXPECT_NEAR(result.report.joints[0].retained, 45, 1e-6);  // to the grid of 1e-6 m
}

}  // namespace
}  // namespace rockslope::blockgen::read_profile_test
