#pragma once

#include <string>
#include <vector>

#include "blockgen/faces/cut_context.hpp"
#include "blockgen/report/changes.hpp"

namespace rockslope::blockgen {

/// Joints that run along earlier ones in the rock by a hundredth of their length or more: less is what
/// rounding makes of joints that cross at a small angle. The earlier joint counts there and names the edge.
/// One change for each joint: where, by which length, along which earlier joint first.
std::vector<Change> repeated_joints(const CutContext& cut);

/// One warning for each pair of names among these changes.
std::vector<std::string> repeated_joint_warnings(const std::vector<Change>& changes);

}  // namespace rockslope::blockgen
