#pragma once

#include <vector>

#include "blockgen/sampling/rock_domain.hpp"
#include "blockgen/sampling/set_sampler.hpp"

namespace rockslope::blockgen {

/// Expected number of lines and traces that sampling a set will draw, from its statistics alone; only a few
/// directions are drawn. For sets of hundreds, it is within a factor of two of the SetSampler::draw_count()
/// after sampling.
/// @param rock required for Baecher, Veneziano and Voronoi sets. @param others the traces at which cross
/// joints may end.
double expected_draws(const SetSampler& sampler, const RockDomain* rock, const std::vector<Trace>& others);

/// @throws InputError when the expected number of draws exceeds the limit of the sampler.
void check_expected_draws(const SetSampler& sampler, const RockDomain* rock,
                          const std::vector<Trace>& others);

}  // namespace rockslope::blockgen
