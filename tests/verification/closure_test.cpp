// Joints that close along the hyperbola of Bandis.

#include <gtest/gtest.h>

#include <cmath>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::closure_test {
namespace {

using namespace scene;
using namespace verification;

constexpr double stiffness = 1e9, largest = 1e-4;  // Pa/m, m
constexpr double unit = stiffness * largest;       // Pa, at half the largest closure

/// A stiff block of 1 m with zero Poisson's ratio on a fixed floor; the joint between them has a largest
/// closure.
Scene block_on_joint() {
    Scene s;
    s.model.block_materials[0].poissons_ratio = 0;
    s.model.block_materials[0].damping_ratio = 0;
    s.model.joint_materials[0] = elastic_joint(stiffness, stiffness);
    s.model.joint_materials[0].law = Scene::mohr_coulomb(30);
    s.model.joint_materials[0].largest_closure = largest;
    s.box({-1, -1}, 3, 1, dda::Motion::prescribed, 0, "floor");
    s.box({0, 0}, 1, 1, dda::Motion::free, 0, "block");
    return s;
}

double closure(const dda::State& state) {
    return -(state.contacts.contacts[0].gap + state.contacts.contacts[1].gap) / 2;
}

// V54. The joint under five loads.
TEST(NormalClosure, FollowsTheHyperbola) {
    const Case row("V54", "pressed by a load",
                   "the contacts' forces agree to 1e-9 with the curve in the last iterate, and the "
                   "unbalanced force to 1e-9");
    for (const double stress : {.1, 1., 4., 19., .5}) {
        Scene s = block_on_joint();
        s.model.gravity.setZero();
        for (const double x : {0., 1.})
            s.model.loads.push_back(dda::PointLoad{s.material_point(1, {x, 1}), {0, -unit * stress / 2}, {}});
        Simulation sim(s);
        ASSERT_EQ(sim.settle(.02).status, dda::RunStatus::completed);
        ASSERT_EQ(sim.state.contacts.contacts.size(), 2U);
        row.expect("closure over the largest at " + std::to_string(stress).substr(0, 4) + " k V", "",
                   closure(sim.state) / largest, stress / (1 + stress), relative(1e-6));
    }
}

/// The closure over the largest closure, s, at which the work of a weight equals the energy stored in the
/// joint: k V^2 (-s - ln(1 - s)) = W V s.
double deepest_closure_ratio(double weight) {
    double low = 1e-9, high = 1 - 1e-9;
    for (int k = 0; k < 100; ++k) {
        const double s = (low + high) / 2;
        ((-s - std::log1p(-s)) * unit > weight * s ? high : low) = s;
    }
    return low;
}

// V54. The weight of the block acts suddenly. The block moves down until the joint has stored the work of the
// weight, and returns to its initial position.
TEST(NormalClosure, OscillatesBetweenTheClosuresOfEqualEnergy) {
    const std::string set_up = "weight of k V at once";
    const double weight = unit;
    Scene s = block_on_joint();
    s.model.gravity = {0, -weight / 2500};
    s.model.block_materials[0].youngs_modulus = 1e13;  // rigid beside the joint
    Simulation sim(s);
    double deepest = 0, highest = 1;
    bool rising = false;
    sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
        rising = rising || state.blocks.velocity[1][1] > 0;
        if (rising)
            highest = std::min(highest, closure(state));
        else
            deepest = closure(state);
    };
    dda::Stage stage;
    stage.name = "swing";
    stage.duration = .012;
    stage.newmark_beta = .25;
    stage.newmark_gamma = .5;
    stage.control.step = 1e-5;
    stage.control.force_tolerance = 1e-9;
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    Case row("V54", set_up,
             "a step passes the turning point by up to (omega dt)^2 / 8, omega of the stiffest spring");
    row.contact_frequency_step(sim.contact_frequency_step())
        .expect("deepest closure over the largest", "", deepest / largest, deepest_closure_ratio(weight),
                relative(1e-3));
    row.expect("highest after it, over the largest", "", highest / largest, 0, absolute(1e-3));
    expect_energy_balance("V54", set_up, sim);
}

}  // namespace
}  // namespace rockslope::closure_test
