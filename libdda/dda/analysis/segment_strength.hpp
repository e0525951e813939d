#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dda/analysis/step_problem.hpp"

namespace rockslope::dda {

/// Normal force (N per metre) and tangential displacement (m) of a contact at some displacement of a step.
struct ContactLoading {
    double normal = 0;
    double shearing = 0;
};

/// What presses a segment of faces, N per metre, and how far they have been sheared, m.
struct SegmentLoading {
    double normal = 0;
    double displacement = 0;
};

/// What the pairs of rough faces bear in a step. In the many displacements that a step tries only normal
/// forces and shear displacements change: what a segment's law asks for besides is put together once, the
/// same as `segment_motion` makes of it.
class SegmentStrength {
  public:
    struct Member {
        int contact = 0;
        bool counts = true;  ///< closed at the step's start, or all are open: it tells how the faces move
        double previous_weight = 0;  ///< share in the faces' displacement of the members before it
        double weight = 1;           ///< and its own
    };

    explicit SegmentStrength(const StepProblem& problem);

    std::size_t count() const { return segments_.size(); }
    /// The segment of faces that a contact is between, or -1.
    int segment_of(std::size_t contact) const { return segment_of_[contact]; }
    /// N/m per metre, of the shear springs of a segment of faces together.
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
            const ContactLoading one = loading_of(static_cast<std::size_t>(member.contact));
            total.normal += std::max(one.normal, 0.0);
            if (member.counts)
                total.displacement =
                    member.previous_weight * total.displacement + member.weight * one.shearing;
        }
        return total;
    }
    /// Strengths over the normal force of a segment of faces, the same for each of its contacts; reduced if
    /// the model's strengths are. @param loading with a positive normal force.
    Strength over_normal_force(std::size_t segment, const SegmentLoading& loading) const;

  private:
    struct Segment {
        std::uint32_t first = 0;  ///< of its members
        std::uint32_t count = 0;  ///< likewise
        const JointLaw* law = nullptr;
        const JointHistory* history = nullptr;
        double length = 0;           ///< m
        double shear_force = 0;      ///< at the step's start, N per metre
        double shear_stiffness = 0;  ///< as the law takes it, N/m per metre
        double stiffness = 0;        ///< of its springs together, N/m per metre
    };

    void add_members(std::span<const int> contacts);

    const StepProblem& p_;
    double strength_factor_;  ///< strength, of the full one
    std::vector<int> segment_of_;
    std::vector<Member> members_;
    std::vector<Segment> segments_;
};

}  // namespace rockslope::dda
