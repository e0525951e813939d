#pragma once

#include <type_traits>

#include "blockgen/config/config_table.hpp"
#include "dda/joint/joint_law.hpp"

namespace dda {

// One reader per law of the list in joint_law.hpp, from its table [joint_material.NAME]; a law without one
// does not compile. They throw blockgen::InputError with the place.

MohrCoulomb read_law(std::type_identity<MohrCoulomb>, const blockgen::ConfigTable& table);
Elastic read_law(std::type_identity<Elastic>, const blockgen::ConfigTable& table);
BartonBandis read_law(std::type_identity<BartonBandis>, const blockgen::ConfigTable& table);
CyclicBartonBandis read_law(std::type_identity<CyclicBartonBandis>, const blockgen::ConfigTable& table);
Weakening read_law(std::type_identity<Weakening>, const blockgen::ConfigTable& table);
Bilinear read_law(std::type_identity<Bilinear>, const blockgen::ConfigTable& table);
Plesha read_law(std::type_identity<Plesha>, const blockgen::ConfigTable& table);
TwoOrderAsperities read_law(std::type_identity<TwoOrderAsperities>, const blockgen::ConfigTable& table);
StressedAsperities read_law(std::type_identity<StressedAsperities>, const blockgen::ConfigTable& table);
VelocityWeakening read_law(std::type_identity<VelocityWeakening>, const blockgen::ConfigTable& table);
ContinuouslyYielding read_law(std::type_identity<ContinuouslyYielding>, const blockgen::ConfigTable& table);

/// The angle of a key, rad. @throws InputError outside [0, 90 deg).
double read_friction_angle(const blockgen::ConfigTable& table, std::string_view key);
double read_friction_angle(const blockgen::ConfigTable& table, std::string_view key, double fallback);

}  // namespace dda
