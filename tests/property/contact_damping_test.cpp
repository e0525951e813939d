// Impacts on contacts with a dashpot, Eqs. (86) to (89): restitution, bounces of a dropped block, energy.
//
// A stiff block on springs of which each bears a part of its mass m is an oscillator of frequency omega. With
// a dashpot of the ratio zeta that never pulls it leaves the springs with the fraction e of its speed, Eq.
// (89).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/scene.hpp"

namespace rockslope::contact_damping_test {
namespace {

using namespace scene;

/// The coefficient of restitution of a damped spring that never pulls, Eq. (89).
double restitution(double ratio) {
    if (ratio == 1) return std::exp(-2);
    const double root = std::sqrt(std::abs(1 - ratio * ratio));
    const double angle = ratio < 1
                             ? std::numbers::pi - std::atan2(2 * ratio * root, root * root - ratio * ratio)
                             : std::log((ratio + root) / (ratio - root));
    return std::exp(-ratio / root * angle);
}

TEST(ContactDamping, ClosedFormOfTheRestitution) {
    EXPECT_NEAR(restitution(0.1), 0.7441, 5e-5);
    EXPECT_NEAR(restitution(0.2), 0.5717, 5e-5);
    EXPECT_NEAR(restitution(0.4), 0.3635, 5e-5);
    EXPECT_NEAR(restitution(1), 0.1353, 5e-5);
    EXPECT_NEAR(restitution(1 - 1e-6), restitution(1), 1e-5) << "continuous at critical damping";
    EXPECT_NEAR(restitution(1 + 1e-6), restitution(1), 1e-5);
}

constexpr double density = 2500;

/// A block that hits a wall face to face without gravity, on springs of any number and share.
struct Collision {
    double ratio = 0;    ///< contact_damping
    double step = 0.1;   ///< omega dt
    double phase = 0.5;  ///< part of a step that the block flies before it meets the wall
    double beta = 0.5, gamma = 1;
    double height = 1;           ///< m, of the block, whose width is 1 m
    int supports = 1;            ///< blocks that make up the wall; each has two contacts with the block
    double modulus = 1e6;        ///< Young's modulus of the block over the sum of the springs
    double largest_closure = 0;  ///< m; above 0 the springs are a joint's own

    /// Speed after the impact over that before, and the energy balance.
    double kept() const {
        const double dt = 1e-3, speed = 0.01;
        const double frequency = step / dt;
        const double stiffness = density * height * frequency * frequency;
        Scene s;
        s.model.gravity.setZero();
        s.model.block_materials[0].damping_ratio = 0;
        s.model.block_materials[0].youngs_modulus = modulus * stiffness;
        s.model.normal_penalty = s.model.shear_penalty = stiffness / (2 * supports);
        dda::JointMaterial& joint = s.model.joint_materials[0];
        joint.contact_damping = ratio;
        if (largest_closure > 0) {
            joint.normal_stiffness = joint.shear_stiffness = stiffness / height;
            joint.largest_closure = largest_closure;
        }
        const double gap = phase * speed * dt;
        for (int k = 0; k < supports; ++k)
            s.box({-1, k * height / supports}, 1, height / supports, dda::Motion::fixed);
        const int block = s.box({gap, 0}, 1, height);
        Simulation sim(s);
        sim.velocity(block)[0] = -speed;
        sim.restart_ledger();
        dda::Stage stage;
        stage.name = "impact";
        // An overdamped block leaves a spring late, at a rate of omega / (2 zeta).
        stage.duration = (10 + std::ceil((4 + 20 * ratio) / step)) * dt;
        stage.control.step = dt;
        stage.newmark_beta = beta;
        stage.newmark_gamma = gamma;
        double damped = 0, least = 0;
        sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
            least = std::min(least, state.energy.contact_damping_loss - damped);
            damped = state.energy.contact_damping_loss;
        };
        EXPECT_EQ(sim.run(stage).status, dda::RunStatus::completed);
        const double kinetic = density * height * speed * speed / 2;
        EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-6 * kinetic);
        EXPECT_EQ(least, 0) << "a dashpot takes energy in every step";
        EXPECT_LT(std::abs(sim.velocity(block)[1]), 1e-6 * speed) << "no friction, no sideways motion";
        const double e = sim.velocity(block)[0] / speed;
        if (ratio == 0) {
            EXPECT_EQ(damped, 0);
        } else if (ratio > step / 4 && gamma == 1) {
            EXPECT_NEAR(damped, (1 - e * e) * kinetic, 1e-5 * kinetic) << "the dashpot took all that is lost";
        }
        return e;
    }
};

// The error is of second order in omega dt; its size depends on the phase. From a step to its quarter it
// falls by a factor of 16; a factor of 6 is asked of the largest error over four phases. 1e-4 allows for
// phases that are not the worst.
TEST(ContactDamping, RestitutionConvergesToTheClosedForm) {
    for (const double ratio : {0.1, 0.2, 0.4, 1., 2.}) {
        SCOPED_TRACE(ratio);
        const double expected = restitution(ratio);
        double coarse = 0, fine = 0;
        for (const double phase : {0.05, 0.3, 0.6, 0.9}) {
            coarse = std::max(
                coarse, std::abs(Collision{.ratio = ratio, .step = 0.2, .phase = phase}.kept() - expected));
            fine = std::max(
                fine, std::abs(Collision{.ratio = ratio, .step = 0.05, .phase = phase}.kept() - expected));
        }
        EXPECT_LT(coarse, 5e-3);
        EXPECT_LT(fine, coarse / 6 + 1e-4);
    }
}

// The sum of the springs, not their number, sets the frequency: each contact has its part of the block's
// mass, wherever it is. A slender block is the harder case, since its contacts are far from the centroid.
TEST(ContactDamping, ABlockThatLandsFlatHasTheRatioWhateverBearsIt) {
    for (const double ratio : {0.2, 1.}) {
        for (const double height : {0.2, 1., 5.}) {
            for (const int supports : {1, 2, 5}) {
                SCOPED_TRACE(testing::Message() << ratio << ", " << height << " m on " << supports);
                const Collision collision{
                    .ratio = ratio, .step = 0.05, .height = height, .supports = supports};
                EXPECT_NEAR(collision.kept(), restitution(ratio), 1e-3);
            }
        }
    }
}

/// Two blocks of the same size that meet face to face, in the frame of their common centroid.
TEST(ContactDamping, TwoFreeBlocksHaveTheRatioOfTheirRelativeMotion) {
    for (const double ratio : {0.2, 1.}) {
        const double dt = 1e-3, frequency = 50, speed = 0.01;
        Scene s;
        s.model.gravity.setZero();
        s.model.block_materials[0].damping_ratio = 0;
        // Two springs in parallel between two masses: omega^2 = 2 k (1/m + 1/m).
        s.model.normal_penalty = s.model.shear_penalty = density * frequency * frequency / 4;
        s.model.block_materials[0].youngs_modulus = 1e6 * s.model.normal_penalty;
        s.model.joint_materials[0].contact_damping = ratio;
        const double gap = 0.5 * speed * dt;
        s.box({-1 - gap, 0}, 1, 1);
        s.box({0, 0}, 1, 1);
        Simulation sim(s);
        sim.velocity(0)[0] = speed / 2;
        sim.velocity(1)[0] = -speed / 2;
        sim.restart_ledger();
        ASSERT_EQ(sim.shake(0.5, dt).status, dda::RunStatus::completed);
        EXPECT_NEAR((sim.velocity(1)[0] - sim.velocity(0)[0]) / speed, restitution(ratio), 1e-3);
        EXPECT_LT(std::abs(sim.velocity(1)[0] + sim.velocity(0)[0]), 1e-9 * speed) << "momentum";
    }
}

// Without a dashpot the default integration damps by zeta = omega dt / 4, and a contact_damping below that
// changes nothing but the account in which the loss is booked.
TEST(ContactDamping, TheIntegrationsOwnDampingIsAPartOfIt) {
    double undamped_mean = 0;
    for (const double phase : {0.125, 0.375, 0.625, 0.875}) {
        const Collision undamped{.ratio = 0, .step = 0.5, .phase = phase};
        const Collision weak{.ratio = 0.1, .step = 0.5, .phase = phase};
        EXPECT_NEAR(weak.kept(), undamped.kept(), 1e-6);
        undamped_mean += undamped.kept() / 4;
    }
    EXPECT_NEAR(undamped_mean, restitution(0.125), 0.015) << "to second order in omega dt = 0.5";
}

// (1/4, 1/2) has no damping of its own; the dashpot is then of first order.
TEST(ContactDamping, IsOfFirstOrderWithoutNumericalDamping) {
    const auto error = [](double step) {
        double largest = 0;
        for (const double phase : {0.05, 0.3, 0.6, 0.9}) {
            const Collision c{.ratio = 0.2, .step = step, .phase = phase, .beta = 0.25, .gamma = 0.5};
            largest = std::max(largest, std::abs(c.kept() - restitution(0.2)));
        }
        return largest;
    };
    const double coarse = error(0.1);
    EXPECT_LT(coarse, 0.02);
    EXPECT_LT(error(0.025), coarse / 3);
}

// A hyperbola that is nearly straight over the impact gives the restitution of the line. One that stiffens by
// a factor of 16 has the damping ratio of its tangent throughout and loses no less and no more than half
// again.
TEST(ContactDamping, HoldsForJointsThatCloseAlongAHyperbola) {
    const double speed = 0.01, dt = 1e-3;
    const double depth = speed * dt / 0.05;  // of an undamped impact at omega dt = 0.05
    for (const double ratio : {0.2, 1.}) {
        const Collision straight{.ratio = ratio, .step = 0.05, .largest_closure = 1e4 * depth};
        EXPECT_NEAR(straight.kept(), restitution(ratio), 1e-3);
        const Collision curved{.ratio = ratio, .step = 0.05, .largest_closure = depth};
        EXPECT_NEAR(curved.kept(), restitution(ratio), 0.5 * restitution(ratio));
    }
}

// A rigid block dropped from 1 m with zeta = 0.2: impacts and rest by the closed form, in which a contact
// lasts no time. The contact lasts 3 ms at 1000 rad/s, a hundredth of a flight, and the times are those of
// the first touch; hence 1 % of the first flight.
TEST(ContactDamping, ADroppedBlockBouncesAsTheClosedFormSays) {
    const double frequency = 1000, dt = 1e-4, height = 1;
    Scene s;
    s.model.normal_penalty = s.model.shear_penalty = density * frequency * frequency / 2;
    s.model.block_materials[0].youngs_modulus = 1e4 * s.model.normal_penalty;
    s.model.joint_materials[0].contact_damping = 0.2;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    const int block = s.box({0, height}, 1, 1);
    Simulation sim(s);
    std::vector<double> impacts, apexes;
    bool was_in_contact = false;
    double highest = 0;
    sim.on_step = [&](const dda::State& state, const dda::StepReport& report) {
        const bool in_contact = report.sliding + report.locked > 0;
        const double above = height + sim.moved(block).y();
        if (in_contact && !was_in_contact) {
            impacts.push_back(state.time);
            if (impacts.size() > 1) apexes.push_back(highest);
            highest = 0;
        }
        highest = in_contact ? 0 : std::max(highest, above);
        was_in_contact = in_contact;
    };
    dda::Stage stage;
    stage.name = "drop";
    stage.duration = 2;
    stage.control.step = dt;
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    const double e = restitution(0.2);
    const std::vector<double> expected = {0.4515, 0.9678, 1.2630, 1.4318};
    ASSERT_GE(impacts.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_NEAR(impacts[k], expected[k], 0.01 * expected[0]);
    EXPECT_NEAR(apexes[0], 0.3269, 0.005);
    EXPECT_NEAR(apexes[1] / apexes[0], e * e, 0.01);
    EXPECT_NEAR(impacts.back(), 1.6571, 0.05) << "at rest";
    EXPECT_LT(sim.velocity(block).head<2>().norm(), 1e-4);
    const double lost = -density * g * sim.moved(block).y();
    const dda::Energy& energy = sim.state.energy;
    EXPECT_NEAR(energy.contact_damping_loss, lost, 1e-3 * lost);
    EXPECT_LT(std::abs(energy.residual()), 1e-6 * lost);
}

/// A block that falls onto a plane of dip psi, and slides down it once it has landed.
struct Landing {
    double psi = 0;       ///< deg
    double friction = 0;  ///< deg
    double ratio = 0;     ///< contact_damping
    double tilt = 0;      ///< rad, by which the block is turned out of the plane
    double duration = 1;  ///< s
    double step = 5e-4;   ///< s

    double speed = 0;      ///< m/s, down the plane at the end
    double off_plane = 0;  ///< m/s, largest speed across the plane in the last tenth of the time
    dda::Energy energy;    ///< at the end
    double exchanged = 0;  ///< J, largest kinetic energy
    double least = 0;      ///< J, smallest loss of the dashpots in a step

    void run() {
        const double dip = radians(psi);
        const Vec2 along(std::cos(dip), -std::sin(dip));
        const Vec2 up = dda::perpendicular(along);
        Scene s;
        s.friction(friction);
        s.model.block_materials[0].youngs_modulus = 1e12;
        s.model.normal_penalty = s.model.shear_penalty = 1e9;
        s.model.joint_materials[0].contact_damping = ratio;
        s.box(-up - 2 * along, 40, 1, dda::Motion::fixed, -dip);
        const int block = s.box(0.1 * up, 1, 1, dda::Motion::free, -dip + tilt);
        Simulation sim(s);
        double damped = 0;
        sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
            least = std::min(least, state.energy.contact_damping_loss - damped);
            damped = state.energy.contact_damping_loss;
            exchanged = std::max(exchanged, state.energy.kinetic);
            double largest = 0;
            for (const dda::Contact& c : state.contacts.contacts) largest = std::max(largest, c.normal_force);
            const double tolerance = 4e-6 * largest + 1e-3;  // four times the force tolerance, and rounding
            for (const dda::Contact& c : state.contacts.contacts) {
                EXPECT_GE(c.normal_force, 0) << "a dashpot never pulls";
                const double bound = c.normal_force * std::tan(radians(friction));
                EXPECT_LE(std::abs(c.shear_force), bound + tolerance);
                if (c.state != dda::ContactState::sliding) continue;
                EXPECT_GE(std::abs(c.shear_force), bound - tolerance) << "the bound contains the dashpot";
            }
            if (state.time > 0.9 * duration)
                off_plane = std::max(off_plane, std::abs(state.blocks.velocity[1].head<2>().dot(up)));
        };
        dda::Stage stage;
        stage.name = "landing";
        stage.duration = duration;
        stage.control.step = step;
        ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
        speed = sim.velocity(block).head<2>().dot(along);
        energy = sim.state.energy;
        EXPECT_LT(std::abs(energy.residual()), 1e-3 * exchanged);
        EXPECT_GE(least, 0);
    }
};

// The block lands at psi = 20 deg with friction 10 deg, bounces a few times and slides. The normal impulse
// from rest to rest across the plane is m g cos(psi) t, whatever the restitution, and friction takes tan(phi)
// of it as long as the block slides: v = g (sin psi - cos psi tan phi) t. 1 % allows for the time between the
// last bounce and the end.
TEST(ContactDamping, FrictionFollowsTheWholeNormalForceOfALanding) {
    for (const double ratio : {0.2, 1.}) {
        Landing landing;
        landing.psi = 20;
        landing.friction = 10;
        landing.ratio = ratio;
        landing.duration = 1.5;
        landing.run();
        const double expected =
            g * (std::sin(radians(20)) - std::cos(radians(20)) * std::tan(radians(10))) * landing.duration;
        EXPECT_NEAR(landing.speed, expected, 0.01 * expected);
        EXPECT_LT(landing.off_plane, 1e-3);
        EXPECT_GT(landing.energy.contact_damping_loss, 0);
        EXPECT_EQ(landing.energy.friction_returned, 0);
    }
}

// Turned by a tenth the block falls on a corner, then on the other one, and so on until it lies flat.
TEST(ContactDamping, ABlockThatFallsOnItsCornerComesToRest) {
    for (const double ratio : {0.2, 1., 3.}) {
        Landing landing;
        landing.friction = 40;
        landing.ratio = ratio;
        landing.tilt = 0.1;
        landing.duration = 2;
        landing.run();
        EXPECT_LT(landing.off_plane, 1e-3);
        EXPECT_NEAR(landing.speed, 0, 1e-3);
        const dda::Energy& e = landing.energy;
        EXPECT_NEAR(e.contact_damping_loss + e.friction_loss + e.numerical_loss + e.damping_loss + e.released,
                    -e.gravity, 0.01 * landing.exchanged);
        EXPECT_GT(e.contact_damping_loss, 0.5 * -e.gravity);
    }
}

// A block on a joint that dilates, thrown up at 0.5 m/s and along at 1 m/s. The walls below it part by
// tan(19.9 deg) = 0.362 along its way, i = 6 log10(50e6 / 24525), so it lands after 2 (0.5 - 0.362) / g =
// 0.028 s, hops and brakes. A damped one soon stays; an undamped one later.
TEST(ContactDamping, ABlockOnADilatingJointLandsAndStays) {
    const auto law = [] {
        dda::CyclicBartonBandis made;
        made.barton = {6, 50e6, radians(20)};
        made.peak_displacement = 2e-3;
        made.damage = 1;
        const dda::RoughnessTable wear = {{{0, 1}, {1, 1}}};
        made.cycles = {{wear, wear, wear, wear}};
        made.unsigned_ratios = true;
        return made;
    }();
    double undamped_landing = 0;  // s, the last one
    for (const double ratio : {0., 1., 2.}) {
        SCOPED_TRACE(ratio);
        Scene s;
        s.model.joint_materials[0].law = law;
        s.model.joint_materials[0].contact_damping = ratio;
        s.model.block_materials[0].youngs_modulus = 1e13;
        s.model.normal_penalty = s.model.shear_penalty = 1e9;
        s.box({-5, -1}, 15, 1, dda::Motion::fixed);
        const int block = s.box({0, 0}, 2, 1);
        Simulation sim(s);
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        sim.velocity(block).head<2>() = Vec2(1, 0.5);
        sim.restart_ledger();
        double last_open = 0, damped = 0, least = 0;
        sim.on_step = [&](const dda::State& state, const dda::StepReport& report) {
            if (report.sliding + report.locked == 0) last_open = state.stage_time;
            least = std::min(least, state.energy.contact_damping_loss - damped);
            damped = state.energy.contact_damping_loss;
        };
        ASSERT_EQ(sim.shake(0.6, 2e-4).status, dda::RunStatus::completed);
        EXPECT_GT(last_open, 0.028);
        if (ratio == 0) {
            undamped_landing = last_open;
        } else {
            EXPECT_LT(last_open, 0.2);
            EXPECT_LT(last_open, undamped_landing / 2);
        }
        EXPECT_EQ(least, 0);
        EXPECT_EQ(damped > 0, ratio > 0);
        EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-5 * damped + 0.01);
    }
}

}  // namespace
}  // namespace rockslope::contact_damping_test
