#pragma once

#include <cstddef>
#include <vector>

#include "dda/analysis/faces_strength.hpp"
#include "dda/base/parallel.hpp"

namespace dda {

/// A shear bound as a line over the normal force: its slope, and what it is without any, N per metre.
struct BoundLine {
    double slope = 0;
    double cohesion = 0;
};

/// The friction of the pairs of rough faces where the contacts of a step were judged last: one for all
/// contacts of a pair, that of their mean stress.
class FacesFriction {
  public:
    FacesFriction(const StepProblem& problem, const Crew& crew);

    bool empty() const { return over_normal_force_.empty(); }
    /// Whether a contact is between rough faces.
    bool has(std::size_t contact) const { return strength_.pair_of(contact) >= 0; }
    /// Asks the laws of pairs whose normal force, or the shear force of whose spring, has moved by more than
    /// `enough` since they were asked last, N per metre. @param pressed_of gives the Pressed of a contact's
    /// index.
    template <class PressedOf>
    void find(double enough, const PressedOf& pressed_of) {
        find(enough, pressed_of, [](std::size_t, const Strength&) {});
    }
    /// Likewise, and calls `take` with each contact's index and what it then bears.
    template <class PressedOf, class Take>
    void find(double enough, const PressedOf& pressed_of, const Take& take) {
        crew_.for_ranges(over_normal_force_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t pair = begin; pair < end; ++pair) {
                find_of(pair, strength_.pressed(pair, pressed_of), enough);
                for (const FacesStrength::Member& member : strength_.members(pair)) {
                    const auto k = static_cast<std::size_t>(member.contact);
                    take(k, share_of(pair, pressed_of(k).normal));
                }
            }
        });
    }
    /// What one of their contacts bears under a normal force, N per metre; nothing where it is open.
    Strength bounds(std::size_t contact, double normal_force) const {
        return share_of(pair_of(contact), normal_force);
    }
    /// The line that touches its bound, as if it bore its share of their force for good.
    BoundLine line(std::size_t contact, bool forward, double normal_force) const;

  private:
    /// Of the normal force, that a strength over it goes with; it stays for the step.
    struct Exponent {
        bool known = false;
        double forward = 0;
        double backward = 0;
    };

    void find_of(std::size_t pair, const FacesPressed& pressed, double enough);
    Strength share_of(std::size_t pair, double normal_force) const {
        if (!(normal_force > 0)) return {};
        const Strength& ratio = over_normal_force_[pair];
        return {normal_force * ratio.forward, normal_force * ratio.backward, normal_force * ratio.tensile};
    }
    std::size_t pair_of(std::size_t contact) const {
        return static_cast<std::size_t>(strength_.pair_of(contact));
    }

    const Crew& crew_;
    FacesStrength strength_;
    std::vector<Strength> over_normal_force_;  ///< per pair
    std::vector<FacesPressed> asked_;          ///< likewise, at what; not numbers where it was open
    std::vector<Exponent> exponents_;          ///< likewise
};

}  // namespace dda
