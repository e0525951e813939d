#include "dda/monitor/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>

#include "dda/block/block_system.hpp"

namespace rockslope::dda {

namespace {

// Limits beyond what rock, soil and concrete have.
constexpr double softest = 1e6, stiffest = 1e13;   // Pa; blocks of models that are nearly rigid are stiff
constexpr double lightest = 500, heaviest = 8000;  // kg/m3
/// Friction angle beyond which no joint goes, and the right angle in rad, which is small as a number of
/// degrees.
constexpr double steepest_friction = 70, right_angle = M_PI / 2;  // deg, rad
constexpr double weakest_wall = 1e5, strongest_wall = 1e9;        // Pa, compressive strength of joint walls
/// Size of a block of median area over the height of the section: smaller blocks are rather in other units.
constexpr double smallest_size = 1e-3;
/// Area of a block over that of the median one below which it is a chip. blockgen merges blocks below 1e-4.
constexpr double smallest_share = 1e-5;
/// Part of the record's energy, the integral of the squared acceleration, that a stage may leave out.
constexpr double negligible_energy = 1e-3;

template <class... Values>
std::string sentence(const char* format, Values... values) {
    char text[400];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

void check_materials(const Model& model, std::vector<std::string>& warnings) {
    for (const BlockMaterial& material : model.block_materials) {
        const double stiffness = material.youngs_modulus;
        if (stiffness < softest || stiffness > stiffest)
            warnings.push_back(
                sentence("youngs_modulus of block material '%s' is %.3g Pa, which no rock has; "
                         "write the unit, as in \"20 GPa\"",
                         material.name.c_str(), stiffness));
        if (material.density < lightest || material.density > heaviest)
            warnings.push_back(
                sentence("density of block material '%s' is %.3g kg/m3, which no rock has; rock "
                         "has some 2600",
                         material.name.c_str(), material.density));
    }
}

/// The friction angle of a joint. @param angle rad; @param must_hold whether nothing else holds its blocks.
void check_friction(const std::string& material, double angle, bool must_hold,
                    std::vector<std::string>& warnings) {
    const double degrees = angle * 180 / M_PI;
    const std::string start = sentence("friction_angle of joint material '%s' is ", material.c_str());
    if (angle == 0 && must_hold)
        warnings.push_back(start + "0, and it has no cohesion: nothing holds blocks on it");
    else if (degrees > steepest_friction)
        warnings.push_back(start + sentence("%.4g deg, which no joint has", degrees));
    else if (angle > 0 && degrees < right_angle)
        warnings.push_back(start + sentence("%.4g deg; if radians are meant, write \"%.4g rad\": they are "
                                            "%.3g deg",
                                            degrees, degrees, degrees * 180 / M_PI));
}

/// Flat walls do not need their strength.
void check_wall(const std::string& material, const BartonStrength& barton,
                std::vector<std::string>& warnings) {
    const double strength = barton.wall_strength;
    if (barton.roughness_coefficient > 0 && (strength < weakest_wall || strength > strongest_wall))
        warnings.push_back(
            sentence("jcs of joint material '%s' is %.3g Pa, which no joint wall has; write the "
                     "unit, as in \"50 MPa\"",
                     material.c_str(), strength));
}

/// Joints with cohesion open where their shear strength ends, at the latest. Without it a tensile strength
/// glues blocks on purpose.
void check_tension(const std::string& material, const MohrCoulomb& law, std::vector<std::string>& warnings) {
    const double tangent = std::tan(law.friction_angle);
    if (tangent <= 0 || law.cohesion == 0 || law.tensile_strength * tangent <= law.cohesion * (1 + 1e-9))
        return;
    warnings.push_back(
        sentence("tensile_strength of joint material '%s' is %.3g Pa, more than cohesion over "
                 "tan(friction_angle), %.3g Pa, where its shear strength ends",
                 material.c_str(), law.tensile_strength, law.cohesion / tangent));
}

void check_joints(const Model& model, std::vector<std::string>& warnings) {
    for (const JointMaterial& material : model.joint_materials) {
        const bool must_hold = model.gravity != Vec2::Zero() && !has_cohesion(material.law);
        std::visit(
            [&](const auto& law) {
                if constexpr (requires { law.friction_angle; })
                    check_friction(material.name, law.friction_angle, must_hold, warnings);
                if constexpr (requires { law.barton; }) check_wall(material.name, law.barton, warnings);
            },
            material.law);
        if (const auto* law = std::get_if<MohrCoulomb>(&material.law))
            check_tension(material.name, *law, warnings);
    }
}

void check_median_size(const Model& model, double median_area, std::vector<std::string>& warnings) {
    double low = 1e300, high = -1e300;
    for (const Vec2& vertex : model.vertices) {
        low = std::min(low, vertex.y());
        high = std::max(high, vertex.y());
    }
    const double median = std::sqrt(median_area);
    if (median < smallest_size * (high - low))
        warnings.push_back(
            sentence("blocks of median size %.3g m fill a section %.3g m high; are the spacings "
                     "of the joints in m?",
                     median, high - low));
}

/// A chip that is squeezed between large blocks shoots away and rattles, and each of its impacts cuts steps.
void check_chips(const Model& model, const BlockSystem& blocks, double median_area,
                 std::vector<std::string>& warnings) {
    int chips = 0;
    BlockIndex smallest = BlockIndex::none();
    for (const BlockIndex b : model.blocks()) {
        const double area = blocks.moments[b].area;
        if (model.motion[b] != Motion::free || area >= smallest_share * median_area) continue;
        ++chips;
        if (!smallest.exists() || area < blocks.moments[smallest].area) smallest = b;
    }
    if (chips == 0) return;
    const AreaMoments& moments = blocks.moments[smallest];
    const Vec2 at = moments.centroid + model.origin;
    warnings.push_back(sentence(
        "%d block%s smaller than %g of the median one, the smallest is block %d at (%g, %g) with "
        "%.2g m2: a chip that is squeezed between large blocks rattles and takes many small steps; "
        "[small_blocks] of a slope model merges chips",
        chips, chips == 1 ? " is" : "s are", smallest_share, smallest.value(), at.x(), at.y(), moments.area));
}

void check_sizes(const Model& model, std::vector<std::string>& warnings) {
    std::vector<double> areas;
    const BlockSystem blocks = initial_block_system(model);
    for (const BlockIndex b : model.blocks())
        if (model.motion[b] == Motion::free) areas.push_back(blocks.moments[b].area);
    if (areas.empty()) return;
    const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
    std::nth_element(areas.begin(), middle, areas.end());
    check_median_size(model, *middle, warnings);
    check_chips(model, blocks, *middle, warnings);
}

/// A head of water that reaches none of the faces that it should wet.
void check_head(const Model& model, const HeadWater& water, std::vector<std::string>& warnings) {
    double lowest_face = std::numeric_limits<double>::infinity(), highest_head = -lowest_face;
    for (const EdgeIndex e : water.edges)
        for (const CornerIndex c : {start_of(e), model.topology.end_of(e)})
            lowest_face = std::min(lowest_face, model.vertices[c].y());
    for (const Vec2& point : water.head) highest_head = std::max(highest_head, point.y());
    if (highest_head < lowest_face)
        warnings.push_back(
            sentence("[[%s]]: the head is at y = %.6g m at most, below all faces that it should wet, which "
                     "begin at y = %.6g m; no water acts",
                     HeadWater::key, highest_head + model.origin.y(), lowest_face + model.origin.y()));
}

/// Energy of a table after a time over that of all of it: integrals of the squared acceleration.
double energy_after(const TimeTable& table, double time) {
    double all = 0, after = 0;
    for (std::size_t k = 1; k < table.times().size(); ++k) {
        const double part = std::pow(table.values()[k], 2) * (table.times()[k] - table.times()[k - 1]);
        all += part;
        if (table.times()[k] > time) after += part;
    }
    return all > 0 ? after / all : 0;
}

void check_record(const Stage& stage, const TimeTable& table, std::vector<std::string>& warnings) {
    if (table.times().size() < 3) return;
    double interval = table.times().back();
    for (std::size_t k = 1; k < table.times().size(); ++k)
        interval = std::min(interval, table.times()[k] - table.times()[k - 1]);
    if (stage.control.step > interval * (1 + 1e-6))
        warnings.push_back(
            sentence("stage '%s': steps of %.3g s are longer than those of the record, %.3g s, "
                     "and miss its peaks",
                     stage.name.c_str(), stage.control.step, interval));
    const double left_out = energy_after(table, stage.duration * (1 + 1e-9));
    if (left_out > negligible_energy)
        warnings.push_back(
            sentence("stage '%s' ends after %.6g s, the record after %.6g s: %.3g %% of its energy "
                     "is cut off; duration = \"record\" takes all of it",
                     stage.name.c_str(), stage.duration, table.times().back(), 100 * left_out));
}

}  // namespace

std::vector<std::string> implausible(const Model& model, const std::vector<Stage>& stages) {
    std::vector<std::string> warnings;
    check_materials(model, warnings);
    check_joints(model, warnings);
    check_sizes(model, warnings);
    for (const auto& load : model.loads)
        if (const auto* water = std::get_if<HeadWater>(&load)) check_head(model, *water, warnings);
    for (const Stage& stage : stages)
        for (const auto* motions : {&stage.base_motions, &stage.frame_motions})
            for (const BaseMotion& motion : *motions) {
                check_record(stage, motion.x, warnings);
                check_record(stage, motion.y, warnings);
            }
    return warnings;
}

}  // namespace rockslope::dda
