#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "blockgen/fit/fit_map.hpp"

namespace rockslope::blockgen {

/// The files of a map, and what their coordinates mean, as in a slope model.
struct MapRequest {
    std::filesystem::path traces;
    std::filesystem::path
        outline;  ///< of the mapped area; empty: polygons of the traces' GeoJSON file, or none
    std::string crs, unit, project;
};

/// A map read, and what was noted.
struct JointMapFile {
    JointMap map;
    std::vector<std::string> notes;
};

/// Reads a map. Without an outline the mapped area is the box around the traces, and a note says so.
/// @throws InputError
JointMapFile read_joint_map(const MapRequest& request);

}  // namespace rockslope::blockgen
