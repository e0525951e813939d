#pragma once

#include <cstdint>
#include <vector>

#include "dda/analysis/counter_slips.hpp"
#include "dda/analysis/state.hpp"

namespace rockslope::dda {

/// A counter-slip about as large as the slip that makes it a reversal.
struct CloseReversal {
    double time = 0;  ///< s of the run, when the joint slipped the other way, or at the end of the run
    JointCounterSlip joint;
    bool ended = true;  ///< false: the joint has not slipped the other way
};

/// Counter-slips within a factor of 5 of the least slip of a reversal, `min_slip`: those for which the least
/// slip decides whether they wear the joint. Each of them may move a slope by metres.
struct CloseReversals {
    /// Largest ratio of a counter-slip to the least slip of a reversal, or the inverse. A `min_slip` that is
    /// chosen well lies farther from all counter-slips; with more than 10 the slip of every pulse is listed.
    static constexpr double factor = 5;
    /// Number of counter-slips listed, so that the summary stays small; all are counted.
    static constexpr std::size_t most = 20;

    std::int64_t counted = 0;      ///< reversals
    std::int64_t not_counted = 0;  ///< counter-slips that were no reversals
    /// Those nearest to the least slip, the nearest by ratio first, then the earliest.
    std::vector<CloseReversal> nearest;

    /// Adds a counter-slip, if it is close.
    void add(const CloseReversal& reversal);
};

/// The close reversals at the end of a run: those so far and the counter-slips that have not ended.
CloseReversals with_present(CloseReversals so_far, const Model& model, const State& state);

}  // namespace rockslope::dda
