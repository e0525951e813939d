#include "dda/linear/multifrontal_factor.hpp"

#include <gtest/gtest.h>

#include "dda/linear/linear_solver.hpp"
#include "support/step_system.hpp"
#include "support/walls.hpp"
#include "unit/dda/linear/random_systems.hpp"

namespace {

using dda::BlockPattern;
using dda::Front;
using dda::FrontPlan;
using dda::Vec6;

dda::SupernodeTree tree_of(const BlockPattern& pattern) {
    return dda::find_supernodes(pattern, dda::fill_reducing_order(pattern));
}

// From the moment a front forms its update until its parent has taken it, nobody else writes there; a
// thread's subtree shares no memory with another at all.
TEST(FrontPlan, KeepsUpdatesApartWhileTheyAreNeeded) {
    for (const int columns : {1, 4, 15, 30}) {
        const auto pattern = BlockPattern::from_pairs(columns * 20, grid_graph(columns, 20));
        const FrontPlan plan = dda::plan_fronts(pattern, tree_of(pattern), 8);
        std::vector<int> subtree(plan.count(), -1);
        for (std::size_t s = 0; s < plan.subtrees.size(); ++s) {
            for (int f = plan.subtrees[s].begin; f < plan.subtrees[s].end; ++f)
                subtree[static_cast<std::size_t>(f)] = static_cast<int>(s);
        }
        std::vector<int> top;
        for (std::size_t f = 0; f < plan.count(); ++f) {
            if (subtree[f] < 0) top.push_back(static_cast<int>(f));
        }
        EXPECT_EQ(top, plan.top);
        for (std::size_t a = 0; a < plan.count(); ++a) {
            const Front& first = plan.fronts[a];
            const auto end = [&](const Front& f) {
                return f.update + f.stride * static_cast<std::size_t>(f.rows) * 6;
            };
            EXPECT_LE(end(first), plan.work_size);
            for (std::size_t b = a + 1; b < plan.count(); ++b) {
                const Front& second = plan.fronts[b];
                const bool apart = end(first) <= second.update || end(second) <= first.update;
                const bool together = subtree[a] != subtree[b] && subtree[a] >= 0 && subtree[b] >= 0;
                // Of one subtree, or of a subtree and the top: `first` is gone once its parent is through.
                const bool lives =
                    first.parent >= static_cast<int>(b) || (first.parent < 0 && first.rows > 0);
                EXPECT_TRUE(apart || !(together || lives)) << a << " and " << b;
            }
        }
    }
}

template <class Scalar>
std::vector<Vec6> solution(const scene::StepSystem& system, int threads) {
    const dda::Crew crew(threads);
    dda::MultifrontalFactor<Scalar> factor;
    factor.analyze(system.pattern, tree_of(system.pattern));
    EXPECT_TRUE(factor.factorize(system.matrix, crew));
    std::vector<Vec6> x = system.load;
    factor.solve(x);
    return x;
}

/// Large enough for its subtrees and its largest fronts to be shared.
scene::StepSystem large_system() {
    return scene::step_system(scene::running_bond_wall(40, 40, 10).model, 0.005);
}

TEST(MultifrontalFactor, IsTheSameBytesOnOneThreadAndTwo) {
    const scene::StepSystem system = large_system();
    EXPECT_EQ(solution<double>(system, 1), solution<double>(system, 2));
    EXPECT_EQ(solution<float>(system, 1), solution<float>(system, 2));
}

double difference(const std::vector<Vec6>& a, const std::vector<Vec6>& b) {
    double apart = 0;
    double size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        apart += (a[i] - b[i]).squaredNorm();
        size += b[i].squaredNorm();
    }
    return std::sqrt(apart / size);
}

// The wall's condition number is some 1e4 (springs of 10 E, 5 ms), so double leaves 1e-11 and single 1e-2.
TEST(MultifrontalFactor, SolvesAWallAsCholmodDoes) {
    const scene::StepSystem system = large_system();
    const auto cholmod = dda::make_cholmod_solver();
    cholmod->analyze(system.pattern);
    ASSERT_TRUE(cholmod->factorize(system.matrix));
    std::vector<Vec6> expected = system.load;
    cholmod->solve(expected);
    EXPECT_LT(difference(solution<double>(system, 1), expected), 1e-11);
    EXPECT_LT(difference(solution<float>(system, 1), expected), 1e-2);
}

TEST(MultifrontalFactor, RefusesWhatIsNoNumber) {
    RandomSystem system(20, 40, 3);
    const dda::Crew crew(1);
    dda::MultifrontalFactor<double> factor;
    factor.analyze(system.pattern, tree_of(system.pattern));
    system.matrix.diagonal[7](4, 2) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(factor.factorize(system.matrix, crew));
}

TEST(MultifrontalFactor, OfSinglePrecisionIsRefusedWhereItCannotTell) {
    // A mass 1e-12 of the springs is lost in them.
    const RandomSystem system(6, 4, 2, 1e-12);
    const dda::Crew crew(1);
    dda::MultifrontalFactor<double> wide;
    wide.analyze(system.pattern, tree_of(system.pattern));
    EXPECT_TRUE(wide.factorize(system.matrix, crew));
    dda::MultifrontalFactor<float> narrow;
    narrow.analyze(system.pattern, tree_of(system.pattern));
    EXPECT_FALSE(narrow.factorize(system.matrix, crew));
}

}  // namespace
