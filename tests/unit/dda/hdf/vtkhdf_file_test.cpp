#include "dda/hdf/vtkhdf_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "unit/dda/input/small_models.hpp"

namespace rockslope::dda::vtkhdf_file_test {
namespace {

constexpr std::uint8_t line = 3;

/// A frame of `count` separate lines whose quantity and coordinates tell the line.
GridFrame lines(double time, const std::string& stage, int count) {
    GridFrame frame{.time = time, .stage = stage};
    frame.columns.resize(1);
    frame.point_columns.resize(1);
    for (std::int64_t k = 0; k < count; ++k) {
        frame.points.insert(frame.points.end(), {time, 1.0 * k, 0, time + 1, 1.0 * k, 0});
        frame.cells.add({2 * k, 2 * k + 1}, line);
        frame.columns[0].push_back(static_cast<float>(100 * time + static_cast<double>(k)));
        frame.point_columns[0].insert(frame.point_columns[0].end(), 2, static_cast<float>(k));
    }
    return frame;
}

const GridLayout layout{.columns = {{"slip", 1}},
                        .point_columns = {{"displacement", 1}},
                        .texts = {{"units", "slip: m\n"}},
                        .points = HdfType::f8};

class VtkHdfFrames : public ::testing::Test {
  protected:
    io_test::Folder folder;
    std::filesystem::path path = folder / "frames.vtkhdf";
};

// A chunk holds four cells: frames of none, of a part of a chunk, of whole chunks and of several.
const std::vector<int> counts = {3, 0, 4, 11, 8, 1};

TEST_F(VtkHdfFrames, WithTheirOwnCellsReadBackAsWritten) {
    VtkHdfFile file(path, layout, 4);
    for (std::size_t k = 0; k < counts.size(); ++k)
        file.append(lines(static_cast<double>(k), k < 2 ? "settle" : "shake", counts[k]));
    const VtkHdfReader reader(path);
    ASSERT_EQ(reader.frame_count(), static_cast<std::int64_t>(counts.size()));
    EXPECT_EQ(reader.stages(),
              (std::vector<std::string>{"settle", "settle", "shake", "shake", "shake", "shake"}));
    EXPECT_EQ(reader.text("units"), "slip: m\n");
    EXPECT_EQ(reader.text("none"), "");
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const GridFrame expected = lines(static_cast<double>(k), "", counts[k]);
        const GridFrame frame = reader.frame(static_cast<std::int64_t>(k), {"slip"}, {"displacement"});
        EXPECT_EQ(frame.points, expected.points) << k;
        EXPECT_EQ(frame.columns, expected.columns) << k;
        EXPECT_EQ(frame.point_columns, expected.point_columns) << k;
        EXPECT_EQ(frame.cells.connectivity, expected.cells.connectivity) << k;
        EXPECT_EQ(frame.cells.offsets, expected.cells.offsets) << k;
        EXPECT_EQ(frame.cells.types, expected.cells.types) << k;
    }
}

// A viewer that knows nothing of times reads the parts one after the other: they must tile the datasets.
TEST_F(VtkHdfFrames, TileTheDatasetsWithTheirParts) {
    {
        VtkHdfFile file(path, layout, 4);
        for (const int count : counts) file.append(lines(0, "", count));
    }
    const HdfFile file = HdfFile::open_to_read(path);
    const auto total = [&](const std::string& name) {
        std::size_t sum = 0;
        for (const std::int64_t n : file.read_all<std::int64_t>("/VTKHDF/" + name))
            sum += static_cast<std::size_t>(n);
        return sum;
    };
    const std::size_t parts = file.row_count("/VTKHDF/NumberOfCells");
    EXPECT_EQ(total("NumberOfPoints"), file.row_count("/VTKHDF/Points"));
    EXPECT_EQ(total("NumberOfCells"), file.row_count("/VTKHDF/Types"));
    EXPECT_EQ(total("NumberOfCells"), file.row_count("/VTKHDF/CellData/slip"));
    EXPECT_EQ(total("NumberOfConnectivityIds"), file.row_count("/VTKHDF/Connectivity"));
    EXPECT_EQ(total("NumberOfCells") + parts, file.row_count("/VTKHDF/Offsets"));
    // Whole chunks only: none is ever written a second time.
    EXPECT_EQ(file.row_count("/VTKHDF/Types") % 4, 0U);
}

}  // namespace
}  // namespace rockslope::dda::vtkhdf_file_test
