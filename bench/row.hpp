#pragma once

#include <string>

#include "stage_recorder.hpp"

namespace rockslope::bench {

/// Conditions of a measurement.
struct Conditions {
    std::string machine;  ///< processor and number of cores
    double load = 0;      ///< mean number of running processes over the minute before the run
    std::string compiler;
    std::string commit;
    int threads = 1;
};

/// The conditions on this machine now.
Conditions present_conditions(const std::string& commit, int threads);

/// The heading line of the CSV file, with units.
std::string csv_heading();

/// One line of the CSV file.
/// @param blocks number of all blocks, free or not.
std::string csv_row(const std::string& scene, int blocks, const StageStatistics& figures,
                    const Conditions& conditions);

}  // namespace rockslope::bench
