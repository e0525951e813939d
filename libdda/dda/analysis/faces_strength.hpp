#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dda/analysis/step_problem.hpp"

namespace dda {

/// Normal force (N per metre) and tangential displacement (m) of a contact at some displacement of a step.
struct Pressed {
    double normal = 0;
    double shearing = 0;
};

/// What presses a pair of faces, N per metre, and how far they have been sheared, m.
struct FacesPressed {
    double normal = 0;
    double displacement = 0;
};

/// What the pairs of rough faces bear in a step. In the many displacements that a step tries only normal
/// forces and shear displacements change: what a pair's law asks for besides is put together once, the same
/// as `faces_motion` makes of it.
class FacesStrength {
  public:
    struct Member {
        int contact = 0;
        bool moves = true;  ///< closed at the step's start, or all are open: it tells how the faces move
        double before = 0;  ///< share in the faces' displacement of the members before it
        double share = 1;   ///< and its own
    };

    explicit FacesStrength(const StepProblem& problem);

    std::size_t count() const { return pairs_.size(); }
    /// The pair of faces that a contact is between, or -1.
    int pair_of(std::size_t contact) const { return pair_of_[contact]; }
    /// N/m per metre, of the shear springs of a pair of faces together.
    double stiffness(std::size_t pair) const { return pairs_[pair].stiffness; }
    /// The contacts of a pair.
    std::span<const Member> members(std::size_t pair) const {
        return std::span(members_).subspan(pairs_[pair].first, pairs_[pair].count);
    }
    /// @param pressed_of gives the Pressed of a contact's index.
    template <class PressedOf>
    FacesPressed pressed(std::size_t pair, const PressedOf& pressed_of) const {
        FacesPressed whole;
        for (const Member& member : members(pair)) {
            const Pressed one = pressed_of(static_cast<std::size_t>(member.contact));
            whole.normal += std::max(one.normal, 0.0);
            if (member.moves)
                whole.displacement = member.before * whole.displacement + member.share * one.shearing;
        }
        return whole;
    }
    /// Strengths over the normal force of a pair of faces, the same for each of its contacts; reduced if the
    /// model's strengths are. @param pressed with a positive normal force.
    Strength over_normal_force(std::size_t pair, const FacesPressed& pressed) const;

  private:
    struct Pair {
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
    double reduced_;  ///< strength, of the full one
    std::vector<int> pair_of_;
    std::vector<Member> members_;
    std::vector<Pair> pairs_;
};

}  // namespace dda
