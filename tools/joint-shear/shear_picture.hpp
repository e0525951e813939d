#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/drawing/canvas.hpp"
#include "dda/laboratory/read_shear_test.hpp"
#include "dda/laboratory/shear_table.hpp"

namespace rockslope {

/// The points that a computed curve is compared with.
struct ComparedPoints {
    dda::ShearTable table;
    std::string origin;  ///< "measured" in a laboratory, or "blocks" computed by a run
};

/// Draws shear stress, dilation and, if it is not constant, normal stress against displacement, with the
/// points to compare as circles.
Canvas draw_shear_test(const dda::ShearTestInput& input, const std::vector<dda::ShearTestRow>& rows,
                       const std::optional<ComparedPoints>& compared, const PageStyle& style = {});

}  // namespace rockslope
