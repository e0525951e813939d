#pragma once

#include <string>

#include "stage_recorder.hpp"

namespace rockslope::bench {

/// What a measurement belongs to besides its scene.
struct Conditions {
    std::string machine;  ///< processor and its cores
    double load = 0;      ///< mean number of running processes over the minute before the run
    std::string compiler;
    std::string commit;
    int threads = 1;
};

/// This machine, at this moment.
Conditions present_conditions(const std::string& commit, int threads);

/// The heading line of the CSV file, with units.
std::string csv_heading();

/// One line of the CSV file.
/// @param blocks free ones and others.
std::string csv_row(const std::string& scene, int blocks, const StageStatistics& figures,
                    const Conditions& conditions);

}  // namespace rockslope::bench
