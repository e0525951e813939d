#include "dda/joint/cyclic_closed_form.hpp"

#include <algorithm>
#include <cmath>

#include "dda/joint/cyclic_history.hpp"

namespace rockslope::dda {

namespace {

/// Relative distance that a force or a slip must keep from the value at which the joint's state changes.
constexpr double margin = 1e-9;

/// The end of a displacement on one linear stretch of the tables.
struct Stretch {
    int direction;               ///< of the displacement
    CyclicRoughness::Place end;  ///< of the displacement
    double bound;                ///< strength against further motion in this direction, N per metre
    double bound_back;           ///< strength against motion in the other direction, N per metre
    double excess;               ///< spring force minus `bound`, in this direction, N per metre
};

/// Nothing where the state of the joint may change during the displacement.
std::optional<Stretch> closed_form_of(const CyclicBartonBandis& law,
                                      const CyclicBartonBandis::History& history, double normal_force,
                                      double length, const ShearTrial& trial) {
    if (law.asymmetric || history.crossed != 0) return std::nullopt;
    const CyclicRoughness at(law, history);
    const int direction = trial.displacement < 0 ? -1 : 1;
    if (history.position == 0 && direction * trial.shear_force < 0) return std::nullopt;
    const double displacement = std::abs(trial.displacement);
    const CyclicRoughness::Place start = at.place(history.position, direction);
    const double distance = start.away ? start.distance + displacement : start.distance - displacement;
    const double knot = at.next_knot(start, false);
    if (start.away ? !(distance < knot) : !(distance > knot)) return std::nullopt;

    const double roughness = law.barton.roughness_angle(normal_force, law.stressed_length(length));
    const auto angle = [&](double ratio) { return law.barton.free_angle(roughness, ratio); };
    const auto tangent = [&](double ratio) { return std::tan(law.barton.total_angle(roughness, ratio)); };
    const CyclicRoughness::Place end = {distance, start.side, start.away};
    const CyclicRoughness::Place back = {distance, start.side, !start.away};
    const double ratio_ahead = at.bound_ratio(end), ratio_back = at.bound_ratio(back);
    const double before = angle(at.bound_ratio(start)), ahead = angle(ratio_ahead);
    const double ahead_tangent = tangent(ratio_ahead);
    const double bound = normal_force * ahead_tangent;
    const double bound_back =
        normal_force * (angle(ratio_back) == ahead ? ahead_tangent : tangent(ratio_back));

    // If the bound grows more slowly than the spring's force, that force reaches the bound at most once.
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
    if (-end_force > bound_back) return std::nullopt;  // the bound has fallen below the force
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
    set_stage(end, sliding, after);
    if (sliding) count_slip(law, stretch->direction, stretch->excess / trial.stiffness, after);
    move_to(law, end, stretch->direction, end.distance, after);
    set_ratios(CyclicRoughness(law, after), end, after);
    return after;
}

}  // namespace rockslope::dda
