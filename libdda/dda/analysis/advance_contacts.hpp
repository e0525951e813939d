#pragma once

#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

/// What an accepted step did to its contacts.
struct ContactStep {
    const JointSegments& segments;    ///< of the contacts
    CornerSpan<const Vec2> vertices;  ///< m, at the step's end
    ContactSpan<const EvaluatedContact> evaluated;
    ContactSpan<const ContactSprings> springs;
    StepTime time;
    bool bonds_hold = false;  ///< see StepProblem
};

/// Advances the contacts of an accepted step to its end: geometry, state, forces, slip and joint histories.
void advance_contacts(const Model& model, const ContactStep& step, const ThreadPool& pool,
                      ContactSpan<Contact> contacts);

}  // namespace rockslope::dda
