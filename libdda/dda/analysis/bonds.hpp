#pragma once

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// Whether bonds hold in a stage, as it asks and its joints have any.
bool bonds_hold(const Model& model, const Stage& stage);

/// The share of its bond's strength at which each contact yields in a step of a static stage, Eq. (97): 0.8
/// of it at first, all of it where the bond has moved.
/// Faces that are glued for good have all of it.
/// @param contacts at the step's start.
PerContact<double> held_shares(const Model& model, ContactSpan<const Contact> contacts);

/// Breaks the worst of the bonds that static stages cannot hold, Eq. (96): all whose measure is within 5 % of
/// the largest. They have their residual strength from the next step on. Counts contacts and event in
/// `state.broken_bonds`, and keeps the largest measure of each contact. @return the number of contacts, 0 if
/// all bonds hold.
int break_worst_bonds(const Model& model, State& state);

/// Counts the bonds that hold, and those of them that bear all of the strength that they would lose, to a
/// hundredth: they have slipped or opened within their largest strain, and a dynamic stage breaks them as
/// soon as they move further.
StrainedBonds strained_bonds(const Model& model, const State& state);

/// Lets the normal springs of held bonds begin where they bear the present forces, at the end of a static
/// stage: what a bond has opened at its tensile strength is no tension of the stage that follows, Eq. (96).
void relax_held_bonds(const Model& model, State& state);

}  // namespace rockslope::dda
