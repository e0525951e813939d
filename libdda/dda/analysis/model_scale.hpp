#pragma once

#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// Sizes of a model that tolerances of its steps are measured in. They stay as they are at the start.
struct ModelScale {
    /// Measures the blocks as the model describes them.
    ModelScale(const Model& model, const RowMap& rows);

    /// The largest displacement that a vertex may have in a step, m.
    double displacement_limit(const StepControl& control) const {
        return control.displacement_ratio * half_height;
    }

    double half_height = 0;          ///< m, half the height of the model
    double mean_weight = 0;          ///< N per metre, mean weight of a block with unknowns; 0 without any
    double coordinate_rounding = 0;  ///< m, rounding error of a coordinate
    double edge_length = 0;          ///< m, median of the block edges
};

}  // namespace rockslope::dda
