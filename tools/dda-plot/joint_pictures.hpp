#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "blockgen/picture/canvas.hpp"

/// A measured joint and the picture of its histories.
struct JointPicture {
    std::string joint;
    blockgen::Canvas canvas;
};

/// One measured joint in several runs. @param references tables of time and displacement.
/// @throws blockgen::InputError.
JointPicture picture_of_joint(const std::string& joint, const std::vector<std::filesystem::path>& folders,
                              const std::vector<std::filesystem::path>& references);

/// Every measured joint of a run; none where the run has none.
std::vector<JointPicture> pictures_of_joints(const std::filesystem::path& folder);
