#pragma once

#include <array>
#include <string>

#include "blockgen/input/slope_model.hpp"

namespace rockslope::peer {

/// Three kinds of jointing that make blocks of quite different sorts.
enum class Family {
    two_sets,        ///< persistent, of constant spacing
    three_sets,      ///< persistent, of exponential spacing
    ending_in_rock,  ///< three sets of traces and rock bridges
};

inline constexpr std::array families = {Family::two_sets, Family::three_sets, Family::ending_in_rock};

std::string name_of(Family family);

/// A square of 100 m with joints that make about so many blocks.
blockgen::SlopeModel family_slope(Family family, double blocks);

/// The joints of a model, those that end at the rim drawn on across it: where a sampler clips, rounding may
/// leave the end on either side.
std::vector<blockgen::Trace> traces_across_rim(const blockgen::SlopeModel& model);

}  // namespace rockslope::peer
