#pragma once

#include <string>
#include <vector>

#include "blockgen/input/slope_model.hpp"

namespace blockgen {

/// A stream of numbers in (0, 1) that any draw can be asked of, in any order: draw k depends on the seed, the
/// name and the counters alone. Philox 4x64 (Salmon et al. 2011); the same numbers on every platform.
class DrawStream {
  public:
    DrawStream(std::uint64_t seed, const std::string& name);
    double draw(std::uint64_t purpose, std::int64_t line, std::uint64_t index) const;

  private:
    std::uint64_t seed_;
    std::uint64_t name_;
};

/// The traces of a joint set within the domain's bounding box, or within its region. Spacings are measured
/// across the set's mean direction, from the origin to both sides. Each line alternates trace and rock
/// bridge. A set's draws depend on the seed and its name only, so editing one set leaves the others as they
/// were. @throws InputError when the set needs more than `most_draws` lines and traces.
std::vector<Trace> sample_joint_set(const JointSet& set, const SlopeModel& model,
                                    std::size_t most_draws = 10'000'000);

}  // namespace blockgen
