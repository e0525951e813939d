#pragma once

#include "common/geometry/point.hpp"
#include "picture_style.hpp"

namespace rockslope {

/// Layout of the picture of a frame, pt. The drawing is as large as the page allows, with the same scale in x
/// and y. A low drawing, or one on a narrow page, has the colour bar below it; a narrow drawing is centred
/// under the header. Margins grow with the letters.
struct FrameLayout {
    static constexpr double bar_gap = 16;

    double letters;                 ///< factor of the sizes of text
    double top, below_axes;         ///< heights above and below the axes
    Point upper_left, lower_right;  ///< of the axes
    double header_left, header_right;
    double page_width, page_height;
    bool bar_is_vertical;

    /// @param width, height of the part of the section that is shown, m.
    FrameLayout(double width, double height, const PictureStyle& style);
};

}  // namespace rockslope
