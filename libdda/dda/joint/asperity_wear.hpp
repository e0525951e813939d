#pragma once

#include <array>

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// The rough surface of a joint whose asperities are worn down by the work of sliding, as it is under one
/// normal stress: what the laws of Plesha (1987) and those after him share. Eq. (70): with the plastic work W
/// per area
///
///     alpha(W) = sum over the orders of a exp(-c W),
///     tau = sigma tan(phi + alpha) away from the origin, sigma tan(phi - alpha) back to it, not below 0,
///     dW = tau dU,    d(dilation) = +- tan(alpha) dU,    with the plastic slip U.
struct AsperitySurface {
    struct Order {
        double angle = 0;  ///< a, rad, not negative
        double wear = 0;   ///< c, m2/J, not negative
    };
    double friction_angle = 0;  ///< phi, rad; with all angles below pi/2
    std::array<Order, 2> orders;
    double slope = 0;  ///< of the angles by the normal force, relative to them, m/N

    /// rad. @param work J/m2.
    double angle(double work) const;
};

/// What such a joint remembers.
struct AsperityHistory {
    double position = 0;  ///< m, from where it was fresh
    double work = 0;      ///< W, J/m2
    double dilation = 0;  ///< m
    friend bool operator==(const AsperityHistory&, const AsperityHistory&) = default;
};

/// What the joint can bear at the end of a displacement.
Strength asperity_strength(const AsperitySurface& surface, const AsperityHistory& history,
                           double normal_force, double length, const ShearTrial& trial);
/// Derivative with respect to the normal force, of a joint at rest.
Strength asperity_strength_slope(const AsperitySurface& surface, const AsperityHistory& history,
                                 double normal_force);
/// The history after a step; unchanged while the joint is open.
AsperityHistory asperity_advance(const AsperitySurface& surface, const AsperityHistory& history,
                                 const ContactMotion& motion);

/// A joint law of such a surface. @tparam Asperities its parameters: an aggregate with a `name`, and
/// `surface(normal_force, length)` that says how the surface is under a normal force (N per metre).
template <class Asperities>
struct AsperityLaw : Asperities {
    struct History : AsperityHistory {
        friend bool operator==(const History&, const History&) = default;
    };

    History fresh(bool) const { return {}; }
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial) const {
        return asperity_strength(this->surface(normal_force, length), history, normal_force, length, trial);
    }
    Strength strength_slope(const History& history, double normal_force, double length) const {
        return asperity_strength_slope(this->surface(normal_force, length), history, normal_force);
    }
    History advance(const History& history, const ContactMotion& motion) const {
        return {asperity_advance(this->surface(motion.normal_force, motion.length), history, motion)};
    }
    /// The mobilised ratio is what work has left of the angles, whatever the normal stress.
    JointRecord record(const History& history) const {
        const AsperitySurface unstressed = this->surface(0, 1);
        const double initial_angle = unstressed.angle(0);
        return {JointStage::none, initial_angle > 0 ? unstressed.angle(history.work) / initial_angle : 0,
                history.dilation, 0, 0};
    }
};

}  // namespace rockslope::dda
