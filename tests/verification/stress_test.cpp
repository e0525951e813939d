// Stresses and strains of blocks at rest.

#include <gtest/gtest.h>

#include "support/penalty_series.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::stress_test {
namespace {

using namespace scene;
using namespace verification;

/// Forces on the corners of a unit square that make a uniform traction: top and bottom, then right and left.
void add_corner_tractions(Scene& s, int block, const Vec2& top, const Vec2& right) {
    const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const Vec2& corner : corners) {
        const Vec2 force = (corner.y() > 0.5 ? 0.5 : -0.5) * top + (corner.x() > 0.5 ? 0.5 : -0.5) * right;
        s.model.loads.push_back(dda::PointLoad{s.material_point(block, corner), force, {}});
    }
}

const std::string strain_reason = "the square's own size changes by 1e-4, and settling has a tolerance";

/// The strains of a square from its corner positions, exact for an affine displacement.
dda::Vec3 strains(const Simulation& sim) {
    const auto& v = sim.state.blocks.vertices;
    const Vec2 along = v[1] - v[0];
    const Vec2 up = v[3] - v[0];
    return {along.x() - 1, up.y() - 1, along.y() + up.x()};
}

// V05, V06. Hooke's law. The tolerance of 0.1 % covers the change of size of the square (strains of 1e-4) and
// the tolerance of the static stage.
TEST(Elasticity, UniaxialCompression) {
    for (const auto& [plane, axial, lateral] : {std::tuple{dda::Plane::stress, -1e-4, 2.5e-5},
                                                std::tuple{dda::Plane::strain, -9.375e-5, 3.125e-5}}) {
        Scene s;
        s.model.plane = plane;
        s.model.gravity.setZero();
        add_corner_tractions(s, s.box({0, 0}, 1, 1), {0, -1e6}, {0, 0});
        Simulation sim(s);
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        const Case pressed("V05", plane == dda::Plane::stress ? "1 MPa, plane stress" : "1 MPa, plane strain",
                           strain_reason);
        pressed.expect("ε_y", "", strains(sim)[1], axial, relative(1e-3));
        pressed.expect("ε_x", "", strains(sim)[0], lateral, relative(1e-3));
        pressed.expect("σ_y", "Pa", sim.stress(0)[1], -1e6, relative(1e-3));
    }
}

TEST(Elasticity, SimpleShear) {
    Scene s;
    s.model.gravity.setZero();
    add_corner_tractions(s, s.box({0, 0}, 1, 1), {1e5, 0}, {0, 1e5});
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    const Case sheared("V06", "τ = 0.1 MPa", strain_reason);
    sheared.expect("γ", "", strains(sim)[2], 2.5e-5, relative(1e-3));
    sheared.expect("τ_xy", "Pa", sim.stress(0)[2], 1e5, relative(1e-3));
}

// V05 with pressure on the faces instead of forces on the corners: both must be the same load.
TEST(Elasticity, PressureOnFacesCompressesAsForcesOnCornersDo) {
    Scene s;
    s.model.plane = dda::Plane::stress;
    s.model.gravity.setZero();
    s.box({0, 0}, 1, 1);
    dda::LineLoad load;
    for (const int edge : {0, 2}) load.faces.push_back({{edge, 0, 1}, 1e6, 1e6, {0, 0}, {0, 0}});
    s.model.loads.push_back(load);
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    Case("V05", "plane stress, pressure on two faces", "change of the square's own size, 1e-4")
        .contact_frequency_step(sim.contact_frequency_step())
        .expect("eps_y", "1", strains(sim)[1], -1e-4, relative(1e-3));
    EXPECT_NEAR(strains(sim)[0], 2.5e-5, 1e-3 * 2.5e-5);
}

// V02, V03. The penetration is W over two springs; the virial stress of self-weight is sigma_y = -rho g h /
// 2, sigma_x = 0. The block does not drift in ten seconds.
TEST(BlockAtRest, PenetratesByItsWeightAndStays) {
    Scene s;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    const int block = s.box({0, 0}, 1, 1);
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    Case rest("V02", "1 m square on a fixed base", "required; settled to 1e-9 of the weight");
    rest.contact_frequency_step(sim.contact_frequency_step());
    rest.expect("penetration", "m", sim.reports.back().largest_penetration, 2.4525e-7, relative(.01));
    Case stress("V03", "1 m square on a fixed base", "required; 1 % of σ_y");
    stress.contact_frequency_step(sim.contact_frequency_step());
    stress.expect("σ_y", "Pa", sim.stress(block)[1], -12262.5, relative(.01));
    stress.expect("σ_x", "Pa", sim.stress(block)[0], 0, absolute(122.6));
    ASSERT_EQ(sim.shake(10, 0.005).status, dda::RunStatus::completed);
    rest.contact_frequency_step(sim.contact_frequency_step());
    rest.expect_below("drift in 10 s", "m", sim.moved(block).norm(), 1e-6);
}

// V02, V03. The stress does not depend on the penalty, the penetration is proportional to 1/penalty.
TEST(BlockAtRest, HasTheSameStressForAnyPenalty) {
    const auto settled = [](const ContactSetting& setting) {
        Scene s;
        setting.apply(s);
        s.box({-1, -1}, 3, 1, dda::Motion::fixed);
        s.box({0, 0}, 1, 1);
        Simulation sim(s);
        EXPECT_EQ(sim.settle().status, dda::RunStatus::completed);
        return sim;
    };
    for (const ContactSetting& setting : settings(1e-9)) {
        const Simulation sim = settled(setting);
        Case stress("V03", setting.name(), "settled to 1e-9 of the weight; strains of 1e-6 move the sides");
        stress.contact_frequency_step(sim.contact_frequency_step());
        stress.expect("σ_y", "Pa", sim.stress(1)[1], -12262.5, relative(1e-5));
        stress.expect("σ_x", "Pa", sim.stress(1)[0], 0, absolute(.1));
    }
    expect_first_order(
        "V02", "1 m square on a fixed base", "height of its base", {1e-9, 1e-9, 1.001 * 12262.5 / 10e9},
        [&](const ContactSetting& setting) { return settled(setting).state.blocks.vertices[4].y(); });
}

// V04. In a smooth column the k-th block from the top carries k - 1/2 blocks.
TEST(Column, StressGrowsWithDepth) {
    Scene s;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    for (int k = 0; k < 10; ++k) s.box({0, double(k)}, 1, 1);
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    Curve statics{"ρ g (k - 1/2)", {}, {}};
    Curve engine{"engine", {}, {}};
    for (int k = 1; k <= 10; ++k) {
        const double expected = -2500 * g * (k - 0.5);
        statics.x.push_back(k);
        statics.y.push_back(-expected / 1e3);
        engine.x.push_back(k);
        engine.y.push_back(-sim.stress(11 - k)[1] / 1e3);
        Case("V04", "block " + std::to_string(k) + " from the top", "required; settled to 1e-9 of the weight")
            .contact_frequency_step(sim.contact_frequency_step())
            .expect("σ_y", "Pa", sim.stress(11 - k)[1], expected, relative(.01));
    }
    record_picture("V04", "stress", "V04: vertical stress in a column", "block from the top",
                   "compression, kPa", {statics, engine});
}

// V04. Each of the ten joints below the top deforms by its force over the penalty.
TEST(Column, HasTheSameStressForAnyPenalty) {
    const auto settled = [](const ContactSetting& setting) {
        Scene s;
        setting.apply(s);
        s.box({-1, -1}, 3, 1, dda::Motion::fixed);
        for (int k = 0; k < 10; ++k) s.box({0, double(k)}, 1, 1);
        Simulation sim(s);
        EXPECT_EQ(sim.settle().status, dda::RunStatus::completed);
        return sim;
    };
    for (const ContactSetting& setting : settings(1e-9)) {
        const Simulation sim = settled(setting);
        Case stress("V04", setting.name(),
                    "settled to 1e-9 of the weight; strains of 2e-5 move sides and heights");
        stress.contact_frequency_step(sim.contact_frequency_step());
        for (const int k : {1, 5, 10})
            stress.expect("σ_y in block " + std::to_string(k) + " from the top", "Pa", sim.stress(11 - k)[1],
                          -2500 * g * (k - .5), relative(1e-4));
    }
    expect_first_order("V04", "smooth column", "sinking of its top",
                       {1e-9, 1e-8, 1.001 * 55 * 12262.5 / 10e9}, [&](const ContactSetting& setting) {
                           return -settled(setting).state.blocks.vertices[4 * 10 + 2].y() + 10;
                       });
}

// V07. n blocks on n joints of stiffness k = 1e12 Pa/m: 1/E_eff = 1/E + 1/(k h), in compression and in
// tension. The remaining error is the strain, 1e-4, because the load does not move with the deformed blocks.
// The joints are soft in shear; otherwise the fixed base would prevent lateral strain of all blocks.
TEST(Chain, IsAsSoftAsBlocksAndJointsInSeries) {
    for (const double stress : {-1e6, 1e6}) {
        Scene s;
        s.model.plane = dda::Plane::stress;
        s.model.gravity.setZero();
        s.model.joint_materials[0] = elastic_joint(1e12, 1e6);
        const int n = 5;
        s.box({-1, -1}, 3, 1, dda::Motion::fixed);
        for (int k = 0; k < n; ++k) s.box({0, double(k)}, 1, 1);
        for (const double x : {0.0, 1.0}) {
            s.model.loads.push_back(dda::PointLoad{s.material_point(n, {x, n}), {0, stress / 2}, {}});
        }
        Simulation sim(s);
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        const double lengthening = sim.state.blocks.points[0].y() - n;
        Case("V07", std::string("five blocks, k = 1e12 Pa/m, ") + (stress < 0 ? "pushed" : "pulled"),
             "strains of 1e-4 move the load")
            .contact_frequency_step(sim.contact_frequency_step())
            .expect("E_eff", "Pa", stress * n / lengthening, 9.901e9, relative(1e-3));
    }
}

// V07. The compliance of the joints, 1/E_eff - 1/E = 1/(k h), is first-order in 1/k. A load of 10 kPa strains
// the blocks by 1e-6. That is the relative error of the blocks' compliance, a thousandth of the compliance of
// the stiffest joints.
TEST(Chain, ComplianceIsOfFirstOrderInThatOfTheJoints) {
    std::vector<double> added;
    for (const double k : {1e11, 1e12, 1e13}) {
        Scene s;
        s.model.plane = dda::Plane::stress;
        s.model.gravity.setZero();
        s.model.joint_materials[0] = elastic_joint(k, 1e4);
        s.box({-1, -1}, 3, 1, dda::Motion::fixed);
        for (int n = 0; n < 5; ++n) s.box({0, double(n)}, 1, 1);
        for (const double x : {0.0, 1.0})
            s.model.loads.push_back(dda::PointLoad{s.material_point(5, {x, 5}), {0, -5e3}, {}});
        Simulation sim(s);
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        added.push_back((5 - sim.state.blocks.points[0].y()) / 5 / 1e4 - 1 / 10e9);
        Case("V07", "five blocks, k = " + to_text(k) + " Pa/m, 10 kPa", "strains of 1e-6 of the blocks' own")
            .expect("1/E_eff - 1/E", "1/Pa", added.back(), 1 / k, relative(2e-3));
    }
    Case("V07", "five blocks, k = 1e11 to 1e13 Pa/m", "as each of the three within 0.2 %")
        .expect("order of 1/E_eff - 1/E in 1/k", "", std::log10(added[0] / added[2]) / 2, 1, absolute(1e-3));
}

}  // namespace
}  // namespace rockslope::stress_test
