#include "dda/joint/barton_bandis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dda/joint/linear_angle.hpp"
#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

/// phi_r + ratio * i, rad, before the limits.
double BartonBandis::angle(double distance, double roughness) const {
    const double friction = barton.residual_friction_angle;
    if (peak_displacement == 0) return friction + roughness;
    const double x = distance / peak_displacement;
    if (from_zero_angle && x < mobilisation.entries[1].x) {
        const auto& [zero, first] = std::pair(mobilisation.entries[0], mobilisation.entries[1]);
        return (friction + first.ratio * roughness) * ((x - zero.x) / (first.x - zero.x));
    }
    return barton.free_angle(roughness, mobilisation.ratio(x));
}

/// Calls `visit` for the parts of an outward displacement on which the total angle is linear.
template <class Visit>
void BartonBandis::visit_pieces(double from, double to, double roughness, Visit visit) const {
    while (from < to) {
        const double knot = peak_displacement == 0
                                ? std::numeric_limits<double>::infinity()
                                : mobilisation.next_above(from / peak_displacement) * peak_displacement;
        const double end = knot > from ? std::min(knot, to) : to;
        LinearAngle rest = {end - from, angle(from, roughness), angle(end, roughness)};
        while (rest.length > 0) {
            const LinearAngle part = clamp_leading_part(rest, 0, BartonStrength::largest_angle);
            visit(part);
            rest = {rest.length - part.length, rest.angle_at(part.length), rest.last};
        }
        from = end;
    }
}

double BartonBandis::strength_at(double furthest, double normal_force, double length) const {
    const double roughness = barton.roughness_angle(normal_force, length);
    return std::max(normal_force, 0.0) *
           std::tan(std::clamp(angle(furthest, roughness), 0.0, BartonStrength::largest_angle));
}

Strength BartonBandis::strength(const History& history, double normal_force, double length,
                                const ShearTrial& trial) const {
    const double displacement = std::abs(trial.displacement);
    const double sign = trial.displacement < 0 ? -1 : 1;
    const double end = sign * history.position + displacement;  // positive in its direction
    const double furthest = std::max(history.furthest, std::abs(end));
    const double at_end = strength_at(furthest, normal_force, length);
    if (!(normal_force > 0) || furthest == history.furthest || trial.stiffness == 0)
        return {at_end, at_end, 0};
    const double inside = std::max(history.furthest - sign * history.position, 0.0);
    const double roughness = barton.roughness_angle(normal_force, length);
    double remaining = displacement - inside;
    double end_force = at_end;
    visit_pieces(history.furthest, furthest, roughness, [&](const LinearAngle& piece) {
        end_force = std::min(end_force, end_force_bound(piece, normal_force, trial.stiffness, remaining));
        remaining -= piece.length;
    });
    return trial.displacement > 0 ? Strength{end_force, at_end, 0} : Strength{at_end, end_force, 0};
}

Strength BartonBandis::strength_slope(const History& history, double normal_force, double length) const {
    if (!(normal_force > 0)) return {};
    const double roughness = barton.roughness_angle(normal_force, length);
    const double free_angle = angle(history.furthest, roughness);
    const double tangent = std::tan(std::clamp(free_angle, 0.0, BartonStrength::largest_angle));
    if (free_angle < 0 || free_angle > BartonStrength::largest_angle || roughness == 0)
        return {tangent, tangent, 0};
    // The angle is linear in i, and N di/dN = -JRC / ln 10.
    const double per_roughness = angle(history.furthest, 1) - angle(history.furthest, 0);
    const double slope =
        tangent + per_roughness * barton.roughness_angle_log_slope() * (1 + tangent * tangent);
    return {slope, slope, 0};
}

BartonBandis::History BartonBandis::advance(const History& history, const ContactMotion& motion) const {
    if (!(motion.normal_force > 0)) return history;
    History after = history;
    after.spring = history.spring.loaded(
        {motion.normal_force, motion.length, motion.length, motion.duration == 0}, barton, peak_displacement);
    if (motion.displacement == 0) return after;
    after.position += motion.displacement;
    after.furthest = std::max(history.furthest, std::abs(after.position));
    const double roughness = barton.roughness_angle(motion.normal_force, motion.length);
    const double friction = barton.residual_friction_angle;
    if (roughness > 0) after.ratio = (angle(after.furthest, roughness) - friction) / roughness;
    if (damage == 0) return after;
    visit_pieces(history.furthest, after.furthest, roughness, [&](const LinearAngle& piece) {
        // The dilation angle, Eq. (60).
        const LinearAngle dilating = {piece.length, (piece.first - friction) / damage,
                                      (piece.last - friction) / damage};
        LinearAngle rest = dilating;
        while (rest.length > 0) {  // no dilation while friction itself is still being mobilised
            const LinearAngle part = clamp_leading_part(rest, 0, BartonStrength::largest_angle);
            after.dilation += part.length * mean_tangent(part.first, part.last);
            rest = {rest.length - part.length, rest.angle_at(part.length), rest.last};
        }
    });
    return after;
}

double BartonBandis::shear_stiffness(const History& history, double normal_force, double length) const {
    if (history.spring.stiffness > 0 || peak_displacement == 0)
        return history.spring.stiffness_of_part(length);
    return barton.shear_strength(normal_force, length, 1) / peak_displacement;
}

BartonBandis BartonBandis::read(const ParameterTable& table) {
    BartonBandis law;
    law.barton = BartonStrength::read(table);
    law.damage = read_damage(table);
    if (!table.has("peak_displacement")) return law;
    law.peak_displacement = table.positive("peak_displacement", Quantity::length);
    law.from_zero_angle = !table.has("mobilisation") || table.is_string("mobilisation");
    if (law.from_zero_angle) {
        table.choice("mobilisation", {"barton-1985"});
        law.mobilisation = barton_1985();
    } else {
        law.mobilisation = RoughnessTable::read(table, "mobilisation");
    }
    return law;
}

JointRecord BartonBandis::record(const History& history) const {
    return {history.furthest > 0 ? JointStage::forward_advance : JointStage::none, history.ratio,
            history.dilation, 0, history.furthest > 0 ? 1 : 0};
}

}  // namespace rockslope::dda
