// Factors of safety of blocks on planes: a slide behind a tension crack with water, two blocks on a bent
// plane.

#include <gtest/gtest.h>

#include "support/record.hpp"
#include "support/scene.hpp"
#include "support/threshold.hpp"

namespace rockslope::plane_slide_test {
namespace {

using namespace scene;
using namespace verification;

/// A simulation that searches for the factor of safety and keeps the bracket found.
struct Searched : Simulation {
    using Simulation::Simulation;
    void trial_done(const dda::Model&, const dda::State&, const dda::Stage&,
                    const dda::ReductionTrial& trial) override {
        if (trial.stands)
            stands = std::max(stands, trial.factor);
        else
            fails = std::min(fails, trial.factor);
    }
    /// The middle of the final bracket, whose relative width is given. In a static step inertia resists with
    /// 2 m/step^2. With 0.5 s that is less than the stiffness of a block of 80 m, so a trial that stands
    /// settles in a few steps.
    double factor_of_safety(double width) {
        dda::Stage stage;
        stage.name = "search";
        stage.kind = dda::StageKind::static_equilibrium;
        stage.step_limit = 500;
        stage.control.step = .5;
        stage.reset_displacements = false;
        stage.strength_reduction = {.1, 10, width, .05};
        EXPECT_EQ(run(stage).status, dda::RunStatus::completed);
        return (stands + fails) / 2;
    }
    double stands = 0;
    double fails = 1e9;
};

struct CrackCase {
    double k;       ///< horizontal acceleration out of the slope, over g
    double filled;  ///< height of the water in the crack over the crack's
    double factor;  ///< of safety, published
    friend std::ostream& operator<<(std::ostream& out, const CrackCase& c) {
        return out << c.k << "_" << c.filled;
    }
};
class TensionCrack : public testing::TestWithParam<CrackCase> {};

// P07. Water presses on the crack with its depth, and on the plane with that pressure at the crack and none
// at the toe. Resistance over drive along the plane: cohesion c L, friction of the effective normal force;
// weight, acceleration and push. The crack at the upper surface that gives the least factor is H (1 -
// sqrt(tan plane / tan face)) deep.
TEST_P(TensionCrack, HasTheFactorOfHoekAndBray) {
    const CrackCase& c = GetParam();
    const double height = 60;
    const double unit_weight = 26e3;
    const double cohesion = 100e3;
    const double face = radians(50);
    const double plane = radians(35);
    const double phi = radians(35);
    const double crack = height * (1 - std::sqrt(std::tan(plane) / std::tan(face)));
    EXPECT_NEAR(crack, 14.01, .005);
    const Vec2 back = (height - crack) * Vec2(1 / std::tan(plane), 1);
    const double length = back.norm();
    const double weight =
        unit_weight / 2 *
        ((height * height - crack * crack) / std::tan(plane) - height * height / std::tan(face));
    const double pressure = 9810 * c.filled * crack;
    const double uplift = pressure * length / 2;
    const double push = pressure * c.filled * crack / 2;
    const double normal =
        weight * (std::cos(plane) - c.k * std::sin(plane)) - uplift - push * std::sin(plane);
    const double drive = weight * (std::sin(plane) + c.k * std::cos(plane)) + push * std::cos(plane);
    const double expected = (cohesion * length + normal * std::tan(phi)) / drive;
    EXPECT_NEAR(expected, c.factor, 6e-4);

    Scene s;
    s.model.gravity = {-c.k * g, -g};
    s.model.block_materials[0].density = unit_weight / g;
    dda::MohrCoulomb law = Scene::mohr_coulomb(35, cohesion);
    law.residual_cohesion = cohesion;  // the whole plane resists at the limit
    s.model.joint_materials[0].law = law;
    const Vec2 along = back / length;
    s.box(-20 * along - 10 * dda::perpendicular(along), length + 40, 10, dda::Motion::fixed, plane);
    const int block =
        s.block({{Vec2(0, 0), back, Vec2(back.x(), height), Vec2(height / std::tan(face), height)}});
    if (c.filled > 0) {
        const std::vector<dda::LoadedFace> faces = {{{4 * block, 0, 1}, 0, pressure},
                                                    {{4 * block + 1, 0, c.filled}, pressure, 0}};
        s.model.loads.push_back(dda::LineLoad{faces, {}});
    }
    Searched sim(s);
    const double found = sim.factor_of_safety(.005);
    Case slide("P07", "k = " + to_text(c.k) + ", z_w/z = " + to_text(c.filled),
               "required; the search ends with a bracket of 0.5 %");
    slide.contact_frequency_step(sim.contact_frequency_step());
    slide.expect("factor of safety", "", found, expected, relative(.02));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, TensionCrack,
                         testing::Values(CrackCase{0, 0, 1.584}, CrackCase{0, .5, 1.416},
                                         CrackCase{0, 1, 1.206}, CrackCase{.08, 0, 1.372},
                                         CrackCase{.08, .5, 1.223}, CrackCase{.08, 1, 1.040}));

// P11. The upper block slides down 45 degrees with a friction of 30, the lower one down 15 with 35, and on
// the upright joint between them, with 25, the upper one slides down. Each has its plane's force N (normal +
// mobilised friction) and the joint's force, which is the same for both; at the factor F all frictions are
// tan(phi)/F. The lower corner of the upper block is cut off: a block cannot pass the bend without crushing.
TEST(BentPlane, HasTheFactorOfTwoForcePolygons) {
    constexpr std::array<double, 3> phi = {30, 25, 35};  // of the upper plane, the joint, the lower plane
    const auto direction = [](double dip) { return Vec2(std::cos(radians(dip)), std::sin(radians(dip))); };
    const Vec2 head = 8 * direction(45);
    const Vec2 toe = -10 * direction(15);
    const std::vector<Vec2> upper = {Vec2(.3, .3), head, Vec2(0, head.y()), Vec2(0, .7)};
    const std::vector<Vec2> lower = {toe, Vec2(0, 0), Vec2(0, head.y()), Vec2(-4, head.y() - 1)};
    const auto weight = [](const std::vector<Vec2>& ring) {
        double area = 0;
        for (std::size_t k = 0; k < ring.size(); ++k)
            area += dda::cross(ring[k], ring[(k + 1) % ring.size()]) / 2;
        return 2500 * g * area;
    };
    // The horizontal force missing for the equilibrium of the lower block, downhill positive.
    const auto missing = [&](double factor) {
        const auto friction = [&](int k) {
            return std::tan(radians(phi[static_cast<std::size_t>(k)])) / factor;
        };
        const auto on_plane = [&](double dip, double mu) -> Vec2 {
            return dda::perpendicular(direction(dip)) + mu * direction(dip);
        };
        const Vec2 a = on_plane(45, friction(0));
        const double joint = -a.x() * weight(upper) / (a.y() - friction(1) * a.x());
        const Vec2 b = on_plane(15, friction(2));
        return joint - b.x() * (weight(lower) + joint * friction(1)) / b.y();
    };
    const double expected = threshold(.3, 5, 50, [&](double factor) { return missing(factor) > 0; });

    Scene s;
    s.model.block_materials[0].youngs_modulus = 1e12;  // the statics' blocks are rigid
    s.model.normal_penalty = s.model.shear_penalty = 1e12;
    s.model.joint_materials.clear();
    for (const double degrees : phi)
        s.model.joint_materials.push_back({"joint", Scene::mohr_coulomb(degrees), 0, 0});
    const Vec2 far_toe = 1.4 * toe;
    const Vec2 far_head = 1.5 * head;
    s.block({{far_toe, far_toe - Vec2(0, 5), far_head + Vec2(5, -20), far_head, Vec2(0, 0)}},
            dda::Motion::fixed);
    s.block({upper});
    s.block({lower});
    const std::pair<int, int> materials[] = {{3, 0},  {5, 0}, {7, 1},
                                             {10, 1}, {4, 2}, {9, 2}};  // of the edges
    for (const auto& [edge, material] : materials) s.model.topology.joint_material[edge] = material;
    Searched sim(s);
    const double found = sim.factor_of_safety(.002);
    Case bent("P11", "planes of 45° and 15°, φ = 30°, 35°, and 25° between the blocks",
              "required; the search ends with a bracket of 0.2 %");
    bent.contact_frequency_step(sim.contact_frequency_step());
    bent.expect("factor of safety", "", found, expected, relative(.005));
}

}  // namespace
}  // namespace rockslope::plane_slide_test
