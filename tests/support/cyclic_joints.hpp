#pragma once

#include <numbers>
#include <utility>
#include <vector>

#include "dda/joint/barton_bandis.hpp"  // IWYU pragma: export
#include "dda/joint/cyclic_barton_bandis.hpp"
#include "dda/joint/shear_test.hpp"

namespace rockslope::joint_tests {

/// Shear test of a joint of 0.1 m under constant stress. @param stress Pa. @param path turning points, mm.
/// @param increment m; the default gives one row for the start and one per turning point.
inline std::vector<dda::ShearTestRow> sheared(const dda::CyclicBartonBandis& law, double stress,
                                              std::vector<double> path, double increment = 1) {
    for (double& displacement : path) displacement *= 1e-3;
    dda::ShearTest test;
    test.material.law = law;
    test.length = 0.1;
    test.normal_stress = stress;
    test.path = std::move(path);
    test.increment = increment;
    return dda::run_shear_test(test);
}

/// The motion of the walls of an open joint, m.
inline dda::ContactMotion flight(double displacement) {
    dda::ContactMotion motion;
    motion.displacement = displacement;
    return motion;
}

/// A smooth joint that counts reversals: its strength is N tan 30 deg in both directions, whatever the wear.
inline dda::CyclicBartonBandis counting_joint() {
    dda::CyclicBartonBandis law;
    law.barton = {0, 100e6, std::numbers::pi / 6};
    law.peak_displacement = 0.1e-3;
    const dda::RoughnessTable wear = {{{0, 1}}};
    law.cycles = {{wear, wear, wear, wear}};
    law.unsigned_ratios = true;
    law.reversal_factor = 0.9;
    law.min_slip = 0.1e-3;
    return law;
}

/// The granite and the marble joint of Ma et al. (2017), Table 3.
inline dda::BartonStrength granite_strength() {
    return {12.8, 151e6, 34.6 * 0.017453292519943295};
}
inline dda::BartonStrength marble_strength() {
    return {12.9, 72e6, 38.3 * 0.017453292519943295};
}
constexpr double granite_peak = 1.25e-3, marble_peak = 0.3e-3;  ///< m

/// Both joints with Tables 4 to 7. The backward advance starts at the end of the forward return.
inline dda::CyclicBartonBandis granite() {
    dda::CyclicBartonBandis law;
    law.barton = granite_strength();
    law.peak_displacement = granite_peak;
    law.damage = 1;
    law.cycles = {
        {{{{0, 0}, {1, 1}, {2, 0.5}, {4, 0.3}, {8, 0.15}, {20, 0.15}}},
         {{{0, -0.4}, {1, -0.38}, {2, -0.3}, {4, -0.3}, {8, -0.3}, {20, -0.3}}},
         {{{0, -0.4}, {1, 0.5}, {2, 0.45}, {4, 0.4}, {8, 0.2}, {20, 0.15}}},
         {{{1, -0.4}, {2, -0.4}, {4, -0.3}, {8, -0.3}, {20, -0.3}}}},
        {{{{0, 0}, {1, 0.3}, {2, 0.3}, {4, 0.3}, {8, 0.3}, {20, 0.3}}},
         {{{0, -0.38}, {1, -0.3}, {2, -0.3}, {4, -0.3}, {8, -0.3}, {20, -0.3}}},
         {{{0, -0.38}, {1, 0.1}, {2, 0.3}, {4, 0.3}, {8, 0.3}, {20, 0.3}}},
         {{{1, -0.3}, {2, -0.3}, {4, -0.3}, {8, -0.3}, {20, -0.3}}}},
    };
    return law;
}
inline dda::CyclicBartonBandis marble() {
    dda::CyclicBartonBandis law;
    law.barton = marble_strength();
    law.peak_displacement = marble_peak;
    law.damage = 1;
    law.cycles = {
        {{{{0, 0}, {1, 1}, {2, 0.8}, {4, 0.7}, {8, 0.6}, {20, 0.35}, {80, 0}}},
         {{{0, 0}, {1, -0.1}, {2, -0.3}, {4, -0.55}, {8, -0.45}, {20, -0.45}, {80, -0.26}}},
         {{{0, 0}, {1, 0.2}, {2, 0.3}, {4, 0.55}, {8, 0.5}, {20, 0.35}, {80, 0.25}}},
         {{{1, -0.1}, {2, -0.2}, {4, -0.4}, {8, -0.4}, {20, -0.4}, {80, -0.4}}}},
        {{{{0, 0.11}, {1, 0.2}, {2, 0.25}, {4, 0.5}, {8, 0.45}, {20, 0.35}, {80, 0}}},
         {{{0, 0}, {1, -0.1}, {2, -0.1}, {4, -0.2}, {8, -0.35}, {20, -0.35}, {80, -0.25}}},
         {{{0, 0}, {1, 0}, {2, 0.1}, {4, 0.3}, {8, 0.4}, {20, 0.4}, {80, 0.3}}},
         {{{1, -0.1}, {2, -0.1}, {4, -0.2}, {8, -0.4}, {20, -0.45}, {80, -0.45}}}},
    };
    return law;
}
/// Joint J2 of Tables 9 and 10, with a factor of 0.9 per reversal.
inline dda::CyclicBartonBandis sliding_plane() {
    dda::CyclicBartonBandis law;
    law.barton = {3.98, 80e6, 1 * 0.017453292519943295};
    law.peak_displacement = 0.164;
    const dda::RoughnessTable wear = {{{0, 1}, {1, 1}, {2, 0.9}, {4, 0.7}, {8, 0.5}, {20, 0.2}}};
    law.cycles = {{wear, wear, wear, wear}};
    law.reversal_factor = 0.9;
    law.unsigned_ratios = true;
    return law;
}

/// Stress and dilation at the end of a quarter of a cycle of 15 mm, from an independent integration.
struct QuarterCycle {
    double stress;    ///< MPa
    double dilation;  ///< mm
};
/// At the start of the second cycle the joint is locked from the strength of its return to that of its
/// advance, over a distance p with tau(advance ratio at p) = tau(return ratio) + k p, and does not dilate
/// there: granite 2.07 um less than by its table, marble 1.26 um, mm. The published values of the second
/// cycle are higher by as much.
constexpr double granite_bridge = 2.07e-3, marble_bridge = 1.26e-3;
/// Two cycles each: granite under 1 MPa, marble under 0.5 MPa.
inline const std::vector<QuarterCycle> granite_quarters = {{.8036, 2.207},
                                                           {-.4336, -.018},
                                                           {-.8306, 2.036},
                                                           {.4337, -.309},
                                                           {.9314, 1.805 - granite_bridge},
                                                           {-.4453, -.426 - granite_bridge},
                                                           {-.9314, 1.449 - granite_bridge},
                                                           {.4929, -.757 - granite_bridge}};
inline const std::vector<QuarterCycle> marble_quarters = {{.4691, 2.840},
                                                          {-.3949, -.186},
                                                          {-.5297, 2.492},
                                                          {.3569, -.339},
                                                          {.4691, 1.973 - marble_bridge},
                                                          {-.3949, -.293 - marble_bridge},
                                                          {-.5562, 2.346 - marble_bridge},
                                                          {.3569, -.647 - marble_bridge}};

}  // namespace rockslope::joint_tests
