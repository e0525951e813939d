#include "blockgen/mesh/block_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "blockgen/mesh/check_mesh.hpp"
#include "common/base/input_error.hpp"
#include "support/case_name.hpp"
#include "support/error_of.hpp"
#include "support/replaced.hpp"

namespace rockslope::blockgen::block_file_test {
namespace {

using testing::HasSubstr;

/// A unit square cut by one joint; the example of docs/formats/block-file.md.
constexpr const char* two_blocks = R"(ddablk 1
counts provenance 1 block_materials 1 joint_materials 1 joints 1 vertices 6 blocks 2 rings 2 corners 8 measured_points 1 bolts 0
provenance "blockgen 0.1.0"
block_material granite
joint_material bedding
joint bedding
vertex 0 0
vertex 1 0
vertex 1 0.5
vertex 0 0.5
vertex 1 1
vertex 0 1
block 0 1 fixed
ring 0 1 2 3
edges - - 0:0 -
block 0 1 free
ring 3 2 4 5
edges 0:0 - - -
measured_point crest 1 0.5 0.9
end
)";

std::string error_of(const std::string& text) {
    const std::string error = rockslope::error_of([&] { parse_block_file(text, "slope.blocks"); });
    EXPECT_EQ(error.find('\n'), std::string::npos);
    return error;
}

TEST(BlockFile, ReadsItsExample) {
    const BlockMesh mesh = parse_block_file(two_blocks, "slope.blocks");
    check_mesh(mesh, "slope.blocks");
    EXPECT_EQ(mesh.block_count(), 2u);
    EXPECT_EQ(mesh.motion[0], BlockMotion::fixed);
    EXPECT_EQ(mesh.ring_marks(0, 0)[2], (EdgeMark{0, 0}));
    EXPECT_EQ(mesh.measured_points[0].block, 1);
    EXPECT_EQ(block_file_text(mesh), two_blocks);
}

TEST(BlockFile, RoundTripKeepsEveryBitAndEveryName) {
    BlockMesh mesh;
    const double tiny = std::numeric_limits<double>::denorm_min();
    mesh.vertices = {
        {0.1, -0.0}, {466000.282228214303632, 6691582.099214151501656}, {tiny, 1e30}, {1.0 / 3, 2}};
    mesh.block_materials = {"", "gneiss \"grey\"", "Schiefer #2", "岩", "a\\b\n\tc\x01"};
    mesh.joint_materials = {"-", "ring"};
    mesh.joints = {{"Störung 1"}};
    mesh.provenance = {"blockgen 0.1.0", "seed 42"};
    const VertexIndex ring[] = {0, 1, 2, 3};
    const EdgeMark marks[] = {{}, {1, 0}, {0, EdgeMark::no_joint}, {}};
    mesh.begin_block(4, BlockMotion::prescribed, "the base");
    mesh.add_ring(ring, marks);
    mesh.add_ring(std::span(ring).first(3), std::span(marks).first(3));
    mesh.measured_points = {{"crest", 0, {0.1, 0.2}}};
    mesh.bolts = {{"b 1", "cable", 0, 0, {1, 2}, {3, 4}}};
    const std::string text = block_file_text(mesh);
    const BlockMesh again = parse_block_file(text, "x");
    EXPECT_EQ(again, mesh);
    EXPECT_TRUE(std::signbit(again.vertices[0].y));
    EXPECT_EQ(block_file_text(again), text);
}

TEST(BlockFile, CommentsBlankLinesAndCarriageReturnsAreSkipped) {
    std::string text = replaced(two_blocks, "vertex 1 0\n", "\n  # a comment\nvertex 1 0   # the toe\r\n");
    EXPECT_EQ(parse_block_file(text + "\n# after\n", "x"), parse_block_file(two_blocks, "x"));
    EXPECT_EQ(parse_block_file("\xEF\xBB\xBF" + text, "x"), parse_block_file(two_blocks, "x"))
        << "a byte order mark is skipped";
}

TEST(BlockFile, EveryTruncationIsAnError) {
    const std::string text = two_blocks;
    for (std::size_t length = 0; length + 1 < text.size(); ++length)
        EXPECT_THROW(parse_block_file(text.substr(0, length), "x"), InputError) << length;
    EXPECT_THAT(error_of(text.substr(0, text.find("measured_point crest"))), HasSubstr("truncated"));
}

TEST(BlockFile, NewerVersionIsRefusedByName) {
    const std::string error = error_of(replaced(two_blocks, "ddablk 1", "ddablk 4"));
    EXPECT_THAT(error, HasSubstr("slope.blocks:1:8"));
    EXPECT_THAT(error, HasSubstr("version 4"));
    EXPECT_THAT(error, HasSubstr("at most version 3"));
}

struct Damage {
    const char* from;
    const char* to;
    const char* place;
    const char* message;
};

class DamagedBlockFile : public testing::TestWithParam<Damage> {};

TEST_P(DamagedBlockFile, IsRefusedWithItsPlace) {
    const auto& [from, to, place, message] = GetParam();
    const std::string error = error_of(replaced(two_blocks, from, to));
    EXPECT_THAT(error, HasSubstr(std::string("slope.blocks:") + place));
    EXPECT_THAT(error, HasSubstr(message));
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedBlockFile,
    testing::Values(Damage{"ddablk", "ddablock", "1:1", "not a block file"},
                    Damage{"vertex 1 0.5", "vertex 1 nan", "9:10", "not a finite number"},
                    Damage{"vertex 1 0.5", "vertex 1 inf", "9:10", "not a finite number"},
                    Damage{"vertex 1 0.5", "vertex 1 1e999", "9:10", "not a finite number"},
                    Damage{"vertex 1 0.5", "vertex 1 -1.1e30", "9:10", "too large"},
                    Damage{"vertex 1 0.5", "vertex 1", "9:9", "ends early"},
                    Damage{"vertex 1 0.5", "vertex 1 0.5 7", "9:14", "one word too many"},
                    Damage{"vertex 1 1", "vertex 1 1\nvertex 2 2", "13:1", "out of place"},
                    Damage{"vertices 6", "vertices 7", "13:1", "out of place"},
                    Damage{"vertices 6", "vertices 2000000000", "2:75", "too short"},
                    Damage{"vertices 6", "vertices -6", "2:75", "out of range"},
                    Damage{"corners 8", "corners 9", "18", "8 corners"},
                    Damage{"rings 2", "rings 3", "18", "2 rings"},
                    Damage{"ring 0 1 2 3", "ring 0 1 2 6", "14:12", "out of range"},
                    Damage{"ring 0 1 2 3", "ring 0 1", "14", "fewer than three"},
                    Damage{"edges - - 0:0 -", "edges - - 0:0", "15", "3 edges"},
                    Damage{"edges - - 0:0 -", "edges - - 1:0 -", "15:11", "joint material"},
                    Damage{"edges - - 0:0 -", "edges - - 0:1 -", "15:11", "a joint"},
                    Damage{"edges - - 0:0 -", "edges - - 0 -", "15:11", "is not an edge mark"},
                    Damage{"block 0 1 fixed", "block 1 1 fixed", "13:7", "out of range"},
                    Damage{"block 0 1 fixed", "block 0 0 fixed", "13:9", "without a ring"},
                    Damage{"block 0 1 fixed", "block 0 1 frozen", "13:11", "not a motion"},
                    Damage{"crest 1 0.5", "crest 2 0.5", "19:22", "out of range"},
                    Damage{"\"blockgen 0.1.0\"", "\"blockgen", "3:12", "not closed"},
                    Damage{"\"blockgen 0.1.0\"", "\"\\q\"", "3:12", "escape"},
                    Damage{"granite", "\xff", "4:16", "UTF-8"},
                    Damage{"end\n", "end\nend\n", "21", "after the end"}),
    [](const auto& tested) { return case_name(std::to_string(tested.index) + " " + tested.param.message); });

TEST(BlockFile, MissingFileIsAnErrorThatNamesIt) {
    EXPECT_THAT(rockslope::error_of([] { read_block_file("no/such/file.blocks"); }),
                HasSubstr("no/such/file.blocks"));
    EXPECT_THROW(read_block_file("/"), InputError);
}

TEST(BlockFile, AHundredThousandBlocksReadFast) {
    BlockMesh mesh;
    const std::int32_t n = 316;
    for (std::int32_t i = 0; i <= n; ++i)
        for (std::int32_t j = 0; j <= n; ++j) mesh.vertices.push_back({j * 0.317 + 1e-3 * i, i * 0.291});
    mesh.block_materials = {"rock"};
    mesh.joint_materials = {"joint"};
    mesh.joints.resize(600, {"set"});
    for (std::int32_t i = 0; i < n; ++i)
        for (std::int32_t j = 0; j < n; ++j) {
            const std::int32_t v = i * (n + 1) + j;
            const VertexIndex ring[] = {v, v + 1, v + n + 2, v + n + 1};
            const EdgeMark marks[] = {{0, i}, {0, j}, {0, i}, {0, j}};
            mesh.begin_block(0);
            mesh.add_ring(ring, marks);
        }
    const std::string text = block_file_text(mesh);
    const auto start = std::chrono::steady_clock::now();
    const BlockMesh again = parse_block_file(text, "x");
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(again, mesh);
    RecordProperty("seconds", std::to_string(seconds.count()));
    // 0.05 s on an idle core in a release build; the limit allows for instrumented builds and busy machines.
    EXPECT_LT(seconds.count(), 5.0);
}

}  // namespace
}  // namespace rockslope::blockgen::block_file_test
