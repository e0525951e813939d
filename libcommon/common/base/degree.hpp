#pragma once

#include <numbers>

namespace rockslope {

/// One degree, rad.
inline constexpr double degree = std::numbers::pi / 180;

}  // namespace rockslope
