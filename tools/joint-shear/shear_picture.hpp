#pragma once

#include <optional>
#include <vector>

#include "blockgen/picture/canvas.hpp"
#include "dda/io/read_shear_test.hpp"
#include "dda/io/shear_table.hpp"

/// Shear stress, dilation and, where it changes, normal stress against displacement; measured points as
/// circles.
blockgen::Canvas draw_shear_test(const dda::ShearTestInput& input, const std::vector<dda::ShearTestRow>& rows,
                                 const std::optional<dda::ShearTable>& measured);
