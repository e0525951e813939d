#pragma once

#include <vector>

#include "common/geometry/point.hpp"
#include "dda/hdf/vtkhdf_file.hpp"

namespace rockslope {

/// Layout of the picture of a frame, pt. The drawing is as large as the page allows, with the same scale in x
/// and y. A low drawing has the colour bar below it; a narrow drawing is centred under the header.
struct FrameLayout {
    static constexpr double left = 60, top = 34, below_axes = 44, bar_gap = 16, margin_right = 16;

    Point upper_left, lower_right;  ///< of the axes
    double header_left, header_right;
    double page_width, page_height;
    bool bar_is_vertical;

    /// @param width, height of the part of the section that is shown, m.
    FrameLayout(double width, double height);
};

/// The corners of a cell of a frame, m.
std::vector<Point> cell_points(const dda::GridFrame& frame, std::size_t cell);

}  // namespace rockslope
