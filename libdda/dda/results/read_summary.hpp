#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "dda/base/types.hpp"

namespace rockslope::dda {

/// The contact that a run which did not converge blames, as its summary names it.
struct WorstContact {
    int corner_block = -1;
    int edge_block = -1;
    Vec2 at = Vec2::Zero();  ///< m, in the user's coordinates
    std::string joint_material;
};

/// The worst contact of a summary.json; none if the run ended without one to blame. @throws InputError when
/// the file cannot be read or is not what dda-run writes.
std::optional<WorstContact> read_worst_contact(const std::filesystem::path& summary);

}  // namespace rockslope::dda
