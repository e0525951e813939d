#pragma once

#include <span>
#include <string>

#include "common/drawing/canvas.hpp"
#include "joint_history.hpp"

namespace rockslope {

/// A measured joint over time in one run or several: displacement along it, dilation where there is any, the
/// friction angle that its strength amounts to (of the strength over the normal stress), and the changes of
/// the slip's direction where there are any. @param references drawn
/// dashed, in black.
Canvas draw_joint_histories(const std::string& joint, std::span<const JointHistory> runs,
                            std::span<const JointHistory> references);

}  // namespace rockslope
