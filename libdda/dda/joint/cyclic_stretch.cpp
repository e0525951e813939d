#include "dda/joint/cyclic_stretch.hpp"

#include <algorithm>
#include <cmath>

#include "dda/joint/cyclic_roughness.hpp"

namespace dda {

namespace {

/// Shares by which a force or a slip keeps away from where the joint changes.
constexpr double margin = 1e-9;

}  // namespace

std::optional<Strength> strength_on_stretch(const CyclicBartonBandis& law,
                                            const CyclicBartonBandis::History& history, double normal_force,
                                            double length, const ShearTrial& trial) {
    if (law.asymmetric) return std::nullopt;
    const CyclicRoughness at(law, history);
    const int direction = trial.displacement < 0 ? -1 : 1;
    const double way = std::abs(trial.displacement);
    const CyclicRoughness::Place start = at.place(history.position, direction);
    const double distance = start.away ? start.distance + way : start.distance - way;
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
    const double climb = trial.stiffness * way;
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
    const double arriving = std::min(excess, 0.0) + bound;
    if (-arriving > bound_back) return std::nullopt;  // a bound that has come down on the force
    if (direction > 0) return Strength{bound, bound_back, 0};
    return Strength{bound_back, bound, 0};
}

}  // namespace dda
