#include <numbers>

#include "dda/input/read_joint_laws.hpp"
#include "dda/input/read_materials.hpp"

namespace rockslope::dda {

namespace {

double friction_angle(const ConfigTable& table, std::string_view key, double value) {
    return table.checked(
        key, value, [](double v) { return v >= 0 && v < std::numbers::pi / 2; },
        "an angle from 0 up to 90 deg (without it)");
}

}  // namespace

double read_friction_angle(const ConfigTable& table, std::string_view key) {
    return friction_angle(table, key, table.number(key, Dimension::angle));
}

double read_friction_angle(const ConfigTable& table, std::string_view key, double fallback) {
    return friction_angle(table, key, table.number(key, Dimension::angle, fallback));
}

MohrCoulomb read_law(std::type_identity<MohrCoulomb>, const ConfigTable& table) {
    MohrCoulomb law;
    law.friction_angle = read_friction_angle(table, "friction_angle");
    law.cohesion = not_negative(table, "cohesion", Dimension::stress, 0);
    law.tensile_strength = not_negative(table, "tensile_strength", Dimension::stress, 0);
    law.residual_friction_angle = read_friction_angle(table, "residual_friction_angle", law.friction_angle);
    law.residual_cohesion = not_negative(table, "residual_cohesion", Dimension::stress, 0);
    return law;
}

Elastic read_law(std::type_identity<Elastic>, const ConfigTable&) {
    return {};
}

}  // namespace rockslope::dda
