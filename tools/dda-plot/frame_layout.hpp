#pragma once

#include "common/drawing/page_style.hpp"
#include "common/geometry/point.hpp"

namespace rockslope {

/// Layout of the picture of a frame, in units of the page. The drawing is as large as the page allows, with
/// the same scale in x and y. A low drawing, or one on a narrow page, has the colour bar below it; a narrow
/// drawing is centred under the header.
struct FrameLayout {
    static constexpr double bar_gap = 16;
    static constexpr double top = 34, below_axes = 44;  ///< heights above and below the axes

    Point upper_left, lower_right;  ///< of the axes
    double header_left, header_right;
    double page_width, page_height;
    bool bar_is_vertical;

    /// @param width, height of the part of the section that is shown, m.
    FrameLayout(double width, double height, const PageStyle& style);
};

}  // namespace rockslope
