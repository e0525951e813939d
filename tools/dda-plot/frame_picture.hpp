#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colour_bar.hpp"
#include "common/drawing/canvas.hpp"
#include "dda/results/read_summary.hpp"
#include "frame_field.hpp"
#include "run_frames.hpp"

namespace rockslope {

/// What the picture of a frame shows.
struct FrameContent {
    const FrameField* field = &frame_fields().front();
    double exaggeration = 1;  ///< factor of the displacements of the corners
    bool labels_blocks = false;
    bool labels_joints = false;
    std::string mechanism = {};  ///< in the title of the last frame in place of its time; may be empty
};

/// The colours and the view that all pictures of a series share, so that they can be compared.
struct PictureScale {
    ColourRange colours;
    double left = 0, right = 0;  ///< m, the part of the plane that is shown
    double bottom = 0, top = 0;
    bool relative_to_base = false;  ///< displacements are relative to the first prescribed block
};

/// The scale for the given frames. @param largest value at the end of the colours, SI unit; by default a
/// round value that covers 99 % of the area of the free blocks, or of the length of the contacts, in every
/// frame.
PictureScale common_scale(const RunFrames& run, const std::vector<std::int64_t>& frames,
                          const FrameContent& content, std::optional<double> largest = std::nullopt);

/// The same colour scale with a view around a contact, sized by the smaller of its two blocks.
/// @throws InputError when the frame does not contain these blocks.
PictureScale scale_around_contact(const dda::WorstContact& contact, const RunFrames& run, std::int64_t index,
                                  PictureScale scale);

/// The blocks of a frame with the given columns, at displacements multiplied by the factor.
/// @throws InputError for a factor other than 1 where the frames have no displacements of corners.
dda::GridFrame exaggerated_blocks(const RunFrames& run, std::int64_t index, double factor,
                                  const std::vector<std::string>& columns = {});

/// Draws the blocks or the contacts coloured by a field, marks sliding contacts and open joints, and prints
/// stage and time as the title. @param worst contact to mark by a ring, heavy outlines of its blocks and a
/// caption.
Canvas draw_frame(const RunFrames& run, std::int64_t index, const PictureScale& scale,
                  const FrameContent& content, const PageStyle& style = {},
                  const std::optional<dda::WorstContact>& worst = std::nullopt);

/// Draws the joints coloured by their mobilised roughness over the peak roughness; wear reduces it. Joints
/// without roughness and open joints are grey.
Canvas draw_roughness(const RunFrames& run, std::int64_t index, const PictureScale& scale,
                      const PageStyle& style = {});

/// Whether roughness is mobilised at any contact of a frame.
bool has_roughness(const RunFrames& run, std::int64_t index);

}  // namespace rockslope
