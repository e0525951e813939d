#include "dda/input/read_joint_laws.hpp"
#include "dda/input/read_materials.hpp"

namespace rockslope::dda {

namespace {

/// A residual angle that is not above the peak's.
double read_residual_angle(const ConfigTable& table, double peak) {
    return table.checked(
        "residual_friction_angle", read_friction_angle(table, "residual_friction_angle", peak),
        [peak](double v) { return v <= peak; }, "an angle up to 'friction_angle'");
}

}  // namespace

Weakening read_law(std::type_identity<Weakening>, const ConfigTable& table) {
    Weakening law;
    law.friction_angle = read_friction_angle(table, "friction_angle");
    law.residual_friction_angle = read_residual_angle(table, law.friction_angle);
    law.cohesion = not_negative(table, "cohesion", Dimension::stress, 0);
    law.residual_cohesion = table.checked(
        "residual_cohesion", not_negative(table, "residual_cohesion", Dimension::stress, 0),
        [&](double v) { return v <= law.cohesion; }, "a stress up to 'cohesion'");
    law.slip = positive(table, "weakening_slip", Dimension::length);
    law.exponential = table.choice("weakening", {"linear", "exponential"}, "linear") == "exponential";
    return law;
}

VelocityWeakening read_law(std::type_identity<VelocityWeakening>, const ConfigTable& table) {
    VelocityWeakening law;
    law.friction_angle = read_friction_angle(table, "friction_angle");
    law.residual_friction_angle = read_residual_angle(table, law.friction_angle);
    law.speed = positive(table, "weakening_speed", Dimension::velocity);
    if (table.choice("weakening", {"exponential", "logarithmic"}, "exponential") == "logarithmic")
        law.rate = positive(table, "weakening_rate", Dimension::none);
    return law;
}

ContinuouslyYielding read_law(std::type_identity<ContinuouslyYielding>, const ConfigTable& table) {
    ContinuouslyYielding law;
    law.friction_angle = read_friction_angle(table, "friction_angle");
    law.residual_friction_angle = read_residual_angle(table, law.friction_angle);
    law.roughness_length = positive(table, "roughness_length", Dimension::length);
    return law;
}

Bilinear read_law(std::type_identity<Bilinear>, const ConfigTable& table) {
    Bilinear law;
    law.friction_angle = read_friction_angle(table, "friction_angle");
    law.residual_friction_angle = read_residual_angle(table, law.friction_angle);
    law.transition_stress = not_negative(table, "transition_stress", Dimension::stress, 0);
    return law;
}

}  // namespace rockslope::dda
