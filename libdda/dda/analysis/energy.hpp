#pragma once

#include "dda/base/indices.hpp"

namespace rockslope::dda {

/// The largest energy that one contact gave in one step.
struct EnergyGain {
    double amount = 0;  ///< J per metre; 0: none gave any
    double time = 0;    ///< s, at the end of the step
    BlockIndex corner_block, edge_block;
    JointMaterialIndex joint_material;

    /// Keeps the larger of both; of equal ones the first.
    void keep_larger(const EnergyGain& later) {
        if (later.amount > amount) *this = later;
    }
};

/// The energy balance, J per metre of thickness. Stored energies are values at an instant. Losses and
/// external work accumulate from the start of the run. Balance: stores() - initial_stores + losses() =
/// external_work, up to residual().
struct Energy {
    double kinetic = 0;     ///< kinetic energy of blocks with unknowns
    double strain = 0;      ///< strain energy of blocks
    double contact = 0;     ///< energy of normal and shear contact springs
    double constraint = 0;  ///< energy of fixed points and bolts
    double gravity = 0;     ///< potential energy, zero at the start of the run

    /// Dissipated by sliding, less the work of dilation against normal forces; and by yielding bolts.
    double friction_loss = 0;
    /// Dissipated by mass and strain damping, and by the dynamic coefficient of the stage, which is zero in
    /// static stages.
    double damping_loss = 0;
    /// Dissipated by the dashpots of normal contacts, Eq. (86), with the part of the loss of the end-of-step
    /// evaluation that belongs to them, Eq. (88); not negative.
    double contact_damping_loss = 0;
    double numerical_loss = 0;  ///< dissipated by the end-of-step evaluation of forces, Eq. (42)
    double released = 0;        ///< spring energy lost when contacts open, break or are replaced
    double boundary_loss = 0;   ///< dissipated by the dashpots of viscous boundaries: outgoing waves
    double excavated = 0;       ///< stored energy of removed blocks and their contacts; may be negative
    double external_work = 0;   ///< work of loads and of prescribed blocks

    double initial_stores = 0;  ///< stores() at the start of the run
    /// Sum of the negative friction losses of single contacts in single steps, positive. Friction only takes
    /// energy, so this is an error of the run; friction_loss contains it.
    double friction_returned = 0;
    EnergyGain largest_gain;  ///< the largest part of friction_returned
    /// The largest energy that the springs of one contact gained while they were replaced; `released` has its
    /// negative.
    EnergyGain largest_spring_gain;

    /// Adds the losses and the work that some of the contacts or blocks had in a step.
    void add_losses(const Energy& part) {
        friction_loss += part.friction_loss;
        damping_loss += part.damping_loss;
        contact_damping_loss += part.contact_damping_loss;
        numerical_loss += part.numerical_loss;
        released += part.released;
        boundary_loss += part.boundary_loss;
        external_work += part.external_work;
        friction_returned += part.friction_returned;
        largest_gain.keep_larger(part.largest_gain);
        largest_spring_gain.keep_larger(part.largest_spring_gain);
    }

    /// Sum of the stored energies, J per metre.
    double stores() const { return kinetic + strain + contact + constraint + gravity; }
    /// Sum of the losses, J per metre.
    double losses() const {
        return friction_loss + damping_loss + contact_damping_loss + numerical_loss + released +
               boundary_loss + excavated;
    }
    /// The error of the balance, J per metre.
    double residual() const { return stores() - initial_stores + losses() - external_work; }
};

}  // namespace rockslope::dda
