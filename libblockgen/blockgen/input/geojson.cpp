#include "blockgen/input/geojson.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/base/input_error.hpp"
#include "common/base/magnitude.hpp"
#include "common/base/read_file.hpp"

namespace rockslope::blockgen {

namespace {

using nlohmann::json;

/// Limit of the recursion; GeoJSON needs about ten levels.
constexpr int max_nesting_depth = 100;

json parse(const std::filesystem::path& path) {
    const std::string text = read_text_file(path);
    const auto refuse_depth = [&](int depth, json::parse_event_t, json&) {
        if (depth > max_nesting_depth)
            throw InputError({path.string()}, "the JSON is nested too deeply", "a GeoJSON file");
        return true;
    };
    try {
        return json::parse(text, refuse_depth);
    } catch (const json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        const int line = 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
        throw InputError({path.string(), line}, "this is not JSON", "a GeoJSON file");
    } catch (const json::out_of_range&) {
        throw InputError({path.string()}, "a number is too large", "coordinates in metres");
    }
}

class GeoJsonReader {
  public:
    explicit GeoJsonReader(const std::filesystem::path& path) : path_(path.string()), root_(parse(path)) {}

    /// Calls visit(geometry, properties) for each geometry.
    template <class Visit>
    void visit_geometries(const Visit& visit) {
        visit_object(root_, json::object(), visit);
    }

    Ring points(const json& list) const {
        if (!list.is_array()) fail("coordinates are not a list", "a list of [x, y]");
        Ring result;
        for (const json& position : list) {
            if (!position.is_array() || position.size() < 2 || !position[0].is_number() ||
                !position[1].is_number())
                fail("a position is not a pair of numbers", "[x, y]");
            result.push_back({position[0].get<double>(), position[1].get<double>()});
            if (!is_in_allowed_range(result.back().x) || !is_in_allowed_range(result.back().y))
                fail("a coordinate is too large", "coordinates in metres");
        }
        return result;
    }

    const json& coordinates(const json& geometry) const {
        const auto found = geometry.find("coordinates");
        if (found == geometry.end() || !found->is_array()) fail("a geometry has no coordinates", "a list");
        return *found;
    }

    [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
        throw InputError({path_}, where_ + what, expected);
    }

  private:
    template <class Visit>
    void visit_object(const json& object, const json& properties, const Visit& visit) {
        if (!object.is_object() || !object.contains("type") || !object["type"].is_string())
            fail("an object has no type", "a GeoJSON object");
        const std::string type = object["type"].get<std::string>();
        if (type == "FeatureCollection" || type == "GeometryCollection") {
            const char* key = type == "FeatureCollection" ? "features" : "geometries";
            if (!object.contains(key) || !object[key].is_array())
                fail("'" + type + "' has no " + key, "a list");
            std::size_t number = 0;
            for (const json& part : object[key]) {
                where_ = type == "FeatureCollection" ? "feature " + std::to_string(number++) + ": " : where_;
                visit_object(part, properties, visit);
            }
            where_.clear();
        } else if (type == "Feature") {
            const json own = object.contains("properties") ? object["properties"] : json::object();
            if (object.contains("geometry") && !object["geometry"].is_null())
                visit_object(object["geometry"], own, visit);
        } else {
            visit(type, object, properties);
        }
    }

    std::string path_;
    std::string where_;
    json root_;
};

}  // namespace

std::vector<GeoJsonLine> read_geojson_lines(const std::filesystem::path& path) {
    GeoJsonReader reader(path);
    std::vector<GeoJsonLine> lines;
    reader.visit_geometries([&](const std::string& type, const json& geometry, const json& properties) {
        std::string material;
        if (properties.is_object() && properties.contains("joint_material") &&
            properties["joint_material"].is_string())
            material = properties["joint_material"].get<std::string>();
        const auto add = [&](const json& coordinates) {
            lines.push_back({material, reader.points(coordinates)});
            if (lines.back().points.size() < 2)
                reader.fail("a line of fewer than two points", "two points or more");
        };
        if (type == "LineString")
            add(reader.coordinates(geometry));
        else if (type == "MultiLineString")
            for (const json& part : reader.coordinates(geometry)) add(part);
        else
            reader.fail("geometry of type '" + type + "'", "LineString or MultiLineString");
    });
    return lines;
}

std::vector<std::vector<Ring>> read_geojson_polygons(const std::filesystem::path& path) {
    GeoJsonReader reader(path);
    std::vector<std::vector<Ring>> polygons;
    const auto add = [&](const json& polygon) {
        if (!polygon.is_array() || polygon.empty()) reader.fail("a polygon without rings", "a list of rings");
        polygons.emplace_back();
        for (const json& ring : polygon) polygons.back().push_back(reader.points(ring));
    };
    reader.visit_geometries([&](const std::string& type, const json& geometry, const json&) {
        if (type == "Polygon")
            add(reader.coordinates(geometry));
        else if (type == "MultiPolygon")
            for (const json& part : reader.coordinates(geometry)) add(part);
        else
            reader.fail("geometry of type '" + type + "'", "Polygon or MultiPolygon");
    });
    if (polygons.empty()) reader.fail("no polygon", "a Polygon or a MultiPolygon");
    return polygons;
}

}  // namespace rockslope::blockgen
