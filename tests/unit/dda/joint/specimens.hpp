#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "dda/joint/joint_law.hpp"  // IWYU pragma: keep, for the list of laws
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

inline std::vector<dda::BartonBandis> barton_bandis_specimens() {
    const dda::RoughnessTable softening = {{{0, 1}, {1, 1}, {2, 0.5}, {4, 0.3}}};
    return {{granite_strength(), 0, {}, false, 0},
            {granite_strength(), granite_peak, dda::barton_1985(), true, 1},
            {marble_strength(), marble_peak, softening, false, 2}};
}

inline std::vector<dda::CyclicBartonBandis> cyclic_specimens() {
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

template <class Law>
using Of = std::vector<Law>;

/// Joints of each law for the tests that walk the list of laws, one line for each law. Without its line the
/// tests do not compile.
inline const auto& all_specimens() {
    static const std::tuple all = {
        // clang-format off
        Of<dda::MohrCoulomb>{{30 * degree, 1e5, 5e4, 20 * degree, 1e4}, {30 * degree, 0, 0, 30 * degree, 0}, {}},
        Of<dda::Elastic>{{}},
        barton_bandis_specimens(),
        cyclic_specimens(),
        Of<dda::Weakening>{{35 * degree, 20 * degree, 2e5, 1e4, 5e-3, false}, {40 * degree, 25 * degree, 0, 0, 1e-3, true}, {30 * degree, 30 * degree, 0, 0, 1e-3, true}},
        Of<dda::Bilinear>{{50 * degree, 30 * degree, 2e6}, {50 * degree, 30 * degree, 0}},
        Of<dda::Plesha>{{30 * degree, 15 * degree, 2e-4}, {30 * degree, 15 * degree, 0}, {20 * degree, 25 * degree, 1e-3}},
        Of<dda::TwoOrderAsperities>{{30 * degree, 8 * degree, 1e-5, 12 * degree, 1e-3}},
        Of<dda::StressedAsperities>{{30 * degree, 15 * degree, 2e-4, 50e6, 1}, {30 * degree, 10 * degree, 1e-4, 100e6, 2}},
        Of<dda::VelocityWeakening>{{35 * degree, 20 * degree, 0.1, 0}, {35 * degree, 20 * degree, 1e-3, 0.02}},
        Of<dda::ContinuouslyYielding>{{45 * degree, 30 * degree, 2e-3}, {40 * degree, 25 * degree, 2e-2}, {30 * degree, 30 * degree, 1e-3}},
        // clang-format on
    };
    return all;
}

/// The specimens of one law.
template <class Law>
const std::vector<Law>& specimens() {
    return std::get<std::vector<Law>>(all_specimens());
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
