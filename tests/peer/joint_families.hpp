#pragma once

#include <array>
#include <string>

#include "blockgen/input/slope_model.hpp"

namespace rockslope::peer {

/// Three kinds of joint networks that give different types of blocks.
enum class Family {
    two_sets,        ///< two persistent sets of constant spacing
    three_sets,      ///< three persistent sets of exponential spacing
    ending_in_rock,  ///< three sets of traces and rock bridges
};

inline constexpr std::array families = {Family::two_sets, Family::three_sets, Family::ending_in_rock};

std::string name_of(Family family);

/// A square of 100 m with joints that give about the given number of blocks.
blockgen::SlopeModel family_slope(Family family, double blocks);

/// The joints of a model. Joints that end at the boundary are extended by 1 m beyond it, because the
/// sampler's clipping may round their ends to either side.
std::vector<blockgen::Trace> traces_across_boundary(const blockgen::SlopeModel& model);

}  // namespace rockslope::peer
