#include "blockgen/input/geometry_file.hpp"

#include <algorithm>
#include <cctype>

#include "blockgen/input/csv_table.hpp"
#include "blockgen/input/gdal_file.hpp"
#include "blockgen/input/geojson.hpp"

namespace rockslope::blockgen {

namespace {

enum class FileKind { csv, geojson, gdal };

FileKind kind_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".csv" || extension == ".txt") return FileKind::csv;
    if (extension == ".geojson" || extension == ".json") return FileKind::geojson;
    if (extension == ".dxf" || extension == ".shp" || extension == ".gpkg") return FileKind::gdal;
    throw InputError({path.string()}, "'" + extension + "' is not a known geometry format",
                     ".csv, .geojson, .dxf, .shp or .gpkg");
}

void open_ring(Ring& ring) {
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

}  // namespace

std::vector<std::vector<Ring>> read_outline_file(const std::filesystem::path& path) {
    std::vector<std::vector<Ring>> parts;
    if (kind_of(path) == FileKind::geojson) {
        parts = read_geojson_polygons(path);
    } else if (kind_of(path) == FileKind::gdal) {
        parts = read_gdal_polygons(path);
    } else {
        const CsvTable table = read_csv(path, {"x", "y"}, {});
        parts.push_back({Ring{}});
        for (const CsvRow& row : table.rows) parts[0][0].push_back({row.numbers[0], row.numbers[1]});
    }
    for (std::vector<Ring>& rings : parts)
        for (Ring& ring : rings) open_ring(ring);
    return parts;
}

std::vector<Trace> read_trace_file(const std::filesystem::path& path, const std::string& name,
                                   const std::string& joint_material) {
    std::vector<Trace> traces;
    if (kind_of(path) == FileKind::geojson) {
        for (GeoJsonLine& line : read_geojson_lines(path))
            traces.push_back({name, line.joint_material.empty() ? joint_material : line.joint_material,
                              std::move(line.points)});
    } else if (kind_of(path) == FileKind::gdal) {
        for (GdalLine& line : read_gdal_lines(path)) {
            const std::string& own = line.joint_material.empty() ? joint_material : line.joint_material;
            traces.push_back({name, own.empty() ? line.layer : own, std::move(line.points)});
        }
    } else {
        const CsvTable table = read_csv(path, {"x1", "y1", "x2", "y2"}, {"joint_material"});
        for (const CsvRow& row : table.rows)
            traces.push_back({name,
                              row.texts[0].empty() ? joint_material : row.texts[0],
                              {{row.numbers[0], row.numbers[1]}, {row.numbers[2], row.numbers[3]}}});
    }
    if (traces.empty()) throw InputError({path.string()}, "the file contains no trace", "one trace or more");
    for (const Trace& trace : traces)
        if (trace.joint_material.empty())
            throw InputError({path.string()}, "a trace has no joint material",
                             "joint_material in the file or in its [[traces]] table");
    return traces;
}

}  // namespace rockslope::blockgen
