#include "dda/trial/joint_dilation.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

namespace {

/// Largest error of a normal force by dilation at the end of a step, over the force tolerance. The remaining
/// dilation acts in the next step.
constexpr double dilation_tolerance = 10;

/// The share of an opening, left from the step before, that a dynamic step releases even where friction does
/// not pay for it. With all of it a block may land on its opening at once and gain its work; with none of it
/// slopes do not come to rest.
constexpr double released_share = 0.5;

/// Displacement over that of the step with which the slope of the dilation along further slip is found, and
/// its least value, m.
constexpr double slope_increment = 1e-3, least_slope_increment = 1e-9;
/// Largest number of evaluations of the law with which the dilation under its own normal force is found.
constexpr int dilation_evaluations = 40;
/// Increase of the normal force, over the normal or the elastic shear force, with which the change of the
/// dilation with the normal force is found.
constexpr double force_increment = 1e-4;
/// Largest response of a dilation to its corrections. With 200 a joint may follow so slowly that 12 mm are
/// left to the next step.
constexpr double largest_response = 5;

/// The derivative of the dilation along further slip. @param total dilation after `combined`, m.
double slope_of_further_slip(const JointLaw& law, const SegmentMotion& combined, double total) {
    ContactMotion more = combined.motion;
    const double further = std::copysign(
        std::max(slope_increment * std::abs(more.displacement), least_slope_increment), more.slip);
    more.displacement += further;
    more.slip += further;
    return (dilation(law, advance(law, *combined.history, more)) - total) / further;
}

/// The derivative of the dilation by the normal force at a held displacement, Eq. (85), m per N per metre. A
/// dilation that grows with the normal force has no solution where the normal springs are stiff: then it is
/// 0.
double slope_by_normal_force(const JointLaw& law, const SegmentMotion& combined, double total) {
    ContactMotion more = combined.motion;
    const double elastic_force = std::abs(more.shear_force + more.stiffness * more.displacement);
    const double increase = force_increment * std::max(more.normal_force, elastic_force);
    if (!(increase > 0)) return 0;
    more.normal_force += increase;
    return std::min((dilation(law, advance(law, *combined.history, more)) - total) / increase, 0.0);
}

}  // namespace

/// Eq. (104).
double DilationCorrection::response(double excess_now) const {
    if (correction == 0) return 1;
    return std::clamp((excess - excess_now) / correction, 1.0, largest_response);
}

JointDilation::JointDilation(const StepProblem& problem, TrialContacts& trials)
    : p_(problem),
      trials_(trials),
      any_(std::any_of(p_.model.joint_materials.begin(), p_.model.joint_materials.end(),
                       [](const JointMaterial& material) { return dilates(material.law); })) {}

template <class Visit>
void JointDilation::visit_segments(const Visit& visit) const {
    if (!any_) return;
    for (std::size_t segment = 0; segment < p_.segments.count(); ++segment) {
        const auto members = p_.segments.contacts_of(segment);
        const JointLaw& law = trials_.law_of(members[0]);
        if (!dilates(law)) continue;
        visit(segment, law, members,
              segment_motion(members, p_.contacts, [&](ContactIndex k) { return trials_.motion(k); }));
    }
}

void JointDilation::update() {
    by_force_.clear();
    if (any_) corrections_.resize(p_.segments.count());
    visit_segments([&](std::size_t segment, const JointLaw& law, std::span<const ContactIndex> members,
                       SegmentMotion combined) {
        const auto leading = std::find_if(members.begin(), members.end(),
                                          [&](ContactIndex k) { return !trials_[k].postponed; });
        if (leading == members.end()) return;
        const bool with_slip = dilates_with_slip(law) && !trials_[members[0]].postponed;
        if (with_slip) combined = find_under_own_force(law, members, combined);
        const JointHistory after = advance(law, *combined.history, combined.motion);
        const double total = dilation(law, after);
        const bool slides = combined.motion.slip != 0;
        const double slope = slides ? slope_of_further_slip(law, combined, total) : 0;
        if (slides && with_slip) {
            const double by_force = slope_by_normal_force(law, combined, total);
            if (by_force < 0) by_force_.push_back({members, by_force, combined.motion.normal_force, 0});
        }
        const double excess = total - p_.contacts[*leading].dilation - trials_[*leading].dilation_increment;
        const double response = with_slip ? 1 : corrections_[segment].response(excess);
        corrections_[segment] = {excess, excess / response};
        const double kept = excess - corrections_[segment].correction;
        for (const ContactIndex k : members) {
            ContactTrial& trial = trials_[k];
            if (trial.postponed) continue;
            trial.dilation_increment = total - p_.contacts[k].dilation - kept;
            if (p_.model.is_augmented(p_.contacts[k].joint_material)) continue;
            trial.dilating =
                after_displacement(locked_dilation(law, p_.contacts[k].history), locked_dilation(law, after));
            trial.sliding_slope = slides ? slope : trial.dilating.slope;
        }
    });
}

SegmentMotion JointDilation::find_under_own_force(const JointLaw& law, std::span<const ContactIndex> members,
                                                  const SegmentMotion& present) {
    SegmentMotion combined = present;
    double stiffness = 0;
    for (const ContactIndex k : members) stiffness += p_.springs[k].normal_stiffness;
    // What the law gives under the normal force of a dilation, less that dilation, m.
    const auto excess = [&](double total) {
        for (const ContactIndex k : members) trials_[k].dilation_increment = total - p_.contacts[k].dilation;
        combined = segment_motion(members, p_.contacts, [&](ContactIndex k) { return trials_.motion(k); });
        return dilation(law, advance(law, *combined.history, combined.motion)) - total;
    };
    const double tolerated = stiffness > 0 ? trials_.tolerance() / stiffness : 0;
    double low = p_.contacts[members[0]].dilation + trials_[members[0]].dilation_increment;
    double at_low = excess(low);
    if (std::abs(at_low) <= tolerated) return combined;
    double high = low + at_low, at_high = excess(high);
    // Illinois' method. Without a change of sign the dilation grows with its normal force.
    for (int k = 0; k < dilation_evaluations && at_low * at_high < 0; ++k) {
        const double middle = high - at_high * (high - low) / (at_high - at_low);
        const double at_middle = excess(middle);
        if (std::abs(at_middle) <= tolerated) break;
        if (at_middle * at_high < 0) {
            low = high;
            at_low = at_high;
        } else {
            at_low /= 2;
        }
        high = middle;
        at_high = at_middle;
    }
    return combined;
}

template <class Visit>
void JointDilation::visit_by_law(const Visit& visit) const {
    visit_segments([&](std::size_t, const JointLaw& law, std::span<const ContactIndex> members,
                       const SegmentMotion& combined) {
        const double total = dilation(law, advance(law, *combined.history, combined.motion));
        for (const ContactIndex k : members) visit(k, total - p_.contacts[k].dilation);
    });
}

bool JointDilation::exceeds_tolerance() const {
    bool any = false;
    visit_by_law([&](ContactIndex k, double by_law) {
        any = any || (!trials_[k].postponed && is_unsettled(k, by_law));
    });
    return any;
}

bool JointDilation::is_unsettled(ContactIndex k, double by_law) const {
    const ContactTrial& trial = trials_[k];
    if (!trial.may_close) return false;
    const double change = p_.springs[k].normal_stiffness * (by_law - trial.dilation_increment);
    const double normal = trials_.law(k).normal(trial.opening);
    const double changed = normal > 0 ? std::abs(change) : normal + change;
    return changed > dilation_tolerance * trials_.tolerance();
}

void JointDilation::set_change(std::size_t index, double change) {
    DilationByForce& dilation = by_force_[index];
    for (const ContactIndex k : dilation.contacts) trials_[k].dilation_increment += change - dilation.change;
    dilation.change = change;
}

double JointDilation::locked_dilation_of(ContactIndex k) const {
    const Contact& contact = p_.contacts[k];
    const ContactTrial& trial = trials_[k];
    const double elastic = trials_.elastic_displacement(k);
    const double slope =
        (locked_dilation(p_.model, contact.joint_material, contact.history).slope + trial.dilating.slope) / 2;
    const double left = left_dilation(p_.model, contact);
    const bool opens = left > 0 && !p_.time.is_static();
    return (opens ? released_share * left : left) + slope * elastic;
}

bool JointDilation::postpone() {
    bool any = false;
    visit_by_law([&](ContactIndex k, double by_law) {
        ContactTrial& trial = trials_[k];
        const double as_locked = locked_dilation_of(k);
        if (trial.postponed || !is_unsettled(k, by_law)) return;
        if (std::abs(by_law - trial.dilation_increment) <= std::abs(by_law - as_locked)) return;
        trial.dilation_increment = as_locked;
        trial.sliding_slope = 0;  // update_active_set() tilts the spring, and the matrix follows
        trial.postponed = true;
        any = true;
    });
    if (any) by_force_.clear();
    return any;
}

ShearedContact JointDilation::sheared_at_end(ContactIndex k) const {
    const Contact& contact = p_.contacts[k];
    const Forces forces = trials_.law_forces(k);
    return {forces.shear, forces.normal, contact.dilation + trials_[k].dilation_increment,
            contact.joint_share};
}

double JointDilation::dilating_loss(ContactIndex k, const LockedDilation& after) const {
    const Contact& contact = p_.contacts[k];
    const ContactTrial& trial = trials_[k];
    const Forces forces = trials_.law_forces(k);
    const double stiffness = p_.springs[k].shear_stiffness;
    const double elastic = trials_.elastic_displacement(k);
    const bool was_closed = contact.state != ContactState::open;
    const double before = was_closed ? shear_energy_before_slip(p_.model, contact, after, stiffness) : 0;
    const double stored = shear_energy(after, sheared_at_end(k), stiffness);
    return forces.shear * trial.shearing - forces.normal * trial.dilation_increment -
           stiffness * elastic * elastic / 2 - (stored - before);
}

bool JointDilation::limit() {
    bool any = false;
    visit_segments([&](std::size_t, const JointLaw& law, std::span<const ContactIndex> members,
                       const SegmentMotion& combined) {
        if (p_.model.is_augmented(p_.contacts[members[0]].joint_material)) return;
        const LockedDilation after = locked_dilation(law, advance(law, *combined.history, combined.motion));
        double loss = 0, normal = 0, moved = 0, excess = 0;
        SharedSpring at_start, at_end;
        for (const ContactIndex k : members) {
            const Forces forces = trials_.law_forces(k);
            const double stiffness = p_.springs[k].shear_stiffness;
            if (const Contact& contact = p_.contacts[k]; contact.state == ContactState::open)
                at_start.add_open(stiffness);
            else
                at_start.add(sheared(contact).spring_force(
                                 locked_dilation(p_.model, contact.joint_material, contact.history)),
                             stiffness);
            if (!trials_[k].may_close || !(forces.normal > 0)) {
                at_end.add_open(stiffness);
                continue;
            }
            const ContactTrial& trial = trials_[k];
            loss += dilating_loss(k, after);
            at_end.add(sheared_at_end(k).spring_force(after), stiffness);
            normal += forces.normal;
            excess += forces.normal * (trial.dilation_increment - locked_dilation_of(k));
            moved = std::max({moved, std::abs(trial.shearing), std::abs(trial.dilation_increment)});
        }
        // A locked joint only pays for what it dilates beyond its slope.
        loss = combined.motion.slip == 0 ? -excess : loss + at_end.uneven() - at_start.uneven();
        const double tolerated = p_.tolerated_gain + trials_.tolerance() * moved;
        if (!(normal > 0) || loss >= -tolerated || excess <= tolerated) return;
        for (const ContactIndex k : members) {
            ContactTrial& trial = trials_[k];
            trial.dilation_increment += std::max(loss, -excess) / normal;
            trial.sliding_slope = 0;
            trial.postponed = true;
        }
        any = true;
    });
    if (any) by_force_.clear();
    return any;
}

}  // namespace rockslope::dda
