#pragma once

#include "frame_picture.hpp"

namespace rockslope {

/// Joints coloured by the roughness that is at work on them, over the peak roughness: what repeated shearing
/// has worn off is missing. Joints without roughness and open ones are grey.
Canvas draw_roughness(const RunFrames& run, std::int64_t index, const PictureScale& scale);

/// Whether roughness is at work anywhere in a frame.
bool has_roughness(const RunFrames& run, std::int64_t index);

}  // namespace rockslope
