#pragma once

#include <utility>
#include <vector>

#include "dda/contact/search_radius.hpp"
#include "dda/trial/step_problem.hpp"

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
    /// The block whose rotation the last of them corrected most.
    BlockIndex turning_block = BlockIndex::none();
    InitialGuess guess;       ///< from the attempt before
    bool needs_retry = true;  ///< whether the corrected prediction deserves another attempt

    /// Whether the displacements found leave pairs beyond the search radius that may have met.
    /// @param moved m, the largest displacement of a vertex; two vertices approach by twice as much.
    bool is_outrun_by(double moved) const { return 2 * moved > search_radius.largest(); }
    /// Widens the search radius for the displacements found. @param moved m, the largest one of a vertex.
    void widen_for(double moved) { search_radius.widen(radius_over_displacement * moved); }
    /// Whether an earlier attempt found displacements and contact states.
    bool has_guess() const { return !guess.contacts.empty(); }
    /// Asks for another attempt that starts from the displacements and contact states found.
    void retry_from(const PerBlock<Vec6>& displacement, InitialGuess found) {
        predicted = displacement;
        guess = std::move(found);
        needs_retry = true;
    }

  private:
    /// Search radius of another attempt over the largest displacement found: twice that one, and a quarter
    /// more for what the next attempt finds.
    static constexpr double radius_over_displacement = 2.5;
};

}  // namespace rockslope::dda
