#pragma once

#include <optional>
#include <vector>

#include "common/drawing/canvas.hpp"
#include "dda/laboratory/read_shear_test.hpp"
#include "dda/laboratory/shear_table.hpp"

namespace rockslope {

/// Shear stress, dilation and, where it changes, normal stress against displacement; measured points as
/// circles.
Canvas draw_shear_test(const dda::ShearTestInput& input, const std::vector<dda::ShearTestRow>& rows,
                       const std::optional<dda::ShearTable>& measured);

}  // namespace rockslope
