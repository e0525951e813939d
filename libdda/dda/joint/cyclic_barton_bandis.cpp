#include "dda/joint/cyclic_barton_bandis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dda/joint/cyclic_closed_form.hpp"
#include "dda/joint/cyclic_shear_path.hpp"
#include "dda/joint/locked_slope.hpp"
#include "dda/joint/mated.hpp"
#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

namespace {

/// Adds an entry at the origin to a table that has none: there the backward advance starts with the ratio of
/// the forward return. Without it the ratio of the first entry holds down to the origin.
RoughnessTable with_continuous_start(RoughnessTable backward_advance, const RoughnessTable& forward_return) {
    if (backward_advance.entries.front().x > 0)
        backward_advance.entries.insert(backward_advance.entries.begin(), {0, forward_return.ratio(0)});
    return backward_advance;
}

void read_cycles(const ParameterTable& table, CyclicBartonBandis& law) {
    const bool continuous = table.choice("bridge", {"continuous", "clamp"}) == "continuous";
    for (const std::unique_ptr<ParameterTable>& cycle : table.array_of_tables("cycle")) {
        CyclicBartonBandis::Cycle tables;
        tables.forward_advance = RoughnessTable::read(*cycle, "forward_advance");
        tables.forward_return = RoughnessTable::read(*cycle, "forward_return");
        tables.backward_advance = RoughnessTable::read(*cycle, "backward_advance");
        if (continuous)
            tables.backward_advance =
                with_continuous_start(std::move(tables.backward_advance), tables.forward_return);
        tables.backward_return = RoughnessTable::read(*cycle, "backward_return");
        law.cycles.push_back(std::move(tables));
    }
    if (law.cycles.empty())
        table.fail("cycle", "there is neither 'cycle' nor 'wear' in [" + table.path() + "]",
                   "an array of tables [[" + table.path() + ".cycle]], or 'wear'");
    law.further_cycle_factor = table.reduction_factor("further_cycle_factor");
    law.heal = table.boolean("heal", false);
}

/// Reads one table for all branches. Its ratios are magnitudes and resist motion in both directions.
void read_wear(const ParameterTable& table, CyclicBartonBandis& law) {
    RoughnessTable wear = RoughnessTable::read(table, "wear");
    for (RoughnessTable::Entry& entry : wear.entries) entry.ratio = std::abs(entry.ratio);
    law.cycles = {{wear, wear, wear, wear}};
    law.unsigned_ratios = true;
    law.asymmetric = table.boolean("asymmetric", false);
    law.heal = table.boolean("heal", false);
}

}  // namespace

CyclicBartonBandis CyclicBartonBandis::read(const ParameterTable& table) {
    CyclicBartonBandis law;
    law.barton = BartonStrength::read(table);
    law.peak_displacement = table.positive("peak_displacement", Quantity::length);
    if (table.has("wear"))
        read_wear(table, law);
    else
        read_cycles(table, law);
    law.reversal_factor = table.reduction_factor("reversal_factor");
    law.min_slip = table.not_negative("min_slip", Quantity::length, law.min_slip);
    law.damage = read_damage(table);
    law.floor_dilation = table.boolean("floor_dilation", false);
    law.contact_length = table.not_negative("contact_length", Quantity::length, 0);
    return law;
}

Strength CyclicBartonBandis::strength(const History& history, double normal_force, double length,
                                      const ShearTrial& trial) const {
    if (!(normal_force > 0)) return {};
    if (trial.stiffness > 0 && trial.displacement != 0) {
        if (const auto found = closed_form_strength(*this, history, normal_force, length, trial))
            return *found;
    }
    CyclicShearPath path(*this, history, normal_force, length,
                         {.stiffness = trial.stiffness, .force = trial.shear_force},
                         CyclicShearPath::Purpose::strength);
    if (trial.displacement == 0) return {path.bound(1), path.bound(-1), 0};
    if (trial.stiffness > 0)
        path.displace(trial.displacement);
    else
        path.prescribe_slip(trial.displacement, 0);
    Strength s = path.bounds_at_end();
    // A joint that slipped on the way has less than the strength at its end if the strength has jumped up.
    if (path.slipped()) {
        double& ahead = trial.displacement > 0 ? s.forward : s.backward;
        const double end_force = trial.displacement > 0 ? path.shear_force() : -path.shear_force();
        if (end_force >= 0 && end_force < ahead) ahead = end_force;
    }
    return s;
}

Strength CyclicBartonBandis::strength_slope(const History& history, double normal_force,
                                            double length) const {
    if (!(normal_force > 0)) return {};
    const CyclicShearPath path(*this, history, normal_force, length, {}, CyclicShearPath::Purpose::strength);
    const auto slope = [&](int direction) {
        const double ratio = path.bound_ratio(direction);
        if (!(asymmetric && history.forward != 0 && direction != history.forward))
            return barton.slope(normal_force, stressed_length(length), ratio);
        const double roughness = barton.roughness_angle(normal_force, stressed_length(length));
        const double angle = barton.residual_friction_angle - ratio * roughness;
        const double tangent = std::tan(std::abs(angle));
        if (roughness == 0) return tangent;
        const double turning = (angle < 0 ? 1 : -1) * ratio * barton.roughness_angle_log_slope();
        return tangent + turning * (1 + tangent * tangent);
    };
    return {slope(1), slope(-1), 0};
}

CyclicBartonBandis::History CyclicBartonBandis::advance(const History& history,
                                                        const ContactMotion& motion) const {
    History loaded = history;
    loaded.spring = history.spring.loaded(
        {motion.normal_force, motion.length, stressed_length(motion.length), motion.time.is_static()}, barton,
        peak_displacement);
    History moved = displaced(loaded, motion);
    if (moved.forward == 0 && moved.opened == 0 && moved.spring.stiffness != history.spring.stiffness &&
        motion.spring_of_law && motion.stiffness > 0) {
        // The new spring bears the same force at another displacement, Eq. (80).
        moved.position =
            (motion.shear_force + motion.stiffness * motion.displacement) / moved.spring.stiffness;
        moved.furthest_forward = std::abs(moved.position);
    }
    return moved;
}

CyclicBartonBandis::History CyclicBartonBandis::displaced(History loaded, const ContactMotion& motion) const {
    double force = motion.shear_force;
    if (const bool intact = loaded.forward == 0 && loaded.opened == 0;
        !intact && loaded.locked_slope != 0 && motion.normal_force > 0) {
        const double slope = loaded.locked_slope;
        loaded.locked_slope = slope_within(slope, strength(loaded, motion.normal_force, motion.length, {}),
                                           motion.normal_force);
        force += (loaded.locked_slope - slope) * motion.normal_force;
    }
    if (motion.stiffness > 0 && motion.displacement != 0) {
        if (const auto found = closed_form_history(*this, loaded, motion.normal_force, motion.length,
                                                   {motion.displacement, force, motion.stiffness}))
            return *found;
    }
    CyclicShearPath path(*this, loaded, motion.normal_force, motion.length,
                         {.stiffness = motion.stiffness, .force = force}, CyclicShearPath::Purpose::history);
    if (motion.stiffness > 0)
        path.displace(motion.displacement);
    else
        path.prescribe_slip(motion.displacement, motion.slip);
    return path.history();
}

CyclicBartonBandis::History CyclicBartonBandis::fly(const History& history,
                                                    const ContactMotion& motion) const {
    History after = history;
    if (motion.displacement != 0 && std::isfinite(motion.displacement)) {
        CyclicShearPath path(*this, history, 0, 0, {}, CyclicShearPath::Purpose::history);
        path.fly(motion.displacement);
        after = path.history();
    }
    if (history.spring.stiffness > 0 && !is_mated(after.position, peak_displacement)) after.opened = 1;
    after.spring.leave_rest();
    return after;
}

double CyclicBartonBandis::shear_stiffness(const History& history, double normal_force, double length) const {
    if (history.spring.stiffness > 0) return history.spring.stiffness_of_part(length);
    return barton.shear_strength(normal_force, stressed_length(length), 1) / peak_displacement;
}

LockedDilation CyclicBartonBandis::locked_dilation(const History& history) const {
    const bool intact = history.forward == 0 && history.opened == 0;
    return {history.locked_slope, intact ? history.spring.normal_force : 0};
}

JointRecord CyclicBartonBandis::record(const History& history) const {
    const bool counted = history.reversal_slip > 0;
    return {static_cast<JointStage>(history.stage),
            history.mobilised_ratio,
            history.dilation,
            history.reversals,
            history.cycle,
            {.amount = counted ? history.reversal_slip : history.reverse_slip,
             .least = reversal_factor < 1 ? min_slip : 0,
             .counted = counted}};
}

}  // namespace rockslope::dda
