#include "dda/analysis/bonds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "dda/contact/contact_stiffness.hpp"
#include "dda/contact/detect.hpp"
#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

namespace {

/// The bonds that break in one event: their measure over the largest.
constexpr double worst_share = 0.95;

/// The share of its strength at which a bond yields as long as it has not moved.
constexpr double least_held_share = 0.8;
/// The measure of Eq. (96) above which a bond yields at its whole strength.
constexpr double wholly_held_measure = 0.5;

/// A bond bears all of its strength from this share on.
constexpr double all_of_strength = 0.99;

/// The history of a contact whose bond has broken.
JointHistory broken(const JointLaw& law, const JointHistory& history) {
    ContactMotion motion;
    motion.opened = true;
    return advance(law, history, motion);
}

/// Whether a bond of the law breaks when it opens. Faces that are glued for good do not.
bool may_break(const JointLaw& law) {
    const JointHistory intact = fresh_history(law, true);
    return broken(law, intact) != intact;
}

/// The measure of Eq. (96), above 1 where the bond is not held. @param length m, of a contact between faces,
/// or of the edge of a bare vertex.
double bond_measure(const Contact& contact, double length) {
    return std::max(std::abs(contact.slip), contact.gap) / (largest_bond_strain * length);
}

/// Smallest length of a contact whose bond counts as one between faces, over that of its edge.
constexpr double least_share_of_edge = 0.01;

/// The length of a contact, or that of its edge for a bare vertex or a sliver of overlap, m.
double length_of(const Model& model, CornerSpan<const Vec2> vertices, const Contact& contact) {
    const double edge =
        (vertices[model.topology.end_of(contact.edge)] - vertices[start_of(contact.edge)]).norm();
    return contact.length > least_share_of_edge * edge ? contact.length : edge;
}

}  // namespace

bool bonds_hold(const Model& model, const Stage& stage) {
    return stage.bonds_break_at_rest &&
           std::any_of(model.joint_materials.begin(), model.joint_materials.end(), [](const auto& material) {
               return has_cohesion(material.law) && may_break(material.law);
           });
}

/// The shares of Eq. (97).
PerContact<double> held_shares(const Model& model, ContactSpan<const Contact> contacts) {
    std::vector<bool> breaks;
    for (const JointMaterial& material : model.joint_materials) breaks.push_back(may_break(material.law));
    PerContact<double> shares;
    for (const Contact& contact : contacts) {
        const double moved = std::min(contact.bond_strain / wholly_held_measure, 1.0);
        shares.push_back(
            breaks[contact.joint_material.value()] ? least_held_share + (1 - least_held_share) * moved : 1);
    }
    return shares;
}

int break_worst_bonds(const Model& model, State& state) {
    struct Overstrained {
        ContactIndex contact;
        double measure = 0;
        JointHistory broken;
    };
    std::vector<Overstrained> overstrained;
    double worst = 0;
    for (const ContactIndex k : state.contacts.contacts.indices()) {
        Contact& contact = state.contacts.contacts[k];
        const JointLaw& law = model.joint_material_at(contact.joint_material).law;
        if (contact.state == ContactState::open || has_segment_history(law)) continue;
        const double measure = bond_measure(contact, length_of(model, state.blocks.vertices, contact));
        contact.bond_strain = std::max(contact.bond_strain, measure);
        if (!(measure > 1)) continue;
        const JointHistory after = broken(law, contact.history);
        if (after == *contact.history) continue;
        overstrained.push_back({k, measure, after});
        worst = std::max(worst, measure);
    }
    int count = 0;
    for (const Overstrained& bond : overstrained) {
        if (bond.measure < worst_share * worst) continue;
        Contact& contact = state.contacts.contacts[bond.contact];
        contact.history = bond.broken;
        contact.bonded = false;
        ++count;
    }
    state.broken_bonds.contacts += count;
    if (count > 0) ++state.broken_bonds.events;
    return count;
}

StrainedBonds strained_bonds(const Model& model, const State& state) {
    StrainedBonds found;
    for (const Contact& contact : state.contacts.contacts) {
        const JointLaw& law = model.joint_material_at(contact.joint_material).law;
        if (contact.state == ContactState::open || has_segment_history(law) || !has_cohesion(law)) continue;
        const double pressing = std::max(contact.normal_force, 0.0);
        const Strength whole = strength(law, contact.history, pressing, contact.length);
        const Strength residual = strength(law, broken(law, contact.history), pressing, contact.length);
        const bool forward = contact.shear_force > 0;
        const double shear = forward ? whole.forward : whole.backward;
        const bool loses_shear = (forward ? residual.forward : residual.backward) < shear;
        const bool loses_tension = residual.tensile < whole.tensile;
        if (!loses_shear && !loses_tension) continue;
        const double borne = all_of_strength / model.strength_reduction;
        ++found.of;
        if ((loses_shear && std::abs(contact.shear_force) >= borne * shear) ||
            (loses_tension && -contact.normal_force >= borne * whole.tensile))
            ++found.contacts;
    }
    return found;
}

void relax_held_bonds(const Model& model, State& state) {
    for (Contact& contact : state.contacts.contacts) {
        if (contact.state == ContactState::open || contact.normal_force > 0) continue;
        const JointLaw& law = model.joint_material_at(contact.joint_material).law;
        if (has_segment_history(law) || model.is_augmented(contact.joint_material)) continue;
        contact.stress_free_gap = contact.gap + normal_spring(model, contact).closure(contact.normal_force);
    }
}

}  // namespace rockslope::dda
