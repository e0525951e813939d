// A polygon that rolls down a slope from corner to corner.

#include <gtest/gtest.h>

#include <array>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::rolling_test {
namespace {

using namespace scene;
using namespace verification;

/// Rolling of a regular polygon without slip and without rebound.
struct Rolling {
    int sides;
    double radius;  ///< m, of the corners
    double dip;     ///< rad

    double angle() const { return 2 * std::numbers::pi / sides; }
    /// Moment of inertia about the centre over the mass.
    double centre() const {
        const double s = std::sin(angle() / 2);
        return radius * radius / 2 * (1 - 2. / 3 * s * s);
    }
    struct Motion {
        double time;   ///< s
        double speed;  ///< rad/s, before the last impact
    };
    /// The time and the speed before the impact that ends the roll over a number of sides, from rest on a
    /// side. About the corner it is a pendulum upside down: theta'' = g R sin(theta) / (I + R^2), theta from
    /// the vertical, downhill. It falls from dip - angle/2 to dip + angle/2. An impact keeps the angular
    /// momentum about the next corner.
    Motion over(int count) const {
        const double about_corner = centre() + radius * radius;
        const double kept = (centre() + radius * radius * std::cos(angle())) / about_corner;
        double time = 0;
        double omega = 0;
        const double dt = 1e-5;
        for (int k = 0; k < count; ++k) {
            if (k > 0) omega *= kept;
            double theta = dip - angle() / 2;
            const double last = dip + angle() / 2;
            while (theta < last) {
                const double a = g * radius * std::sin(theta + omega * dt / 2) / about_corner;
                const double step = omega * dt + a * dt * dt / 2;
                const double part = std::min(1., (last - theta) / step);
                theta += part * step;
                omega += part * a * dt;
                time += part * dt;
                if (part < 1) break;
            }
        }
        return {time, omega};
    }
};

// P10. From rest on a side, 5 degrees being more than half the angle of a side. Impacts at up to 0.25 m/s do
// not rebound: the time integration takes what the springs store, and what is left is lost in further impacts
// within a few milliseconds.
TEST(RollingPolygon, FollowsTheInelasticImpactOfItsCorners) {
    const Rolling rolling{48, 1, radians(5)};
    Scene s;
    s.friction(45);
    const Vec2 along(std::cos(rolling.dip), -std::sin(rolling.dip));
    const Vec2 up = dda::perpendicular(along);
    s.box(-5 * along - up, 30, 1, dda::Motion::fixed, -rolling.dip);
    std::vector<Vec2> ring;
    const Vec2 centre = rolling.radius * std::cos(rolling.angle() / 2) * up;
    for (int k = 0; k < rolling.sides; ++k) {
        const double angle = (k + .5) * rolling.angle() - std::numbers::pi / 2;
        ring.push_back(centre + rolling.radius * (std::cos(angle) * along + std::sin(angle) * up));
    }
    const int block = s.block({ring});
    Simulation sim(s);
    const std::array<int, 3> counts = {6, 12, 24};
    std::vector<Rolling::Motion> found;
    double turned = 0;
    double before = 0;
    sim.on_step = [&](const dda::State& state, const dda::StepReport& report) {
        const double speed = -state.blocks.velocity[block][2];
        turned += report.step * (speed + before) / 2;
        if (found.size() < counts.size() && turned >= counts[found.size()] * rolling.angle())
            found.push_back({state.stage_time, before});
        before = speed;
    };
    ASSERT_EQ(sim.shake(4, 1e-3).status, dda::RunStatus::completed);
    ASSERT_EQ(found.size(), counts.size());
    const std::string set_up = "48 corners, radius 1 m, on 5°";
    expect_energy_balance("P10", set_up, sim);
    Case rolls("P10", set_up, "required");
    rolls.contact_frequency_step(sim.contact_frequency_step());
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const Rolling::Motion expected = rolling.over(counts[k]);
        const std::string after = " after " + to_text(counts[k]) + " sides";
        rolls.expect("time" + after, "s", found[k].time, expected.time, relative(.02));
        rolls.expect("angular velocity" + after, "rad/s", found[k].speed, expected.speed, relative(.02));
    }
}

}  // namespace
}  // namespace rockslope::rolling_test
