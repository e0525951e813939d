#include "record/newmark_block.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rockslope::record {

void RigidSlider::advance(double drive, double pressure, double dt) {
    const double bound = strength_.friction * std::max(pressure, 0.0) + strength_.adhesion;
    double next = 0;
    if (speed_ != 0 || std::abs(drive) > bound) {
        const double direction = speed_ != 0 ? speed_ : drive;
        strength_ = residual_;
        next = speed_ + dt * (drive - std::copysign(bound, direction));
        if (next * direction < 0) next = 0;
    }
    slip_ += dt * (speed_ + next) / 2;
    speed_ = next;
}

double yield_coefficient(const SlidingPlane& plane) {
    return std::tan(plane.friction - plane.dip);
}

std::vector<double> newmark_slip(const Accelerogram& record, const SlidingPlane& plane, double gravity) {
    const auto in_range = [](double angle) { return angle >= 0 && angle < std::numbers::pi / 2; };
    if (!in_range(plane.dip) || !in_range(plane.friction))
        throw std::invalid_argument("dip and friction must be at least 0 and below 90 degrees");
    const double sine = std::sin(plane.dip), cosine = std::cos(plane.dip), mu = std::tan(plane.friction);
    const int substeps = std::max(1, static_cast<int>(std::ceil(record.step / max_sliding_substep)));
    const double dt = record.step / substeps;
    RigidSlider block({mu, 0}, {mu, 0});
    std::vector<double> slip(record.values.size(), 0.0);
    for (std::size_t k = 1; k < slip.size(); ++k) {
        for (int i = 0; i < substeps; ++i) {
            const double a = std::lerp(record.values[k - 1], record.values[k], (i + 0.5) / substeps);
            block.advance(gravity * sine - a * cosine, gravity * cosine + a * sine, dt);
        }
        slip[k] = block.slip();
    }
    return slip;
}

}  // namespace rockslope::record
