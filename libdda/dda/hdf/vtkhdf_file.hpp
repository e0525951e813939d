#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dda/hdf/hdf.hpp"

namespace rockslope::dda {

/// The cells of an unstructured grid: cell c has the points connectivity[offsets[c]] ...
/// connectivity[offsets[c + 1] - 1].
struct GridCells {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets = {0};
    std::vector<std::uint8_t> types;  ///< VTK's: 1 vertex, 3 line, 7 polygon

    std::size_t count() const { return types.size(); }
    void add(const std::vector<std::int64_t>& points, std::uint8_t type);
};

/// A quantity with `width` components per cell.
struct GridColumn {
    std::string name;
    int width = 1;
};

/// One frame: coordinates (x, y, z per point), the values of every column and, if they change from frame to
/// frame, the cells.
struct GridFrame {
    double time = 0;
    std::vector<double> points;
    std::vector<std::vector<float>> columns;
    GridCells cells;
};

/// A VTKHDF 2.0 temporal UnstructuredGrid that grows frame by frame, see docs/formats/results.md. After
/// append() the file on disk is complete: a killed process loses no frame.
class VtkHdfFile {
  public:
    /// A file whose cells are constant and written once. @param points type of coordinates, f4 or f8.
    VtkHdfFile(const std::filesystem::path& path, std::vector<GridColumn> columns, HdfType points,
               const GridCells& cells, std::size_t point_count);
    /// A file in which every frame has its own cells, as a part. @param typical_cells sizes the chunks.
    VtkHdfFile(const std::filesystem::path& path, std::vector<GridColumn> columns, HdfType points,
               std::size_t typical_cells);

    /// @throws OutputError if a value is not finite (nothing is written), or if the disk is full (earlier
    /// frames stay intact).
    void append(const GridFrame& frame);
    /// Number of frames in the file.
    std::int64_t frame_count() const { return frame_count_; }
    /// The path that the file was opened with.
    const std::filesystem::path& path() const { return file_.path(); }
    void rename_to(const std::filesystem::path& path) { file_.rename_to(path); }

  private:
    VtkHdfFile(const std::filesystem::path& path, std::vector<GridColumn> columns, HdfType points,
               bool fixed_cells);
    void add_column_datasets(std::size_t cell_chunk);
    void check(const GridFrame& frame) const;
    void append_steps(const GridFrame& frame);

    HdfFile file_;
    std::vector<GridColumn> columns_;
    HdfType points_;
    bool fixed_cells_;
    std::int64_t frame_count_ = 0;
    std::int64_t points_before_ = 0;
    std::int64_t cells_before_ = 0;
    std::int64_t connectivity_before_ = 0;
};

/// Reads a file of VtkHdfFile, also while it is being written.
class VtkHdfReader {
  public:
    explicit VtkHdfReader(const std::filesystem::path& path);

    /// Number of frames in the file.
    std::int64_t frame_count() const { return static_cast<std::int64_t>(times_.size()); }
    /// The times of the frames, s.
    const std::vector<double>& times() const { return times_; }
    /// The names of the data of a frame.
    const std::vector<std::string>& column_names() const { return names_; }
    /// A frame with the given columns, in their order. @throws OutputError if a column is missing.
    GridFrame frame(std::int64_t index, const std::vector<std::string>& columns) const;

  private:
    std::int64_t step(const std::string& name, std::int64_t index) const;

    HdfFile file_;
    std::vector<double> times_;
    std::vector<std::string> names_;
};

}  // namespace rockslope::dda
