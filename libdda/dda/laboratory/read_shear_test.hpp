#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dda/joint/shear_test.hpp"

namespace rockslope::dda {

/// The input of a shear test and the files that it was read from.
struct ShearTestInput {
    ShearTest test;
    std::string material;                      ///< name of the joint material
    std::vector<std::filesystem::path> files;  ///< the model file and, if given, the table of the path
};

/// Reads a model file of joint-shear: [joint_material.*] as in a run, and [shear_test].
/// @param overrides key=value. @throws InputError, one line with the place and what was expected.
ShearTestInput read_shear_test(const std::filesystem::path& file,
                               const std::vector<std::string>& overrides = {});

/// A commented model file to start from.
std::string shear_test_template();

}  // namespace rockslope::dda
