// The primal iteration against the dual form in contact forces [zheng2016], on recorded steps: the forces
// that the open-close iteration found are those of a dense condensed problem, which projected relaxation
// solves.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/dual_form.hpp"
#include "support/recorded_files.hpp"
#include "support/recorded_solution.hpp"

namespace rockslope::dual_form_test {
namespace {

using namespace recorded_step;

constexpr int most_sweeps = 200'000;
constexpr double largest_difference = 0.01;  ///< of a contact force, over the tolerance of forces

/// A recorded step with its dual form, and the forces of its contacts in the solution that the run found. The
/// run balanced its blocks to the tolerance of forces T; its solution is taken on to T / 10000, from the same
/// states.
struct RecordedForces {
    RecordedStep recorded;
    Equations equations;
    DualForm dual;
    Eigen::VectorXd forces;

    explicit RecordedForces(const std::filesystem::path& file)
        : recorded(read_step(file)), equations(recorded), dual(equations) {
        Solution run = Solution::from_found(recorded);
        run.solve(3, [&](double) { return 1e-4 * recorded.tolerance; });
        const auto contacts = equations.step().contacts;
        forces.resize(static_cast<Eigen::Index>(2 * contacts.size()));
        Eigen::Index at = 0;
        for (const dda::LimitedContact& contact : contacts) {
            forces.segment<2>(at) = forces_at(contact, run.displacement());
            at += 2;
        }
    }
    /// The largest difference from other forces over the tolerance of the run's.
    double difference(const Eigen::VectorXd& other) const {
        return (forces - other).cwiseAbs().maxCoeff() / recorded.tolerance;
    }
};

// The displacements under the forces that the iteration found give these forces by the laws: they solve the
// dual form. The iteration balances each block to the tolerance T. A remaining force of T on a block of mass
// m moves it by T dt^2 / 2m, which is 25 T / k at most here; the contacts around it answer with less than
// that.
TEST(DualForm, HasTheForcesOfTheIterationWithBoundsThatAreHeld) {
    for (const auto& file : recorded_files()) {
        SCOPED_TRACE(file.filename());
        const RecordedForces run(file);
        // With held bounds there is one solution, for the matrix is positive definite.
        const DualForm::Bounds bounds = run.dual.bounds_at(run.forces);
        const DualForm::Result found = run.dual.relax(&bounds, most_sweeps);
        ASSERT_TRUE(found.converged);
        EXPECT_LT(run.difference(found.forces), largest_difference);
    }
}

// With Coulomb's bounds another state may balance as well, so that forces alone prove nothing where they
// differ. Here relaxation from no force at all ends at the solution of the iteration in each step.
TEST(DualForm, HasTheForcesOfTheIterationWithCoulombsBounds) {
    int sliding = 0, bonded = 0;
    for (const auto& file : recorded_files()) {
        SCOPED_TRACE(file.filename());
        const RecordedForces run(file);
        const DualForm::Result found = run.dual.relax(nullptr, most_sweeps);
        ASSERT_TRUE(found.converged);
        EXPECT_LT(largest_unbalanced(run.equations, run.dual.displacement(found.forces)),
                  run.recorded.tolerance)
            << "the relaxed forces solve the primal problem";
        EXPECT_LT(run.difference(found.forces), largest_difference);
        for (const dda::LimitedContact& c : run.equations.step().contacts) {
            const dda::Piece piece = c.piece_at(c.elastic_at(run.equations.found()));
            sliding += piece.slides != 0 && piece.normal == dda::Piece::Normal::pressed ? 1 : 0;
            bonded += c.least_normal < 0 ? 1 : 0;
        }
    }
    EXPECT_GT(sliding, 50) << "or friction was not tried";
    EXPECT_GT(bonded, 5) << "or bonds were not tried";
}

// A block on two contacts, pushed down and along: N = f / 2 each but for the base stiffness, S = N tan 30
// where it slides.
TEST(DualForm, IsThatOfABlockOnAPlane) {
    RecordedStep step;
    RecordedStep::Row row;
    row.length = 1;
    row.stiffness.setIdentity();
    row.load << 3000, -4000, 0, 0, 0, 0;
    step.rows.push_back(row);
    for (const double x : {-0.5, 0.5}) {
        RecordedStep::Contact contact;
        contact.rows.first = dda::RowIndex(0);
        contact.rows.first_arm = {x, 0};
        contact.law.opening = {0, 1};
        contact.law.shearing = {-1, 0};
        contact.law.normal_stiffness = contact.law.shear_stiffness = 1e9;
        contact.law.forward = contact.law.backward = {0, 0.5};
        step.contacts.push_back(contact);
    }
    const Equations equations(step);
    const DualForm::Result found = DualForm(equations).relax(nullptr, most_sweeps);
    ASSERT_TRUE(found.converged);
    for (const Eigen::Index contact : {0, 1}) {
        EXPECT_NEAR(found.forces[2 * contact], 2000, 1e-5);
        EXPECT_NEAR(found.forces[2 * contact + 1], -1000, 1e-5)
            << "against the motion, along which it is negative";
    }
}

}  // namespace
}  // namespace rockslope::dual_form_test
