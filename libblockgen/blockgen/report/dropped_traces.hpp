#pragma once

#include <string>
#include <vector>

#include "blockgen/faces/cut_context.hpp"

namespace rockslope::blockgen {

/// Warnings of given traces without effect, counted by name: outside the rock, along a free face, or without
/// length on the grid. Sampled sets fill the domain's box, so some of their traces always lie outside the
/// rock.
std::vector<std::string> dropped_trace_warnings(const CutContext& cut);

}  // namespace rockslope::blockgen
