#include "blockgen/input/place_coordinates.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_of.hpp"
#include "unit/blockgen/file_folder.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::place_coordinates_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

using PlaceCoordinates = FileFolder;

std::string geojson(const std::string& type, const std::string& coordinates, const std::string& crs = {}) {
    const std::string member =
        crs.empty() ? "" : R"("crs": {"type": "name", "properties": {"name": ")" + crs + R"("}}, )";
    return R"({"type": "FeatureCollection", )" + member +
           R"("features": [{"type": "Feature", "properties": {}, "geometry": {"type": ")" + type +
           R"(", "coordinates": )" + coordinates + "}}]}";
}

/// A square of about 60 m by 111 m near Turku, in degrees, and a trace across it.
const char* degrees_square =
    "[[[22.2, 60.4], [22.201, 60.4], [22.201, 60.401], [22.2, 60.401], [22.2, 60.4]]]";
const char* degrees_trace = "[[22.1995, 60.4004], [22.2015, 60.4006]]";
/// The same place in UTM zone 34.
const char* metres_trace = "[[566030, 6696500], [566180, 6696520]]";

std::string model_text(const std::string& domain, const std::string& traces = {}) {
    return "[domain]\nblock_material = \"rock\"\n" + domain +
           (traces.empty() ? "" : "\n[[traces]]\njoint_material = \"joint\"\n" + traces);
}

std::string error_in(const std::string& text) {
    return rockslope::error_of([&] { slope(text); });
}

TEST_F(PlaceCoordinates, DegreesAreRefused) {
    const std::string named =
        file("a.geojson", geojson("Polygon", degrees_square, "urn:ogc:def:crs:OGC:1.3:CRS84"));
    EXPECT_THAT(error_in(model_text("outline_file = " + named)),
                AllOf(HasSubstr("slope.toml:3:16: "), HasSubstr("the coordinates are in degrees"),
                      HasSubstr("project = ")));
    const std::string silent = file("b.geojson", geojson("Polygon", degrees_square));
    EXPECT_THAT(error_in(model_text("outline_file = " + silent)), HasSubstr("look like degrees"));
    const std::string table = file("c.csv", "x,y\n22.2,60.4\n22.201,60.4\n22.201,60.401\n22.2,60.401\n");
    EXPECT_THAT(error_in(model_text("outline_file = " + table)), HasSubstr("look like degrees"));
    // Traces in degrees beside an outline in metres.
    const std::string outline = "outline = [[566000, 6696400], [566200, 6696400], [566200, 6696600]]";
    EXPECT_THAT(
        error_in(model_text(outline, "file = " + file("d.geojson", geojson("LineString", degrees_trace)))),
        HasSubstr("look like degrees"));
}

TEST_F(PlaceCoordinates, MetresWithoutASystemAreRead) {
    const std::string near = file("a.geojson", geojson("Polygon", "[[[0, 0], [60, 0], [60, 40], [0, 0]]]"));
    EXPECT_EQ(slope(model_text("outline_file = " + near)).notes.size(), 0u);
    // One trace far from the origin, but within the domain.
    const std::string trace = file("b.geojson", geojson("LineString", "[[60, 40], [61, 41]]"));
    EXPECT_EQ(slope(model_text("outline = [[0, 0], [100, 0], [100, 80]]", "file = " + trace)).traces.size(),
              1u);
    // A specimen of 2 m whose coordinates could be degrees: the model says that they are not.
    const std::string far =
        file("c.geojson", geojson("Polygon", "[[[60, 40], [62, 40], [62, 41], [60, 40]]]"));
    EXPECT_THAT(error_in(model_text("outline_file = " + far)), HasSubstr("look like degrees"));
    EXPECT_EQ(slope(model_text("crs = \"local\"\noutline_file = " + far)).outline[0], (Point{60, 40}));
}

TEST_F(PlaceCoordinates, DegreesAreConvertedToTheProject) {
    for (const char* crs : {"", "urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326"}) {
        const std::string outline = file("a.geojson", geojson("Polygon", degrees_square, crs));
        const std::string traces = file("b.geojson", geojson("LineString", degrees_trace, crs));
        const SlopeModel model =
            slope(model_text("project = \"EPSG:32634\"\noutline_file = " + outline, "file = " + traces));
        // Arcs of 0.001 degrees on the ellipsoid WGS 84 at 60.4 and 60.4005 degrees north, 55.124 m and
        // 111.418 m, times the scale of the projection 1.2 degrees from its central meridian, 0.9996 (1 +
        // (0.020944 cos 60.4)^2 / 2) = 0.99965.
        const auto length = [&](int a, int b) {
            return std::hypot(model.outline[b].x - model.outline[a].x,
                              model.outline[b].y - model.outline[a].y);
        };
        EXPECT_NEAR(length(0, 1), 55.105, 0.01) << crs;
        EXPECT_NEAR(length(1, 2), 111.379, 0.01) << crs;
        EXPECT_NEAR(model.outline[0].x, 566000, 500) << crs;
        EXPECT_NEAR(model.outline[0].y, 6696000, 2000) << crs;
        EXPECT_EQ(cut(model).report.blocks, 2u) << crs;
        EXPECT_THAT(model.notes, Contains(HasSubstr("to EPSG:32634 (WGS 84 / UTM zone 34N)"))) << crs;
    }
}

TEST_F(PlaceCoordinates, FilesOfTwoSystemsAreRefusedOrConverted) {
    const std::string square =
        "[[[566000, 6696400], [566200, 6696400], [566200, 6696600], [566000, 6696400]]]";
    const std::string outline = file("a.geojson", geojson("Polygon", square, "urn:ogc:def:crs:EPSG::32634"));
    const std::string traces = file("b.geojson", geojson("LineString", metres_trace, "EPSG:3067"));
    EXPECT_THAT(error_in(model_text("outline_file = " + outline, "file = " + traces)),
                AllOf(HasSubstr("are in EPSG:3067 (ETRS89 / TM35FIN(E,N))"), HasSubstr("a.geojson"),
                      HasSubstr("EPSG:32634")));
    const std::string same = file("c.geojson", geojson("LineString", metres_trace, "EPSG:32634"));
    EXPECT_EQ(slope(model_text("outline_file = " + outline, "file = " + same)).traces.size(), 1u);
    EXPECT_EQ(slope(model_text("outline_file = " + outline, "crs = \"EPSG:32634\"\nfile = " + traces))
                  .traces.size(),
              1u);
    // Converted, they lie 330 km to the west.
    EXPECT_THAT(
        error_in(model_text("project = \"EPSG:32634\"\noutline_file = " + outline, "file = " + traces)),
        HasSubstr("is near the domain"));
}

TEST_F(PlaceCoordinates, FeetAreRefusedOrConverted) {
    // North Carolina in US survey feet: a square of a thousand feet.
    const std::string square =
        "[[[2000000, 700000], [2001000, 700000], [2001000, 701000], [2000000, 701000], [2000000, 700000]]]";
    const std::string outline = file("a.geojson", geojson("Polygon", square, "EPSG:2264"));
    EXPECT_THAT(error_in(model_text("outline_file = " + outline)), HasSubstr("is 0.304800609601219"));
    const SlopeModel model = slope(model_text("project = \"EPSG:32119\"\noutline_file = " + outline));
    EXPECT_NEAR(model.outline[1].x - model.outline[0].x, 304.8006, 1e-3);
    EXPECT_THAT(error_in(model_text("project = \"EPSG:2264\"\noutline = [[0, 0], [9, 0], [9, 9]]")),
                HasSubstr("is not in metres"));
    EXPECT_THAT(error_in(model_text("project = \"EPSG:4326\"\noutline = [[0, 0], [9, 0], [9, 9]]")),
                HasSubstr("is not in metres"));
    EXPECT_THAT(error_in(model_text("project = \"EPSG:99\"\noutline = [[0, 0], [9, 0], [9, 9]]")),
                HasSubstr("slope.toml:3:11: the coordinate system 'EPSG:99' is not known"));
}

/// A drawing of a square of 12000 units whose header states a unit by its number.
std::string drawing(const std::string& unit) {
    const std::string header =
        unit.empty() ? "" : "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + unit + "\n0\nENDSEC\n";
    return header +
           "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n12000\n20\n0\n10\n1"
           "2000\n"
           "20\n12000\n10\n0\n20\n12000\n0\nENDSEC\n0\nEOF\n";
}

TEST_F(PlaceCoordinates, DrawingsAreScaledByTheirUnit) {
    const struct {
        const char* unit;
        double width;
    } cases[] = {{"4", 12}, {"  5\r", 120}, {"2", 3657.6}, {"6", 12000}, {"0", 12000}, {"", 12000}};
    for (const auto& [unit, width] : cases) {
        const SlopeModel model = slope(model_text("outline_file = " + file("a.dxf", drawing(unit))));
        EXPECT_NEAR(model.outline[1].x, width, 1e-9) << unit;
        EXPECT_EQ(model.notes.size(), width == 12000 ? 0u : 1u) << unit;
    }
    const std::string path = file("a.dxf", drawing("4"));
    EXPECT_THAT(slope(model_text("outline_file = " + path)).notes,
                ElementsAre(HasSubstr("the drawing is in mm")));
    EXPECT_EQ(slope(model_text("unit = \"m\"\noutline_file = " + path)).outline[1].x, 12000);
    EXPECT_THAT(error_in(model_text("unit = \"cubit\"\noutline_file = " + path)),
                HasSubstr("the unit 'cubit' is not a length"));
    EXPECT_THAT(error_in(model_text("outline_file = " + file("b.dxf", drawing("77")))),
                HasSubstr("$INSUNITS is '77'"));
}

TEST_F(PlaceCoordinates, TracesFarFromTheDomainAreRefused) {
    const std::string path = file("a.csv", "x1,y1,x2,y2\n500,0,600,10\n700,0,800,9\n");
    EXPECT_THAT(error_in(model_text("outline = [[0, 0], [9, 0], [9, 9]]", "file = " + path)),
                AllOf(HasSubstr("slope.toml:6:8: no trace of"),
                      HasSubstr("they lie in (500, 0) to (800, 10), the domain in (0, 0) to (9, 9)")));
}

TEST_F(PlaceCoordinates, EmptyGeometriesAndHeightsAreCounted) {
    const std::string path = file("a.geojson",
                                  R"({"type": "FeatureCollection", "features": [
                 {"type": "Feature", "properties": {}, "geometry": null},
                 {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": []}},
                 {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[0, 1, 5], [9, 2, 6]]}}]})");
    const SlopeModel model = slope(model_text("outline = [[0, 0], [9, 0], [9, 9]]", "file = " + path));
    EXPECT_EQ(model.traces.size(), 1u);
    EXPECT_THAT(model.notes, ElementsAre(HasSubstr("2 empty geometries are skipped"),
                                         HasSubstr("the third coordinate of 1 geometries is ignored")));
}

}  // namespace
}  // namespace rockslope::blockgen::place_coordinates_test
