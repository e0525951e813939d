#include "dda/joint/parameter_table.hpp"

#include <numbers>

namespace rockslope::dda {

namespace {

double check_friction_angle(const ParameterTable& table, std::string_view key, double value) {
    return table.checked(
        key, value, [](double v) { return v >= 0 && v < std::numbers::pi / 2; },
        "an angle from 0 up to 90 deg (without it)");
}

}  // namespace

double ParameterTable::friction_angle(std::string_view key) const {
    return check_friction_angle(*this, key, number(key, Quantity::angle));
}

double ParameterTable::friction_angle(std::string_view key, double fallback) const {
    return check_friction_angle(*this, key, number(key, Quantity::angle, fallback));
}

double ParameterTable::residual_friction_angle(double peak) const {
    return checked(
        "residual_friction_angle", friction_angle("residual_friction_angle", peak),
        [peak](double v) { return v <= peak; }, "an angle up to 'friction_angle'");
}

double ParameterTable::reduction_factor(std::string_view key) const {
    return checked(
        key, number(key, Quantity::number, 1), [](double v) { return v >= 0 && v <= 1; },
        "a factor from 0 to 1");
}

}  // namespace rockslope::dda
