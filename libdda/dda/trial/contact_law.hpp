#pragma once

#include <algorithm>
#include <cstdint>

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

/// The linear pieces of the shear force of a contact: its spring is locked, or it is at a bound.
enum class ShearPiece : std::uint8_t { locked, forward, backward };

/// The force laws of a contact with held shear bounds, Eq. (32), with all their parameters. The line search
/// evaluates them at many displacements.
struct ContactLaw {
    NormalClosure normal_law;
    NormalDashpot dashpot;
    double gap_offset = 0;          ///< m, gap less the linearised opening, Eq. (21)
    double dilation_increment = 0;  ///< m, at zero displacement
    double stress_free_gap = 0;     ///< m
    double shear_origin = 0;        ///< N per metre, shear force at zero displacement
    double shear_stiffness = 0;     ///< N/m per metre
    double backward = 0;            ///< N per metre, the smallest shear force, at zero displacement
    double forward = 0;             ///< N per metre, the largest shear force, at zero displacement
    Hardening hardening;            ///< of both; less than the shear stiffness
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
    /// The largest shear force, N per metre.
    double largest(double shearing) const { return forward + hardening.forward * shearing; }
    /// The smallest shear force, N per metre.
    double smallest(double shearing) const { return backward + hardening.backward * shearing; }
    /// What the shear force is: that of the spring, or a bound. Far back a bound that hardens is beyond the
    /// other one, and the backward one holds.
    ShearPiece shear_piece(double shearing) const {
        const double force = elastic(shearing);
        const double most = largest(shearing);
        if (std::min(force, most) < smallest(shearing)) return ShearPiece::backward;
        return force > most ? ShearPiece::forward : ShearPiece::locked;
    }
    /// Whether the shear force is that of the spring, and the bounds leave room for a locked contact.
    bool locks(double shearing) const {
        return may_close && shear_piece(shearing) == ShearPiece::locked &&
               largest(shearing) > smallest(shearing);
    }
    /// The forces at the held bounds, Eq. (32).
    Forces forces(double opening, double shearing) const {
        if (!may_close) return {};
        return {std::max(normal(opening), least_normal),
                std::max(std::min(elastic(shearing), largest(shearing)), smallest(shearing))};
    }
};

}  // namespace rockslope::dda
