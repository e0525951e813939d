#pragma once

#include <algorithm>

#include "dda/joint/normal_closure.hpp"
#include "dda/terms/contact_damping.hpp"

namespace rockslope::dda {

/// A contact's forces at one displacement, N per metre.
struct Forces {
    double normal = 0;
    double shear = 0;
};
// A contact that dilates has its normal spring along a tilted direction, Eq. (83): then `shear` of the linear
// system, of a ContactLaw and of the friction coupling is the shear force less tilt times normal force.

/// The force laws of a contact with fixed shear bounds, Eq. (32), with all their parameters. The line search
/// evaluates them at many displacements.
struct ContactLaw {
    NormalClosure normal_law;
    NormalDashpot dashpot;
    double gap_offset = 0;          ///< m, gap less the linearised opening, Eq. (21)
    double dilation_increment = 0;  ///< m, at zero displacement
    double stress_free_gap = 0;     ///< m
    double shear_origin = 0;        ///< N per metre, shear force at zero displacement
    double shear_stiffness = 0;     ///< N/m per metre
    double backward = 0;            ///< N per metre, the smallest shear force, negative or zero
    double forward = 0;             ///< N per metre, the largest shear force
    double least_normal = 0;        ///< N per metre, the smallest normal force; below 0 if it bears tension
    bool may_close = true;          ///< false: no force at all

    /// The compression of the normal spring, m.
    double closure(double opening) const {
        return -(gap_offset + opening - dilation_increment - stress_free_gap);
    }
    /// The force of the normal spring, Eq. (22), N per metre.
    double spring_force(double opening) const {
        const double closed = closure(opening);
        return normal_law.is_linear() ? normal_law.stiffness * closed : normal_law.force(closed);
    }
    /// The force of the normal spring and its dashpot, Eq. (86), N per metre.
    double normal(double opening) const {
        if (dashpot.stiffness == 0) return spring_force(opening);
        return spring_force(opening) + dashpot.force(closure(opening));
    }
    /// Stiffness of a linear normal spring in compression, with its dashpot, N/m per metre.
    double normal_stiffness() const { return normal_law.stiffness + dashpot.stiffness; }
    /// The shear force without bounds, N per metre.
    double elastic(double shearing) const { return shear_origin + shear_stiffness * shearing; }
    /// Whether it is within the bounds, and these leave room for a locked contact.
    bool locks(double shearing) const {
        const double force = elastic(shearing);
        return may_close && force <= forward && force >= backward && forward > backward;
    }
    /// The forces at the fixed bounds, Eq. (32).
    Forces forces(double opening, double shearing) const {
        if (!may_close) return {};
        return {std::max(normal(opening), least_normal), std::clamp(elastic(shearing), backward, forward)};
    }
};

}  // namespace rockslope::dda
