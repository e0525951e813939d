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
    FacesFriction(const StepProblem& problem, const Crew& crew)
        : crew_(crew), strength_(problem), friction_(strength_.count()) {}

    bool empty() const { return friction_.empty(); }
    /// Whether a contact is between rough faces.
    bool has(std::size_t contact) const { return strength_.pair_of(contact) >= 0; }
    /// Asks the laws. @param pressed_of gives the Pressed of a contact's index.
    template <class PressedOf>
    void find(const PressedOf& pressed_of) {
        crew_.for_ranges(friction_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t pair = begin; pair < end; ++pair)
                find_of(pair, strength_.pressed(pair, pressed_of));
        });
    }
    /// What one of their contacts bears under a normal force, N per metre; nothing where it is open.
    Strength bounds(std::size_t contact, double normal_force) const;
    /// The line that touches its bound, as if it bore its share of their force for good.
    BoundLine line(std::size_t contact, bool forward, double normal_force) const;

  private:
    struct OfPair {
        Strength over_normal_force;
        bool curved = false;  ///< whether the exponents are known; they stay for the step
        Strength exponent;    ///< of the normal force, that the strength over it goes with
    };

    void find_of(std::size_t pair, const FacesPressed& pressed);
    const OfPair& of(std::size_t contact) const {
        return friction_[static_cast<std::size_t>(strength_.pair_of(contact))];
    }

    const Crew& crew_;
    FacesStrength strength_;
    std::vector<OfPair> friction_;
};

}  // namespace dda
