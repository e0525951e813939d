#include "dda/terms/springs.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"
#include "unit/dda/linear/dense.hpp"

namespace rockslope::springs_test {
namespace {

using namespace scene;

/// A corner of the upper block penetrates the top of the lower block by 0.01 m.
struct Touching {
    Scene s;
    dda::Contact contact;
    Touching() {
        s.box({0, 0}, 2, 1);
        s.block({{{.7, .99}, {1.5, 1.8}, {.1, 1.9}}});
        contact.corner = 4;
        contact.edge = 2;
        contact.corner_block = 1;
        contact.edge_block = 0;
    }
    dda::ContactSprings springs(const dda::RowMap& rows, const dda::MidStep& mid,
                                const std::vector<Vec6>& known) const {
        return dda::contact_springs(s.model, rows, mid, known, std::vector{contact}, ThreadPool(1))[0];
    }
};

const Vec6 lower = (Vec6() << .1, .2, .3, .01, .02, .03).finished();
const Vec6 upper = (Vec6() << -.4, .5, -.6, .07, -.08, .09).finished();

TEST(ContactSprings, MeasureTheRelativeDisplacementAtTheContactPoint) {
    const Touching t;
    const dda::BlockSystem blocks = dda::initial_block_system(t.s.model);
    const dda::MidStep mid{blocks.vertices, {}, {blocks.centroid(0), blocks.centroid(1)}};
    const dda::RowMap rows(t.s.model.motion);
    const auto spring = t.springs(rows, mid, {Vec6::Zero(), Vec6::Zero()});
    const Vec2 contact_point(.7, .995);
    const Vec2 relative = dda::displacement_matrix(contact_point - blocks.centroid(1)) * upper -
                          dda::displacement_matrix(contact_point - blocks.centroid(0)) * lower;
    const Vec6 d[] = {lower, upper};
    EXPECT_NEAR(spring.rows.measure(spring.normal, d), relative.y(), 1e-15);
    EXPECT_NEAR(spring.rows.measure(spring.shear, d), -relative.x(), 1e-15)
        << "the tangent of the top edge points to the left";
}

TEST(ContactSprings, AddNoForceAndNoMomentInTotal) {
    const Touching t;
    const dda::BlockSystem blocks = dda::initial_block_system(t.s.model);
    const dda::MidStep mid{blocks.vertices, {}, {blocks.centroid(0), blocks.centroid(1)}};
    const auto spring = t.springs(dda::RowMap(t.s.model.motion), mid, {Vec6::Zero(), Vec6::Zero()});
    for (const dda::RelativeMeasure& relative : {spring.normal, spring.shear}) {
        const Vec6 of_corner = spring.rows.gradient_first(relative);
        const Vec6 of_edge = spring.rows.gradient_second(relative);
        const Vec2 on_corner = of_corner.head<2>();
        const Vec2 on_edge = of_edge.head<2>();
        EXPECT_LT((on_corner + on_edge).norm(), 1e-15);
        const double moment = of_corner[2] + dda::cross(blocks.centroid(1), on_corner) + of_edge[2] +
                              dda::cross(blocks.centroid(0), on_edge);
        EXPECT_NEAR(moment, 0, 1e-14);
    }
}

TEST(ContactSprings, IncludeThePrescribedDisplacement) {
    Touching t;
    const dda::BlockSystem blocks = dda::initial_block_system(t.s.model);
    const dda::MidStep mid{blocks.vertices, {}, {blocks.centroid(0), blocks.centroid(1)}};
    const auto both = t.springs(dda::RowMap(t.s.model.motion), mid, {Vec6::Zero(), Vec6::Zero()});
    const Vec6 d[] = {lower, upper};
    t.s.model.motion[0] = dda::Motion::prescribed;
    const auto one = t.springs(dda::RowMap(t.s.model.motion), mid, {lower, Vec6::Zero()});
    EXPECT_NEAR(one.rows.measure(one.normal, std::vector<Vec6>{upper}), both.rows.measure(both.normal, d),
                1e-15);
    EXPECT_NEAR(one.rows.measure(one.shear, std::vector<Vec6>{upper}), both.rows.measure(both.shear, d),
                1e-15);
}

TEST(BlockPair, ForceDoesTheWorkOfItsMeasureInEitherOrder) {
    for (const auto& [first, second] :
         {std::pair(0, 2), std::pair(2, 0), std::pair(1, -1), std::pair(-1, 1)}) {
        const dda::BlockPair rows{first, second, {.3, -.7}, {-.4, .2}};
        const dda::RelativeMeasure relative{{.6, .8}, .5};
        std::vector<Vec6> force(3, Vec6::Zero());
        rows.add_force(relative, 7, force);
        // The work of a force in a displacement is the force times the change of the measure.
        const std::vector<Vec6> moved{lower, .3 * upper, lower - upper};
        double work = 0;
        for (std::size_t r = 0; r < 3; ++r) work += force[r].dot(moved[r]);
        EXPECT_NEAR(work, 7 * (rows.measure(relative, moved) - .5), 1e-13);
    }
}

}  // namespace
}  // namespace rockslope::springs_test
