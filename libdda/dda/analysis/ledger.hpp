#pragma once

#include <span>

#include "common/base/thread_pool.hpp"
#include "dda/analysis/state.hpp"
#include "dda/solve/open_close_iteration.hpp"
#include "dda/terms/loads.hpp"

namespace rockslope::dda {

/// The data of one accepted step that the energy balance needs.
struct StepWork {
    const BlockSystem& blocks;  ///< at the start of the step
    const MidStep& mid;
    ContactSpan<const Contact> before;  ///< at the start of the step
    const JointSegments& segments;
    ContactSpan<const ContactSprings> springs;
    ContactSpan<const NormalDashpot> dashpots;  ///< see StepProblem
    std::span<const BoltSpring> bolts;
    std::span<const double> bolt_force;  ///< at the start of the step
    std::span<const BoundaryTerm> boundaries;
    const OpenCloseResult& result;
    Newmark newmark;
    double mass_damping = 0;
    double velocity_factor = 1;  ///< fraction of the velocity that the next step starts with
    double time = 0;             ///< s, at the end of the step
    LoadInstant loads;           ///< at the end of the step
    double duration = 0;         ///< s, physical time of the step; 0 in static stages
};

/// Updates the energy balance, theory sec. 8. Stored energies follow from the state alone, losses and work
/// from the forces and displacements of the step. Energy::residual() therefore measures the errors of the
/// linearised kinematics, of the solver and of the contact transfer.
class Ledger {
  public:
    /// All three must outlive the ledger.
    Ledger(const Model& model, const RowMap& rows, const ThreadPool& pool);

    /// Adds a step to the energy balance of the state at its end. @param last the contacts of the state at
    /// its start, before they were found anew.
    void record_step(const StepWork& step, ContactSpan<const Contact> last, State& after) const;

    /// Sets the stored energies to those of `state`.
    void update_stored_energy(const State& state, Energy& energy) const;
    /// Adds what the contacts' springs lose while those of a step replace those of the state before it.
    /// @param before the contacts of that state; Energy::contact is what they stored; @param segments of
    /// `after`; @param time s, at the end of the step.
    void record_transfer(ContactSpan<const Contact> before, ContactSpan<const Contact> after,
                         const JointSegments& segments, double time, Energy& energy) const;

    /// Adds the losses of contact springs and the work of prescribed blocks on them.
    /// @param advanced the contacts at the end of the step.
    void record_contacts(const StepWork& step, const PerContact<Contact>& advanced, Energy& energy) const;
    /// Adds the energy difference of shear springs whose stiffness changed in the step at constant force,
    /// Eq. (58), to Energy::released. @param after the contacts at the end of the step.
    void record_spring_changes(const StepWork& step, const PerContact<Contact>& after, Energy& energy) const;
    /// Adds the losses and the work of bolts and fixed points.
    void record_constraints(const StepWork& step, Energy& energy) const;
    /// Adds the losses of inertia and elasticity, and the work of loads.
    void record_blocks(const StepWork& step, Energy& energy) const;
    /// Adds the losses and the work of viscous boundaries.
    void record_boundaries(const StepWork& step, Energy& energy) const;

  private:
    /// Adds the losses and the work of contacts and blocks, which threads share.
    /// @param losses(k, energy) adds those of one.
    template <class Index, class Losses>
    void add_losses(std::size_t count, const Losses& losses, Energy& energy) const;
    /// The sum of the energies of contacts or blocks, J per metre, which threads share.
    /// @param energy_of(k) of one.
    template <class Index, class EnergyOf>
    double sum(std::size_t count, const EnergyOf& energy_of) const;
    /// The energy of contacts, with one shear spring for each joint segment, Eq. (81).
    double contact_energy(ContactSpan<const Contact> contacts, const JointSegments& segments) const;
    double kinetic_energy(const BlockSystem& blocks) const;
    double strain_energy(const BlockSystem& blocks) const;
    /// Heights are measured from the initial centroids, which keeps rounding errors small.
    double gravity_energy(const BlockSystem& blocks) const;
    /// Adds the losses of a contact but that of its friction, and external work on it. @return what its
    /// friction takes, J per metre. @param slips whether it, or its joint segment, slips.
    double record_contact(const StepWork& step, ContactIndex k, const Contact& advanced, bool slips,
                          Energy& energy) const;
    /// As above. @param segments those of the contacts of `state`.
    void update_stored_energy(const State& state, const JointSegments& segments, Energy& energy) const;
    bool stores_dilation(const EvaluatedContact& after, const Contact& contact) const;
    void record_normal_loss(const StepWork& step, ContactIndex k, double loss, Energy& energy) const;
    /// The shearing and dilating of a contact in a step.
    struct Shearing {
        double work = 0;           ///< J per metre, of shear force and dilation
        double stored_before = 0;  ///< J per metre
        bool segment_slips = false;
    };
    double record_dilating_shear(const StepWork& step, ContactIndex k, const Contact& advanced,
                                 const Shearing& shearing, Energy& energy) const;

    const Model& model_;
    const RowMap& rows_;
    const ThreadPool& pool_;
    PerBlock<Vec2> datum_;  ///< per block, initial centroid, m
};

}  // namespace rockslope::dda
