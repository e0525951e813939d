#include <array>

#include "common/base/text.hpp"
#include "dda/input/read_joint_laws.hpp"
#include "dda/input/read_materials.hpp"
#include "dda/input/read_roughness_table.hpp"

namespace rockslope::dda {

BartonStrength read_barton_strength(const ConfigTable& table) {
    BartonStrength barton;
    barton.residual_friction_angle = table.checked(
        "residual_friction_angle", read_friction_angle(table, "residual_friction_angle"),
        [](double v) { return v <= BartonStrength::largest_angle; }, "at most 70 deg, Barton's limit");
    barton.roughness_coefficient = table.checked(
        "jrc", table.number("jrc"), [](double v) { return v >= 0 && v <= 20; },
        "a joint roughness coefficient from 0 to 20");
    barton.wall_strength = positive(table, "jcs", Dimension::stress);
    return barton;
}

double read_damage(const ConfigTable& table) {
    const double damage = not_negative(table, "damage", Dimension::none, 0);
    return table.checked(
        "damage", damage, [](double v) { return v == 0 || (v >= 1 && v <= 2); },
        "0 for no dilation, or a number from 1 to 2");
}

BartonBandis read_law(std::type_identity<BartonBandis>, const ConfigTable& table) {
    BartonBandis law;
    law.barton = read_barton_strength(table);
    law.damage = read_damage(table);
    if (!table.has("peak_displacement")) return law;
    law.peak_displacement = positive(table, "peak_displacement", Dimension::length);
    const std::string preset = "barton-1985";
    law.from_zero_angle = !table.has("mobilisation") || table.is_string("mobilisation");
    if (law.from_zero_angle) {
        table.choice("mobilisation", {preset}, preset);
        law.mobilisation = barton_1985();
    } else {
        law.mobilisation = read_roughness_table(table, "mobilisation");
    }
    return law;
}

}  // namespace rockslope::dda
