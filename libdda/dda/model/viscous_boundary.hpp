#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dda/model/face.hpp"
#include "dda/model/free_field.hpp"

namespace rockslope::dda {

/// Directions in which a viscous boundary is held by springs in static stages. Their forces are the reactions
/// that support the model.
enum class Hold { none, normal, both };

/// Faces beyond which the rock is unbounded: dashpots absorb the waves that arrive, theory section 11.
struct ViscousBoundary {
    std::string name;  ///< referred to by IncidentWave::boundary
    std::vector<FacePart> faces;
    double normal_impedance = 0;  ///< Pa s/m; 0: density times the speed of pressure waves in the face's rock
    double shear_impedance = 0;   ///< Pa s/m; 0: density times the speed of shear waves
    Hold hold = Hold::both;
    /// The free field beside the faces: only motion relative to it is absorbed. Nothing: all motion is
    /// absorbed.
    std::optional<FreeField> free_field = std::nullopt;
};

}  // namespace rockslope::dda
