#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "dda/joint/joint_law.hpp"
#include "support/cyclic_joints.hpp"

namespace rockslope::joint_tests {

constexpr double degree = 0.017453292519943295;

/// Whether the strength of a joint grows with the normal force. It does not where a joint slides down its own
/// roughness: the steeper the asperities, the smaller the resistance, and they flatten as the stress grows.
template <class Law>
bool strength_grows_with_normal_force(const Law&) {
    return true;
}
inline bool strength_grows_with_normal_force(const dda::CyclicBartonBandis& law) {
    return !law.asymmetric;
}

/// Joints of each law for the conformance test: one overload per law, or the test does not compile.
inline std::vector<dda::MohrCoulomb> specimens(std::type_identity<dda::MohrCoulomb>) {
    return {{30 * degree, 1e5, 5e4, 20 * degree, 1e4}, {30 * degree, 0, 0, 30 * degree, 0}, {}};
}

inline std::vector<dda::Elastic> specimens(std::type_identity<dda::Elastic>) {
    return {{}};
}

inline std::vector<dda::BartonBandis> specimens(std::type_identity<dda::BartonBandis>) {
    const dda::RoughnessTable softening = {{{0, 1}, {1, 1}, {2, 0.5}, {4, 0.3}}};
    return {{granite_strength(), 0, {}, false, 0},
            {granite_strength(), granite_peak, dda::barton_1985(), true, 1},
            {marble_strength(), marble_peak, softening, false, 2}};
}

inline std::vector<dda::CyclicBartonBandis> specimens(std::type_identity<dda::CyclicBartonBandis>) {
    dda::CyclicBartonBandis healing = granite(), floored = marble(), lopsided = sliding_plane();
    healing.heal = true;
    healing.further_cycle_factor = 0.8;
    floored.floor_dilation = true;
    floored.reversal_factor = 0.95;
    floored.damage = 2;
    lopsided.peak_displacement = 1e-3;
    lopsided.asymmetric = true;
    lopsided.min_slip = 0;
    return {granite(), marble(), sliding_plane(), healing, floored, lopsided};
}

inline std::vector<dda::Weakening> specimens(std::type_identity<dda::Weakening>) {
    return {{35 * degree, 20 * degree, 2e5, 1e4, 5e-3, false},
            {40 * degree, 25 * degree, 0, 0, 1e-3, true},
            {30 * degree, 30 * degree, 0, 0, 1e-3, true}};
}

inline std::vector<dda::Bilinear> specimens(std::type_identity<dda::Bilinear>) {
    return {{50 * degree, 30 * degree, 2e6}, {50 * degree, 30 * degree, 0}};
}

inline std::vector<dda::Plesha> specimens(std::type_identity<dda::Plesha>) {
    return {
        {30 * degree, 15 * degree, 2e-4}, {30 * degree, 15 * degree, 0}, {20 * degree, 25 * degree, 1e-3}};
}

inline std::vector<dda::TwoOrderAsperities> specimens(std::type_identity<dda::TwoOrderAsperities>) {
    return {{30 * degree, 8 * degree, 1e-5, 12 * degree, 1e-3}};
}

inline std::vector<dda::StressedAsperities> specimens(std::type_identity<dda::StressedAsperities>) {
    return {{30 * degree, 15 * degree, 2e-4, 50e6, 1}, {30 * degree, 10 * degree, 1e-4, 100e6, 2}};
}

inline std::vector<dda::VelocityWeakening> specimens(std::type_identity<dda::VelocityWeakening>) {
    return {{35 * degree, 20 * degree, 0.1, 0}, {35 * degree, 20 * degree, 1e-3, 0.02}};
}

inline std::vector<dda::ContinuouslyYielding> specimens(std::type_identity<dda::ContinuouslyYielding>) {
    return {
        {45 * degree, 30 * degree, 2e-3}, {40 * degree, 25 * degree, 2e-2}, {30 * degree, 30 * degree, 1e-3}};
}

/// The laws of a list as the types of a typed test suite, and their names in it.
template <class List>
struct AsTypes;
template <class... Laws>
struct AsTypes<std::variant<Laws...>> {
    using type = testing::Types<Laws...>;
};
struct NameOfLaw {
    template <class Law>
    static std::string GetName(int) {
        return Law::name;
    }
};

}  // namespace rockslope::joint_tests
