#include "blockgen/input/gdal_file.hpp"

#include "common/base/input_error.hpp"
#include "common/base/magnitude.hpp"

#ifdef BLOCKGEN_HAS_GDAL
#include <cpl_error.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <functional>
#include <memory>
#endif

namespace rockslope::blockgen {

#ifdef BLOCKGEN_HAS_GDAL

namespace {

/// Keeps GDAL from writing to the standard error stream.
class GdalErrorSilencer {
  public:
    GdalErrorSilencer() { CPLPushErrorHandler(CPLQuietErrorHandler); }
    ~GdalErrorSilencer() { CPLPopErrorHandler(); }
    GdalErrorSilencer(const GdalErrorSilencer&) = delete;
    GdalErrorSilencer& operator=(const GdalErrorSilencer&) = delete;
};

using Dataset = std::unique_ptr<void, decltype(&GDALClose)>;
using Feature = std::unique_ptr<std::remove_pointer_t<OGRFeatureH>, decltype(&OGR_F_Destroy)>;
using Geometry = std::unique_ptr<std::remove_pointer_t<OGRGeometryH>, decltype(&OGR_G_DestroyGeometry)>;

class GdalReader {
  public:
    explicit GdalReader(const std::filesystem::path& path) : place_{path.string()} {
        GDALAllRegister();
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) throw InputError(place_, "cannot be read", "a file");
        dataset_ = Dataset(
            GDALOpenEx(place_.file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr),
            &GDALClose);
        if (!dataset_)
            throw InputError(place_, "GDAL cannot read this file", "a vector file such as DXF or GeoPackage");
    }

    /// Calls visit(geometry, feature, layer name) for each feature with a geometry. Curves are linearised.
    template <class Visit>
    void visit_features(const Visit& visit) {
        for (int k = 0; k < GDALDatasetGetLayerCount(dataset_.get()); ++k) {
            OGRLayerH layer = GDALDatasetGetLayer(dataset_.get(), k);
            OGRSpatialReferenceH system = OGR_L_GetSpatialRef(layer);
            if (system != nullptr && OSRIsGeographic(system))
                throw InputError(place_, "the coordinates are in degrees",
                                 "coordinates in metres: a projected reference system");
            OGR_L_ResetReading(layer);
            while (const Feature feature{OGR_L_GetNextFeature(layer), &OGR_F_Destroy}) {
                OGRGeometryH shape = OGR_F_GetGeometryRef(feature.get());
                if (shape == nullptr) continue;
                const Geometry straight{OGR_G_GetLinearGeometry(shape, 0, nullptr), &OGR_G_DestroyGeometry};
                if (straight) visit(straight.get(), feature.get(), std::string(OGR_L_GetName(layer)));
            }
        }
    }

    /// Calls visit(points) for each line and ring of a geometry.
    void visit_lines(OGRGeometryH shape, const std::function<void(std::vector<Point>)>& visit) const {
        const OGRwkbGeometryType type = wkbFlatten(OGR_G_GetGeometryType(shape));
        if (type == wkbLineString || type == wkbLinearRing) {
            std::vector<Point> points;
            for (int k = 0; k < OGR_G_GetPointCount(shape); ++k) {
                points.push_back({OGR_G_GetX(shape, k), OGR_G_GetY(shape, k)});
                if (!is_in_allowed_range(points.back().x) || !is_in_allowed_range(points.back().y))
                    throw InputError(place_, "a coordinate is too large", "coordinates in metres");
            }
            if (points.size() >= 2) visit(std::move(points));
            return;
        }
        for (int k = 0; k < OGR_G_GetGeometryCount(shape); ++k)
            visit_lines(OGR_G_GetGeometryRef(shape, k), visit);
    }

    const SourceLocation& place() const { return place_; }

  private:
    GdalErrorSilencer error_silencer_;
    SourceLocation place_;
    Dataset dataset_{nullptr, &GDALClose};
};

std::string field_of(OGRFeatureH feature, const char* name) {
    const int index = OGR_F_GetFieldIndex(feature, name);
    if (index < 0 || !OGR_F_IsFieldSetAndNotNull(feature, index)) return {};
    return OGR_F_GetFieldAsString(feature, index);
}

}  // namespace

bool has_gdal() {
    return true;
}

std::vector<GdalLine> read_gdal_lines(const std::filesystem::path& path) {
    GdalReader reader(path);
    std::vector<GdalLine> lines;
    reader.visit_features([&](OGRGeometryH shape, OGRFeatureH feature, const std::string& layer) {
        const std::string drawn_on = field_of(feature, "Layer");
        // A Shapefile truncates field names to ten letters.
        std::string material = field_of(feature, "joint_material");
        if (material.empty()) material = field_of(feature, "joint_mate");
        reader.visit_lines(shape, [&](std::vector<Point> points) {
            lines.push_back({material, drawn_on.empty() ? layer : drawn_on, std::move(points)});
        });
    });
    return lines;
}

std::vector<std::vector<Ring>> read_gdal_polygons(const std::filesystem::path& path) {
    GdalReader reader(path);
    std::vector<std::vector<Ring>> polygons;
    const std::function<void(OGRGeometryH)> add = [&](OGRGeometryH shape) {
        const OGRwkbGeometryType type = wkbFlatten(OGR_G_GetGeometryType(shape));
        const bool is_one = type == wkbPolygon || type == wkbLineString || type == wkbLinearRing;
        if (is_one) polygons.emplace_back();
        for (int k = 0; !is_one && k < OGR_G_GetGeometryCount(shape); ++k)
            add(OGR_G_GetGeometryRef(shape, k));
        if (!is_one) return;
        reader.visit_lines(shape, [&](std::vector<Point> points) {
            if (!(points.front() == points.back()))
                throw InputError(reader.place(), "a line that is not closed", "closed lines or polygons");
            polygons.back().push_back(std::move(points));
        });
        if (polygons.back().empty()) polygons.pop_back();
    };
    reader.visit_features([&](OGRGeometryH shape, OGRFeatureH, const std::string&) { add(shape); });
    if (polygons.empty()) throw InputError(reader.place(), "no polygon", "closed lines or polygons");
    return polygons;
}

#else

namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
    throw InputError({path.string()}, "this blockgen was built without GDAL, which reads files of this type",
                     ".csv or .geojson");
}

}  // namespace

bool has_gdal() {
    return false;
}

std::vector<GdalLine> read_gdal_lines(const std::filesystem::path& path) {
    fail(path);
}

std::vector<std::vector<Ring>> read_gdal_polygons(const std::filesystem::path& path) {
    fail(path);
}

#endif

}  // namespace rockslope::blockgen
