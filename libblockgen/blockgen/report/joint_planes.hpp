#pragma once

#include <optional>
#include <string>
#include <vector>

#include "blockgen/faces/cut_context.hpp"
#include "blockgen/input/orientation.hpp"

namespace rockslope::blockgen {

/// The planes in space of the joints of one set.
struct JointPlanes {
    std::string name;
    std::vector<PlaneAngles> planes;  ///< rad; one for each plane with a trace in the rock
    PlaneAngles mean;                 ///< rad
    double asked_k = 0;               ///< Fisher's K in the model; 0: none, or measured poles
    std::optional<double> k;          ///< that of `planes`, see FisherEstimate
    bool weighted_by_section = false;
};

/// The planes of each set that is given by dip and dip direction and has a trace in the rock. Traces on one
/// line are of one plane, and pieces of a trace too. Sets of angles in the section and given traces have no
/// planes: how they strike is not known.
std::vector<JointPlanes> joint_planes(const CutContext& cut);

}  // namespace rockslope::blockgen
