#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "common/drawing/canvas.hpp"

namespace rockslope {

/// History of one measured joint, from the last reset of displacements to zero, SI units. Columns other than
/// time and displacement may be empty for a reference table.
struct JointHistory {
    std::string label;
    std::vector<double> time;                                   ///< s
    std::vector<double> displacement;                           ///< m, along the joint
    std::vector<double> dilation;                               ///< m
    std::vector<double> shear_stress, normal_stress, strength;  ///< Pa
    std::vector<double> reversals;                              ///< number of changes of slip direction
};

/// The names of the measured joints in a run's joints.csv. @throws InputError.
std::vector<std::string> measured_joints(const std::filesystem::path& table);

/// Reads the history of one measured joint. An empty name reads a reference table with the columns "time (s)"
/// and "displacement (m)". An incomplete last line is ignored. @throws InputError with file and line.
JointHistory read_joint_history(const std::filesystem::path& table, const std::string& joint,
                                std::string label);

/// Draws a measured joint against time in one or several runs: displacement, dilation (if any), friction
/// angle atan(strength / normal stress), and number of changes of slip direction (if any). @param references
/// drawn dashed in black.
Canvas draw_joint_histories(const std::string& joint, std::span<const JointHistory> runs,
                            std::span<const JointHistory> references, const PageStyle& style = {});

}  // namespace rockslope
