#include "dda/monitor/close_reversals.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

namespace {

/// Distance of a counter-slip from the least slip of a reversal: the logarithm of the larger over the
/// smaller.
double distance_of(const CounterSlip& slip) {
    return std::abs(std::log(slip.amount / slip.least));
}

}  // namespace

void CloseReversals::add(const CloseReversal& reversal) {
    const CounterSlip& slip = reversal.joint.slip;
    if (!(slip.least > 0) || slip.amount > factor * slip.least || slip.least > factor * slip.amount) return;
    ++(slip.counted ? counted : not_counted);
    const auto at = std::upper_bound(
        nearest.begin(), nearest.end(), distance_of(slip),
        [](double distance, const CloseReversal& other) { return distance < distance_of(other.joint.slip); });
    nearest.insert(at, reversal);
    if (nearest.size() > most) nearest.pop_back();
}

CloseReversals with_present(CloseReversals so_far, const Model& model, const State& state) {
    for (const JointCounterSlip& joint : present_counter_slips(model, state.contacts.contacts))
        so_far.add({state.time, joint, false});
    return so_far;
}

}  // namespace rockslope::dda
