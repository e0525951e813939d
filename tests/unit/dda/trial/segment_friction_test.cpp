// When the laws of rough joint segments are evaluated again, compared with evaluating them every time.

#include "dda/trial/segment_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/rough_segments.hpp"

namespace rockslope::segment_friction_test {
namespace {

using dda::ContactLoading;
using dda::Strength;

struct SegmentFriction : testing::Test {
    scene::RandomSource random{23};
    scene::RoughSegments step{random, {2, 2, 1, 3, 2, 1}};
    dda::StepProblem problem = step.problem();
    ThreadPool pool;
    dda::SegmentFriction friction{problem, pool};
    std::vector<ContactLoading> loading;

    void SetUp() override {
        for (std::size_t k = 0; k < step.contacts.size(); ++k)
            loading.push_back({random.between(1e5, 1e6), random.between(-1e-3, 1e-3)});
        update(0);
    }
    auto of_index() const {
        return [this](std::size_t k) { return loading[k]; };
    }
    void update(double tolerance) { update_in(friction, tolerance); }
    void update_in(dda::SegmentFriction& of, double tolerance) const {
        of.update(tolerance, of_index(), [](std::size_t, const Strength&, const dda::Hardening&) {});
    }
    /// Shear bound over normal force of each contact. Lines that were not requested have no cohesion.
    std::vector<double> ratios_of(const dda::SegmentFriction& of) const {
        std::vector<double> found;
        for (std::size_t k = 0; k < loading.size(); ++k) {
            found.insert(found.end(), {of.line(k, true, 1).slope, of.line(k, false, 1).slope});
        }
        return found;
    }
    std::vector<double> ratios() const { return ratios_of(friction); }
    std::vector<double> freshly_evaluated() const {
        dda::SegmentFriction other(problem, pool);
        update_in(other, 0);
        return ratios_of(other);
    }
};

TEST_F(SegmentFriction, IsReusedAfterASmallChange) {
    const std::vector<double> before = ratios();
    for (ContactLoading& one : loading) one.normal += 10;
    update(31);  // three contacts at most
    EXPECT_EQ(ratios(), before);
    update(0);
    EXPECT_NE(ratios(), before);
    EXPECT_EQ(ratios(), freshly_evaluated());
}

TEST_F(SegmentFriction, IsReevaluatedAfterManySmallChanges) {
    const std::vector<double> before = ratios();
    for (int k = 0; k < 4; ++k) {
        for (ContactLoading& one : loading) one.normal += 10;
        update(31);
    }
    EXPECT_NE(ratios(), before);
}

TEST_F(SegmentFriction, IsReevaluatedAfterAShearDisplacement) {
    const std::vector<double> before = ratios();
    for (ContactLoading& one : loading) one.shearing -= 1e-3;  // 1e5 N and more
    update(1e4);
    EXPECT_NE(ratios(), before);
    EXPECT_EQ(ratios(), freshly_evaluated());
}

TEST_F(SegmentFriction, IsEvaluatedForSegmentsThatWereOpen) {
    const std::vector<ContactLoading> closed = loading;
    for (ContactLoading& one : loading) one.normal = -1;
    update(1e9);
    update(0);
    EXPECT_EQ(ratios(), std::vector<double>(ratios().size(), 0));
    loading = closed;
    update(1e9);
    EXPECT_EQ(ratios(), freshly_evaluated());
}

TEST_F(SegmentFriction, GivesEachContactTheBoundOfItsNormalForce) {
    std::vector<int> times(loading.size(), 0);
    friction.update(1e9, of_index(), [&](std::size_t k, const Strength& bounds, const dda::Hardening&) {
        ++times[k];
        EXPECT_EQ(bounds.forward, loading[k].normal * friction.line(k, true, 1).slope);
        EXPECT_EQ(bounds.backward, loading[k].normal * friction.line(k, false, 1).slope);
    });
    EXPECT_EQ(times, std::vector<int>(loading.size(), 1));
}

/// The roughness angle decreases with the normal force, so the tangent does not pass through zero. A power
/// law through the strengths at a force and at half of it explains most of the difference between tangent and
/// secant slopes; the curvature of the tangent leaves a fraction of 0.2.
TEST_F(SegmentFriction, ARequestedLineIsTangentToTheStrength) {
    const double aside = 0.01;
    dda::SegmentFriction more(problem, pool), less(problem, pool), lines(problem, pool);
    for (std::size_t k = 0; k < loading.size(); ++k) lines.request_line(k);
    lines.find_requested_lines(of_index());  // of segments that have not been evaluated
    const std::vector<ContactLoading> here = loading;
    for (ContactLoading& one : loading) one.normal = one.normal * (1 + aside);
    update_in(more, 0);
    loading = here;
    for (ContactLoading& one : loading) one.normal = one.normal * (1 - aside);
    update_in(less, 0);
    for (std::size_t k = 0; k < here.size(); ++k) {
        const double normal = here[k].normal;
        const dda::ShearLine line = lines.line(k, true, normal);
        const double ratio = friction.line(k, true, normal).slope;
        EXPECT_NEAR(line.slope * normal + line.cohesion, ratio * normal, 1e-12 * ratio * normal) << k;
        const double slope = ((1 + aside) * more.line(k, true, normal).slope -
                              (1 - aside) * less.line(k, true, normal).slope) /
                             (2 * aside);
        EXPECT_NEAR(line.slope, slope, 0.2 * std::abs(ratio - slope)) << k;
    }
}

}  // namespace
}  // namespace rockslope::segment_friction_test
