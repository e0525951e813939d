#include <numbers>

#include "dda/input/read_joint_laws.hpp"
#include "dda/input/read_materials.hpp"

namespace rockslope::dda {

namespace {

/// An asperity angle that, with all that it stands on, is below 90 deg.
double read_asperity_angle(const ConfigTable& table, const char* key, double below) {
    return table.checked(
        key, table.number(key, Dimension::angle),
        [below](double v) { return v >= 0 && v + below < std::numbers::pi / 2; },
        "an angle from 0 that leaves the sum with friction below 90 deg");
}

double read_wear(const ConfigTable& table, const char* key) {
    return not_negative(table, key, Dimension::none, 0);
}

}  // namespace

Plesha read_law(std::type_identity<Plesha>, const ConfigTable& table) {
    Plesha law;
    law.friction_angle = read_friction_angle(table, "friction_angle");
    law.asperity_angle = read_asperity_angle(table, "asperity_angle", law.friction_angle);
    law.wear = read_wear(table, "wear");
    return law;
}

TwoOrderAsperities read_law(std::type_identity<TwoOrderAsperities>, const ConfigTable& table) {
    TwoOrderAsperities law;
    law.friction_angle = read_friction_angle(table, "friction_angle");
    law.waviness_angle = read_asperity_angle(table, "waviness_angle", law.friction_angle);
    law.waviness_wear = read_wear(table, "waviness_wear");
    law.unevenness_angle =
        read_asperity_angle(table, "unevenness_angle", law.friction_angle + law.waviness_angle);
    law.unevenness_wear = read_wear(table, "unevenness_wear");
    return law;
}

StressedAsperities read_law(std::type_identity<StressedAsperities>, const ConfigTable& table) {
    StressedAsperities law;
    law.friction_angle = read_friction_angle(table, "friction_angle");
    law.asperity_angle = read_asperity_angle(table, "asperity_angle", law.friction_angle);
    law.wear = read_wear(table, "wear");
    law.wall_strength = positive(table, "wall_strength", Dimension::stress);
    law.exponent = positive(table, "exponent", Dimension::none, 1);
    return law;
}

}  // namespace rockslope::dda
