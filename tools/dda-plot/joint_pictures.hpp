#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/drawing/canvas.hpp"

namespace rockslope {

/// A measured joint and the picture of its histories.
struct JointPicture {
    std::string joint;
    Canvas canvas;
};

/// One measured joint in several runs. @param references tables of time and displacement.
/// @throws InputError.
JointPicture picture_of_joint(const std::string& joint, const std::vector<std::filesystem::path>& folders,
                              const std::vector<std::filesystem::path>& references);

/// Every measured joint of a run; none where the run has none.
std::vector<JointPicture> pictures_of_joints(const std::filesystem::path& folder);

}  // namespace rockslope
