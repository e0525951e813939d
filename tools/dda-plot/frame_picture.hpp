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
    /// Times of the complete frames, s. A killed run may have written a frame of blocks without contacts.
    const std::vector<double>& times() const { return times_; }
    dda::GridFrame blocks(std::int64_t index) const;
    dda::GridFrame contacts(std::int64_t index) const;
    /// The contacts with the given columns.
    dda::GridFrame contacts(std::int64_t index, const std::vector<std::string>& columns) const;

  private:
    std::string name_;
    std::vector<double> times_;
    std::optional<dda::VtkHdfReader> blocks_;
    std::optional<dda::VtkHdfReader> contacts_;
};

/// The colour scale and the view that all pictures of a series share, so that they can be compared.
struct PictureScale {
    double largest = 0;          ///< m, displacement at the dark end of the colours
    double farthest = 0;         ///< m, the largest displacement of a free block
    double left = 0, right = 0;  ///< m, the part of the plane that is shown
    double bottom = 0, top = 0;
    bool relative_to_base = false;  ///< displacements are relative to the first prescribed block
};

/// The scale for the given frames. @param largest displacement at the end of the colours, m; by default a
/// round length that covers 99 % of the free blocks' area in every frame.
PictureScale common_scale(const RunFrames& run, const std::vector<std::int64_t>& frames,
                          std::optional<double> largest = std::nullopt);

/// The same colour scale with a view around a contact, sized by the smaller of its two blocks.
/// @throws InputError when the frame does not contain these blocks.
PictureScale scale_around_contact(const dda::WorstContact& contact, const RunFrames& run, std::int64_t index,
                                  PictureScale scale);

/// Draws the blocks coloured by the magnitude of their displacement, marks sliding contacts and open joints,
/// and prints the time as the title. @param worst contact to mark by a ring, heavy outlines of its blocks and
/// a caption.
Canvas draw_frame(const RunFrames& run, std::int64_t index, const PictureScale& scale,
                  const std::optional<dda::WorstContact>& worst = std::nullopt);

/// Draws the joints coloured by their mobilised roughness over the peak roughness; wear reduces it. Joints
/// without roughness and open joints are grey.
Canvas draw_roughness(const RunFrames& run, std::int64_t index, const PictureScale& scale);

/// Whether roughness is mobilised at any contact of a frame.
bool has_roughness(const RunFrames& run, std::int64_t index);

}  // namespace rockslope
