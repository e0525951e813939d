// GeoPackage, Shapefile and DXF files written by GDAL are read back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "blockgen/input/geometry_file.hpp"
#include "common/base/input_error.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

#include <cpl_error.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

namespace rockslope::blockgen::gdal_formats_test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

struct Shape {
    std::string text;  ///< well-known text
    std::string joint_material;
};

/// A file of one layer in a format of GDAL. Tests run concurrently in separate processes.
class Format {
  public:
    Format(const char* driver, const std::string& extension, int zone = 35)
        : folder_(fs::path(testing::TempDir()) / ("gdal_formats_" + std::to_string(::getpid()))),
          path_(folder_ / ("map" + extension)) {
        GDALAllRegister();
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        is_drawing_ = extension == ".dxf";
        data_ = GDALCreate(GDALGetDriverByName(driver), path_.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
        system_ = OSRNewSpatialReference(nullptr);
        OSRSetWellKnownGeogCS(system_, "WGS84");
        if (zone > 0) OSRSetUTM(system_, zone, 1);
        layer_ = GDALDatasetCreateLayer(data_, is_drawing_ ? "entities" : "map",
                                        is_drawing_ ? nullptr : system_, wkbUnknown, nullptr);
        if (is_drawing_ || layer_ == nullptr) return;
        OGRFieldDefnH field = OGR_Fld_Create("joint_material", OFTString);
        CPLPushErrorHandler(CPLQuietErrorHandler);  // a Shapefile shortens the name and says so
        OGR_L_CreateField(layer_, field, TRUE);
        CPLPopErrorHandler();
        OGR_Fld_Destroy(field);
    }
    ~Format() {
        OSRDestroySpatialReference(system_);
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Format(const Format&) = delete;
    Format& operator=(const Format&) = delete;

    /// Writes the shapes and closes the file. @return its path.
    fs::path with(const std::vector<Shape>& shapes) {
        EXPECT_NE(layer_, nullptr);
        for (const Shape& shape : shapes) {
            OGRFeatureH feature = OGR_F_Create(OGR_L_GetLayerDefn(layer_));
            OGRGeometryH geometry = nullptr;
            std::string text = shape.text;
            char* rest = text.data();
            EXPECT_EQ(OGR_G_CreateFromWkt(&rest, nullptr, &geometry), OGRERR_NONE) << shape.text;
            OGR_F_SetGeometryDirectly(feature, geometry);
            const char* name = is_drawing_ ? "Layer" : nullptr;
            const int index = name != nullptr ? OGR_F_GetFieldIndex(feature, name) : 0;
            if (!shape.joint_material.empty())
                OGR_F_SetFieldString(feature, index, shape.joint_material.c_str());
            EXPECT_EQ(OGR_L_CreateFeature(layer_, feature), OGRERR_NONE);
            OGR_F_Destroy(feature);
        }
        GDALClose(data_);
        return path_;
    }

  private:
    fs::path folder_, path_;
    bool is_drawing_ = false;
    GDALDatasetH data_ = nullptr;
    OGRSpatialReferenceH system_ = nullptr;
    OGRLayerH layer_ = nullptr;
};

const std::vector<Shape> lines = {
    {"LINESTRING (466000.25 6691582.5, 466010 6691590, 466012.5 6691600)", "fault"},
    {"LINESTRING (466001 6691582, 466002 6691599)", ""}};

void expect_lines(const std::vector<Trace>& traces, const std::string& second_material) {
    ASSERT_EQ(traces.size(), 2u);
    EXPECT_EQ(traces[0].joint_material, "fault");
    EXPECT_EQ(traces[0].points,
              (std::vector<Point>{{466000.25, 6691582.5}, {466010, 6691590}, {466012.5, 6691600}}));
    EXPECT_EQ(traces[1].joint_material, second_material);
    EXPECT_EQ(traces[1].points, (std::vector<Point>{{466001, 6691582}, {466002, 6691599}}));
}

TEST(GdalFormats, TracesOfAGeoPackage) {
    Format format("GPKG", ".gpkg");
    const fs::path path = format.with(lines);
    expect_lines(read_trace_file(path, "map", "joint"), "joint");
    expect_lines(read_trace_file(path, "map", ""), "map");  // the layer's name
}

TEST(GdalFormats, TracesOfAShapefileWithItsShortenedField) {
    Format format("ESRI Shapefile", ".shp");
    expect_lines(read_trace_file(format.with(lines), "map", "joint"), "joint");
}

TEST(GdalFormats, TracesOfADrawingByLayer) {
    Format format("DXF", ".dxf");
    const std::vector<Trace> traces = read_trace_file(format.with(lines), "map", "");
    ASSERT_EQ(traces.size(), 2u);
    EXPECT_EQ(traces[0].joint_material, "fault");
    ASSERT_EQ(traces[0].points.size(), 3u);
    EXPECT_NEAR(traces[0].points[0].x, 466000.25, 1e-6);  // DXF holds 15 digits
    EXPECT_NEAR(traces[0].points[2].y, 6691600, 1e-6);
    EXPECT_EQ(traces[1].joint_material, "0");  // the default layer
}

TEST(GdalFormats, CurvesAndCollectionsBecomeLines) {
    Format format("GPKG", ".gpkg");
    const std::vector<Trace> traces =
        read_trace_file(format.with({{"CIRCULARSTRING (0 0, 1 1, 2 0)", "arc"},
                                     {"MULTILINESTRING ((0 0, 1 0), (0 1, 1 1))", "pair"},
                                     {"POINT (3 3)", "point"}}),
                        "map", "joint");
    ASSERT_EQ(traces.size(), 3u);
    EXPECT_GT(traces[0].points.size(), 20u);
    for (const Point& p : traces[0].points) EXPECT_NEAR(std::hypot(p.x - 1, p.y), 1, 1e-9);
    EXPECT_EQ(traces[1].points.size(), 2u);
    EXPECT_EQ(traces[2].joint_material, "pair");
}

TEST(GdalFormats, OutlinesWithHolesAndParts) {
    const std::string multi =
        "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1)), ((6 0, 9 0, 9 4, 6 0)))";
    for (const auto& [driver, extension] :
         {std::pair("GPKG", ".gpkg"), std::pair("ESRI Shapefile", ".shp")}) {
        Format format(driver, extension);
        const auto parts = read_outline_file(format.with({{multi, ""}}));
        ASSERT_EQ(parts.size(), 2u) << driver;
        ASSERT_EQ(parts[0].size(), 2u) << driver;
        EXPECT_EQ(std::abs(twice_signed_area(parts[0][0])), 32) << driver;
        EXPECT_EQ(std::abs(twice_signed_area(parts[0][1])), 2) << driver;
        EXPECT_EQ(std::abs(twice_signed_area(parts[1][0])), 12) << driver;
    }
}

TEST(GdalFormats, ClosedLinesOfADrawingAreParts) {
    Format format("DXF", ".dxf");
    const auto parts = read_outline_file(
        format.with({{"LINESTRING (0 0, 4 0, 4 4, 0 0)", ""}, {"LINESTRING (6 0, 9 0, 9 4, 6 0)", ""}}));
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(twice_signed_area(parts[1][0]), 12);
}

TEST(GdalFormats, LinesOfADrawingThatFormAChainAreAnOutlineAndThoseInsideAreItsHoles) {
    Format format("DXF", ".dxf");
    const auto parts = read_outline_file(format.with({{"LINESTRING (0 0, 9 0)", ""},
                                                      {"LINESTRING (9 8, 9 0)", ""},
                                                      {"LINESTRING (9 8, 0 0)", ""},
                                                      {"LINESTRING (6 1, 8 1, 8 2, 6 1)", ""}}));
    ASSERT_EQ(parts.size(), 1u);
    ASSERT_EQ(parts[0].size(), 2u);
    EXPECT_EQ(std::abs(twice_signed_area(parts[0][0])), 72);
    EXPECT_EQ(std::abs(twice_signed_area(parts[0][1])), 2);
}

std::string error_of_outline(const fs::path& path) {
    return error_of([&] { read_outline_file(path); });
}
std::string error_of_traces(const fs::path& path) {
    return error_of([&] { read_trace_file(path, "map", "joint"); });
}

TEST(GdalFormats, OpenOutlinesAndEmptyFilesAreRefused) {
    Format open("GPKG", ".gpkg");
    EXPECT_THAT(error_of_outline(open.with(lines)), HasSubstr("not closed"));
    Format empty("GPKG", ".gpkg");
    const fs::path path = empty.with({});
    EXPECT_THAT(error_of_outline(path), HasSubstr("no polygon"));
    EXPECT_THAT(error_of_traces(path), HasSubstr("no trace"));
}

std::string model_text(const std::string& domain, const fs::path& traces) {
    return "[domain]\nblock_material = \"rock\"\n" + domain +
           "\n[[traces]]\njoint_material = \"joint\"\nfile = \"" + traces.string() + "\"\n";
}

TEST(GdalFormats, SystemsAreTheirOwn) {
    const std::string outline =
        "outline = [[465990, 6691570], [466020, 6691570], [466020, 6691610], [465990, 6691610]]";
    for (const auto& [driver, extension] :
         {std::pair("GPKG", ".gpkg"), std::pair("ESRI Shapefile", ".shp")}) {
        Format degrees(driver, extension, 0);
        EXPECT_THAT(error_of([&] { slope(model_text(outline, degrees.with(lines))); }),
                    HasSubstr("the coordinates are in degrees"))
            << driver;
        Format metres(driver, extension);
        const fs::path path = metres.with(lines);
        EXPECT_EQ(slope(model_text(outline, path)).traces.size(), 2u) << driver;
        // The system of the file is that of the project, and a neighbouring zone is converted to it.
        EXPECT_EQ(slope(model_text("project = \"EPSG:32635\"\n" + outline, path)).traces[0].points[0],
                  (Point{466000.25, 6691582.5}))
            << driver;
        EXPECT_THAT(error_of([&] { slope(model_text("project = \"EPSG:32634\"\n" + outline, path)); }),
                    HasSubstr("is near the domain"))
            << driver;
    }
}

TEST(GdalFormats, HeightsAndEmptyGeometriesAreCounted) {
    Format format("GPKG", ".gpkg");
    MapNotes notes;
    const auto traces = read_trace_file(
        format.with(
            {{"LINESTRING Z (0 0 5, 1 1 6)", ""}, {"LINESTRING EMPTY", ""}, {"LINESTRING (0 0, 1 0)", ""}}),
        "map", "joint", &notes);
    EXPECT_EQ(traces.size(), 2u);
    EXPECT_EQ(notes.empty, 1u);
    EXPECT_EQ(notes.with_heights, 1u);
}

}  // namespace
}  // namespace rockslope::blockgen::gdal_formats_test
