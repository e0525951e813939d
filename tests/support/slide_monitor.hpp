#pragma once

#include <gtest/gtest.h>

#include <cstdio>

#include "support/momentum_balance.hpp"
#include "support/overlap.hpp"
#include "support/scene.hpp"

namespace rockslope::scene {

/// Monitors a slide: momentum, area and contacts at every step, overlaps of blocks at every
/// `overlaps_every`-th.
class SlideMonitor {
  public:
    SlideMonitor(const Scene& scene, int threads, int overlaps_every)
        : sim_(scene, threads), overlaps_every_(overlaps_every), momentum_(sim_.state) {
        first_area_ = unstrained_area(sim_.state);
        sim_.on_step = [this](const dda::State& state, const dda::StepReport& report) {
            observe(state, report);
        };
    }
    /// Prints a line of progress every `period` of simulated time, s.
    void print_every(double period) { period_ = next_ = period; }
    void run(double duration) {
        const dda::RunOutcome outcome = sim_.shake(duration, .005);
        EXPECT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
        check_overlaps(sim_.state);
    }

    double deepest() const { return deepest_; }          ///< m, largest penetration
    double deepest_overlap() const { return overlap_; }  ///< m, overlap beyond it over perimeter
    double turned_away() const { return turned_away_; }  ///< largest back_face_sine()
    double area_change() const { return area_change_; }  ///< largest relative change of the total area
    double momentum_change() const {
        return momentum_.unexplained();
    }                                                              ///< kg m/s, largest change without a force
    double momentum_moved() const { return momentum_.largest(); }  ///< kg m/s, largest total momentum
    double lowest() const {
        double lowest = 1e9;
        for (std::size_t b = 1; b < sim_.state.blocks.moments.size(); ++b)
            lowest = std::min(lowest, sim_.state.blocks.moments[b].centroid.y());
        return lowest;
    }
    double mean_displacement() const {
        double sum = 0;
        for (int b = 1; b < sim_.model.block_count(); ++b) sum += sim_.moved(b).norm();
        return sum / (sim_.model.block_count() - 1);
    }

  private:
    /// Total area of the blocks less that of their elastic strain, m2, Eq. (9).
    double unstrained_area(const dda::State& state) const {
        double sum = 0;
        for (std::size_t b = 1; b < state.blocks.mass.size(); ++b) {
            const auto& rock = sim_.model.material_of(static_cast<int>(b));
            const dda::Vec3& stress = state.blocks.stress[b];
            const double nu = rock.poissons_ratio;
            const double strain = (1 + nu) * (1 - 2 * nu) / rock.youngs_modulus * (stress[0] + stress[1]);
            sum += state.blocks.moments[b].area * std::exp(-strain);
        }
        return sum;
    }

    void observe(const dda::State& state, const dda::StepReport& report) {
        deepest_ = std::max(deepest_, report.largest_penetration);
        for (const dda::Contact& c : state.contacts.contacts)
            turned_away_ = std::max(turned_away_, back_face_sine(c));
        momentum_.add_step(sim_.model, state, report.step);
        area_change_ = std::max(area_change_, std::abs(unstrained_area(state) / first_area_ - 1));
        if (++steps_ % overlaps_every_ == 0) check_overlaps(state);
        iterations_ += report.iterations;
        cuts_ += report.cuts;
        if (state.time >= next_) print_progress(state);
    }

    /// Sine of the largest angle by which an edge of a corner dips behind the face that bears it; 0 if none
    /// does.
    double back_face_sine(const dda::Contact& contact) const {
        if (contact.state == dda::ContactState::open) return 0;
        const dda::Topology& topology = sim_.model.topology;
        const auto at = [&](dda::CornerIndex k) { return sim_.state.blocks.vertices[k]; };
        double sine = 0;
        for (const dda::CornerIndex end : {topology.next[contact.corner], topology.previous[contact.corner]})
            sine = std::max(sine, -(at(end) - at(contact.corner)).normalized().dot(contact.normal));
        return sine;
    }

    void print_progress(const dda::State& state) {
        const dda::Energy& energy = state.energy;
        std::printf(
            "%5.2f s: %d steps, %.1f iterations each, %d cuts, penetration %.3g m, overlap %.3g m, "
            "momentum %.2g of %.3g, area %.2g; kinetic %.3g J, friction %.4g J, residual %.2g J\n",
            state.time, steps_, double(iterations_) / steps_, cuts_, deepest_, overlap_,
            momentum_.unexplained(), momentum_.largest(), area_change_, energy.kinetic, energy.friction_loss,
            energy.residual());
        std::fflush(stdout);
        next_ += period_;
    }

    void check_overlaps(const dda::State& state) {
        overlap_ = std::max(overlap_, largest_overlap_depth(sim_.model.topology, state.blocks.vertices));
    }

    Simulation sim_;
    int overlaps_every_;
    MomentumBalance momentum_;
    double first_area_ = 0;
    double deepest_ = 0, overlap_ = 0, turned_away_ = 0, area_change_ = 0;
    int steps_ = 0, cuts_ = 0;
    long iterations_ = 0;
    double period_ = 0, next_ = 1e9;  ///< s, interval and next time of progress lines
};

inline void expect_slide_invariants(const SlideMonitor& slide) {
    EXPECT_LT(slide.deepest(), 1e-3) << "penetration of blocks of 1 m";
    EXPECT_LT(slide.deepest_overlap(), slide.deepest())
        << "overlaps are no deeper than the penetration of contacts";
    // A contact is released if its face dips by more than 3 degrees, and a block may turn by as much in a
    // step.
    EXPECT_LT(slide.turned_away(), .2) << "a corner is borne by faces that face it";
    EXPECT_LT(slide.area_change(), 1e-9) << "rounding of some thousand steps";
    // Reported forces are those of the joint laws. In a converged step they differ from those of the linear
    // system by up to a millionth of the largest.
    EXPECT_LT(slide.momentum_change(), 1e-6 * slide.momentum_moved());
    EXPECT_GT(slide.lowest(), 0) << "no block is below the plane";
}

}  // namespace rockslope::scene
