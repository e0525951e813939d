#include "dda/terms/contact_damping.hpp"

#include <algorithm>
#include <cmath>

#include "dda/contact/detect.hpp"
#include "dda/contact/typical_block.hpp"

namespace rockslope::dda {

namespace {

/// Whether a contact is expected to bear a force at the step's end: it is closed now, or the motion predicted
/// closes it. Of the lines of a vertex-vertex contact it is not known which will close.
bool is_expected_to_bear(const Model& model, const MidStep& mid, const Contact& contact) {
    if (contact.state != ContactState::open) return true;
    if (contact.inhibited || contact.group >= 0) return false;
    const CornerEdgeGeometry at_mid_step =
        corner_edge_geometry(mid.vertices[contact.corner], mid.vertices[start_of(contact.edge)],
                             mid.vertices[model.topology.end_of(contact.edge)]);
    const double gap_at_end = 2 * (at_mid_step.gap - contact.dilation) - contact.gap;
    return gap_at_end < contact.stress_free_gap;
}

/// The squared frequency of the normal motion of contacts, Eq. (87).
class ContactFrequency {
  public:
    ContactFrequency(const RowMap& rows, const BlockSystem& blocks, const SpringsOfContacts& contacts,
                     ContactSpan<const char> bears)
        : springs_(contacts.springs), row_contacts_(contacts.row_contacts), bears_(bears) {
        for (const BlockIndex b : rows.block_of) {
            const AreaMoments& moments = blocks.moments[b];
            const double mass = blocks.mass[b];
            mass_.push_back({mass, mass / moments.area * (moments.xx + moments.yy)});
        }
    }

    /// rad2/s2
    double squared(ContactIndex k) const {
        double sum = 0;
        for (const RowIndex row : {springs_[k].rows.first, springs_[k].rows.second})
            if (row.exists()) sum += squared_of_block(k, row);
        return sum;
    }

  private:
    struct RigidMass {
        double translation = 0;  ///< kg per metre
        double rotation = 0;     ///< kg m2 per metre
    };

    /// The acceleration with which a block moves away from a contact, over the closure of all contacts on
    /// that side of the block. It is at least that of the contact by itself on a block that does not rotate.
    double squared_of_block(ContactIndex k, RowIndex row) const {
        const RigidMass& mass = mass_[row];
        const auto gradient = [&](ContactIndex contact) {
            return springs_[contact].rows.project_on_row(row, springs_[contact].normal.direction);
        };
        const Vec6 own = gradient(k);
        double sum = 0;
        for (const ContactIndex j : row_contacts_.of(row)) {
            if (j != k && bears_[j] == 0) continue;
            const Vec6 other = gradient(j);
            const double along = own.head<2>().dot(other.head<2>());
            if (!(along > 0)) continue;
            sum +=
                springs_[j].normal_stiffness * (along / mass.translation + own[2] * other[2] / mass.rotation);
        }
        return std::max(sum, springs_[k].normal_stiffness / mass.translation);
    }

    ContactSpan<const ContactSprings> springs_;
    const RowContacts& row_contacts_;
    ContactSpan<const char> bears_;
    PerRow<RigidMass> mass_;
};

}  // namespace

/// The dashpots of Eq. (86), less the damping of the time integration, Eq. (88).
PerContact<NormalDashpot> contact_dashpots(const Model& model, const BlocksAtMidStep& blocks,
                                           const Newmark& newmark, const SpringsOfContacts& contacts,
                                           const ThreadPool& pool) {
    if (std::none_of(model.joint_materials.begin(), model.joint_materials.end(),
                     [](const JointMaterial& material) { return material.contact_damping > 0; }))
        return {};
    const auto for_contacts = [&](const auto& body) {
        pool.parallel_for(contacts.contacts.size(), [&](std::size_t begin, std::size_t end) {
            for (const ContactIndex k : indices<ContactIndex>(begin, end)) body(k);
        });
    };
    PerContact<char> bears(contacts.contacts.size());
    for_contacts([&](ContactIndex k) {
        bears[k] = is_expected_to_bear(model, blocks.mid, contacts.contacts[k]) ? 1 : 0;
    });
    const ContactFrequency frequency(blocks.rows, blocks.blocks, contacts, bears);
    PerContact<NormalDashpot> dashpots(contacts.contacts.size());
    for_contacts([&](ContactIndex k) {
        const Contact& contact = contacts.contacts[k];
        const double ratio = model.joint_material_at(contact.joint_material).contact_damping;
        if (!(ratio > 0) || contact.bonded || model.is_augmented(contact.joint_material)) return;
        const double squared = frequency.squared(k);
        if (!(squared > 0)) return;
        const double stiffness = contacts.springs[k].normal_stiffness;
        const double asked = 2 * ratio * stiffness / std::sqrt(squared) / newmark.dt;
        const double of_integration = std::max(newmark.gamma - 0.5, 0.0) * stiffness;
        dashpots[k] = {std::max(asked - of_integration, 0.0),
                       std::max(contact.stress_free_gap - contact.gap, 0.0),
                       asked < of_integration ? asked / of_integration : 1};
    });
    return dashpots;
}

std::optional<IneffectiveDamping> ineffective_damping(const Model& model, std::span<const Stage> stages) {
    const std::optional<TypicalBlock> typical = typical_block(model);
    if (!typical) return std::nullopt;
    for (std::size_t k = 0; k < stages.size(); ++k) {
        if (stages[k].is_static()) continue;
        for (const JointMaterialIndex m : model.joint_materials.indices()) {
            const JointMaterial& material = model.joint_materials[m];
            const double stiffness = material.normal_spring(model.normal_penalty, typical->face).stiffness;
            const double frequency_step = std::sqrt(stiffness / typical->mass) * stages[k].control.step;
            const double of_integration = (stages[k].newmark_gamma - 0.5) * frequency_step;
            if (material.contact_damping > 0 && of_integration >= 2 * material.contact_damping)
                return IneffectiveDamping{k, m, frequency_step};
        }
    }
    return std::nullopt;
}

}  // namespace rockslope::dda
