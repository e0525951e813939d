#pragma once

#include "common/drawing/axes.hpp"
#include "common/drawing/fitted_text.hpp"
#include "run_frames.hpp"

namespace rockslope {

/// Writes the number of each block into it, where it is large enough and no other label is in the way.
/// @param blocks with the numbers as first column.
void label_blocks(Canvas& canvas, const Axes& axes, const dda::GridFrame& blocks, Labels& labels);

/// Writes the name of each set of joints along the longest of its contacts that has room for it; where none
/// has, beside the longest one. @param contacts with the number of the joint as first column. @param names of
/// the joints by their numbers.
void label_joints(Canvas& canvas, const Axes& axes, const dda::GridFrame& contacts,
                  const std::vector<std::string>& names, Labels& labels);

}  // namespace rockslope
