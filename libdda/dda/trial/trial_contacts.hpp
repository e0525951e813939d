#pragma once

#include <limits>
#include <span>
#include <vector>

#include "dda/linear/anderson.hpp"
#include "dda/trial/contact_law.hpp"
#include "dda/trial/joint_motion.hpp"
#include "dda/trial/segment_friction.hpp"
#include "dda/trial/shear_energy.hpp"
#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

/// The contacts and bolts of a step during the open-close iteration. For each contact it holds the active set
/// (which springs are in the linear system), the forces by the joint law, and the shear bounds; and it
/// updates the active set and the bounds from the forces.
///
/// With fixed shear bounds the normal force is a continuous, monotonic function of the gap alone, and the
/// shear force one of the elastic trial force alone. The potential of the step is therefore convex. The
/// bounds couple the two forces; they are zero where the contact is open.
class TrialContacts {
  public:
    /// How gaps follow from a displacement.
    enum class Gaps { exact, linear };

    TrialContacts(const StepProblem& problem, const ThreadPool& pool);

    std::size_t count() const { return trials_.size(); }

    // --- the linear system
    /// The measure of the normal spring: the opening, less the tilt times the shear displacement, Eq. (83).
    RelativeMeasure normal_measure(ContactIndex k) const {
        const ContactSprings& s = p_.springs[k];
        const double tilt = trials_[k].tilt;
        return {s.normal.direction - tilt * s.shear.direction,
                s.normal.prescribed - tilt * s.shear.prescribed};
    }
    double tilt(ContactIndex k) const { return trials_[k].tilt; }
    /// Whether a contact may bear a force; false for a line that is not entered first.
    bool may_close(ContactIndex k) const { return trials_[k].may_close; }
    bool has_normal_spring(ContactIndex k) const { return trials_[k].active; }
    /// Tangent stiffness of the normal spring, N/m per metre.
    double normal_stiffness(ContactIndex k) const { return trials_[k].tangent.stiffness; }
    bool has_shear_spring(ContactIndex k) const { return trials_[k].locked; }
    bool is_elastic(std::size_t bolt) const { return yielding_[bolt] == 0; }
    /// The forces of the linear system at a displacement.
    Forces linear_forces(ContactIndex k, double opening, double shearing) const;
    double linear_bolt_force(std::size_t k, double elongation) const;

    // --- the laws
    /// The force laws with the present shear bounds.
    ContactLaw law(ContactIndex k) const;
    Forces law_forces(ContactIndex k, double opening, double shearing) const {
        return law(k).forces(opening, shearing);
    }
    double law_bolt_force(std::size_t k, double elongation) const;
    /// The tangent of the normal law at a force of its spring, N per metre: the force that it has at an
    /// opening, N per metre, and its stiffness, N/m per metre.
    struct SpringForce {
        double force = 0;
        double stiffness = 0;
    };
    SpringForce normal_tangent(ContactIndex k, double spring_force, double opening) const {
        const Tangent tangent = tangent_at(k, spring_force);
        return {tangent.at(closure(k, opening)), tangent.stiffness};
    }

    // --- friction of sliding contacts, whose shear force is a load in the linear system
    bool slides_forward(ContactIndex k) const { return trials_[k].forward; }
    double friction_force(ContactIndex k) const { return trials_[k].friction_force; }
    void set_friction_force(ContactIndex k, double force) { trials_[k].friction_force = force; }
    /// Sets the bound in the sliding direction to the friction force.
    /// @param normal_force N per metre, of the linear system.
    void set_bound_to_friction_force(ContactIndex k, double normal_force);
    /// Whether the law of any joint dilates.
    bool any_dilates() const { return dilates_; }
    /// Whether any contact is on a rough joint segment.
    bool has_segments() const { return !segment_friction_.empty(); }
    /// Whether a contact is on a rough joint segment, whose contacts have one friction law in common.
    bool is_on_segment(ContactIndex k) const { return segment_friction_.is_on_segment(k); }
    /// Whether the bound line of a contact on a segment has been computed.
    bool has_line(ContactIndex k) const { return segment_friction_.has_line(k); }
    /// Marks the bound line to be computed by find_requested_lines().
    void request_line(ContactIndex k) { segment_friction_.request_line(k); }
    void find_requested_lines();
    /// The tangent of the shear bound over the normal force for a contact on a segment, in its sliding
    /// direction, at the last evaluation. The contact's fraction of the segment's normal force is held
    /// constant.
    BoundLine bound_tangent(ContactIndex k) const {
        return segment_friction_.line(k, trials_[k].forward, current_forces(k).normal);
    }
    /// The shear bound of a sliding contact that is not on a segment, in its sliding direction, N per metre.
    /// @param normal N per metre, its normal force; @param d displacement of the linear system, per row.
    double bound_at(ContactIndex k, double normal, RowSpan<const Vec6> d) const;
    /// Shear bound over normal force at the last evaluation, in the sliding direction; 0 without normal
    /// force.
    double bound_secant(ContactIndex k) const {
        const double normal = current_forces(k).normal;
        return normal > 0 ? in_direction(k, trials_[k].bounds) / normal : 0;
    }
    /// Both shear bounds over the normal force at which they were set; zero without one.
    Strength bounds_over_normal_force(ContactIndex k) const {
        const Trial& trial = trials_[k];
        if (!(trial.held_normal > 0)) return {};
        return {trial.bounds.forward / trial.held_normal, trial.bounds.backward / trial.held_normal, 0};
    }
    const JointLaw& law_of(ContactIndex k) const {
        return p_.model.joint_material_at(p_.contacts[k].joint_material).law;
    }
    /// Whether a contact's law gives it a shear strength without a normal force.
    bool has_cohesion(ContactIndex k) const {
        return has_cohesion_[p_.contacts[k].joint_material] != 0 && p_.contacts[k].length > 0;
    }
    /// Whether the cohesion of a contact acts in this step, Eq. (75): it was closed at the step's start, it
    /// may close, and no bond of its has broken since.
    bool coheres(ContactIndex k) const {
        return trials_[k].coheres && may_close(k) && !trials_[k].bond_broken;
    }
    bool is_bonded(ContactIndex k) const { return p_.contacts[k].bonded && !trials_[k].bond_broken; }
    /// The smallest normal force of a contact in the step, N per metre: 0 without a bond, no limit where the
    /// bond may break, the tensile strength where it holds.
    double least_normal_force(ContactIndex k) const {
        if (!is_bonded(k) || !may_close(k)) return 0;
        return p_.bonds_hold() ? -tensile_strength_[k] : -std::numeric_limits<double>::infinity();
    }
    /// The normal force where the linear system has no normal spring, N per metre: that of a bond which
    /// yields.
    double inactive_normal_force(ContactIndex k) const { return p_.bonds_hold() ? least_normal_force(k) : 0; }
    // --- dilation that follows the normal force
    /// How the dilation of a joint segment follows its normal force while its displacement is held: where the
    /// joint slips, a smaller normal force lets its shear spring slip on.
    struct DilationByForce {
        std::span<const ContactIndex> contacts;
        double slope =
            0;  ///< derivative of the dilation by the normal force, Eq. (85), m per N per metre, negative
        double normal_force = 0;  ///< N per metre, of the segment at its last evaluation
        double change = 0;        ///< m, of the dilation since then by the normal force
    };
    std::span<const DilationByForce> dilations_by_force() const { return dilations_by_force_; }
    /// Sets the change of a dilation by the normal force, m. @param index in dilations_by_force().
    void set_dilation_change(std::size_t index, double change);
    /// The force of the normal spring in the linear system, N per metre, tension negative.
    double linear_normal(ContactIndex k, double opening) const;

    // --- evaluation
    /// Sets the forces of the linear system at its solution, N per metre.
    void set_linear_forces(ContactIndex k, const Forces& forces) {
        trials_[k].linear = forces;
        trials_[k].linear.shear += trials_[k].tilt * forces.normal;
    }
    /// Sets the force of a bolt in the linear system at its solution, N per metre.
    void set_linear_bolt_force(std::size_t bolt, double force) { linear_bolt_[bolt] = force; }
    /// Computes gaps and displacements of all contacts at an iterate. Gaps are exact there; Eq. (21) shifts
    /// their linearisation.
    /// @param d the iterate, per row; @param target the solution of the linear system, whose forces balance.
    /// @param gaps linear: as linearised at the last iterate with exact ones.
    void set_displacement(RowSpan<const Vec6> d, RowSpan<const Vec6> target, Gaps gaps = Gaps::exact);
    /// Measures the gaps at the iterate exactly; they are linearised from there.
    void measure_gaps(RowSpan<const Vec6> d);
    /// Moves to another iterate near the last one: gaps are linear in the displacement in between.
    void move_to(RowSpan<const Vec6> d);
    /// First entrance, Eq. (28): of each group of entrance lines at a vertex-vertex contact, only the line
    /// with the largest gap, which is crossed last, may close. Inherited penetration adds twice its depth to
    /// the gap. @return whether any line was exchanged.
    bool select_first_entrances();
    /// The largest difference between a force of the linear system at its solution and the force of the law
    /// at the iterate, of contacts and bolts, N per metre.
    struct ForceChange {
        double largest = 0;
        ContactIndex contact = ContactIndex::none();  ///< the contact with the largest difference
    };
    ForceChange force_change();
    /// The largest force change at convergence, Eq. (36), N per metre.
    double tolerance() const;
    /// Sets the shear bounds to those of the present normal forces and displacements. A rough joint segment
    /// whose forces have changed by less than a tenth of the tolerance keeps the result of its law.
    void update_bounds();
    /// Sets the shear bounds, evaluating all joint laws.
    void update_all_bounds();
    /// Sets the dilation to that of the present forces and displacements, except where it is postponed.
    void update_dilation();
    /// Whether update_dilation() would change a normal force by more than ten times the tolerance, also one
    /// that it would close.
    bool dilation_exceeds_tolerance() const;
    /// Sets the dilation of the step to that of the locked part of its displacement, where it is farther from
    /// the law's value than that is. The rest acts from the next step on. @return whether any was changed.
    bool postpone_dilation();
    /// Lowers the dilation of the segments whose friction would give energy, so that it gives none at the
    /// present forces. @return whether any was changed.
    bool limit_dilation();
    /// The shear bounds, N per metre: forward and backward of each contact in turn.
    Eigen::VectorXd shear_bounds() const;
    /// Sets the shear bounds; negative values become zero.
    void set_shear_bounds(const Eigen::VectorXd& shear_bounds);
    /// Breaks, for the rest of the step, the bonds whose tension exceeds the strength, unless bonds hold.
    /// @return whether any broke.
    bool break_bonds();
    /// Augmented Lagrangian update, Eq. (37): if an augmented contact violates the rigid contact conditions
    /// by more than the model's tolerance, shifts the springs so that they bear the present forces at zero
    /// gap and zero shear displacement. `mixing` accelerates these updates. @return whether the springs were
    /// shifted.
    bool augment(AndersonMixing& mixing);
    /// Sets the springs of the linear system by the forces of the laws. @return whether the matrix changes.
    bool update_active_set();

    /// Writes the state and forces of every contact at the iterate.
    /// @param evaluated_contacts one per contact.
    void evaluate(ContactSpan<EvaluatedContact> evaluated_contacts) const;
    double bolt_force(std::size_t k) const { return law_bolt_force(k, elongation_[k]); }

  private:
    /// A linear relation of normal force (N per metre) and closure (m).
    struct Tangent {
        double point = 0;      ///< m, closure at the point of tangency
        double force = 0;      ///< N per metre, force at that point
        double stiffness = 0;  ///< N/m per metre
        double at(double closure) const { return force + stiffness * (closure - point); }
    };
    /// The trial state of a contact.
    struct Trial {
        bool active = false;  ///< its normal spring is in the linear system
        bool locked = false;  ///< its shear spring is in the linear system
        bool forward = true;  ///< sliding direction
        bool bond_broken = false;
        bool may_close = true;
        bool coheres = false;           ///< its cohesion acts in this step until a bond breaks
        bool postponed = false;         ///< the rest of its dilation acts from the next step on
        double friction_force = 0;      ///< N per metre, shear force in the linear system when not locked
        Strength bounds;                ///< N per metre, shear bounds and tensile strength
        double stress_free_gap = 0;     ///< m, gap at zero normal force
        double shear_origin = 0;        ///< N per metre, of the spring at the start; shifted by augmentation
        double gap_offset = 0;          ///< m, gap less the linearised opening, Eq. (21)
        double dilation_increment = 0;  ///< m, opening by dilation since the start of the step
        double tilt = 0;                ///< derivative of the dilation in the linear system, Eq. (83)
        LockedDilation dilating;        ///< how its shear force follows its normal force while locked
        double sliding_slope = 0;       ///< derivative of the dilation while sliding
        double held_normal = 0;         ///< N per metre, normal force at which the bounds were set
        double opening = 0;             ///< m, linearised normal displacement, tilted
        double shearing = 0;            ///< m, linearised tangential displacement
        Forces linear;                  ///< forces of the linear system at its solution
        Tangent tangent;                ///< the normal spring in the linear system
    };

    /// Calls body(k) for each contact, in parallel: body may write data of contact k only.
    template <class Body>
    void for_contacts(const Body& body) const {
        pool_.parallel_for(count(), [&](std::size_t begin, std::size_t end) {
            for (const ContactIndex k : indices<ContactIndex>(begin, end)) body(k);
        });
    }
    /// Calls predicate(k) for each contact, in parallel. @return whether it is true for any.
    template <class Predicate>
    bool for_any_contact(const Predicate& predicate) const {
        const auto any_in_chunk = [&](std::size_t begin, std::size_t end) {
            bool any = false;
            for (const ContactIndex k : indices<ContactIndex>(begin, end)) any = predicate(k) || any;
            return any;
        };
        return pool_.parallel_reduce(count(), false, any_in_chunk, [](bool a, bool b) { return a || b; });
    }
    Trial initial_trial(ContactIndex k) const;
    NormalDashpot dashpot(ContactIndex k) const {
        return p_.dashpots.empty() ? NormalDashpot() : p_.dashpots[k];
    }
    /// Sets the shear bounds by the laws, at the forces and displacements of the last evaluation.
    /// @param change_tolerance see `tolerance` of SegmentFriction::update.
    void compute_bounds(double change_tolerance);
    double in_direction(ContactIndex k, const Strength& strength) const {
        return trials_[k].forward ? strength.forward : strength.backward;
    }
    /// The shear bounds of a contact that is not on a segment.
    Strength bounds_of_single_contact(ContactIndex k, const ContactLoading& loading) const;
    /// The shear bounds of a contact that is not on a segment, under a loading, Eq. (75). The cohesion
    /// of a contact that was closed at the step's start acts through the whole step, also where the contact
    /// opens; that of a contact that closes acts from the next step on. The bounds are therefore continuous
    /// functions of the displacement, and the step has a solution.
    Strength bounds_at(ContactIndex k, const ContactLoading& here) const;
    /// Whether a contact is closed at the step's end, Eq. (76): in compression, bonded, or held by its
    /// cohesion and open by less than the extension at which its normal spring would pull with that cohesion,
    /// or left by a spring that is compressed still.
    bool stays_closed(ContactIndex k) const;
    /// Normal force and shear displacement of the initial guess; without one, those of the step's start.
    ContactLoading initial_loading(ContactIndex k) const;
    /// The force of the normal spring of the initial guess, N per metre; without one, that of the step's
    /// start.
    double initial_spring_force(ContactIndex k) const;
    /// Normal force and shear displacement at the last evaluation.
    ContactLoading current_loading(ContactIndex k) const;
    /// @return whether the matrix changes.
    bool update_active_set_of(ContactIndex k);
    EvaluatedContact evaluated(ContactIndex k) const;
    /// The motion of the contact in the step, with its slip.
    ContactMotion motion(ContactIndex k) const;
    /// Evaluates the dilation of the step by the joint laws. Calls visit(k, dilation increment, m) for each
    /// contact of a segment whose law dilates.
    template <class Visit>
    void visit_dilation_by_law(const Visit& visit) const;
    /// Sets the dilation of a segment that dilates with slip to that under the normal force which it causes
    /// itself, at the present displacement. @return the motion of the segment with that force.
    SegmentMotion find_dilation(const JointLaw& law, std::span<const ContactIndex> members,
                                const SegmentMotion& present);
    /// The dilation of the step if only the locked part of its displacement dilates the joint, m.
    double locked_dilation_of(ContactIndex k) const;
    /// The contact at the step's end, at the last evaluation.
    ShearedContact sheared(ContactIndex k) const;
    /// What friction takes from a contact of a dilating joint, J per metre. @param after its locked dilation
    /// at the step's end.
    double dilating_loss(ContactIndex k, const LockedDilation& after) const;
    /// Calls visit(law, contacts, motion) for each segment whose law dilates, with its motion in the step;
    /// none without a normal force.
    template <class Visit>
    void visit_dilating_segments(const Visit& visit) const;
    double gap(ContactIndex k) const {
        return trials_[k].gap_offset + trials_[k].opening - dilation_at_zero(k);
    }
    /// The dilation of the step, linearised at the last evaluation, at zero shear displacement, m.
    double dilation_at_zero(ContactIndex k) const {
        return trials_[k].dilation_increment - trials_[k].tilt * trials_[k].shearing;
    }
    /// Changes the tilt; forces and gap at the last evaluation stay.
    void set_tilt(ContactIndex k, double tilt);
    /// The shear force of the linear system at zero shear displacement, N per metre.
    double shear_origin(ContactIndex k) const {
        const Trial& trial = trials_[k];
        return trial.shear_origin +
               trial.dilating.shear_force(trial.held_normal, p_.contacts[k].joint_share) -
               trial.tilt * trial.held_normal;
    }
    /// The compression of the normal spring, m.
    double closure(ContactIndex k, double opening) const;
    /// The tangent of the normal law at a force of its spring; the law itself if it is linear.
    Tangent tangent_at(ContactIndex k, double spring_force) const;
    /// The force of the normal spring at the last evaluation, without its dashpot, N per metre.
    double spring_force(ContactIndex k) const { return law(k).spring_force(trials_[k].opening); }
    /// Whether a contact at the last evaluation bears nothing, since its dashpot would pull by as much as its
    /// compressed spring presses.
    bool is_rebounding(ContactIndex k) const {
        return dashpot(k).stiffness > 0 && spring_force(k) > 0 && !(current_forces(k).normal > 0);
    }
    /// The elastic shear force, Eq. (77), at the last evaluation, before the law bounds it.
    double elastic_shear(ContactIndex k) const;
    /// The part of it that the slope of the locked joint gives, the second term of Eq. (77), N per metre.
    double by_slope(ContactIndex k) const;
    /// The forces of the law at the last evaluation: the whole shear force.
    Forces current_forces(ContactIndex k) const;
    /// Whether an augmented contact violates the conditions of rigid contact by more than `tolerance`, m: it
    /// bears a force but does not touch, penetrates, moves though locked, or slides against its shear force.
    bool violates_rigid_contact(ContactIndex k, double tolerance) const;
    /// The plastic part of the shear displacement of the step, m; all of it where an augmented contact
    /// slides.
    double slip(ContactIndex k, double elastic, double force) const;

    const StepProblem& p_;
    const ThreadPool& pool_;
    SegmentFriction segment_friction_;
    PerContact<Trial> trials_;
    PerContact<double> tensile_strength_;  ///< N per metre, where bonds hold
    PerCorner<Vec2> moved_vertices_;       ///< per corner: its position at the iterate
    std::vector<int> yielding_;            ///< per bolt: the sign of its yielding force, 0 when elastic
    std::vector<double> elongation_;       ///< per bolt, m, in the step
    std::vector<double> linear_bolt_;  ///< per bolt: force in the linear system, at its solution, N per metre
    bool evaluated_ = false;           ///< whether set_displacement() has been called
    /// Per joint material: whether it has a shear strength without a normal force.
    IndexedVector<JointMaterialIndex, char> has_cohesion_;
    bool dilates_ = false;                             ///< whether any joint law dilates
    std::vector<DilationByForce> dilations_by_force_;  ///< of the slipping segments where it matters
    int groups_ = 0;                                   ///< number of groups of entrance lines
    std::vector<ContactIndex> on_entrance_lines_;      ///< the contacts of groups that are not inhibited
    std::vector<ContactIndex> first_entrance_;         ///< per group, the line that may close
    double largest_force_ = 0;                         ///< N per metre, largest contact force by the laws
};

inline double TrialContacts::closure(ContactIndex k, double opening) const {
    const Trial& trial = trials_[k];
    return -(trial.gap_offset + opening - dilation_at_zero(k) - trial.stress_free_gap);
}

inline double TrialContacts::linear_normal(ContactIndex k, double opening) const {
    return trials_[k].tangent.at(closure(k, opening));
}

inline void TrialContacts::set_tilt(ContactIndex k, double tilt) {
    trials_[k].opening += (trials_[k].tilt - tilt) * trials_[k].shearing;
    trials_[k].tilt = tilt;
}

inline Forces TrialContacts::linear_forces(ContactIndex k, double opening, double shearing) const {
    const Trial& trial = trials_[k];
    return {trial.active ? linear_normal(k, opening) : inactive_normal_force(k),
            trial.locked ? shear_origin(k) + p_.springs[k].shear_stiffness * shearing : trial.friction_force};
}

inline ContactLaw TrialContacts::law(ContactIndex k) const {
    const Trial& trial = trials_[k];
    const ContactSprings& springs = p_.springs[k];
    const double by_dilation = trial.tilt * trial.held_normal;
    return {springs.normal_law,
            dashpot(k),
            trial.gap_offset,
            dilation_at_zero(k),
            trial.stress_free_gap,
            shear_origin(k),
            springs.shear_stiffness,
            -trial.bounds.backward - by_dilation,
            trial.bounds.forward - by_dilation,
            least_normal_force(k),
            trial.may_close};
}

}  // namespace rockslope::dda
