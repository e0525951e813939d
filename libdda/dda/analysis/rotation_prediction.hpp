#pragma once

#include "dda/solve/open_close_iteration.hpp"

namespace rockslope::dda {

/// Whether the predicted rotations were so wrong that the step would gain or lose energy.
///
/// The predicted displacement fixes the contact arms and normals at mid-step (MidStep). The linearised
/// opening of a contact, Eq. (20), is third-order accurate only about the true mid-step position, and an
/// impact may change a rotation by its whole size. The contact forces then do more or less work than the
/// springs store.
/// @param predicted displacement of the step by the prediction, per block.
/// @param displacement displacement of the step by the solution, per block.
/// @param before the contacts at the start of the step.
/// @param kinetic J per metre, kinetic energy at the start of the step, the scale for the work error.
bool rotation_prediction_failed(BlockSpan<const Vec6> predicted, BlockSpan<const Vec6> displacement,
                                ContactSpan<const ContactSprings> springs, ContactSpan<const Contact> before,
                                const OpenCloseResult& result, double kinetic);

/// The block that turns most otherwise than predicted.
/// @param predicted, displacement as above.
BlockIndex worst_predicted(BlockSpan<const Vec6> predicted, BlockSpan<const Vec6> displacement);

}  // namespace rockslope::dda
