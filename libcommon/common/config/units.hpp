#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rockslope {

enum class Dimension;

/// The factor from a unit of the dimension to SI ("deg" -> pi/180); nothing when the dimension does not know
/// the unit.
std::optional<double> unit_factor(Dimension dimension, std::string_view unit);

/// What a value of the dimension looks like, for messages: "an angle such as "35 deg" (deg, rad)".
std::string describe(Dimension dimension);

/// The unit in which a bare number of the dimension is meant, for headings and comments; empty for a pure
/// number.
std::string_view si_unit(Dimension dimension);

}  // namespace rockslope
