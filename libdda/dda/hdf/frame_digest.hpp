#pragma once

#include <string>
#include <vector>

#include "common/base/sha256.hpp"
#include "dda/hdf/grid_frame.hpp"

namespace rockslope::dda {

/// The digest of frames as a file gives them back. HDF5 does not detect a damaged number.
class FrameDigest {
  public:
    /// Takes a frame. @param columns, point_columns names of its data, in their order there.
    /// @param cells digest of its cells.
    void add(const GridFrame& frame, const std::vector<std::string>& columns,
             const std::vector<std::string>& point_columns, const std::string& cells);
    /// The digest of the frames so far.
    std::string digest() const { return sum_.digest(); }

    /// The digest of cells.
    static std::string of_cells(const GridCells& cells);

  private:
    void add_columns(const std::vector<std::vector<float>>& columns, const std::vector<std::string>& names);

    Sha256 sum_;
};

}  // namespace rockslope::dda
