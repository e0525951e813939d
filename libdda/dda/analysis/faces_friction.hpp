#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
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

    bool empty() const { return pairs_.empty(); }
    /// Whether a contact is between rough faces.
    bool has(std::size_t contact) const { return strength_.pair_of(contact) >= 0; }
    /// Asks the laws of pairs whose normal force, or the shear force of whose spring, has moved by more than
    /// `enough` since they were asked last, N per metre. @param pressed_of gives the Pressed of a contact's
    /// index; @param take is called with each contact's index and what it then bears.
    template <class PressedOf, class Take>
    void find(double enough, const PressedOf& pressed_of, const Take& take) {
        crew_.for_ranges(pairs_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t pair = begin; pair < end; ++pair) {
                const FacesPressed pressed = strength_.pressed(pair, pressed_of);
                if (has_moved(pair, pressed, enough)) ask(pair, pressed);
                for (const FacesStrength::Member& member : strength_.members(pair)) {
                    const auto k = static_cast<std::size_t>(member.contact);
                    take(k, share_of(pairs_[pair], pressed_of(k).normal));
                }
            }
        });
    }
    /// Whether a contact's line is known: none is where its faces are open.
    bool has_line(std::size_t contact) const { return pair_of(contact).has_exponents; }
    /// A contact whose line is to be found.
    void want_line(std::size_t contact);
    /// Finds the lines that are wanted, and asks the laws of those pairs among theirs that have not been
    /// asked yet. @param pressed_of as above.
    template <class PressedOf>
    void find_lines(const PressedOf& pressed_of) {
        crew_.for_ranges(wanted_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::size_t pair = wanted_[i];
                if (std::isnan(pairs_[pair].asked.normal)) ask(pair, strength_.pressed(pair, pressed_of));
                find_exponents(pair);
            }
        });
        wanted_.clear();
    }
    /// The line that touches a contact's bound, as if it bore its share of their force for good; the one to
    /// that bound from no force at all as long as it has not been found.
    BoundLine line(std::size_t contact, bool forward, double normal_force) const;

  private:
    /// What is known of a pair. What it bears goes with a power of its normal force; the exponents stay for
    /// the step.
    struct Pair {
        static constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
        FacesPressed asked = {nowhere, nowhere};  ///< not numbers where it is open
        Strength over_normal_force;
        double forward_exponent = 0;  ///< of the strength over the normal force
        double backward_exponent = 0;
        bool has_exponents = false;
        bool wanted = false;
    };

    bool has_moved(std::size_t pair, const FacesPressed& pressed, double enough) const {
        const FacesPressed& asked = pairs_[pair].asked;
        const double way = std::abs(pressed.displacement - asked.displacement);
        return !(std::abs(pressed.normal - asked.normal) <= enough &&
                 strength_.stiffness(pair) * way <= enough);
    }
    const Pair& pair_of(std::size_t contact) const {
        return pairs_[static_cast<std::size_t>(strength_.pair_of(contact))];
    }
    void ask(std::size_t pair, const FacesPressed& pressed);
    void find_exponents(std::size_t pair);
    /// What one of their contacts bears under a normal force, N per metre; nothing where it is open.
    static Strength share_of(const Pair& pair, double normal_force) {
        if (!(normal_force > 0)) return {};
        const Strength& ratio = pair.over_normal_force;
        return {normal_force * ratio.forward, normal_force * ratio.backward, normal_force * ratio.tensile};
    }

    const Crew& crew_;
    FacesStrength strength_;
    std::vector<Pair> pairs_;
    std::vector<std::size_t> wanted_;  ///< pairs with contacts whose lines are to be found
};

}  // namespace dda
