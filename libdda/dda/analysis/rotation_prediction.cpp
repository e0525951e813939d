#include "dda/analysis/rotation_prediction.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

namespace {

/// Error of the predicted rotation times the rotation, rad2. Below this value the prediction counts as right,
/// and the work error is not computed.
constexpr double rotation_error_tolerance = 1e-6;
/// Largest work error of the contact forces over the kinetic energy.
constexpr double work_error_tolerance = 1e-6;

}  // namespace

bool rotation_prediction_failed(BlockSpan<const Vec6> predicted, BlockSpan<const Vec6> displacement,
                                ContactSpan<const ContactSprings> springs, ContactSpan<const Contact> before,
                                const OpenCloseResult& result, double kinetic) {
    double rotation_error = 0;
    for (const BlockIndex b : displacement.indices())
        rotation_error =
            std::max(rotation_error, std::abs(displacement[b][2] * (displacement[b][2] - predicted[b][2])));
    if (rotation_error < rotation_error_tolerance) return false;
    double work_error = 0;
    for (const ContactIndex k : result.contacts.indices()) {
        const EvaluatedContact& evaluated = result.contacts[k];
        const double linear = springs[k].rows.measure(springs[k].normal, result.displacement);
        work_error += std::abs(evaluated.normal_force *
                               (evaluated.gap + evaluated.dilation_increment - before[k].gap - linear));
    }
    return work_error > work_error_tolerance * kinetic;
}

BlockIndex worst_predicted(BlockSpan<const Vec6> predicted, BlockSpan<const Vec6> displacement) {
    BlockIndex worst(0);
    double largest = 0;
    for (const BlockIndex b : displacement.indices()) {
        const double error = std::abs(displacement[b][2] - predicted[b][2]);
        if (error > largest) worst = b;
        largest = std::max(largest, error);
    }
    return worst;
}

}  // namespace rockslope::dda
