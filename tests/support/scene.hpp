#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "dda/analysis/run.hpp"
#include "dda/analysis/step.hpp"  // IWYU pragma: export
#include "support/energy_monitor.hpp"

namespace rockslope::scene {

using dda::Vec2;
using dda::Vec6;

inline constexpr double g = 9.81;
inline double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

/// A joint that neither opens nor slips, with normal and shear stiffness in Pa/m.
inline dda::JointMaterial elastic_joint(double normal, double shear) {
    return {"joint", dda::Elastic{}, 0, 0, normal, shear};
}

/// Builds small models from polygons. By default there is one joint material, the rock of the catalogue (2500
/// kg/m3, 10 GPa, 0.25) and its penalty (5e10 N/m).
class Scene {
  public:
    Scene() {
        model.block_materials.push_back({"rock", 2500, 10e9, 0.25, 0.1, dda::Vec3::Zero()});
        model.joint_materials.push_back({"joint", mohr_coulomb(0), 0, 0});
        model.normal_penalty = model.shear_penalty = 5e10;
        model.fixed_point_penalty = 5e11;
        model.gravity = {0, -g};
    }

    static dda::MohrCoulomb mohr_coulomb(double friction_degrees, double cohesion = 0, double tensile = 0) {
        const double phi = radians(friction_degrees);
        return {phi, cohesion, tensile, phi, 0};
    }
    void friction(double degrees) { model.joint_materials[0].law = mohr_coulomb(degrees); }

    /// Adds a block from its outer ring, counter-clockwise, and holes, clockwise. @return its index.
    int block(const std::vector<std::vector<Vec2>>& rings, dda::Motion motion = dda::Motion::free,
              const std::string& name = {}) {
        std::vector<int> sizes;
        for (const auto& ring : rings) {
            sizes.push_back(static_cast<int>(ring.size()));
            model.vertices.insert(model.vertices.end(), ring.begin(), ring.end());
        }
        model.topology.add_block(sizes);
        model.block_material.push_back(0);
        model.motion.push_back(motion);
        model.block_name.push_back(name);
        return model.block_count() - 1;
    }
    /// A rectangle with its lower left corner at `corner` and its base along `angle` (rad).
    int box(const Vec2& corner, double width, double height, dda::Motion motion = dda::Motion::free,
            double angle = 0, const std::string& name = {}) {
        const Vec2 along(std::cos(angle), std::sin(angle));
        const Vec2 up = dda::perpendicular(along);
        return block(
            {{corner, corner + width * along, corner + width * along + height * up, corner + height * up}},
            motion, name);
    }
    int material_point(int block_index, const Vec2& position) {
        model.material_points.push_back({block_index, position});
        return static_cast<int>(model.material_points.size()) - 1;
    }

    dda::Model model;
};

/// Runs a scene stage by stage and stores the step reports.
class Simulation : public dda::RunObserver {
  public:
    explicit Simulation(const Scene& s, int thread_count = 1)
        : model(s.model), state(dda::initial_state(model)), threads(thread_count) {}

    /// Runs a stage after those that have been run.
    dda::RunOutcome run(const dda::Stage& stage) {
        first_report_ = reports.size();
        stages.push_back(stage);
        return dda::run(model, stages, state, *this, {threads, static_cast<int>(stages.size()) - 1, false});
    }
    /// Runs a static stage.
    dda::RunOutcome settle(double step = 0.005, double tolerance = 1e-9) {
        dda::Stage stage;
        stage.name = "settle";
        stage.kind = dda::StageKind::static_equilibrium;
        stage.tolerance = tolerance;
        stage.control.step = step;
        return run(stage);
    }
    dda::RunOutcome shake(double duration, double step) {
        dda::Stage stage;
        stage.name = "dynamic";
        stage.duration = duration;
        stage.control.step = step;
        return run(stage);
    }

    /// One energy monitor observes consecutive dynamic stages.
    void stage_begins(const dda::Model&, const dda::State& s, const dda::Stage& stage, int) override {
        if (stage.is_static())
            energy.reset();
        else if (!energy)
            energy.emplace(s.energy);
    }
    bool step_done(const dda::Model&, const dda::State& s, const dda::Stage&,
                   const dda::StepReport& report) override {
        reports.push_back(report);
        if (energy) energy->observe(s.energy);
        if (on_step) on_step(s, report);
        return true;
    }

    /// Restarts the energy ledger, after the test has changed the state.
    void restart_ledger() {
        state.energy = {};
        const ThreadPool one_thread;
        dda::Ledger(model, dda::RowMap(model.motion), one_thread).update_stored_energy(state, state.energy);
        state.energy.initial_stores = state.energy.stores();
        energy.reset();
    }
    Vec2 moved(int block) const {
        return state.blocks.moments[block].centroid - state.centroid_origin[block];
    }
    const Vec6& velocity(int block) const { return state.blocks.velocity[block]; }
    Vec6& velocity(int block) { return state.blocks.velocity[block]; }
    const dda::Vec3& stress(int block) const { return state.blocks.stress[block]; }
    /// Largest omega_contact * dt of the last run's steps.
    double contact_frequency_step() const {
        double largest = 0;
        for (std::size_t k = first_report_; k < reports.size(); ++k)
            largest = std::max(largest, reports[k].contact_frequency_step);
        return largest;
    }
    double mean_iterations() const {
        double sum = 0;
        for (const auto& report : reports) sum += report.iterations;
        return reports.empty() ? 0 : sum / static_cast<double>(reports.size());
    }

    const dda::Model model;
    dda::State state;
    int threads;
    std::vector<dda::Stage> stages;  ///< run so far
    std::vector<dda::StepReport> reports;
    std::optional<EnergyMonitor> energy;  ///< of the last consecutive dynamic stages
    std::function<void(const dda::State&, const dda::StepReport&)> on_step;

  private:
    std::size_t first_report_ = 0;
};

}  // namespace rockslope::scene
