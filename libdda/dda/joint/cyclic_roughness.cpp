#include "dda/joint/cyclic_roughness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockslope::dda {

CyclicRoughness::Place CyclicRoughness::place(double position, int direction) const {
    // Before the first slip both sides are the forward one.
    const int forward = !is_fresh() ? history_.forward : position != 0 ? (position > 0 ? 1 : -1) : direction;
    const double ahead = forward * position;
    const int motion = forward * direction;
    const int side = ahead > 0 || (ahead == 0 && motion > 0) ? 1 : -1;
    return {std::abs(position), side, side == motion};
}

const CyclicBartonBandis::Cycle& CyclicRoughness::cycle() const {
    const auto last = static_cast<std::int32_t>(law_.cycles.size());
    return law_.cycles[static_cast<std::size_t>(std::min(history_.cycle, last) - 1)];
}

const RoughnessTable& CyclicRoughness::roughness_table(const Place& place) const {
    const CyclicBartonBandis::Cycle& tables = cycle();
    if (place.side > 0) return place.away ? tables.forward_advance : tables.forward_return;
    return place.away ? tables.backward_advance : tables.backward_return;
}

/// A joint that has never slipped has its advance strength in both directions.
const RoughnessTable& CyclicRoughness::bound_table(const Place& place) const {
    return is_fresh() ? cycle().forward_advance : roughness_table(place);
}

double CyclicRoughness::advance_ratio(const Place& place) const {
    const Place outwards = {place.distance, place.side, true};
    const RoughnessTable& table = roughness_table(outwards);
    const double ratio = table.ratio(place.distance / law_.peak_displacement);
    if (!is_worn(outwards)) return ratio;
    return std::min(ratio, table.ratio(furthest(place.side) / law_.peak_displacement));
}

double CyclicRoughness::first_advance_ratio(double distance) const {
    return law_.cycles.front().forward_advance.ratio(distance / law_.peak_displacement);
}

JointStage CyclicRoughness::stage(const Place& place, bool sliding) {
    const bool forward = place.side > 0;
    if (place.away) return forward ? JointStage::forward_advance : JointStage::backward_advance;
    if (sliding) return forward ? JointStage::forward_return : JointStage::backward_return;
    return forward ? JointStage::forward_unloading : JointStage::backward_unloading;
}

double CyclicRoughness::mobilised_ratio(const Place& place, bool sliding, double unloading_ratio) const {
    const bool returning = !place.away && sliding;
    return history_.wear * (returning ? roughness_table(place).ratio(place.distance / law_.peak_displacement)
                                      : unloading_ratio);
}

double CyclicRoughness::unworn_bound_ratio(const Place& place, double distance) const {
    return is_before_first_peak(place, distance)
               ? 1
               : bound_table(place).ratio(distance / law_.peak_displacement);
}

double CyclicRoughness::bound_ratio(const Place& place) const {
    const double unworn = unworn_bound_ratio(place, place.distance);
    if (!is_worn(place)) return history_.wear * unworn;
    return history_.wear * std::min(unworn, unworn_bound_ratio(place, furthest(place.side)));
}

double CyclicRoughness::next_knot(const Place& place, bool dilating) const {
    double nearest = place.away ? std::numeric_limits<double>::infinity() : 0;
    const auto offer = [&](double distance) {
        if (place.away && distance > place.distance) nearest = std::min(nearest, distance);
        if (!place.away && distance < place.distance) nearest = std::max(nearest, distance);
    };
    const auto offer_all = [&](const RoughnessTable& table) {
        for (const RoughnessTable::Entry& entry : table.entries) {
            const double distance = entry.x * law_.peak_displacement;
            offer(distance);
            if (distance > place.distance) return;  // the other entries are farther out
        }
    };
    const RoughnessTable& bounding = bound_table(place);
    offer_all(bounding);
    if (dilating && &roughness_table(place) != &bounding) offer_all(roughness_table(place));
    if (history_.cycle == 1) offer(law_.peak_displacement);
    if (place.away) offer(furthest(place.side));
    return nearest;
}

}  // namespace rockslope::dda
