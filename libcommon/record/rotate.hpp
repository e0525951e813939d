#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// A horizontal component and the direction of its positive values.
struct HorizontalComponent {
    Accelerogram record;
    double azimuth = 0;  ///< degrees clockwise from north
};

/// The motion along an azimuth, degrees clockwise from north, from two components that need not be
/// orthogonal. The ground acceleration a solves a . e_i = a_i with the unit vectors e_i of the components.
/// The longer record is cut.
/// @throws std::invalid_argument for different steps, and for components within 10 degrees of parallel.
Accelerogram rotated(const HorizontalComponent& first, const HorizontalComponent& second, double azimuth);

}  // namespace rockslope::record
