#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace rockslope::blockgen {

/// A case that writes input files into a folder of its own.
class FileFolder : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// The path of a new file with these bytes.
    std::filesystem::path written(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    /// The same in quotes, as a model has it.
    std::string file(const std::string& name, const std::string& text) const {
        return "\"" + written(name, text).string() + "\"";
    }

    const std::filesystem::path folder_ =
        std::filesystem::path(testing::TempDir()) / ("blockgen_files_" + std::to_string(::getpid()));
};

}  // namespace rockslope::blockgen
