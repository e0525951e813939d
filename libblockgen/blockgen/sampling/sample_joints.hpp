#pragma once

#include <cstddef>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "blockgen/sampling/set_sampler.hpp"

namespace rockslope::blockgen {

/// Samples the traces of a joint set in the domain, or in the set's region. The draws depend on the seed and
/// the set's name only, so editing one set does not change the others, except sets that end on it.
/// @param others the traces at which joints of a cross-jointed set may end, or the mapped traces to which a
/// set adds until it has its density. In a mapped area nothing is added, and the density is that of the rest.
/// @throws InputError when the set needs more lines and traces than the limit allows; before sampling if its
/// statistics show it.
std::vector<Trace> sample_joint_set(const JointSet& set, const SlopeModel& model,
                                    const std::vector<Trace>& others = {}, const DrawLimit& limit = {});

/// All joints of a model: its traces, then its sampled sets, in the order of the file. @throws InputError
/// when the sets need more lines and traces than DrawLimit allows.
std::vector<Trace> all_traces(const SlopeModel& model, std::size_t max_blocks = 1'000'000);

}  // namespace rockslope::blockgen
