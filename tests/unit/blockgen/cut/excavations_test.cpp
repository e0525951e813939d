#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blockgen/mesh/block_file.hpp"
#include "blockgen/mesh/measures.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::excavations_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string domain =
    "[domain]\noutline = [[0, 0], [10, 0], [10, 10], [0, 10]]\nblock_material = \"rock\"\n";

std::string excavation(const std::string& stage, const std::string& polygon,
                       const std::string& joint = "joint_material = \"cut\"\n") {
    return "[[excavation]]\nstage = " + stage + "\n" + joint + "shape = \"polygon\"\npolygon = " + polygon +
           "\n";
}

double area_of(const BlockMesh& mesh, const ExcavatedBlocks& blocks) {
    double sum = 0;
    for (const BlockIndex b : blocks.blocks) sum += block_area(mesh, b);
    return sum;
}

TEST(Excavations, AreCutAndWrittenWithTheirStage) {
    SlopeModel model = slope(domain + excavation("2", "[[4, 4], [6, 4], [6, 6], [4, 6]]"));
    add_trace(model, {{0, 5}, {10, 5}});
    const CutResult result = cut(model);
    EXPECT_EQ(result.report.blocks, 4U);
    EXPECT_TRUE(result.report.area_proved);
    ASSERT_EQ(result.mesh.excavations.size(), 1U);
    EXPECT_EQ(result.mesh.excavations[0].stage, 2);
    EXPECT_EQ(result.mesh.excavations[0].blocks.size(), 2U);
    EXPECT_DOUBLE_EQ(area_of(result.mesh, result.mesh.excavations[0]), 4);
    EXPECT_THAT(result.mesh.joint_materials, ElementsAre("joint", "cut"));

    const std::string text = block_file_text(result.mesh);
    EXPECT_EQ(text.substr(0, 9), "ddablk 2\n");
    EXPECT_EQ(parse_block_file(text, "x"), result.mesh);
    EXPECT_EQ(block_file_text(parse_block_file(text, "x")), text);
}

TEST(Excavations, OverlapBelongsToTheEarliestStage) {
    const SlopeModel model = slope(domain + excavation("3", "[[2, 2], [6, 2], [6, 6], [2, 6]]") +
                                   excavation("2", "[[4, 4], [8, 4], [8, 8], [4, 8]]"));
    const CutResult result = cut(model);
    EXPECT_EQ(result.report.blocks, 3U);
    ASSERT_EQ(result.mesh.excavations.size(), 2U);
    EXPECT_DOUBLE_EQ(area_of(result.mesh, result.mesh.excavations[0]), 12);
    EXPECT_DOUBLE_EQ(area_of(result.mesh, result.mesh.excavations[1]), 16);
}

TEST(Excavations, ATunnelWithAStageIsRockBeforeIt) {
    const std::string tunnel =
        "[[tunnel]]\nname = \"adit\"\nshape = \"circle\"\ncentre = [5, 5]\nradius = 2\n";
    EXPECT_EQ(cut(slope(domain + tunnel)).report.blocks, 1U);
    const CutResult staged = cut(slope(domain + tunnel + "stage = 4\njoint_material = \"cut\"\n"));
    EXPECT_EQ(staged.report.blocks, 2U);
    EXPECT_DOUBLE_EQ(staged.report.domain_area, 100);
    EXPECT_EQ(staged.mesh.excavations.at(0).name, "adit");
}

TEST(Excavations, SmallBlocksAreNotMergedAcrossTheirOutline) {
    SlopeModel model = slope(domain + excavation("2", "[[4, 0], [5, 0], [5, 0.1], [4, 0.1]]"));
    model.small_blocks = {SmallBlockPolicy::merge, 1, 0};
    EXPECT_EQ(cut(model).report.blocks, 2U);
}

TEST(Excavations, FileWithoutExcavationsHasVersionOne) {
    EXPECT_EQ(block_file_text(cut(rectangle(2, 1)).mesh).substr(0, 9), "ddablk 1\n");
}

TEST(Excavations, OutsideTheRockRemoveNothing) {
    const CutResult result = cut(slope(domain + excavation("2", "[[14, 4], [16, 4], [16, 6], [14, 6]]")));
    EXPECT_TRUE(result.mesh.excavations.empty());
    EXPECT_THAT(result.report.warnings, ElementsAre(HasSubstr("removes no rock")));
}

TEST(Excavations, InvalidExcavationsAreRejected) {
    const std::string polygon = "[[4, 4], [6, 4], [6, 6], [4, 6]]";
    for (const char* stage : {"0", "-1", "1.5", "\"two\""})
        EXPECT_THROW(slope(domain + excavation(stage, polygon)), InputError) << stage;
    EXPECT_THROW(slope(domain + "[[excavation]]\nshape = \"polygon\"\npolygon = " + polygon + "\n"),
                 InputError);
    EXPECT_THAT(error_of([&] { cut(slope(domain + excavation("2", polygon, ""))); }),
                HasSubstr("where no joint runs"));
}

TEST(Excavations, DamagedRecordsAreRefused) {
    const std::string text =
        block_file_text(cut(slope(domain + excavation("2", "[[4, 4], [6, 4], [6, 6], [4, 6]]"))).mesh);
    const std::size_t at = text.find("excavation \"");
    ASSERT_NE(at, std::string::npos);
    const auto with = [&](const std::string& record) {
        return error_of([&] { parse_block_file(text.substr(0, at) + record + "\nend\n", "x"); });
    };
    EXPECT_THAT(with("excavation e 0 1"), HasSubstr("stage 0"));
    EXPECT_THAT(with("excavation e 2 7"), HasSubstr("7"));
    EXPECT_THAT(with("excavation e 2 1 0"), HasSubstr("out of order"));
    EXPECT_THAT(with("excavation e 2 1 1"), HasSubstr("out of order"));
    EXPECT_THAT(with("bolt b m 0 0 0 1 1 1"), HasSubstr("out of place"));
    EXPECT_THAT(error_of([&] { parse_block_file("ddablk 1" + text.substr(8), "x"); }),
                HasSubstr("excavations"));
}

}  // namespace
}  // namespace rockslope::blockgen::excavations_test
