#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dda/trial/joint_motion.hpp"
#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

/// Normal force (N per metre) and tangential displacement (m) of a contact at some displacement of a step.
struct ContactLoading {
    double normal = 0;
    double shearing = 0;
};

/// Normal force (N per metre) and tangential displacement (m) of a joint segment.
struct SegmentLoading {
    double normal = 0;
    double displacement = 0;
};

/// Strengths of the joint segments in a step. During the iterations of a step only normal forces and
/// tangential displacements change; the other arguments of a segment's law are computed once, by
/// `segment_motion`.
class SegmentStrength {
  public:
    struct Member {
        ContactIndex contact;
        MemberWeight weight;
    };

    explicit SegmentStrength(const StepProblem& problem);

    /// Number of joint segments.
    std::size_t count() const { return segments_.size(); }
    /// The joint segment of a contact, or -1.
    int segment_of(ContactIndex contact) const { return segment_of_[contact]; }
    /// Sum of the shear stiffnesses of a segment's contacts, N/m per metre.
    double stiffness(std::size_t segment) const { return segments_[segment].stiffness; }
    /// The contacts of a segment.
    std::span<const Member> members(std::size_t segment) const {
        return std::span(members_).subspan(segments_[segment].first, segments_[segment].count);
    }
    /// @param loading_of gives the ContactLoading of a contact's index.
    template <class LoadingOf>
    SegmentLoading loading(std::size_t segment, const LoadingOf& loading_of) const {
        SegmentLoading total;
        for (const Member& member : members(segment)) {
            const ContactLoading one = loading_of(member.contact);
            total.normal += std::max(one.normal, 0.0);
            if (member.weight.counts)
                total.displacement =
                    weighted_mean(total.displacement, one.shearing, member.weight.previous_weight);
        }
        return total;
    }
    /// Strengths over the normal force of a joint segment, divided by the model's strength reduction. They
    /// hold for each contact of the segment. @param loading with a positive normal force.
    Strength over_normal_force(std::size_t segment, const SegmentLoading& loading) const;
    /// The hardening over the normal force of the strength in the direction of the displacement, 1/m; zero
    /// where the joint softens. It is a secant over a hundredth of the displacement at which the springs of
    /// the segment would bear the strength. @param strength over_normal_force() at the loading.
    Hardening hardening(std::size_t segment, const SegmentLoading& loading, const Strength& strength) const;

  private:
    struct Segment {
        std::uint32_t first = 0;  ///< index of its first member
        std::uint32_t count = 0;  ///< of its members
        const JointLaw* law = nullptr;
        const JointHistory* history = nullptr;
        double length = 0;           ///< m
        double shear_force = 0;      ///< argument of the law, see contact_motion, N per metre
        double normal_force = 0;     ///< at the step's start, N per metre
        double locked_slope = 0;     ///< t of Eq. (77), times the strength reduction
        double shear_stiffness = 0;  ///< argument of the law, see contact_motion, N/m per metre
        double stiffness = 0;        ///< sum over its springs, N/m per metre
    };

    const StepProblem& p_;
    double strength_factor_;  ///< 1 / strength reduction
    PerContact<int> segment_of_;
    std::vector<Member> members_;
    std::vector<Segment> segments_;
};

}  // namespace rockslope::dda
