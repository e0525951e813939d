#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dda/model/face.hpp"
#include "dda/model/free_field.hpp"

namespace rockslope::dda {

/// In which directions a viscous boundary is held while a static stage finds the forces that bear the model.
enum class Hold { none, normal, both };

/// Faces behind which the rock goes on for ever, theory sec. 11: dashpots that swallow waves.
struct ViscousBoundary {
    std::string name;  ///< by which a stage's incident wave calls it
    std::vector<FacePart> faces;
    double normal_impedance = 0;  ///< Pa s/m; 0: density times the speed of pressure waves in the face's rock
    double shear_impedance = 0;   ///< Pa s/m; 0: density times the speed of shear waves
    Hold hold = Hold::both;
    /// A column beside the faces, whose motion the rock behind them has; nothing: what leaves is swallowed.
    std::optional<FreeField> free_field = std::nullopt;
};

}  // namespace rockslope::dda
