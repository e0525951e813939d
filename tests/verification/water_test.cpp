// Water in joints and around blocks.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/penalty_series.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::water_test {
namespace {

using namespace scene;
using namespace verification;

constexpr double water_weight = 9810;  // N/m3

/// All edges of a block of four corners.
std::vector<dda::EdgeIndex> edges_of(int block) {
    return {4 * block, 4 * block + 1, 4 * block + 2, 4 * block + 3};
}

// V43. W = 49050 N on 2 m of a plane of 30 degrees, phi = 40. Sliding starts at W sin psi = (W cos psi - p L)
// tan phi, p = (W/L) (cos psi - sin psi / tan phi) = 6625.4 Pa. The pressure rises by 1 % of that in 0.1 s.
// The acceleration then grows by 0.24 m/s3, and the block needs 0.03 s for the micrometre that counts as
// sliding.
struct Uplift {
    double critical = 0;  ///< Pa, pressure at which the block has slid by a micrometre
    double frequency_step = 0;
};
Uplift slide_by_water(const std::string& set_up, const ContactSetting& setting) {
    const double psi = radians(30);
    const Vec2 along(std::cos(psi), std::sin(psi));
    Scene s;
    s.friction(40);
    setting.apply(s);
    s.box(-5 * along - dda::perpendicular(along), 12, 1, dda::Motion::fixed, psi);
    const int block = s.box({0, 0}, 2, 1, dda::Motion::free, psi);
    const double critical = 49050.0 / 2 * (std::cos(psi) - std::sin(psi) / std::tan(radians(40)));
    EXPECT_NEAR(critical, 6625.4, 0.1);
    Simulation dry(s);
    EXPECT_EQ(dry.settle().status, dda::RunStatus::completed);
    s.model.loads.push_back(dda::JointWater{{4 * block}, critical, dda::TimeTable({0, 11}, {0, 1.1})});
    Simulation wet(s);
    wet.state = dry.state;
    wet.stages = dry.stages;
    wet.restart_ledger();
    Uplift found;
    wet.on_step = [&](const dda::State& state, const dda::StepReport&) {
        if (found.critical == 0 && -wet.moved(block).dot(along) > 1e-6)
            found.critical = critical * state.stage_time / 10;
    };
    EXPECT_EQ(wet.shake(11, 5e-3).status, dda::RunStatus::completed);
    found.frequency_step = wet.contact_frequency_step();
    expect_energy_balance("V43", set_up, wet);
    return found;
}

TEST(WaterUplift, LetsABlockSlideAtItsCriticalPressure) {
    for (const ContactSetting& setting : {ContactSetting{5}, ContactSetting{1}, ContactSetting{100},
                                          ContactSetting{1, 1e-9}, ContactSetting{100, 1e-9}}) {
        const std::string set_up = "pressure rising by 1 % of its critical value in 0.1 s, " + setting.name();
        const Uplift found = slide_by_water(set_up, setting);
        Case("V43", set_up, "time to slide a micrometre")
            .contact_frequency_step(found.frequency_step)
            .expect("p_crit", "Pa", found.critical, 6625.4, relative(0.01));
    }
}

// A submerged block sinks with g (1 - rho_w/rho). Shi's integration is exact here. Evaluating the pressure at
// the mid-step position causes no error, because its gradient with depth is constant.
TEST(Buoyancy, EqualsTheWeightOfTheDisplacedWater) {
    Scene s;
    const int block = s.box({0, 0}, 1, 1, dda::Motion::free, radians(20));
    s.model.loads.push_back(dda::HeadWater{edges_of(block), {{0, 10}}, water_weight, {}});
    Simulation sim(s);
    ASSERT_EQ(sim.shake(0.5, 1e-3).status, dda::RunStatus::completed);
    const double a = g - water_weight / 2500;
    // The pressure compresses the block by a strain of 1e-5, and the displaced volume is smaller by that.
    EXPECT_NEAR(sim.velocity(block)[1], -a * 0.5, 1e-4 * a * 0.5);
    EXPECT_NEAR(sim.velocity(block)[0], 0, 1e-8);
    EXPECT_NEAR(sim.velocity(block)[2], 0, 1e-6);
}

// A column of three blocks in still water, with water in the joints. Each joint carries the buoyant weight
// above it. The stress of a block is the total stress of rock and water at its centroid.
TEST(Buoyancy, JointsCarryTheEffectiveWeight) {
    Scene s;
    s.model.block_materials[0].poissons_ratio = 0;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    std::vector<dda::EdgeIndex> edges;
    for (int k = 0; k < 3; ++k) {
        for (const dda::EdgeIndex edge : edges_of(s.box({0, double(k)}, 1, 1))) edges.push_back(edge);
    }
    s.model.loads.push_back(dda::HeadWater{edges, {{-1, 5}, {2, 5}}, water_weight, {}});
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    std::vector<double> borne(3, 0);
    for (const dda::Contact& contact : sim.state.contacts.contacts)
        borne[std::max(contact.corner_block, contact.edge_block) - 1] += contact.normal_force;
    const double buoyant = 2500 * g - water_weight;
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(borne[k], (3 - k) * buoyant, 1e-3 * buoyant);
        const double depth = 4.5 - k;
        const double total = 2500 * g * (2.5 - k) + 2 * water_weight;
        EXPECT_NEAR(sim.stress(k + 1)[1], -total, 1e-3 * total) << "rock and 2 m of water above it";
        EXPECT_NEAR(sim.stress(k + 1)[0], -water_weight * depth, 1e-3 * water_weight * depth);
    }
}

// A light block floats with rho/rho_w of its height in the water and oscillates vertically (heaves) about
// that with omega^2 = g rho_w / (rho h).
TEST(Buoyancy, MakesALightBlockHeave) {
    Scene s;
    s.model.block_materials[0].density = 400;
    const int block = s.box({0, -0.45}, 2, 1);
    s.model.loads.push_back(dda::HeadWater{edges_of(block), {{0, 0}}, water_weight, {}});
    Simulation sim(s);
    std::vector<double> crossings;
    double before = 0;
    sim.on_step = [&](const dda::State& state, const dda::StepReport& report) {
        const double now = sim.moved(block).y() - 0.05;
        if (before * now < 0) crossings.push_back(state.time - report.step * now / (now - before));
        before = now;
    };
    ASSERT_EQ(sim.shake(2.5, 1e-3).status, dda::RunStatus::completed);
    ASSERT_GE(crossings.size(), 3u);
    const double period = 2 * std::numbers::pi * std::sqrt(400 * 1 / (1000 * g));
    // The pressure at mid-step neither adds nor removes energy. It lags by half a step, of 1270 steps.
    EXPECT_NEAR(crossings[2] - crossings[0], period, 1e-3 * period);
}

}  // namespace
}  // namespace rockslope::water_test
