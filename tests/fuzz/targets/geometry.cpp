// A file of lines: its first byte chooses CSV, GeoJSON, Shi's line file, and DXF and Shapefile, which GDAL
// reads.
#include <array>

#include "blockgen/input/geo_file.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "fuzz/targets/target.hpp"

using namespace rockslope;
using namespace rockslope::blockgen;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    static const std::array<const char*, 5> names = {"lines.csv", "lines.json", "lines.geo", "lines.dxf",
                                                     "lines.shp"};
    const std::size_t kind = data[0] % names.size();
    const auto path = fuzz::file_of(fuzz::text_of(data + 1, size - 1), names[kind]);
    return fuzz::reads_or_refuses([&] {
        if (kind == 2)
            read_geo_file(path);
        else
            read_trace_file(path, "name", "joint");
    });
}
