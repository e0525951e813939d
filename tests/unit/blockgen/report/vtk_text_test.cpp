#include "blockgen/report/vtk_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "common/geometry/polygon.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::vtk_text_test {
namespace {

using testing::HasSubstr;

/// What a reader of the format finds.
struct VtkFile {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> lines, polygons;
    std::map<std::string, std::vector<double>> cell_data;
};

std::vector<std::vector<std::size_t>> read_cells(std::istream& in) {
    std::size_t cells = 0, numbers = 0, read = 0;
    in >> cells >> numbers;
    std::vector<std::vector<std::size_t>> all(cells);
    for (auto& cell : all) {
        std::size_t corners = 0;
        in >> corners;
        cell.resize(corners);
        for (std::size_t& corner : cell) in >> corner;
        read += corners + 1;
    }
    EXPECT_EQ(read, numbers);
    return all;
}

VtkFile read_vtk(const std::string& text) {
    std::istringstream in(text);
    VtkFile file;
    std::string word, type, table, components;
    std::size_t count = 0, cells = 0;
    while (in >> word) {
        if (word == "POINTS") {
            in >> count >> type;
            file.points.resize(count);
            double z = 0;
            for (Point& p : file.points) in >> p.x >> p.y >> z;
        }
        if (word == "LINES") file.lines = read_cells(in);
        if (word == "POLYGONS") file.polygons = read_cells(in);
        if (word == "CELL_DATA") in >> cells;
        if (word == "SCALARS") {
            in >> word >> type >> components >> table >> table;
            std::vector<double>& values = file.cell_data[word];
            values.resize(cells);
            for (double& value : values) in >> value;
        }
    }
    return file;
}

TEST(VtkText, HasBlocksAndTracesWithTheirData) {
    SlopeModel model = rectangle(4, 2);
    add_trace(model, {{1, -1}, {1, 3}}, "left joint");
    add_trace(model, {{2, 1}, {3, 1}}, "crack");
    const CutResult result = cut(model);
    const std::string text = vtk_text(result.mesh, model.traces);
    EXPECT_THAT(text, testing::StartsWith("# vtk DataFile Version 3.0\n"));
    EXPECT_THAT(text, HasSubstr("left%20joint"));
    const VtkFile file = read_vtk(text);
    EXPECT_EQ(file.points.size(), result.mesh.vertices.size() + 4);
    ASSERT_EQ(file.lines.size(), 2u);
    EXPECT_EQ(file.points[file.lines[1][1]], (Point{3, 1}));
    ASSERT_EQ(file.polygons.size(), 2u);
    EXPECT_EQ(file.cell_data.at("area"), (std::vector<double>{0, 0, 2, 6}));
    EXPECT_EQ(file.cell_data.at("block"), (std::vector<double>{-1, -1, 0, 1}));
    EXPECT_EQ(file.cell_data.at("set"), (std::vector<double>{0, 1, -1, -1}));
    EXPECT_EQ(file.cell_data.at("motion"), (std::vector<double>{-1, -1, 0, 0}));
    EXPECT_EQ(file.cell_data.at("kind"), (std::vector<double>{1, 1, 0, 0}));
}

TEST(VtkText, HasTheWaterTableAfterTheTraces) {
    SlopeModel model = rectangle(4, 2);
    add_trace(model, {{1, -1}, {1, 3}}, "joint");
    model.water_table = {{1, 0.5}, {9, 1.5}};
    const VtkFile file = read_vtk(vtk_text(cut(model).mesh, model.traces));
    ASSERT_EQ(file.lines.size(), 2u);
    std::vector<Point> water;
    for (const std::size_t k : file.lines[1]) water.push_back(file.points[k]);
    EXPECT_EQ(water, (std::vector<Point>{{0, 0.5}, {1, 0.5}, {4, 0.875}}));
    EXPECT_EQ(file.cell_data.at("kind"), (std::vector<double>{1, 2, 0, 0}));
    EXPECT_EQ(file.cell_data.at("trace"), (std::vector<double>{0, -1, -1, -1}));
    EXPECT_EQ(file.cell_data.at("set"), (std::vector<double>{0, -1, -1, -1}));
    EXPECT_EQ(file.cell_data.at("block"), (std::vector<double>{-1, -1, 0, 1}));
}

// With holes joined by slits the polygons keep the areas of the blocks, for cavities and for islands alike.
TEST(VtkText, JoinsHolesBySlits) {
    SlopeModel model = rectangle(10, 10);
    model.holes = {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {{7, 7}, {8, 7}, {8, 8}, {7, 8}}};
    add_trace(model, {{4, 4}, {6, 4}, {6, 6}, {4, 6}, {4, 4}}, "island");
    const CutResult result = cut(model);
    const VtkFile file = read_vtk(vtk_text(result.mesh, {}));
    ASSERT_EQ(file.polygons.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        Ring ring;
        for (const std::size_t corner : file.polygons[k]) ring.push_back(file.points[corner]);
        EXPECT_NEAR(twice_signed_area(ring) / 2, file.cell_data.at("area")[k], 1e-9);
    }
    EXPECT_EQ(file.polygons[0].size() + file.polygons[1].size(), 4u + 4 * 4 + 3 * 2);
}

}  // namespace
}  // namespace rockslope::blockgen::vtk_text_test
