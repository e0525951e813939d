#include "dda/joint/normal_closure.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockslope::normal_closure_test {
namespace {

using dda::NormalClosure;

constexpr NormalClosure curves[] = {{1e9, 0}, {5e10, 0}, {1e10, 2e-4}, {5e9, 1e-3}};
/// Into the straight end of the hyperbolas.
constexpr double forces[] = {1e-6, 1.0, 1e3, 1e5, 1e6, 5e6, 2e7, 3.97e8, 1.1e9};

// At half the largest closure the joint bears k V and is four times as stiff as at first.
TEST(NormalClosure, OfBandisIsAHyperbola) {
    const NormalClosure joint{1e10, 2e-4};
    EXPECT_NEAR(joint.force(1e-4), 2e6, 1e-8);
    EXPECT_NEAR(joint.tangent(2e6), 4e10, 1e-4);
    EXPECT_NEAR(joint.closure(1e8), 2e-4 * 50 / 51, 1e-15);
}

TEST(NormalClosure, InTensionIsLinear) {
    for (const NormalClosure& joint : curves) {
        EXPECT_EQ(joint.force(-1e-5), -1e-5 * joint.stiffness);
        EXPECT_EQ(joint.closure(-1e5), -1e5 / joint.stiffness);
        EXPECT_EQ(joint.tangent(-1e5), joint.stiffness);
        EXPECT_EQ(joint.energy(-1e5), 1e10 / 2 / joint.stiffness);
    }
}

// Rounding: the relative error of a closure near its largest grows by 1 + F/(k V), 200 at most.
TEST(NormalClosure, ClosureIsTheInverseOfForceAndGrowsWithIt) {
    for (const NormalClosure& joint : curves) {
        double last = 0;
        for (const double force : forces) {
            EXPECT_GT(joint.closure(force), last);
            last = joint.closure(force);
            EXPECT_NEAR(joint.force(last), force, 1e-13 * force);
        }
    }
}

// A central difference with a relative step of 1e-5 errs by 1e-10, and its rounding is another 1e-10 times
// the 200 from above.
TEST(NormalClosure, TangentIsTheDerivative) {
    for (const NormalClosure& joint : curves) {
        for (const double force : forces) {
            const double step = 1e-5 * force;
            const double closed = joint.closure(force + step) - joint.closure(force - step);
            EXPECT_NEAR(joint.tangent(force) * closed / (2 * step), 1, 5e-8) << force;
        }
    }
}

// Simpson's rule on 2000 parts of the closure. At a share s of the largest closure its error is some
// (1/2000)^4 / (1 - s)^5: below 1e-6 up to s = 0.9, which is 9 k V.
TEST(NormalClosure, EnergyIsTheWorkOfTheForce) {
    for (const NormalClosure& joint : curves) {
        for (const double force : forces) {
            if (!joint.is_linear() && force > 9 * joint.stiffness * joint.largest_closure) continue;
            const double whole = joint.closure(force);
            const int parts = 2000;
            double work = joint.force(whole);
            for (int k = 1; k < parts; ++k) work += (k % 2 == 1 ? 4 : 2) * joint.force(whole * k / parts);
            work *= whole / (3 * parts);
            EXPECT_NEAR(joint.energy(force), work, 1e-6 * work) << force;
        }
    }
}

// On the straight end the energy grows by the trapezium below it.
TEST(NormalClosure, EnergyGoesOnStraightAtTheEnd) {
    const NormalClosure joint{1e10, 2e-4};
    const double first = 4e8, second = 6e8;
    const double trapezium = (first + second) / 2 * (joint.closure(second) - joint.closure(first));
    EXPECT_NEAR(joint.energy(second) - joint.energy(first), trapezium, 1e-9 * trapezium);
}

}  // namespace
}  // namespace rockslope::normal_closure_test
