#pragma once

#include <type_traits>
#include <vector>

#include "dda/joint/joint_law.hpp"

namespace joint_tests {

constexpr double degree = 0.017453292519943295;

/// Joints of each law for the conformance test: one overload per law, or the test does not compile.
inline std::vector<dda::MohrCoulomb> specimens(std::type_identity<dda::MohrCoulomb>) {
    return {{30 * degree, 1e5, 5e4, 20 * degree, 1e4}, {30 * degree, 0, 0, 30 * degree, 0}, {}};
}

inline std::vector<dda::Elastic> specimens(std::type_identity<dda::Elastic>) {
    return {{}};
}

}  // namespace joint_tests
