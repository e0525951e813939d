#pragma once

#include "dda/joint/asperity_wear.hpp"

namespace dda {

/// Plesha's joint: one order of asperities whose angle decays with the plastic work, Eq. (64) with one term.
/// Source: Plesha (1987), from which the form of the law is known; the numbers of a joint are the user's.
/// Limits: the asperities are symmetric about the origin, and no crushing but by work; the law has no
/// dependence of the angle on stress.
struct Plesha {
    static constexpr const char* name = "plesha";

    double friction_angle = 0;  ///< phi of the flat surface, rad
    double asperity_angle = 0;  ///< a, rad, not negative; with friction_angle below pi/2
    double wear = 0;            ///< c, m2/J, not negative

    struct History : AsperityHistory {
        friend bool operator==(const History&, const History&) = default;
    };

    History fresh(bool) const { return {}; }
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial) const {
        return asperity_strength(surface(), history, normal_force, length, trial);
    }
    Strength strength_slope(const History& history, double normal_force, double) const {
        return asperity_slope(surface(), history, normal_force);
    }
    History advance(const History& history, const ContactMotion& motion) const {
        return {asperity_advance(surface(), history, motion)};
    }
    JointRecord record(const History& history) const {
        return {JointStage::none, asperity_angle > 0 ? surface().angle(history.work) / asperity_angle : 0,
                history.dilation, 0, 0};
    }

  private:
    AsperitySurface surface() const { return {friction_angle, {{{asperity_angle, wear}, {}}}}; }
};

}  // namespace dda
