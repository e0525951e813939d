#pragma once

#include <type_traits>

#include "common/config/config_table.hpp"
#include "dda/joint/joint_law.hpp"

namespace rockslope::dda {

// One reader per law of the list in joint_law.hpp, from its table [joint_material.NAME]; a law without one
// does not compile. They throw InputError with the place.

MohrCoulomb read_law(std::type_identity<MohrCoulomb>, const ConfigTable& table);
Elastic read_law(std::type_identity<Elastic>, const ConfigTable& table);
BartonBandis read_law(std::type_identity<BartonBandis>, const ConfigTable& table);
CyclicBartonBandis read_law(std::type_identity<CyclicBartonBandis>, const ConfigTable& table);
Weakening read_law(std::type_identity<Weakening>, const ConfigTable& table);
Bilinear read_law(std::type_identity<Bilinear>, const ConfigTable& table);
Plesha read_law(std::type_identity<Plesha>, const ConfigTable& table);
TwoOrderAsperities read_law(std::type_identity<TwoOrderAsperities>, const ConfigTable& table);
StressedAsperities read_law(std::type_identity<StressedAsperities>, const ConfigTable& table);
VelocityWeakening read_law(std::type_identity<VelocityWeakening>, const ConfigTable& table);
ContinuouslyYielding read_law(std::type_identity<ContinuouslyYielding>, const ConfigTable& table);

/// The angle of a key, rad. @throws InputError outside [0, 90 deg).
double read_friction_angle(const ConfigTable& table, std::string_view key);
double read_friction_angle(const ConfigTable& table, std::string_view key, double fallback);

}  // namespace rockslope::dda
