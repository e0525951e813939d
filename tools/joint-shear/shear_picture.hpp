#pragma once

#include <optional>
#include <vector>

#include "common/drawing/canvas.hpp"
#include "dda/laboratory/read_shear_test.hpp"
#include "dda/laboratory/shear_table.hpp"

namespace rockslope {

/// Draws shear stress, dilation and, if it is not constant, normal stress against displacement, with measured
/// points as circles.
Canvas draw_shear_test(const dda::ShearTestInput& input, const std::vector<dda::ShearTestRow>& rows,
                       const std::optional<dda::ShearTable>& measured);

}  // namespace rockslope
