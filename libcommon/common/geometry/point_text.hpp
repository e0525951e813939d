#pragma once

#include <string>

#include "common/geometry/point.hpp"

namespace rockslope {

/// "(x, y)", m, in the fewest digits.
std::string text_of(const Point& p);

}  // namespace rockslope
