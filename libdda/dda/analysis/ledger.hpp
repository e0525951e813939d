#pragma once

#include <span>
#include <vector>

#include "dda/analysis/open_close_iteration.hpp"
#include "dda/analysis/state.hpp"
#include "dda/terms/loads.hpp"

namespace rockslope::dda {

/// What one accepted step did, as the energy ledger needs it.
struct StepWork {
    const BlockSystem& blocks;  ///< at the start of the step
    const MidStep& mid;
    std::span<const Contact> before;  ///< at the start of the step
    std::span<const ContactSprings> springs;
    std::span<const BoltSpring> bolts;
    std::span<const double> bolt_force;  ///< at the start of the step
    std::span<const BoundaryTerm> boundaries;
    const OpenCloseResult& result;
    Newmark newmark;
    double mass_damping = 0;
    double velocity_factor = 1;  ///< share of the velocity that the step control leaves
    LoadInstant loads;           ///< at the end of the step
};

/// Keeps the energy ledger, theory sec. 8. The stores are computed from the state alone and the flows from
/// the step's forces and displacements, so that the residual measures what the step's linear kinematics, the
/// solver and contact transfer get wrong.
class Ledger {
  public:
    Ledger(const Model& model, const RowMap& rows);

    /// Sets the stores to those of a state.
    void update_stored_energy(const State& state, Energy& energy) const;
    /// Energy in the springs of contacts, J per metre.
    double contact_energy_of(const std::vector<Contact>& contacts) const;

    void record_contacts(const StepWork& step, Energy& energy) const;
    /// A law that has changed its shear spring in this step, Eq. (58), keeps the force in it: what the other
    /// spring stores more or less comes from nowhere. @param after the contacts at the step's end.
    void record_spring_changes(const StepWork& step, const std::vector<Contact>& after, Energy& energy) const;
    void record_constraints(const StepWork& step, Energy& energy) const;
    void record_blocks(const StepWork& step, Energy& energy) const;
    void record_boundaries(const StepWork& step, Energy& energy) const;

  private:
    const Model& model_;
    const RowMap& rows_;
    std::vector<Vec2> datum_;  ///< per block, initial centroid, m
};

}  // namespace rockslope::dda
