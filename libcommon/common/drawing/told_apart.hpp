#pragma once

#include <vector>

#include "common/drawing/canvas.hpp"

namespace rockslope {

/// The stroke of a line of a panel: dashed where it coincides on the page, within a line's width, with one
/// that is drawn already, so that both are seen. @param drawn the lines so far.
Stroke told_apart(Stroke stroke, const std::vector<Point>& line,
                  const std::vector<std::vector<Point>>& drawn);

}  // namespace rockslope
