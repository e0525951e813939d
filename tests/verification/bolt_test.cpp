// Bolts: an elastic bolt carries a hanging block; the tension that holds a block on a plane.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/penalty_series.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"
#include "support/threshold.hpp"

namespace rockslope::bolt_test {
namespace {

using namespace scene;
using namespace verification;

// V42. A block of 24 525 N hangs on one bar: T = W, elongation W L/(E A).
TEST(HangingBlock, StretchesItsBolt) {
    Scene s;
    const int roof = s.box({-1, 3}, 3, 1, dda::Motion::fixed);
    const int block = s.box({0, 0}, 1, 1);
    const double length = 2;
    const double stiffness = 1e8;
    s.model.bolts.push_back(
        {"hanger", s.material_point(roof, {.5, 3}), s.material_point(block, {.5, 1}), stiffness});
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    const double weight = 2500 * g;
    // The strain of the block moves its top, too; the elongation is measured between the ends of the bolt.
    const double elongation = (sim.state.blocks.points[0] - sim.state.blocks.points[1]).norm() - length;
    const Case hanger("V42", "W = 24 525 N, E A = 100 MN, L = 2 m",
                      "required; settled to 1e-9 of the weight");
    hanger.expect("tension", "N", sim.state.bolt_force[0], weight, relative(.005));
    hanger.expect("elongation", "m", elongation, weight * length / stiffness, relative(.005));
}

/// A 2 m x 1 m block on 30 degrees with a friction angle of 25 degrees, held by a bolt of constant tension.
/// The bolt is long and of very small stiffness, so that the motion of the block changes neither its tension
/// nor its direction.
class BoltedBlock {
  public:
    explicit BoltedBlock(const Vec2& pull, const ContactSetting& setting = {5})
        : pull_(pull), setting_(setting) {}

    bool holds(double tension) {
        Simulation settled(scene(80, tension));
        EXPECT_EQ(settled.settle().status, dda::RunStatus::completed);
        Simulation sim(scene(25, tension));
        sim.state = settled.state;
        EXPECT_EQ(sim.shake(1, 1e-3).status, dda::RunStatus::completed);
        frequency_step = sim.contact_frequency_step();
        energy = sim.energy;
        return sim.moved(1).norm() < 1e-4;
    }
    double frequency_step = 0;
    std::optional<EnergyMonitor> energy;  ///< of the last run

  private:
    Scene scene(double phi, double tension) const {
        const double psi = -radians(30);
        const Vec2 along(std::cos(psi), std::sin(psi));
        const Vec2 out = dda::perpendicular(along);
        Scene s;
        s.friction(phi);
        setting_.apply(s);
        const int base = s.box(-out - 10 * along, 30, 1, dda::Motion::fixed, psi);
        const int block = s.box({0, 0}, 2, 1, dda::Motion::free, psi);
        const Vec2 centre = along + .5 * out;
        s.model.bolts.push_back({"bolt", s.material_point(base, centre + 100 * pull_),
                                 s.material_point(block, centre), 1.0, tension, 0});
        return s;
    }
    Vec2 pull_;
    ContactSetting setting_;
};

// V41. Limit equilibrium: W sin psi - T_t = (W cos psi + T_n) tan phi, with the components T_n into the plane
// and T_t uphill. With 0.1 % less tension the block slides by 0.5 mm in the simulated second.
struct BoltDirection {
    const char* name;
    Vec2 pull;
    double tension;  ///< N, at the limit
};
std::vector<BoltDirection> bolt_directions() {
    const double weight = 5000 * g;
    const double psi = radians(30);
    const double mu = std::tan(radians(25));
    return {{"normal to the plane",
             {-std::sin(psi), -std::cos(psi)},
             weight * (std::sin(psi) / mu - std::cos(psi))},
            {"horizontal",
             {-1, 0},
             weight * (std::sin(psi) - std::cos(psi) * mu) / (std::cos(psi) + std::sin(psi) * mu)}};
}

void expect_limit_tension(const BoltDirection& direction, const std::string& set_up, BoltedBlock block) {
    ASSERT_FALSE(block.holds(.9 * direction.tension));
    ASSERT_TRUE(block.holds(1.1 * direction.tension));
    const double found = direction.tension * threshold(.9, 1.1, 7, [&](double share) {
                             return block.holds(share * direction.tension);
                         });
    Case bolt("V41", set_up, "required; found by halving to 0.2 %");
    bolt.contact_frequency_step(block.frequency_step);
    bolt.expect("tension for FS = 1", "N", found, direction.tension, relative(.01));
    expect_energy_balance("V41", set_up, *block.energy, block.frequency_step);
}

TEST(BoltedBlock, NeedsTheTensionOfLimitEquilibrium) {
    const std::vector<BoltDirection> directions = bolt_directions();
    EXPECT_NEAR(directions[0].tension, 10115.5, .1);
    EXPECT_NEAR(directions[1].tension, 4291.3, .1);
    for (const BoltDirection& direction : directions)
        expect_limit_tension(direction, std::string("bolt ") + direction.name, BoltedBlock(direction.pull));
}

TEST(BoltedBlock, NeedsTheSameTensionForAnyPenalty) {
    for (const BoltDirection& direction : bolt_directions())
        for (const ContactSetting& setting : settings(1e-9))
            expect_limit_tension(direction, std::string("bolt ") + direction.name + ", " + setting.name(),
                                 BoltedBlock(direction.pull, setting));
}

}  // namespace
}  // namespace rockslope::bolt_test
