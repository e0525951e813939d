#pragma once

#include <array>

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// The surface, under one normal stress, of a joint whose asperities wear with the work of sliding: the
/// common part of the laws of Plesha (1987) and his successors. Eq. (70): with the plastic work W per area
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
    double slope = 0;  ///< relative derivative of the angles with respect to the normal force, m/N

    /// rad. @param work J/m2.
    double angle(double work) const;
};

struct AsperityHistory {
    double position = 0;  ///< m, from where it was fresh
    double work = 0;      ///< W, J/m2
    double dilation = 0;  ///< m
    /// The direction in which the joint keeps the strength that it had before it crossed its origin locked,
    /// Eq. (82); 0: none.
    double crossed = 0;
    friend bool operator==(const AsperityHistory&, const AsperityHistory&) = default;
};

/// Strength at the end of the trial displacement.
Strength asperity_strength(const AsperitySurface& surface, const AsperityHistory& history,
                           double normal_force, double length, const ShearTrial& trial);
/// Derivative of the strength at rest with respect to the normal force.
Strength asperity_strength_slope(const AsperitySurface& surface, const AsperityHistory& history,
                                 double normal_force);
/// The history after a step.
AsperityHistory asperity_advance(const AsperitySurface& surface, const AsperityHistory& history,
                                 const ContactMotion& motion);
/// The history of an open joint after a motion of its walls. All of its displacement is slip, which does no
/// work. @param surface under no normal stress.
AsperityHistory asperity_flight(const AsperitySurface& surface, const AsperityHistory& history,
                                const ContactMotion& motion);

/// An asperity angle in [0, pi/2 - below), rad. @param below sum of the friction angle and the asperity
/// angles of lower orders, rad.
double read_asperity_angle(const ParameterTable& table, const char* key, double below);
/// The wear coefficient c of one order of asperities, m2/J, by default 0.
double read_asperity_wear(const ParameterTable& table, const char* key);

/// A joint law with such a surface. @tparam Asperities its parameters: an aggregate with a `name`, a
/// `read(table)`, and `surface(normal_force, length)`, the surface under a normal force (N per metre).
template <class Asperities>
struct AsperityLaw : Asperities {
    static constexpr HistoryScope history_scope = HistoryScope::joint_segment;

    struct History : AsperityHistory {
        friend bool operator==(const History&, const History&) = default;
    };

    static constexpr NoCommonHistories<History> common_histories() { return {}; }

    static AsperityLaw read(const ParameterTable& table) { return {Asperities::read(table)}; }
    Dilates dilates() const { return Dilates::with_slip; }
    std::optional<CoulombEnvelope> coulomb_envelope() const { return std::nullopt; }
    History fresh(bool) const { return {}; }
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial) const {
        return asperity_strength(this->surface(normal_force, length), history, normal_force, length, trial);
    }
    Strength strength_slope(const History& history, double normal_force, double length) const {
        return asperity_strength_slope(this->surface(normal_force, length), history, normal_force);
    }
    std::optional<CoulombLine> bound_line(const History&) const { return std::nullopt; }
    History advance(const History& history, const ContactMotion& motion) const {
        return {asperity_advance(this->surface(motion.normal_force, motion.length), history, motion)};
    }
    History fly(const History& history, const ContactMotion& motion) const {
        return {asperity_flight(this->surface(0, motion.length), history, motion)};
    }
    double shear_stiffness(const History&, double, double) const { return 0; }
    LockedDilation locked_dilation(const History&) const { return {}; }
    /// The mobilised ratio is the remaining fraction of the asperity angle at zero normal stress.
    JointRecord record(const History& history) const {
        const AsperitySurface unstressed = this->surface(0, 1);
        const double initial_angle = unstressed.angle(0);
        return {JointStage::none, initial_angle > 0 ? unstressed.angle(history.work) / initial_angle : 0,
                history.dilation, 0, 0};
    }
};

}  // namespace rockslope::dda
