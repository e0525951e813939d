#include "dda/contact/find_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/scene.hpp"

namespace rockslope::find_contacts_test {
namespace {

using namespace scene;

/// A square on another, penetrating it by 0.1 mm, after the first step.
class FindContacts : public testing::Test {
  protected:
    FindContacts() {
        s.box({0, 0}, 1, 1);
        s.box({0, 1 - 1e-4}, 1, 1);
        s.friction(35);
        first = found(0, {}, true);
        for (dda::Contact& c : first.contacts) {
            c.state = dda::ContactState::locked;
            c.stress_free_gap = c.gap;
        }
    }
    dda::ContactSet found(double duration, const dda::ContactSet& last, bool first_step = false) const {
        const auto& vertices = s.model.vertices;
        return dda::find_contacts(s.model, last, {vertices, vertices, {}, .01, 1, 1e-9, duration, first_step},
                                  ThreadPool(1))
            .set;
    }

    Scene s;
    dda::ContactSet first;
};

TEST_F(FindContacts, TheStressFreeGapDecays) {
    ASSERT_FALSE(first.contacts.empty());
    for (const double duration : {0., 0.1}) {  // a static step has no duration
        const double decay = std::exp(-duration / 5);
        for (const dda::Contact& c : found(duration, first).contacts) {
            EXPECT_NEAR(c.gap, -1e-4, 1e-12);
            EXPECT_NEAR(c.stress_free_gap, -1e-4 * decay, 1e-12) << "in a step of " << duration << " s";
            EXPECT_EQ(c.normal_force > 0, duration > 0);
        }
    }
}

TEST_F(FindContacts, AnOpenContactInsideTheRockBearsNothing) {
    for (dda::Contact& c : first.contacts) c.state = dda::ContactState::open;
    for (const dda::Contact& c : found(.001, first).contacts) {
        EXPECT_EQ(c.stress_free_gap, c.gap);
        EXPECT_EQ(c.normal_force, 0);
    }
}

}  // namespace
}  // namespace rockslope::find_contacts_test
