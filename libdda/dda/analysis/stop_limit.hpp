#pragma once

#include <optional>
#include <string>

#include "dda/analysis/run_observer.hpp"

namespace rockslope::dda {

/// What has moved farther than the limit of a stage; of several blocks the one that moved farthest. Nothing
/// without a limit.
std::optional<Collapse> find_collapse(const Model& model, const Stage& stage, const State& state);

/// One line: stage, time, block or point, place, displacement, what the block moves along, and the limit.
std::string describe(const Model& model, const Stage& stage, const State& state, const Collapse& collapse);

}  // namespace rockslope::dda
