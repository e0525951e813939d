#include "dda/monitor/low_pass.hpp"

#include <cmath>
#include <numbers>

namespace rockslope::dda {

const Vec2& LowPass::pass(const Vec2& input, double step, double corner) {
    // The exact solution for an input that is constant in the step.
    const double share = -std::expm1(-2 * std::numbers::pi * corner * step);
    first += share * (input - first);
    second += share * (first - second);
    return second;
}

}  // namespace rockslope::dda
