// The strength at the limit of a slope: friction is reduced until the slope moves.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"
#include "support/threshold.hpp"

namespace rockslope::slope_test {
namespace {

using namespace scene;
using namespace verification;

/// A slab of five blocks, each 4 m long and 2 m thick, on 20 degrees. A slipping joint keeps its cohesion,
/// because the ends of the slab slip first and cohesion must act along the whole slab at the limit.
class Slab {
  public:
    explicit Slab(double cohesion) : cohesion_(cohesion) {}

    bool holds(double phi) {
        Simulation settled(scene(60));
        EXPECT_EQ(settled.settle().status, dda::RunStatus::completed);
        Simulation sim(scene(phi));
        sim.state = settled.state;
        EXPECT_EQ(sim.shake(1, 1e-3).status, dda::RunStatus::completed);
        frequency_step = sim.contact_frequency_step();
        energy = sim.energy;
        double moved = 0;
        for (int b = 1; b <= 5; ++b) moved = std::max(moved, sim.moved(b).norm());
        return moved < 1e-3;
    }
    double frequency_step = 0;
    std::optional<EnergyMonitor> energy;  ///< of the last run

  private:
    Scene scene(double phi) const {
        const double psi = -radians(20);
        const Vec2 along(std::cos(psi), std::sin(psi));
        Scene s;
        dda::MohrCoulomb law = Scene::mohr_coulomb(phi, cohesion_);
        law.residual_cohesion = cohesion_;
        s.model.joint_materials[0].law = law;
        s.box(-dda::perpendicular(along) - 10 * along, 60, 1, dda::Motion::fixed, psi);
        for (int k = 0; k < 5; ++k) s.box(4 * k * along, 4, 2, dda::Motion::free, psi);
        return s;
    }
    double cohesion_;
};

// V40. A slice of thickness h, weight gamma h per metre of slope: gamma h sin psi = c + gamma h cos psi
// tan(phi) at the limit, h = z cos psi. At 0.2 degrees below the limit the slab moves by 17 mm in the
// simulated second.
TEST(InfiniteSlope, FailsAtTheFrictionOfLimitEquilibrium) {
    const double psi = radians(20);
    for (const double cohesion : {0., 5e3}) {
        const double critical =
            std::atan(std::tan(psi) - cohesion / (2500 * g * 2 * std::cos(psi))) * 180 / std::numbers::pi;
        Slab slab(cohesion);
        ASSERT_FALSE(slab.holds(critical - 1));
        ASSERT_TRUE(slab.holds(critical + 1));
        const double found =
            threshold(critical - 1, critical + 1, 6, [&](double phi) { return slab.holds(phi); });
        const std::string set_up = "ψ = 20°, 2 m thick, c = " + to_text(cohesion) + " Pa";
        expect_energy_balance("V40", set_up, *slab.energy, slab.frequency_step);
        Case slope("V40", set_up, "required; found by halving to 0.03°");
        slope.contact_frequency_step(slab.frequency_step);
        slope.expect("φ for FS = 1", "°", found, critical, absolute(.2));
    }
}

}  // namespace
}  // namespace rockslope::slope_test
