#include "blockgen/input/coordinate_system.hpp"

#include <cmath>
#include <memory>

#include "blockgen/input/gdal_library.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

struct SystemDeleter {
    void operator()(void* system) const { gdal().OSRDestroySpatialReference(system); }
};
using System = std::unique_ptr<void, SystemDeleter>;

struct TransformationDeleter {
    void operator()(void* transformation) const { gdal().OCTDestroyCoordinateTransformation(transformation); }
};
using Transformation = std::unique_ptr<void, TransformationDeleter>;

/// Nothing when PROJ does not know the system.
System parsed(const std::string& text) {
    const GdalErrorSilencer silence;
    System system(gdal().OSRNewSpatialReference(nullptr));
    if (gdal().OSRSetFromUserInput(system.get(), text.c_str()) != OGRERR_NONE) return nullptr;
    gdal().OSRSetAxisMappingStrategy(system.get(), OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

std::string text_or_empty(const char* text) {
    return text == nullptr ? std::string() : std::string(text);
}

/// The authority and the number of a system between which a text stands; empty for a system without a number.
std::string code_of(void* system, const std::string& between) {
    const std::string code = text_or_empty(gdal().OSRGetAuthorityCode(system, nullptr));
    return code.empty() ? "" : text_or_empty(gdal().OSRGetAuthorityName(system, nullptr)) + between + code;
}

std::string name_of(void* system) {
    const std::string name = text_or_empty(gdal().OSRGetName(system)), code = code_of(system, ":");
    return code.empty() ? name : code + " (" + name + ")";
}

std::string definition_of(void* system) {
    char* text = nullptr;
    gdal().OSRExportToWkt(system, &text);
    std::string definition = text_or_empty(text);
    gdal().VSIFree(text);
    return definition;
}

}  // namespace

CoordinateSystem::CoordinateSystem(const std::string& text, const SourceLocation& place) {
    const System system = parsed(text);
    if (!system)
        throw InputError(place, "the coordinate system '" + text.substr(0, 60) + "' is not known",
                         "one such as \"EPSG:32634\"");
    const GdalErrorSilencer silence;
    if (gdal().OSRIsCompound(system.get()) != 0) {
        states_heights_ = true;
        metres_per_height_unit_ = gdal().OSRGetTargetLinearUnits(system.get(), "VERT_CS", nullptr);
        gdal().OSRStripVertical(system.get());
    }
    definition_ = definition_of(system.get());
    name_ = name_of(system.get());
    if (const std::string code = code_of(system.get(), "::"); !code.empty()) urn_ = "urn:ogc:def:crs:" + code;
    is_in_degrees_ = gdal().OSRIsGeographic(system.get()) != 0;
    metres_per_unit_ = is_in_degrees_ ? 1 : gdal().OSRGetLinearUnits(system.get(), nullptr);
}

bool CoordinateSystem::is_same(const CoordinateSystem& other) const {
    if (definition_ == other.definition_) return true;
    if (!exists() || !other.exists()) return false;
    return gdal().OSRIsSame(parsed(definition_).get(), parsed(other.definition_).get()) != 0;
}

void CoordinateSystem::convert(std::span<Point> points, const CoordinateSystem& to,
                               const SourceLocation& place) const {
    const System source = parsed(definition_), target = parsed(to.definition_);
    const GdalErrorSilencer silence;
    const Transformation transformation(gdal().OCTNewCoordinateTransformation(source.get(), target.get()));
    if (!transformation)
        throw InputError(place, "coordinates of " + name_ + " cannot be converted to " + to.name_,
                         "systems between which PROJ knows a way");
    for (Point& p : points) {
        Point image = p;
        const int done = gdal().OCTTransform(transformation.get(), 1, &image.x, &image.y, nullptr);
        if (done == 0 || !std::isfinite(image.x) || !std::isfinite(image.y))
            throw InputError(place,
                             "the point (" + shortest_text(p.x) + ", " + shortest_text(p.y) + ") of " +
                                 name_ + " has no image in " + to.name_,
                             "coordinates within the area of both systems");
        p = image;
    }
}

}  // namespace rockslope::blockgen
