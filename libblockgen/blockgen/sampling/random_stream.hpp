#pragma once

#include <cstdint>
#include <string>

namespace rockslope::blockgen {

/// What a draw is for; a number here is part of every result ever made with a seed.
enum DrawPurpose : std::uint64_t {
    draw_phase = 0,
    draw_spacing_forward = 1,
    draw_spacing_backward = 2,
    draw_trace = 3,
    draw_bridge = 4,
    draw_direction = 5,
    draw_start = 6,
    draw_place = 7,
    draw_termination = 8,
    draw_stagger = 9
};

/// A stream of numbers in (0, 1) that any draw can be asked of, in any order: draw k depends on the seed, the
/// name and the counters alone. Philox 4x64 (Salmon et al. 2011); the same numbers on every platform.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, const std::string& name);
    double draw(std::uint64_t purpose, std::int64_t line, std::uint64_t index) const;

  private:
    std::uint64_t seed_;
    std::uint64_t name_;
};

}  // namespace rockslope::blockgen
