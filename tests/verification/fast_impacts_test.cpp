// Many impacts at speed: polygons in a closed box, blocks that fall over a cliff.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/momentum_balance.hpp"
#include "support/overlap.hpp"
#include "support/random_shapes.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::fast_impacts_test {
namespace {

using namespace scene;
using namespace verification;

/// Free blocks and one fixed block, number 0. Monitors energy, momentum and overlaps step by step.
class Flight {
  public:
    /// @param height m, of the blocks above the ground: their initial energy includes that of this fall.
    Flight(const Scene& scene, const std::vector<Vec6>& velocity, double height)
        : sim_(thrown(scene, velocity)), momentum_(sim_.state) {
        sim_.restart_ledger();
        energy_ = initial_ = sim_.state.energy.stores();
        for (std::size_t b = 1; b < velocity.size(); ++b)
            initial_ -= sim_.state.blocks.mass[b] * sim_.model.gravity.y() * height;
        sim_.on_step = [this](const dda::State& state, const dda::StepReport& report) {
            observe(state, report);
        };
    }
    void run(const std::string& set_up, double duration, double step) {
        ASSERT_EQ(sim_.shake(duration, step).status, dda::RunStatus::completed);
        EXPECT_FALSE(free_) << "blocks must meet the fixed one";
        EXPECT_LT(sim_.state.energy.stores(), energy_at_first_) << "impacts must take energy";
        expect_energy_balance("P16", set_up, sim_);
        Case row("P16", set_up,
                 "required; momentum: rounding in flight, the convergence of forces in impacts");
        row.contact_frequency_step(sim_.contact_frequency_step());
        row.expect_below("largest gain of energy in a step over the initial energy", "", gain_ / initial_,
                         1e-6);
        row.expect_below("deepest contact", "m", deepest_, 1e-3);
        row.expect_below("largest overlap of two polygons over the perimeter of one", "m", overlap_, 1e-3);
        row.expect_below("change of momentum in free flight but by gravity, over the largest", "",
                         unexplained_in_flight_ / momentum_.largest(), 1e-9);
        row.expect_below("change of momentum without a force on a block, over the largest", "",
                         momentum_.unexplained() / momentum_.largest(), 1e-6);
    }

  private:
    static Simulation thrown(const Scene& scene, const std::vector<Vec6>& velocity) {
        Simulation sim(scene);
        for (std::size_t b = 0; b < velocity.size(); ++b) sim.velocity(static_cast<int>(b)) = velocity[b];
        return sim;
    }
    void observe(const dda::State& state, const dda::StepReport& report) {
        gain_ = std::max(gain_, state.energy.stores() - energy_);
        energy_ = state.energy.stores();
        deepest_ = std::max(deepest_, report.largest_penetration);
        if (sim_.reports.size() % 5 == 0) check_overlaps(state);
        const auto touches_ground = [](const dda::Contact& c) {
            return (c.edge_block == 0 || c.corner_block == 0) && c.state != dda::ContactState::open;
        };
        const dda::PerContact<dda::Contact>& contacts = state.contacts.contacts;
        if (free_ && std::any_of(contacts.begin(), contacts.end(), touches_ground)) {
            free_ = false;
            energy_at_first_ = energy_;
        }
        momentum_.add_step(sim_.model, state, report.step);
        if (free_) unexplained_in_flight_ = momentum_.unexplained();
    }
    void check_overlaps(const dda::State& state) {
        overlap_ = std::max(overlap_, largest_overlap_depth(sim_.model.topology, state.blocks.vertices));
    }

    Simulation sim_;
    double energy_ = 0;           ///< J, after the last step
    double initial_ = 0;          ///< J
    double energy_at_first_ = 0;  ///< J, at the first contact with the fixed block
    double gain_ = 0;             ///< J, largest in a step
    double deepest_ = 0;          ///< m
    double overlap_ = 0;          ///< m
    MomentumBalance momentum_;
    double unexplained_in_flight_ = 0;  ///< kg m/s, before the first contact with the fixed block
    bool free_ = true;                  ///< no block has touched the fixed one yet
};

// P16. Polygons of three to eight corners and 1.4 m, at 10 to 50 m/s in all directions. A block of 4 t at 50
// m/s would go v sqrt(m/k) = 4.5 mm into one spring of 5e11 N/m; in steps of 0.2 ms, omega dt = 2, the
// integration takes most of that.
TEST(FastImpacts, OfPolygonsInABoxCreateNoEnergy) {
    RandomSource random(16);
    Scene s;
    s.friction(30);
    s.model.normal_penalty = s.model.shear_penalty = 5e11;
    s.block({{{-1, -1}, {13, -1}, {13, 13}, {-1, 13}}, {{0, 0}, {0, 12}, {12, 12}, {12, 0}}},
            dda::Motion::fixed);
    std::vector<Vec6> velocity(1, Vec6::Zero());
    for (int i = 0; i < 36; ++i) {
        const unsigned corners = 3 + random.index_below(6);
        const double turned = random.between(0, 6);
        const Vec2 centre(1 + 2 * (i % 6), 1 + 2 * std::floor(i / 6.));
        std::vector<Vec2> ring;
        for (unsigned k = 0; k < corners; ++k) {
            const double angle = turned + 2 * std::numbers::pi * (k + random.between(0, .5)) / corners;
            ring.push_back(centre + random.between(.6, .8) * Vec2(std::cos(angle), std::sin(angle)));
        }
        s.block({ring});
        Vec6 v = Vec6::Zero();
        const Vec2 way = random.direction();
        v.head<2>() = random.between(10, 50) * way;
        v[2] = random.between(-20, 20);
        velocity.push_back(v);
    }
    Flight(s, velocity, 0).run("36 polygons at up to 50 m/s in a closed box", .5, 2e-4);
}

// P16. Blocks of 1 m leave a plateau at 5 to 20 m/s and land with 35 m/s and more.
TEST(LongFastImpacts, BelowACliffCreateNoEnergy) {
    RandomSource random(60);
    Scene s;
    s.friction(35);
    s.model.normal_penalty = s.model.shear_penalty = 5e11;
    s.block({{{-40, -5}, {250, -5}, {250, 0}, {0, 0}, {0, 60}, {-40, 60}}}, dda::Motion::fixed);
    std::vector<Vec6> velocity(1, Vec6::Zero());
    for (int i = 0; i < 200; ++i) {
        s.box({1 + 2. * (i % 20), 61 + 2 * std::floor(i / 20.)}, 1, 1);
        Vec6 v = Vec6::Zero();
        v[0] = random.between(5, 20);
        v[2] = random.between(-2, 2);
        velocity.push_back(v);
    }
    Flight(s, velocity, 60).run("200 blocks over a cliff of 60 m", 4.2, 5e-3);
}

}  // namespace
}  // namespace rockslope::fast_impacts_test
