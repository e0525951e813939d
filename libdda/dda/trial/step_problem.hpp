#pragma once

#include <limits>
#include <span>

#include "dda/contact/contact.hpp"
#include "dda/contact/joint_segments.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"
#include "dda/terms/contact_damping.hpp"
#include "dda/terms/row_contacts.hpp"
#include "dda/terms/springs.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// Slip or opening of a bond that a static stage does not hold, over the length of its contact, Eq. (96).
inline constexpr double largest_bond_strain = 0.01;

/// The state and forces of a contact at the end of a step, evaluated by its joint law.
struct EvaluatedContact {
    ContactState state = ContactState::open;
    double gap = 0;                  ///< m
    double stress_free_gap = 0;      ///< m, see Contact
    double normal_force = 0;         ///< N per metre
    double normal_spring_force = 0;  ///< N per metre, see Contact
    double shear_force = 0;          ///< N per metre; also where cohesion acts in a contact that opens
    double displacement = 0;         ///< m, tangential displacement of the step
    double slip = 0;                 ///< m, plastic part of the tangential displacement
    double dilation_increment = 0;   ///< m, opening of the joint by the shearing of the step
    bool bond_broken = false;        ///< bonded at the start of the step, broken in it
};

/// The equations of one step: the constant input of the open-close iteration.
struct StepProblem {
    const Model& model;
    const StepControl& control;
    const RowMap& rows;
    const BaseSystem& base;
    const BlockSystem& blocks;            ///< at the start of the step
    BlockSpan<const Vec6> prescribed;     ///< per block, displacement of the step where it is prescribed
    ContactSpan<const Contact> contacts;  ///< at the start of the step
    const JointSegments& segments;        ///< groups the contacts by joint segment
    /// Per contact: the initial guess from an earlier attempt at the step, or null.
    ContactSpan<const EvaluatedContact* const> guess;
    ContactSpan<const ContactSprings> springs;
    const RowContacts& row_contacts;  ///< the contacts of each matrix row
    std::span<const BoltSpring> bolts;
    std::span<const double> bolt_force;  ///< at the start of the step, N per metre
    StepTime time;                       ///< of the step
    double rounding_force = 0;           ///< N per metre; smaller force differences are rounding errors
    ContactSpan<const NormalDashpot> dashpots = {};  ///< per contact, beside its normal spring; empty: none
    /// Per contact: the share of its bond's strength at which the bond yields, Eq. (97). Empty: bonds break
    /// in the step at their whole strength.
    ContactSpan<const double> held_shares = {};
    /// J per metre; friction that gives no more in a step is a rounding error.
    double tolerated_gain = 0;
    /// Whether the mid-step may be predicted anew: the iteration then ends where gaps do not settle.
    bool may_predict_anew = false;
    /// Per row: the displacement that an earlier attempt at the step found, m; empty in the first attempt.
    RowSpan<const Vec6> found = {};
    double displacement_limit = std::numeric_limits<double>::infinity();  ///< m, of a vertex in the step

    /// Whether no bond breaks in the step.
    bool bonds_hold() const { return !held_shares.empty(); }
};

}  // namespace rockslope::dda
