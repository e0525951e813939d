#pragma once

#include <utility>
#include <vector>

#include "dda/analysis/step_problem.hpp"
#include "dda/contact/search_radius.hpp"

namespace rockslope::dda {

/// The contact states and forces found in an earlier attempt at the step: the initial guess of the open-close
/// iteration in the next attempt.
struct InitialGuess {
    PerContact<Contact> contacts;  ///< sorted, as found by detect_contacts
    PerContact<EvaluatedContact> evaluated;

    /// The guess for each contact of the new attempt; null for contacts that the earlier one did not have.
    /// @param new_contacts sorted in the same order.
    PerContact<const EvaluatedContact*> match(ContactSpan<const Contact> new_contacts) const;
};

/// The assumptions of one attempt at a step. Where the solution contradicts them, they are corrected and the
/// step is attempted again.
struct Prediction {
    SearchRadius search_radius;          ///< within which corner and edge may meet in the step
    std::vector<CornerEdge> undetected;  ///< sorted pairs that penetrated without a contact
    /// Forced candidates: pairs that penetrated undetected a second time. They get a contact without an
    /// entrance-angle test.
    std::vector<CornerEdge> forced;
    PerBlock<Vec6> predicted;  ///< per block, displacement of the step; fixes the mid-step arms and normals
    int rotation_corrections = 0;  ///< number of attempts repeated because of the rotations
    InitialGuess guess;            ///< from the attempt before
    bool needs_retry = true;       ///< whether the corrected prediction deserves another attempt

    /// Asks for another attempt that starts from the displacements and contact states found.
    void retry_from(const PerBlock<Vec6>& displacement, InitialGuess found) {
        predicted = displacement;
        guess = std::move(found);
        needs_retry = true;
    }
};

}  // namespace rockslope::dda
