#include "dda/solve/patch_path.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "support/random_patch.hpp"

namespace rockslope::patch_path_test {
namespace {

using namespace rockslope::dda;
using rockslope::random_patch::RandomPatch;

/// A block of mass 1 kg on a rigid plane, pressed by 100 N and pushed along the plane.
struct BlockOnPlane {
    BlockPair rows{RowIndex(0), RowIndex::none()};
    LimitedContact contact;
    BaseSystem base;
    std::vector<ContactSprings> springs = std::vector<ContactSprings>(1);
    RowContacts row_contacts;

    explicit BlockOnPlane(double push) {
        contact.rows = &rows;
        contact.opening = {0, 1};
        contact.shearing = {1, 0};
        contact.normal_stiffness = 1e6;
        contact.shear_stiffness = 4e5;
        contact.forward = contact.backward = {0, 0.5};
        base.stiffness.push_back(1e3 * Mat6::Identity());
        base.load.push_back(Vec6::Zero());
        base.load[RowIndex(0)].head<2>() << push, -100;
        springs[0].rows = rows;
        row_contacts.find(1, springs);
    }
    /// The displacement at the end of the path from no displacement, m.
    Vec6 found(bool& balanced, int& borders) {
        std::vector<Vec6> displacement{Vec6::Zero()};
        std::vector<ElasticForces> elastic{contact.elastic_at(displacement)};
        const std::vector<RowIndex> patch{RowIndex(0)};
        const PatchPath::Outcome outcome =
            PatchPath().follow({base, row_contacts, std::span(&contact, 1)}, patch, {displacement, elastic});
        balanced = outcome.balanced;
        borders = outcome.borders;
        return displacement[0];
    }
};

TEST(PatchPath, FindsBlockThatSticks) {
    BlockOnPlane block(30);
    bool balanced = false;
    int borders = 0;
    const Vec6 d = block.found(balanced, borders);
    EXPECT_TRUE(balanced);
    EXPECT_NEAR(d[1], -100 / (1e6 + 1e3), 1e-15);
    EXPECT_NEAR(d[0], 30 / (4e5 + 1e3), 1e-15);
}

TEST(PatchPath, FindsBlockThatSlides) {
    BlockOnPlane block(80);
    bool balanced = false;
    int borders = 0;
    const Vec6 d = block.found(balanced, borders);
    EXPECT_TRUE(balanced);
    const double normal = 1e6 * 100 / (1e6 + 1e3);
    EXPECT_NEAR(d[0], (80 - 0.5 * normal) / 1e3, 1e-12);
    EXPECT_GE(borders, 1);
}

/// Random blocks in contact, of which many slide or part on the way, from random displacements.
TEST(PatchPath, BalancesRandomPatches) {
    PatchPath path;
    int balanced = 0, begun_negative = 0;
    for (unsigned seed = 0; seed < 400; ++seed) {
        RandomPatch patch(seed);
        const std::vector<Vec6> start = patch.random_displacement();
        std::vector<Vec6> displacement = start;
        std::vector<ElasticForces> elastic = patch.elastic(displacement);
        const bool is_negative = patch.determinant_sign(displacement) < 0;
        const PatchPath::Outcome outcome = path.follow(patch.step(), patch.rows(), {displacement, elastic});
        if (!outcome.balanced) {
            for (std::size_t k = 0; k < start.size(); ++k)
                EXPECT_EQ(displacement[k], start[k]) << "stays as it was; seed " << seed;
            continue;
        }
        ++balanced;
        begun_negative += is_negative ? 1 : 0;
        EXPECT_LT(patch.unbalanced(displacement), 1e-6 * patch.load())
            << "rounding on the way; seed " << seed;
        const std::vector<ElasticForces> here = patch.elastic(displacement);
        for (std::size_t k = 0; k < elastic.size(); ++k) {
            EXPECT_NEAR(elastic[k].normal, here[k].normal, 1e-6 * patch.load());
            EXPECT_NEAR(elastic[k].shear, here[k].shear, 1e-6 * patch.load());
        }
    }
    EXPECT_GE(balanced, 392) << "a path may close on itself";
    EXPECT_GT(begun_negative, 2) << "against the direction of a positive determinant these would run away";
}

}  // namespace
}  // namespace rockslope::patch_path_test
