#pragma once

#include <Eigen/Core>

#include "dda/trial/segment_friction.hpp"
#include "dda/trial/shear_line.hpp"
#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// Sets the shear bounds of the contacts of a step by their joint laws. Contacts on a rough joint segment
/// have one friction law in common.
class ShearBounds {
  public:
    /// Sets the bounds of contacts that slide at first. @param problem, trials must outlive the bounds.
    ShearBounds(const StepProblem& problem, TrialContacts& trials, const ThreadPool& pool);

    /// Sets the shear bounds to those of the forces and displacements at the iterate. A rough joint segment
    /// whose forces have changed by less than a tenth of the tolerance keeps the result of its law.
    void update();
    /// Sets the shear bounds, evaluating all joint laws.
    void update_all() { compute(0); }
    /// Whether bounds keep their hardening when they are set: bounds from one minimum to the next differ by
    /// the laws alone then, and can be mixed.
    void hold_hardening(bool holds) { holds_hardening_ = holds; }
    /// The shear bounds at no shear displacement, N per metre: forward and backward of each contact in turn.
    Eigen::VectorXd values() const;
    /// Sets the shear bounds; negative values become zero.
    void set_values(const Eigen::VectorXd& values);

    /// Whether any contact is on a rough joint segment.
    bool has_segments() const { return !segments_.empty(); }
    /// Whether a contact is on a rough joint segment.
    bool is_on_segment(ContactIndex k) const { return segments_.is_on_segment(k); }
    /// Both shear bounds over the normal force at which they were set; zero without one.
    Strength over_normal_force(ContactIndex k) const;

    /// The shear bound of a contact as a line over its normal force: the law's own where it has one; on a
    /// joint segment the tangent at the iterate; otherwise the secant between a normal force and half of it.
    /// An unbonded contact without a normal force there gets the secant from zero to the iterate.
    /// @param normal N per metre, the normal force; @param d per row, m, the displacement at which the law is
    /// evaluated.
    ShearLine line(ContactIndex k, double normal, RowSpan<const Vec6> d) const;
    /// Whether the line of a contact on a segment has been computed; a segment that is open has none.
    bool has_line(ContactIndex k) const { return segments_.has_line(k); }
    /// Marks the line of a contact on a segment to be computed by find_requested_lines().
    void request_line(ContactIndex k) { segments_.request_line(k); }
    /// Computes the marked lines.
    void find_requested_lines() {
        segments_.find_requested_lines([this](ContactIndex k) { return trials_.loading(k); });
    }

  private:
    /// Sets the shear bounds by the laws. @param change_tolerance see `tolerance` of SegmentFriction::update.
    void compute(double change_tolerance);
    /// The shear bounds of a contact that is not on a segment, under a loading, Eq. (75). The cohesion
    /// of a contact that was closed at the step's start acts through the whole step, also where the contact
    /// opens; that of a contact that closes acts from the next step on. The bounds are therefore continuous
    /// functions of the displacement, and the step has a solution.
    Strength bounds_at(ContactIndex k, const ContactLoading& here) const;
    /// The bound in the sliding direction of a contact that is not on a segment, N per metre.
    double bound_at(ContactIndex k, double normal, RowSpan<const Vec6> d) const;

    const StepProblem& p_;
    TrialContacts& trials_;
    SegmentFriction segments_;
    bool holds_hardening_ = false;
};

}  // namespace rockslope::dda
