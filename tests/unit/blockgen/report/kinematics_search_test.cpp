// The modes of the kinematic screen against a search of all directions, and wedges by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "blockgen/mesh/measures.hpp"
#include "blockgen/report/kinematics.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::kinematics_search_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Result of a search of 3600 directions of movement. `margin` is the largest, over all directions d, of the
/// smallest d.n over the faces; it is negative for a tapered block.
struct Search {
    bool is_free = false;
    double margin = -1;
    double descent = -1;  ///< sine of the dip of the steepest admissible direction
    Point steepest;
};

Search search(const BlockMesh& mesh, BlockIndex block, double left_end, double right_end, double bottom) {
    std::vector<Point> inward;
    Search found;
    for (std::size_t r = 0; r < mesh.ring_count(block); ++r) {
        const Ring ring = ring_points(mesh, block, r);
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Point &p = ring[k], &q = ring[(k + 1) % ring.size()];
            const bool at_end = (p.x == left_end && q.x == left_end) ||
                                (p.x == right_end && q.x == right_end) || (p.y == bottom && q.y == bottom);
            if (mesh.ring_marks(block, r)[k] == EdgeMark{} && !at_end) {
                found.is_free = true;
                continue;
            }
            const double length = std::hypot(q.x - p.x, q.y - p.y);
            inward.push_back({-(q.y - p.y) / length, (q.x - p.x) / length});
        }
    }
    for (int k = 0; k < 3600; ++k) {
        const Point d{std::cos(k * degree / 10), std::sin(k * degree / 10)};
        double clearance = 1;
        for (const Point& n : inward) clearance = std::min(clearance, d.x * n.x + d.y * n.y);
        found.margin = std::max(found.margin, clearance);
        if (clearance < -1e-3 || -d.y < found.descent) continue;
        found.descent = -d.y;
        found.steepest = d;
    }
    return found;
}

TEST(Kinematics, ModesAgreeWithASearchOfAllDirections) {
    std::mt19937 random(3);
    const auto uniform = [&] { return static_cast<double>(random()) * 0x1p-32; };
    int count[6] = {};
    int safeties = 0;
    for (int round = 0; round < 80; ++round) {
        SlopeModel model = rectangle(1, 1);
        model.outline = {{0, 0}, {20, 0}, {20, 5}, {10, 15}, {0, 15}};
        model.kinematics = KinematicScreen{35 * degree};
        if (round % 3 == 0) model.tunnels.push_back({"t", {{6, 4}, {9, 4}, {9, 7}, {6, 7}}, {}});
        for (int k = 0; k < 7; ++k)
            add_trace(model,
                      {{22 * uniform() - 1, -1 + 3 * uniform()}, {22 * uniform() - 1, 14 + 3 * uniform()}});
        for (int k = 0; k < 3; ++k) add_trace(model, {{-1, 14 * uniform()}, {21, 14 * uniform()}});
        const CutResult result = cut(model, false);
        const KinematicReport& report = *result.report.kinematics;
        for (const BlockIndex b : result.mesh.blocks()) {
            const Search by_search = search(result.mesh, b, 0, 20, 0);
            const BlockMode mode = report.mode[b];
            // Skip blocks too near the limit for directions at steps of a tenth of a degree.
            if (std::abs(by_search.margin) < 5e-3) continue;
            ++count[static_cast<int>(mode)];
            if (!by_search.is_free) {
                EXPECT_EQ(mode, BlockMode::enclosed) << round << ' ' << b;
            } else if (by_search.margin < 0) {
                EXPECT_EQ(mode, BlockMode::tapered) << round << ' ' << b;
            } else if (by_search.descent < -5e-3) {
                EXPECT_EQ(mode, BlockMode::stable) << round << ' ' << b;
            } else if (by_search.descent > 5e-3) {
                ASSERT_GE(mode, BlockMode::falling) << round << ' ' << b;
                const auto key = std::find_if(report.blocks.begin(), report.blocks.end(),
                                              [&](const KeyBlock& k) { return k.block == b; });
                ASSERT_NE(key, report.blocks.end());
                EXPECT_EQ(key->mode, mode);
                EXPECT_NEAR(-key->direction.y, by_search.descent, 2e-3) << round << ' ' << b;
                if (by_search.descent > 0.999) continue;
                EXPECT_NE(mode, BlockMode::falling) << round << ' ' << b;
                // Friction of the weight's normal component against its driving component.
                const double safety = std::tan(35 * degree) * std::abs(key->direction.x) / -key->direction.y;
                if (key->factor_of_safety > 0) {
                    EXPECT_NEAR(key->factor_of_safety, safety, 1e-6 * safety);
                    ++safeties;
                }
            }
        }
    }
    for (const int mode : {0, 1, 2, 3, 4}) EXPECT_GT(count[mode], 5) << mode;
    EXPECT_GT(safeties, 5);
}

// A wedge at the foot of a face on a plane of dip beta, with a joint of dip delta behind it: the factor of
// safety is tan phi / tan beta for any delta. The mirror image gives the same to the left.
TEST(Kinematics, AWedgeOnAPlaneWithAJointBehind) {
    for (const double beta : {12.0, 25.0, 41.0})
        for (const double delta : {55.0, 70.0, 90.0, 110.0, 130.0})
            for (const double side : {1.0, -1.0}) {
                SlopeModel model = rectangle(1, 1);
                const auto at = [&](double x, double y) { return Point{side * x, y}; };
                model.outline = {at(0, 0), at(30, 0), at(30, 4), at(20, 20), at(0, 20)};
                if (side < 0) std::reverse(model.outline.begin(), model.outline.end());
                model.kinematics = KinematicScreen{33 * degree};
                const double t = std::tan(beta * degree), run = 16;  // along the plane, level
                const Point foot{29, 5.6}, back{foot.x - run, foot.y + run * t};
                const double up = 30 - back.y;
                add_trace(model, {at(foot.x + 2, foot.y - 2 * t), at(back.x, back.y)}, "plane");
                add_trace(model, {at(back.x, back.y), at(back.x - up / std::tan(delta * degree), 30)},
                          "back");
                const CutResult result = cut(model);
                ASSERT_EQ(result.report.kinematics->blocks.size(), 1u) << beta << ' ' << delta << ' ' << side;
                const KeyBlock& key = result.report.kinematics->blocks[0];
                EXPECT_EQ(key.mode, BlockMode::sliding);
                EXPECT_NEAR(key.factor_of_safety, std::tan(33 * degree) / t, 1e-5);
                EXPECT_NEAR(key.direction.x, side * std::cos(beta * degree), 1e-6);
                EXPECT_EQ(result.mesh.joints[key.joint].set, "plane");
            }
}

}  // namespace
}  // namespace rockslope::blockgen::kinematics_search_test
