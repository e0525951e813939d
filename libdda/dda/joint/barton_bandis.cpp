#include "dda/joint/barton_bandis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dda/joint/linear_angle.hpp"
#include "dda/joint/locked_slope.hpp"
#include "dda/joint/mated.hpp"
#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

namespace {

/// Slip over the peak displacement that is rounding: up to it a joint has not slipped.
constexpr double slip_rounding = 1e-6;

}  // namespace

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
    const double before = outline(history), furthest = std::max(before, std::abs(end));
    const double at_end = strength_at(furthest, normal_force, length);
    if (!(normal_force > 0) || furthest == before || trial.stiffness == 0) return {at_end, at_end, 0};
    const double inside = std::max(before - sign * history.position, 0.0);
    const double roughness = barton.roughness_angle(normal_force, length);
    double remaining = displacement - inside;
    double end_force = at_end;
    visit_pieces(before, furthest, roughness, [&](const LinearAngle& piece) {
        end_force = std::min(end_force, end_force_bound(piece, normal_force, trial.stiffness, remaining));
        remaining -= piece.length;
    });
    return trial.displacement > 0 ? Strength{end_force, at_end, 0} : Strength{at_end, end_force, 0};
}

Strength BartonBandis::strength_slope(const History& history, double normal_force, double length) const {
    if (!(normal_force > 0)) return {};
    const double furthest = outline(history);
    const double roughness = barton.roughness_angle(normal_force, length);
    const double free_angle = angle(furthest, roughness);
    const double tangent = std::tan(std::clamp(free_angle, 0.0, BartonStrength::largest_angle));
    if (free_angle < 0 || free_angle > BartonStrength::largest_angle || roughness == 0)
        return {tangent, tangent, 0};
    // The angle is linear in i, and N di/dN = -JRC / ln 10.
    const double per_roughness = angle(furthest, 1) - angle(furthest, 0);
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

bool BartonBandis::is_fresh(const History& history) const {
    return history.slipped <= slip_rounding * peak_displacement;
}

double BartonBandis::fresh_dilation(double distance, double roughness) const {
    return dilation_between(0, distance, roughness, largest_climb(roughness));
}

double BartonBandis::fresh_rate(double distance, double roughness) const {
    return std::min(dilation_rate(distance, roughness), largest_climb(roughness) * distance);
}

/// The largest rate of a fresh joint over its distance, Eq. (79), 1/m.
double BartonBandis::largest_climb(double roughness) const {
    return std::tan(barton.total_angle(roughness, 1)) / peak_displacement;
}

BartonBandis::History BartonBandis::advance(const History& history, const ContactMotion& motion) const {
    History after = history;
    after.spring =
        history.spring.loaded({motion.normal_force, motion.length, motion.length, motion.time.is_static()},
                              barton, peak_displacement);
    after.locked_slope = slope_under(history, motion.normal_force, motion.length);
    if (motion.displacement == 0) return after;
    after.position += motion.displacement;
    after.furthest = std::max(outline(history), std::abs(after.position));
    // The strength is zero at the origin: there a joint slips when it is first loaded.
    if (!is_mated(after.furthest, peak_displacement)) after.slipped += std::abs(motion.slip);
    const double roughness = barton.roughness_angle(motion.normal_force, motion.length);
    if (roughness > 0)
        after.ratio = (angle(after.furthest, roughness) - barton.residual_friction_angle) / roughness;
    if (damage > 0) dilate(history, motion, after);
    return after;
}

/// Adds the dilation of a motion under a normal force to the history after it.
void BartonBandis::dilate(const History& history, const ContactMotion& motion, History& after) const {
    const double outward = after.furthest - outline(history);
    const double inward = std::abs(motion.displacement) - outward;
    const int side = after.position > 0 ? 1 : after.position < 0 ? -1 : 0;
    if (peak_displacement == 0) {  // only slip dilates
        const double roughness = barton.roughness_angle(motion.normal_force, motion.length);
        const double slip = std::clamp(std::abs(motion.slip) - inward, 0.0, outward);
        after.dilation += slip * dilation_rate(after.furthest, roughness);
        return;
    }
    const double rough = reference_roughness(after);
    const double rate = dilation_rate(after.furthest, rough);
    if (is_fresh(history)) {
        // The joint dilates and contracts on one curve.
        after.dilation += fresh_dilation(std::abs(after.position), rough) -
                          fresh_dilation(std::abs(history.position), rough);
        after.locked_slope = side * fresh_rate(std::abs(after.position), rough);
        if (!is_fresh(after) && outward > 0) after.locked_slope = side * rate;
        return;
    }
    // Slip against the displacement is what the spring has shortened by where the strength has fallen: the
    // walls move as those of a locked joint.
    const double locked_slope = after.locked_slope;
    if (motion.slip == 0 || (motion.slip < 0) != (motion.displacement < 0)) {
        after.dilation += locked_slope * motion.displacement;
        return;
    }
    // The locked joint dilates and contracts with its slope, and slip dilates it outside the largest
    // distance. There the spring follows the strength. A strength that has fallen leaves the spring an
    // excess, which goes as slip: it is no locked motion backwards.
    const double sign = motion.displacement < 0 ? -1 : 1;
    const auto locked_distance = [&](double slides_from) {
        const double elastic = sign * (motion.displacement - motion.slip);
        if (!(motion.stiffness > 0)) return std::max(elastic, 0.0);
        const double softening = (strength_at(after.furthest, motion.normal_force, motion.length) -
                                  strength_at(slides_from, motion.normal_force, motion.length)) /
                                 motion.stiffness;
        return std::max(elastic - softening, 0.0);
    };
    double slides_from = outline(history), locked = locked_distance(slides_from);
    if (locked > inward) {
        slides_from = std::min(outline(history) + locked - inward, after.furthest);
        locked = locked_distance(slides_from);
    }
    // No steeper than the strength can climb: the stress at a corner may be far above the reference.
    const double steepest =
        strength_at(after.furthest, motion.normal_force, motion.length) / motion.normal_force;
    const double climbed =
        dilation_between(slides_from, after.furthest, rough, std::numeric_limits<double>::infinity());
    after.dilation +=
        std::min(climbed, steepest * (after.furthest - slides_from)) + sign * locked * locked_slope;
    if (outward > 0) {
        const double rise = (strength_at(after.furthest, motion.normal_force, motion.length) -
                             strength_at(slides_from, motion.normal_force, motion.length)) /
                            motion.normal_force;
        after.locked_slope =
            slope_paid_by_slip(side * std::min(rate, steepest), locked_slope, side,
                               {motion.normal_force, motion.stiffness, after.furthest - slides_from, rise});
    }
}

double BartonBandis::slope_under(const History& history, double normal_force, double length) const {
    if (history.locked_slope == 0 || is_fresh(history)) return history.locked_slope;
    const double strength = strength_at(outline(history), normal_force, length);
    return slope_within(history.locked_slope, {strength, strength, 0}, normal_force);
}

double BartonBandis::reference_roughness(const History& history) const {
    return history.spring.normal_stress > 0 ? barton.roughness_angle(history.spring.normal_stress, 1) : 0;
}

BartonBandis::History BartonBandis::fly(const History& history, const ContactMotion& motion) const {
    History after = history;
    after.spring.leave_rest();
    after.position += motion.displacement;
    // The spring is released: what it had lengthened is slip.
    if (history.spring.stiffness > 0 && !is_mated(after.position, peak_displacement))
        after.slipped = std::max(history.slipped, peak_displacement);
    if (damage == 0 || !std::isfinite(after.position)) return after;
    // Between where the joint has worn and where it flies to, on either side, the walls part and meet.
    const double rough = reference_roughness(after);
    const auto height = [&](double position) {
        return dilation_between(history.furthest, std::max(std::abs(position), history.furthest), rough,
                                std::numeric_limits<double>::infinity());
    };
    const double lowest = std::min(history.dilation, 0.0);
    const bool crosses = history.position * after.position < 0;
    const double at_origin = std::max(history.dilation - (crosses ? height(history.position) : 0), lowest);
    after.dilation = std::max(at_origin + height(after.position) - (crosses ? 0 : height(history.position)),
                              std::min(at_origin, 0.0));
    // Inside its largest distance the worn joint is even: there a joint that lands leans on no slope.
    const int side = after.position > 0 ? 1 : after.position < 0 ? -1 : 0;
    const double distance = std::abs(after.position);
    after.locked_slope = distance > history.furthest ? side * dilation_rate(distance, rough) : 0;
    return after;
}

LockedDilation BartonBandis::locked_dilation(const History& history) const {
    return {history.locked_slope,
            peak_displacement > 0 && is_fresh(history) ? history.spring.normal_force : 0};
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
