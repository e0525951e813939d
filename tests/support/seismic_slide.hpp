#pragma once

#include <cmath>

#include "support/cyclic_joints.hpp"
#include "support/scene.hpp"

namespace rockslope::scene {

/// The seismic sliding of Ma et al. (2017), Fig. 9: five bonded blocks of 50.2 m x 71.1 m side by side on a
/// plane of 2 degrees, whose joint wears with every reversal of slip.
struct SeismicSlide {
    dda::JointLaw plane = joint_tests::sliding_plane();
    double shear_penalty = 3e7;    ///< N/m per metre, of a contact on the plane; 0: that of the joint law
    double normal_penalty = 5e11;  ///< N/m per metre, of all contacts
    double amplitude = 0.28;       ///< m, of the base's displacement
    double frequency = 0.8;        ///< Hz
    double step = 0.005;           ///< s
    double youngs_modulus = 5e12;  ///< Pa; not in the paper: the reference is rigid
    /// s, times at which the joint of every block counts a reversal, in place of those of its slip; empty:
    /// the reversals of its slip count.
    std::vector<double> prescribed_reversals = {};

    std::vector<double> time;  ///< s
    std::vector<double> slip;  ///< m, of the third block down the plane, relative to the base
    int reversals = 0;         ///< of slip on the plane, below the third block
    dda::RunOutcome outcome;
    std::optional<EnergyMonitor> energy;  ///< of the dynamic stages
    double frequency_step = 0;

    void run(double duration);

    double at(double t) const {
        const auto after = std::lower_bound(time.begin(), time.end(), t - 1e-9);
        return slip.at(static_cast<std::size_t>(after - time.begin()));
    }

  private:
    static constexpr double width = 50.2, height = 71.1;  ///< m
    static constexpr int count = 5;

    Scene scene(const dda::JointLaw& law) const;
    double acceleration(double t) const;
    dda::TimeTable record(double from, double to) const;
    void preload_joint(dda::State& state) const;
    void count_reversal(dda::State& state) const;
};

inline Scene SeismicSlide::scene(const dda::JointLaw& law) const {
    const double angle = -radians(2);
    const Vec2 along(std::cos(angle), std::sin(angle));
    Scene s;
    s.model.block_materials[0].density = 2000;
    s.model.block_materials[0].youngs_modulus = youngs_modulus;
    s.model.normal_penalty = s.model.shear_penalty = normal_penalty;
    s.model.joint_materials[0] = {"J2", law, 0, shear_penalty};
    s.model.joint_materials.push_back({"J1", Scene::mohr_coulomb(20, 0, 10e6), 0, 0});
    s.box(-20 * dda::perpendicular(along) - 40 * along, count * width + 120, 20, dda::Motion::prescribed,
          angle, "base");
    s.model.topology.joint_material.assign(4, 0);
    for (int k = 0; k < count; ++k) {
        const int block = s.box(k * width * along, width, height, dda::Motion::free, angle);
        const dda::EdgeIndex first = edge_from(s.model.topology.block_corners[block]);
        s.model.topology.joint_material[first] = 0;
        if (k + 1 < count) s.model.topology.joint_material[first + 1] = 1;
        if (k > 0) s.model.topology.joint_material[first + 3] = 1;
    }
    return s;
}

/// The second derivative of u = amplitude E(t) sin(2 pi f t), E = (t/9)^4 exp(4 (1 - t/9)), m/s2.
inline double SeismicSlide::acceleration(double t) const {
    if (t <= 0) return 0;
    const double envelope = std::pow(t / 9, 4) * std::exp(4 * (1 - t / 9));
    const double growth = 4 / t - 4.0 / 9;
    const double w = 2 * std::numbers::pi * frequency;
    return amplitude * envelope *
           ((growth * growth - 4 / (t * t) - w * w) * std::sin(w * t) + 2 * growth * w * std::cos(w * t));
}

/// Base acceleration of a stage between two times of the shaking.
inline dda::TimeTable SeismicSlide::record(double from, double to) const {
    std::vector<double> times, values;
    for (int k = 0; k * 1e-3 <= to - from + 1e-9; ++k) {
        times.push_back(k * 1e-3);
        values.push_back(acceleration(from + times.back()));
    }
    return {times, values};
}

/// Gives the joint on the plane the history of a joint that bears the blocks and has not slipped.
inline void SeismicSlide::preload_joint(dda::State& state) const {
    const auto above = [](const dda::Contact& c) { return std::max(c.corner_block, c.edge_block); };
    for (dda::Contact& contact : state.contacts.contacts) {
        if (contact.joint_material != 0) continue;
        dda::ContactMotion preload;
        for (const dda::Contact& other : state.contacts.contacts) {
            if (other.joint_material != 0 || above(other) != above(contact)) continue;
            preload.normal_force += other.normal_force;
            preload.length += other.length;
        }
        contact.history = dda::advance(plane, dda::fresh_history(plane, true), preload);
    }
}

inline void SeismicSlide::count_reversal(dda::State& state) const {
    const double factor = std::get<dda::CyclicBartonBandis>(plane).reversal_factor;
    for (dda::Contact& contact : state.contacts.contacts) {
        if (contact.joint_material != 0) continue;
        auto history = std::get<dda::CyclicBartonBandis::History>(*contact.history);
        history.wear = std::pow(factor, ++history.reversals);
        contact.history = dda::JointHistory(history);
    }
}

/// Settles the blocks with high friction, so that the joint bears them without slip, then shakes the base.
inline void SeismicSlide::run(double duration) {
    Simulation settled(scene(Scene::mohr_coulomb(80)));
    outcome = settled.settle(1);  // large steps, since the springs of the plane are soft
    if (outcome.status != dda::RunStatus::completed) return;
    if (!prescribed_reversals.empty()) std::get<dda::CyclicBartonBandis>(plane).min_slip = 1e9;
    Simulation sim(scene(plane));
    sim.state = settled.state;
    preload_joint(sim.state);
    sim.restart_ledger();
    const Vec2 down(std::cos(radians(2)), -std::sin(radians(2)));
    const auto position = [&] { return (sim.moved(3) - sim.moved(0)).dot(down); };
    const double start = position();
    double stage_start = 0;  // s, of the present stage
    sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
        time.push_back(stage_start + state.stage_time);
        slip.push_back(position() - start);
    };
    const auto shake = [&](double until) {
        dda::Stage stage;
        stage.name = "shaking";
        stage.duration = until - stage_start;
        stage.control.step = step;
        stage.base_motions.push_back({"base", record(stage_start, until), {}});
        outcome = sim.run(stage);
        stage_start = until;
    };
    for (const double t : prescribed_reversals) {
        shake(t);
        count_reversal(sim.state);
    }
    shake(duration);
    energy = sim.energy;
    frequency_step = sim.contact_frequency_step();
    for (const dda::Contact& contact : sim.state.contacts.contacts) {
        if (contact.joint_material == 0 && (contact.corner_block == 3 || contact.edge_block == 3))
            reversals = std::max(reversals, dda::record(plane, contact.history).reversals);
    }
}

}  // namespace rockslope::scene
