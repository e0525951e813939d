#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "dda/block/block_system.hpp"
#include "dda/model/stage.hpp"
#include "dda/terms/row_contacts.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// A dashpot beside the normal spring of a contact in one step, Eq. (86). Contact and dashpot together never
/// pull.
struct NormalDashpot {
    double stiffness = 0;  ///< N/m per metre, its force over the closure of the step
    double closure = 0;    ///< m, compression of the spring at the step's start, not negative
    /// The part of the contact's loss of energy that is that of the dashpot asked for, 0 to 1; the rest is
    /// the damping of the time integration, Eq. (88).
    double share_of_loss = 0;

    /// Its force, N per metre, negative while the spring expands. @param closed m, compression of the spring
    /// at the step's end; negative: the faces are apart.
    double force(double closed) const { return stiffness * (std::max(closed, 0.0) - closure); }
};

/// The blocks of a step: their rows in the equations, their state at its start, their positions half-way.
struct BlocksAtMidStep {
    const RowMap& rows;
    const BlockSystem& blocks;
    const MidStep& mid;
};

/// The contacts of a step, the spring of each and the contacts of each row.
struct SpringsOfContacts {
    ContactSpan<const Contact> contacts;
    ContactSpan<const ContactSprings> springs;
    const RowContacts& row_contacts;
};

/// The dashpots of all contacts for a step of a dynamic stage; empty if no joint material has a
/// contact_damping. Bonded and augmented contacts have none: the first do not land, and the second are rigid.
PerContact<NormalDashpot> contact_dashpots(const Model& model, const BlocksAtMidStep& blocks,
                                           const Newmark& newmark, const SpringsOfContacts& contacts,
                                           const ThreadPool& pool);

/// A contact_damping that is without effect in a stage: the time integration damps an impact more.
struct IneffectiveDamping {
    std::size_t stage = 0;  ///< index
    JointMaterialIndex joint_material;
    double frequency_step = 0;  ///< omega dt of one contact of a block of median mass
};

/// The first contact_damping without effect in a dynamic stage, by Eq. (88) for a free block of median mass
/// on one contact of the median length of the edges.
std::optional<IneffectiveDamping> ineffective_damping(const Model& model, std::span<const Stage> stages);

}  // namespace rockslope::dda
