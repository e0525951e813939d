#include "blockgen/input/geojson.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "common/base/input_error.hpp"
#include "common/base/magnitude.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

using nlohmann::json;

/// GeoJSON needs about ten levels.
constexpr std::size_t max_nesting_depth = 100;

/// The lists of positions in one member `coordinates`: lines, or the rings of polygons.
struct Paths {
    std::vector<Ring> paths;
    std::vector<std::size_t> polygon_ends;  ///< in a MultiPolygon: number of paths up to the end of each
    std::size_t position_depth = 0;         ///< lists round each number; 0 before the first number
    std::vector<double> heights;            ///< of those positions that have a third coordinate
};

/// A geometry with the joint material of its feature.
struct Shape {
    std::string type, joint_material;
    std::size_t feature = 0;
    Paths coordinates;
    PlaneFields plane;
};

/// What an object of the file is to its reader.
enum class Role { node, properties, crs, crs_properties, ignored };

struct Object {
    Role role = Role::node;
    std::string key;   ///< of the member being read
    std::string type;  ///< node: the member `type`
    bool has_coordinates = false, has_features = false, has_geometries = false;
    std::size_t first_shape = 0;  ///< node: shapes before it
    std::string joint_material;   ///< Feature: of its properties
    PlaneFields plane;            ///< likewise
    Paths coordinates;
};

/// Receives a GeoJSON file token by token and keeps the geometries only.
class GeoJsonHandler : public nlohmann::json_sax<json> {
  public:
    explicit GeoJsonHandler(std::string path) : path_(std::move(path)) {}

    bool null() override { return scalar(); }
    bool boolean(bool) override { return scalar(); }
    bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t&) override { return number(value); }
    bool binary(binary_t&) override { return scalar(); }

    bool string(string_t& value) override {
        if (in_coordinates_) fail_position();
        scalar();
        Object& object = objects_.back();
        if (array_depth_ > 0) return true;
        if (object.role == Role::node && object.key == "type") object.type = value;
        if (object.role == Role::properties && object.key == "joint_material")
            objects_[objects_.size() - 2].joint_material = value;
        keep_plane(parse_number(value));
        if (object.role == Role::crs_properties && object.key == "name") system_ = value;
        return true;
    }

    bool key(string_t& name) override {
        objects_.back().key = name;
        return true;
    }

    bool start_object(std::size_t) override {
        if (in_coordinates_) fail_position();
        check_depth();
        Object object;
        object.role = objects_.empty() ? Role::node : role_of_member();
        object.first_shape = shapes_.size();
        array_depths_.push_back(array_depth_);
        array_depth_ = 0;
        objects_.push_back(std::move(object));
        return true;
    }

    bool end_object() override {
        Object object = std::move(objects_.back());
        objects_.pop_back();
        array_depth_ = array_depths_.back();
        array_depths_.pop_back();
        if (object.role == Role::node) finish(std::move(object));
        return true;
    }

    bool start_array(std::size_t) override {
        check_depth();
        if (objects_.empty()) fail("an object has no type", "a GeoJSON object");
        Object& object = objects_.back();
        ++array_depth_;
        if (object.role != Role::node) return true;
        if (in_coordinates_) {
            if (coordinates().position_depth > 0 && array_depth_ > coordinates().position_depth)
                fail_position();
            if (array_depth_ == coordinates().position_depth) position_size_ = 0;
        } else if (array_depth_ == 1 && object.key == "coordinates") {
            in_coordinates_ = true;
            object.has_coordinates = true;
            object.coordinates = {};
        } else if (array_depth_ == 1) {
            object.has_features = object.has_features || object.key == "features";
            object.has_geometries = object.has_geometries || object.key == "geometries";
        }
        return true;
    }

    bool end_array() override {
        if (in_coordinates_) end_list();
        if (--array_depth_ == 0) in_coordinates_ = false;
        return true;
    }

    bool parse_error(std::size_t byte, const std::string&, const json::exception& error) override {
        error_byte_ = byte;
        if (dynamic_cast<const json::out_of_range*>(&error) != nullptr)
            fail("a number is too large", "coordinates in metres");
        return false;
    }

    [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
        throw InputError({path_}, where_ + what, expected);
    }

    /// Errors from now on name the feature of a shape.
    void blame(const Shape& shape) { where_ = is_collection_ ? feature_text(shape.feature) : ""; }

    MapNotes notes() const {
        MapNotes result;
        result.system = system_;
        for (const Shape& shape : shapes_) {
            result.empty += shape.coordinates.paths.empty();
            result.with_heights += !shape.coordinates.heights.empty();
        }
        result.empty += without_geometry_;
        return result;
    }
    std::vector<Shape>& shapes() { return shapes_; }
    /// Where the text ceases to be JSON.
    std::size_t error_byte() const { return error_byte_; }

  private:
    static std::string feature_text(std::size_t number) { return "feature " + std::to_string(number) + ": "; }

    Paths& coordinates() { return objects_.back().coordinates; }

    void check_depth() const {
        std::size_t depth = objects_.size() + array_depth_;
        for (const std::size_t arrays : array_depths_) depth += arrays;
        if (depth > max_nesting_depth) fail("the JSON is nested too deeply", "a GeoJSON file");
    }

    [[noreturn]] void fail_position() const { fail("a position is not a pair of numbers", "[x, y]"); }

    /// A value that is not a number.
    bool scalar() {
        if (in_coordinates_) fail_position();
        if (objects_.empty()) fail("an object has no type", "a GeoJSON object");
        const Object& object = objects_.back();
        if (object.role == Role::node && array_depth_ == 0 && object.key == "geometry") ++without_geometry_;
        return true;
    }

    /// Keeps a property that is an angle of the feature's plane.
    void keep_plane(std::optional<double> degrees) {
        const Object& object = objects_.back();
        if (object.role != Role::properties || array_depth_ > 0) return;
        PlaneFields& plane = objects_[objects_.size() - 2].plane;
        if (object.key == "dip") plane.dip = degrees;
        if (object.key == "dip_direction") plane.dip_direction = degrees;
    }

    bool number(double value) {
        if (!in_coordinates_) {
            scalar();
            keep_plane(value);
            return true;
        }
        Paths& read = coordinates();
        if (read.position_depth == 0) {
            read.position_depth = array_depth_;
            position_size_ = 0;
        }
        if (array_depth_ != read.position_depth) fail_position();
        if (position_size_ < 2 && !is_in_allowed_range(value))
            fail("a coordinate is too large", "coordinates in metres");
        if (position_size_ < position_.size()) position_[position_size_] = value;
        ++position_size_;
        return true;
    }

    /// At the end of a list in `coordinates`: a position, a path, or the paths of a polygon.
    void end_list() {
        Paths& read = coordinates();
        const std::size_t depth = array_depth_;
        if (read.position_depth == 0) return;
        if (depth == read.position_depth) {
            if (position_size_ < 2) fail_position();
            if (!in_path_) read.paths.emplace_back();
            in_path_ = true;
            read.paths.back().push_back({position_[0], position_[1]});
            if (position_size_ > 2) read.heights.push_back(position_[2]);
        } else if (depth + 1 == read.position_depth) {
            in_path_ = false;
        } else if (depth + 2 == read.position_depth) {
            read.polygon_ends.push_back(read.paths.size());
        }
        if (depth == 1) in_path_ = false;
    }

    Role role_of_member() {
        const Object& parent = objects_.back();
        if (parent.role == Role::crs)
            return parent.key == "properties" ? Role::crs_properties : Role::ignored;
        if (parent.role != Role::node) return Role::ignored;
        if (array_depth_ == 1 && (parent.key == "features" || parent.key == "geometries")) {
            if (parent.key == "features") {
                is_collection_ = true;
                where_ = feature_text(features_++);
            }
            return Role::node;
        }
        if (array_depth_ > 0) return Role::ignored;
        if (parent.key == "geometry") return Role::node;
        if (parent.key == "properties") return Role::properties;
        return parent.key == "crs" ? Role::crs : Role::ignored;
    }

    void finish(Object object) {
        if (object.type.empty()) fail("an object has no type", "a GeoJSON object");
        if (object.type == "Feature") {
            for (std::size_t k = object.first_shape; k < shapes_.size(); ++k)
                shapes_[k].joint_material = object.joint_material, shapes_[k].plane = object.plane;
        } else if (object.type == "FeatureCollection" || object.type == "GeometryCollection") {
            const bool features = object.type == "FeatureCollection";
            if (features) where_.clear();
            if (!(features ? object.has_features : object.has_geometries))
                fail("'" + object.type + "' has no " + (features ? "features" : "geometries"), "a list");
        } else {
            if (!object.has_coordinates) fail("a geometry has no coordinates", "a list");
            shapes_.push_back(
                {object.type, {}, features_ > 0 ? features_ - 1 : 0, std::move(object.coordinates), {}});
        }
    }

    std::string path_, where_, system_;
    std::vector<Object> objects_;            ///< those being read, the outermost first
    std::vector<std::size_t> array_depths_;  ///< lists open round each of them, within the object round it
    std::size_t array_depth_ = 0;            ///< lists open in the innermost object
    bool in_coordinates_ = false, in_path_ = false, is_collection_ = false;
    std::array<double, 3> position_{};
    std::size_t position_size_ = 0, features_ = 0, without_geometry_ = 0, error_byte_ = 0;
    std::vector<Shape> shapes_;
};

GeoJsonHandler parsed(const std::filesystem::path& path) {
    const std::string text = read_text_file(path);
    GeoJsonHandler handler(path.string());
    if (json::sax_parse(text, &handler)) return handler;
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(handler.error_byte(), text.size()));
    const int line = 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
    throw InputError({path.string(), line}, "this is not JSON", "a GeoJSON file");
}

bool has_lines(const Shape& shape) {
    return shape.type == "LineString" || shape.type == "MultiLineString";
}

bool has_polygons(const Shape& shape) {
    return shape.type == "Polygon" || shape.type == "MultiPolygon";
}

void take_lines(const GeoJsonHandler& file, Shape& shape, MapLines& map) {
    if (shape.coordinates.paths.empty()) return;
    if (shape.coordinates.position_depth != (shape.type == "LineString" ? 2u : 3u))
        file.fail("a position is not a pair of numbers", "[x, y]");
    std::size_t points = 0;
    for (const Ring& line : shape.coordinates.paths) points += line.size();
    const bool all_have_heights = shape.coordinates.heights.size() == points;
    auto height = shape.coordinates.heights.begin();
    for (Ring& line : shape.coordinates.paths) {
        if (line.size() < 2) file.fail("a line of fewer than two points", "two points or more");
        map.lines.push_back({shape.joint_material, {}, std::move(line), {}, shape.plane});
        if (!all_have_heights) continue;
        const auto end = height + static_cast<std::ptrdiff_t>(map.lines.back().points.size());
        map.lines.back().heights.assign(height, end);
        height = end;
    }
}

void take_polygons(const GeoJsonHandler& file, Shape& shape, MapPolygons& map) {
    Paths& rings = shape.coordinates;
    if (rings.paths.empty()) return;
    if (rings.position_depth != (shape.type == "Polygon" ? 3u : 4u))
        file.fail("a position is not a pair of numbers", "[x, y]");
    if (shape.type == "Polygon") rings.polygon_ends = {rings.paths.size()};
    std::size_t ring = 0;
    for (const std::size_t end : rings.polygon_ends) {
        if (ring == end) continue;
        map.polygons.emplace_back();
        for (; ring < end; ++ring) map.polygons.back().push_back(std::move(rings.paths[ring]));
    }
}

}  // namespace

MapLines read_geojson_lines(const std::filesystem::path& path) {
    GeoJsonHandler file = parsed(path);
    MapLines map;
    map.notes = file.notes();
    for (Shape& shape : file.shapes()) {
        file.blame(shape);
        if (!has_lines(shape))
            file.fail("geometry of type '" + shape.type + "'", "LineString or MultiLineString");
        take_lines(file, shape, map);
    }
    return map;
}

MapPolygons read_geojson_polygons(const std::filesystem::path& path) {
    GeoJsonHandler file = parsed(path);
    MapPolygons map;
    map.notes = file.notes();
    for (Shape& shape : file.shapes()) {
        file.blame(shape);
        if (!has_polygons(shape))
            file.fail("geometry of type '" + shape.type + "'", "Polygon or MultiPolygon");
        take_polygons(file, shape, map);
    }
    file.blame({});
    if (map.polygons.empty()) throw InputError({path.string()}, "no polygon", "a Polygon or a MultiPolygon");
    return map;
}

GeoJsonMap read_geojson_map(const std::filesystem::path& path) {
    GeoJsonHandler file = parsed(path);
    GeoJsonMap map;
    map.lines.notes = map.polygons.notes = file.notes();
    for (Shape& shape : file.shapes()) {
        file.blame(shape);
        if (has_lines(shape))
            take_lines(file, shape, map.lines);
        else if (has_polygons(shape))
            take_polygons(file, shape, map.polygons);
        else
            file.fail("geometry of type '" + shape.type + "'", "lines and polygons");
    }
    return map;
}

}  // namespace rockslope::blockgen
