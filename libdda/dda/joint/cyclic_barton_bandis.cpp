#include "dda/joint/cyclic_barton_bandis.hpp"

#include <algorithm>
#include <cmath>

#include "dda/joint/cyclic_stretch.hpp"
#include "dda/joint/cyclic_walk.hpp"

namespace dda {

Strength CyclicBartonBandis::strength(const History& history, double normal_force, double length,
                                      const ShearTrial& trial) const {
    if (!(normal_force > 0)) return {};
    if (trial.stiffness > 0 && trial.displacement != 0) {
        if (const auto found = strength_on_stretch(*this, history, normal_force, length, trial))
            return *found;
    }
    CyclicWalk walk(*this, history, normal_force, length, trial.stiffness, trial.shear_force,
                    CyclicWalk::Purpose::strength);
    if (trial.displacement == 0) return {walk.bound(1), walk.bound(-1), 0};
    if (trial.stiffness > 0)
        walk.go(trial.displacement);
    else
        walk.go_as_told(trial.displacement, 0);
    Strength s = walk.bounds_at_end();
    // What slipped on the way arrives with less than the strength there, if that has jumped up meanwhile.
    if (walk.slipped()) {
        double& ahead = trial.displacement > 0 ? s.forward : s.backward;
        const double arriving = trial.displacement > 0 ? walk.shear_force() : -walk.shear_force();
        if (arriving >= 0 && arriving < ahead) ahead = arriving;
    }
    return s;
}

Strength CyclicBartonBandis::strength_slope(const History& history, double normal_force,
                                            double length) const {
    if (!(normal_force > 0)) return {};
    const CyclicWalk walk(*this, history, normal_force, length, 0, 0, CyclicWalk::Purpose::strength);
    const auto slope = [&](int direction) {
        const double ratio = walk.bound_ratio(direction);
        if (!(asymmetric && history.forward != 0 && direction != history.forward))
            return barton.slope(normal_force, stressed_length(length), ratio);
        const double roughness = barton.roughness_angle(normal_force, stressed_length(length));
        const double angle = barton.residual_friction_angle - ratio * roughness;
        const double tangent = std::tan(std::abs(angle));
        if (roughness == 0) return tangent;
        const double turning = (angle < 0 ? 1 : -1) * ratio * barton.roughness_change();
        return tangent + turning * (1 + tangent * tangent);
    };
    return {slope(1), slope(-1), 0};
}

CyclicBartonBandis::History CyclicBartonBandis::advance(const History& history,
                                                        const ContactMotion& motion) const {
    if (!(motion.normal_force > 0)) return history;
    History pressed = history;
    pressed.spring = history.spring.pressed(
        {motion.normal_force, motion.length, stressed_length(motion.length), motion.duration == 0}, barton,
        peak_displacement);
    if (motion.stiffness > 0 && motion.displacement != 0) {
        if (const auto found =
                history_on_stretch(*this, pressed, motion.normal_force, motion.length,
                                   {motion.displacement, motion.shear_force, motion.stiffness}))
            return *found;
    }
    CyclicWalk walk(*this, pressed, motion.normal_force, motion.length, motion.stiffness, motion.shear_force,
                    CyclicWalk::Purpose::history);
    if (motion.stiffness > 0)
        walk.go(motion.displacement);
    else
        walk.go_as_told(motion.displacement, motion.slip);
    return walk.history();
}

double CyclicBartonBandis::shear_stiffness(const History& history, double normal_force, double length) const {
    if (history.spring.stiffness > 0) return history.spring.of_part(length);
    return barton.shear_strength(normal_force, stressed_length(length), 1) / peak_displacement;
}

JointRecord CyclicBartonBandis::record(const History& history) const {
    return {static_cast<JointStage>(history.stage), history.mobilised_ratio, history.dilation,
            history.reversals, history.cycle};
}

}  // namespace dda
