#include "dda/linear/multifrontal_factor.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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

// From the moment a front forms its update until its parent has taken it, nobody else writes there. Within
// subtrees each thread has a space of its own; the roots of all subtrees come before the fronts above.
TEST(FrontPlan, KeepsUpdatesApartWhileTheyAreNeeded) {
    for (const int columns : {1, 4, 15, 30}) {
        const auto pattern = BlockPattern::from_pairs(columns * 20, grid_graph(columns, 20));
        const FrontPlan plan = dda::plan_fronts(pattern, tree_of(pattern), 8);
        const int count = static_cast<int>(plan.count());
        const auto front = [&](int f) -> const Front& { return plan.fronts[static_cast<std::size_t>(f)]; };
        const auto size = [&](const Front& f) {
            const auto rows = static_cast<std::size_t>(f.rows);
            return 6 * (rows * f.stride - dda::left_out_before(rows, 8));
        };
        std::vector<int> subtree(plan.count(), -1);
        for (const dda::Subtree& one : plan.subtrees) {
            for (int f = one.begin; f < one.end; ++f) subtree[static_cast<std::size_t>(f)] = one.begin;
            for (int f = one.begin; f < one.end; ++f) EXPECT_EQ(front(f).in_subtree, f + 1 < one.end);
        }
        for (int a = 0; a < count; ++a) {
            const bool inside = front(a).in_subtree;
            EXPECT_LE(front(a).update + size(front(a)), inside ? plan.subtree_space : plan.shared_space);
            EXPECT_TRUE(subtree[static_cast<std::size_t>(a)] >= 0 ||
                        std::binary_search(plan.top.begin(), plan.top.end(), a));
            for (int b = 0; b < count; ++b) {
                if (a == b || front(b).in_subtree != inside) continue;
                const bool a_is_root = !inside && subtree[static_cast<std::size_t>(a)] >= 0;
                const bool b_is_root = !inside && subtree[static_cast<std::size_t>(b)] >= 0;
                if (inside && subtree[static_cast<std::size_t>(a)] != subtree[static_cast<std::size_t>(b)])
                    continue;
                const bool b_comes_while_a_is_needed =
                    (a_is_root && b_is_root) || ((a_is_root || a < b) && !b_is_root && b <= front(a).parent);
                const bool apart = front(a).update + size(front(a)) <= front(b).update ||
                                   front(b).update + size(front(b)) <= front(a).update;
                EXPECT_TRUE(apart || !b_comes_while_a_is_needed) << a << " and " << b;
            }
        }
    }
}

TEST(FrontPlan, KeepsOfAnUpdateWhatIsOnAndBelowTheDiagonal) {
    for (const std::size_t w : {8, 16}) {
        for (const std::size_t rows : {1, 2, 5, 9, 40}) {
            const std::size_t stride = (6 * rows + w - 1) / w * w;
            std::size_t end = 0;  // of the columns so far
            for (std::size_t j = 0; j < rows; ++j) {
                const std::size_t first = dda::first_update_row(j, w);
                EXPECT_LE(first, 6 * j);
                EXPECT_GT(first + w, 6 * j);
                EXPECT_EQ(dda::update_column(j, stride, w) + first, end);
                EXPECT_EQ(dda::update_stride(j, stride, w), stride - first);
                end += 6 * (stride - first);
            }
            EXPECT_EQ(end, 6 * (rows * stride - dda::left_out_before(rows, w)));
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
