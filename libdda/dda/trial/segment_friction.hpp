#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/trial/segment_strength.hpp"
#include "dda/trial/shear_line.hpp"

namespace rockslope::dda {

/// Shear bounds of the contacts on joint segments. A segment has one ratio of strength over normal force,
/// that of its mean stress, for all its contacts. It is computed at the displacements at which the contacts
/// were evaluated last.
class SegmentFriction {
  public:
    SegmentFriction(const StepProblem& problem, const ThreadPool& pool);

    bool empty() const { return segments_.empty(); }
    /// Whether a contact is a member of a joint segment.
    bool is_on_segment(ContactIndex contact) const { return strength_.segment_of(contact) >= 0; }
    /// Evaluates the laws of segments whose normal force, or whose springs' shear force, has changed by more
    /// than `tolerance` (N per metre) since their last evaluation. @param loading_of gives the ContactLoading
    /// of a contact's index; @param assign is called with each contact's index, its Strength and its
    /// Hardening.
    template <class LoadingOf, class Assign>
    void update(double tolerance, const LoadingOf& loading_of, const Assign& assign) {
        pool_.parallel_for(segments_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t segment = begin; segment < end; ++segment) {
                const SegmentLoading loading = strength_.loading(segment, loading_of);
                if (has_moved(segment, loading, tolerance)) evaluate_law(segment, loading);
                for (const SegmentStrength::Member& member : strength_.members(segment)) {
                    const ContactIndex k = member.contact;
                    const double normal = loading_of(k).normal;
                    const double pressing = normal > 0 ? normal : 0;
                    assign(k, pressing * segments_[segment].over_normal_force,
                           pressing * segments_[segment].hardening);
                }
            }
        });
    }
    /// Whether the bound line of a contact has been computed; an open segment has none.
    bool has_line(ContactIndex contact) const { return segment_of(contact).has_exponents; }
    /// Requests the bound line of a contact from the next `find_requested_lines`.
    void request_line(ContactIndex contact);
    /// Computes the requested lines; a segment that has no evaluation, or was open in it, is evaluated first.
    /// @param loading_of as above.
    template <class LoadingOf>
    void find_requested_lines(const LoadingOf& loading_of) {
        pool_.parallel_for(requested_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::size_t segment = requested_[i];
                if (std::isnan(segments_[segment].evaluated_at.normal))
                    evaluate_law(segment, strength_.loading(segment, loading_of));
                find_exponents(segment);
            }
        });
        requested_.clear();
    }
    /// Tangent of a contact's bound at a normal force, with the contact's fraction of the segment's normal
    /// force held constant. Before the line has been computed: the secant from zero force, marked as missing.
    ShearLine line(ContactIndex contact, bool forward, double normal_force) const;

  private:
    /// Last evaluation of a segment. Its strength is taken to be a power of its normal force; the exponents
    /// are constant in a step.
    struct Segment {
        static constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
        SegmentLoading evaluated_at = {undefined, undefined};  ///< NaN where it is open
        Strength over_normal_force;
        Hardening hardening;           ///< over the normal force
        double forward_exponent = 0;   ///< of strength / normal force
        double backward_exponent = 0;  ///< of strength / normal force
        bool has_exponents = false;
        bool requested = false;
    };

    bool has_moved(std::size_t segment, const SegmentLoading& loading, double tolerance) const {
        const SegmentLoading& evaluated_at = segments_[segment].evaluated_at;
        const double shear_change = std::abs(loading.displacement - evaluated_at.displacement);
        return !(std::abs(loading.normal - evaluated_at.normal) <= tolerance &&
                 strength_.stiffness(segment) * shear_change <= tolerance);
    }
    const Segment& segment_of(ContactIndex contact) const { return segments_[strength_.segment_of(contact)]; }
    void evaluate_law(std::size_t segment, const SegmentLoading& loading);
    void find_exponents(std::size_t segment);

    const ThreadPool& pool_;
    SegmentStrength strength_;
    std::vector<Segment> segments_;
    std::vector<std::size_t> requested_;  ///< segments whose lines are requested
};

}  // namespace rockslope::dda
