#pragma once

namespace rockslope::dda {

/// The energy ledger, J per metre of thickness. Stores are values at an instant, flows accumulate from the
/// start of the run. Balance: stores - initial stores + losses = external work, up to `residual()`.
struct Energy {
    double kinetic = 0;
    double strain = 0;      ///< of the blocks
    double contact = 0;     ///< of normal and shear contact springs
    double constraint = 0;  ///< of fixed points and bolts
    double gravity = 0;     ///< potential, zero at the start of the run

    double friction_loss = 0;  ///< dissipated by sliding, never decreases
    double damping_loss =
        0;  ///< mass damping, and velocity taken away by a dynamic coefficient below 1 or a static stage
    double numerical_loss = 0;  ///< dissipated by the end-of-step evaluation of forces, theory Eq. (42)
    double released = 0;        ///< spring energy lost when contacts open, tear or are replaced
    double boundary_loss = 0;   ///< taken by the dashpots of viscous boundaries: waves that left the model
    double excavated = 0;       ///< stores of rock taken out, with its contacts; gravity's may be negative
    double external_work = 0;   ///< done by loads and by prescribed blocks

    double initial_stores = 0;

    double stores() const { return kinetic + strain + contact + constraint + gravity; }
    double losses() const {
        return friction_loss + damping_loss + numerical_loss + released + boundary_loss + excavated;
    }
    /// What the ledger does not explain, J.
    double residual() const { return stores() - initial_stores + losses() - external_work; }
};

}  // namespace rockslope::dda
