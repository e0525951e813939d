#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "dda/analysis/segment_friction.hpp"
#include "dda/analysis/step_problem.hpp"
#include "dda/linear/anderson.hpp"

namespace rockslope::dda {

/// A contact's forces at one displacement, N per metre.
struct Forces {
    double normal = 0;
    double shear = 0;
};

/// What a contact's laws say, with the shear bounds held: all of it in one place, for those who ask for many
/// displacements.
struct ContactLaw {
    NormalClosure normal_law;
    double gap_offset = 0;          ///< m, gap less the linear measure of the displacement
    double dilation_increment = 0;  ///< m
    double stress_free_gap = 0;     ///< m
    double shear_origin = 0;        ///< N per metre
    double shear_stiffness = 0;     ///< N/m per metre
    double backward = 0;            ///< the least shear force, N per metre
    double forward = 0;             ///< the largest
    bool bonded = false;
    bool may_close = true;

    double normal(double opening) const {
        const double closed = -(gap_offset + opening - dilation_increment - stress_free_gap);
        return normal_law.is_linear() ? normal_law.stiffness * closed : normal_law.force(closed);
    }
    Forces forces(double opening, double shearing) const {
        if (!may_close) return {};
        const double compression = normal(opening);
        return {bonded ? compression : std::max(compression, 0.0),
                std::clamp(shear_origin + shear_stiffness * shearing, backward, forward)};
    }
};

/// The contacts and bolts of a step while its equations are being solved: what the linear system takes them
/// for, what their laws say, and the judgement that makes the one follow the other.
///
/// With the shear bounds held, a contact's normal force depends on the gap alone and its shear force on the
/// elastic trial force alone, both without a jump: that makes the step's potential convex. What couples them
/// is the bounds, zero where the contact is open.
class TrialContacts {
  public:
    TrialContacts(const StepProblem& problem, const ThreadPool& pool);

    std::size_t count() const { return trials_.size(); }

    // --- the linear system
    bool has_normal_spring(std::size_t k) const { return trials_[k].active; }
    /// N/m per metre.
    double normal_stiffness(std::size_t k) const { return trials_[k].tangent.stiffness; }
    bool has_shear_spring(std::size_t k) const { return trials_[k].locked; }
    bool is_elastic(std::size_t bolt) const { return yielding_[bolt] == 0; }
    /// What the linear system takes the contact's forces to be.
    Forces linear_forces(std::size_t k, double opening, double shearing) const;
    double linear_bolt_force(std::size_t k, double elongation) const;

    // --- the laws
    /// What the law says they are, with the shear bounds held.
    ContactLaw law(std::size_t k) const;
    Forces law_forces(std::size_t k, double opening, double shearing) const {
        return law(k).forces(opening, shearing);
    }
    double law_bolt_force(std::size_t k, double elongation) const;

    // --- the shear forces of sliding contacts, which the linear system holds
    bool slides_forward(std::size_t k) const { return trials_[k].forward; }
    double friction_force(std::size_t k) const { return trials_[k].friction_force; }
    void set_friction_force(std::size_t k, double force) { trials_[k].friction_force = force; }
    /// The bounds become those that the held force is at.
    void set_bound_to_friction_force(std::size_t k);
    /// Whether any contact is between rough faces.
    bool has_segments() const { return !segment_friction_.empty(); }
    /// Whether a contact is between rough faces, which share one friction.
    bool is_on_segment(std::size_t k) const { return segment_friction_.is_on_segment(k); }
    /// Whether the bound_tangent of such a contact is known; makes it one to be found; and finds all of
    /// these.
    bool has_line(std::size_t k) const { return segment_friction_.has_line(k); }
    void request_line(std::size_t k) { segment_friction_.request_line(k); }
    void find_requested_lines();
    /// The line that touches the bound of such a contact where the contacts were evaluated last, as if it
    /// bore its share of their force for good, in the direction that it slides in.
    BoundLine bound_tangent(std::size_t k) const {
        return segment_friction_.line(k, trials_[k].forward, current_forces(k).normal);
    }
    /// The largest shear force of another sliding contact in the direction that it slides in, N per metre.
    /// @param normal its normal force; @param d gives its displacement, by the linear system.
    double bound_at(std::size_t k, double normal, std::span<const Vec6> d) const;
    /// Bound over normal force where the contact was evaluated last, in the direction that it slides in.
    double bound_secant(std::size_t k) const {
        const double normal = current_forces(k).normal;
        return normal > 0 ? in_direction(k, trials_[k].bounds) / normal : 0;
    }
    const JointLaw& law_of(std::size_t k) const {
        return p_.model.joint_material_at(p_.contacts[k].joint_material).law;
    }
    bool is_bonded(std::size_t k) const { return p_.contacts[k].bonded && !trials_[k].bond_broken; }
    /// The normal spring's force in the linear system, tension negative.
    double linear_normal(std::size_t k, double opening) const;

    // --- evaluation
    /// Takes measures and true gaps at a displacement; the linear measure of the gap is kept exact there.
    /// @param target the linear system's solution, under whose forces blocks are in balance.
    void set_displacement(std::span<const Vec6> d, std::span<const Vec6> target);
    /// Of a group of vertex-vertex lines only the one with the largest gap, the last that is crossed, may
    /// close; the gap of a line along a face that the corner is in already counts from there.
    void select_first_entrances();
    /// The largest difference between the forces of the linear system, at its solution, and those of the law,
    /// at the present displacement, N per metre.
    struct ForceChange {
        double largest = 0;
        int contact = -1;  ///< whose it is
    };
    ForceChange force_change();
    /// What a force may still move by at convergence, N per metre.
    double tolerance() const;
    /// Moves the shear bounds to those of the present normal forces and displacements; those of rough faces
    /// where more has moved than does not matter as long as nothing has converged.
    void update_bounds();
    /// Likewise, all of them.
    void update_all_bounds();
    /// Moves the dilation likewise, except where it has been postponed.
    void update_dilation();
    /// Whether that would change a normal force by much.
    bool dilation_exceeds_tolerance() const;
    /// Joints whose present dilation is farther from what their law says than none would be do not dilate any
    /// more in this step: the dilation of their history acts from the next one on. @return whether there are
    /// any.
    bool postpone_dilation();
    /// What couples normal and shear forces, N per metre: the shear bounds, forward and backward of each
    /// contact in turn.
    Eigen::VectorXd shear_bounds() const;
    /// Sets it; negative bounds to zero.
    void set_shear_bounds(const Eigen::VectorXd& coupling);
    /// Opens, for the rest of the step, the bonded contacts whose tension exceeds the strength. @return
    /// whether there were any.
    bool break_bonds();
    /// Where forces are augmented (theory, sec. 5): if a contact is not as a rigid one would be, is_within
    /// the model's tolerance, shifts the springs so that they bear the present forces at no displacement. The
    /// fixed point of these shifts is found by `mixing`. @return whether it did; never without augmentation.
    bool augment(AndersonMixing& mixing);
    /// Sets the linear system's springs to the evaluated states. @return whether its matrix changes.
    bool update_active_set();

    /// What each contact does. @param evaluated_contacts as many as contacts.
    void evaluate(std::span<EvaluatedContact> evaluated_contacts) const;
    double bolt_force(std::size_t k) const { return law_bolt_force(k, elongation_[k]); }

  private:
    /// A straight line of normal force (N per metre) over closure (m).
    struct Tangent {
        double closure = 0;
        double force = 0;
        double stiffness = 0;  ///< N/m per metre
        double at(double closed) const { return force + stiffness * (closed - closure); }
    };
    struct Trial {
        bool active = false;  ///< has its normal spring in the linear system
        bool locked = false;  ///< has its shear spring in the linear system
        bool forward = true;  ///< the direction it slides in
        bool bond_broken = false;
        bool may_close = true;
        bool postponed = false;      ///< dilates after the step
        double friction_force = 0;   ///< shear force in the linear system when not locked, N per metre
        Strength bounds;             ///< that the shear force is clipped to
        double stress_free_gap = 0;  ///< m, where the normal spring bears nothing
        double shear_origin = 0;     ///< shear force at the step's start, or as augmented since, N per metre
        double gap_offset = 0;       ///< m, gap less the linear measure of the present displacement
        double dilation_increment =
            0;                ///< m, by which shearing has moved the faces apart since the step's start
        double opening = 0;   ///< linear measure of the normal displacement, m
        double shearing = 0;  ///< of the tangential displacement, m
        Forces linear;        ///< in the linear system, at its solution
        Tangent tangent;      ///< the normal spring in the linear system
    };

    /// Calls body(k) for each contact; on several threads, so it may write what is the contact's own only.
    template <class Body>
    void for_contacts(const Body& body) const;
    /// Likewise is_one(k). @return whether any is.
    template <class IsOne>
    bool for_any_contact(const IsOne& is_one) const;
    Trial initial_trial(std::size_t k) const;
    /// Moves the shear bounds to where contacts were evaluated last. @param change_tolerance see
    /// SegmentFriction.
    void compute_bounds(double change_tolerance);
    double in_direction(std::size_t k, const Strength& strength) const {
        return trials_[k].forward ? strength.forward : strength.backward;
    }
    /// Of a contact whose law knows of no faces.
    Strength bounds_of_single_contact(std::size_t k, const ContactLoading& loading) const;
    ContactLoading initial_loading(std::size_t k) const;
    /// Where the contact was evaluated last.
    ContactLoading current_loading(std::size_t k) const;
    /// @return whether the matrix changes.
    bool update_active_set_of(std::size_t k);
    EvaluatedContact evaluated(std::size_t k) const;
    /// The contact's motion so far, with its plastic part.
    ContactMotion motion(std::size_t k) const;
    /// What shearing has moved a pair of faces apart in the step by their law, m; for each of its contacts
    /// calls `take` with it.
    template <class Take>
    void dilation_by_law(const Take& take) const;
    double gap(std::size_t k) const {
        return trials_[k].gap_offset + trials_[k].opening - trials_[k].dilation_increment;
    }
    /// m, by which the normal spring is compressed.
    double closed(std::size_t k, double opening) const;
    /// The line that touches the normal spring's curve where it bears a force; the curve itself if it is
    /// straight.
    Tangent tangent_at(std::size_t k, double force) const;
    /// The shear spring's force before the laws have their say.
    double elastic_shear(std::size_t k, double shearing) const;
    Forces current_forces(std::size_t k) const;
    /// Whether an augmented contact bears a force without touching, is too deep, moves though it is stuck, or
    /// slides against its shear force, by more than `tolerance`, m.
    bool violates_rigid_contact(std::size_t k, double tolerance) const;
    /// The plastic part of the step's shear displacement, m; all of it where the contact gives no way.
    double slip(std::size_t k, double elastic, double force) const;

    const StepProblem& p_;
    const ThreadPool& pool_;
    SegmentFriction segment_friction_;
    std::vector<Trial> trials_;
    std::vector<Vec2> moved_vertices_;  ///< per corner: its place at the present displacement
    std::vector<int> yielding_;         ///< per bolt: the sign of its yielding force, 0 when elastic
    std::vector<double> elongation_;    ///< per bolt, of the step, m
    std::vector<double> linear_bolt_;  ///< per bolt: force in the linear system, at its solution, N per metre
    bool evaluated_ = false;           ///< whether contacts have been anywhere but where they start
    bool dilates_ = false;             ///< whether any contact may
    std::size_t groups_ = 0;           ///< of vertex-vertex contacts
    std::vector<std::size_t> first_entrance_;  ///< per group, the line that may close
    double largest_force_ = 0;                 ///< the largest force of a law, N per metre
};

inline double TrialContacts::closed(std::size_t k, double opening) const {
    const Trial& trial = trials_[k];
    return -(trial.gap_offset + opening - trial.dilation_increment - trial.stress_free_gap);
}

inline double TrialContacts::linear_normal(std::size_t k, double opening) const {
    return trials_[k].tangent.at(closed(k, opening));
}

inline double TrialContacts::elastic_shear(std::size_t k, double shearing) const {
    return trials_[k].shear_origin + p_.springs[k].shear_stiffness * shearing;
}

inline Forces TrialContacts::linear_forces(std::size_t k, double opening, double shearing) const {
    const Trial& trial = trials_[k];
    return {trial.active ? linear_normal(k, opening) : 0,
            trial.locked ? elastic_shear(k, shearing) : trial.friction_force};
}

inline ContactLaw TrialContacts::law(std::size_t k) const {
    const Trial& trial = trials_[k];
    const ContactSprings& springs = p_.springs[k];
    return {springs.normal_law, trial.gap_offset,        trial.dilation_increment, trial.stress_free_gap,
            trial.shear_origin, springs.shear_stiffness, -trial.bounds.backward,   trial.bounds.forward,
            is_bonded(k),       trial.may_close};
}

}  // namespace rockslope::dda
