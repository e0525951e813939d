#pragma once

#include <cstddef>
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

/// Where the poles of all sets' planes are densest.
struct DensestPlanes {
    std::size_t count = 0;         ///< number of poles
    double density = 0;            ///< % of the poles for each 1 % of the hemisphere's area, see AxisDensity
    double uniform_deviation = 0;  ///< standard deviation of the density of uniform poles about 1
    PlaneAngles plane;             ///< rad; whose pole lies there
};

/// The planes of each set that is given by dip and dip direction and has a trace in the rock. Traces on one
/// line are of one plane, and pieces of a trace too. Sets of angles in the section and given traces have no
/// planes: how they strike is not known.
std::vector<JointPlanes> joint_planes(const CutContext& cut);

/// @param sets with one plane or more.
DensestPlanes densest_planes(const std::vector<JointPlanes>& sets);

}  // namespace rockslope::blockgen
