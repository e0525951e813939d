#pragma once

#include <algorithm>
#include <cmath>

#include "dda/joint/joint_law.hpp"
#include "dda/trial/contact_law.hpp"

namespace rockslope::dda {

/// A linear relation of the normal force and the closure of a contact.
struct NormalTangent {
    double point = 0;      ///< m, closure at the point of tangency
    double force = 0;      ///< N per metre, force at that point
    double stiffness = 0;  ///< N/m per metre
    /// The force at a closure, N per metre. @param closure m.
    double at(double closure) const { return force + stiffness * (closure - point); }
};

/// A contact during the open-close iteration: its springs in the linear system, the iterate, and what is held
/// until the step's outer problems change it.
struct ContactTrial {
    // The springs in the linear system; update_active_set() sets them.
    bool has_normal_spring = false;
    bool has_shear_spring = false;
    bool slides_forward = true;    ///< sliding direction, where it has no shear spring
    double tilt = 0;               ///< derivative of the dilation in the linear system, Eq. (83)
    double friction_force = 0;     ///< N per metre, shear force in the linear system while it slides, at zero
                                   ///< shear displacement
    double sliding_stiffness = 0;  ///< N/m per metre, how that force grows: the hardening of its bound
    NormalTangent tangent;         ///< the normal spring

    // The iterate; set_displacement() and move_to() set it.
    double gap_offset = 0;          ///< m, gap less the linearised opening, Eq. (21)
    double opening = 0;             ///< m, linearised normal displacement, tilted
    double shearing = 0;            ///< m, linearised tangential displacement
    double dilation_increment = 0;  ///< m, opening by dilation since the start of the step
    Forces linear;                  ///< forces of the linear system at its solution, N per metre

    // What is held.
    bool may_close = true;        ///< false for an entrance line that is not entered first, Eq. (28)
    bool bond_broken = false;     ///< in this step
    bool has_cohesion = false;    ///< its law gives it a shear strength without a normal force
    bool coheres = false;         ///< its cohesion acts in this step until a bond breaks, Eq. (75)
    bool postponed = false;       ///< the rest of its dilation acts from the next step on
    Strength bounds;              ///< N per metre, shear bounds and tensile strength
    double tensile_strength = 0;  ///< N per metre, of a bond that holds
    Hardening hardening;          ///< of the bounds
    double held_normal = 0;       ///< N per metre, normal force at which the bounds were set
    double held_shearing = 0;     ///< m, shear displacement at which they were set
    double stress_free_gap = 0;   ///< m, gap at zero normal force; shifted by augmentation
    double shear_origin = 0;      ///< N per metre, of the spring at the start; shifted by augmentation
    LockedDilation dilating;      ///< how its shear force follows its normal force while locked
    double sliding_slope = 0;     ///< derivative of the dilation while sliding

    /// The dilation of the step, linearised at the iterate, at zero shear displacement, m.
    double dilation_at_zero() const { return dilation_increment - tilt * shearing; }
    /// The gap at the iterate, m.
    double gap() const { return gap_offset + opening - dilation_at_zero(); }
    /// The compression of the normal spring at an opening, m.
    double closure(double at_opening) const {
        return -(gap_offset + at_opening - dilation_at_zero() - stress_free_gap);
    }
    /// The force of the normal spring in the linear system at an opening, N per metre, tension negative.
    double linear_normal(double at_opening) const { return tangent.at(closure(at_opening)); }
    /// Changes the tilt; forces and gap at the iterate stay.
    void set_tilt(double to) {
        opening += (tilt - to) * shearing;
        tilt = to;
    }
    /// Sets the friction force, and the bound in the sliding direction to it.
    /// @param force N per metre, less the tilt times the normal force, at zero shear displacement; @param
    /// normal_force N per metre.
    void set_friction(double force, double normal_force) {
        friction_force = force;
        held_normal = std::max(normal_force, 0.0);
        (slides_forward ? bounds.forward : bounds.backward) =
            std::abs(friction_force + sliding_stiffness * held_shearing + tilt * held_normal);
    }
    /// Sets the bounds to those at the iterate.
    void set_bounds(const Strength& at_iterate, const Hardening& of_bounds) {
        bounds = at_iterate;
        hardening = of_bounds;
        held_shearing = shearing;
    }
    /// The held bounds at the iterate.
    Strength bounds_here() const {
        const double further = shearing - held_shearing;
        return {bounds.forward + hardening.forward * further, bounds.backward - hardening.backward * further,
                bounds.tensile};
    }
    /// The bound in the sliding direction, N per metre.
    double bound() const { return slides_forward ? bounds.forward : bounds.backward; }
    /// Its hardening, N/m per metre.
    double hardening_ahead() const { return slides_forward ? hardening.forward : hardening.backward; }
};

}  // namespace rockslope::dda
