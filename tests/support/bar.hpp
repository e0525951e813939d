#pragma once

#include "support/scene.hpp"

namespace rockslope::scene {

/// A straight bar of equal blocks along x, from x = 0, centred on y = 0, one block high. The joints are
/// elastic and add a thousandth to the compliance of the rock. No gravity, no damping of the strain modes.
/// The thin bar carries plane waves.
struct Bar {
    Scene s;
    int count;
    double block_length;  ///< m
    double height;        ///< m

    /// Joint stiffness times block length over E.
    static constexpr double glued = 1e3;
    static constexpr double free = 1e-3;

    /// @param shear stiffness of the joints, as the constants above. With joints glued in shear, blocks of
    /// uniform strain all have the same lateral strain, and the sides of the bar are not free.
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
    /// Fixes all corners along the given axes, for confinement or pure shear.
    void hold(bool x, bool y) {
        for (int b = 0; b < count; ++b) {
            for (int corner = 4 * b; corner < 4 * b + 4; ++corner) {
                const int point = s.material_point(b, s.model.vertices[corner]);
                s.model.fixed_points.push_back({point, x, y});
            }
        }
    }
    /// Loads the left end with a traction, Pa, times a history.
    void push(const Vec2& traction, const dda::TimeTable& history) {
        for (const double y : {-height / 2, height / 2})
            s.model.loads.push_back(
                dda::PointLoad{s.material_point(0, {0, y}), traction * height / 2, history});
    }
};

/// One raised cosine, (1 - cos(2 pi t / duration)) / 2, from the time `start`, s.
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

/// A dynamic stage with the average-acceleration method, which conserves energy. The default would damp waves
/// by omega dt / 4, theory section 3.
inline dda::Stage wave_stage(double duration, double step) {
    dda::Stage stage;
    stage.name = "wave";
    stage.duration = duration;
    stage.control.step = step;
    stage.newmark_beta = 0.25;
    stage.newmark_gamma = 0.5;
    return stage;
}

/// Records the velocities of the centroids of some blocks along one axis at every step.
struct Seismogram {
    std::vector<double> times;
    std::vector<std::vector<double>> values;  ///< per station

    Seismogram(Simulation& sim, const std::vector<int>& stations, int axis) : values(stations.size()) {
        sim.on_step = [this, stations, axis](const dda::State& state, const dda::StepReport&) {
            times.push_back(state.stage_time);
            for (std::size_t k = 0; k < stations.size(); ++k)
                values[k].push_back(state.blocks.velocity[stations[k]][axis]);
        };
    }
    Seismogram(const Seismogram&) = delete;
    Seismogram& operator=(const Seismogram&) = delete;

    double largest(std::size_t station) const {
        double result = 0;
        for (const double v : values[station]) result = std::max(result, std::abs(v));
        return result;
    }
    /// Mean arrival time of the energy at a station, s: centroid of the squared velocity over time.
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
