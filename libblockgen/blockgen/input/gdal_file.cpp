#include "blockgen/input/gdal_file.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string_view>

#include "blockgen/input/closed_lines.hpp"
#include "blockgen/input/coordinate_system.hpp"
#include "blockgen/input/gdal_library.hpp"
#include "common/base/input_error.hpp"
#include "common/base/magnitude.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

template <auto Member>
struct GdalDeleter {
    void operator()(void* object) const { (gdal().*Member)(object); }
};
template <auto Member>
struct HandleDeleter {
    template <class Handle>
    void operator()(Handle* object) const {
        (gdal().*Member)(object);
    }
};
using Dataset = std::unique_ptr<void, GdalDeleter<&GdalLibrary::GDALClose>>;
using Feature =
    std::unique_ptr<std::remove_pointer_t<OGRFeatureH>, HandleDeleter<&GdalLibrary::OGR_F_Destroy>>;
using Geometry =
    std::unique_ptr<std::remove_pointer_t<OGRGeometryH>, HandleDeleter<&GdalLibrary::OGR_G_DestroyGeometry>>;

/// The units of drawings by the number after $INSUNITS in the header of a DXF file.
constexpr std::array<const char*, 22> drawing_units = {"",    "in",  "ft", "mi", "mm", "cm",   "m",  "km",
                                                       "uin", "mil", "yd", "A",  "nm", "um",   "dm", "dam",
                                                       "hm",  "Gm",  "au", "ly", "pc", "us-ft"};

/// The unit that the header of a DXF file states; empty when it states none.
std::string drawing_unit(const std::filesystem::path& path, const std::string& text) {
    const std::size_t key = text.find("$INSUNITS");
    if (key == std::string::npos) return {};
    // The lines after the key are the group code 70 and the number.
    const std::size_t code = text.find('\n', key);
    const std::size_t start = code == std::string::npos ? code : text.find('\n', code + 1);
    if (start == std::string::npos) return {};
    const std::string line = text.substr(start + 1, text.find('\n', start + 1) - start - 1);
    const std::size_t first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t\r");
    if (first == std::string::npos) return {};
    const auto number = parse_number(std::string_view(line).substr(first, last - first + 1));
    if (!number || !(*number >= 0 && *number < static_cast<double>(drawing_units.size())))
        throw InputError({path.string()}, "$INSUNITS is '" + line.substr(first, last - first + 1) + "'",
                         "a number from 0 to 21");
    return drawing_units[static_cast<std::size_t>(*number)];
}

/// The next line of a text from a place on, without blanks at its ends; the place then is behind its end: a
/// line feed, a carriage return, or both.
std::string_view next_line(const std::string& text, std::size_t& at) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    at = std::min(end + 1, text.size());
    if (at < text.size() && text[at] != text[end] && (text[at] == '\n' || text[at] == '\r')) ++at;
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(" \t") + 1 - first);
}

/// Checks that the pairs of lines of a DXF file, group code and value, come to its last record, 0 and EOF.
/// GDAL looks for it for ever in a file that was cut off, or that lost a line.
/// @throws InputError where they do not.
void require_end_of_drawing(const std::filesystem::path& path, const std::string& text) {
    const bool is_text = text.find('\0') == std::string::npos;
    for (std::size_t at = 0; is_text && at < text.size();) {
        const std::string_view code = next_line(text, at);
        const std::string_view value = next_line(text, at);
        if (code == "0" && value == "EOF") return;
    }
    throw InputError({path.string()}, "its last record is missing: the file was cut off or lost a line",
                     "a DXF file of text, whose lines come in pairs up to 0 and EOF");
}

bool is_drawing(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".dxf";
}

class GdalReader {
  public:
    explicit GdalReader(const std::filesystem::path& path) : place_{path.string()} {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) throw InputError(place_, "cannot be read", "a file");
        const bool is_drawing = blockgen::is_drawing(path);
        const std::string text = is_drawing ? read_text_file(path) : std::string();
        if (is_drawing) require_end_of_drawing(path, text);
        dataset_ = Dataset(gdal().GDALOpenEx(place_.file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr,
                                             nullptr, nullptr));
        if (!dataset_)
            throw InputError(place_, "GDAL cannot read this file", "a vector file such as DXF or GeoPackage");
        if (is_drawing) notes_.unit = drawing_unit(path, text);
    }

    /// Calls visit(geometry, feature, layer name) for each feature with a geometry. Curves are linearised.
    template <class Visit>
    void visit_features(const Visit& visit) {
        for (int k = 0; k < gdal().GDALDatasetGetLayerCount(dataset_.get()); ++k) {
            OGRLayerH layer = gdal().GDALDatasetGetLayer(dataset_.get(), k);
            note_system(gdal().OGR_L_GetSpatialRef(layer));
            gdal().OGR_L_ResetReading(layer);
            while (const Feature feature{
                static_cast<std::remove_pointer_t<OGRFeatureH>*>(gdal().OGR_L_GetNextFeature(layer))}) {
                OGRGeometryH shape = gdal().OGR_F_GetGeometryRef(feature.get());
                if (shape == nullptr || gdal().OGR_G_IsEmpty(shape)) {
                    ++notes_.empty;
                    continue;
                }
                notes_.with_heights += gdal().OGR_G_Is3D(shape) != 0;
                const Geometry straight{gdal().OGR_G_GetLinearGeometry(shape, 0, nullptr)};
                if (straight) visit(straight.get(), feature.get(), std::string(gdal().OGR_L_GetName(layer)));
            }
        }
    }

    /// Calls visit(points, heights) for each line and ring of a geometry.
    void visit_lines(OGRGeometryH shape,
                     const std::function<void(std::vector<Point>, std::vector<double>)>& visit) const {
        const OGRwkbGeometryType type = gdal().OGR_GT_Flatten(gdal().OGR_G_GetGeometryType(shape));
        if (type == wkbLineString || type == wkbLinearRing) {
            std::vector<Point> points;
            std::vector<double> heights;
            const bool has_heights = gdal().OGR_G_Is3D(shape) != 0;
            for (int k = 0; k < gdal().OGR_G_GetPointCount(shape); ++k) {
                points.push_back({gdal().OGR_G_GetX(shape, k), gdal().OGR_G_GetY(shape, k)});
                if (!is_in_allowed_range(points.back().x) || !is_in_allowed_range(points.back().y))
                    throw InputError(place_, "a coordinate is too large", "coordinates in metres");
                if (has_heights) heights.push_back(gdal().OGR_G_GetZ(shape, k));
            }
            if (points.size() >= 2) visit(std::move(points), std::move(heights));
            return;
        }
        for (int k = 0; k < gdal().OGR_G_GetGeometryCount(shape); ++k)
            visit_lines(gdal().OGR_G_GetGeometryRef(shape, k), visit);
    }

    const SourceLocation& place() const { return place_; }
    const MapNotes& notes() const { return notes_; }

  private:
    /// Keeps the system of the first layer that states one. @throws InputError when another layer has
    /// another.
    void note_system(OGRSpatialReferenceH system) {
        if (system == nullptr) return;
        char* text = nullptr;
        gdal().OSRExportToWkt(system, &text);
        const std::string definition = text == nullptr ? "" : text;
        gdal().VSIFree(text);
        if (notes_.system.empty()) {
            notes_.system = definition;
            return;
        }
        const CoordinateSystem first(notes_.system, place_), other(definition, place_);
        if (!first.is_same(other))
            throw InputError(place_, "its layers are in " + first.name() + " and in " + other.name(),
                             "one coordinate system");
    }

    GdalErrorSilencer error_silencer_;
    SourceLocation place_;
    Dataset dataset_;
    MapNotes notes_;
};

std::string field_of(OGRFeatureH feature, const char* name) {
    const int index = gdal().OGR_F_GetFieldIndex(feature, name);
    if (index < 0 || !gdal().OGR_F_IsFieldSetAndNotNull(feature, index)) return {};
    return gdal().OGR_F_GetFieldAsString(feature, index);
}

PlaneFields plane_of(OGRFeatureH feature) {
    // A Shapefile truncates field names to ten letters.
    std::string direction = field_of(feature, "dip_direction");
    if (direction.empty()) direction = field_of(feature, "dip_direct");
    return {parse_number(field_of(feature, "dip")), parse_number(direction)};
}

}  // namespace

MapLines read_gdal_lines(const std::filesystem::path& path) {
    GdalReader reader(path);
    MapLines map;
    reader.visit_features([&](OGRGeometryH shape, OGRFeatureH feature, const std::string& layer) {
        const std::string drawn_on = field_of(feature, "Layer");
        // A Shapefile truncates field names to ten letters.
        std::string material = field_of(feature, "joint_material");
        if (material.empty()) material = field_of(feature, "joint_mate");
        const PlaneFields plane = plane_of(feature);
        reader.visit_lines(shape, [&](std::vector<Point> points, std::vector<double> heights) {
            map.lines.push_back({material, drawn_on.empty() ? layer : drawn_on, std::move(points),
                                 std::move(heights), plane});
        });
    });
    map.notes = reader.notes();
    return map;
}

MapPolygons read_gdal_polygons(const std::filesystem::path& path) {
    GdalReader reader(path);
    MapPolygons map;
    std::vector<Ring> lines;
    const std::function<void(OGRGeometryH)> add = [&](OGRGeometryH shape) {
        const OGRwkbGeometryType type = gdal().OGR_GT_Flatten(gdal().OGR_G_GetGeometryType(shape));
        if (type == wkbPolygon) {
            map.polygons.emplace_back();
            reader.visit_lines(shape, [&](std::vector<Point> points, const std::vector<double>&) {
                map.polygons.back().push_back(std::move(points));
            });
            if (map.polygons.back().empty()) map.polygons.pop_back();
        } else if (type == wkbLineString || type == wkbLinearRing) {
            reader.visit_lines(shape, [&](std::vector<Point> points, const std::vector<double>&) {
                lines.push_back(std::move(points));
            });
        } else {
            for (int k = 0; k < gdal().OGR_G_GetGeometryCount(shape); ++k)
                add(gdal().OGR_G_GetGeometryRef(shape, k));
        }
    };
    reader.visit_features([&](OGRGeometryH shape, OGRFeatureH, const std::string&) { add(shape); });
    if (!lines.empty())
        for (std::vector<Ring>& polygon : nested_polygons(closed_lines(std::move(lines), reader.place())))
            map.polygons.push_back(std::move(polygon));
    if (map.polygons.empty()) throw InputError(reader.place(), "no polygon", "closed lines or polygons");
    map.notes = reader.notes();
    return map;
}

}  // namespace rockslope::blockgen
