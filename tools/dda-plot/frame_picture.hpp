#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/drawing/canvas.hpp"
#include "dda/hdf/vtkhdf_file.hpp"
#include "dda/results/read_summary.hpp"

namespace rockslope {

/// The frames of a run: its blocks and its contacts.
class RunFrames {
  public:
    /// Finds NAME.vtkhdf and NAME.joints.vtkhdf in a result folder. @throws InputError when there
    /// are none.
    explicit RunFrames(const std::filesystem::path& folder);

    const std::string& name() const { return name_; }
    /// s, of the frames that are whole: a run that was killed may have left its blocks without their
    /// contacts.
    const std::vector<double>& times() const { return times_; }
    dda::GridFrame blocks(std::int64_t index) const;
    dda::GridFrame contacts(std::int64_t index) const;
    /// The contacts with other columns than the state.
    dda::GridFrame contacts(std::int64_t index, const std::vector<std::string>& columns) const;

  private:
    std::string name_;
    std::vector<double> times_;
    std::optional<dda::VtkHdfReader> blocks_;
    std::optional<dda::VtkHdfReader> contacts_;
};

/// What all pictures of a series share, so that they can be compared.
struct PictureScale {
    double largest = 0;          ///< m, displacement at the dark end of the colours
    double farthest = 0;         ///< m, the largest displacement of a free block
    double left = 0, right = 0;  ///< m, the part of the plane that is shown
    double bottom = 0, top = 0;
    bool relative_to_base = false;  ///< displacements are those relative to the first prescribed block
};

/// The scale that fits the given frames. @param largest m, where the colours shall end; without it at a round
/// length that in every frame covers 99 % of the free blocks' area.
PictureScale common_scale(const RunFrames& run, const std::vector<std::int64_t>& frames,
                          std::optional<double> largest = std::nullopt);

/// The same scale over the neighbourhood of a contact only: about the smaller of its two blocks.
/// @throws InputError when the frame has no such blocks.
PictureScale scale_around_contact(const dda::WorstContact& contact, const RunFrames& run, std::int64_t index,
                                  PictureScale scale);

/// Blocks coloured by the magnitude of their displacement, sliding contacts and open joints marked, the time
/// in the title. @param worst is ringed, its blocks have heavy outlines, and a line below names them.
Canvas draw_frame(const RunFrames& run, std::int64_t index, const PictureScale& scale,
                  const std::optional<dda::WorstContact>& worst = std::nullopt);

}  // namespace rockslope
