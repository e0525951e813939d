#pragma once

#include <cmath>
#include <vector>

#include "dda/joint/shear_step.hpp"
#include "support/shaken_block.hpp"

namespace rockslope::scene {

/// The motion of a block on a joint, relative to the base.
struct BlockTrack {
    std::vector<double> time;  ///< s, of shaking
    std::vector<double> slip;  ///< m, down the plane
    std::vector<double> rise;  ///< m, normal to it

    /// The first instant that is not before `t`.
    Expected at(double t) const {
        const auto after = std::lower_bound(time.begin(), time.end(), t - 1e-9) - time.begin();
        return {time.at(after), slip.at(after), rise.at(after)};
    }
};

/// A rigid block on one square metre of joint, of two degrees of freedom: m (u'' + a_t) = m g sin(psi) - S
/// and m (n'' + a_n) = N - m g cos(psi), with the shear force S and the dilation d_n of the joint's law, and
/// N = k_n p + 2 zeta sqrt(k_n m) p' >= 0 while p = d_n - n > 0. It starts at rest, with its weight on the
/// joint's springs. Explicit steps of 5 microseconds; it has neither blocks that deform nor contacts to
/// search for.
/// @param damping zeta.
inline BlockTrack rigid_motion(const Shaken& block, double damping = 1) {
    constexpr double normal_stiffness = 5e10, dt = 5e-6, length = 1;
    constexpr int kept_every = 200;
    const double psi = radians(block.psi), mass = block.density * block.height;
    const double dashpot = 2 * damping * std::sqrt(normal_stiffness * mass);
    const double weight = mass * g * std::cos(psi), drive = mass * g * std::sin(psi);
    dda::ShearedJoint joint;
    joint.history = dda::fresh_history(block.law, true);
    const auto spring = [&] {
        if (block.shear_stiffness > 0) return block.shear_stiffness;
        return dda::shear_stiffness(block.law, joint.history, weight, length);
    };
    joint = dda::shear(block.law, joint, 0, {weight, length, spring()});
    joint = dda::shear(block.law, joint, drive / spring(), {weight, length, spring()});
    double dilated = dda::dilation(block.law, joint.history), before = dilated;
    double normal = weight, along = 0, up = 0, slip = 0;
    const double start = dilated - weight / normal_stiffness;
    double rise = start;
    BlockTrack track{{0}, {0}, {0}};
    const int steps = static_cast<int>(std::lround(block.expected.back().time / dt));
    for (int k = 1; k <= steps; ++k) {
        const double t = (k - 0.5) * dt;
        const double ax = block.acceleration(t), ay = block.vertical ? block.vertical(t) : 0;
        along += dt * ((drive - joint.shear_force) / mass - (ax * std::cos(psi) - ay * std::sin(psi)));
        up += dt * ((normal - weight) / mass - (ax * std::sin(psi) + ay * std::cos(psi)));
        slip += along * dt;
        rise += up * dt;
        const double closing = (dilated - before) / dt - up;
        const double overlap = dilated - rise;
        normal = overlap > 0 ? std::max(normal_stiffness * overlap + dashpot * closing, 0.0) : 0;
        joint = dda::shear(block.law, joint, along * dt, {normal, length, spring(), dda::StepTime(dt)});
        before = dilated;
        dilated = dda::dilation(block.law, joint.history);
        if (k % kept_every != 0) continue;
        track.time.push_back(k * dt);
        track.slip.push_back(slip);
        track.rise.push_back(rise - start);
    }
    return track;
}

}  // namespace rockslope::scene
