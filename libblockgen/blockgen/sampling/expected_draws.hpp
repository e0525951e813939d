#pragma once

#include <vector>

#include "blockgen/sampling/rock_domain.hpp"
#include "blockgen/sampling/set_sampler.hpp"

namespace rockslope::blockgen {

/// How many lines and traces a set will be made of, from its statistics alone: nothing is drawn but a few
/// directions. Within a factor of two of what SetSampler::count_draw() comes to, for sets of hundreds.
/// @param rock needed by the sets that lie anywhere. @param others the traces at which cross joints may end.
double expected_draws(const SetSampler& sampler, const RockDomain* rock, const std::vector<Trace>& others);

/// @throws InputError when a set is expected to be made of more lines and traces than its sampler may draw.
void check_expected_draws(const SetSampler& sampler, const RockDomain* rock,
                          const std::vector<Trace>& others);

}  // namespace rockslope::blockgen
