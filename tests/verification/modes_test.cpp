// A block on an incline slides, topples, or does both.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/penalty_series.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::modes_test {
namespace {

using namespace scene;
using namespace verification;

/// A block `width` long and `height` high on an incline that falls to the right. It is settled under the
/// normal component of gravity alone, and then released under full gravity.
struct Release {
    double psi, phi;  ///< degrees
    double width, height;
    double gravity = g;
    double density = 2500;
    double step = 4e-5;
    ContactSetting setting = {5};

    double toe = 0;       ///< m, downhill, of the lower corner
    double rotation = 0;  ///< rad, clockwise
    double frequency_step = 0;
    std::optional<EnergyMonitor> energy{};

    /// Runs until the block has rotated by `angle`, at most for `duration`.
    void run(double duration, double angle) {
        const Vec2 along(std::cos(radians(psi)), -std::sin(radians(psi)));
        const Vec2 out = dda::perpendicular(along);
        const auto scene = [&](double friction) {
            Scene s;
            s.friction(friction);
            setting.apply(s);
            s.model.block_materials[0].density = density;
            s.box(-out - 20 * width * along, 40 * width, 1, dda::Motion::fixed, -radians(psi));
            s.box({0, 0}, width, height, dda::Motion::free, -radians(psi));
            return s;
        };
        const bool stands = width / height > std::tan(radians(psi));
        Scene held = scene(stands && phi > psi ? phi : 80);
        held.model.gravity = stands ? Vec2(0, -gravity) : Vec2(-gravity * std::cos(radians(psi)) * out);
        Simulation settled(held);
        ASSERT_EQ(settled.settle().status, dda::RunStatus::completed);

        Scene free = scene(phi);
        free.model.gravity = {0, -gravity};
        Simulation sim(free);
        sim.state = settled.state;
        sim.restart_ledger();
        const Vec2 start = sim.state.blocks.vertices[5];
        dda::Stage stage;
        stage.name = "release";
        stage.duration = duration / 100;
        stage.control.step = step;
        for (int part = 0; part < 100 && rotation < angle; ++part) {
            ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
            rotation = -sim.state.blocks.rotation[1];
            toe = (sim.state.blocks.vertices[5] - start).dot(along);
        }
        frequency_step = sim.contact_frequency_step();
        energy = sim.energy;
    }
    /// Movements above 1 mm and 1 mrad count: at rest the block moves by micrometres.
    std::string mode() const {
        const bool slides = toe > 1e-3;
        const bool topples = rotation > 1e-3;
        if (slides && topples) return "slides and topples";
        return slides ? "slides" : topples ? "topples" : "stable";
    }
};

struct ModeCase {
    double height, phi;
    const char* mode;
    friend std::ostream& operator<<(std::ostream& out, const ModeCase& c) {
        return out << c.height << "_" << c.phi;
    }
};
class Modes : public testing::TestWithParam<ModeCase> {};

// V19. Blocks 10 m wide on 40 degrees. A block slides for phi < psi. It topples for b/h < tan(psi), unless
// tan(phi) < b/h: then it slides without rotation. Between tan(phi) = b/h and phi_c of V20 it does both.
TEST_P(Modes, AreThoseOfStatics) {
    const ModeCase& c = GetParam();
    for (const ContactSetting& setting : {ContactSetting{5}, ContactSetting{1}, ContactSetting{100},
                                          ContactSetting{1, 1e-8}, ContactSetting{100, 1e-8}}) {
        Release block{40, c.phi, 10, c.height, 10, 2000};
        block.step = 2e-4;
        block.setting = setting;
        block.run(.5, .2);
        const std::string set_up =
            "height " + to_text(c.height) + " m, φ = " + to_text(c.phi) + "°, " + setting.name();
        expect_energy_balance("V19", set_up, *block.energy, block.frequency_step);
        Case mode("V19", set_up, "exact");
        mode.contact_frequency_step(block.frequency_step);
        mode.expect_outcome("mode", block.mode(), c.mode);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Modes,
                         testing::Values(ModeCase{10, 40.1, "stable"}, ModeCase{5, 20, "slides"},
                                         ModeCase{25, 40, "topples"},
                                         ModeCase{25, 24, "slides and topples"}));

struct BoundaryCase {
    double psi, slenderness, critical;  ///< degrees, b/h, degrees
    friend std::ostream& operator<<(std::ostream& out, const BoundaryCase& c) {
        return out << c.psi << "_" << c.slenderness;
    }
};
class ToeFriction : public testing::TestWithParam<BoundaryCase> {};

// V20. The block starts to rotate about the toe with theta'' = 3 g (sin psi - k cos psi)/(2 h (1 + k^2)). The
// force at the toe is then inclined at phi_c. With friction just below phi_c the toe slides by more than a
// tenth of the arc b theta. Just above it moves by the deformation of the springs under sudden gravity, less
// than a hundredth.
TEST_P(ToeFriction, DecidesWhetherATopplingBlockSlides) {
    const auto [psi, k, critical] = GetParam();
    const double t = std::tan(radians(psi));
    EXPECT_NEAR(std::atan(((1 + 4 * k * k) * t + 3 * k) / (4 + k * k + 3 * k * t)) * 180 / std::numbers::pi,
                critical, 5e-4);
    for (const double offset : {-.3, .3}) {
        Release block{psi, critical + offset, 1, 1 / k};
        block.run(.5, 3e-3);
        ASSERT_GT(block.rotation, 3e-3);
        const std::string set_up = "ψ = " + to_text(psi) + "°, b/h = " + to_text(k) + ", φ = φ_c " +
                                   (offset < 0 ? "-" : "+") + " 0.3°";
        expect_energy_balance("V20", set_up, *block.energy, block.frequency_step);
        Case boundary("V20", set_up,
                      "required; the outcome is read at 3 mrad, before the turn changes the forces");
        boundary.contact_frequency_step(block.frequency_step);
        boundary.expect_outcome("toe", block.toe > .05 * block.rotation ? "slides" : "stays",
                                offset < 0 ? "slides" : "stays");
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, ToeFriction,
                         testing::Values(BoundaryCase{30, .3, 20.082}, BoundaryCase{30, .5, 27.425},
                                         BoundaryCase{40, .4, 26.500}, BoundaryCase{45, .5, 31.329},
                                         BoundaryCase{20, .2, 13.498}));

}  // namespace
}  // namespace rockslope::modes_test
