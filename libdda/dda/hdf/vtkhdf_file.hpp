#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dda/hdf/frame_digest.hpp"
#include "dda/hdf/grid_frame.hpp"  // IWYU pragma: export
#include "dda/hdf/hdf.hpp"

namespace rockslope::dda {

/// A VTKHDF 2.0 temporal UnstructuredGrid that grows frame by frame, see docs/formats/results.md. After
/// append() the file on disk is complete: a killed process loses no frame.
class VtkHdfFile {
  public:
    /// A file whose cells are constant and written once.
    VtkHdfFile(const std::filesystem::path& path, GridLayout layout, const GridCells& cells,
               std::size_t point_count);
    /// A file in which every frame has its own cells, as a part. @param typical_cells sizes the chunks.
    VtkHdfFile(const std::filesystem::path& path, GridLayout layout, std::size_t typical_cells);

    /// @throws OutputError if a value is not finite (nothing is written), or if the disk is full (earlier
    /// frames stay intact).
    void append(const GridFrame& frame);
    /// Waits until the frames are on the disk.
    void sync() const { file_.sync(); }
    /// Number of frames in the file.
    std::int64_t frame_count() const { return frame_count_; }
    /// The digest of these frames, that of a VtkHdfReader.
    std::string digest() const { return digest_.digest(); }
    /// The path that the file was opened with.
    const std::filesystem::path& path() const { return file_.path(); }
    /// Sets the path that messages name, for a file that will be renamed.
    void show_as(const std::filesystem::path& path) { file_.show_as(path); }

  private:
    /// Rows that a frame takes of the datasets.
    struct Rows {
        std::size_t points, cells, connectivity, parts;
    };

    VtkHdfFile(const std::filesystem::path& path, GridLayout layout, std::size_t cell_chunk,
               bool fixed_cells);
    void add_text_datasets();
    void add_column_datasets(std::size_t cell_chunk, std::size_t point_chunk);
    void check(const GridFrame& frame) const;
    void add_to_digest(const GridFrame& frame);
    Rows rows_of(const GridFrame& frame) const;
    void append_steps(const GridFrame& frame);
    void append_cells(const GridFrame& frame, const Rows& rows);
    template <class T>
    void append_padded(const std::string& name, std::vector<T> values, std::size_t count);

    HdfFile file_;
    GridLayout layout_;
    std::size_t cell_chunk_;  ///< rows of a chunk of the cells, where frames have their own
    bool fixed_cells_;
    std::string cells_;  ///< digest of the fixed cells
    FrameDigest digest_;
    std::vector<std::string> stages_;  ///< names of the stages so far
    std::int64_t frame_count_ = 0;
    Rows before_ = {};  ///< rows of the frames so far
};

/// Reads a file of VtkHdfFile, also while it is being written.
class VtkHdfReader {
  public:
    explicit VtkHdfReader(const std::filesystem::path& path);

    /// Number of frames in the file.
    std::int64_t frame_count() const { return static_cast<std::int64_t>(times_.size()); }
    /// The times of the frames, s.
    const std::vector<double>& times() const { return times_; }
    /// A frame with the given columns of the cells and of the points, in their order. @throws OutputError if
    /// a column is missing.
    GridFrame frame(std::int64_t index, const std::vector<std::string>& columns,
                    const std::vector<std::string>& point_columns = {}) const;
    /// The digest of the first frames, all their data. @throws OutputError if one cannot be read.
    std::string digest(std::int64_t frames) const;
    /// Whether the points have a quantity of that name.
    bool has_point_column(const std::string& name) const;
    /// Name of the stage of each frame; empty in a file of an older version.
    const std::vector<std::string>& stages() const { return stages_; }
    /// The text of that name; nothing if the file has none.
    std::string text(const std::string& name) const;

  private:
    std::int64_t step(const std::string& name, std::int64_t index) const;
    void read_stages();

    HdfFile file_;
    std::vector<double> times_;
    std::vector<std::string> stages_;
    std::vector<std::string> names_;
};

/// The frames of the blocks in a folder of results, NAME.vtkhdf, and those of the contacts,
/// NAME.joints.vtkhdf. Each is empty where there is none.
struct FrameFiles {
    std::string name;
    std::filesystem::path blocks, contacts;
};
/// Looks for the files of frames in a folder of results.
FrameFiles find_frame_files(const std::filesystem::path& folder);

}  // namespace rockslope::dda
