#pragma once

#include <cstdint>
#include <string>

namespace rockslope::blockgen {

/// Purpose of a draw. The values must not change: they determine the result for a given seed.
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

/// A counter-based generator of uniform numbers in (0, 1): Philox 4x64 (Salmon et al. 2011). A draw depends
/// on the seed, the name and the counters only, so draws can be made in any order. The numbers are the same
/// on every platform.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, const std::string& name);
    double draw(std::uint64_t purpose, std::int64_t line, std::uint64_t index) const;

  private:
    std::uint64_t seed_;
    std::uint64_t name_;
};

}  // namespace rockslope::blockgen
