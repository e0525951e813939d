#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "dda/joint/shear_test.hpp"

namespace rockslope::joint_tests {

/// A rough joint under a constant stress, worked out from Eqs. (57), (60) and (61) and not by the engine's
/// laws. Ratios are of mobilised over peak roughness, wear included.
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
    /// What a way opens along which the ratio goes evenly from one value to another, Eq. (61).
    double opening(double from, double to, double displacement) const {
        const double a = roughness_angle(from), b = roughness_angle(to);
        return displacement * std::log(std::cos(a) / std::cos(b)) / (b - a);
    }
    /// Of the spring that leads to the peak, Pa/m.
    double shear_stiffness() const { return tau(1) / (peak * mm); }
    /// The way from a strength forward to one backward, m.
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
/// Dilation from one row to another.
inline void expect_opening(const dda::ShearTestRow& from, const dda::ShearTestRow& to, double expected) {
    EXPECT_NEAR(to.dilation - from.dilation, expected, 1e-13);
}

}  // namespace rockslope::joint_tests
