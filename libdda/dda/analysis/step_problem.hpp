#pragma once

#include <span>

#include "dda/contact/contact.hpp"
#include "dda/contact/joint_segments.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"
#include "dda/terms/row_contacts.hpp"
#include "dda/terms/springs.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// What a contact does at the end of a step.
struct EvaluatedContact {
    ContactState state = ContactState::open;
    double gap = 0;                 ///< m
    double stress_free_gap = 0;     ///< m, see Contact
    double normal_force = 0;        ///< N per metre
    double shear_force = 0;         ///< N per metre
    double displacement = 0;        ///< tangential, of the step, m
    double slip = 0;                ///< plastic part of it, m
    double dilation_increment = 0;  ///< by which the step's shearing moved the faces apart, m
    bool bond_broken = false;       ///< bonded at the start, opened in this step
};

/// One step's equations: everything that the open-close iteration may read and does not change.
struct StepProblem {
    const Model& model;
    const StepControl& control;
    const RowMap& rows;
    const BaseSystem& base;
    const BlockSystem& blocks;          ///< at the start of the step
    std::span<const Vec6> prescribed;   ///< per block, known displacements
    std::span<const Contact> contacts;  ///< at the start of the step
    const JointSegments& segments;      ///< of the contacts
    /// Per contact: what another look at the step found, null where there was none. A place to start from.
    std::span<const EvaluatedContact* const> guess;
    std::span<const ContactSprings> springs;
    const RowContacts& row_contacts;  ///< by the rows of the springs
    std::span<const BoltSpring> bolts;
    std::span<const double> bolt_force;  ///< at the start of the step, N per metre
    double rounding_force = 0;           ///< N per metre, below which force differences are rounding
};

}  // namespace rockslope::dda
