// The result of a run does not depend on the linear solver.

#include <gtest/gtest.h>

#include "support/walls.hpp"

namespace rockslope::solver_choice_test {
namespace {

using namespace scene;

Simulation dropped_wall(dda::SolverKind solver) {
    Scene wall = running_bond_wall(5, 5, 10);
    wall.model.solver = solver;
    Simulation sim(wall);
    EXPECT_EQ(sim.shake(0.05, 0.005).status, dda::RunStatus::completed);
    return sim;
}

// Gravity acts on the wall suddenly, and contacts close and slide. Linear solutions differ by about 1e-12,
// and convergence allows forces to differ by 1e-6: that is 1e-9 m for displacements of about a millimetre.
TEST(SolverChoice, ChangesARunByRoundingOnly) {
    const Simulation reference = dropped_wall(dda::SolverKind::simplicial);
    for (const dda::SolverKind kind : {dda::SolverKind::multifrontal, dda::SolverKind::refined}) {
        const Simulation own = dropped_wall(kind);
        ASSERT_EQ(own.state.contacts.contacts.size(), reference.state.contacts.contacts.size());
        double moved = 0;
        for (int b = 1; b < own.model.block_count(); ++b) {
            moved = std::max(moved, reference.moved(b).norm());
            EXPECT_LT((own.moved(b) - reference.moved(b)).norm(), 1e-9) << "block " << b;
        }
        EXPECT_GT(moved, 1e-5) << "the wall moves too little for this test";
    }
}

}  // namespace
}  // namespace rockslope::solver_choice_test
