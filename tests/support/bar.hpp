#pragma once

#include "support/scene.hpp"

namespace rockslope::scene {

/// A straight bar along x of equal blocks glued by elastic joints, so stiff that they take a thousandth of
/// the rock's give; without gravity and without damping of the strain modes. It begins at x = 0 and is
/// centred on y = 0. A bar that thin carries plane waves: its height is that of one block.
struct Bar {
    Scene s;
    int count;
    double block_length;  ///< m
    double height;        ///< m

    /// Joint stiffness times block length over E.
    static constexpr double glued = 1e3;
    static constexpr double free = 1e-3;

    /// @param shear of the joints, as the constants above. Blocks of uniform strain that are glued in shear
    /// must all spread alike, and a bar of them cannot have free sides.
    Bar(int blocks, double length, dda::Plane plane, double shear = free)
        : count(blocks), block_length(length), height(length) {
        const double unit = 10e9 / block_length;
        s.model.plane = plane;
        s.model.gravity.setZero();
        s.model.block_materials[0].damping_ratio = 0;
        s.model.joint_materials[0] = elastic_joint(glued * unit, shear * unit);
        for (int k = 0; k < count; ++k) s.box({k * block_length, -height / 2}, block_length, height);
    }

    double density() const { return s.model.block_materials[0].density; }
    /// Keeps all corners from moving along an axis: confined, or in pure shear.
    void hold(bool x, bool y) {
        for (int b = 0; b < count; ++b) {
            for (int corner = 4 * b; corner < 4 * b + 4; ++corner) {
                const int point = s.material_point(b, s.model.vertices[static_cast<std::size_t>(corner)]);
                s.model.fixed_points.push_back({point, x, y});
            }
        }
    }
    /// Pushes the left end with a traction, Pa, times a history.
    void push(const Vec2& traction, const dda::TimeTable& history) {
        for (const double y : {-height / 2, height / 2})
            s.model.loads.push_back(
                dda::PointLoad{s.material_point(0, {0, y}), traction * height / 2, history});
    }
};

/// One raised cosine, (1 - cos(2 pi t / duration)) / 2, from `start` on.
inline dda::TimeTable raised_cosine(double duration, double start = 0) {
    std::vector<double> times;
    std::vector<double> values;
    constexpr int pieces = 200;
    for (int k = 0; k <= pieces; ++k) {
        times.push_back(start + duration * k / pieces);
        values.push_back((1 - std::cos(2 * std::numbers::pi * k / pieces)) / 2);
    }
    return {times, values};
}

/// Dynamic, by the average acceleration: it conserves energy, where the default would damp waves by
/// omega dt / 4, theory sec. 3.
inline dda::Stage wave_stage(double duration, double step) {
    dda::Stage stage;
    stage.name = "wave";
    stage.duration = duration;
    stage.control.step = step;
    stage.newmark_beta = 0.25;
    stage.newmark_gamma = 0.5;
    return stage;
}

/// Velocities of some blocks' centroids along one axis, step by step.
struct Seismogram {
    std::vector<double> times;
    std::vector<std::vector<double>> values;  ///< per station

    Seismogram(Simulation& sim, const std::vector<int>& stations, int axis) : values(stations.size()) {
        sim.on_step = [this, stations, axis](const dda::State& state, const dda::StepReport&) {
            times.push_back(state.stage_time);
            for (std::size_t k = 0; k < stations.size(); ++k)
                values[k].push_back(state.blocks.velocity[static_cast<std::size_t>(stations[k])][axis]);
        };
    }
    Seismogram(const Seismogram&) = delete;
    Seismogram& operator=(const Seismogram&) = delete;

    double largest(std::size_t station) const {
        double result = 0;
        for (const double v : values[station]) result = std::max(result, std::abs(v));
        return result;
    }
    /// The instant about which the energy that passes a station is balanced, s.
    double arrival(std::size_t station) const {
        double moment = 0;
        double sum = 0;
        for (std::size_t k = 0; k < times.size(); ++k) {
            const double energy = values[station][k] * values[station][k];
            moment += times[k] * energy;
            sum += energy;
        }
        return moment / sum;
    }
};

}  // namespace rockslope::scene
