// Mapped traces with their orientations, from files written by GDAL, and a slope of an elevation model that
// they cut.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "unit/blockgen/file_folder.hpp"
#include "unit/blockgen/slopes.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

namespace rockslope::blockgen::map_traces_test {
namespace {

namespace fs = std::filesystem;

constexpr double degree = std::numbers::pi / 180;

/// A mapped trace, as well-known text, and its plane in degrees.
struct Mapped {
    std::string text;
    double dip, dip_direction;
};

class MapTraces : public FileFolder {
  protected:
    void SetUp() override {
        GDALAllRegister();
        FileFolder::SetUp();
        OSRSetFromUserInput(system_, "EPSG:3067");
    }
    void TearDown() override {
        OSRDestroySpatialReference(system_);
        FileFolder::TearDown();
    }

    /// A file of traces with the fields dip and dip_direction.
    fs::path traces(const char* driver, const std::string& extension, const std::vector<Mapped>& mapped) {
        const fs::path path = folder_ / ("traces" + extension);
        GDALDatasetH data =
            GDALCreate(GDALGetDriverByName(driver), path.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
        OGRLayerH layer = GDALDatasetCreateLayer(data, "traces", system_, wkbLineString25D, nullptr);
        CPLPushErrorHandler(CPLQuietErrorHandler);  // a Shapefile shortens the name and says so
        for (const char* name : {"dip", "dip_direction"}) {
            OGRFieldDefnH field = OGR_Fld_Create(name, OFTReal);
            OGR_L_CreateField(layer, field, TRUE);
            OGR_Fld_Destroy(field);
        }
        CPLPopErrorHandler();
        for (const Mapped& trace : mapped) {
            OGRFeatureH feature = OGR_F_Create(OGR_L_GetLayerDefn(layer));
            OGRGeometryH geometry = nullptr;
            std::string text = trace.text;
            char* rest = text.data();
            EXPECT_EQ(OGR_G_CreateFromWkt(&rest, nullptr, &geometry), OGRERR_NONE);
            OGR_F_SetGeometryDirectly(feature, geometry);
            OGR_F_SetFieldDouble(feature, 0, trace.dip);
            OGR_F_SetFieldDouble(feature, 1, trace.dip_direction);
            EXPECT_EQ(OGR_L_CreateFeature(layer, feature), OGRERR_NONE);
            OGR_F_Destroy(feature);
        }
        GDALClose(data);
        return path;
    }

    /// A GeoTIFF of 200 m by 100 m with cells of 2 m: a hillside that dips eastwards by 30 degrees.
    fs::path hillside() {
        const fs::path path = folder_ / "hillside.tif";
        GDALDatasetH data =
            GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), 100, 50, 1, GDT_Float64, nullptr);
        std::array<double, 6> place = {466000, 2, 0, 6691600, 0, -2};
        GDALSetGeoTransform(data, place.data());
        GDALSetSpatialRef(data, system_);
        for (int row = 0; row < 50; ++row)
            for (int column = 0; column < 100; ++column) {
                double z = ground(466000 + 2 * column + 1);
                EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(data, 1), GF_Write, column, row, 1, 1, &z, 1, 1,
                                       GDT_Float64, 0, 0),
                          CE_None);
            }
        GDALClose(data);
        return path;
    }

    static double ground(double x) { return 300 - std::tan(30 * degree) * (x - 466000); }

    OGRSpatialReferenceH system_ = OSRNewSpatialReference(nullptr);
};

/// A section eastwards over the hillside; a bed that daylights and a joint that dips into it.
TEST_F(MapTraces, CutAHillsideFromAnElevationModel) {
    const std::vector<Mapped> mapped = {{"LINESTRING Z (466110 6691570 1, 466110 6691530 2)", 20, 90},
                                        {"LINESTRING Z (466050 6691570 3, 466050 6691555 4)", 75, 270}};
    const fs::path dem = hillside();
    for (const auto& [driver, extension] :
         {std::pair("GPKG", ".gpkg"), std::pair("ESRI Shapefile", ".shp")}) {
        const SlopeModel model = slope(
            "[domain]\nblock_material = \"rock\"\nprofile_file = \"" + dem.string() +
            "\"\nbottom = 150\n[section]\nfrom = [466020, 6691550]\nto = [466180, 6691550]\n"
            "[[traces]]\nname = \"mapped\"\njoint_material = \"joint\"\non = \"map\"\nreach = 5\nfile = \"" +
            traces(driver, extension, mapped).string() + "\"\n");
        ASSERT_EQ(model.traces.size(), 2u) << driver;
        const auto height_at = [&](std::size_t k, double x) {
            const Point &a = model.traces[k].points[0], &b = model.traces[k].points[1];
            return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
        };
        // At the ground over 90 m and 30 m of the section, along the dip; coordinates are rounded to 1e-9 m.
        EXPECT_NEAR(height_at(0, 90), ground(466110), 1e-7) << driver;
        EXPECT_NEAR(height_at(0, 0), ground(466110) + 90 * std::tan(20 * degree), 1e-7) << driver;
        EXPECT_NEAR(height_at(1, 30), ground(466050), 1e-7) << driver;
        EXPECT_NEAR(height_at(1, 29), ground(466050) - std::tan(75 * degree), 1e-6) << driver;
        // The bed daylights: it runs through the rock from its outcrop up to the left side of the section.
        // The joint dips into the hill and crosses the bed, so that there are four blocks.
        const CutResult result = cut(model);
        EXPECT_EQ(result.report.blocks, 4u) << driver;
        EXPECT_NEAR(result.report.domain_area, 160 * (ground(466100) - 150), 1e-6) << driver;
    }
}

}  // namespace
}  // namespace rockslope::blockgen::map_traces_test
