#pragma once

#include <span>

#include "dda/analysis/open_close_iteration.hpp"

namespace rockslope::dda {

/// Whether blocks turned so differently from what fixed the arms and normals half-way through the step
/// (MidStep) that contact forces did noticeably more or less work than their springs stored: the linear
/// measure of a contact's opening, Eq. (20), is good to third order only about the true half-way position. An
/// impact may change a rotation by its whole size, and the step would gain or lose energy by it.
/// @param predicted, displacement per block, over the step.
/// @param before the step's contacts at its start.
/// @param kinetic energy at the step's start, J per metre, that the work is compared with.
bool rotation_prediction_failed(std::span<const Vec6> predicted, std::span<const Vec6> displacement,
                                std::span<const ContactSprings> springs, std::span<const Contact> before,
                                const OpenCloseResult& result, double kinetic);

}  // namespace rockslope::dda
