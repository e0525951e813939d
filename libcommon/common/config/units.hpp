#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rockslope {

enum class Dimension;

/// Factor from a unit of the dimension to SI ("deg" -> pi/180). Nothing if it is no unit of the dimension.
std::optional<double> unit_factor(Dimension dimension, std::string_view unit);

/// Description of a value of the dimension for messages: "an angle such as "35 deg" (deg, rad)".
std::string describe(Dimension dimension);

}  // namespace rockslope
