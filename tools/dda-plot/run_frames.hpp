#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/point.hpp"
#include "dda/hdf/vtkhdf_file.hpp"

namespace rockslope {

/// The frames of a run: its blocks and, where they were written, its contacts.
class RunFrames {
  public:
    /// Finds NAME.vtkhdf in a result folder, and NAME.joints.vtkhdf. @throws InputError when there is none.
    explicit RunFrames(const std::filesystem::path& folder);

    const std::string& name() const { return name_; }
    /// Times of the complete frames, s. A killed run may have written a frame of blocks without contacts.
    const std::vector<double>& times() const { return times_; }
    /// The blocks with the given columns of the cells and of the points, and their motion last.
    dda::GridFrame blocks(std::int64_t index, std::vector<std::string> columns = {},
                          const std::vector<std::string>& point_columns = {}) const;
    /// The contacts with the given columns; none where the run has no file of them.
    dda::GridFrame contacts(std::int64_t index, const std::vector<std::string>& columns) const;
    /// Whether the frames have the displacements of the points; those of older versions do not.
    bool has_point_displacements() const;

    /// "shake, 12.000 s": the stage of a frame and the time since its first frame; the time since the start
    /// of the run where the file does not name stages.
    std::string title(std::int64_t index) const;
    /// The names of the materials of blocks and joints, and of the sets of joints, by their numbers.
    std::vector<std::string> block_materials() const;
    std::vector<std::string> joint_materials() const;
    std::vector<std::string> joints() const;
    /// Name of the stage of a frame; empty where the file does not name stages.
    const std::string& stage(std::int64_t index) const;

  private:
    std::string name_;
    std::vector<double> times_;
    std::optional<dda::VtkHdfReader> blocks_;
    std::optional<dda::VtkHdfReader> contacts_;
};

/// Values of the column "motion" of the blocks.
inline constexpr float motion_free = 0, motion_prescribed = 2;

/// Values of the column "state" of the contacts.
inline constexpr float state_open = 0, state_sliding = 1;

/// The corners of a cell of a frame, m.
std::vector<Point> cell_points(const dda::GridFrame& frame, std::size_t cell);

/// The area of a cell, m2.
double cell_area(const dda::GridFrame& frame, std::size_t cell);

/// The cell of the base, the first prescribed block of a frame of blocks(); nothing when there is none.
std::optional<std::size_t> base_cell(const dda::GridFrame& frame);

}  // namespace rockslope
