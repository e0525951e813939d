#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rockslope {

/// What a run says of one measured joint, from where displacements last began to count anew, SI units. The
/// columns but the first two may be empty in a table of another origin.
struct JointHistory {
    std::string label;
    std::vector<double> time;                                   ///< s
    std::vector<double> displacement;                           ///< m, along the joint
    std::vector<double> dilation;                               ///< m
    std::vector<double> shear_stress, normal_stress, strength;  ///< Pa
    std::vector<double> reversals;                              ///< changes of slip direction
};

/// The measured joints of a table, a run's joints.csv. @throws InputError.
std::vector<std::string> measured_joints(const std::filesystem::path& table);

/// The history of one of them; without a name that of a table with the columns "time (s)" and
/// "displacement (m)" alone. A last line that is not finished yet is left out. @throws InputError
/// with file:line.
JointHistory read_joint_history(const std::filesystem::path& table, const std::string& joint,
                                std::string label);

}  // namespace rockslope
