#pragma once

namespace rockslope::dda {

using Scalar = double;
constexpr int round_limit = 3;

}  // namespace rockslope::dda
