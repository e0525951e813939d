#include "dda/analysis/rotation_prediction.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

namespace {

/// A mistake in the rotation over the step, times the rotation, rad2, from which on the work_error of contact
/// forces is looked at.
constexpr double rotation_error_tolerance = 1e-6;
/// The share of the kinetic energy by which that work_error may differ from what the springs store.
constexpr double work_error_tolerance = 1e-6;

}  // namespace

bool rotation_prediction_failed(std::span<const Vec6> predicted, std::span<const Vec6> displacement,
                                std::span<const ContactSprings> springs, std::span<const Contact> before,
                                const OpenCloseResult& result, double kinetic) {
    double rotation_error = 0;
    for (std::size_t b = 0; b < displacement.size(); ++b)
        rotation_error =
            std::max(rotation_error, std::abs(displacement[b][2] * (displacement[b][2] - predicted[b][2])));
    if (rotation_error < rotation_error_tolerance) return false;
    double work_error = 0;
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const EvaluatedContact& evaluated = result.contacts[k];
        const double linear = springs[k].rows.measure(springs[k].normal, result.displacement);
        work_error += std::abs(evaluated.normal_force *
                               (evaluated.gap + evaluated.dilation_increment - before[k].gap - linear));
    }
    return work_error > work_error_tolerance * kinetic;
}

}  // namespace rockslope::dda
