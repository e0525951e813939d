#pragma once

#include <vector>

#include "blockgen/input/slope_model.hpp"

namespace blockgen {

/// The traces of a joint set that reach the domain, or its region. A set's draws depend on the seed and its
/// name only, so editing one set leaves the others as they were, unless one ends on the other.
/// @param others the traces at which joints of a cross-jointed set may end. @throws InputError when the set
/// needs more than `most_draws` lines and traces.
std::vector<Trace> sample_joint_set(const JointSet& set, const SlopeModel& model,
                                    const std::vector<Trace>& others = {},
                                    std::size_t most_draws = 10'000'000);

/// All joints of a model: its traces, then its sets as sampled, in the order of the file.
std::vector<Trace> all_traces(const SlopeModel& model);

}  // namespace blockgen
