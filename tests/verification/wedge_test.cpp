// Wedges between blocks: in a notch, splitting two blocks, and in a roof.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/penalty_series.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::wedge_test {
namespace {

using namespace scene;
using namespace verification;

/// Sums over the contacts between two blocks: normal force and shear force, N, and the numbers of closed and
/// of sliding contacts.
struct Joint {
    double normal = 0;
    double shear = 0;
    int touching = 0;
    int sliding = 0;
};
Joint between(const dda::State& state, int a, int b) {
    Joint sum;
    for (const dda::Contact& c : state.contacts.contacts) {
        if (c.state == dda::ContactState::open) continue;
        if (!((c.corner_block == a && c.edge_block == b) || (c.corner_block == b && c.edge_block == a)))
            continue;
        sum.normal += c.normal_force;
        sum.shear += std::abs(c.shear_force);
        ++sum.touching;
        sum.sliding += c.state == dda::ContactState::sliding ? 1 : 0;
    }
    return sum;
}

/// A wedge that points down, between two side blocks whose faces stand at `half_angle` (rad) to the vertical.
struct WedgeScene : Scene {
    WedgeScene(double half_angle, dda::Motion sides) {
        const double t = std::tan(half_angle);
        const double b = .2;  // half the wedge's lower edge, m
        wedge = block({{{-b, 0}, {b, 0}, {b + t, 1}, {-b - t, 1}}});
        left = block({{{-3, -.5}, {-b + .5 * t, -.5}, {-b - 1.5 * t, 1.5}, {-3, 1.5}}}, sides, "left");
        right = block({{{b - .5 * t, -.5}, {3, -.5}, {3, 1.5}, {b + 1.5 * t, 1.5}}}, sides, "right");
    }
    int wedge, left, right;
};

// V45. Vertical equilibrium of the wedge is 2 (N sin a + S cos a) = W. Elastic sinking shears the faces by
// cot a times their compression, so for phi < 90 - a all contacts slip at once and S = N tan(phi).
TEST(Notch, HasTheForcesOfFullSlip) {
    for (const double phi : {0., 15.}) {
        const double a = radians(30);
        WedgeScene s(a, dda::Motion::fixed);
        s.friction(phi);
        Simulation sim(s);
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        const double weight = sim.state.blocks.mass[s.wedge] * g;
        const double expected = std::cos(radians(phi)) / (2 * std::sin(a + radians(phi)));
        EXPECT_NEAR(expected, phi == 0 ? 1 : .68301, 1e-5);
        Case notch("V45", "half-angle 30°, φ = " + to_text(phi) + "°",
                   "required; settled to 1e-9 of the weight");
        notch.contact_frequency_step(sim.contact_frequency_step());
        notch.expect("N/W on the left face", "", between(sim.state, s.wedge, s.left).normal / weight,
                     expected, relative(.01));
        notch.expect("N/W on the right face", "", between(sim.state, s.wedge, s.right).normal / weight,
                     expected, relative(.01));
    }
}

// V45. The forces do not depend on the penalty. Without friction the wedge sinks by a penetration over sin a.
// With friction the forces are those of full slip, which the wedge reaches by sinking. With rigid contacts it
// sinks because it is squeezed.
TEST(Notch, HasTheSameForcesForAnyPenalty) {
    const double a = radians(30);
    for (const double phi : {0., 15.}) {
        const auto settled = [&](const ContactSetting& setting) {
            WedgeScene s(a, dda::Motion::fixed);
            s.friction(phi);
            setting.apply(s);
            Simulation sim(s);
            EXPECT_EQ(sim.settle().status, dda::RunStatus::completed);
            return sim;
        };
        const std::string friction = "half-angle 30°, φ = " + to_text(phi) + "°";
        const double expected = std::cos(radians(phi)) / (2 * std::sin(a + radians(phi)));
        for (const ContactSetting& setting : settings(1e-9)) {
            const Simulation sim = settled(setting);
            const double weight = sim.state.blocks.mass[0] * g;
            Case notch("V45", friction + ", " + setting.name(), "settled to 1e-9 of the weight");
            notch.contact_frequency_step(sim.contact_frequency_step());
            notch.expect("N/W on the left face", "", between(sim.state, 0, 1).normal / weight, expected,
                         relative(1e-4));
            notch.expect("N/W on the right face", "", between(sim.state, 0, 2).normal / weight, expected,
                         relative(1e-4));
        }
        if (phi > 0) continue;
        const double weight = settled({1}).state.blocks.mass[0] * g;
        expect_first_order("V45", friction, "sinking of the wedge",
                           {1e-9, 1e-9 / std::sin(a), weight / 10e9 / std::sin(a)},
                           [&](const ContactSetting& setting) { return -settled(setting).moved(0).y(); });
    }
}

// V46. A force P drives a weightless wedge between two blocks on a smooth floor between smooth walls. P/2 and
// the side force S are the components of a contact force inclined at a + phi: S = P/2/tan(a + phi).
struct SplittingScene : WedgeScene {
    static constexpr double push = 1e5;  // N
    int left_wall, right_wall;

    SplittingScene() : WedgeScene(radians(20), dda::Motion::free) {
        model.gravity.setZero();
        model.joint_materials.push_back({"wedge", Scene::mohr_coulomb(15), 0, 0});
        for (const dda::CornerIndex corner : model.topology.corners_of(wedge))
            model.topology.joint_material[edge_from(corner)] = 1;
        box({-5, -1.5}, 10, 1, dda::Motion::fixed);
        left_wall = box({-4, -.5}, 1, 3, dda::Motion::fixed);
        right_wall = box({3, -.5}, 1, 3, dda::Motion::fixed);
        model.loads.push_back(dda::PointLoad{material_point(wedge, {0, 1}), {0, -push}, {}});
    }
};

void expect_split(const std::string& set_up, const SplittingScene& s, Tolerance tolerance, bool all_slip) {
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    const double expected = s.push / 2 / std::tan(radians(35));
    EXPECT_NEAR(expected, 71407, 1);
    Case split("V46", set_up, "required; settled to 1e-9 of the load");
    split.contact_frequency_step(sim.contact_frequency_step());
    split.expect("force on the left wall", "N", between(sim.state, s.left, s.left_wall).normal, expected,
                 tolerance);
    split.expect("force on the right wall", "N", between(sim.state, s.right, s.right_wall).normal, expected,
                 tolerance);
    if (!all_slip) return;
    const Joint face = between(sim.state, s.wedge, s.left);
    split.expect_outcome("contacts of the wedge", face.sliding == face.touching ? "all slip" : "some stick",
                         "all slip");
}

TEST(SplittingWedge, PushesTheBlocksApart) {
    expect_split("P = 100 kN, half-angle 20°, φ = 15°", SplittingScene(), relative(.02), true);
}

// The forces are those of full slip. With stiff springs one contact of a face stays just below its bound.
TEST(SplittingWedge, HasTheSameForcesForAnyPenalty) {
    for (const ContactSetting& setting : settings(1e-9)) {
        SplittingScene s;
        setting.apply(s);
        expect_split("P = 100 kN, half-angle 20°, φ = 15°, " + setting.name(), s, relative(1e-3), false);
    }
}

struct RoofCase {
    double normal, shear, expected;  ///< springs, N/m; p_l/(2 H0)
    const char* name;
    friend std::ostream& operator<<(std::ostream& out, const RoofCase& c) { return out << c.name; }
};
class RoofWedge : public testing::TestWithParam<RoofCase> {};

// V47. The sides squeeze a weightless wedge, wider below, up to the horizontal force H0 and are then fixed.
// The wedge is pulled down until all contacts slip. A displacement u reduces the normal force by k_n u sin a,
// from H0 cos a, and increases the shear force by k_s u cos a, from H0 sin a. Slip at S = N tan(phi) gives
// the formula of the notes.
TEST_P(RoofWedge, CarriesTheLoadOfTheFormula) {
    const RoofCase& c = GetParam();
    const double a = radians(20);
    const double t = std::tan(a);
    Scene s;
    s.friction(40);
    s.model.gravity.setZero();
    s.model.normal_penalty = c.normal;
    s.model.shear_penalty = c.shear;
    s.model.block_materials[0].youngs_modulus = 1e4 * c.normal;  // the formula's blocks are rigid
    const int wedge = s.block({{{-.2 - t, 0}, {.2 + t, 0}, {.2, 1}, {-.2, 1}}});
    const int left = s.block({{{-3, -.5}, {-.2 - 1.5 * t, -.5}, {-.2 + .5 * t, 1.5}, {-3, 1.5}}},
                             dda::Motion::prescribed, "left");
    const int right = s.block({{{.2 + 1.5 * t, -.5}, {3, -.5}, {3, 1.5}, {.2 - .5 * t, 1.5}}},
                              dda::Motion::prescribed, "right");
    const int point_of_load = s.material_point(wedge, {0, 0});
    const double ramp = 100;      // s, in steps of 0.1 s, whose inertia is negligible beside the springs
    const double squeeze = 1e-5;  // m, of each side

    Simulation sim(s);
    sim.velocity(left)[0] = squeeze;
    sim.velocity(right)[0] = -squeeze;
    dda::Stage stage;
    stage.name = "squeeze";
    stage.duration = 1;
    stage.dynamic_coefficient = 0;
    stage.control.step = 1e-2;
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    sim.velocity(left).setZero();
    sim.velocity(right).setZero();
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    const Joint squeezed = between(sim.state, wedge, left);
    const double side =
        std::hypot(squeezed.normal, squeezed.shear);  // horizontal, for the wedge has no weight

    Scene pulled = s;
    pulled.model.loads.push_back(
        dda::PointLoad{point_of_load, {0, -2 * side}, dda::TimeTable({0, ramp}, {0, .5})});
    Simulation pull(pulled);
    pull.state = sim.state;
    double largest = 0;
    pull.on_step = [&](const dda::State& state, const dda::StepReport&) {
        const Joint face = between(state, wedge, left);
        if (face.touching > 0 && face.sliding < face.touching) largest = .5 * state.stage_time / ramp;
    };
    stage.name = "pull";
    stage.duration = ramp;
    stage.control.step = .1;
    stage.control.displacement_ratio = 10;
    ASSERT_EQ(pull.run(stage).status, dda::RunStatus::completed);
    Case roof("V47", std::string("α = 20°, φ = 40°, ") + c.name,
              "required; the load's increments are 0.0005 of 2 H0");
    roof.contact_frequency_step(pull.contact_frequency_step());
    roof.expect("p_l/(2 H0)", "", largest, c.expected, relative(.03));
    expect_energy_balance("V47", std::string("α = 20°, φ = 40°, ") + c.name, pull);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, RoofWedge,
                         testing::Values(RoofCase{1e9, 1e5, .18199, "k_n = 10000 k_s"},
                                         RoofCase{1e9, 1e8, .24058, "k_n = 10 k_s"},
                                         RoofCase{1e9, 1e9, .36397, "k_n = k_s"}));

}  // namespace
}  // namespace rockslope::wedge_test
