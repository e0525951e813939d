#include "blockgen/input/geometry_file.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "blockgen/input/csv_table.hpp"
#include "blockgen/input/gdal_file.hpp"
#include "blockgen/input/geojson.hpp"
#include "common/base/magnitude.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

enum class FileKind { csv, geojson, gdal };

std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// The kind of a file by its name; nothing when it is none of these.
std::optional<FileKind> known_kind(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    if (extension == ".csv" || extension == ".txt") return FileKind::csv;
    if (extension == ".geojson" || extension == ".json") return FileKind::geojson;
    if (extension == ".dxf" || extension == ".shp" || extension == ".gpkg") return FileKind::gdal;
    return std::nullopt;
}

FileKind kind_of(const std::filesystem::path& path) {
    if (const auto kind = known_kind(path)) return *kind;
    throw InputError({path.string()}, "'" + extension_of(path) + "' is not a known geometry format",
                     ".csv, .geojson, .dxf, .shp or .gpkg");
}

std::vector<Point> read_csv_points(const std::filesystem::path& path) {
    const CsvTable table = read_csv(path, {"x", "y"}, {});
    std::vector<Point> points;
    for (std::size_t k = 0; k < table.row_count(); ++k)
        points.push_back({table.number(k, 0), table.number(k, 1)});
    return points;
}

void open_ring(Ring& ring) {
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

/// A number in a text column of a table; nothing where it is empty.
std::optional<double> number_in(const std::string& text, const std::filesystem::path& path, int line) {
    if (text.empty()) return std::nullopt;
    const auto number = parse_number(text);
    if (!number || !is_in_allowed_range(*number))
        throw InputError({path.string(), line}, "'" + text + "' is not a finite number",
                         "numbers for dip, dip_direction, z1 and z2");
    return number;
}

MapLines read_csv_lines(const std::filesystem::path& path, LineFields fields) {
    std::vector<std::string> texts = {"joint_material"};
    if (fields == LineFields::all) texts.insert(texts.end(), {"dip", "dip_direction", "z1", "z2"});
    CsvTable table = read_csv(path, {"x1", "y1", "x2", "y2"}, texts);
    MapLines map;
    map.lines.reserve(table.row_count());
    for (std::size_t k = 0; k < table.row_count(); ++k) {
        map.lines.push_back(
            {std::move(table.text(k, 0)),
             {},
             {{table.number(k, 0), table.number(k, 1)}, {table.number(k, 2), table.number(k, 3)}}});
        if (fields != LineFields::all) continue;
        const auto number = [&](std::size_t column) {
            return number_in(table.text(k, column), path, table.lines[k]);
        };
        map.lines.back().plane = {number(1), number(2)};
        const auto first = number(3), last = number(4);
        if (first && last) map.lines.back().heights = {*first, *last};
    }
    return map;
}

}  // namespace

bool is_geometry_file(const std::filesystem::path& path) {
    return known_kind(path).has_value();
}

bool is_csv_file(const std::filesystem::path& path) {
    return known_kind(path) == FileKind::csv;
}

std::vector<std::vector<Ring>> read_outline_file(const std::filesystem::path& path, MapNotes* notes) {
    MapPolygons map;
    switch (kind_of(path)) {
        case FileKind::geojson:
            map = read_geojson_polygons(path);
            break;
        case FileKind::gdal:
            map = read_gdal_polygons(path);
            break;
        case FileKind::csv:
            map.polygons.push_back({read_csv_points(path)});
    }
    for (std::vector<Ring>& rings : map.polygons)
        for (Ring& ring : rings) open_ring(ring);
    if (notes != nullptr) *notes = std::move(map.notes);
    return std::move(map.polygons);
}

MapLines read_line_file(const std::filesystem::path& path, LineFields fields) {
    switch (kind_of(path)) {
        case FileKind::geojson:
            return read_geojson_lines(path);
        case FileKind::gdal:
            return read_gdal_lines(path);
        case FileKind::csv:
            break;
    }
    return read_csv_lines(path, fields);
}

const std::string& joint_material_of(const MapLine& line, const std::string& fallback,
                                     const std::filesystem::path& path) {
    const std::string& material = !line.joint_material.empty() ? line.joint_material
                                  : !fallback.empty()          ? fallback
                                                               : line.layer;
    if (material.empty())
        throw InputError({path.string()}, "a trace has no joint material",
                         "joint_material in the file or in its [[traces]] table");
    return material;
}

std::vector<Trace> read_trace_file(const std::filesystem::path& path, const std::string& name,
                                   const std::string& joint_material, MapNotes* notes) {
    MapLines map = read_line_file(path);
    if (map.lines.empty())
        throw InputError({path.string()}, "the file contains no trace", "one trace or more");
    std::vector<Trace> traces;
    traces.reserve(map.lines.size());
    for (MapLine& line : map.lines) {
        traces.push_back({name, joint_material_of(line, joint_material, path), std::move(line.points)});
    }
    if (notes != nullptr) *notes = std::move(map.notes);
    return traces;
}

std::vector<Point> read_single_line(const std::filesystem::path& path, MapNotes* notes) {
    const FileKind kind = kind_of(path);
    MapLines map;
    if (kind == FileKind::csv)
        map.lines.push_back({{}, {}, read_csv_points(path)});
    else
        map = kind == FileKind::geojson ? read_geojson_lines(path) : read_gdal_lines(path);
    if (map.lines.size() != 1 || map.lines.front().points.empty())
        throw InputError({path.string()},
                         map.lines.size() > 1
                             ? "the file contains " + std::to_string(map.lines.size()) + " lines"
                             : "the file contains no line",
                         "one line");
    if (notes != nullptr) *notes = std::move(map.notes);
    return std::move(map.lines.front().points);
}

}  // namespace rockslope::blockgen
