#include "dda/solve/methods/limited_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dda/trial/step_contacts.hpp"
#include "support/cyclic_joints.hpp"
#include "support/first_step.hpp"

namespace rockslope::limited_contacts_test {
namespace {

using namespace scene;

/// The largest difference between the forces of the laws and those of the frozen contacts at the displacement
/// at which they are frozen, over the largest force.
double difference(const dda::JointLaw& law, unsigned seed, double damping) {
    FirstStep step(law);
    dda::StepProblem problem = step.problem();
    dda::PerContact<dda::NormalDashpot> dashpots;
    if (damping > 0) {
        for (const dda::ContactSprings& s : step.springs)
            dashpots.push_back({damping * s.normal_stiffness, 3e-5, 1});
        problem.dashpots = dashpots;
    }
    dda::StepContacts step_contacts(problem, step.pool);
    dda::TrialContacts& trials = step_contacts.trials;
    RandomSource random(seed);
    const std::vector<Vec6> d = moved(random, step.rows.count(), 1);
    trials.set_displacement(d, d);
    step_contacts.entrances.select_first();
    step_contacts.dilation.update();
    step_contacts.bounds.update();
    trials.update_active_set();
    dda::PerContact<dda::LimitedContact> contacts;
    dda::limit_contacts(problem, trials, step_contacts.bounds, d, step.pool, contacts);
    double largest = 0, force = 0;
    for (const dda::ContactIndex k : contacts.indices()) {
        const dda::LimitedContact& c = contacts[k];
        const dda::ElasticForces elastic = c.may_close ? c.elastic_at(d) : dda::ElasticForces();
        const dda::Vec2 found = c.on(c.piece_at(elastic)).at(elastic);
        const dda::Forces expected =
            trials.law(k).forces(step.springs[k].rows.measure(trials.normal_measure(k), d),
                                 step.springs[k].rows.measure(step.springs[k].shear, d));
        largest =
            std::max({largest, std::abs(found.x() - expected.normal), std::abs(found.y() - expected.shear)});
        force = std::max({force, expected.normal, std::abs(expected.shear)});
    }
    return largest / force;
}

TEST(LimitedContacts, HaveTheForcesOfTheLawsWhereTheyAreFrozen) {
    const std::vector<dda::JointLaw> laws = {
        Scene::mohr_coulomb(35), Scene::mohr_coulomb(35, 2e4), dda::Plesha{{radians(25), radians(10), 1e-5}},
        joint_tests::granite(), dda::ContinuouslyYielding{radians(35), radians(25), 1e-3}};
    for (std::size_t law = 0; law < laws.size(); ++law) {
        for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
            for (const double damping : {0.0, 0.4})
                EXPECT_LT(difference(laws[law], seed, damping), 1e-9) << "law " << law << ", seed " << seed;
        }
    }
}

}  // namespace
}  // namespace rockslope::limited_contacts_test
