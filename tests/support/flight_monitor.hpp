#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "support/momentum_balance.hpp"
#include "support/overlap.hpp"
#include "support/scene.hpp"

namespace rockslope::scene {

/// Blocks thrown at each other.
struct FlightSetup {
    Scene scene;
    std::vector<Vec6> velocity;  ///< per block
    dda::Stage stage;
};

/// Monitors a flight step by step: overlaps are no deeper than the penetration of contacts, energy does not
/// grow, and momentum is conserved if no external force acts.
class FlightMonitor {
  public:
    /// @param max_residual largest residual of the energy ledger over the largest kinetic energy.
    explicit FlightMonitor(const FlightSetup& thrown, double max_residual = .01)
        : sim_(thrown.scene), stage_(thrown.stage), max_residual_(max_residual) {
        for (int b = 0; b < sim_.model.block_count(); ++b) sim_.velocity(b) = thrown.velocity[b];
        sim_.restart_ledger();
        energy_ = sim_.state.energy.stores();
        kinetic_ = sim_.state.energy.kinetic;
        momentum_ = momentum(sim_.state, 0);
        remember_rotation(sim_.state);
        for (std::size_t b = 0; b < thrown.velocity.size(); ++b) {
            scale_ += sim_.state.blocks.mass[b] * thrown.velocity[b].head<2>().norm();
            isolated_ = isolated_ && sim_.model.motion[b] == dda::Motion::free;
        }
        isolated_ = isolated_ && sim_.model.gravity.isZero(0);
        sim_.on_step = [this](const dda::State& state, const dda::StepReport& report) {
            observe(state, report);
        };
    }
    void run() {
        const dda::RunOutcome outcome = sim_.run(stage_);
        EXPECT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
    }
    /// Closed contacts, summed over the steps.
    int closed_contacts() const { return closed_contacts_; }
    /// Loads of a corner whose neighbour bears or has borne force on the same block.
    int loaded_neighbours() const { return loaded_neighbours_; }
    /// Loads of an entrance line while another of its group has borne force or would be entered first.
    int loaded_rear_lines() const { return loaded_rear_lines_; }
    /// m, the largest displacement of a vertex in a step.
    double largest_displacement() const { return largest_displacement_; }
    /// rad2, the largest product of a block's rotation in a step and its error by the velocity at the step's
    /// start, see rotation_prediction_failed.
    double largest_rotation_error() const { return largest_rotation_error_; }
    const Simulation& simulation() const { return sim_; }

  private:
    void observe(const dda::State& state, const dda::StepReport& report) {
        for (const dda::Contact& c : state.contacts.contacts) {
            if (c.state == dda::ContactState::open) continue;
            ++closed_contacts_;
            remember_load(state, c);
        }
        observe_motion(state, report);
        check_overlaps(state, report);
        // The equations are solved to the rounding of stiffness times displacement, a few 1e-16.
        rounding_ += 1e-15 * sim_.model.normal_penalty * report.largest_displacement * report.step;
        if (isolated_) {
            ASSERT_LE((momentum(state, 0) - momentum_).norm(), 1e-9 * scale_ + rounding_)
                << "t = " << state.time;
        }
        kinetic_ = std::max(kinetic_, state.energy.kinetic);
        ASSERT_LE(state.energy.stores(), energy_ + 1e-9 * kinetic_) << "t = " << state.time;
        ASSERT_LE(std::abs(state.energy.residual()), max_residual_ * kinetic_) << "t = " << state.time;
    }

    /// Notes that a contact bears force.
    void remember_load(const dda::State& state, const dda::Contact& loaded) {
        remember_corner(loaded.corner, loaded.edge_block);
        if (loaded.kind == dda::ContactKind::vertex_vertex)
            remember_corner(nearer_end(state, loaded), loaded.corner_block);
        for (const dda::Contact& c : state.contacts.contacts) {
            const bool is_other_line = loaded.group >= 0 && c.group == loaded.group && c.line != loaded.line;
            loaded_rear_lines_ += is_other_line && (c.gap > loaded.gap || c.inherited_penetration > 0);
        }
    }
    void remember_corner(dda::CornerIndex corner, dda::BlockIndex on) {
        for (const auto& [other, met] : loaded_)
            loaded_neighbours_ += met == on && are_neighbours(corner, other);
        loaded_.insert({corner, on});
    }
    dda::CornerIndex nearer_end(const dda::State& state, const dda::Contact& contact) const {
        const dda::CornerIndex first = start_of(contact.edge),
                               second = sim_.model.topology.end_of(contact.edge);
        const auto distance = [&](dda::CornerIndex c) {
            return (state.blocks.vertices[c] - contact.point).norm();
        };
        return distance(first) < distance(second) ? first : second;
    }
    bool are_neighbours(dda::CornerIndex a, dda::CornerIndex b) const {
        const dda::Topology& topology = sim_.model.topology;
        return topology.end_of(dda::edge_from(a)) == b || topology.end_of(dda::edge_from(b)) == a;
    }

    void observe_motion(const dda::State& state, const dda::StepReport& report) {
        largest_displacement_ = std::max(largest_displacement_, report.largest_displacement);
        for (std::size_t b = 0; b < spin_before_.size(); ++b) {
            const double rotation = state.blocks.rotation[b] - rotation_before_[b];
            largest_rotation_error_ = std::max(
                largest_rotation_error_, std::abs(rotation * (rotation - report.step * spin_before_[b])));
        }
        remember_rotation(state);
    }
    void remember_rotation(const dda::State& state) {
        rotation_before_ = state.blocks.rotation;
        spin_before_.clear();
        for (const Vec6& velocity : state.blocks.velocity) spin_before_.push_back(velocity[2]);
    }

    void check_overlaps(const dda::State& state, const dda::StepReport& report) {
        // Two corners that meet have one contact. If it opens in a step, the other corner may still be as
        // deep as the contact was a step ago. It has no force, gains no energy, and leaves.
        const double depth = std::max(report.largest_penetration, depth_before_) + 2e-9;
        depth_before_ = report.largest_penetration;
        for (const Overlap& overlap : overlaps(sim_.model.topology, state.blocks.vertices)) {
            const double rim =
                std::min(perimeter(sim_.model.topology, state.blocks.vertices, overlap.first),
                         perimeter(sim_.model.topology, state.blocks.vertices, overlap.second));
            ASSERT_LE(overlap.area, depth * rim)
                << "blocks " << overlap.first << " and " << overlap.second << ", t = " << state.time;
        }
    }

    Simulation sim_;
    dda::Stage stage_;
    double max_residual_;
    bool isolated_ = true;
    int closed_contacts_ = 0;
    std::set<std::pair<dda::CornerIndex, dda::BlockIndex>> loaded_;  ///< corners, and the blocks they met
    int loaded_neighbours_ = 0;
    int loaded_rear_lines_ = 0;
    double largest_displacement_ = 0;
    double largest_rotation_error_ = 0;
    std::vector<double> rotation_before_;  ///< rad, per block, a step ago
    std::vector<double> spin_before_;      ///< rad/s, per block, a step ago
    double energy_ = 0;                    ///< J, at the start
    double kinetic_ = 0;                   ///< J, largest so far
    Vec2 momentum_{0, 0};                  ///< kg m/s, at the start
    double scale_ = 0;                     ///< kg m/s, sum of the magnitudes of the blocks' momenta
    double rounding_ = 0;                  ///< kg m/s, possible error of the solutions so far
    double depth_before_ = 0;              ///< m, largest penetration a step ago
};

}  // namespace rockslope::scene
