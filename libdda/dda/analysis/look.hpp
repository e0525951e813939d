#pragma once

#include <span>
#include <vector>

#include "dda/analysis/step_problem.hpp"

namespace dda {

/// What contacts did in another look at the step; where the iteration starts from.
struct Guess {
    std::vector<Contact> contacts;  ///< sorted, as found by detect_contacts
    std::vector<JudgedContact> judged;

    /// Per contact of another look, sorted likewise; null for those that were not there.
    std::vector<const JudgedContact*> of(std::span<const Contact> others) const;
};

/// What a look at the step takes for granted, and a further one corrects: how far apart corners and edges may
/// meet, where blocks go, which corners come in unannounced.
struct Look {
    double reach = 0;                ///< m, within which corner and edge may meet in the step
    std::vector<CornerEdge> missed;  ///< sorted pairs that met without a contact
    /// Of them, those that did so again: known to meet though they could not touch at the start.
    std::vector<CornerEdge> entering;
    std::vector<Vec6> predicted;  ///< per block, displacement of the whole step; fixes arms and normals
    int turns = 0;                ///< how often that was corrected
    Guess guess;                  ///< what the look before found
    bool wanted = true;           ///< whether what this look corrects is worth another one
};

}  // namespace dda
