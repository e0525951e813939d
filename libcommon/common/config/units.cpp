#include "common/config/units.hpp"

#include <numbers>
#include <span>

#include "common/base/degree.hpp"
#include "common/config/config_table.hpp"

namespace rockslope {

namespace {

struct Unit {
    std::string_view name;
    double factor;
};

constexpr double turn = 2 * std::numbers::pi;
constexpr double standard_gravity = 9.80665;  // m/s2, exact by definition

constexpr Unit lengths[] = {{"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"km", 1e3}};
constexpr Unit angles[] = {{"rad", 1}, {"deg", degree}};
constexpr Unit times[] = {{"s", 1}, {"ms", 1e-3}, {"min", 60}};
constexpr Unit mass_densities[] = {{"kg/m3", 1}, {"t/m3", 1e3}, {"g/cm3", 1e3}};
constexpr Unit stresses[] = {{"Pa", 1}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}};
constexpr Unit stiffnesses[] = {{"N/m", 1}, {"kN/m", 1e3}, {"MN/m", 1e6}, {"GN/m", 1e9},
                                {"Pa", 1},  {"kPa", 1e3},  {"MPa", 1e6},  {"GPa", 1e9}};
constexpr Unit joint_stiffnesses[] = {{"Pa/m", 1}, {"kPa/m", 1e3}, {"MPa/m", 1e6}, {"GPa/m", 1e9}};
constexpr Unit accelerations[] = {{"m/s2", 1}, {"cm/s2", 1e-2}, {"gal", 1e-2}, {"g", standard_gravity}};
constexpr Unit velocities[] = {{"m/s", 1}, {"cm/s", 1e-2}, {"mm/s", 1e-3}};
constexpr Unit forces[] = {{"N", 1}, {"kN", 1e3}, {"MN", 1e6}};
constexpr Unit frequencies[] = {{"Hz", 1}, {"rad/s", 1 / turn}};

struct Row {
    std::string_view noun;
    std::string_view example;
    std::span<const Unit> units;
};

/// The units of each dimension. The first one is the SI unit.
Row row(Dimension dimension) {
    switch (dimension) {
        case Dimension::none:
            return {"a number", "", {}};
        case Dimension::length:
            return {"a length", "5 mm", lengths};
        case Dimension::angle:
            return {"an angle with its unit", "35 deg", angles};
        case Dimension::time:
            return {"a time", "20 s", times};
        case Dimension::mass_density:
            return {"a density", "2600 kg/m3", mass_densities};
        case Dimension::stress:
            return {"a stress", "2.5 GPa", stresses};
        case Dimension::stiffness:
            return {"a stiffness", "50 GN/m", stiffnesses};
        case Dimension::joint_stiffness:
            return {"a stiffness of a joint", "20 GPa/m", joint_stiffnesses};
        case Dimension::acceleration:
            return {"an acceleration", "0.3 g", accelerations};
        case Dimension::velocity:
            return {"a velocity", "2 cm/s", velocities};
        case Dimension::force:
            return {"a force", "10 kN", forces};
        case Dimension::frequency:
            return {"a frequency", "2 Hz", frequencies};
    }
    return {"a number", "", {}};
}

}  // namespace

std::optional<double> unit_factor(Dimension dimension, std::string_view unit) {
    for (const Unit& candidate : row(dimension).units)
        if (candidate.name == unit) return candidate.factor;
    return std::nullopt;
}

std::string describe(Dimension dimension) {
    const Row entry = row(dimension);
    std::string text(entry.noun);
    if (entry.units.empty()) return text;
    text += " such as \"" + std::string(entry.example) + "\" (";
    for (const Unit& unit : entry.units)
        text += std::string(unit.name) + (&unit == &entry.units.back() ? ")" : ", ");
    return text;
}

}  // namespace rockslope
