#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "blockgen/mesh/block_file.hpp"  // IWYU pragma: export
#include "support/error_of.hpp"

namespace rockslope::io_test {

namespace fs = std::filesystem;
using rockslope::error_of;

/// A temporary folder of a test, removed at its end.
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
    mesh.add_ring(std::vector<blockgen::VertexIndex>{0, 1, 2, 3, 4, 5},
                  std::vector<blockgen::EdgeMark>{face, face, face, joint, face, face});
    mesh.begin_block(0);
    mesh.add_ring(std::vector<blockgen::VertexIndex>{4, 3, 6, 7},
                  std::vector<blockgen::EdgeMark>{joint, face, face, face});
    mesh.measured_points = {{"crest", 1, {2, 2}}};
    mesh.provenance = {"made by a test"};
    return mesh;
}

/// Beginning of a model text for two_block_mesh(): the block file "two.blocks" and the rock.
inline std::string two_blocks_of_rock() {
    return R"(blocks = "two.blocks"
[block_material.rock]
density = 2500
youngs_modulus = "10 GPa"
poissons_ratio = 0.25
)";
}

/// The same with a Mohr-Coulomb joint. @param angle friction angle, such as "20 deg".
inline std::string two_blocks_with_friction(const std::string& angle) {
    return two_blocks_of_rock() + "[joint_material.bedding]\nlaw = \"mohr-coulomb\"\nfriction_angle = \"" +
           angle + "\"\n";
}

}  // namespace rockslope::io_test
