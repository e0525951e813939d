#pragma once

#include <vector>

#include "blockgen/input/slope_model.hpp"

namespace rockslope::blockgen {

/// A slope whose base is part of it, and its traces.
struct SlopeWithBase {
    SlopeModel model;  ///< without [base]
    std::vector<Trace> traces;
};

/// The slope and its base as one section: the base is a further part of the domain, a region of its own
/// material over all others, and held; a joint runs along its contact with the slope; the traces end there.
/// @param traces those of the model first. @param model with a base.
SlopeWithBase add_base(const SlopeModel& model, const std::vector<Trace>& traces);

}  // namespace rockslope::blockgen
