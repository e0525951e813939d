// Profiles of the ground from elevation models written by GDAL.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "blockgen/input/coordinate_system.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/file_folder.hpp"
#include "unit/blockgen/slopes.hpp"

#include <cpl_conv.h>
#include <gdal.h>
#include <ogr_srs_api.h>

namespace rockslope::blockgen::dem_profile_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;
using Surface = std::function<double(double, double)>;

/// How a raster is written.
struct Raster {
    Surface elevation = [](double, double) { return 0.0; };  ///< at the centre of a cell
    int columns = 60, rows = 50;
    std::array<double, 6> place = {1000, 2, 0, 5100, 0, -2};  ///< GDAL's affine map from cells to coordinates
    bool has_place = true;
    std::string system = {};  ///< "EPSG:32634"
    std::string unit = {};
    double scale = 1, offset = 0;  ///< elevation = scale x stored value + offset
    int bands = 1;
    GDALDataType type = GDT_Float64;
};

constexpr double nodata = -9999;

class DemProfile : public FileFolder {
  protected:
    void SetUp() override {
        GDALAllRegister();
        FileFolder::SetUp();
    }

    /// Writes a GeoTIFF, or a grid in text when the name ends in .asc. NaN becomes the value for no data.
    fs::path write(const Raster& raster, const std::string& name = "dem.tif") {
        const fs::path path = folder_ / name;
        const bool is_text = path.extension() == ".asc";
        GDALDatasetH data =
            GDALCreate(GDALGetDriverByName(is_text ? "MEM" : "GTiff"), is_text ? "" : path.c_str(),
                       raster.columns, raster.rows, raster.bands, raster.type, nullptr);
        std::array<double, 6> place = raster.place;
        if (raster.has_place) GDALSetGeoTransform(data, place.data());
        if (!raster.system.empty()) {
            OGRSpatialReferenceH system = OSRNewSpatialReference(nullptr);
            EXPECT_EQ(OSRSetFromUserInput(system, raster.system.c_str()), OGRERR_NONE);
            OSRSetAxisMappingStrategy(system, OAMS_TRADITIONAL_GIS_ORDER);
            GDALSetSpatialRef(data, system);
            OSRDestroySpatialReference(system);
        }
        GDALRasterBandH band = GDALGetRasterBand(data, 1);
        GDALSetRasterNoDataValue(band, nodata);
        if (!raster.unit.empty()) GDALSetRasterUnitType(band, raster.unit.c_str());
        if (raster.scale != 1) GDALSetRasterScale(band, raster.scale);
        if (raster.offset != 0) GDALSetRasterOffset(band, raster.offset);
        for (int row = 0; row < raster.rows; ++row)
            for (int column = 0; column < raster.columns; ++column) {
                const double u = column + 0.5, v = row + 0.5;
                const double z = raster.elevation(place[0] + u * place[1] + v * place[2],
                                                  place[3] + u * place[4] + v * place[5]);
                double stored = std::isnan(z) ? nodata : (z - raster.offset) / raster.scale;
                EXPECT_EQ(GDALRasterIO(band, GF_Write, column, row, 1, 1, &stored, 1, 1, GDT_Float64, 0, 0),
                          CE_None);
            }
        if (is_text)
            GDALClose(GDALCreateCopy(GDALGetDriverByName("AAIGrid"), path.c_str(), data, FALSE, nullptr,
                                     nullptr, nullptr));
        GDALClose(data);
        return path;
    }
};

std::string model_text(const fs::path& path, const std::string& line, const std::string& keys = {}) {
    return "[domain]\nblock_material = \"rock\"\nprofile_file = \"" + path.string() + "\"\ndepth = 30\n" +
           keys + "\n[section]\n" + line + "\n";
}

/// The ground of a model, from left to right: its outline without the two corners below.
std::vector<Point> ground(const SlopeModel& model) {
    return {model.outline.rbegin(), model.outline.rend() - 2};
}

std::vector<Point> ground(const fs::path& path, const std::string& line, const std::string& keys = {}) {
    return ground(slope(model_text(path, line, keys)));
}

std::string error_with(const fs::path& path, const std::string& line, const std::string& keys = {}) {
    return error_of([&] { slope(model_text(path, line, keys)); });
}

/// Rises by 1 m in 4 eastwards and falls by 1 m in 8 northwards; numbers without rounding on whole metres.
double plane(double x, double y) {
    return 700 + (x - 1000) / 4 - (y - 5000) / 8;
}

/// 100 m in the direction (3, 4) / 5.
const std::string line = "from = [1020, 5010]\nto = [1080, 5090]";

TEST_F(DemProfile, APlaneGivesAStraightLineInBothFormats) {
    for (const char* name : {"dem.tif", "dem.asc"}) {
        Raster raster;
        raster.elevation = plane;
        const fs::path path = write(raster, name);
        const std::vector<Point> profile = ground(path, line);
        ASSERT_EQ(profile.size(), 51u) << name;  // one step for each cell of 2 m
        for (std::size_t k = 0; k < profile.size(); ++k) {
            EXPECT_NEAR(profile[k].x, 2.0 * double(k), 1e-12) << name;
            // Bilinear interpolation reproduces the plane; 1e-12 of 700 m and the rounding of the weights.
            EXPECT_NEAR(profile[k].y, plane(1020 + 0.6 * profile[k].x, 5010 + 0.8 * profile[k].x), 1e-9)
                << name << ' ' << k;
        }
        EXPECT_EQ(ground(path, line, "simplify = 1e-6").size(), 2u) << name;
        EXPECT_EQ(ground(path, line, "profile_step = 7").size(), 16u) << name;  // 15 steps of 6.67 m
        EXPECT_EQ(ground(path, line, "profile_step = 1e4").size(), 2u) << name;
    }
}

TEST_F(DemProfile, CellsMayBeRotatedScaledAndCutInHalfByTheEdge) {
    Raster raster;
    raster.elevation = plane;
    raster.place = {1000, 1.5, 1, 5000, -0.75, 2};  // turned and skewed
    raster.columns = raster.rows = 100;
    const std::string inside = "from = [1030, 5010]\nto = [1160, 5120]";
    for (const Point& p : ground(write(raster), inside)) {
        const double part = p.x / std::hypot(130, 110);
        EXPECT_NEAR(p.y, plane(1030 + 130 * part, 5010 + 110 * part), 1e-9);
    }
    // From one outer edge of the raster to the other: the surface goes on to the cells' edges.
    raster = {};
    raster.elevation = plane;
    const auto across = ground(write(raster), "from = [1000, 5000]\nto = [1120, 5100]");
    EXPECT_NEAR(across.front().y, plane(1000, 5000), 1e-9);
    EXPECT_NEAR(across.back().y, plane(1120, 5100), 1e-9);
    // Whole decimetres above 650 m in two bytes.
    raster.type = GDT_Int16;
    raster.scale = 0.125;
    raster.offset = 650;
    EXPECT_NEAR(ground(write(raster), line)[10].y, plane(1032, 5026), 1e-9);
}

/// The error of bilinear interpolation is at most h^2 (|z_xx| + |z_yy|) / 8, and falls with the square of the
/// cell. On a cone of slope s both second derivatives are of one sign and add up to s / r, with r the
/// distance from the summit.
TEST_F(DemProfile, AConicalHillIsApproximatedInSecondOrder) {
    const double s = 0.8;
    const auto hill = [&](double x, double y) { return 900 - s * std::hypot(x - 1050, y - 5050); };
    // 20 m beside the summit.
    const std::string beside = "from = [1010, 5030]\nto = [1090, 5030]";
    std::vector<double> errors;
    for (const double h : {4.0, 2.0, 1.0}) {
        Raster raster;
        raster.elevation = hill;
        raster.columns = raster.rows = int(100 / h);
        raster.place = {1000, h, 0, 5100, 0, -h};
        double most = 0;
        for (const Point& p : ground(write(raster), beside, "profile_step = 0.1"))
            most = std::max(most, std::abs(p.y - hill(1010 + p.x, 5030)));
        EXPECT_LE(most, h * h * s / (20 - h) / 8) << h;
        errors.push_back(most);
    }
    // The largest error moves with the cells, so that the order is 2 within 0.03; a first-order scheme has 1.
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.05);
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.05);
}

TEST_F(DemProfile, PlacesWithoutAnElevationAreRefused) {
    Raster raster;
    // A hole of two by two cells round (1050, 5050).
    raster.elevation = [](double x, double y) {
        return std::max(std::abs(x - 1050), std::abs(y - 5050)) < 2 ? std::nan("") : plane(x, y);
    };
    for (const char* name : {"dem.tif", "dem.asc"}) {
        const fs::path path = write(raster, name);
        // The first point within one cell of the hole is 1044 + 3.
        EXPECT_THAT(
            error_with(path, "from = [1004, 5050]\nto = [1104, 5050]", "profile_step = 1"),
            AllOf(HasSubstr(name), HasSubstr("no elevation at (1048, 5050), 44 m along the section line")));
        // The corner cells of the hole have centres at 1049 and 5049: a line along centres beside it is not
        // touched.
        EXPECT_EQ(ground(path, "from = [1005, 5047]\nto = [1105, 5047]").size(), 51u) << name;
    }
}

TEST_F(DemProfile, LinesThatLeaveTheRasterAreRefusedWithBothExtents) {
    Raster raster;
    raster.elevation = plane;
    const fs::path path = write(raster);
    EXPECT_THAT(error_with(path, "from = [1020, 5010]\nto = [1130, 5090]"),
                AllOf(HasSubstr("slope.toml:3:16: "),
                      HasSubstr("it runs from (1020, 5010) to (1130, 5090), the raster from (1000, 5000) to "
                                "(1120, 5100)")));
    EXPECT_THAT(error_with(path, "from = [0, 0]\nto = [3, 4]"), HasSubstr("leaves the raster"));
    EXPECT_THAT(error_with(path, "azimuth = \"0 deg\""), HasSubstr("no section line"));
    EXPECT_THAT(error_with(path, line, "profile_step = 0"), HasSubstr("a positive distance"));
    EXPECT_THAT(error_with(path, line, "profile_step = 1e-5"), HasSubstr("would have 10000000 points"));
}

TEST_F(DemProfile, OtherRastersAreRefused) {
    Raster picture;
    picture.bands = 3;
    EXPECT_THAT(error_with(write(picture), line), HasSubstr("the raster has 3 bands"));
    Raster strip;
    strip.rows = 1;
    EXPECT_THAT(error_with(write(strip), line), HasSubstr("60 by 1 cells"));
    Raster nowhere;
    nowhere.has_place = false;
    EXPECT_THAT(error_with(write(nowhere), line), HasSubstr("no place on the map"));
    written("nan.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize nan\n1 2\n3 4\n");
    EXPECT_THAT(error_with(folder_ / "nan.asc", line), HasSubstr("no place on the map"));
    written("text.tif", "elevations");
    EXPECT_THAT(error_with(folder_ / "text.tif", line), HasSubstr("cannot read this file as a raster"));
    EXPECT_THAT(error_with(folder_ / "none.tif", line), HasSubstr("none.tif"));
    // The first half of a file.
    Raster raster;
    raster.elevation = plane;
    const fs::path path = write(raster);
    fs::resize_file(path, fs::file_size(path) / 2);
    EXPECT_THAT(error_with(path, line), AllOf(HasSubstr("dem.tif"), testing::Not(HasSubstr("no error"))));
}

/// A raster near Turku in degrees, a plane in longitude and latitude.
Raster degrees_raster() {
    Raster raster;
    raster.place = {22.19, 1e-4, 0, 60.41, 0, -1e-4};
    raster.columns = raster.rows = 200;
    raster.elevation = [](double longitude, double latitude) {
        return 100 + 5000 * (longitude - 22.2) + 9000 * (latitude - 60.4);
    };
    return raster;
}

TEST_F(DemProfile, DegreesAreRefusedOrTheLineIsConverted) {
    const std::string metres = "from = [566000, 6696500]\nto = [566300, 6696900]";
    for (const char* system : {"EPSG:4326", ""}) {
        Raster raster = degrees_raster();
        raster.system = system;
        const fs::path path = write(raster);
        EXPECT_THAT(error_with(path, metres), HasSubstr("degrees")) << system;
        const SlopeModel model = slope(model_text(path, metres, "project = \"EPSG:32634\""));
        const std::vector<Point> profile = ground(model);
        ASSERT_GT(profile.size(), 30u);
        const CoordinateSystem utm("EPSG:32634", {}), geographic("OGC:CRS84", {});
        for (const Point& p : profile) {
            std::vector<Point> place = {model.section->line.at(p.x)};
            utm.convert(place, geographic, {});
            EXPECT_NEAR(p.y, raster.elevation(place[0].x, place[0].y), 1e-6);
        }
        EXPECT_THAT(
            error_with(path, "from = [566000, 6696500]\nto = [568300, 6696900]", "project = \"EPSG:32634\""),
            AllOf(HasSubstr("leaves the raster"), HasSubstr("the raster from (22.19, 60.39)")))
            << system;
    }
}

TEST_F(DemProfile, SystemsAreThoseOfTheOtherFiles) {
    Raster raster;
    raster.elevation = plane;
    raster.system = "EPSG:32634";
    const fs::path path = write(raster);
    EXPECT_THAT(slope(model_text(path, line)).system.name(), HasSubstr("EPSG:32634"));
    EXPECT_EQ(ground(path, line, "crs = \"local\"").size(), 51u);
    EXPECT_THAT(error_with(path, line, "crs = \"EPSG:2263\""), HasSubstr("a unit of"));
    EXPECT_THAT(slope(model_text(path, line)).notes, IsEmpty());
}

TEST_F(DemProfile, ElevationsInFeetAreConverted) {
    constexpr double foot = 0.3048, us_foot = 1200.0 / 3937;
    Raster raster;
    raster.elevation = plane;
    raster.system = "EPSG:32634";
    const auto first_with = [&](const std::string& keys) { return ground(write(raster), line, keys)[0].y; };
    const double stored = plane(1020, 5010);
    EXPECT_NEAR(first_with(""), stored, 1e-9);
    EXPECT_NEAR(first_with("unit = \"ft\""), stored * foot, 1e-9);
    for (const auto& [unit, metres] :
         {std::pair{"ft", foot}, {"m", 1.0}, {"metre", 1.0}, {"US survey foot", us_foot}}) {
        raster.unit = unit;
        EXPECT_NEAR(first_with(""), stored * metres, 1e-9) << unit;
        EXPECT_NEAR(first_with("unit = \"m\""), stored, 1e-9) << unit;
        EXPECT_EQ(slope(model_text(write(raster), line)).notes.size(), metres == 1 ? 0u : 1u) << unit;
    }
    raster.unit = "fathom";
    EXPECT_THAT(error_with(write(raster), line),
                AllOf(HasSubstr("the unit 'fathom'"), HasSubstr("unit = one of")));
    // The unit of the system's vertical part: NAVD88 height (ftUS).
    raster.unit = "";
    raster.system = "EPSG:32634+6360";
    EXPECT_NEAR(first_with(""), stored * us_foot, 1e-9);
    EXPECT_THAT(slope(model_text(write(raster), line)).system.name(), HasSubstr("EPSG:32634 (WGS 84"));
}

TEST_F(DemProfile, MapsInFeetMustSayWhatElevationsAreIn) {
    Raster raster;
    raster.elevation = plane;
    raster.system = "EPSG:2263";  // New York Long Island, US survey feet
    raster.place = {980000, 6, 0, 200300, 0, -6};
    const fs::path path = write(raster);
    const std::vector<Point> feet = {{980060, 200060}, {980300, 200240}};
    std::vector<Point> metres = feet;
    CoordinateSystem("EPSG:2263", {}).convert(metres, CoordinateSystem("EPSG:32618", {}), {});
    const auto text = [](const Point& p) {
        return "[" + std::to_string(p.x) + ", " + std::to_string(p.y) + "]";
    };
    const std::string section = "from = " + text(metres[0]) + "\nto = " + text(metres[1]);
    EXPECT_THAT(error_with(path, section), HasSubstr("a unit of EPSG:2263"));
    const std::string project = "project = \"EPSG:32618\"\n";
    EXPECT_THAT(error_with(path, section, project), HasSubstr("the unit of the elevations is not stated"));
    const std::vector<Point> profile = ground(path, section, project + "unit = \"us-ft\"");
    // 300 feet, on a map whose scale is 1 within a thousandth, and steps of one cell of 6 feet.
    EXPECT_NEAR(profile.back().x, 300 * 0.3048, 0.1);
    EXPECT_EQ(profile.size(), 51u);
    // The line's ends are given to a micrometre.
    EXPECT_NEAR(profile.back().y, plane(feet[1].x, feet[1].y) * 1200 / 3937, 1e-5);
}

/// A valley side from a raster, cut by a joint parallel to the ground.
TEST_F(DemProfile, ASlopeOfARasterIsCut) {
    Raster raster;
    raster.elevation = [](double x, double) { return x < 1060 ? 80.0 : 80 - (x - 1060); };
    const std::string joint = "[[traces]]\njoint_material = \"fault\"\npoints = [[-1, 60], [101, 60]]\n";
    const CutResult result = cut(slope(
        model_text(write(raster), "from = [1010, 5050]\nto = [1110, 5050]", "simplify = 1e-3") + joint));
    EXPECT_EQ(result.report.blocks, 2u);
    // The ground falls below 60 m at x = 1080, 70 m along the line; the cells round the crest flatten it.
    EXPECT_NEAR(result.report.joints[0].retained, 70, 1e-3);
}

}  // namespace
}  // namespace rockslope::blockgen::dem_profile_test
