#include "joint_pictures.hpp"

#include "joint_history.hpp"

namespace rockslope {

namespace fs = std::filesystem;

namespace {

/// Label of a run in a legend: the last folder of its path.
std::string label_of(const fs::path& folder) {
    const fs::path path = fs::absolute(folder).lexically_normal();
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace

JointPicture picture_of_joint(const std::string& joint, const std::vector<fs::path>& folders,
                              const std::vector<fs::path>& references, const PageStyle& style) {
    std::vector<JointHistory> runs, reference_histories;
    for (const fs::path& folder : folders)
        runs.push_back(read_joint_history(folder / "joints.csv", joint, label_of(folder)));
    for (const fs::path& file : references)
        reference_histories.push_back(read_joint_history(file, "", file.stem().string()));
    return {joint, draw_joint_histories(joint, runs, reference_histories, style)};
}

std::vector<JointPicture> pictures_of_joints(const fs::path& folder, const PageStyle& style) {
    std::vector<JointPicture> pictures;
    if (!fs::exists(folder / "joints.csv")) return pictures;
    for (const std::string& joint : measured_joints(folder / "joints.csv"))
        pictures.push_back(picture_of_joint(joint, {folder}, {}, style));
    return pictures;
}

}  // namespace rockslope
