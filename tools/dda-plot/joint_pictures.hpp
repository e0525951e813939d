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

/// Draws one measured joint of several runs. @param references tables of time and displacement.
/// @throws InputError.
JointPicture picture_of_joint(const std::string& joint, const std::vector<std::filesystem::path>& folders,
                              const std::vector<std::filesystem::path>& references, const PageStyle& style);

/// Draws all measured joints of a run.
std::vector<JointPicture> pictures_of_joints(const std::filesystem::path& folder, const PageStyle& style);

}  // namespace rockslope
