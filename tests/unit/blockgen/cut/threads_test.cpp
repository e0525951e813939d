#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "blockgen/mesh/block_file.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::threads_test {
namespace {

/// Several thousand blocks with slivers, a hole, a region and a tunnel, of traces that end in rock: islands
/// and pinches among them. With `edges` beyond 1e5 no plane sweep is used.
SlopeModel ending_in_rock(double spacing) {
    std::ostringstream text;
    text << "seed = 5\n[domain]\noutline = [[0, 0], [60, 0], [60, 20], [20, 40], [0, 40]]\n"
            "holes = [[[10, 10], [14, 10], [12, 14]]]\nblock_material = \"rock\"\n"
            "[[region]]\nname = \"top\"\nblock_material = \"weathered\"\njoint_material = \"contact\"\n"
            "polygon = [[-1, 30], [61, 30], [61, 41], [-1, 41]]\n"
            "[[tunnel]]\nshape = \"circle\"\ncentre = [40, 10]\nradius = 3\n";
    for (const int angle : {5, 65, 125})
        text << "[[joint_set]]\nname = \"" << angle << "\"\njoint_material = \"joint\"\nangle = \"" << angle
             << " deg\"\nspacing = " << spacing
             << "\ntrace_length = { law = \"exponential\", mean = " << 8 * spacing
             << " }\ngap = { law = \"exponential\", mean = " << 2 * spacing << " }\n";
    return slope(text.str());
}

CutResult cut_on(int threads, const SlopeModel& model, bool full_report = true) {
    CutOptions options;
    options.threads = threads;
    options.full_report = full_report;
    return cut_blocks(model, all_traces(model), options);
}

TEST(CutOnThreads, GivesTheBytesOfOneThread) {
    for (const double spacing : {0.7, 0.18}) {
        const SlopeModel model = ending_in_rock(spacing);
        const CutResult one = cut_on(1, model);
        EXPECT_GT(one.mesh.block_count(), 2000u);
        const std::string blocks = block_file_text(one.mesh), report = report_text(one.report);
        for (const int threads : {2, 3, 7}) {
            const CutResult more = cut_on(threads, model);
            EXPECT_EQ(block_file_text(more.mesh), blocks) << spacing << ' ' << threads;
            EXPECT_EQ(report_text(more.report), report) << spacing << ' ' << threads;
        }
    }
}

TEST(CutOnThreads, WithoutAFullReportGivesTheSameBlocksAndWarnings) {
    SlopeModel model = ending_in_rock(0.7);
    add_trace(model, {{70, 0}, {80, 0}}, "far");
    const CutResult full = cut_on(1, model), brief = cut_on(2, model, false);
    EXPECT_EQ(block_file_text(full.mesh), block_file_text(brief.mesh));
    EXPECT_EQ(full.report.warnings, brief.report.warnings);
    EXPECT_FALSE(brief.report.warnings.empty());
    EXPECT_EQ(full.report.sizes.d50, brief.report.sizes.d50);
    EXPECT_EQ(full.report.slivers, brief.report.slivers);
    EXPECT_TRUE(brief.report.area_proved);
    EXPECT_TRUE(brief.report.joints.empty());
    EXPECT_FALSE(full.report.joints.empty());
}

TEST(CutOnThreads, TellsItsPhasesInOrder) {
    std::vector<std::string> phases;
    CutOptions options;
    options.on_phase = [&](const char* phase) { phases.emplace_back(phase); };
    const SlopeModel model = rectangle(2, 1);
    cut_blocks(model, {}, options);
    EXPECT_EQ(phases, (std::vector<std::string>{"segments", "noding", "faces", "blocks", "edges", "rings",
                                                "network", "mesh", "checks"}));
}

TEST(BlockFile, IsWrittenOnThreadsAsItsText) {
    const SlopeModel model = ending_in_rock(0.4);
    const BlockMesh mesh = cut_on(1, model).mesh;
    const std::filesystem::path file =
        std::filesystem::path(testing::TempDir()) / "written_on_threads.blocks";
    for (const int threads : {1, 2, 5}) {
        write_block_file(file, mesh, ThreadPool(threads));
        std::ifstream stream(file, std::ios::binary);
        std::ostringstream bytes;
        bytes << stream.rdbuf();
        EXPECT_EQ(bytes.str(), block_file_text(mesh)) << threads;
    }
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace rockslope::blockgen::threads_test
