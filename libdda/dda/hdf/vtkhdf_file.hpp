#pragma once

#include <filesystem>
#include <optional>
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

/// A quantity of the cells with `width` components each.
struct GridColumn {
    std::string name;
    int width = 1;
};

/// One instant: coordinates (x, y, z per point), the values of every column, and the cells where they change
/// from frame to frame.
struct GridFrame {
    double time = 0;
    std::vector<double> points;
    std::vector<std::vector<float>> columns;
    GridCells cells;
};

/// A VTKHDF 2.0 temporal UnstructuredGrid that grows frame by frame: see docs/formats/results.md. After
/// append() the file on disk is whole: killing the process loses no frame.
class VtkHdfFile {
  public:
    /// A file whose cells stay the same: written once. Coordinates are stored as `points`, f4 or f8.
    VtkHdfFile(const std::filesystem::path& path, std::vector<GridColumn> columns, HdfType points,
               const GridCells& cells, std::size_t point_count);
    /// A file whose frames bring their own cells; each frame is a part. `typical_cells` sizes the storage.
    VtkHdfFile(const std::filesystem::path& path, std::vector<GridColumn> columns, HdfType points,
               std::size_t typical_cells);

    /// @throws OutputError when a value is not finite (nothing is written then), or the disk is full (earlier
    /// frames stay good).
    void append(const GridFrame& frame);
    std::int64_t frame_count() const { return frame_count_; }
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

/// Reads what VtkHdfFile wrote, also while it is being written.
class VtkHdfReader {
  public:
    explicit VtkHdfReader(const std::filesystem::path& path);

    std::int64_t frame_count() const { return static_cast<std::int64_t>(times_.size()); }
    const std::vector<double>& times() const { return times_; }
    const std::vector<std::string>& column_names() const { return names_; }
    /// The frame's columns stand in the order of `columns`. @throws OutputError when a column is missing.
    GridFrame frame(std::int64_t index, const std::vector<std::string>& columns) const;

  private:
    std::int64_t step(const std::string& name, std::int64_t index) const;

    HdfFile file_;
    std::vector<double> times_;
    std::vector<std::string> names_;
};

}  // namespace rockslope::dda
