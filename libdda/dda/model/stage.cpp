#include "dda/model/stage.hpp"

#include <cmath>

namespace rockslope::dda {

double next_step_multiple(const Stage& stage, double stage_time) {
    constexpr double rounding = 1e-9;  // fraction of a step; exceeds the rounding of a sum of many steps
    return (std::floor(stage_time / stage.control.step + rounding) + 1) * stage.control.step;
}

}  // namespace rockslope::dda
