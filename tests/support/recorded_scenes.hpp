#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "support/step_recorder.hpp"
#include "support/walls.hpp"

namespace rockslope::recorded_step {

/// A small slope, and which step of its run is recorded.
struct RecordedScene {
    std::string name;
    scene::Scene slope;
    bool shaken = true;  ///< a shaken stage follows the static one, and the step is one of it
    double peak = 0;     ///< m/s2, of the shaking
    int most = 1000;     ///< iterations of the step, which is the first that took the most up to these
};

/// Blocks of 1 m in running bond on a base that dips at 20 degrees: 22 blocks.
inline scene::Scene inclined_wall() {
    scene::Scene slope = scene::running_bond_wall(5, 4, 4);
    const double dip = scene::radians(20);
    slope.model.gravity = scene::g * dda::Vec2(std::sin(dip), -std::cos(dip));
    return slope;
}

inline std::vector<RecordedScene> recorded_scenes() {
    using scene::Scene;
    std::vector<RecordedScene> scenes;
    scenes.push_back({"smooth-shaken", inclined_wall(), true, 3, 12});
    scenes.push_back({"hard-shaken", inclined_wall(), true, 8, 60});

    RecordedScene cohesive{"cohesive-settling", inclined_wall(), false};
    cohesive.slope.model.joint_materials[0].law = Scene::mohr_coulomb(15, 6e3, 2e3);
    scenes.push_back(cohesive);

    RecordedScene rough{"rough-shaken", inclined_wall(), true, 4, 60};
    rough.slope.model.joint_materials[0].law = dda::Plesha{{scene::radians(28), scene::radians(8), 1e-5}};
    scenes.push_back(rough);

    RecordedScene bolted{"bolted-shaken", inclined_wall(), true, 6};
    dda::Model& model = bolted.slope.model;
    const int base = bolted.slope.material_point(0, {1.5, -0.5});
    model.bolts.push_back({"anchor", bolted.slope.material_point(4, {3.5, 0.5}), base, 5e7, 2e4, 4e4});
    const int low = bolted.slope.material_point(7, {1, 1.5});
    model.bolts.push_back({"short", bolted.slope.material_point(13, {1.5, 2.5}), low, 2e7, 0, 1e4});
    scenes.push_back(bolted);
    return scenes;
}

/// Horizontal shaking of two frequencies, 0.6 s.
inline dda::TimeTable shaking(double peak) {
    std::vector<double> times, values;
    for (int k = 0; k <= 600; ++k) {
        const double t = 1e-3 * k;
        times.push_back(t);
        values.push_back(peak * (0.7 * std::sin(2 * std::numbers::pi * 4 * t) +
                                 0.3 * std::sin(2 * std::numbers::pi * 11 * t)));
    }
    return {times, values};
}

/// Runs the scene and records its step.
inline RecordedStep record(const RecordedScene& recorded) {
    scene::Simulation run(recorded.slope);
    const StepRecorder recorder(run.model);
    dda::State before = run.state;
    RecordedStep hardest;
    bool records = !recorded.shaken;
    const auto observe = [&](const dda::Stage& stage) {
        run.on_step = [&, stage](const dda::State& state, const dda::StepReport& report) {
            if (records && report.cuts == 0 && report.iterations > hardest.iterations) {
                const double begin = state.stage_steps > 1 ? before.stage_time : 0;
                dda::State start = before;
                start.stage_time = begin;
                const auto found = recorder.record(stage, start, state.stage_time - begin);
                if (found && found->iterations > hardest.iterations && found->iterations <= recorded.most)
                    hardest = *found;
            }
            before = state;
        };
    };
    dda::Stage settle;
    settle.name = "settle";
    settle.kind = dda::StageKind::static_equilibrium;
    settle.tolerance = 1e-4;
    observe(settle);
    run.run(settle);
    if (!recorded.shaken) return hardest;
    records = true;
    dda::Stage shake;
    shake.name = "shake";
    shake.duration = 0.6;
    shake.frame_motions.push_back({"", shaking(recorded.peak), {}});
    observe(shake);
    before = run.state;
    before.stage_time = 0;
    run.run(shake);
    return hardest;
}

}  // namespace rockslope::recorded_step
