#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "blockgen/input/slope_model.hpp"

namespace rockslope::blockgen {

/// How many lines and traces may be drawn for a model of at most so many blocks: as many, and ten thousand
/// more, so that a small limit does not forbid a network that hardly connects. A million take about 1.2 GB.
constexpr std::size_t max_draws_for(std::size_t max_blocks) {
    return std::min<std::size_t>(max_blocks, 1'000'000'000'000) + 10'000;
}

/// The traces of a joint set that reach the domain, or its region. A set's draws depend on the seed and its
/// name only, so editing one set leaves the others as they were, unless one ends on the other.
/// @param others the traces at which joints of a cross-jointed set may end. @throws InputError when the set
/// needs more than `max_draws` lines and traces, before it is drawn where its statistics tell.
std::vector<Trace> sample_joint_set(const JointSet& set, const SlopeModel& model,
                                    const std::vector<Trace>& others = {},
                                    std::size_t max_draws = max_draws_for(1'000'000));

/// All joints of a model: its traces, then its sets as sampled, in the order of the file. @throws InputError
/// before a set is drawn that would take more lines and traces, with those of the sets before it, than
/// max_draws_for() allows.
std::vector<Trace> all_traces(const SlopeModel& model, std::size_t max_blocks = 1'000'000);

}  // namespace rockslope::blockgen
