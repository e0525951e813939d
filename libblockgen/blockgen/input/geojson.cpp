#include "blockgen/input/geojson.hpp"

#include <simdjson.h>
#include <algorithm>
#include <array>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>

#include "common/base/input_error.hpp"
#include "common/base/magnitude.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

namespace ondemand = simdjson::ondemand;
using ondemand::json_type;

/// GeoJSON needs about ten levels.
constexpr int max_nesting_depth = 100;

/// A feature of one line is hardly shorter. Room for so many lines takes no memory until it is used.
constexpr std::size_t bytes_of_feature = 100;

/// What the caller takes from a file.
enum class Wanted { lines, polygons, lines_and_polygons };

/// The lists of positions in one member `coordinates`: lines, or the rings of polygons.
struct Paths {
    std::vector<Ring> paths;
    std::vector<std::size_t> polygon_ends;  ///< in a MultiPolygon: number of paths up to the end of each
    std::size_t position_depth = 0;         ///< lists round each number; 0 before the first number
    std::vector<double> heights;            ///< of those positions that have a third coordinate
    bool in_path = false;                   ///< the next position continues the last path
};

/// A geometry, a feature or a collection while its members are read, which come in any order.
struct Node {
    std::string_view type;
    bool has_coordinates = false, has_features = false, has_geometries = false;
    std::size_t first_line = 0;  ///< lines of the file before it
    std::string joint_material;  ///< Feature: of its properties
    PlaneFields plane;           ///< likewise
    Paths coordinates;
};

/// Throws where the text ceases to be JSON. simdjson has refused it; the slower parser knows the place.
[[noreturn]] void fail_text(const std::string& path, const std::string& text) {
    using nlohmann::json;
    int line = 0;
    try {
        const auto keep_nothing = [](int, json::parse_event_t, json&) { return false; };
        const json nothing = json::parse(text, keep_nothing);
    } catch (const json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        line = 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
    } catch (const json::out_of_range&) {
        throw InputError({path}, "a number is too large", "coordinates in metres");
    }
    throw InputError({path, line}, "this is not JSON", "a GeoJSON file");
}

/// Reads a GeoJSON file in one pass. All of the text is walked, also members that are not used.
class GeoJsonReader {
  public:
    GeoJsonReader(std::string path, Wanted wanted) : path_(std::move(path)), wanted_(wanted) {}

    GeoJsonMap read() {
        std::string text = read_text_file(path_);
        try {
            read_text(text);
        } catch (const simdjson::simdjson_error& error) {
            if (error.error() == simdjson::MEMALLOC) throw std::bad_alloc();
            fail_text(path_, text);
        }
        map_.polygons.notes = map_.lines.notes = notes_;
        return std::move(map_);
    }

  private:
    [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
        const std::string where = feature_ ? "feature " + std::to_string(*feature_) + ": " : "";
        throw InputError({path_}, where + what, expected);
    }

    [[noreturn]] void fail_position() const { fail("a position is not a pair of numbers", "[x, y]"); }

    void check_depth(int depth) const {
        if (depth > max_nesting_depth) fail("the JSON is nested too deeply", "a GeoJSON file");
    }

    void read_text(std::string& text) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        const std::size_t start = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
        text.reserve(text.size() + simdjson::SIMDJSON_PADDING);
        if (wanted_ != Wanted::polygons) map_.lines.lines.reserve(text.size() / bytes_of_feature);
        ondemand::parser parser;
        ondemand::document document = parser.iterate(
            simdjson::padded_string_view(text.data() + start, text.size() - start, text.capacity() - start));
        if (document.type() != json_type::object) fail("an object has no type", "a GeoJSON object");
        read_node(document.get_object(), 1);
        const bool has_more = document.current_location().error() == simdjson::SUCCESS;
        if (has_more) throw simdjson::simdjson_error(simdjson::TAPE_ERROR);
    }

    void read_node(ondemand::object object, int depth) {
        check_depth(depth);
        Node node;
        node.first_line = map_.lines.lines.size();
        for (auto field : object) {
            const std::string_view key = field.unescaped_key();
            read_member(node, key, field.value(), depth + 1);
        }
        finish(node);
    }

    void read_member(Node& node, std::string_view key, ondemand::value value, int depth) {
        const json_type type = value.type();
        if (key == "type" && type == json_type::string) {
            node.type = value.get_string();
        } else if (key == "coordinates" && type == json_type::array) {
            node.has_coordinates = true;
            node.coordinates = {};
            read_list(value, 1, depth, node.coordinates);
        } else if (key == "features" && type == json_type::array) {
            node.has_features = true;
            read_features(value, depth);
        } else if (key == "geometries" && type == json_type::array) {
            node.has_geometries = true;
            for (auto geometry : value.get_array()) read_node_or_skip(geometry.value(), depth + 1);
        } else if (key == "geometry") {
            notes_.empty += type != json_type::object && type != json_type::array;
            read_node_or_skip(value, depth);
        } else if (key == "properties" && type == json_type::object) {
            read_properties(node, value, depth);
        } else if (key == "crs" && type == json_type::object) {
            read_system(value, depth);
        } else {
            skip(value, depth);
        }
    }

    void read_features(ondemand::array features, int depth) {
        check_depth(depth);
        std::size_t number = 0;
        for (auto feature : features) {
            feature_ = number++;
            read_node_or_skip(feature.value(), depth + 1);
        }
        feature_.reset();
    }

    void read_node_or_skip(ondemand::value value, int depth) {
        if (value.type() == json_type::object)
            read_node(value, depth);
        else
            skip(value, depth);
    }

    void read_properties(Node& feature, ondemand::object properties, int depth) {
        check_depth(depth);
        for (auto property : properties) {
            const std::string_view key = property.unescaped_key();
            ondemand::value value = property.value();
            const json_type type = value.type();
            if (type == json_type::string) {
                const std::string text(value.get_string().value());
                if (key == "joint_material") feature.joint_material = text;
                keep_plane(feature.plane, key, parse_number(text));
            } else if (type == json_type::number) {
                keep_plane(feature.plane, key, value.get_double().value());
            } else {
                skip(value, depth + 1);
            }
        }
    }

    static void keep_plane(PlaneFields& plane, std::string_view key, std::optional<double> degrees) {
        if (key == "dip") plane.dip = degrees;
        if (key == "dip_direction") plane.dip_direction = degrees;
    }

    /// Reads the member `crs`: {"type": "name", "properties": {"name": "EPSG:32632"}}.
    void read_system(ondemand::object crs, int depth) {
        check_depth(depth);
        for (auto member : crs) {
            const std::string_view key = member.unescaped_key();
            ondemand::value value = member.value();
            if (key != "properties" || value.type() != json_type::object) {
                skip(value, depth + 1);
                continue;
            }
            check_depth(depth + 1);
            for (auto property : value.get_object()) {
                const bool is_name = property.unescaped_key().value() == "name";
                ondemand::value name = property.value();
                if (is_name && name.type() == json_type::string)
                    notes_.system = name.get_string().value();
                else
                    skip(name, depth + 2);
            }
        }
    }

    /// Walks a value that is not used, so that its errors are found.
    void skip(ondemand::value value, int depth) {
        switch (value.type()) {
            case json_type::array:
                check_depth(depth);
                for (auto element : value.get_array()) skip(element.value(), depth + 1);
                break;
            case json_type::object:
                check_depth(depth);
                for (auto field : value.get_object()) {
                    static_cast<void>(field.unescaped_key().value());
                    skip(field.value(), depth + 1);
                }
                break;
            case json_type::string:
                static_cast<void>(value.get_string().value());
                break;
            case json_type::number:
                static_cast<void>(value.get_double().value());
                break;
            case json_type::boolean:
                static_cast<void>(value.get_bool().value());
                break;
            case json_type::null:
                if (!value.is_null().value()) throw simdjson::simdjson_error(simdjson::N_ATOM_ERROR);
                break;
        }
    }

    /// Reads a list in `coordinates`, the `level`-th round its numbers counted from outside: a position, or
    /// lists.
    void read_list(ondemand::array list, std::size_t level, int depth, Paths& read) {
        check_depth(depth);
        std::array<double, 3> position{};
        std::size_t size = 0;
        for (auto element : list) {
            ondemand::value value = element.value();
            const json_type type = value.type();
            if (type == json_type::array) {
                if (read.position_depth > 0 && level >= read.position_depth) fail_position();
                read_list(value, level + 1, depth + 1, read);
            } else if (type == json_type::number) {
                if (read.position_depth == 0) read.position_depth = level;
                if (level != read.position_depth) fail_position();
                const double number = value.get_double();
                if (size < 2 && !is_in_allowed_range(number))
                    fail("a coordinate is too large", "coordinates in metres");
                if (size < position.size()) position[size] = number;
                ++size;
            } else {
                fail_position();
            }
        }
        end_list(level, position, size, read);
    }

    /// At the end of a list in `coordinates`: a position, a path, or the paths of a polygon.
    void end_list(std::size_t level, const std::array<double, 3>& position, std::size_t size, Paths& read) {
        if (read.position_depth == 0) return;
        if (level == read.position_depth) {
            if (size < 2) fail_position();
            if (!read.in_path) read.paths.emplace_back().reserve(2);
            read.in_path = true;
            read.paths.back().push_back({position[0], position[1]});
            if (size > 2) read.heights.push_back(position[2]);
        } else if (level + 1 == read.position_depth) {
            read.in_path = false;
        } else if (level + 2 == read.position_depth) {
            read.polygon_ends.push_back(read.paths.size());
        }
    }

    /// At the end of a geometry, a feature or a collection.
    void finish(Node& node) {
        if (node.type.empty()) fail("an object has no type", "a GeoJSON object");
        if (node.type == "Feature") {
            for (std::size_t k = node.first_line; k < map_.lines.lines.size(); ++k) {
                map_.lines.lines[k].joint_material = node.joint_material;
                map_.lines.lines[k].plane = node.plane;
            }
        } else if (node.type == "FeatureCollection") {
            if (!node.has_features) fail("'FeatureCollection' has no features", "a list");
        } else if (node.type == "GeometryCollection") {
            if (!node.has_geometries) fail("'GeometryCollection' has no geometries", "a list");
        } else {
            take_geometry(node);
        }
    }

    void take_geometry(Node& node) {
        if (!node.has_coordinates) fail("a geometry has no coordinates", "a list");
        notes_.empty += node.coordinates.paths.empty();
        notes_.with_heights += !node.coordinates.heights.empty();
        const bool has_lines = node.type == "LineString" || node.type == "MultiLineString";
        const bool has_polygons = node.type == "Polygon" || node.type == "MultiPolygon";
        if (has_lines && wanted_ != Wanted::polygons)
            take_lines(node.type == "LineString" ? 2 : 3, node.coordinates);
        else if (has_polygons && wanted_ != Wanted::lines)
            take_polygons(node.type == "Polygon" ? 3 : 4, node.coordinates);
        else
            fail("geometry of type '" + std::string(node.type) + "'", wanted_text());
    }

    std::string wanted_text() const {
        if (wanted_ == Wanted::lines) return "LineString or MultiLineString";
        return wanted_ == Wanted::polygons ? "Polygon or MultiPolygon" : "lines and polygons";
    }

    /// @param levels lists round each number.
    void take_lines(std::size_t levels, Paths& read) {
        if (read.paths.empty()) return;
        if (read.position_depth != levels) fail_position();
        std::size_t points = 0;
        for (const Ring& line : read.paths) points += line.size();
        const bool all_have_heights = read.heights.size() == points;
        auto height = read.heights.begin();
        for (Ring& line : read.paths) {
            if (line.size() < 2) fail("a line of fewer than two points", "two points or more");
            MapLine& taken = map_.lines.lines.emplace_back();
            taken.points = std::move(line);
            if (!all_have_heights) continue;
            const auto end = height + static_cast<std::ptrdiff_t>(taken.points.size());
            taken.heights.assign(height, end);
            height = end;
        }
    }

    /// @param levels lists round each number.
    void take_polygons(std::size_t levels, Paths& read) {
        if (read.paths.empty()) return;
        if (read.position_depth != levels) fail_position();
        if (levels == 3) read.polygon_ends = {read.paths.size()};
        std::size_t ring = 0;
        for (const std::size_t end : read.polygon_ends) {
            if (ring == end) continue;
            std::vector<Ring>& rings = map_.polygons.polygons.emplace_back();
            for (; ring < end; ++ring) rings.push_back(std::move(read.paths[ring]));
        }
    }

    std::string path_;
    Wanted wanted_;
    std::optional<std::size_t> feature_;  ///< the one being read, which errors name
    MapNotes notes_;
    GeoJsonMap map_;
};

}  // namespace

MapLines read_geojson_lines(const std::filesystem::path& path) {
    return GeoJsonReader(path.string(), Wanted::lines).read().lines;
}

MapPolygons read_geojson_polygons(const std::filesystem::path& path) {
    MapPolygons map = GeoJsonReader(path.string(), Wanted::polygons).read().polygons;
    if (map.polygons.empty()) throw InputError({path.string()}, "no polygon", "a Polygon or a MultiPolygon");
    return map;
}

GeoJsonMap read_geojson_map(const std::filesystem::path& path) {
    return GeoJsonReader(path.string(), Wanted::lines_and_polygons).read();
}

}  // namespace rockslope::blockgen
