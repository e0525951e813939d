// Block counts beside those of GEOS, a polygonizer in floating point.
#include <gtest/gtest.h>

#include "blockgen/cut_blocks.hpp"
#include "peer/geos_blocks.hpp"
#include "peer/joint_families.hpp"

namespace peer {
namespace {

using Case = std::pair<Family, double>;

class BlockCount : public testing::TestWithParam<Case> {};

TEST_P(BlockCount, IsThatOfGeos) {
    const auto [family, blocks] = GetParam();
    blockgen::SlopeModel model = family_slope(family, blocks);
    // As fine as the size allows: on the default grid three joints that cross within 1e-6 m meet in one
    // point.
    model.grid = 0x1p-30;
    const std::vector<blockgen::Trace> traces = traces_across_rim(model);
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
                                         Case{Family::three_sets, 1e3}, Case{Family::three_sets, 1e4},
                                         Case{Family::ending_in_rock, 1e3},
                                         Case{Family::ending_in_rock, 1e4}),
                         [](const auto& test_case) {
                             std::string name = name_of(test_case.param.first);
                             for (char& c : name)
                                 if (c == ' ') c = '_';
                             return name + "_" + std::to_string(static_cast<int>(test_case.param.second));
                         });

}  // namespace
}  // namespace peer
