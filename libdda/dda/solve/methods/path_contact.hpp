#pragma once

#include "dda/terms/springs.hpp"

namespace rockslope::dda {

/// A contact on the way of the interior-point method: its forces, and how far they are from their limits,
/// Eqs. (90) and (91). Forces in N per metre, products in N^2 per square metre. All rooms, distances and
/// multipliers are unknowns of their own: near a limit, the difference of two forces is rounding.
struct PathContact {
    /// How the shear force is limited.
    enum class Shear {
        none,     ///< no shear force
        elastic,  ///< no bound
        bounded,  ///< by lines over the normal force
    };
    /// The values that an iteration changes, or their changes.
    struct Unknowns {
        double normal = 0;         ///< N
        double distance = 0;       ///< q, normal force less the spring's
        double shear = 0;          ///< S
        double forward_room = 0;   ///< forward bound less shear force
        double backward_room = 0;  ///< backward bound plus shear force
        double forward_multiplier = 0;
        double backward_multiplier = 0;
    };
    /// The three products of Eq. (91).
    struct Products {
        double normal = 0;
        double forward = 0;
        double backward = 0;
        /// The sum of the three products.
        double sum() const { return normal + forward + backward; }
    };

    ContactIndex contact;
    bool bonded = false;  ///< bears any tension: its normal force is the spring's
    /// The least normal force of a contact that does not bear any tension. Its normal forces here are those
    /// above it, so that none is negative.
    double least_normal = 0;
    Shear shear = Shear::none;
    double cohesion = 0;  ///< both bounds without a normal force
    double forward = 0;   ///< slope of the forward bound over the normal force, less the tilt
    double backward = 0;  ///< slope of the backward bound over the normal force, plus the tilt
    RelativeMeasure opening;
    double normal_stiffness = 0;  ///< N/m per metre, tangent of the normal law
    double shear_stiffness = 0;   ///< N/m per metre
    double spring_normal = 0;     ///< force of the normal spring at the iterate
    double spring_shear = 0;      ///< elastic shear force at the iterate
    Unknowns at;
    Unknowns change;
    Products target;
    // Forces change by a part of the springs' and a constant, Eq. (94).
    double normal_fraction = 0;
    double shear_fraction = 0;
    double coupling = 0;  ///< change of the shear force by that of the normal force
    double normal_constant = 0;
    double shear_constant = 0;

    /// The normal force at the iterate.
    double normal_force() const { return at.normal + least_normal; }

    /// Places the contact on the central path, where all products are equal, Eq. (92).
    void place_on_path(double product);
    /// Holds the bounds at those of the present normal force.
    void hold_bounds();
    /// Sets the fractions of the springs in the matrix, Eq. (94).
    void set_fractions();
    /// Sets the constants of the change that leads the products to their targets, Eq. (94).
    void set_constants();
    /// Sets the change of all unknowns. @param opening, shearing m, changes of the displacements.
    void set_change(double opening, double shearing);
    /// The targets that lead all products to one value, corrected by the second-order terms of the predicted
    /// change, Eq. (95).
    Products corrected_target(double product) const;
    /// The products after a fraction of the change.
    Products products(double step) const;
    /// The largest fraction of the change that keeps all unknowns positive; may be infinite.
    double largest_step() const;
    /// Moves the unknowns by a fraction of their change. @param step 0 to 1.
    void advance(double step);
    /// The largest difference of the forces from those of the laws at the iterate.
    double law_error() const;

  private:
    void place_shear_on_path(double product);
};

}  // namespace rockslope::dda
