#include "dda/trial/shear_energy.hpp"

#include <gtest/gtest.h>

namespace rockslope::shear_energy_test {
namespace {

using dda::LockedDilation;
using dda::ShearedContact;

constexpr double k = 2e6;  // N/m per metre

// Eq. (77): S = f + N t once the joint has slipped, so f = 5 kN - 0.2 * 10 kN.
TEST(ShearEnergy, IsThatOfTheSpringAlone) {
    const ShearedContact contact{5e3, 10e3, 1e-3, 1};
    EXPECT_DOUBLE_EQ(contact.spring_force({0.2, 0}), 3e3);
    EXPECT_DOUBLE_EQ(dda::shear_energy({0.2, 0}, contact, k), 3e3 * 3e3 / (2 * k));
    EXPECT_DOUBLE_EQ(dda::shear_energy({}, contact, k), 5e3 * 5e3 / (2 * k));
}

// Eq. (78): before the first slip f is counted from the reference force, and its dilation is stored, too.
TEST(ShearEnergy, StoresTheDilationOfAJointThatHasNotSlipped) {
    const ShearedContact contact{5e3, 10e3, 1e-3, 0.5};
    const LockedDilation fresh{0.2, 8e3};
    const double force = 5e3 - 0.2 * (10e3 - 4e3);
    EXPECT_DOUBLE_EQ(contact.spring_force(fresh), force);
    EXPECT_DOUBLE_EQ(dda::shear_energy(fresh, contact, k), force * force / (2 * k) - 4e3 * 1e-3);
}

// Two springs of a joint with the same displacement store what the joint's spring does; of another
// distribution of the same force the excess is (f1 k2 - f2 k1)^2 / (2 k1 k2 (k1 + k2)).
TEST(ShearEnergy, OfUnevenSpringsIsMoreThanThatOfTheJoint) {
    dda::SharedSpring even;
    even.add(2e3, k);
    even.add(6e3, 3 * k);
    EXPECT_NEAR(even.uneven(), 0, 1e-12);
    dda::SharedSpring uneven;
    uneven.add(6e3, k);
    uneven.add(2e3, 3 * k);
    const double moment = 6e3 * 3 * k - 2e3 * k;
    EXPECT_DOUBLE_EQ(uneven.uneven(), moment * moment / (2 * k * 3 * k * 4 * k));
    EXPECT_EQ(dda::SharedSpring().uneven(), 0);
}

}  // namespace
}  // namespace rockslope::shear_energy_test
