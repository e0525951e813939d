// Compares block counts with those of GEOS, which polygonizes in floating point.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "blockgen/cut/cut_blocks.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "common/geometry/polygon.hpp"
#include "peer/geos_blocks.hpp"
#include "peer/joint_families.hpp"
#include "support/external_data.hpp"

namespace rockslope::peer::count_test {
namespace {

using Case = std::pair<Family, double>;

class BlockCount : public testing::TestWithParam<Case> {};

TEST_P(BlockCount, EqualsThatOfGeos) {
    const auto [family, blocks] = GetParam();
    blockgen::SlopeModel model = family_slope(family, blocks);
    // The finest grid for this size: on the default grid three joints that cross within 1e-6 m meet in one
    // point.
    model.grid = 0x1p-30;
    const std::vector<blockgen::Trace> traces = traces_across_boundary(model);
    const blockgen::CutResult ours = blockgen::cut_blocks(model, traces);
    const std::vector<GeosBlock> theirs = geos_blocks(model.outline, traces);
    EXPECT_EQ(ours.mesh.block_count(), theirs.size());
    EXPECT_NEAR(static_cast<double>(theirs.size()), blocks, 0.2 * blocks);
    EXPECT_EQ(ours.report.domain_area, 1e4);
    double area = 0;
    for (const GeosBlock& block : theirs) area += block.area;
    EXPECT_NEAR(area, 1e4, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Families, BlockCount,
                         testing::Values(Case{Family::two_sets, 1e3}, Case{Family::two_sets, 1e4},
                                         Case{Family::two_sets, 1e5}, Case{Family::three_sets, 1e3},
                                         Case{Family::three_sets, 1e4}, Case{Family::three_sets, 1e5},
                                         Case{Family::ending_in_rock, 1e3}, Case{Family::ending_in_rock, 1e4},
                                         Case{Family::ending_in_rock, 1e5}),
                         [](const auto& test_case) {
                             std::string name = name_of(test_case.param.first);
                             for (char& c : name)
                                 if (c == ' ') c = '_';
                             return name + "_" + std::to_string(static_cast<int>(test_case.param.second));
                         });

// Digitised maps in UTM coordinates. When plain noding fails, GEOS closes gaps below 1e-12 of the largest
// coordinate, here 6.7e-6 m. A grid of 2^-17 m closes a gap of 6.2e-6 m in KB11; a grid of 2^-20 m does not.
TEST(Maps, HaveAsManyBlocksAsWithGeos) {
    const auto maps = external_data("joint-maps");
    if (!maps) GTEST_SKIP() << external_data_missing("joint-maps");
    for (const auto& [name, grid, fewer] :
         {std::tuple("KB11", 0x1p-20, 1u), std::tuple("KB11", 0x1p-17, 0u),
          std::tuple("Getaberget", 0x1p-20, 0u), std::tuple("Getaberget", 0x1p-17, 0u)}) {
        blockgen::SlopeModel model;
        model.block_material = "rock";
        model.grid = grid;
        model.outline = blockgen::read_outline_file(*maps / (std::string(name) + "_area.geojson"))[0][0];
        if (twice_signed_area(model.outline) < 0) std::reverse(model.outline.begin(), model.outline.end());
        model.traces =
            blockgen::read_trace_file(*maps / (std::string(name) + "_traces.geojson"), name, "joint");
        const blockgen::CutResult ours = blockgen::cut_blocks(model, model.traces);
        const std::vector<GeosBlock> theirs = geos_blocks(model.outline, model.traces);
        EXPECT_EQ(ours.mesh.block_count() + fewer, theirs.size()) << name << " on " << grid;
        double area = 0;
        for (const GeosBlock& block : theirs) area += block.area;
        EXPECT_NEAR(area, ours.report.domain_area, 2e-3) << name;
    }
}

}  // namespace
}  // namespace rockslope::peer::count_test
