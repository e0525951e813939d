#pragma once

#include <limits>
#include <utility>

#include "dda/trial/contact_trial.hpp"
#include "dda/trial/segment_strength.hpp"
#include "dda/trial/step_problem.hpp"
#include "dda/trial/trial_bolts.hpp"

namespace rockslope::dda {

/// The contacts and bolts of a step during the open-close iteration. Gives the forces of each contact in the
/// linear system and by the joint law, and updates the active set: which springs are in the linear system.
/// What is held meanwhile is changed by ShearBounds, JointDilation, EntranceLines, break_bonds() and
/// augment().
///
/// With fixed shear bounds the normal force is a continuous, monotonic function of the gap alone, and the
/// shear force one of the elastic trial force alone. The potential of the step is therefore convex. The
/// bounds couple the two forces; they are zero where the contact is open.
class TrialContacts {
  public:
    /// How gaps follow from a displacement.
    enum class Gaps { exact, linear };
    /// Whether the tilts of dilating contacts follow the active set, or are held like the shear bounds. Held
    /// tilts leave the potential of the step as it is, and its shear springs are those of the fixed bounds.
    enum class Tilts { follow, held };

    /// Begins at the initial guess of the problem; without one, at the step's start. Shear bounds are zero.
    /// @param problem must outlive the contacts. @param memory trials of an earlier step: their memory is
    /// used.
    TrialContacts(const StepProblem& problem, const ThreadPool& pool, PerContact<ContactTrial> memory = {});
    /// The memory of the trials, for a later step.
    PerContact<ContactTrial> release() { return std::move(trials_); }

    std::size_t count() const { return trials_.size(); }
    ContactTrial& operator[](ContactIndex k) { return trials_[k]; }
    const ContactTrial& operator[](ContactIndex k) const { return trials_[k]; }
    /// The bolts of the step.
    TrialBolts& bolts() { return bolts_; }
    const TrialBolts& bolts() const { return bolts_; }

    /// Calls body(k) for each contact, in parallel: body may write data of contact k only.
    template <class Body>
    void for_each(const Body& body) const {
        pool_.parallel_for(count(), [&](std::size_t begin, std::size_t end) {
            for (const ContactIndex k : indices<ContactIndex>(begin, end)) body(k);
        });
    }
    /// Calls predicate(k) for each contact, in parallel. @return whether it is true for any.
    template <class Predicate>
    bool for_any(const Predicate& predicate) const {
        const auto any_in_chunk = [&](std::size_t begin, std::size_t end) {
            bool any = false;
            for (const ContactIndex k : indices<ContactIndex>(begin, end)) any = predicate(k) || any;
            return any;
        };
        return pool_.parallel_reduce(count(), false, any_in_chunk, [](bool a, bool b) { return a || b; });
    }

    // --- bonds and cohesion
    /// Whether the cohesion of a contact acts in this step, Eq. (75): it was closed at the step's start, it
    /// may close, and no bond of its has broken since.
    bool coheres(ContactIndex k) const {
        return trials_[k].coheres && trials_[k].may_close && !trials_[k].bond_broken;
    }
    bool is_bonded(ContactIndex k) const { return p_.contacts[k].bonded && !trials_[k].bond_broken; }
    /// The smallest normal force of a contact in the step, N per metre: 0 without a bond, no limit where the
    /// bond may break, the tensile strength where it holds.
    double least_normal_force(ContactIndex k) const {
        if (!is_bonded(k) || !trials_[k].may_close) return 0;
        return p_.bonds_hold() ? -trials_[k].tensile_strength : -std::numeric_limits<double>::infinity();
    }

    // --- the linear system
    /// The measure of the normal spring: the opening, less the tilt times the shear displacement, Eq. (83).
    RelativeMeasure normal_measure(ContactIndex k) const {
        const ContactSprings& s = p_.springs[k];
        const double tilt = trials_[k].tilt;
        return {s.normal.direction - tilt * s.shear.direction,
                s.normal.prescribed - tilt * s.shear.prescribed};
    }
    /// The forces of the linear system at a displacement.
    Forces linear_forces(ContactIndex k, double opening, double shearing) const;
    /// Sets the forces of the linear system at its solution, N per metre.
    void set_linear_forces(ContactIndex k, const Forces& forces) {
        trials_[k].linear = forces;
        trials_[k].linear.shear += trials_[k].tilt * forces.normal;
    }
    /// Sets the springs of the linear system by the forces of the laws. @return whether the matrix changes.
    bool update_active_set(Tilts tilts = Tilts::follow);

    // --- the laws
    const JointLaw& law_of(ContactIndex k) const {
        return p_.model.joint_material_at(p_.contacts[k].joint_material).law;
    }
    /// The force laws with the present shear bounds.
    ContactLaw law(ContactIndex k) const;
    /// The tangent of the normal law at a force of its spring, N per metre: the force that it has at an
    /// opening, N per metre, and its stiffness, N/m per metre.
    struct SpringForce {
        double force = 0;
        double stiffness = 0;
    };
    SpringForce normal_tangent(ContactIndex k, double spring_force, double opening) const {
        const NormalTangent tangent = tangent_at(k, spring_force);
        return {tangent.at(trials_[k].closure(opening)), tangent.stiffness};
    }

    // --- the iterate
    /// Computes gaps and displacements of all contacts at an iterate. Gaps are exact there; Eq. (21) shifts
    /// their linearisation.
    /// @param d the iterate, per row; @param target the solution of the linear system, whose forces balance.
    /// @param gaps linear: as linearised at the last iterate with exact ones.
    void set_displacement(RowSpan<const Vec6> d, RowSpan<const Vec6> target, Gaps gaps = Gaps::exact);
    /// Measures the gaps at the iterate exactly; they are linearised from there.
    void measure_gaps(RowSpan<const Vec6> d);
    /// Moves to another iterate near the last one: gaps are linear in the displacement in between.
    void move_to(RowSpan<const Vec6> d);
    /// The forces of the law at the iterate: the whole shear force.
    Forces law_forces(ContactIndex k) const {
        Forces forces = law(k).forces(trials_[k].opening, trials_[k].shearing);
        forces.shear += trials_[k].tilt * forces.normal;
        return forces;
    }
    /// Normal force and shear displacement at the iterate; before the first one, of the initial guess.
    ContactLoading loading(ContactIndex k) const {
        return evaluated_ ? ContactLoading{law_forces(k).normal, trials_[k].shearing} : initial_loading(k);
    }
    /// The part of the shear displacement of the step that its spring bears, m.
    double elastic_displacement(ContactIndex k) const {
        return trials_[k].shearing - slip(k, elastic_shear(k), law_forces(k).shear);
    }
    /// The motion of the contact in the step, with its slip.
    ContactMotion motion(ContactIndex k) const;
    /// The largest difference between a force of the linear system at its solution and the force of the law
    /// at the iterate, of contacts and bolts, N per metre.
    struct ForceChange {
        double largest = 0;
        ContactIndex contact = ContactIndex::none();  ///< the contact with the largest difference
    };
    ForceChange force_change();
    /// The largest force change at convergence, Eq. (36), N per metre.
    double tolerance() const;
    /// Writes the state and forces of every contact at the iterate.
    /// @param evaluated_contacts one per contact.
    void evaluate(ContactSpan<EvaluatedContact> evaluated_contacts) const;

  private:
    ContactTrial initial_trial(ContactIndex k) const;
    NormalDashpot dashpot(ContactIndex k) const {
        return p_.dashpots.empty() ? NormalDashpot() : p_.dashpots[k];
    }
    /// Whether a contact is closed at the step's end, Eq. (76): in compression, bonded, or held by its
    /// cohesion and open by less than the extension at which its normal spring would pull with that cohesion,
    /// or left by a spring that is compressed still.
    bool stays_closed(ContactIndex k) const;
    /// Normal force and shear displacement of the initial guess; without one, those of the step's start.
    ContactLoading initial_loading(ContactIndex k) const;
    /// The force of the normal spring of the initial guess, N per metre; without one, that of the step's
    /// start.
    double initial_spring_force(ContactIndex k) const;
    /// @return whether the matrix changes.
    bool update_active_set_of(ContactIndex k, Tilts tilts);
    /// The shear spring of a contact: whether it is locked, and otherwise whether it slides forward.
    struct ShearState {
        bool locked = false;
        bool slides_forward = true;
    };
    ShearState shear_state(ContactIndex k, Tilts tilts) const;
    EvaluatedContact evaluated(ContactIndex k) const;
    /// The shear force of the linear system at zero shear displacement, N per metre.
    double shear_origin(ContactIndex k) const {
        const ContactTrial& trial = trials_[k];
        return trial.shear_origin +
               trial.dilating.shear_force(trial.held_normal, p_.contacts[k].joint_share) -
               trial.tilt * trial.held_normal;
    }
    /// The normal force where the linear system has no normal spring, N per metre: that of a bond which
    /// yields.
    double inactive_normal_force(ContactIndex k) const { return p_.bonds_hold() ? least_normal_force(k) : 0; }
    /// The tangent of the normal law at a force of its spring; the law itself if it is linear.
    NormalTangent tangent_at(ContactIndex k, double spring_force) const;
    /// The force of the normal spring at the iterate, without its dashpot, N per metre.
    double spring_force(ContactIndex k) const { return law(k).spring_force(trials_[k].opening); }
    /// Whether a contact at the iterate bears nothing, since its dashpot would pull by as much as its
    /// compressed spring presses.
    bool is_rebounding(ContactIndex k) const {
        return dashpot(k).stiffness > 0 && spring_force(k) > 0 && !(law_forces(k).normal > 0);
    }
    /// The elastic shear force, Eq. (77), at the iterate, before the law bounds it.
    double elastic_shear(ContactIndex k) const;
    /// The part of it that the slope of the locked joint gives, the second term of Eq. (77), N per metre.
    double by_slope(ContactIndex k) const;
    /// The plastic part of the shear displacement of the step, m; all of it where an augmented contact
    /// slides.
    double slip(ContactIndex k, double elastic, double force) const;

    const StepProblem& p_;
    const ThreadPool& pool_;
    PerContact<ContactTrial> trials_;
    TrialBolts bolts_;
    PerCorner<Vec2> moved_vertices_;  ///< per corner: its position at the iterate
    bool evaluated_ = false;          ///< whether set_displacement() has been called
    double largest_force_ = 0;        ///< N per metre, largest contact force by the laws
};

inline Forces TrialContacts::linear_forces(ContactIndex k, double opening, double shearing) const {
    const ContactTrial& trial = trials_[k];
    return {trial.has_normal_spring ? trial.linear_normal(opening) : inactive_normal_force(k),
            trial.has_shear_spring ? shear_origin(k) + p_.springs[k].shear_stiffness * shearing
                                   : trial.friction_force + trial.sliding_stiffness * shearing};
}

inline ContactLaw TrialContacts::law(ContactIndex k) const {
    const ContactTrial& trial = trials_[k];
    const ContactSprings& springs = p_.springs[k];
    const double by_dilation = trial.tilt * trial.held_normal;
    return {springs.normal_law,
            dashpot(k),
            trial.gap_offset,
            trial.dilation_at_zero(),
            trial.stress_free_gap,
            shear_origin(k),
            springs.shear_stiffness,
            -trial.bounds.backward - by_dilation - trial.hardening.backward * trial.held_shearing,
            trial.bounds.forward - by_dilation - trial.hardening.forward * trial.held_shearing,
            trial.hardening,
            least_normal_force(k),
            trial.may_close};
}

}  // namespace rockslope::dda
