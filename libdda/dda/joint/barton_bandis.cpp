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

double BartonBandis::dilation_rate(double distance, double roughness) const {
    const double total = std::clamp(angle(distance, roughness), 0.0, BartonStrength::largest_angle);
    return std::tan(std::max((total - barton.residual_friction_angle) / damage, 0.0));
}

double BartonBandis::dilation_between(double from, double to, double roughness, double climb) const {
    const double friction = barton.residual_friction_angle;
    const bool limited = climb < std::numeric_limits<double>::infinity();
    double sum = 0, start = from;
    visit_pieces(from, to, roughness, [&](const LinearAngle& piece) {
        // The dilation angle, Eq. (60).
        LinearAngle rest = {piece.length, (piece.first - friction) / damage,
                            (piece.last - friction) / damage};
        while (rest.length > 0) {  // no dilation while friction itself is still being mobilised
            const LinearAngle part = clamp_leading_part(rest, 0, BartonStrength::largest_angle);
            sum += limited ? dilation_before_slip(part, start, climb)
                           : part.length * mean_tangent(part.first, part.last);
            start += part.length;
            rest = {rest.length - part.length, rest.angle_at(part.length), rest.last};
        }
    });
    return sum;
}

BartonBandis::History BartonBandis::advance(const History& history, const ContactMotion& motion) const {
    if (!(motion.normal_force > 0)) return history;
    History after = history;
    after.spring = history.spring.loaded(
        {motion.normal_force, motion.length, motion.length, motion.duration == 0}, barton, peak_displacement);
    if (motion.displacement == 0) return after;
    after.position += motion.displacement;
    after.furthest = std::max(history.furthest, std::abs(after.position));
    if (motion.slip != 0) after.slipped = 1;
    const double roughness = barton.roughness_angle(motion.normal_force, motion.length);
    if (roughness > 0)
        after.ratio = (angle(after.furthest, roughness) - barton.residual_friction_angle) / roughness;
    if (damage == 0) return after;
    const double outward = after.furthest - history.furthest;
    const double inward = std::abs(motion.displacement) - outward;
    const int side = after.position > 0 ? 1 : after.position < 0 ? -1 : 0;
    if (!(after.spring.normal_stress > 0)) {  // without a peak displacement only slip dilates
        const double slip = std::clamp(std::abs(motion.slip) - inward, 0.0, outward);
        after.dilation += slip * dilation_rate(after.furthest, roughness);
        return after;
    }
    const double rough = barton.roughness_angle(after.spring.normal_stress, 1);
    const double rate = dilation_rate(after.furthest, rough);
    if (history.slipped == 0) {
        // The joint dilates and contracts on one curve.
        const double climb = std::tan(barton.total_angle(rough, 1)) / peak_displacement;
        after.dilation += dilation_between(0, std::abs(after.position), rough, climb) -
                          dilation_between(0, std::abs(history.position), rough, climb);
        after.locked_slope =
            side * std::min(dilation_rate(std::abs(after.position), rough), climb * std::abs(after.position));
        if (after.slipped != 0 && outward > 0) after.locked_slope = side * rate;
        return after;
    }
    if (motion.slip == 0) {
        after.dilation += history.locked_slope * motion.displacement;
        return after;
    }
    // The locked joint dilates and contracts with its slope, and slip dilates it outside the largest
    // distance. There the spring follows the strength.
    const double sign = motion.displacement < 0 ? -1 : 1;
    const auto locked_distance = [&](double slides_from) {
        const double elastic = sign * (motion.displacement - motion.slip);
        if (!(motion.stiffness > 0)) return elastic;
        return elastic - (strength_at(after.furthest, motion.normal_force, motion.length) -
                          strength_at(slides_from, motion.normal_force, motion.length)) /
                             motion.stiffness;
    };
    double slides_from = history.furthest, locked = locked_distance(slides_from);
    if (locked > inward) {
        slides_from = std::min(history.furthest + locked - inward, after.furthest);
        locked = locked_distance(slides_from);
    }
    after.dilation +=
        dilation_between(slides_from, after.furthest, rough, std::numeric_limits<double>::infinity()) +
        sign * locked * history.locked_slope;
    if (outward > 0) after.locked_slope = side * rate;
    return after;
}

LockedDilation BartonBandis::locked_dilation(const History& history) const {
    return {history.locked_slope,
            history.slipped == 0 ? history.spring.normal_force(history.spring.length) : 0};
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
