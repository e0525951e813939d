#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "dda/joint/shear_test.hpp"

namespace rockslope::joint_tests {

/// A rough joint under constant stress, computed from Eqs. (57), (60) and (61) independently of the joint
/// laws of the program. Ratios are mobilised over peak roughness, with wear.
struct ReferenceJoint {
    static constexpr double mm = 1e-3;  ///< m
    static constexpr double degree = 0.017453292519943295;

    double jrc;
    double jcs;       ///< MPa
    double friction;  ///< deg, residual
    double peak;      ///< mm, displacement
    double stress;    ///< MPa

    double roughness_angle(double ratio) const { return ratio * jrc * std::log10(jcs / stress) * degree; }
    /// Strength, Pa.
    double tau(double ratio) const {
        return 1e6 * stress * std::tan(friction * degree + roughness_angle(ratio));
    }
    /// Tangent of the dilation angle.
    double rate(double ratio) const { return std::tan(roughness_angle(ratio)); }
    /// Dilation over a displacement along which the ratio changes linearly, Eq. (61), in the unit of
    /// `displacement`.
    double opening(double from, double to, double displacement) const {
        const double a = roughness_angle(from), b = roughness_angle(to);
        return displacement * std::log(std::cos(a) / std::cos(b)) / (b - a);
    }
    /// Shear stiffness up to the peak, Pa/m.
    double shear_stiffness() const { return tau(1) / (peak * mm); }
    /// Elastic displacement from the forward to the backward strength, m.
    double reversal_displacement(double forward, double backward) const {
        return (tau(forward) + tau(backward)) / shear_stiffness();
    }
};

/// Table 3 of Ma et al. (2017).
inline ReferenceJoint reference_granite(double megapascals = 1) {
    return {12.8, 151, 34.6, 1.25, megapascals};
}
inline ReferenceJoint reference_marble() {
    return {12.9, 72, 38.3, 0.3, 0.5};
}

inline void expect_stress(const dda::ShearTestRow& row, double expected) {
    EXPECT_NEAR(row.shear_stress, expected, 1e-3);
}
/// Compares the increase of the dilation between two rows, m.
inline void expect_opening(const dda::ShearTestRow& from, const dda::ShearTestRow& to, double expected) {
    EXPECT_NEAR(to.dilation - from.dilation, expected, 1e-13);
}

}  // namespace rockslope::joint_tests
