#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/analysis/segment_strength.hpp"

namespace rockslope::dda {

/// A shear bound as a line over the normal force: its slope, and what it is without any, N per metre.
struct BoundLine {
    double slope = 0;
    double cohesion = 0;
};

/// The friction of the pairs of rough faces where the contacts of a step were evaluated last: one for all
/// contacts of a segment, that of their mean stress.
class SegmentFriction {
  public:
    SegmentFriction(const StepProblem& problem, const ThreadPool& pool);

    bool empty() const { return segments_.empty(); }
    /// Whether a contact is between rough faces.
    bool is_on_segment(std::size_t contact) const { return strength_.segment_of(contact) >= 0; }
    /// Asks the laws of pairs whose normal force, or the shear force of whose spring, has moved by more than
    /// `tolerance` since they were asked last, N per metre. @param loading_of gives the ContactLoading of a
    /// contact's index; @param assign is called with each contact's index and what it then bears.
    template <class LoadingOf, class Assign>
    void update(double tolerance, const LoadingOf& loading_of, const Assign& assign) {
        pool_.parallel_for(segments_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t segment = begin; segment < end; ++segment) {
                const SegmentLoading loading = strength_.loading(segment, loading_of);
                if (has_moved(segment, loading, tolerance)) evaluate_law(segment, loading);
                for (const SegmentStrength::Member& member : strength_.members(segment)) {
                    const auto k = static_cast<std::size_t>(member.contact);
                    assign(k, contact_strength(segments_[segment], loading_of(k).normal));
                }
            }
        });
    }
    /// Whether a contact's line is known: none is where its faces are open.
    bool has_line(std::size_t contact) const { return segment_of(contact).has_exponents; }
    /// A contact whose line is to be found.
    void request_line(std::size_t contact);
    /// Finds the lines that are requested, and asks the laws of those pairs among theirs that have not been
    /// asked yet. @param loading_of as above.
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
    /// The line that touches a contact's bound, as if it bore its share of their force for good; the one to
    /// that bound from no force at all as long as it has not been found.
    BoundLine line(std::size_t contact, bool forward, double normal_force) const;

  private:
    /// What is known of a segment. What it bears goes with a power of its normal force; the exponents stay
    /// for the step.
    struct Segment {
        static constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
        SegmentLoading evaluated_at = {undefined, undefined};  ///< not numbers where it is open
        Strength over_normal_force;
        double forward_exponent = 0;  ///< of the strength over the normal force
        double backward_exponent = 0;
        bool has_exponents = false;
        bool requested = false;
    };

    bool has_moved(std::size_t segment, const SegmentLoading& loading, double tolerance) const {
        const SegmentLoading& evaluated_at = segments_[segment].evaluated_at;
        const double shear_change = std::abs(loading.displacement - evaluated_at.displacement);
        return !(std::abs(loading.normal - evaluated_at.normal) <= tolerance &&
                 strength_.stiffness(segment) * shear_change <= tolerance);
    }
    const Segment& segment_of(std::size_t contact) const {
        return segments_[static_cast<std::size_t>(strength_.segment_of(contact))];
    }
    void evaluate_law(std::size_t segment, const SegmentLoading& loading);
    void find_exponents(std::size_t segment);
    /// What one of their contacts bears under a normal force, N per metre; nothing where it is open.
    static Strength contact_strength(const Segment& segment, double normal_force) {
        if (!(normal_force > 0)) return {};
        const Strength& ratio = segment.over_normal_force;
        return {normal_force * ratio.forward, normal_force * ratio.backward, normal_force * ratio.tensile};
    }

    const ThreadPool& pool_;
    SegmentStrength strength_;
    std::vector<Segment> segments_;
    std::vector<std::size_t> requested_;  ///< pairs with contacts whose lines are to be found
};

}  // namespace rockslope::dda
