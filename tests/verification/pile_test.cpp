// Momentum of blocks without external forces: contact forces must conserve it.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::pile_test {
namespace {

using namespace scene;
using namespace verification;

// V51. Nine blocks with friction fly at each other in free space. Contact forces are pairs of opposite forces
// at one point of the mid-step position, where Newmark (1/2, 1) conserves linear and angular momentum of
// rigid blocks up to rounding. The moment of inertia of a strained block differs; the angular momentum is
// corrected for that.
class IsolatedPile : public testing::TestWithParam<double> {};

TEST_P(IsolatedPile, KeepsItsMomentum) {
    Scene s;
    s.friction(30);
    s.model.block_materials[0].youngs_modulus = GetParam();
    s.model.gravity.setZero();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            s.box({1.1 * column, 1.1 * row}, 1, 1, dda::Motion::free, .02 * (row - column));
    Simulation sim(s);
    double speed = 0;
    for (int b = 0; b < 9; ++b) {
        const Vec2 inward = Vec2(1.6, 1.6) - sim.state.blocks.centroid(b);
        sim.velocity(b).head<2>() = inward + Vec2(.3, -.1 * b);
        sim.velocity(b)[2] = .2 * (b % 3) - .1;
        speed += sim.velocity(b).head<2>().norm();
    }
    sim.restart_ledger();
    const auto momentum = [&] {
        dda::Vec3 sum = dda::Vec3::Zero();
        for (int b = 0; b < 9; ++b) {
            const auto k = static_cast<std::size_t>(b);
            const dda::AreaMoments& m = sim.state.blocks.moments[k];
            const double mass = sim.state.blocks.mass[k];
            const Vec6& v = sim.velocity(b);
            sum.head<2>() += mass * v.head<2>();
            const double density = mass / m.area;
            const double spin = (m.xx + m.yy) * v[2] - m.xy * v[3] + m.xy * v[4] + (m.xx - m.yy) / 2 * v[5];
            sum[2] += mass * dda::cross(m.centroid, v.head<2>()) + density * spin;
        }
        return sum;
    };
    const dda::Vec3 before = momentum();
    const double kinetic = sim.state.energy.kinetic;
    ASSERT_EQ(sim.shake(1, 1e-4).status, dda::RunStatus::completed);
    const dda::Vec3 change = momentum() - before;
    const double scale = 2500 * speed;
    const std::string set_up = "nine blocks, friction 30°, 1 s, E = " + to_text(GetParam()) + " Pa";
    Case pile("V51", set_up, "required; relative to the sum of m v, and m v times 1 m");
    pile.contact_frequency_step(sim.contact_frequency_step());
    pile.expect_below("change of linear momentum", "", change.head<2>().norm() / scale, 1e-8);
    pile.expect_below("change of angular momentum", "", change[2] / scale, 1e-8);
    pile.expect_above("share of the kinetic energy that friction and impacts took", "",
                      1 - sim.state.energy.kinetic / kinetic, .1);
    expect_energy_balance("V51", set_up, sim);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, IsolatedPile, testing::Values(1e10, 1e14));

}  // namespace
}  // namespace rockslope::pile_test
