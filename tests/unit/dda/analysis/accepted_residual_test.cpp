// The displacement of an accepted step solves its linear system to 1e-10 of the load, or the blocks are in
// balance within the force tolerance.

#include <gtest/gtest.h>

#include <cmath>

#include "dda/solve/contact_solution.hpp"
#include "support/first_step.hpp"

namespace rockslope::accepted_residual_test {
namespace {

using namespace scene;

/// The refined solver; records the last matrix and the last right-hand side.
class RecordingSolver final : public dda::LinearSolver {
  public:
    explicit RecordingSolver(const ThreadPool& pool)
        : solver_(dda::make_linear_solver(dda::SolverKind::refined, pool)) {}

    void analyze(const dda::BlockPattern& pattern) override {
        pattern_ = pattern;
        solver_->analyze(pattern);
    }
    bool factorize(const dda::BlockMatrix& matrix) override { return refactorize(matrix, {}); }
    bool refactorize(const dda::BlockMatrix& matrix, std::span<const char> changed) override {
        matrix_ = &matrix;
        return solver_->refactorize(matrix, changed);
    }
    void solve(std::vector<Vec6>& right_hand_side) override { solver_->solve(right_hand_side); }
    int solve_coarsely(std::vector<Vec6>& x, const std::vector<Vec6>& b) override {
        return solver_->solve_coarsely(x, b);
    }
    void apply_factor(std::vector<Vec6>& right_hand_side) override { solver_->apply_factor(right_hand_side); }
    int refine(std::vector<Vec6>& x, const std::vector<Vec6>& b, double tolerance) override {
        load_ = b;
        largest_tolerance = std::max(largest_tolerance, tolerance);
        return solver_->refine(x, b, tolerance);
    }

    dda::OpenCloseResult iterate(const FirstStep& step) {
        analyze(step.pattern);
        const dda::StepProblem problem = step.problem();
        return dda::solve_contacts(problem, step.pattern, *this, work_, step.pool);
    }
    /// The residual of x over the load in the last linear system, in the solver's norm.
    double residual(const std::vector<Vec6>& x) const {
        std::vector<Vec6> image(x.size());
        matrix_->multiply(pattern_, x, image);
        double residual = 0;
        double load = 0;
        for (std::size_t r = 0; r < x.size(); ++r) {
            const Vec6 weight = matrix_->diagonal[r].diagonal().cwiseInverse();
            residual += (load_[r] - image[r]).cwiseAbs2().dot(weight);
            load += load_[r].cwiseAbs2().dot(weight);
        }
        return std::sqrt(residual / load);
    }

    double largest_tolerance = 0;  ///< of all calls of refine()

  private:
    std::unique_ptr<dda::LinearSolver> solver_;
    dda::BlockPattern pattern_;
    dda::IterationWorkspace work_;
    const dda::BlockMatrix* matrix_ = nullptr;
    std::vector<Vec6> load_;
};

/// A wall under its weight with a random body force on each block. Contacts open and slide, and the friction
/// coupling needs several solutions, not all of them to full accuracy.
struct PushedWall : FirstStep {
    static constexpr double dt = 0.005;

    PushedWall(unsigned seed, double force_tolerance) {
        control.force_tolerance = force_tolerance;
        for (dda::Mat6& stiffness : base.stiffness) stiffness.setZero();
        dda::add_inertia(rows, state.blocks, {0.5, 1, dt}, 0, base);
        dda::add_elasticity(model, rows, state.blocks, dt, base);
        RandomSource random(seed);
        for (std::size_t r = 0; r < base.load.size(); ++r) {
            const double mass = state.blocks.mass[rows.block_of[r]];
            base.load[r].head<2>() += mass * (model.gravity + 5 * random.direction());
        }
    }

    /// The largest unbalanced force of a block, N per metre, over the number of its contact forces plus one
    /// for its inertia.
    double unbalanced_force(const dda::OpenCloseResult& result) const {
        double largest = 0;
        for (std::size_t r = 0; r < base.load.size(); ++r) {
            Vec6 force = base.load[r] - base.stiffness[r] * result.displacement[r];
            int terms = 1;
            for (const dda::ContactIndex k : row_contacts.of(r)) {
                const dda::ContactSprings& s = springs[k];
                const dda::EvaluatedContact& evaluated = result.contacts[k];
                force +=
                    s.rows.project_on_row(static_cast<int>(r), evaluated.normal_force * s.normal.direction -
                                                                   evaluated.shear_force * s.shear.direction);
                terms += 2;  // a normal and a shear force
            }
            largest = std::max(largest, force.head<2>().cwiseAbs().maxCoeff() / terms);
        }
        return largest;
    }
    static double largest_force(const dda::OpenCloseResult& result) {
        double largest = 0;
        for (const dda::EvaluatedContact& evaluated : result.contacts)
            largest = std::max({largest, evaluated.normal_force, std::abs(evaluated.shear_force)});
        return largest;
    }
};

TEST(AcceptedStep, SolvesItsLinearSystem) {
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
        const PushedWall step(seed, dda::StepControl().force_tolerance);
        RecordingSolver solver(step.pool);
        const dda::OpenCloseResult result = solver.iterate(step);
        ASSERT_TRUE(result.converged) << "seed " << seed;
        EXPECT_GT(result.iterations, 2) << "seed " << seed << ": nothing to iterate";
        EXPECT_GT(solver.largest_tolerance, 1e-10) << "seed " << seed;
        EXPECT_LT(solver.residual(result.displacement), 1e-10) << "seed " << seed;
    }
}

// The forces of the laws balance the blocks within the tolerance, also one of 1e-2.
TEST(AcceptedStep, BalancesItsBlocks) {
    constexpr double tolerance = 1e-2;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        const PushedWall step(seed, tolerance);
        RecordingSolver solver(step.pool);
        const dda::OpenCloseResult result = solver.iterate(step);
        ASSERT_TRUE(result.converged) << "seed " << seed;
        EXPECT_LE(step.unbalanced_force(result), tolerance * PushedWall::largest_force(result))
            << "seed " << seed;
    }
}

}  // namespace
}  // namespace rockslope::accepted_residual_test
