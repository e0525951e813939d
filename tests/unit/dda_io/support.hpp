#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "blockgen/base/input_error.hpp"
#include "blockgen/mesh/block_file.hpp"

namespace io_test {

namespace fs = std::filesystem;

/// A folder of the test's own, removed at its end.
class Folder {
  public:
    Folder() {
        static int count = 0;
        path_ = fs::path(::testing::TempDir()) /
                ("dda_io_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
        fs::create_directories(path_);
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    fs::path operator/(const std::string& name) const { return path_ / name; }
    const fs::path& path() const { return path_; }
    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

  private:
    fs::path path_;
};

/// What an InputError says; "no error" when none was thrown.
template <class Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const blockgen::InputError& error) {
        return error.what();
    }
    return "no error";
}

/// The folder of real records, which are not part of the project: $DDA_SHARED/records or ../shared/records
/// beside the sources.
inline std::optional<fs::path> real_records() {
    if (const char* shared = std::getenv("DDA_SHARED")) return fs::path(shared) / "records";
    for (fs::path folder = fs::path(__FILE__).parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
        if (fs::exists(folder.parent_path() / "shared" / "records"))
            return folder.parent_path() / "shared" / "records";
    return std::nullopt;
}

/// A free block of 2 m x 1 m with its lower left corner at (1, 1) on a prescribed base of 4 m x 1 m, sharing
/// the vertices of their joint; a measured point at the block's top.
inline blockgen::BlockMesh two_block_mesh() {
    blockgen::BlockMesh mesh;
    mesh.vertices = {{0, 0}, {4, 0}, {4, 1}, {3, 1}, {1, 1}, {0, 1}, {3, 2}, {1, 2}};
    mesh.block_materials = {"rock"};
    mesh.joint_materials = {"bedding"};
    mesh.joints = {{"set"}};
    const blockgen::EdgeMark face, joint{0, 0};
    mesh.begin_block(0, blockgen::BlockMotion::prescribed, "base");
    mesh.add_ring(std::vector<std::int32_t>{0, 1, 2, 3, 4, 5},
                  std::vector<blockgen::EdgeMark>{face, face, face, joint, face, face});
    mesh.begin_block(0);
    mesh.add_ring(std::vector<std::int32_t>{4, 3, 6, 7},
                  std::vector<blockgen::EdgeMark>{joint, face, face, face});
    mesh.measured_points = {{"crest", 1, {2, 2}}};
    mesh.provenance = {"made by a test"};
    return mesh;
}

}  // namespace io_test
