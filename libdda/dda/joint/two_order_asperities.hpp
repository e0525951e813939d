#pragma once

#include "dda/joint/asperity_wear.hpp"

namespace dda {

/// Two orders of asperities, waviness and unevenness, that decay with the plastic work each at its own rate:
/// Eq. (64) with two terms. Source: Lee et al. (2001) as Ma et al. (2017) tell it, the asperity angle as the
/// sum of two; the rates are not checked against the paper. Limits: as for Plesha's.
struct TwoOrderAsperities {
    static constexpr const char* name = "two-order-asperities";

    double friction_angle = 0;    ///< phi of the flat surface, rad
    double waviness_angle = 0;    ///< rad, first order, not negative
    double waviness_wear = 0;     ///< m2/J
    double unevenness_angle = 0;  ///< rad, second order, not negative; all three angles below pi/2
    double unevenness_wear = 0;   ///< m2/J

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
        const double fresh = waviness_angle + unevenness_angle;
        return {JointStage::none, fresh > 0 ? surface().angle(history.work) / fresh : 0, history.dilation, 0,
                0};
    }

  private:
    AsperitySurface surface() const {
        return {friction_angle, {{{waviness_angle, waviness_wear}, {unevenness_angle, unevenness_wear}}}};
    }
};

}  // namespace dda
