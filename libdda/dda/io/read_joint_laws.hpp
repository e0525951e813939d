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

/// The angle of a key, rad. @throws InputError outside [0, 90 deg).
double read_friction_angle(const blockgen::ConfigTable& table, std::string_view key);
double read_friction_angle(const blockgen::ConfigTable& table, std::string_view key, double fallback);

}  // namespace dda
