#include "dda/monitor/spring_resolution.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "dda/contact/typical_block.hpp"

namespace rockslope::dda {

namespace {

double frequency(double stiffness, const TypicalBlock& block) {
    return std::sqrt(stiffness / block.mass);
}

/// The fraction of its amplitude that a swing loses in a period.
double lost_per_period(const Stage& stage, double omega) {
    const double ratio = (stage.newmark_gamma - 0.5) * omega * stage.control.step / 2;
    return 1 - std::exp(-2 * std::numbers::pi * ratio);
}

SpringResolution resolution_of(const Model& model, const TypicalBlock& block, JointMaterialIndex m,
                               const Stage& stage) {
    const JointMaterial& material = model.joint_material_at(m);
    const double weight = block.mass * model.gravity.norm();
    const double of_law =
        shear_stiffness(material.law, fresh_history(material.law, true), weight, block.face);
    const double shear = material.shear_spring(model.shear_penalty, block.face, of_law);
    const double normal = material.normal_spring(model.normal_penalty, block.face).stiffness;
    const auto steps = [&](double omega) { return 2 * std::numbers::pi / omega / stage.control.step; };
    SpringResolution resolution;
    resolution.joint_material = m;
    resolution.shear_period_steps = steps(frequency(shear, block));
    resolution.normal_period_steps = steps(frequency(normal, block));
    resolution.swing = weight / shear;
    resolution.lost_per_period = lost_per_period(stage, frequency(shear, block));
    return resolution;
}

}  // namespace

std::vector<SpringResolution> spring_resolutions(const Model& model, std::span<const Stage> stages) {
    std::vector<SpringResolution> resolutions;
    const std::optional<TypicalBlock> block = typical_block(model);
    if (!block) return resolutions;
    for (std::size_t k = 0; k < stages.size(); ++k) {
        if (stages[k].is_static()) continue;
        for (const JointMaterialIndex m : model.joint_materials.indices()) {
            resolutions.push_back(resolution_of(model, *block, m, stages[k]));
            resolutions.back().stage = k;
        }
    }
    return resolutions;
}

bool loses_swing(const SpringResolution& resolution) {
    return resolution.lost_per_period > largest_lost_per_period && resolution.swing > least_swing;
}

double step_that_keeps_swing(const SpringResolution& resolution, const Stage& stage) {
    return stage.control.step * std::log1p(-largest_lost_per_period) /
           std::log1p(-resolution.lost_per_period);
}

}  // namespace rockslope::dda
