#pragma once

#include "dda/trial/step_contacts.hpp"
#include "support/first_step.hpp"

namespace rockslope::scene {

/// A block of 1 m on a fixed floor, and its two contacts at x = 0 and x = 1, each of 0.5 m and with springs
/// of 1e9 N/m. Their normal is (0, 1) and their tangent (-1, 0).
inline Scene resting_block(const dda::JointLaw& law) {
    Scene s;
    s.model.joint_materials[0].law = law;
    s.model.normal_penalty = s.model.shear_penalty = 1e9;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    return s;
}

/// The trial contacts of the block in its first step.
struct RestingContacts {
    static constexpr double spring = 1e9;  ///< N/m per metre, normal and shear

    FirstStep step;
    dda::StepProblem problem = step.problem();
    dda::StepContacts contacts{problem, step.pool};
    dda::TrialContacts& trials = contacts.trials;
    dda::ShearBounds& bounds = contacts.bounds;

    explicit RestingContacts(const Scene& s) : step(s.model) {}
    explicit RestingContacts(const dda::JointLaw& law) : RestingContacts(resting_block(law)) {}

    /// Moves the block along the tangent, sliding forward, and into the floor, m.
    void move(double along, double into) {
        const std::vector<Vec6> d{displacement(along, into)};
        trials.set_displacement(d, d);
    }
    static Vec6 displacement(double along, double into) {
        Vec6 d = Vec6::Zero();
        d.head<2>() = Vec2(-along, -into);
        return d;
    }
    std::vector<dda::EvaluatedContact> evaluated() const {
        std::vector<dda::EvaluatedContact> all(trials.count());
        trials.evaluate(all);
        return all;
    }
};

}  // namespace rockslope::scene
