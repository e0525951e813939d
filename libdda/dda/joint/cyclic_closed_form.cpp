#include "dda/joint/cyclic_closed_form.hpp"

#include <algorithm>
#include <cmath>

#include "dda/joint/cyclic_roughness.hpp"

namespace rockslope::dda {

namespace {

/// Shares by which a force or a slip keeps away from where the joint changes.
constexpr double margin = 1e-9;

/// A displacement on one stretch of the tables, as it ends.
struct Stretch {
    int direction;               ///< of the displacement
    CyclicRoughness::Place end;  ///< where it ends
    double bound;                ///< against going on, N per metre
    double bound_back;           ///< against going back
    double excess;               ///< of the spring's force over the bound, in its direction
};

/// Nothing where more changes on the displacement than can be told beforehand.
std::optional<Stretch> closed_form_of(const CyclicBartonBandis& law,
                                      const CyclicBartonBandis::History& history, double normal_force,
                                      double length, const ShearTrial& trial) {
    if (law.asymmetric) return std::nullopt;
    const CyclicRoughness at(law, history);
    const int direction = trial.displacement < 0 ? -1 : 1;
    const double displacement = std::abs(trial.displacement);
    const CyclicRoughness::Place start = at.place(history.position, direction);
    const double distance = start.away ? start.distance + displacement : start.distance - displacement;
    const double knot = at.next_knot(start, false);
    if (start.away ? !(distance < knot) : !(distance > knot)) return std::nullopt;

    const double roughness = law.barton.roughness_angle(normal_force, law.stressed_length(length));
    const auto angle = [&](double ratio) { return law.barton.residual_friction_angle + ratio * roughness; };
    const auto tangent = [](double angle_) {
        return std::tan(std::clamp(angle_, 0.0, BartonStrength::largest_angle));
    };
    const CyclicRoughness::Place end = {distance, start.side, start.away};
    const CyclicRoughness::Place back = {distance, start.side, !start.away};
    const double before = angle(at.bound_ratio(start));
    const double ahead = angle(at.bound_ratio(end)), behind = angle(at.bound_ratio(back));
    const double ahead_tangent = tangent(ahead);
    const double bound = normal_force * ahead_tangent;
    const double bound_back = normal_force * (behind == ahead ? ahead_tangent : tangent(behind));

    // Where the bound grows less than the spring's force, all along, that force meets it once at most.
    const double climb = trial.stiffness * displacement;
    const double growth = normal_force * (ahead - before) * (1 + ahead_tangent * ahead_tangent);
    if (ahead > before && (at.is_worn(start) || !(growth < (1 - margin) * climb))) return std::nullopt;
    const double excess = direction * trial.shear_force + climb - bound;
    if (excess > -margin * bound) {
        const double slip = excess / trial.stiffness;
        if (at.is_fresh()) return std::nullopt;
        if (history.slip_direction == -direction &&
            !(history.reverse_slip + slip < (1 - margin) * law.min_slip))
            return std::nullopt;
    }
    const double end_force = std::min(excess, 0.0) + bound;
    if (-end_force > bound_back) return std::nullopt;  // a bound that has come down on the force
    return Stretch{direction, end, bound, bound_back, excess};
}

}  // namespace

std::optional<Strength> closed_form_strength(const CyclicBartonBandis& law,
                                             const CyclicBartonBandis::History& history, double normal_force,
                                             double length, const ShearTrial& trial) {
    const std::optional<Stretch> stretch = closed_form_of(law, history, normal_force, length, trial);
    if (!stretch) return std::nullopt;
    if (stretch->direction > 0) return Strength{stretch->bound, stretch->bound_back, 0};
    return Strength{stretch->bound_back, stretch->bound, 0};
}

std::optional<CyclicBartonBandis::History> closed_form_history(const CyclicBartonBandis& law,
                                                               const CyclicBartonBandis::History& history,
                                                               double normal_force, double length,
                                                               const ShearTrial& trial) {
    if (law.damage != 0) return std::nullopt;
    const std::optional<Stretch> stretch = closed_form_of(law, history, normal_force, length, trial);
    if (!stretch || std::abs(stretch->excess) <= margin * stretch->bound) return std::nullopt;
    const bool sliding = stretch->excess > 0;
    const CyclicRoughness::Place& end = stretch->end;
    CyclicBartonBandis::History after = history;
    after.position += trial.displacement;
    after.sliding = sliding ? 1 : 0;
    after.stage = static_cast<std::int32_t>(CyclicRoughness::stage(end, sliding));
    if (sliding) {
        if (after.slip_direction == 0) after.slip_direction = stretch->direction;
        const bool same = after.slip_direction == stretch->direction;
        after.reverse_slip = same ? 0 : after.reverse_slip + stretch->excess / trial.stiffness;
    }
    const CyclicRoughness at(law, after);
    if (end.away) {
        double& reached = end.side > 0 ? after.furthest_forward : after.furthest_backward;
        reached = std::max(reached, end.distance);
        after.unloading_ratio = at.advance_ratio(end);
    }
    after.mobilised_ratio = at.mobilised_ratio(end, sliding, after.unloading_ratio);
    return after;
}

}  // namespace rockslope::dda
