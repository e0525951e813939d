#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dda/joint/shear_test.hpp"

namespace rockslope::dda {

/// A shear test as read: what to do, and what was read.
struct ShearTestInput {
    ShearTest test;
    std::string material;                      ///< name of the joint material
    std::vector<std::filesystem::path> files;  ///< the model file, and the table of its path
};

/// Reads a model file of joint-shear: [joint_material.*] as in a run, and [shear_test].
/// @param overrides key=value. @throws InputError, one line with the place and the expectation.
ShearTestInput read_shear_test(const std::filesystem::path& file,
                               const std::vector<std::string>& overrides = {});

/// A commented model file to start from.
std::string shear_test_template();

}  // namespace rockslope::dda
