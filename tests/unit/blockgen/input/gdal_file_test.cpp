#include "blockgen/input/gdal_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "blockgen/input/geometry_file.hpp"
#include "common/base/input_error.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/file_folder.hpp"

namespace rockslope::blockgen::gdal_file_test {
namespace {

using testing::HasSubstr;

class GdalFile : public FileFolder {};

/// A drawing with a line on layer "fault", a polyline of three corners on "bedding", a circle and a text.
const char* drawing =
    "0\nSECTION\n2\nENTITIES\n"
    "0\nLINE\n8\nfault\n10\n0\n20\n1\n11\n10\n21\n2.5\n"
    "0\nLWPOLYLINE\n8\nbedding\n90\n3\n70\n0\n10\n0\n20\n5\n10\n4\n20\n6\n10\n9\n20\n5.5\n"
    "0\nCIRCLE\n8\ntunnel\n10\n5\n20\n5\n40\n1\n"
    "0\nTEXT\n8\nnotes\n10\n1\n20\n1\n40\n1\n1\nhello\n"
    "0\nENDSEC\n0\nEOF\n";

TEST_F(GdalFile, LinesOfADrawing) {
    const std::vector<Trace> traces = read_trace_file(written("drawing.dxf", drawing), "map", "");
    ASSERT_EQ(traces.size(), 3u);
    EXPECT_EQ(traces[0].name, "map");
    EXPECT_EQ(traces[0].joint_material, "fault");
    EXPECT_EQ(traces[0].points, (std::vector<Point>{{0, 1}, {10, 2.5}}));
    EXPECT_EQ(traces[1].joint_material, "bedding");
    EXPECT_EQ(traces[1].points.size(), 3u);
    EXPECT_GT(traces[2].points.size(), 20u);  // the circle, in short segments
    EXPECT_EQ(traces[2].points.front(), traces[2].points.back());
    for (const Trace& trace : read_trace_file(written("drawing.dxf", drawing), "map", "joint"))
        EXPECT_EQ(trace.joint_material, "joint");
}

TEST_F(GdalFile, AClosedLineIsAnOutline) {
    const std::string outline =
        "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n3\n70\n1\n10\n0\n20\n0\n10\n4\n20\n0\n10\n4\n20\n3"
        "\n"
        "0\nENDSEC\n0\nEOF\n";
    const std::vector<std::vector<Ring>> parts = read_outline_file(written("outline.dxf", outline));
    ASSERT_EQ(parts.size(), 1u);
    const std::vector<Ring>& rings = parts[0];
    ASSERT_EQ(rings.size(), 1u);
    EXPECT_EQ(rings[0].size(), 3u);
    EXPECT_EQ(twice_signed_area(rings[0]), 12);
    EXPECT_THROW(read_outline_file(written("drawing.dxf", drawing)), InputError);
}

void put(std::string& bytes, std::int32_t value, bool big_endian) {
    for (int k = 0; k < 4; ++k)
        bytes +=
            static_cast<char>(static_cast<std::uint32_t>(value) >> (8 * (big_endian ? 3 - k : k)) & 255u);
}
void put(std::string& bytes, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int k = 0; k < 8; ++k) bytes += static_cast<char>(bits >> (8 * k) & 255u);
}

/// The header that the shape file and its index file share; length in bytes.
std::string shape_header(std::int32_t length) {
    std::string bytes;
    for (const std::int32_t value : {9994, 0, 0, 0, 0, 0, length / 2}) put(bytes, value, true);
    for (const std::int32_t value : {1000, 3}) put(bytes, value, false);
    for (const double value : {0.0, 0.0, 4.0, 3.0, 0.0, 0.0, 0.0, 0.0}) put(bytes, value);
    return bytes;
}

TEST_F(GdalFile, LinesOfAShapefile) {
    // One polyline of one part: type 3, its box, one part, two points.
    std::string content;
    put(content, 3, false);
    for (const double value : {0.0, 0.0, 4.0, 3.0}) put(content, value);
    for (const std::int32_t value : {1, 2, 0}) put(content, value, false);
    for (const double value : {0.0, 0.0, 4.0, 3.0}) put(content, value);
    const auto words = static_cast<std::int32_t>(content.size() / 2);
    std::string shapes = shape_header(100 + 8 + 2 * words), index = shape_header(108);
    put(shapes, 1, true);
    put(shapes, words, true);
    put(index, 50, true);
    put(index, words, true);
    written("faults.shx", index);
    const std::vector<Trace> traces = read_trace_file(written("faults.shp", shapes + content), "map", "");
    ASSERT_EQ(traces.size(), 1u);
    EXPECT_EQ(traces[0].joint_material, "faults");
    EXPECT_EQ(traces[0].points, (std::vector<Point>{{0, 0}, {4, 3}}));
}

TEST_F(GdalFile, FilesWithoutGeometryAreRefused) {
    EXPECT_THROW(read_trace_file("no-such.dxf", "map", "joint"), InputError);
    EXPECT_THROW(read_trace_file(written("junk.gpkg", "junk"), "map", "joint"), InputError);
    EXPECT_THROW(
        read_trace_file(written("empty.dxf", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n"), "map", "j"),
        InputError);
}

}  // namespace
}  // namespace rockslope::blockgen::gdal_file_test
