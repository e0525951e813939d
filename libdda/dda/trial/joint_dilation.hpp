#pragma once

#include <span>
#include <vector>

#include "dda/trial/joint_motion.hpp"
#include "dda/trial/shear_energy.hpp"
#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// How the dilation of a joint segment follows its normal force while its displacement is held: where the
/// joint slips, a smaller normal force lets its shear spring slip on.
struct DilationByForce {
    std::span<const ContactIndex> contacts;
    double slope = 0;         ///< m per N per metre, Eq. (85), of the dilation by the normal force; negative
    double normal_force = 0;  ///< N per metre, of the segment at its last evaluation
    double change = 0;        ///< m, of the dilation since then by the normal force
};

/// A correction of the dilation of a joint segment that dilates with its displacement: what the law gave
/// beyond it, and by how much it was moved, m.
struct DilationCorrection {
    double excess = 0;
    double correction = 0;

    /// How much smaller the excess becomes for each metre of a correction, 1 to 5: more than 1 where the
    /// dilation raises the normal force, under which the law gives less. @param excess_now m, what the law
    /// gives beyond the dilation after this correction.
    double response(double excess_now) const;
};

/// Sets the dilation of the joint segments of a step, and its slopes. A joint segment dilates as a whole, by
/// the combined motion of its contacts.
class JointDilation {
  public:
    /// @param problem, trials must outlive the dilation.
    JointDilation(const StepProblem& problem, TrialContacts& trials);

    /// Whether the law of any joint dilates.
    bool any() const { return any_; }
    /// Moves the dilation to that of the forces and displacements at the iterate, Eq. (104), except where it
    /// is postponed.
    void update();
    /// Whether update() would change a normal force by more than ten times the tolerance, also one that it
    /// would close.
    bool exceeds_tolerance() const;
    /// Sets the dilation of the step to that of the locked part of its displacement, where it is farther from
    /// the law's value than that is. The rest acts from the next step on. @return whether any was changed.
    bool postpone();
    /// Lowers the dilation of the segments whose friction would give energy, so that it gives none at the
    /// present forces. @return whether any was changed.
    bool limit();

    /// The slipping segments whose dilation follows the normal force, as the last update() found them.
    std::span<const DilationByForce> by_force() const { return by_force_; }
    /// Sets the change of a dilation by the normal force, m. @param index in by_force().
    void set_change(std::size_t index, double change);

  private:
    /// Calls visit(segment, law, contacts, motion) for each segment whose law dilates, with its motion in the
    /// step; none without a normal force.
    template <class Visit>
    void visit_segments(const Visit& visit) const;
    /// Evaluates the dilation of the step by the joint laws. Calls visit(k, dilation increment, m) for each
    /// contact of a segment whose law dilates.
    template <class Visit>
    void visit_by_law(const Visit& visit) const;
    /// Sets the dilation of a segment that dilates with slip to that under the normal force which it causes
    /// itself, at the present displacement. @return the motion of the segment with that force.
    SegmentMotion find_under_own_force(const JointLaw& law, std::span<const ContactIndex> members,
                                       const SegmentMotion& present);
    /// Whether the dilation by the law would change the normal force by more than ten times the tolerance,
    /// also one that it would close.
    bool is_unsettled(ContactIndex k, double by_law) const;
    /// The dilation of the step if only the locked part of its displacement dilates the joint, m.
    double locked_dilation_of(ContactIndex k) const;
    /// The contact at the step's end, at the iterate.
    ShearedContact sheared_at_end(ContactIndex k) const;
    /// What friction takes from a contact of a dilating joint, J per metre. @param after its locked dilation
    /// at the step's end.
    double dilating_loss(ContactIndex k, const LockedDilation& after) const;

    const StepProblem& p_;
    TrialContacts& trials_;
    bool any_;
    std::vector<DilationByForce> by_force_;
    std::vector<DilationCorrection> corrections_;  ///< per segment, of the last update()
};

}  // namespace rockslope::dda
