#include "blockgen/input/elevation_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "blockgen/input/gdal_library.hpp"
#include "common/base/input_error.hpp"
#include "common/base/magnitude.hpp"

namespace rockslope::blockgen {

namespace {

/// Points on the edge of the raster may be beyond it by so much of a cell, after rounding.
constexpr double edge_tolerance = 1e-6;

std::shared_ptr<void> opened(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) throw InputError({path}, "cannot be read", "a file");
    const GdalErrorSilencer silence;
    GDALDatasetH dataset =
        gdal().GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
    if (dataset == nullptr)
        throw InputError(
            {path}, "GDAL cannot read this file as a raster",
            "a profile: .csv, .geojson, .dxf, .shp, .gpkg, or an elevation model such as GeoTIFF");
    return {dataset, [](void* open) { gdal().GDALClose(open); }};
}

/// Whether GDAL's map from cells to coordinates has an inverse.
bool is_invertible(const double* place) {
    const double determinant = place[1] * place[5] - place[2] * place[4];
    return std::isfinite(place[0]) && std::isfinite(place[3]) && std::isfinite(determinant) &&
           determinant != 0;
}

std::string system_text(GDALDatasetH dataset) {
    OGRSpatialReferenceH system = gdal().GDALGetSpatialRef(dataset);
    if (system == nullptr) return {};
    char* text = nullptr;
    gdal().OSRExportToWkt(system, &text);
    std::string definition = text == nullptr ? "" : text;
    gdal().VSIFree(text);
    return definition;
}

}  // namespace

ElevationRaster::ElevationRaster(const std::filesystem::path& path)
    : path_(path.string()), dataset_(opened(path_)) {
    const GdalErrorSilencer silence;
    GDALDatasetH data = dataset_.get();
    if (const int bands = gdal().GDALGetRasterCount(data); bands != 1)
        throw InputError({path_}, "the raster has " + std::to_string(bands) + " bands",
                         "one band, of elevations");
    if (gdal().GDALGetGeoTransform(data, place_) != CE_None || !is_invertible(place_))
        throw InputError({path_}, "the raster has no place on the map", "a georeferenced raster");
    columns_ = gdal().GDALGetRasterXSize(data);
    rows_ = gdal().GDALGetRasterYSize(data);
    if (columns_ < 2 || rows_ < 2)
        throw InputError(
            {path_}, "the raster has " + std::to_string(columns_) + " by " + std::to_string(rows_) + " cells",
            "two columns and two rows or more");
    system_ = system_text(data);
    band_ = gdal().GDALGetRasterBand(data, 1);
    mask_ = gdal().GDALGetMaskBand(band_);
    unit_ = gdal().GDALGetRasterUnitType(band_);
    scale_ = gdal().GDALGetRasterScale(band_, nullptr);
    offset_ = gdal().GDALGetRasterOffset(band_, nullptr);
}

Ring ElevationRaster::corners() const {
    const auto corner = [this](double column, double row) {
        return Point{place_[0] + column * place_[1] + row * place_[2],
                     place_[3] + column * place_[4] + row * place_[5]};
    };
    return {corner(0, 0), corner(columns_, 0), corner(columns_, rows_), corner(0, rows_)};
}

Point ElevationRaster::cell_of(const Point& p) const {
    const double determinant = place_[1] * place_[5] - place_[2] * place_[4];
    const double x = p.x - place_[0], y = p.y - place_[3];
    return {(x * place_[5] - y * place_[2]) / determinant - 0.5,
            (y * place_[1] - x * place_[4]) / determinant - 0.5};
}

bool ElevationRaster::contains(const Point& p) const {
    const auto [u, v] = cell_of(p);
    return u >= -0.5 - edge_tolerance && u <= columns_ - 0.5 + edge_tolerance && v >= -0.5 - edge_tolerance &&
           v <= rows_ - 0.5 + edge_tolerance;
}

std::optional<double> ElevationRaster::elevation_at(const Point& p) const {
    const auto [u, v] = cell_of(p);
    const int column = std::clamp(static_cast<int>(std::floor(u)), 0, columns_ - 2);
    const int row = std::clamp(static_cast<int>(std::floor(v)), 0, rows_ - 2);
    std::array<double, 4> stored{};
    std::array<unsigned char, 4> is_known{};
    const GdalErrorSilencer silence;
    if (gdal().GDALRasterIO(band_, GF_Read, column, row, 2, 2, stored.data(), 2, 2, GDT_Float64, 0, 0) !=
            CE_None ||
        gdal().GDALRasterIO(mask_, GF_Read, column, row, 2, 2, is_known.data(), 2, 2, GDT_Byte, 0, 0) !=
            CE_None)
        throw InputError({path_},
                         "the raster cannot be read at column " + std::to_string(column + 1) + ", row " +
                             std::to_string(row + 1),
                         "an undamaged file");
    const double right = u - column, below = v - row;
    const std::array<double, 4> weights = {(1 - right) * (1 - below), right * (1 - below),
                                           (1 - right) * below, right * below};
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        if (weights[k] == 0) continue;
        if (is_known[k] == 0 || !is_in_allowed_range(stored[k])) return std::nullopt;
        sum += weights[k] * stored[k];
    }
    return scale_ * sum + offset_;
}

}  // namespace rockslope::blockgen
