#pragma once

#include <span>
#include <vector>

#include "dda/analysis/step_problem.hpp"

namespace rockslope::dda {

/// What contacts did in another prediction at the step; where the iteration starts from.
struct InitialGuess {
    std::vector<Contact> contacts;  ///< sorted, as found by detect_contacts
    std::vector<EvaluatedContact> evaluated;

    /// Per contact of another prediction, sorted likewise; null for those that were not there.
    std::vector<const EvaluatedContact*> match(std::span<const Contact> new_contacts) const;
};

/// What a prediction at the step takes for granted, and a further one corrects: how far apart corners and
/// edges may meet, where blocks go, which corners come in unannounced.
struct Prediction {
    double search_radius = 0;            ///< m, within which corner and edge may meet in the step
    std::vector<CornerEdge> undetected;  ///< sorted pairs that met without a contact
    /// Of them, those that did so again: known to meet though they could not touch at the start.
    std::vector<CornerEdge> forced;
    std::vector<Vec6> predicted;   ///< per block, displacement of the whole step; fixes arms and normals
    int rotation_corrections = 0;  ///< how often that was corrected
    InitialGuess guess;            ///< what the prediction before found
    bool needs_retry = true;       ///< whether what this prediction corrects is worth another one
};

}  // namespace rockslope::dda
