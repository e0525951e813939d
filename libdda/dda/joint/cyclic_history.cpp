#include "dda/joint/cyclic_history.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

namespace {

/// f of Eq. (63): wear by reversals and by cycles beyond those given.
double wear_factor(const CyclicBartonBandis& law, const CyclicBartonBandis::History& history) {
    const int further = history.cycle - static_cast<int>(law.cycles.size());
    double wear = 1;
    if (law.reversal_factor != 1) wear *= std::pow(law.reversal_factor, history.reversals);
    if (law.further_cycle_factor != 1 && further > 0) wear *= std::pow(law.further_cycle_factor, further);
    return wear;
}

}  // namespace

void move_to(const CyclicBartonBandis& law, const CyclicRoughness::Place& place, int direction,
             double distance, CyclicBartonBandis::History& history) {
    history.position = distance == 0 ? 0 : (place.away ? direction : -direction) * distance;
    if (place.away) {
        double& reached = place.side > 0 ? history.furthest_forward : history.furthest_backward;
        reached = std::max(reached, distance);
        return;
    }
    if (distance != 0) return;
    if (history.forward == 0) history.furthest_forward = 0;  // no slip yet
    if (place.side < 0 && history.furthest_backward >= law.peak_displacement) {
        ++history.cycle;
        history.furthest_forward = history.furthest_backward = 0;
        history.wear = wear_factor(law, history);
    }
}

bool count_slip(const CyclicBartonBandis& law, int direction, double amount,
                CyclicBartonBandis::History& history) {
    if (!(amount > 0)) return false;
    if (history.slip_direction == 0) history.slip_direction = direction;
    if (history.slip_direction == direction) {
        history.reverse_slip = 0;
        if (history.reversal_slip > 0) history.reversal_slip += amount;
        return false;
    }
    history.reversal_slip = 0;
    history.reverse_slip += amount;
    if (!(history.reverse_slip > law.min_slip)) return false;
    count_reversal(law, history);
    return true;
}

void count_reversal(const CyclicBartonBandis& law, CyclicBartonBandis::History& history) {
    ++history.reversals;
    history.slip_direction = -history.slip_direction;
    history.reversal_slip = std::max(history.reverse_slip, law.min_slip);
    history.reverse_slip = 0;
    history.wear = wear_factor(law, history);
}

void set_stage(const CyclicRoughness::Place& place, bool sliding, CyclicBartonBandis::History& history) {
    history.sliding = sliding ? 1 : 0;
    history.stage = static_cast<std::int32_t>(CyclicRoughness::stage(place, sliding));
}

void set_ratios(const CyclicRoughness& roughness, const CyclicRoughness::Place& place,
                CyclicBartonBandis::History& history) {
    if (place.away) history.unloading_ratio = roughness.advance_ratio(place);
    history.mobilised_ratio = roughness.mobilised_ratio(place, history.sliding != 0, history.unloading_ratio);
}

}  // namespace rockslope::dda
