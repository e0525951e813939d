#include "dda/contact/inherited_penetration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/contact/undetected_penetration.hpp"
#include "support/scene.hpp"

namespace rockslope::inherited_penetration_test {
namespace {

using namespace scene;

/// The lowest corner of a block, 0.3 mm deep in the top of a box, has slid 70 um past the end of the top. The
/// corner of the box is now behind the next face of the block, which leans by a given angle.
struct SlidPast {
    Scene s;
    dda::Contact contact;

    SlidPast(double lean_degrees, double inherited_penetration) {
        s.box({-1, -1}, 1, 1);
        const Vec2 corner(7e-5, -3e-4);
        const double lean = radians(lean_degrees);
        s.block({{corner, corner + Vec2(.5, 1), corner + Vec2(-std::cos(lean), std::sin(lean))}});
        contact.corner = 4;
        contact.corner_block = 1;
        contact.edge = 2;
        contact.edge_block = 0;
        contact.normal = {0, 1};
        contact.gap = -3e-4;
        contact.inherited_penetration = inherited_penetration;
    }
    std::optional<double> depth() const {
        return dda::penetration_accounted_for(s.model.topology, s.model.vertices, contact);
    }
};

// In a slide, a face with a lean of 3.1 degrees was not accounted for, and the steps fell to nanoseconds.
TEST(InheritedPenetration, OfACornerPastTheEdgeEndIsThatOfTheEnd) {
    for (const double lean : {0., 3.5, 30.}) {
        const double depth = 3e-4 * std::cos(radians(lean)) - 7e-5 * std::sin(radians(lean));
        EXPECT_NEAR(SlidPast(lean, 3e-4).depth().value_or(0), depth, 1e-15) << lean;
    }
}

TEST(InheritedPenetration, IgnoresAFaceThatTurnsAway) {
    EXPECT_EQ(SlidPast(60, 3e-4).depth(), std::nullopt);
}

TEST(InheritedPenetration, IsAtMostTwiceTheInheritedPenetration) {
    EXPECT_EQ(SlidPast(3.5, 1e-4).depth(), std::nullopt);
}

// The corners of a joint that has contracted by 0.4 um penetrate by that depth without a force.
TEST(InheritedPenetration, OfAContractedJointIsAtLeastItsContraction) {
    Scene s;
    s.box({0, 0}, 2, 1);
    s.box({.5, 1 - 3e-7}, 1, 1);
    dda::Contact contact;
    contact.corner = 4;
    contact.corner_block = 1;
    contact.edge = 2;
    contact.edge_block = 0;
    contact.normal = {0, 1};
    contact.dilation = -4e-7;
    contact.gap = -3e-7 - contact.dilation;
    const auto penetration = [&] {
        return dda::InheritedPenetrations(s.model.topology, s.model.vertices, std::vector{contact}, 1e-3,
                                          ThreadPool(1))
            .in_block(4, 0);
    };
    EXPECT_DOUBLE_EQ(penetration(), 4e-7);
    contact.inhibited = true;
    EXPECT_EQ(penetration(), 0);
}

/// A block whose lower face leans by two thousandths overhangs the end of a box's top: its corner is
/// `overlap` from the end of the top, and `depth` behind it. The box's corner is the deeper in the block.
struct LeaningOverlap {
    Scene s;
    dda::Contact contact;
    static constexpr double sine = 2e-3;

    LeaningOverlap(double overlap, double depth) {
        s.box({0, 0}, 2, 1);
        const Vec2 corner(2 - overlap, 1 - depth);
        const Vec2 along(std::sqrt(1 - sine * sine), -sine);
        s.block({{corner, corner + 1.5 * along, corner + 1.5 * along + Vec2(0, 1), corner + Vec2(0, 1)}});
        contact.corner = 4;
        contact.corner_block = 1;
        contact.edge = 2;
        contact.edge_block = 0;
        contact.normal = {0, 1};
        contact.gap = -depth;
        contact.state = depth > 0 ? dda::ContactState::locked : dda::ContactState::open;
    }
    dda::InheritedPenetrations found() const {
        return {s.model.topology, s.model.vertices, std::vector{contact}, 0.1, ThreadPool(1)};
    }
};

// Blocks that slid off each other had one contact at such an overlap, and each step of a shaken slope was
// attempted three times for the corner at its other end.
TEST(InheritedPenetration, LeansAtTheOtherEndOfAShortOverlap) {
    const double lean = 1.5e-3 * LeaningOverlap::sine;
    const auto at_other_end = [](const LeaningOverlap& overlap) {
        const dda::InheritedPenetrations found = overlap.found();
        return std::pair(found.in_block(2, 1), found.lean_in_block(2, 1));
    };
    const auto [depth, deeper] = at_other_end({1.5e-3, 2e-6});
    EXPECT_NEAR(depth, 2e-6, 1e-15);
    EXPECT_NEAR(deeper, lean, 1e-11) << "the square of the lean";
    EXPECT_NEAR(at_other_end({1.5e-3, -1e-6}).second, lean, 1e-11) << "of an open contact";
    EXPECT_EQ(at_other_end({2.5e-3, 2e-6}).second, 0)
        << "more than a thousandth of the longer face has a contact at either end";
    LeaningOverlap inhibited(1.5e-3, -1e-6);
    inhibited.contact.inhibited = true;
    EXPECT_EQ(at_other_end(inhibited), std::pair(0.0, 0.0));
}

/// The block comes down on the box from 10 um above.
TEST(InheritedPenetration, OfAShortOverlapIsNoUndetectedOne) {
    const auto undetected = [](double overlap) {
        const LeaningOverlap before(overlap, -1e-5), after(overlap, 2e-6);
        const std::vector<dda::CornerEdge> candidates{{2, 4}, {4, 2}};
        return dda::find_undetected_penetrations(after.s.model,
                                                 {.before = before.s.model.vertices,
                                                  .after = after.s.model.vertices,
                                                  .candidates = candidates,
                                                  .contacts = std::vector{after.contact},
                                                  .search_radius = 0.1,
                                                  .tolerance = 1e-9,
                                                  .clip_depth = 1e-5},
                                                 ThreadPool(1))
            .size();
    };
    EXPECT_EQ(undetected(1.5e-3), 0U);
    EXPECT_EQ(undetected(2.5e-3), 1U) << "as deep as 7 um, with 2 um accounted for";
}

TEST(InheritedPenetration, IgnoresAnInhibitedContact) {
    SlidPast slid(3.5, 3e-4);
    slid.contact.inhibited = true;
    EXPECT_EQ(slid.depth(), std::nullopt);
}

}  // namespace
}  // namespace rockslope::inherited_penetration_test
