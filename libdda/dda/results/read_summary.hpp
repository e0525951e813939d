#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "dda/base/types.hpp"

namespace rockslope::dda {

/// The contact with the largest residual of a run that did not converge, from its summary.
struct WorstContact {
    int corner_block = -1;
    int edge_block = -1;
    Vec2 at = Vec2::Zero();  ///< m, in the user's coordinates
    std::string joint_material;
};

/// The worst contact in a summary.json; nothing if it has none. @throws InputError if the file cannot be read
/// or is not a summary of dda-run.
std::optional<WorstContact> read_worst_contact(const std::filesystem::path& summary);

/// How the run of a summary.json ended: "completed", "collapsed", ... @throws InputError if the file cannot
/// be read or is not a summary of dda-run.
std::string read_status(const std::filesystem::path& summary);

/// The factor of safety of a strength reduction in a summary.json: the geometric mean of the largest factor
/// that stood and the smallest that failed; nothing where there is not one of each. @throws InputError if the
/// file cannot be read or is not a summary of dda-run.
std::optional<double> read_factor_of_safety(const std::filesystem::path& summary);

}  // namespace rockslope::dda
